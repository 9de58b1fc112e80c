#include "waywright/proof/pose_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/path/pose_motion.hpp"

namespace waywright {
namespace {

// m: spans of which curvature changes are judged. Short ones see jumps, long ones see small excess through
// noise.
constexpr double shortest_span = 0.02;
constexpr double longest_span = 1.3;

/// Holds |sum at j − sum at i| ≤ share·(progress at j − progress at i) + allowed for all i < j at once: that
/// is a rising and a falling line, each held against its extreme so far.
class Rule {
 public:
  Rule(double share, double allowed) : share_{share}, allowed_{allowed} {}

  struct Excess {
    double by = 0.0;        // over what is allowed
    double sum = 0.0;       // of the stretch
    double progress = 0.0;  // of the stretch, m
    Pose from{}, to{};
  };

  void add(double progress, double sum, const Pose& at) {
    for (Side* side : {&left_, &right_}) {
      const double signed_sum = side == &left_ ? sum : -sum;
      const double over = signed_sum - share_ * progress;
      if (!side->begun || over < side->least) *side = {true, over, progress, signed_sum, at};
      const double by = over - side->least - allowed_;
      if (by > worst_.by) worst_ = {by, signed_sum - side->sum, progress - side->progress, side->at, at};
    }
  }

  std::optional<Excess> worst() const { return worst_.by > 0.0 ? std::optional{worst_} : std::nullopt; }

 private:
  struct Side {
    bool begun = false;
    double least = 0.0, progress = 0.0, sum = 0.0;
    Pose at{};
  };
  double share_, allowed_;
  Side left_, right_;
  Excess worst_;
};

std::string stretch(const Pose& from, const Pose& to) {
  return fmt::format("between ({:.3f}, {:.3f}) and ({:.3f}, {:.3f})", from.x, from.y, to.x, to.y);
}

/// A piece goes in its direction: ahead as a whole, and never back by more than noise.
std::optional<Violation> retreat(const PoseSequence& sequence, const std::vector<PoseMotion>& motion,
                                 int direction) {
  std::size_t farthest = 0;
  std::size_t from = 0, to = 0;
  double worst = retreat_allowed;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    if (motion[i].progress > motion[farthest].progress) farthest = i;
    if (const double back = motion[farthest].progress - motion[i].progress; back > worst) {
      worst = back;
      from = farthest;
      to = i;
    }
  }
  if (to == 0 && motion.back().progress > 0.0) return std::nullopt;
  if (to == 0) {
    to = motion.size() - 1;
    worst = -motion.back().progress;
  }
  return Violation{fmt::format("{} the poses go {:.4f} m against their driving direction, which is {}",
                               stretch(sequence.poses[from], sequence.poses[to]), worst,
                               direction > 0 ? "forwards" : "backwards"),
                   sequence.poses[from]};
}

/// Curvature over a span before and after each place: their difference is at most the rate times the distance
/// of the spans' middles.
std::optional<Violation> rate_excess(const PoseSequence& sequence, const std::vector<PoseMotion>& motion,
                                     double limit) {
  const std::vector<std::size_t> nodes = thinned(motion);
  const auto at = [&](std::size_t k) -> const PoseMotion& { return motion[nodes[k]]; };
  std::optional<Violation> worst;
  double greatest = 1.0;
  for (double span = shortest_span; span < longest_span; span *= 2.0) {
    std::size_t i = 0, k = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      while (i + 1 < j && at(j).progress - at(i + 1).progress >= span) ++i;
      while (k + 1 < nodes.size() && at(k).progress - at(j).progress < span) ++k;
      const double before = at(j).progress - at(i).progress;
      const double after = at(k).progress - at(j).progress;
      if (before < span || after < span) continue;
      const double first = (at(j).turned - at(i).turned) / before;
      const double second = (at(k).turned - at(j).turned) / after;
      const double apart = 0.5 * (before + after);
      const double allowed =
          limit * (1.0 + estimate_slack) * apart + heading_change_allowed * (1.0 / before + 1.0 / after);
      if (std::abs(second - first) <= greatest * allowed) continue;
      greatest = std::abs(second - first) / allowed;
      const Pose& p = sequence.poses[nodes[j]];
      worst = Violation{fmt::format("near ({:.3f}, {:.3f}) the curvature of the poses goes from {:.4f} to "
                                    "{:.4f} 1/m within {:.2f} m, over the limit of "
                                    "the curvature rate of {:.4f} 1/m²",
                                    p.x, p.y, first, second, apart, limit),
                        p};
    }
  }
  return worst;
}

}  // namespace

std::vector<Violation> check_pose_sequences(const Vehicle& vehicle, const Path& path) {
  std::vector<Violation> violations;
  if (vehicle.moves_any_way()) return violations;
  const double limit = vehicle.max_curvature();
  Rule slip{slip_share, slip_allowed};
  Rule bend{limit * (1.0 + estimate_slack), turn_allowed};
  std::vector<Violation> retreats, rates;
  PoseMotion done;  // in the pieces before
  for (const Piece& piece : path.pieces) {
    const auto* sequence = std::get_if<PoseSequence>(&piece.curve);
    if (sequence == nullptr) continue;
    const std::vector<PoseMotion> motion = motion_along(*sequence, piece.direction);
    double ahead = 0.0;  // as far as the piece has come: going back and forth gains nothing
    for (std::size_t i = 0; i < motion.size(); ++i) {
      ahead = std::max(ahead, motion[i].progress);
      const double progress = done.progress + ahead;
      slip.add(progress, done.sideways + motion[i].sideways, sequence->poses[i]);
      if (std::isfinite(limit)) bend.add(progress, done.turned + motion[i].turned, sequence->poses[i]);
    }
    if (auto violation = retreat(*sequence, motion, piece.direction)) retreats.push_back(*violation);
    if (vehicle.limits.curvature_rate) {
      if (auto violation = rate_excess(*sequence, motion, *vehicle.limits.curvature_rate))
        rates.push_back(*violation);
    }
    done.progress += ahead;
    done.sideways += motion.back().sideways;
    done.turned += motion.back().turned;
  }
  if (const auto found = slip.worst()) {
    violations.push_back({fmt::format("{} the vehicle would slide {:.4f} m sideways over {:.4f} m of "
                                      "progress, which its drive cannot do",
                                      stretch(found->from, found->to), std::abs(found->sum), found->progress),
                          found->from});
  }
  // Who slides without getting ahead is told of the slide alone.
  if (violations.empty()) violations = std::move(retreats);
  if (const auto found = bend.worst()) {
    violations.push_back(
        {fmt::format("{} the poses turn by {:.4f} rad over {:.4f} m of progress, more than the curvature "
                     "limit of {:.4f} 1/m allows",
                     stretch(found->from, found->to), std::abs(found->sum), found->progress, limit),
         found->from});
  }
  violations.insert(violations.end(), rates.begin(), rates.end());
  return violations;
}

}  // namespace waywright
