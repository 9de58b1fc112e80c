#include "waywright/core/result.hpp"

#include <array>
#include <utility>

namespace waywright {
namespace {

constexpr std::array<std::pair<Status, const char*>, 9> words{{
    {Status::solved, "solved"},
    {Status::unproven, "unproven"},
    {Status::no_path, "no_path"},
    {Status::start_in_collision, "start_in_collision"},
    {Status::goal_in_collision, "goal_in_collision"},
    {Status::start_outside, "start_outside"},
    {Status::goal_outside, "goal_outside"},
    {Status::timed_out, "timed_out"},
    {Status::canceled, "canceled"},
}};

}  // namespace

const char* to_string(Status status) {
  for (const auto& [s, word] : words) {
    if (s == status) return word;
  }
  return "no_path";
}

std::optional<Status> status_from_string(const std::string& word) {
  for (const auto& [s, w] : words) {
    if (word == w) return s;
  }
  return std::nullopt;
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return text;
}

std::string InputError::message() const {
  std::string m;
  if (!file.empty()) m += file + ": ";
  if (!field.empty()) m += field + ": ";
  m += problem;
  if (!allowed.empty()) m += " (allowed: " + allowed + ")";
  return one_line(std::move(m));
}

}  // namespace waywright
