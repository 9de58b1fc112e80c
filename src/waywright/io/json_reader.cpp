#include "waywright/io/json_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/core/spelling.hpp"

namespace waywright {
namespace {

constexpr std::size_t longest_name = 4096;  // bytes of a file name
constexpr double largest_angle = 1e6;       // rad; beyond it a wrapped angle has lost too many digits
constexpr double any_number = 1e300;        // a limit beyond it is none
constexpr double largest_whole = 9007199254740992.0;  // 2^53: whole numbers up to it are exact as doubles

std::vector<std::string> words_of(std::initializer_list<const char*> words) { return {words.begin(), words.end()}; }

std::string child(const std::string& path, std::string_view field) {
  return path.empty() ? std::string{field} : path + "." + std::string{field};
}

const Json& nothing() {
  static const Json null;
  return null;
}

}  // namespace

std::string kind_of(const Json& json) {
  if (json.is_number()) return "a number";
  if (json.is_string()) return "text";
  if (json.is_boolean()) return json.get<bool>() ? "true" : "false";
  if (json.is_array()) return "an array";
  if (json.is_object()) return "an object";
  return "null";
}

std::string shortened(const std::string& text) {
  constexpr std::size_t most = 60;
  std::string out = text.substr(0, most);
  if (text.size() > most) {
    // Not in the middle of a character of several bytes.
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0U) == 0x80U) out.pop_back();
    if (!out.empty() && static_cast<unsigned char>(out.back()) >= 0xC0U) out.pop_back();
    out += "...";
  }
  return one_line(std::move(out));
}

void ReadContext::fail(const std::string& field, std::string problem, std::string allowed) {
  if (!error) error = InputError{file, field, std::move(problem), std::move(allowed)};
}

void fail_by_file(const Node& field, InputError error) {
  if (field.failed()) return;
  if (!error.field.empty()) {
    field.context().error = std::move(error);
    return;
  }
  field.fail(error.file + ": " + error.problem, error.allowed);
}

bool Node::is_object_of(std::initializer_list<const char*> fields) const {
  if (!json_->is_object()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "an object");
    return false;
  }
  for (const auto& [key, value] : json_->get_ref<const Json::object_t&>()) {
    if (std::any_of(fields.begin(), fields.end(), [&k = key](const char* f) { return k == f; })) continue;
    const std::vector<std::string> known = words_of(fields);
    context_->fail(child(path_, shortened(key)), "unknown field" + meant_instead(key, known), list_of_words(known));
    return false;
  }
  return true;
}

Node Node::missing_child(std::string path) const {
  Node node{nothing(), std::move(path), *context_};
  node.missing_ = true;
  return node;
}

Node Node::at(const char* field) const {
  if (!json_->is_object()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "an object");
    return Node{nothing(), child(path_, field), *context_};
  }
  const auto found = json_->find(field);
  if (found == json_->end()) return missing_child(child(path_, field));
  return Node{*found, child(path_, field), *context_};
}

Node Node::at(std::size_t index) const {
  std::string path = fmt::format("{}[{}]", path_, index);
  if (!json_->is_array() || index >= json_->size()) {
    fail(fmt::format("element {} is missing", index), "an array with it");
    return Node{nothing(), std::move(path), *context_};
  }
  return Node{(*json_)[index], std::move(path), *context_};
}

std::vector<Node> Node::elements() const {
  std::vector<Node> nodes;
  if (!json_->is_array()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "an array");
    return nodes;
  }
  nodes.reserve(json_->size());
  for (std::size_t i = 0; i < json_->size(); ++i) nodes.push_back(at(i));
  return nodes;
}

std::vector<std::pair<std::string, Node>> Node::members(const char* what) const {
  std::vector<std::pair<std::string, Node>> nodes;
  if (!json_->is_object()) {
    fail(fmt::format("it is {}", kind_of(*json_)), what);
    return nodes;
  }
  nodes.reserve(json_->size());
  for (const auto& [key, value] : json_->get_ref<const Json::object_t&>()) {
    nodes.emplace_back(key, Node{value, child(path_, shortened(key)), *context_});
  }
  return nodes;
}

bool Node::is_array_of(std::size_t n, const char* what) const {
  if (json_->is_array() && json_->size() == n) return true;
  fail(json_->is_array() ? fmt::format("it has {} element{}", json_->size(), json_->size() == 1 ? "" : "s")
                         : fmt::format("it is {}", kind_of(*json_)),
       what);
  return false;
}

double Node::number(double low, double high) const {
  if (!json_->is_number()) {
    fail(fmt::format("it is {}", kind_of(*json_)), high < any_number ? fmt::format("a number from {} to {}", low, high) : "a number");
    return low;
  }
  const double value = json_->get<double>();
  if (!std::isfinite(value) || value < low || value > high) {
    fail(fmt::format("{} is out of range", value), fmt::format("{} to {}", low, high));
    return low;
  }
  return value;
}

double Node::number_above(double low, double high) const {
  if (!json_->is_number()) {
    fail(fmt::format("it is {}", kind_of(*json_)), fmt::format("a number above {}, at most {}", low, high));
    return high;
  }
  if (!(json_->get<double>() > low && json_->get<double>() <= high)) {
    fail(fmt::format("{} is out of range", json_->get<double>()),
         fmt::format("above {}, at most {}", low, high));
    return high;
  }
  return number(low, high);
}

double Node::number_between(double low, double high) const {
  if (!json_->is_number()) {
    fail(fmt::format("it is {}", kind_of(*json_)), fmt::format("a number above {}, under {}", low, high));
    return 0.5 * (low + high);
  }
  if (!(json_->get<double>() > low && json_->get<double>() < high)) {
    fail(fmt::format("{} is out of range", json_->get<double>()),
         fmt::format("above {}, under {}", low, high));
    return 0.5 * (low + high);
  }
  return number(low, high);
}

std::int64_t Node::integer(std::int64_t low, std::int64_t high) const {
  if (!json_->is_number()) {
    fail(fmt::format("it is {}", kind_of(*json_)), fmt::format("a whole number from {} to {}", low, high));
    return low;
  }
  std::optional<std::int64_t> value;
  if (json_->is_number_unsigned()) {
    if (json_->get<std::uint64_t>() <= static_cast<std::uint64_t>(INT64_MAX))
      value = json_->get<std::int64_t>();
  } else if (json_->is_number_integer()) {
    value = json_->get<std::int64_t>();
  } else {
    const double given = json_->get<double>();  // 1e3 and 1000.0 are whole numbers too
    if (!(std::floor(given) == given)) {
      fail(fmt::format("{} is not a whole number", given), "a whole number");
      return low;
    }
    if (std::abs(given) <= largest_whole) value = static_cast<std::int64_t>(given);
  }
  if (value && *value >= low && *value <= high) return *value;
  fail(fmt::format("{} is out of range", json_->dump()), fmt::format("{} to {}", low, high));
  return low;
}

bool Node::boolean() const {
  if (json_->is_boolean()) return json_->get<bool>();
  fail(fmt::format("it is {}", kind_of(*json_)), "true or false");
  return false;
}

std::string Node::text() const {
  if (json_->is_string()) return json_->get<std::string>();
  fail(fmt::format("it is {}", kind_of(*json_)), "text");
  return {};
}

std::string Node::word(std::initializer_list<const char*> words) const {
  if (!json_->is_string()) {
    fail(fmt::format("it is {}", kind_of(*json_)), list_of_words(words_of(words)));
    return {};
  }
  const std::string given = text();
  if (failed() || std::any_of(words.begin(), words.end(), [&](const char* w) { return given == w; }))
    return given;
  fail(fmt::format("\"{}\" is not known{}", shortened(given), meant_instead(given, words_of(words))), list_of_words(words_of(words)));
  return given;
}

std::string Node::file_name() const {
  if (!json_->is_string()) fail(fmt::format("it is {}", kind_of(*json_)), "the name of a file");
  if (failed()) return {};
  std::string name = text();
  const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
  if (name.empty() || name.size() > longest_name || std::any_of(name.begin(), name.end(), control)) {
    fail(name.empty() ? "the file name is empty" : fmt::format("\"{}\" is not a file name", shortened(name)),
         "a file name");
    return {};
  }
  return name;
}

/// n numbers within ±most (the third an angle), without building the names of their places.
template <std::size_t n>
bool Node::plain(std::array<double, n>& values, double most) const {
  if (!json_->is_array() || json_->size() != n) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Json& value = (*json_)[i];
    if (!value.is_number()) return false;
    values[i] = value.get<double>();
    if (!(std::abs(values[i]) <= (i < 2 ? most : largest_angle))) return false;
  }
  return true;
}

Vec2 Node::point(double most) const {
  std::array<double, 2> v{};
  if (plain(v, most)) return {v[0], v[1]};
  if (!is_array_of(2, "[x, y]")) return {};
  for (std::size_t i = 0; i < 2; ++i) at(i).number(-most, most);
  return {};
}

Pose Node::pose(double most) const {
  std::array<double, 3> v{};
  if (plain(v, most)) return {v[0], v[1], wrap(v[2])};
  if (!is_array_of(3, "[x, y, heading]")) return {};
  for (std::size_t i = 0; i < 3; ++i)
    at(i).number(i < 2 ? -most : -largest_angle, i < 2 ? most : largest_angle);
  return {};
}

std::vector<Vec2> Node::points(double most) const {
  std::vector<Vec2> values;
  if (!json_->is_array()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "an array of points [x, y]");
    return values;
  }
  values.reserve(json_->size());
  std::array<double, 2> v{};
  for (std::size_t i = 0; i < json_->size(); ++i) {
    const Node element{(*json_)[i], {}, *context_};
    if (!element.plain(v, most)) {
      at(i).point(most);  // again, to say what is wrong and where
      return {};
    }
    values.push_back({v[0], v[1]});
  }
  return values;
}

std::vector<Pose> Node::poses(double most) const {
  std::vector<Pose> values;
  if (!json_->is_array()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "an array of poses [x, y, heading]");
    return values;
  }
  values.reserve(json_->size());
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < json_->size(); ++i) {
    const Node element{(*json_)[i], {}, *context_};
    if (!element.plain(v, most)) {
      at(i).pose(most);
      return {};
    }
    values.push_back({v[0], v[1], wrap(v[2])});
  }
  return values;
}

std::vector<double> Node::numbers(double low, double high) const {
  std::vector<double> values;
  if (!json_->is_array()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "an array of numbers");
    return values;
  }
  values.reserve(json_->size());
  for (std::size_t i = 0; i < json_->size(); ++i) {
    const Json& value = (*json_)[i];
    const double v = value.is_number() ? value.get<double>() : low;
    if (!value.is_number() || !(v >= low && v <= high)) {
      at(i).number(low, high);
      return {};
    }
    values.push_back(v);
  }
  return values;
}

}  // namespace waywright
