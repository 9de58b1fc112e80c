// Strict reading of JSON: every field known, typed and in range, or one sentence about the first that is not.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/pose.hpp"
#include "waywright/core/result.hpp"

namespace waywright {

using Json = nlohmann::ordered_json;

/// Parses text: depth at most 64, no duplicate keys, numbers finite.
Parsed<Json> parse_json(const std::string& text, const std::string& name);

/// Collects the first error; what is read after it is meaningless and thrown away by the caller.
struct ReadContext {
  std::string file;
  std::optional<InputError> error;
  int files_deep = 0;  ///< files that name files that name files …
  void fail(const std::string& field, std::string problem, std::string allowed = "");
};

inline constexpr double largest_coordinate = 1e6;  ///< m

/// A JSON value with its place. Getters never throw; a wrong value fails the context and gives a harmless one.
class Node {
 public:
  Node(const Json& json, std::string path, ReadContext& context) : json_{&json}, path_{std::move(path)}, context_{&context} {}

  const Json& json() const { return *json_; }
  const std::string& path() const { return path_; }
  ReadContext& context() const { return *context_; }
  bool failed() const { return context_->error.has_value(); }
  void fail(std::string problem, std::string allowed = "") const { context_->fail(path_, std::move(problem), std::move(allowed)); }

  /// Is an object with no other fields than these; fails otherwise.
  bool is_object_of(std::initializer_list<const char*> fields) const;
  bool is_object() const { return json_->is_object(); }
  bool is_array() const { return json_->is_array(); }
  bool has(const char* field) const { return json_->is_object() && json_->contains(field) && !(*json_)[field].is_null(); }
  /// The field; fails where it is missing.
  Node at(const char* field) const;
  Node at(std::size_t index) const;
  std::vector<Node> elements() const;  ///< of an array; fails where it is none
  /// An array of exactly n elements.
  bool is_array_of(std::size_t n, const char* what) const;

  double number(double low, double high) const;
  double number_above(double low, double high) const;  ///< low excluded
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  bool boolean() const;
  std::string text() const;
  Vec2 point() const;  ///< [x, y] within ±1e6 m
  Pose pose() const;   ///< [x, y, θ], θ wrapped

 private:
  const Json* json_;
  std::string path_;
  ReadContext* context_;
};

/// "number", "string", "object" …: what a value is, for messages.
std::string kind_of(const Json& json);

}  // namespace waywright
