#include "waywright/proof/proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "waywright/proof/collision.hpp"
#include "waywright/proof/limits.hpp"

namespace waywright {
namespace {

constexpr double comparison_slack = 1e-6;     // m, for a clearance that is met exactly

void append(std::vector<Violation>& all, std::vector<Violation> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// What is proven of one body against one world; the world names what is tightest.
struct Finding {
  SweptClearance swept;
  const World* world = nullptr;
};

/// The tighter of two, and the work of both.
void merge(Finding& all, const SweptClearance& swept, const World& world) {
  const std::int64_t queries = all.swept.queries + swept.queries;
  const bool complete = all.swept.complete && swept.complete;
  const double lower = std::min(all.swept.lower, swept.lower);
  const double length = all.swept.length;
  const double rounding = std::max(all.swept.rounding, swept.rounding);
  if (swept.upper < all.swept.upper) all = {swept, &world};
  all.swept.rounding = rounding;
  all.swept.queries = queries;
  all.swept.complete = complete;
  all.swept.lower = lower;
  all.swept.length = length;
}

std::string place(const Finding& finding) {
  const SweptClearance& s = finding.swept;
  if (!s.tightest) return "anything";
  return fmt::format("{} at ({:.3f}, {:.3f}), vehicle at ({:.3f}, {:.3f}, {:.4f} rad)", finding.world->source_name(s.contact.source),
                     s.contact.point.x, s.contact.point.y, s.tightest->x, s.tightest->y, s.tightest->heading);
}

std::optional<Violation> too_near(const Finding& finding, const char* what, double margin) {
  if (!finding.swept.complete) {
    return Violation{fmt::format("the collision proof ended undecided after {} distance queries", finding.swept.queries),
                     finding.swept.tightest};
  }
  if (finding.swept.lower > margin) return std::nullopt;
  const std::string where = place(finding);
  return Violation{finding.swept.upper <= 0.0
                       ? fmt::format("{} {} {}", what, std::string_view{what}.ends_with('s') ? "touch" : "touches", where)
                       : fmt::format("within the pose error {} can touch {}: {:.4f} m of clearance, {:.4f} m of pose error", what, where,
                                     finding.swept.upper, margin),
                   finding.swept.tightest};
}

}  // namespace

Proof prove(const Problem& problem, const Path& path, const ProofOptions& options) {
  Proof proof;
  proof.certificate.tolerance = options.tolerance;
  proof.violations = check_form(path);
  if (!proof.violations.empty()) return proof;
  if (const double needed = samples_needed(path, problem.footprint().radius(), options.tolerance); !(needed <= most_samples)) {
    proof.violations.push_back({std::isfinite(needed) ? fmt::format("the path is too long or too bent: it needs {:.0f} samples, and at most {} are allowed",
                                                                    needed, most_samples)
                                                      : "the path has a cusp, where the vehicle's heading is not defined",
                                std::nullopt});
    return proof;
  }
  proof.measurable = true;

  append(proof.violations, check_continuity(problem, path, options));
  append(proof.violations, check_limits(problem.vehicle(), path));

  // What is driven in the open, and the stretch in the shelf.
  const std::optional<std::size_t> pocket_piece = problem.pocket_piece(path);
  if (problem.pocket() && !pocket_piece) {
    proof.violations.push_back({"the straight stretch between the docked pose and the forks' place in the shelf does not stand as one line at the path's "
                                "end in the shelf",
                                std::nullopt});
  }
  std::vector<MotionInterval> open, in_shelf;
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    std::vector<MotionInterval> more = MotionInterval::of(path.pieces[i]);
    std::vector<MotionInterval>& motion = pocket_piece == i ? in_shelf : open;
    motion.insert(motion.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }

  const double margin = problem.pose_error_margin();
  const double required = problem.required_clearance();
  Finding finding{swept_clearance(problem.world(), problem.footprint(), open, {options.tolerance, required, World::nothing, options.cancel}), &problem.world()};
  Certificate& certificate = proof.certificate;
  certificate.checked_length = finding.swept.length;
  std::optional<Finding> forks;
  if (pocket_piece) {
    const PocketMotion& pocket = *problem.pocket();
    for (const MotionInterval& interval : in_shelf) certificate.checked_length += interval.length();
    merge(finding, swept_clearance(problem.world(), problem.footprint(), in_shelf, {options.tolerance, required, pocket.shelf_source, options.cancel}),
          problem.world());
    for (const Ring& ring : pocket.rest) {
      merge(finding, swept_clearance(pocket.shelf, Footprint{ring, 0.0}, in_shelf, {options.tolerance, required, World::nothing, options.cancel}), pocket.shelf);
    }
    for (const Ring& fork : pocket.forks) {
      const SweptClearance swept = swept_clearance(pocket.beside_pockets, Footprint{fork, 0.0}, in_shelf, {options.tolerance, margin, World::nothing, options.cancel});
      if (forks) merge(*forks, swept, pocket.beside_pockets);
      else forks = Finding{swept, &pocket.beside_pockets};
    }
    certificate.pocket_clearance = std::max(0.0, forks->swept.lower - margin);
  }

  const SweptClearance& swept = finding.swept;
  if (swept.tightest) {
    certificate.tightest = swept.tightest;
    certificate.tightest_point = swept.contact.point;
    certificate.tightest_obstacle = finding.world->source_name(swept.contact.source);
  }
  certificate.clearance = std::max(0.0, swept.lower - margin);
  // Distances are what they are up to rounding: one that differs from what is required by no more than that is the one required.
  const double short_by = required - swept.lower;
  if (short_by > 0.0 && short_by <= 2.0 * swept.rounding && swept.upper >= required - swept.rounding) {
    certificate.clearance = problem.scenario().clearance;
  }
  certificate.collision_free = swept.complete && swept.lower > margin;
  if (forks) certificate.collision_free &= forks->swept.complete && forks->swept.lower > margin;

  if (auto violation = too_near(finding, "the footprint", margin)) {
    proof.violations.push_back(*violation);
  } else if (certificate.clearance < problem.scenario().clearance - comparison_slack) {
    proof.violations.push_back({fmt::format("the proven clearance is {:.4f} m, under the {:.4f} m asked for; tightest against {}",
                                            certificate.clearance, problem.scenario().clearance,
                                            swept.tightest ? certificate.tightest_obstacle : "nothing"),
                                swept.tightest});
  }
  if (forks) {
    if (auto violation = too_near(*forks, "the forks", margin)) proof.violations.push_back(*violation);
  }
  return proof;
}

}  // namespace waywright
