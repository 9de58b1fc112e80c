#include "waywright/planner/docking/pattern_solver.hpp"

#include "waywright/judge/entry.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

constexpr double little_worse = 1.1;  // times the cost of the best

}  // namespace

PatternSolver::PatternSolver(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer, std::uint64_t seed)
    : prepared_{prepared}, options_{options}, seed_{seed}, search_{prepared, options_, optimizer}, nearby_{prepared, options_, optimizer}, sides_{&none_}, proving_{prepared.problem()} {
  none_.resize(prepared.task().zones.size());
}

void PatternSolver::reserve(std::size_t samples) {
  for (std::vector<Sample>* of : {&samples_, &ahead_.samples, &next_.samples}) of->reserve(samples);
  timing_.reserve(samples);
}

const SideFound* PatternSolver::solve(bool second_choice, Budget& budget) {
  prove_ahead(budget);
  const SideFound* found = solve_watched(second_choice, budget);
  search_.watch({});
  return found;
}

const SideFound* PatternSolver::solve_watched(bool second_choice, Budget& budget) {
  const Problem& problem = prepared_.problem();
  sides_ = &none_;
  in_motion_ = tried_in_motion_ = false;
  can_stop_ = !problem.blocked_stop();
  if (const auto& motion = problem.motion(); motion && motion->direction < 0) {
    tried_in_motion_ = in_motion_ = true;
    const PatternEntry moving{{placement_of(problem.first_pose()), motion->curvature}, motion->speed};
    if (const SideFound* best = best_standing(search_.search(moving, options_.evaluations, seed_, true, budget), budget)) return best;
    in_motion_ = has_ahead_ = false;
    if (budget.exhausted()) return nullptr;
  }
  if (!can_stop_) return nullptr;
  const PatternEntry standing{{placement_of(problem.start())}};
  if (const SideFound* best = best_standing(search_.search(standing, options_.evaluations, seed_, second_choice, budget), budget)) return best;
  for (std::int64_t times = 2; times <= harder_times && !budget.limits().evaluations && !budget.exhausted(); ++times) {
    if (const SideFound* best = best_standing(search_.search_on(options_.evaluations * times, budget), budget)) return best;
  }
  return nullptr;
}

std::optional<Continuation> PatternSolver::carry_on(const Path& old, double driven, Budget& budget) {
  auto rest = continuation(prepared_.problem(), old, driven);
  if (!rest || stands(rest->path)) return rest;
  rest = nearby_.search(old, driven, seed_, budget);
  if (rest && !stands(rest->path)) rest.reset();
  return rest;
}

/// The search allows for what is between its samples by estimates; what the proof does not confirm is not offered.
SideFound* PatternSolver::best_standing(std::vector<SideFound>& sides, const Budget& budget) {
  sides_ = &sides;
  const bool is_cut_short = budget.canceled() || budget.cut_short();
  while (SideFound* best = best_of(sides)) {
    if (take_ahead(static_cast<std::size_t>(best - sides.data()), *best, is_cut_short)) return best;
    if (stands(prepared_.problem().whole_path(path_of(*best), in_motion_))) return best;
    best->refused = true;
  }
  return nullptr;
}

void PatternSolver::prove_ahead(Budget& budget) {
  has_ahead_ = false;
  if (budget.cancel_flag() == nullptr && !budget.limits().seconds) return search_.watch({});
  search_.watch([this, &budget](std::size_t side, const SideFound& found) {
    if (budget.exhausted()) return;
    const Problem& problem = prepared_.problem();
    next_.side = side;
    next_.found = found;
    next_.path = problem.whole_path(path_of(found), in_motion_);
    ProofOptions options;
    options.cancel = budget.cancel_flag();
    next_.proof = prove(problem, next_.path, options, proving_);
    if (!next_.proof.holds()) return;
    sample(next_.path, problem.footprint().radius(), next_.proof.certificate.tolerance, sample_step, next_.samples);
    if (problem.motion() && !can_be_entered(problem, next_.samples, timing_, zone_limits(problem, next_.samples, next_.proof.certificate.tolerance))) return;
    std::swap(ahead_, next_);
    has_ahead_ = true;
  });
}

/// What was proven ahead is the answer where it is the best still; where the run was cut short also where that is a little worse than what was
/// found since.
bool PatternSolver::take_ahead(std::size_t side, SideFound& best, bool is_cut_short) {
  if (!has_ahead_ || ahead_.side != side) return false;
  const SideFound& ahead = ahead_.found;
  const bool is_the_best = ahead.cost == best.cost && ahead.transition == best.transition;
  if (!is_the_best && !(is_cut_short && ahead.cost >= best.cost && ahead.cost <= little_worse * best.cost)) return false;
  const std::int64_t evaluations = best.evaluations;
  const bool given_up = best.given_up;
  best = ahead;
  best.evaluations = evaluations;
  best.given_up = given_up;
  std::swap(path_, ahead_.path);
  std::swap(proof_, ahead_.proof);
  std::swap(samples_, ahead_.samples);
  is_sampled_ = true;
  has_ahead_ = false;
  return true;
}

bool PatternSolver::stands(const Path& whole) {
  const Problem& problem = prepared_.problem();
  path_ = whole;
  proof_ = prove(problem, path_, {}, proving_);
  is_sampled_ = false;
  return proof_.holds() && (!problem.motion() || can_be_entered(problem, samples(), timing_, zone_limits(problem, samples(), proof_.certificate.tolerance)));
}

std::vector<Sample>& PatternSolver::samples() {
  if (!is_sampled_) sample(path_, prepared_.problem().footprint().radius(), proof_.certificate.tolerance, sample_step, samples_);
  is_sampled_ = true;
  return samples_;
}

Path path_of(const SideFound& side) { return pattern_path(splines_of(side.pattern)); }

}  // namespace waywright
