#include "waywright/planner/steering/way_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace waywright {
namespace {

constexpr double picture_tolerance = 0.01, picture_step = 0.12;  // m

std::string counted(int n, const char* one, const char* many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

}  // namespace

WayCounts counts_of(const Path& path) {
  WayCounts counts;
  int direction = 0;
  const Piece* before = nullptr;
  for (const Piece& piece : path.pieces) {
    if (const auto* turn = std::get_if<Turn>(&piece.curve)) {
      ++counts.turns;
      counts.turning += std::abs(turn->angle);
      before = nullptr;
      continue;
    }
    if (direction != 0 && piece.direction != direction) {
      ++counts.direction_changes;
    } else if (before != nullptr && end_curvature(*before) != start_curvature(piece)) {
      ++counts.curvature_jumps;
    }
    direction = piece.direction;
    before = &piece;
  }
  return counts;
}

std::string changes_words(const WayCounts& counts, bool is_turning) {
  std::string words = counted(counts.direction_changes, "change of direction", "changes of direction");
  if (is_turning) words += fmt::format(" and {}, {:.1f}° in all", counted(counts.turns, "turn on the spot", "turns on the spot"), counts.turning * 180.0 / pi);
  return words;
}

std::string jumps_sentence(const WayCounts& counts) {
  if (counts.curvature_jumps == 0) return {};
  return fmt::format("Its curvature jumps at {} between changes of direction: there a vehicle stands whose steering takes time, or whose turning speeds up only so fast.",
                     counted(counts.curvature_jumps, "place", "places"));
}

std::vector<Pose> poses_along(const Path& path) {
  std::vector<Pose> poses;
  if (path.pieces.empty()) return poses;
  for (const Sample& s : sample(path, 0.0, picture_tolerance, picture_step)) poses.push_back(s.pose());
  return poses;
}

}  // namespace waywright
