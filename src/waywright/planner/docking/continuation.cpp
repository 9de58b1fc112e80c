#include "waywright/planner/docking/continuation.hpp"

#include <algorithm>

#include "waywright/path/remainder.hpp"
#include "waywright/planner/docking/carry.hpp"

namespace waywright {
namespace {

constexpr double least_left = 1e-4;  // m
constexpr double passed_by = 2e-9;   // m into a piece: a turn on the spot before it is over
constexpr double at_rest = 1e-6;     // m/s
constexpr double same_place = 1e-6;  // m

/// Whether the vehicle stands where piece i ends, s metres on the way: it changes direction or turns there, or its speed comes down to nothing.
bool stands_after(const Path& path, std::size_t i, const std::vector<Sample>& samples, double s) {
  if (i + 1 >= path.pieces.size() || path.pieces[i + 1].direction != path.pieces[i].direction) return true;
  const auto from = std::lower_bound(samples.begin(), samples.end(), s - same_place, [](const Sample& a, double value) { return a.s < value; });
  for (auto at = from; at != samples.end() && at->s <= s + same_place; ++at) {
    if (at->speed <= at_rest) return true;
  }
  return false;
}

}  // namespace

Handover handover_at(const Path& path, const std::vector<Sample>& samples, double t) {
  Handover handover;
  if (samples.empty() || path.pieces.empty()) return handover;
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double time, const Sample& s) { return time < s.t; });
  const Sample& a = after == samples.begin() ? samples.front() : *std::prev(after);
  const Sample& b = after == samples.end() ? samples.back() : *after;
  const double way = b.s - a.s, time = std::clamp(t - a.t, 0.0, std::max(0.0, b.t - a.t));
  const double sum = a.speed + b.speed;
  double speed = 0.0;
  handover.driven = a.s;
  if (way > 0.0 && sum > 0.0) {  // evenly accelerated
    const double acceleration = 0.5 * (b.speed - a.speed) * sum / way;
    handover.driven += std::clamp(a.speed * time + 0.5 * acceleration * time * time, 0.0, way);
    speed = std::max(0.0, a.speed + acceleration * time);
  } else if (way > 0.0 && time > 0.0) {  // from rest to rest: taken to stand at the end
    handover.driven = b.s;
  } else {  // at one place
    handover.is_turning = a.direction == 0 && b.direction == 0 && after != samples.begin() && after != samples.end();
    speed = a.speed;
  }
  // Its piece: what is left of it is measured from its end, where curves of less than a tenth of a millimetre are nothing but rounding.
  double end = 0.0;
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    const double begin = end;
    end += length(path.pieces[i]);
    if (path.pieces[i].direction == 0 || handover.driven > end + least_left) continue;
    if (end - handover.driven >= least_left) {
      if (handover.driven - begin < passed_by && i > 0 && a.direction != 0) handover.driven = begin + passed_by;
      break;
    }
    handover.driven = end;
    if (stands_after(path, i, samples, end)) speed = 0.0;
    break;
  }
  const Path rest = remainder(path, handover.driven);
  const Piece& first = rest.pieces.front();
  handover.pose = start_pose(first);
  if (speed > 0.0) {
    handover.motion = {first.direction < 0 ? -speed : speed, start_curvature(first)};
    if (first.heading) {
      handover.motion.course = start_pose(Piece{first.curve, first.direction, {}}).heading;
      handover.motion.angular_velocity = first.heading->turn / length(first) * speed;
    }
  }
  return handover;
}

std::optional<Continuation> continuation(const Problem& problem, const Path& old, double driven) {
  auto rest = pattern_left(problem, old, driven);
  if (!rest) return std::nullopt;
  return Continuation{problem.whole_path(std::move(rest->carried), true), rest->farthest};
}

}  // namespace waywright
