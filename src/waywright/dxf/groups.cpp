#include "waywright/dxf/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace waywright::dxf {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : text_{text}, name_{name} {}

  /// False at the end, and where it fails.
  bool next(Group& group) {
    if (at_ >= text_.size()) return false;
    const std::string_view code = line();
    if (code.empty() && at_ >= text_.size()) return false;  // an empty line at the end
    if (at_ >= text_.size()) return refuse("the file is cut short: it ends after a group code", "a value after each group code");
    const auto [end, wrong] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (wrong != std::errc{} || end != code.data() + code.size() || group.code < -9999 || group.code > 9999) {
      return refuse("there is no group code", "a whole number on every other line, as DXF text has it");
    }
    group.value = line();
    group.line = lines_;
    return true;
  }

  bool refuse(std::string problem, std::string allowed) {
    error_ = InputError{name_, fmt::format("line {}", std::max<std::size_t>(lines_, 1)), std::move(problem), std::move(allowed)};
    return false;
  }
  const std::optional<InputError>& error() const { return error_; }

 private:
  std::string_view line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    ++lines_;
    return trimmed(found);
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0, lines_ = 0;
  std::optional<InputError> error_;
};

std::optional<Section> section_of(std::string_view name) {
  if (name == "HEADER") return Section::header;
  if (name == "TABLES") return Section::tables;
  if (name == "BLOCKS") return Section::blocks;
  if (name == "ENTITIES") return Section::entities;
  return std::nullopt;
}

/// Gathers groups into items.
class Walk {
 public:
  using Visit = std::function<std::optional<InputError>(Section, const Item&)>;
  Walk(std::string_view text, const std::string& name, const Visit& visit) : reader_{text, name}, name_{name}, visit_{visit} {}

  std::optional<InputError> run() {
    Group group;
    bool ended = false;
    while (!ended && !error_ && reader_.next(group)) {
      if (group.code == 999) continue;  // a comment
      if (group.code == 0) ended = begin(group);
      else if (awaits_name_ && group.code == 2) {
        section_ = section_of(group.value);
        awaits_name_ = false;
      } else if (section_ == Section::header && group.code == 9) {
        finish();
        item_ = {group.value, group.line, {}};
      } else if (!item_.type.empty() && !skipping_) {
        item_.groups.push_back(group);
      }
    }
    if (reader_.error()) return reader_.error();
    if (error_) return error_;
    if (!any_) return InputError{name_, "", "it is not a DXF drawing", "DXF text with its sections"};
    if (!ended) return InputError{name_, "", "the file is cut short: it ends before its EOF", "a whole DXF file"};
    return std::nullopt;
  }

 private:
  /// True at EOF.
  bool begin(const Group& group) {
    const std::string_view type = group.value;
    if (type == "SECTION" || type == "ENDSEC" || type == "EOF") {
      finish();
      awaits_name_ = type == "SECTION";
      any_ = any_ || awaits_name_;
      section_.reset();
      return type == "EOF";
    }
    if (!section_ || awaits_name_) return false;
    const bool in_drawing = section_ == Section::blocks || section_ == Section::entities;
    if (in_drawing && (type == "VERTEX" || type == "ATTRIB" || type == "SEQEND")) {
      // They belong to the entity before them.
      skipping_ = !(type == "VERTEX" && item_.type == "POLYLINE");
      if (!skipping_) item_.groups.push_back(group);
      return false;
    }
    finish();
    item_ = {type, group.line, {}};
    return false;
  }

  void finish() {
    skipping_ = false;
    if (!item_.type.empty() && section_ && !error_) error_ = visit_(*section_, item_);
    item_ = {};
  }

  Reader reader_;
  const std::string& name_;
  const Visit& visit_;
  std::optional<Section> section_;
  bool awaits_name_ = false, skipping_ = false, any_ = false;
  Item item_;
  std::optional<InputError> error_;
};

}  // namespace

std::optional<std::string_view> Item::find(int code) const {
  for (const Group& group : groups) {
    if (group.code == code) return group.value;
    if (group.code == 0) break;  // of the entity itself, not of its vertices
  }
  return std::nullopt;
}

std::string_view Item::text(int code) const { return find(code).value_or(std::string_view{}); }

std::optional<InputError> walk(std::string_view text, const std::string& name, const Walk::Visit& visit) {
  if (text.starts_with("AutoCAD Binary DXF")) return InputError{name, "", "it is a binary DXF", "a DXF saved as text (ASCII)"};
  if (text.starts_with("AC10")) return InputError{name, "", "it is a DWG drawing", "a DXF, which CAD programs save or export"};
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return Walk{text, name, visit}.run();
}

std::optional<double> number_from(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size()) return std::nullopt;
  // Too small to be a number is nothing; too large is none.
  if (wrong == std::errc::result_out_of_range) return text.find("e-") != text.npos || text.find("E-") != text.npos ? std::optional{0.0} : std::nullopt;
  if (wrong != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace waywright::dxf
