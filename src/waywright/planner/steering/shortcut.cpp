#include "waywright/planner/steering/shortcut.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "waywright/core/random.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"

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

/// A place on a way along states, so much of its cost after the start.
struct Place {
  std::size_t after = 0;  ///< the last state before it
  double at = 0.0;        ///< m
  Pose pose{};
};

class Way {
 public:
  Way(const Steering& steering, std::vector<Pose> states) : steering_{steering}, states_{std::move(states)} { measure(); }

  double whole() const { return reached_.back(); }
  const std::vector<Pose>& states() const { return states_; }
  /// The place there, or the state beside it where one is within a sliver.
  Place place(double at) const {
    std::size_t next = 1;
    while (next + 1 < states_.size() && reached_[next] < at) ++next;
    const std::size_t after = next - 1;
    if (at - reached_[after] <= sliver) return {after, reached_[after], states_[after]};
    if (reached_[next] - at <= sliver) return {next, reached_[next], states_[next]};
    return {after, at, steering_.at(states_[after], states_[next], (at - reached_[after]) / (reached_[next] - reached_[after]))};
  }
  void replace(const Place& from, const Place& to) {
    std::vector<Pose> joined(states_.begin(), states_.begin() + static_cast<std::ptrdiff_t>(from.after) + 1);
    if (from.at > reached_[from.after]) joined.push_back(from.pose);
    if (to.at > reached_[to.after]) {
      joined.push_back(to.pose);
      joined.insert(joined.end(), states_.begin() + static_cast<std::ptrdiff_t>(to.after) + 1, states_.end());
    } else {
      joined.insert(joined.end(), states_.begin() + static_cast<std::ptrdiff_t>(to.after), states_.end());
    }
    states_ = std::move(joined);
    measure();
  }

 private:
  void measure() {
    reached_.assign(1, 0.0);
    for (std::size_t i = 1; i < states_.size(); ++i) reached_.push_back(reached_.back() + steering_.distance(states_[i - 1], states_[i]));
  }

  const Steering& steering_;
  std::vector<Pose> states_;
  std::vector<double> reached_;  ///< m, from the start to each state
};

}  // namespace

Path shortened(const Path& path, const Steering& curves, MotionTest& test, int attempts,
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

std::vector<Pose> shortened(std::vector<Pose> states, const Steering& steering, MotionTest& test, int attempts, std::uint64_t seed) {
  if (states.size() < 2) return states;
  Way way{steering, std::move(states)};
  const auto try_between = [&](const Place& from, const Place& to) {
    if (to.at - from.at < least_gain || steering.distance(from.pose, to.pose) > to.at - from.at - least_gain) return;
    if (test.motion_free(steering.between(from.pose, to.pose))) way.replace(from, to);
  };
  Random random{seed};
  if (attempts > 0 && !test.spent()) try_between(way.place(0.0), way.place(way.whole()));
  for (int attempt = 0; attempt < attempts && way.states().size() > 2 && !test.spent(); ++attempt) {
    const double u = random.uniform();
    const double span = way.whole() * u * u;
    const double begin = random.uniform(0.0, way.whole() - span);
    try_between(way.place(begin), way.place(begin + span));
  }
  return way.states();
}

double cost_of(const Steering& steering, const std::vector<Pose>& states) {
  double cost = 0.0;
  for (std::size_t i = 1; i < states.size(); ++i) cost += steering.distance(states[i - 1], states[i]);
  return cost;
}

}  // namespace waywright
