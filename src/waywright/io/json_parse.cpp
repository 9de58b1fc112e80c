// Text to a JSON value through our own consumer of the parser's events: refusals come with their place, an
// object of very many fields is read in n log n, and nothing is kept of a text that is refused.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <new>

#include "waywright/io/json_reader.hpp"

namespace waywright {
namespace {

std::string line_and_column(const std::string& text, std::size_t at) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto newline = std::find(std::make_reverse_iterator(end), text.rend(), '\n');
  return fmt::format("line {}, column {}", line, std::max<std::ptrdiff_t>(1, end - newline.base()));
}

/// The word (letters and sign) around a place of the text, in lower case.
std::string word_around(const std::string& text, std::size_t at) {
  const auto part = [&](std::size_t i) {
    return std::isalpha(static_cast<unsigned char>(text[i])) != 0 || text[i] == '-';
  };
  std::size_t begin = std::min(at, text.size());
  std::size_t end = begin;
  while (begin > 0 && at - begin < 16 && part(begin - 1)) --begin;
  while (end < text.size() && end - at < 16 && part(end)) ++end;
  std::string word = text.substr(begin, end - begin);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

bool is_no_number(const std::string& word) {
  for (const char* w : {"nan", "-nan", "inf", "-inf", "infinity", "-infinity"}) {
    if (word == w) return true;
  }
  return false;
}

/// "parse error at …: syntax error while parsing value - what was found; what was expected" without its
/// beginning.
std::string reason_of(const std::string& what) {
  const std::size_t dash = what.find(" - ");
  std::string reason = dash == std::string::npos ? "syntax error" : what.substr(dash + 3);
  for (char& c : reason) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E) c = '?';
  }
  // "last read" repeats the text from the beginning of a token, which may be long.
  return reason.size() > 160 ? reason.substr(0, 157) + "..." : reason;
}

class Builder final : public nlohmann::json_sax<Json> {
 public:
  Builder(const std::string& text, const std::string& name, std::size_t deepest)
      : text_{text}, name_{name}, deepest_{deepest} {}

  Json take() { return std::move(root_); }
  InputError error() const { return error_.value_or(InputError{name_, "", "not valid JSON", ""}); }

  bool null() override { return put(nullptr) != nullptr; }
  bool boolean(bool value) override { return put(value) != nullptr; }
  bool number_integer(number_integer_t value) override { return put(value) != nullptr; }
  bool number_unsigned(number_unsigned_t value) override { return put(value) != nullptr; }
  bool number_float(number_float_t value, const string_t& token) override {
    if (!std::isfinite(value)) return too_large(token);
    return put(value) != nullptr;
  }
  bool string(string_t& value) override { return put(std::move(value)) != nullptr; }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool key(string_t& value) override {
    members().emplace_back(std::move(value), nullptr);
    return true;
  }
  bool end_object() override {
    if (auto twice = repeated()) {
      members().emplace_back(*twice, nullptr);  // so that the path names it
      return refuse(path(false), "the field stands twice in one object", "once");
    }
    open_.pop_back();
    return true;
  }
  bool end_array() override {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& e) override {
    constexpr int number_overflow = 406;
    if (e.id == number_overflow) return too_large(token);
    const std::size_t at = position > 0 ? position - 1 : 0;
    if (const std::string word = word_around(text_, at); is_no_number(word)) {
      return refuse(path(true), fmt::format("not valid JSON: {} is not a number", word), "finite numbers");
    }
    return refuse(line_and_column(text_, position), "not valid JSON: " + reason_of(e.what()), "");
  }

 private:
  Json::object_t& members() { return open_.back()->get_ref<Json::object_t&>(); }

  bool refuse(std::string field, std::string problem, std::string allowed) {
    if (!error_) error_ = InputError{name_, std::move(field), std::move(problem), std::move(allowed)};
    return false;
  }
  bool too_large(const std::string& token) {
    return refuse(path(true), fmt::format("the number {} is too large", shortened(token)), "finite numbers");
  }

  /// The place of the value that comes next (array elements that are not there yet), or of the last one.
  std::string path(bool next) const {
    std::string text;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Json& json = *open_[i];
      if (json.is_array()) {
        const bool to_come = next && i + 1 == open_.size();
        text += fmt::format("[{}]", json.size() - (to_come || json.empty() ? 0 : 1));
      } else if (!json.empty()) {
        if (!text.empty()) text += '.';
        text += shortened(json.get_ref<const Json::object_t&>().back().first);
      }
    }
    return text;
  }

  /// The address of an element stays as long as it is open: its container does not grow meanwhile.
  Json* put(Json value) {
    if (++values_ > most_json_values) {
      refuse("", "there are too many values in the JSON", fmt::format("at most {}", most_json_values));
      return nullptr;
    }
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (open_.back()->is_array()) {
      auto& array = open_.back()->get_ref<Json::array_t&>();
      array.push_back(std::move(value));
      return &array.back();
    }
    Json& member = members().back().second;
    member = std::move(value);
    return &member;
  }

  bool open(Json empty) {
    if (open_.size() >= deepest_)
      return refuse("", "the JSON is nested too deeply", fmt::format("at most {} levels", deepest_));
    Json* placed = put(std::move(empty));
    if (placed == nullptr) return false;
    open_.push_back(placed);
    return true;
  }

  std::optional<std::string> repeated() {
    std::vector<std::string_view> keys;
    keys.reserve(members().size());
    for (const auto& member : members()) keys.push_back(member.first);
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice == keys.end()) return std::nullopt;
    return std::string{*twice};
  }

  const std::string& text_;
  const std::string& name_;
  std::size_t deepest_;
  std::size_t values_ = 0;
  Json root_;
  std::vector<Json*> open_;
  std::optional<InputError> error_;
};

}  // namespace

Parsed<Json> parse_json(const std::string& text, const std::string& name, std::size_t deepest) {
  if (text.size() > largest_json) {
    return tl::unexpected{InputError{name, "", fmt::format("the JSON is {} bytes long", text.size()),
                                     fmt::format("at most {}", largest_json)}};
  }
  try {
    Builder builder{text, name, deepest};
    if (!Json::sax_parse(text, &builder)) return tl::unexpected{builder.error()};
    return builder.take();
  } catch (const nlohmann::json::exception&) {
    return tl::unexpected{InputError{name, "", "not valid JSON", ""}};
  } catch (const std::bad_alloc&) {
    return tl::unexpected{InputError{name, "", "there is not enough memory for the JSON", ""}};
  }
}

std::size_t depth_of(const Json& json) {
  if (!json.is_structured()) return 0;
  std::size_t deepest = 0;
  for (const Json& element : json) deepest = std::max(deepest, depth_of(element));
  return deepest + 1;
}

}  // namespace waywright
