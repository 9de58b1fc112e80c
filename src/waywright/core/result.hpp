// A result is a value or a failure with its cause; nothing in between.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "waywright/core/pose.hpp"

namespace waywright {

/// How a planning run ended; the words of the plan file.
enum class Status {
  solved,              ///< a path whose proof holds
  unproven,            ///< a path that touches, breaks a limit, or cannot be proven
  no_path,             ///< the planner ended without a path
  start_in_collision,  ///< the footprint at the start touches an obstacle
  goal_in_collision,   ///< the footprint at the goal touches an obstacle
  start_outside,       ///< the footprint at the start leaves the boundary
  goal_outside,        ///< the footprint at the goal leaves the boundary
  timed_out,           ///< the budget in seconds ran out before there was a path
  canceled,            ///< stopped from outside
};

const char* to_string(Status status);
std::optional<Status> status_from_string(const std::string& word);

/// Why there is no path, found where it happened.
struct Failure {
  Status status = Status::no_path;
  std::string reason;              ///< one plain sentence
  std::optional<Pose> pose = {};   ///< the pose that it speaks of
  std::optional<Vec2> point = {};  ///< the obstacle's point that it speaks of
};

/// Text fit for a message: a name out of a file may hold anything, and line breaks and control characters become question marks.
std::string one_line(std::string text);

/// Input that cannot be used. `message()` is the one sentence that a user sees.
struct InputError {
  std::string file;     ///< name as the user gave it; empty where there is none
  std::string field;    ///< dotted path of the field, for example "station.shelf.size[0]"; may be empty
  std::string problem;  ///< what is wrong
  std::string allowed;  ///< what is allowed; may be empty

  std::string message() const;
};

template <class T>
using Result = tl::expected<T, Failure>;
template <class T>
using Parsed = tl::expected<T, InputError>;

}  // namespace waywright
