#include "waywright/proof/proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "waywright/proof/collision.hpp"
#include "waywright/proof/limits.hpp"

namespace waywright {
namespace {

constexpr double fine_tolerance = 5e-7;       // m, second look where the first bound is just short; under the slack
constexpr double comparison_slack = 1e-6;     // m, for a clearance that is met exactly

void append(std::vector<Violation>& all, std::vector<Violation> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

Proof prove(const Problem& problem, const Path& path, const ProofOptions& options) {
  Proof proof;
  proof.certificate.tolerance = options.tolerance;
  proof.violations = check_form(path);
  if (!proof.violations.empty()) return proof;

  append(proof.violations, check_continuity(problem, path, options));
  append(proof.violations, check_limits(problem.vehicle(), path));

  std::vector<MotionInterval> intervals;
  for (const Piece& piece : path.pieces) {
    std::vector<MotionInterval> more = MotionInterval::of(piece);
    intervals.insert(intervals.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  const Footprint& footprint = problem.vehicle().footprint;
  const double margin = problem.pose_error_margin();
  const double required = problem.required_clearance();
  SweptClearance swept = swept_clearance(problem.world(), footprint, intervals, options.tolerance);
  if (swept.complete && swept.lower < required && swept.upper >= required - comparison_slack) {
    swept = swept_clearance(problem.world(), footprint, intervals, fine_tolerance);
  }

  Certificate& certificate = proof.certificate;
  certificate.checked_length = swept.length;
  certificate.tightest = swept.tightest;
  certificate.tightest_point = swept.contact.point;
  certificate.tightest_obstacle = problem.world().empty() ? "" : problem.world().source_name(swept.contact.source);
  certificate.clearance = std::max(0.0, swept.lower - margin);
  certificate.collision_free = swept.complete && swept.lower > margin;

  if (!swept.complete) {
    proof.violations.push_back({fmt::format("the collision proof ended undecided after {} distance queries", swept.queries),
                                swept.tightest});
  } else if (!certificate.collision_free) {
    const std::string where = fmt::format("{} at ({:.3f}, {:.3f}), vehicle at ({:.3f}, {:.3f}, {:.4f} rad)",
                                          certificate.tightest_obstacle, swept.contact.point.x, swept.contact.point.y,
                                          swept.tightest.x, swept.tightest.y, swept.tightest.heading);
    proof.violations.push_back(
        {swept.upper <= 0.0 ? fmt::format("the footprint touches {}", where)
                            : fmt::format("within the pose error the footprint can touch {}: {:.4f} m of clearance, {:.4f} m of "
                                          "pose error",
                                          where, swept.upper, margin),
         swept.tightest});
  } else if (certificate.clearance < problem.scenario().clearance - comparison_slack) {
    proof.violations.push_back({fmt::format("the proven clearance is {:.4f} m, under the {:.4f} m asked for; tightest against {}",
                                            certificate.clearance, problem.scenario().clearance,
                                            certificate.tightest_obstacle),
                                swept.tightest});
  }
  return proof;
}

}  // namespace waywright
