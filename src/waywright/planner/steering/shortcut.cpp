#include "waywright/planner/steering/shortcut.hpp"

#include <cmath>
#include <utility>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

constexpr double least_gain = 1e-6;  // m
constexpr double sliver = 0.02;      // m: what would be left of a piece is not worth a joint of its own

/// `s`, or the joint nearest to it where that is within a sliver.
double snapped(const Pieces& pieces, double s) {
  double joint = 0.0;
  double nearest = 0.0;
  for (const Piece& piece : pieces) {
    joint += length(piece);
    if (std::abs(joint - s) < std::abs(nearest - s)) nearest = joint;
  }
  return std::abs(nearest - s) <= sliver ? nearest : s;
}

}  // namespace

Path shortened(const Path& path, const ReedsShepp& curves, MotionTest& test, int attempts,
               std::uint64_t seed) {
  Pieces best = path.pieces;
  double whole = length(path);
  const auto try_between = [&](double begin, double end) {
    if (end - begin < least_gain) return;
    const Pose from = begin <= 0.0 ? start_pose(best.front()) : pose_at(best, begin);
    const Pose to = end >= whole ? end_pose(best.back()) : pose_at(best, end);
    if (curves.distance(from, to) > end - begin - least_gain) return;
    const Pieces cut = curves.between(from, to);
    if (!test.motion_free(cut)) return;
    Pieces joined;
    for (const Piece& piece : part_of(best, 0.0, begin)) append_merged(joined, piece);
    for (const Piece& piece : cut) append_merged(joined, piece);
    for (const Piece& piece : part_of(best, end, whole)) append_merged(joined, piece);
    best = std::move(joined);
    whole = length(Path{best});
  };

  Random random{seed};
  if (attempts > 0 && !test.spent()) try_between(0.0, whole);
  for (int attempt = 0; attempt < attempts && !test.spent(); ++attempt) {
    // Short spans more often than long ones: late in the work only short ones still give something.
    const double u = random.uniform();
    const double span = whole * u * u;
    const double begin = random.uniform(0.0, whole - span);
    try_between(snapped(best, begin), snapped(best, begin + span));
  }
  return Path{std::move(best)};
}

}  // namespace waywright
