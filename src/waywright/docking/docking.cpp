#include "waywright/docking/docking.hpp"

#include <exception>

#include "waywright/docking/check_fields.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

InputError out_of_memory() { return {"", "", "there is not enough memory for this station", ""}; }

}  // namespace

struct Docking::State {
  explicit State(Problem ready, const PatternDockingOptions& wanted)
      : problem{std::move(ready)},
        options{wanted},
        planner{PatternDockingPlanner{wanted, std::make_shared<LatticeSearch>(), 1}.prepared(problem)} {}
  Problem problem;
  PatternDockingOptions options;
  PatternDockingPlanner planner;
};

Docking::Docking(std::unique_ptr<const State> state) : state_{std::move(state)} {}
Docking::Docking(Docking&&) noexcept = default;
Docking& Docking::operator=(Docking&&) noexcept = default;
Docking::~Docking() = default;

const Problem& Docking::problem() const { return state_->problem; }

Parsed<Docking> Docking::prepare(Scenario scenario, const PatternDockingOptions& options) noexcept {
  try {
    if (auto error = check_fields(scenario)) return tl::unexpected{std::move(*error)};
    auto problem = Problem::prepare(std::move(scenario));
    if (!problem) return tl::unexpected{problem.error()};
    return Docking{std::make_unique<const State>(std::move(*problem), options)};
  } catch (const std::exception&) {  // memory: nothing else is thrown on data
    return tl::unexpected{out_of_memory()};
  }
}

Parsed<Docking> Docking::from(const Pose& start) const noexcept {
  try {
    Scenario scenario = state_->problem.scenario();
    scenario.start = start;
    return prepare(std::move(scenario), state_->options);
  } catch (const std::exception&) {
    return tl::unexpected{out_of_memory()};
  }
}

DockingPlan Docking::plan(const BudgetLimits& limits, const std::atomic<bool>* cancel) const noexcept {
  DockingPlan plan;
  try {
    const Problem& problem = state_->problem;
    if (auto failure = problem.check_ends()) {
      plan.status = failure->status;
      plan.reason = std::move(failure->reason);
      return plan;
    }
    Budget budget{limits, cancel};
    PlanningResult found = state_->planner.plan(problem, budget);
    plan.evaluations = budget.evaluations();
    plan.reproducible = !budget.cut_short() && !budget.canceled();
    if (!found) {
      plan.status = found.error().failure.status;
      plan.reason = std::move(found.error().failure.reason);
      return plan;
    }
    for (const Alternative& a : found->alternatives) {
      if (a.chosen && a.cost) plan.cost = *a.cost;
    }
    plan.path = problem.whole_path(std::move(found->path));
    Proof proof = prove(problem, plan.path);
    plan.certificate = std::move(proof.certificate);
    plan.status = proof.holds() ? Status::solved : Status::unproven;
    if (!proof.violations.empty()) plan.reason = std::move(proof.violations.front().sentence);
    plan.samples = sample(plan.path, problem.footprint().radius(), plan.certificate.tolerance);
    plan.travel_time = assign_speed(plan.samples, problem.vehicle());
    plan.length = length(plan.path);
  } catch (const std::exception&) {
    plan = DockingPlan{};
    plan.reason = "there is not enough memory for this plan";
  }
  return plan;
}

}  // namespace waywright
