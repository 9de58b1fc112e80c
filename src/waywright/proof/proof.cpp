#include "waywright/proof/proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "waywright/proof/collision.hpp"
#include "waywright/proof/directions.hpp"
#include "waywright/proof/limits.hpp"
#include "waywright/proof/passing.hpp"

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
                     s.contact.point.x, s.contact.point.y, s.tightest->x, s.tightest->y, wrap(s.tightest->heading));
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

// Of a docking path; longer ones reserve what they need.
constexpr std::size_t usual_pieces = 8;
constexpr std::size_t usual_curves = 16;

std::vector<SweptBody> bodies_of(const std::vector<Footprint>& parts) {
  std::vector<SweptBody> bodies;
  for (const Footprint& part : parts) bodies.emplace_back(part);
  return bodies;
}

}  // namespace

struct ProofWorkspace::State {
  SweptBody vehicle;
  std::vector<SweptBody> rest, forks;  // of the vehicle in a pocket
  Motion motion;
  SweepMemory memory;
};

ProofWorkspace::ProofWorkspace(const Problem& problem)
    : state_{new State{SweptBody{problem.footprint()}, problem.pocket() ? bodies_of(problem.pocket()->rest) : std::vector<SweptBody>{},
                       problem.pocket() ? bodies_of(problem.pocket()->forks) : std::vector<SweptBody>{}, {}, {}}} {
  state_->motion.reserve(usual_pieces, usual_curves);
  state_->memory.reserve(state_->vehicle);
  for (const auto* bodies : {&state_->rest, &state_->forks}) {
    for (const SweptBody& body : *bodies) state_->memory.reserve(body);
  }
}
ProofWorkspace::ProofWorkspace(ProofWorkspace&&) noexcept = default;
ProofWorkspace& ProofWorkspace::operator=(ProofWorkspace&&) noexcept = default;
ProofWorkspace::~ProofWorkspace() = default;

Proof prove(const Problem& problem, const Path& path, const ProofOptions& options) {
  ProofWorkspace workspace{problem};
  return prove(problem, path, options, workspace);
}

Proof prove(const Problem& problem, const Path& path, const ProofOptions& options, ProofWorkspace& workspace) {
  ProofWorkspace::State& state = *workspace.state_;
  Proof proof;
  proof.certificate.tolerance = options.tolerance;
  proof.violations = check_form(path);
  if (!proof.violations.empty()) return proof;
  if (!can_be_sampled(path, state.vehicle.radius, options.tolerance)) {
    const double needed = samples_needed(path, state.vehicle.radius, options.tolerance);
    proof.violations.push_back({std::isfinite(needed) ? fmt::format("the path is too long or too bent: it needs {:.0f} samples, and at most {} are allowed",
                                                                    needed, most_samples)
                                                      : "the path has a cusp, where the vehicle's heading is not defined",
                                std::nullopt});
    return proof;
  }
  proof.measurable = true;

  Motion& motion = state.motion;
  motion.assign(path);
  append(proof.violations, check_directions(problem, path, motion, options));  // first: a reason names a few violations only, and these are about what was asked
  append(proof.violations, check_continuity(problem, path, motion, options));
  append(proof.violations, check_limits(problem.vehicle(), path, motion));
  append(proof.violations, check_waypoints(problem, motion, options));

  // What is driven in the open, and the stretch in the shelf.
  const std::optional<std::size_t> pocket_piece = problem.pocket_piece(path);
  if (problem.pocket() && !pocket_piece) {
    proof.violations.push_back({"the straight stretch between the docked pose and the forks' place in the shelf does not stand as one line at the path's "
                                "end in the shelf",
                                std::nullopt});
  }
  const std::size_t first_open = pocket_piece && problem.is_driven_back() ? 1 : 0;
  const std::size_t last_open = pocket_piece && !problem.is_driven_back() ? *pocket_piece : path.pieces.size();

  const double margin = problem.pose_error_margin();
  const double required = problem.required_clearance();
  const World& world = problem.world();
  const auto sweep = [&](const World& obstacles, const SweptBody& body, std::span<const MotionInterval> intervals, double least, std::size_t without) {
    return swept_clearance(obstacles, body, intervals, {options.tolerance, least, without, options.cancel}, state.memory);
  };
  Finding finding{sweep(world, state.vehicle, motion.intervals(first_open, last_open), required, World::nothing), &world};
  Certificate& certificate = proof.certificate;
  certificate.checked_length = finding.swept.length;
  std::optional<Finding> forks;
  if (pocket_piece) {
    const PocketMotion& pocket = *problem.pocket();
    const std::span<const MotionInterval> in_shelf = motion.of_piece(*pocket_piece);
    for (const MotionInterval& interval : in_shelf) certificate.checked_length += interval.length();
    merge(finding, sweep(world, state.vehicle, in_shelf, required, pocket.shelf_source), world);
    for (const SweptBody& body : state.rest) merge(finding, sweep(pocket.shelf, body, in_shelf, required, World::nothing), pocket.shelf);
    for (const SweptBody& body : state.forks) {
      const SweptClearance swept = sweep(pocket.beside_pockets, body, in_shelf, margin, World::nothing);
      if (forks) merge(*forks, swept, pocket.beside_pockets);
      else forks = Finding{swept, &pocket.beside_pockets};
    }
    certificate.pocket_clearance = std::max(0.0, forks->swept.lower - margin);
  }

  const SweptClearance& swept = finding.swept;
  if (swept.tightest) {
    certificate.tightest = swept.tightest;
    certificate.tightest_point = swept.contact.point;
    certificate.tightest_source = finding.world == &world ? swept.contact.source : problem.pocket()->shelf_source;
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
                                            world.source_name(certificate.tightest_source)),
                                swept.tightest});
  }
  if (forks) {
    if (auto violation = too_near(*forks, "the forks", margin)) proof.violations.push_back(*violation);
  }
  return proof;
}

}  // namespace waywright
