#include "waywright/planner/docking/pattern_solver.hpp"

#include "waywright/judge/entry.hpp"

namespace waywright {
PatternSolver::PatternSolver(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer, std::uint64_t seed)
    : prepared_{prepared}, options_{options}, seed_{seed}, search_{prepared, options_, optimizer}, nearby_{prepared, options_, optimizer}, sides_{&none_}, proving_{prepared.problem()} {
  none_.resize(prepared.task().zones.size());
}

void PatternSolver::reserve(std::size_t samples) {
  samples_.reserve(samples);
  timing_.reserve(samples);
}

const SideFound* PatternSolver::solve(bool second_choice, Budget& budget) {
  const Problem& problem = prepared_.problem();
  sides_ = &none_;
  in_motion_ = tried_in_motion_ = false;
  can_stop_ = !problem.blocked_stop();
  if (const auto& motion = problem.motion(); motion && motion->direction < 0) {
    tried_in_motion_ = in_motion_ = true;
    const PatternEntry moving{{placement_of(problem.first_pose()), motion->curvature}, motion->speed};
    if (const SideFound* best = best_standing(search_.search(moving, options_.evaluations, seed_, true, budget))) return best;
    in_motion_ = false;
    if (budget.exhausted()) return nullptr;
  }
  if (!can_stop_) return nullptr;
  const PatternEntry standing{{placement_of(problem.start())}};
  if (const SideFound* best = best_standing(search_.search(standing, options_.evaluations, seed_, second_choice, budget))) return best;
  for (std::int64_t times = 2; times <= harder_times && !budget.limits().evaluations && !budget.exhausted(); ++times) {
    if (const SideFound* best = best_standing(search_.search_on(options_.evaluations * times, budget))) return best;
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
SideFound* PatternSolver::best_standing(std::vector<SideFound>& sides) {
  sides_ = &sides;
  while (SideFound* best = best_of(sides)) {
    if (stands(prepared_.problem().whole_path(path_of(*best), in_motion_))) return best;
    best->refused = true;
  }
  return nullptr;
}

bool PatternSolver::stands(const Path& whole) {
  const Problem& problem = prepared_.problem();
  path_ = whole;
  proof_ = prove(problem, path_, {}, proving_);
  is_sampled_ = false;
  return proof_.holds() && (!problem.motion() || can_be_entered(problem, samples(), timing_));
}

std::vector<Sample>& PatternSolver::samples() {
  if (!is_sampled_) sample(path_, prepared_.problem().footprint().radius(), proof_.certificate.tolerance, sample_step, samples_);
  is_sampled_ = true;
  return samples_;
}

Path path_of(const SideFound& side) { return pattern_path(splines_of(side.pattern)); }

}  // namespace waywright
