#include "waywright/io/json_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace waywright {
namespace {

constexpr std::size_t deepest = 64;

/// Edit distance, for "did you mean".
std::size_t distance_of(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, corner + (a[i - 1] == b[j - 1] ? 0 : 1)});
      corner = above;
    }
  }
  return row[b.size()];
}

/// Brackets are counted before parsing: a parser's own stack must not depend on the data.
bool too_deep(const std::string& text) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      else if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if ((c == '{' || c == '[') && ++depth > deepest) return true;
    if ((c == '}' || c == ']') && depth > 0) --depth;
  }
  return false;
}

std::string shortened(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E) c = '?';
  }
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

std::string child(const std::string& path, std::string_view field) {
  return path.empty() ? std::string{field} : path + "." + std::string{field};
}

}  // namespace

std::string kind_of(const Json& json) {
  if (json.is_number()) return "a number";
  if (json.is_string()) return "text";
  if (json.is_boolean()) return "true or false";
  if (json.is_array()) return "an array";
  if (json.is_object()) return "an object";
  return "null";
}

void ReadContext::fail(const std::string& field, std::string problem, std::string allowed) {
  if (!error) error = InputError{file, field, std::move(problem), std::move(allowed)};
}

Parsed<Json> parse_json(const std::string& text, const std::string& name) {
  if (too_deep(text)) {
    return tl::unexpected{InputError{name, "", "the JSON is nested too deeply", fmt::format("at most {} levels", deepest)}};
  }
  std::vector<std::set<std::string>> keys;
  std::optional<std::string> duplicate;
  const auto watch = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end && !keys.empty()) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.empty() && !duplicate) {
      const std::string key = value.get<std::string>();
      if (!keys.back().insert(key).second) duplicate = key;
    }
    return true;
  };
  try {
    Json json = Json::parse(text, watch);
    if (duplicate) {
      return tl::unexpected{InputError{name, shortened(*duplicate), "the field stands twice in one object", "once"}};
    }
    return json;
  } catch (const nlohmann::json::parse_error& e) {
    const auto end = std::min(text.size(), static_cast<std::size_t>(e.byte));
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    return tl::unexpected{InputError{name, "", fmt::format("not valid JSON near line {}", line), ""}};
  } catch (const nlohmann::json::out_of_range&) {
    return tl::unexpected{InputError{name, "", "a number is too large", "finite numbers"}};
  } catch (const nlohmann::json::exception&) {
    return tl::unexpected{InputError{name, "", "not valid JSON", ""}};
  }
}

bool Node::is_object_of(std::initializer_list<const char*> fields) const {
  if (!json_->is_object()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "an object");
    return false;
  }
  for (const auto& [key, value] : json_->items()) {
    if (std::any_of(fields.begin(), fields.end(), [&k = key](const char* f) { return k == f; })) continue;
    std::string allowed;
    std::string nearest;
    std::size_t least = 3;
    for (const char* f : fields) {
      allowed += (allowed.empty() ? "" : ", ") + std::string{f};
      if (const std::size_t d = distance_of(key, f); d < least) {
        least = d;
        nearest = f;
      }
    }
    context_->fail(child(path_, shortened(key)),
                   nearest.empty() ? "unknown field" : fmt::format("unknown field, did you mean \"{}\"?", nearest), allowed);
    return false;
  }
  return true;
}

Node Node::at(const char* field) const {
  static const Json nothing;
  if (!json_->is_object() || !json_->contains(field)) {
    context_->fail(child(path_, field), "the field is missing");
    return Node{nothing, child(path_, field), *context_};
  }
  return Node{(*json_)[field], child(path_, field), *context_};
}

Node Node::at(std::size_t index) const {
  static const Json nothing;
  std::string path = fmt::format("{}[{}]", path_, index);
  if (!json_->is_array() || index >= json_->size()) {
    context_->fail(path, "the element is missing");
    return Node{nothing, std::move(path), *context_};
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

bool Node::is_array_of(std::size_t n, const char* what) const {
  if (json_->is_array() && json_->size() == n) return true;
  fail(json_->is_array() ? fmt::format("it has {} elements", json_->size()) : fmt::format("it is {}", kind_of(*json_)), what);
  return false;
}

double Node::number(double low, double high) const {
  if (!json_->is_number()) {
    fail(fmt::format("it is {}", kind_of(*json_)), "a number");
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
  const double value = number(low, high);
  if (!failed() && value <= low) fail(fmt::format("{} is out of range", value), fmt::format("above {}, at most {}", low, high));
  return value;
}

std::int64_t Node::integer(std::int64_t low, std::int64_t high) const {
  if (json_->is_number_integer()) {
    const bool fits = !json_->is_number_unsigned() || json_->get<std::uint64_t>() <= static_cast<std::uint64_t>(INT64_MAX);
    if (fits && json_->get<std::int64_t>() >= low && json_->get<std::int64_t>() <= high) return json_->get<std::int64_t>();
    fail("the number is out of range", fmt::format("{} to {}", low, high));
    return low;
  }
  fail(json_->is_number() ? "it is not a whole number" : fmt::format("it is {}", kind_of(*json_)), "a whole number");
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

Vec2 Node::point() const {
  if (!is_array_of(2, "[x, y]")) return {};
  return {at(std::size_t{0}).number(-largest_coordinate, largest_coordinate), at(1).number(-largest_coordinate, largest_coordinate)};
}

Pose Node::pose() const {
  if (!is_array_of(3, "[x, y, heading]")) return {};
  return {at(std::size_t{0}).number(-largest_coordinate, largest_coordinate), at(1).number(-largest_coordinate, largest_coordinate),
          wrap(at(2).number(-1e6, 1e6))};
}

}  // namespace waywright
