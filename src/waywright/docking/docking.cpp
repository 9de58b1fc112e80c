#include "waywright/docking/docking.hpp"

#include <exception>

#include "waywright/docking/check_fields.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/pattern_words.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

constexpr const char* out_of_memory_words = "there is not enough memory for this plan";

InputError out_of_memory() { return {"", "", "there is not enough memory for this station", ""}; }

}  // namespace

struct Docking::State {
  State(Problem ready, const PatternDockingOptions& wanted) : problem{std::move(ready)}, options{wanted}, prepared{problem} {}
  Problem problem;
  PatternDockingOptions options;
  LatticeSearch optimizer;
  PreparedDocking prepared;
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

Parsed<Docking> Docking::from(const Pose& start, const StartMotion& motion, const std::optional<Shelf>& shelf) const noexcept {
  try {
    Scenario scenario = state_->problem.scenario();
    scenario.start = start;
    scenario.start_motion = motion;
    if (auto* station = std::get_if<Station>(&scenario.mission); station != nullptr && shelf) station->shelf = *shelf;
    return prepare(std::move(scenario), state_->options);
  } catch (const std::exception&) {
    return tl::unexpected{out_of_memory()};
  }
}

struct DockingSession::State {
  explicit State(const Docking::State& docking)
      : problem{docking.problem}, prepared{docking.prepared}, solver{docking.prepared, docking.options, docking.optimizer, 1} {
    solver.reserve(usual_samples);
    timing.reserve(usual_samples);
    plan.samples.reserve(usual_samples);
  }

  /// `old` null: nothing to carry on.
  void work(const DockingPlan* old, double driven, const BudgetLimits& limits, const std::atomic<bool>* cancel) {
    // `old` may be the last plan made here.
    const bool is_old_solved = old != nullptr && old->status == Status::solved;
    const Path driven_path = is_old_solved ? old->path : Path{};
    start_over();
    budget.emplace(limits, cancel);
    ran_out_of_memory = false;
    ends = problem.check_ends();
    if (ends) {
      plan.status = ends->status;
    } else if (const auto rest = is_old_solved ? solver.carry_on(driven_path, driven, *budget) : std::nullopt) {
      take(0.0);
      plan.in_motion = problem.motion().has_value();
      plan.is_carried_on = true;
      plan.moved = rest->farthest;
    } else if (const SideFound* found = solver.solve(false, *budget)) {
      take(found->cost);
      plan.in_motion = solver.in_motion();
    } else {
      plan.status = budget->canceled() ? Status::canceled : budget->cut_short() ? Status::timed_out : Status::no_path;
    }
    plan.evaluations = budget->evaluations();
    plan.reproducible = !budget->cut_short() && !budget->canceled();
  }

  void start_over() {
    std::vector<Sample> samples = std::move(plan.samples);
    plan = {};
    plan.samples = std::move(samples);
    plan.samples.clear();
  }

  void take(double cost) {
    plan.status = Status::solved;
    plan.cost = cost;
    plan.path = solver.path();
    plan.certificate = solver.proof().certificate;
    std::swap(plan.samples, solver.samples());
    plan.travel_time = assign_speed(plan.samples, problem.vehicle(), problem.motion() ? problem.motion()->speed : 0.0, timing, zone_limits(problem, plan.samples, plan.certificate.tolerance));
    plan.length = length(plan.path);
  }

  std::string reason() const {
    if (ran_out_of_memory) return out_of_memory_words;
    if (plan.status == Status::solved || !budget) return {};
    if (ends) return ends->reason;
    return failure_of(problem, prepared.task(), solver, outcomes_of(prepared, solver, *budget), *budget).failure.reason;
  }

  const Problem& problem;
  const PreparedDocking& prepared;
  PatternSolver solver;
  SpeedWorkspace timing;
  DockingPlan plan;
  std::optional<Budget> budget;
  std::optional<Failure> ends;  ///< what is wrong with them
  bool ran_out_of_memory = false;
};

DockingSession::DockingSession(std::unique_ptr<State> state) : state_{std::move(state)} {}
DockingSession::DockingSession(DockingSession&&) noexcept = default;
DockingSession& DockingSession::operator=(DockingSession&&) noexcept = default;
DockingSession::~DockingSession() = default;

Parsed<DockingSession> DockingSession::on(const Docking& docking) noexcept {
  try {
    return DockingSession{std::make_unique<State>(*docking.state_)};
  } catch (const std::exception&) {
    return tl::unexpected{out_of_memory()};
  }
}

const DockingPlan& DockingSession::plan(const BudgetLimits& limits, const std::atomic<bool>* cancel) noexcept {
  return work(nullptr, 0.0, limits, cancel);
}

const DockingPlan& DockingSession::replan(const DockingPlan& old, double driven, const BudgetLimits& limits, const std::atomic<bool>* cancel) noexcept {
  return work(&old, driven, limits, cancel);
}

const DockingPlan& DockingSession::work(const DockingPlan* old, double driven, const BudgetLimits& limits, const std::atomic<bool>* cancel) noexcept {
  try {
    state_->work(old, driven, limits, cancel);
  } catch (const std::exception&) {  // a path beyond the room that was made, and no memory for it
    state_->start_over();
    state_->ran_out_of_memory = true;
  }
  return state_->plan;
}

std::string DockingSession::reason() const noexcept {
  try {
    return state_->reason();
  } catch (const std::exception&) {
    return {};
  }
}

namespace {

DockingPlan planned_once(const Docking& docking, const auto& plan) {
  auto session = DockingSession::on(docking);
  if (!session) {
    DockingPlan failed;
    failed.reason = out_of_memory_words;
    return failed;
  }
  DockingPlan made = plan(*session);
  if (made.status != Status::solved) made.reason = session->reason();
  return made;
}

}  // namespace

DockingPlan Docking::plan(const BudgetLimits& limits, const std::atomic<bool>* cancel) const noexcept {
  try {
    return planned_once(*this, [&](DockingSession& session) { return session.plan(limits, cancel); });
  } catch (const std::exception&) {
    return {};
  }
}

DockingPlan Docking::replan(const DockingPlan& old, double driven, const BudgetLimits& limits, const std::atomic<bool>* cancel) const noexcept {
  try {
    return planned_once(*this, [&](DockingSession& session) { return session.replan(old, driven, limits, cancel); });
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace waywright
