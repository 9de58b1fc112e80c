// Strict reading of JSON: every field known, typed and in range, or one sentence about the first that is not.
#pragma once

#include <cstdint>
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

inline constexpr std::size_t deepest_json = 64;              ///< levels of brackets
inline constexpr std::uint64_t largest_json = 256ULL << 20;  ///< bytes of text
inline constexpr std::size_t most_json_values = 16ULL
                                                << 20;  ///< values in one text: bounds the memory asked for
inline constexpr double largest_coordinate = 1e6;       ///< m

/// Parses text of at most largest_json bytes and most_json_values values, nested at most `deepest` levels.
/// Refuses fields that stand twice and numbers that are not finite; says where, by field or by line and
/// column.
Parsed<Json> parse_json(const std::string& text, const std::string& name, std::size_t deepest = deepest_json);

/// Collects the first error; what is read after it is meaningless and thrown away by the caller.
struct ReadContext {
  std::string file;
  std::optional<InputError> error;
  int files_deep = 0;      ///< files that name files that name files …
  int files_read = 0;      ///< in all
  std::int64_t cells = 0;  ///< of all grids read
  void fail(const std::string& field, std::string problem, std::string allowed = "");
};

/// A JSON value with its place. Getters never throw; a wrong value fails the context and gives a harmless
/// one.
class Node {
 public:
  Node(const Json& json, std::string path, ReadContext& context)
      : json_{&json}, path_{std::move(path)}, context_{&context} {}

  const Json& json() const { return *json_; }
  const std::string& path() const { return path_; }
  ReadContext& context() const { return *context_; }
  bool failed() const { return context_->error.has_value(); }
  void fail(std::string problem, std::string allowed = "") const {
    context_->fail(path_, missing_ ? std::string{missing_words} : std::move(problem), std::move(allowed));
  }

  /// Is an object with no other fields than these; fails otherwise, with the nearest spelling as a hint.
  bool is_object_of(std::initializer_list<const char*> fields) const;
  bool is_object() const { return json_->is_object(); }
  bool is_array() const { return json_->is_array(); }
  bool has(const char* field) const { return json_->is_object() && json_->contains(field); }
  /// The field is there and not null: for the few fields that may be null.
  bool given(const char* field) const { return has(field) && !(*json_)[field].is_null(); }
  /// The field. Where it is missing, whatever is asked of it fails and says so, with what would have been allowed.
  Node at(const char* field) const;
  bool missing() const { return missing_; }
  Node at(std::size_t index) const;
  std::vector<Node> elements() const;  ///< of an array; fails where it is none
  /// The members of an object with their names; fails where it is none.
  std::vector<std::pair<std::string, Node>> members(const char* what) const;
  /// An array of exactly n elements.
  bool is_array_of(std::size_t n, const char* what) const;

  double number(double low, double high) const;
  double number_above(double low, double high) const;    ///< low excluded
  double number_between(double low, double high) const;  ///< both excluded
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  bool boolean() const;
  std::string text() const;
  std::string word(std::initializer_list<const char*> words) const;  ///< one of these
  std::string file_name() const;  ///< not empty, no control characters, at most 4096 bytes
  Vec2 point(double most = largest_coordinate) const;                ///< [x, y] within ±most
  Pose pose(double most = largest_coordinate) const;                 ///< [x, y, θ], θ wrapped
  std::vector<Vec2> points(double most = largest_coordinate) const;  ///< an array of [x, y]
  std::vector<Pose> poses(double most = largest_coordinate) const;   ///< an array of [x, y, θ]
  std::vector<double> numbers(double low, double high) const;        ///< an array of numbers

 private:
  template <std::size_t n>
  bool plain(std::array<double, n>& values, double most) const;

  static constexpr const char* missing_words = "the field is missing";
  Node missing_child(std::string path) const;

  const Json* json_;
  std::string path_;
  ReadContext* context_;
  bool missing_ = false;
};

/// An error of a file that a field names: where it is one of the file as a whole (not there, a folder), it names the field too.
void fail_by_file(const Node& field, InputError error);

/// "a number", "text", "an object" …: what a value is, for messages.
std::string kind_of(const Json& json);

/// Text fit for a message: control characters replaced, cut after about 60 bytes.
std::string shortened(const std::string& text);

/// Levels of brackets; 0 for a plain value.
std::size_t depth_of(const Json& json);

}  // namespace waywright
