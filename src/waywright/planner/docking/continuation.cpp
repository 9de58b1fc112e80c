#include "waywright/planner/docking/continuation.hpp"

#include <algorithm>

#include "waywright/path/remainder.hpp"
#include "waywright/planner/docking/carry.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

constexpr double least_left = 1e-4;  // m
constexpr double passed_by = 2e-9;   // m into a piece: a turn on the spot before it is over
constexpr double at_rest = 1e-6;     // m/s
constexpr double same_place = 1e-6;  // m
constexpr double at_one_place = 1e-9;  // m, between two samples
constexpr double no_turn = 1e-9;     // rad
constexpr double turned_by = 1e-6;   // rad, that samples may miss of a turn

/// Whether the vehicle stands where piece i ends, s metres on the way: it changes direction or turns there, or its speed comes down to nothing.
bool stands_after(const Path& path, std::size_t i, const std::vector<Sample>& samples, double s) {
  if (i + 1 >= path.pieces.size() || path.pieces[i + 1].direction != path.pieces[i].direction) return true;
  const auto from = std::lower_bound(samples.begin(), samples.end(), s - same_place, [](const Sample& a, double value) { return a.s < value; });
  for (auto at = from; at != samples.end() && at->s <= s + same_place; ++at) {
    if (at->speed <= at_rest) return true;
  }
  return false;
}

/// Turns on the spot that the path makes at a place.
struct Turns {
  double whole = 0.0;            ///< rad, all of them, whichever way
  bool is_gone_on_from = false;  ///< something is driven after them
};
Turns turns_at(const Path& path, double s) {
  Turns turns;
  double here = 0.0;
  for (const Piece& piece : path.pieces) {
    if (const auto* turn = std::get_if<Turn>(&piece.curve)) {
      if (std::abs(here - s) <= same_place) turns.whole += std::abs(turn->angle);
      continue;
    }
    here += length(piece);
    turns.is_gone_on_from = turns.is_gone_on_from || (turns.whole > 0.0 && here > s + same_place);
  }
  return turns;
}

/// rad that the samples have turned at the place where `at` stands, up to `time` s after it.
double turned_at(const std::vector<Sample>& samples, std::vector<Sample>::const_iterator at, const Sample& next, double time) {
  const double part = next.t > at->t ? std::clamp(time / (next.t - at->t), 0.0, 1.0) : 0.0;
  double turned = part * std::abs(shorter_turn(at->heading, next.heading));
  for (; at != samples.begin() && at->s - std::prev(at)->s <= at_one_place; --at) turned += std::abs(shorter_turn(std::prev(at)->heading, at->heading));
  return turned;
}

/// Puts `driven` on its piece, that in which `within` metres lie: at its end where less than a tenth of a millimetre is left, curves shorter than which are nothing but
/// rounding; behind the turns before it. True where the vehicle stands there.
bool place_on_piece(const Path& path, const std::vector<Sample>& samples, double within, double& driven) {
  double end = 0.0;
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    const double begin = end;
    end += length(path.pieces[i]);
    if (path.pieces[i].direction == 0 || within > end) continue;
    if (end - driven < least_left) {
      driven = end;
      return stands_after(path, i, samples, end);
    }
    if (driven - begin < passed_by && i > 0) driven = begin + passed_by;
    return false;
  }
  driven = end;  // rounding beyond the last
  return true;
}

}  // namespace

Handover handover_at(const Path& path, const std::vector<Sample>& samples, double t) {
  Handover handover;
  if (samples.empty() || path.pieces.empty()) return handover;
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double time, const Sample& s) { return time < s.t; });
  const auto before = after == samples.begin() ? after : std::prev(after);
  const Sample &a = *before, &b = after == samples.end() ? samples.back() : *after;
  const double time = t - a.t;
  double speed = 0.0;
  if (b.s - a.s > at_one_place) {
    const WithinStep within = within_step(a, b, time);
    handover.driven = a.s + within.way;
    speed = place_on_piece(path, samples, a.s + std::max(within.way, std::min(0.5 * (b.s - a.s), same_place)), handover.driven) ? 0.0 : within.speed;
  } else {
    handover.driven = a.s;
    const Turns turns = turns_at(path, a.s);
    const double done = turned_at(samples, before, b, time), now = std::abs(shorter_turn(a.heading, b.heading));
    const bool is_turning = now > no_turn && time > 0.0 && b.t > a.t;
    if (turns.whole == 0.0) {
      place_on_piece(path, samples, handover.driven, handover.driven);
    } else if (done >= turns.whole - turned_by && turns.is_gone_on_from) {
      handover.driven += passed_by;
    } else if (is_turning ? done > 0.0 : done > turned_by) {
      handover.is_turning = true;
      handover.turned = std::min(done, turns.whole);
    }
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
