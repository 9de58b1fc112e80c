// JSON to text: numbers in the fewest digits that read back to the same bits, objects one field a line, rows
// of numbers on one.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "waywright/io/scenario_json.hpp"

namespace waywright {
namespace {

template <class Number>
void write_number(Number value, std::string& out) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
  // A number with a fraction stays one when read back: −0.0 keeps its sign, and what is carried along keeps
  // its text.
  const bool whole = std::none_of(digits.data(), end, [](char c) { return c == '.' || c == 'e'; });
  if (std::is_floating_point_v<Number> && whole) out += ".0";
}

void write_plain(const Json& json, std::string& out) {
  if (json.is_number_float()) {
    const double value = json.get<double>();
    if (!std::isfinite(value)) {
      out += "null";  // JSON has no other word; writers leave such figures out before they come here
    } else {
      write_number(value, out);
    }
  } else if (json.is_number_unsigned()) {
    write_number(json.get<std::uint64_t>(), out);
  } else if (json.is_number_integer()) {
    write_number(json.get<std::int64_t>(), out);
  } else {
    // Text that is not valid UTF-8 (a file's name, say) must not throw.
    out += json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

/// Plain values, or arrays of plain values such as points: they stand on one line.
bool is_row(const Json& array) {
  return std::none_of(array.begin(), array.end(), [](const Json& e) {
    return e.is_object() ||
           (e.is_array() && std::any_of(e.begin(), e.end(), [](const Json& f) { return f.is_structured(); }));
  });
}

void write_row(const Json& json, std::string& out) {
  if (!json.is_array()) return write_plain(json, out);
  out += '[';
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (i > 0) out += ',';
    write_row(json[i], out);
  }
  out += ']';
}

class Writer {
 public:
  Writer(int indent, std::string& out) : indent_{static_cast<std::size_t>(std::max(indent, 0))}, out_{out} {}

  void write(const Json& json, std::size_t depth) {
    if (json.is_object() && !json.empty()) {
      write_object(json, depth);
    } else if (json.is_object()) {
      out_ += "{}";
    } else if (!json.is_array() || is_row(json)) {
      write_row(json, out_);
    } else {
      out_ += '[';
      for (std::size_t i = 0; i < json.size(); ++i) {
        if (i > 0) out_ += ',';
        line(depth + 1);
        write(json[i], depth + 1);
      }
      line(depth);
      out_ += ']';
    }
  }

 private:
  void write_object(const Json& json, std::size_t depth) {
    out_ += '{';
    bool first = true;
    for (const auto& [key, value] : json.get_ref<const Json::object_t&>()) {
      if (!first) out_ += ',';
      first = false;
      line(depth + 1);
      write_plain(Json(key), out_);
      out_ += ": ";
      write(value, depth + 1);
    }
    line(depth);
    out_ += '}';
  }
  void line(std::size_t depth) {
    out_ += '\n';
    out_.append(indent_ * depth, ' ');
  }

  std::size_t indent_;
  std::string& out_;
};

}  // namespace

std::string pretty(const Json& json, int indent) {
  std::string out;
  Writer{indent, out}.write(json, 0);
  out += '\n';
  return out;
}

}  // namespace waywright
