// What a planner is: an immutable problem in, a path or a failure with its cause out.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/core/result.hpp"
#include "waywright/judge/pace.hpp"
#include "waywright/judge/plan.hpp"
#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// What a planner made, before anyone judged it.
struct Planned {
  Path path;
  std::vector<std::string> explanation;   ///< why this one, against which alternatives
  std::vector<Alternative> alternatives;  ///< what was tried
  std::optional<Optimality> optimality{};
  std::optional<SearchPicture> search{};
  std::shared_ptr<const FieldDrawing> field{};  ///< that the path leads down
  bool begins_in_motion = false;          ///< the path begins at problem.first_pose(), though the vehicle moves there
  std::optional<Pace> pace{};             ///< times that were planned with the way, among what moves
  std::string shortcoming{};              ///< what belongs to the reason where the path turns out not to be proven
};

/// A failure keeps what was tried, so that the report can show it.
struct PlanningFailure {
  Failure failure;
  std::vector<std::string> explanation;
  std::vector<Alternative> alternatives;
  std::optional<SearchPicture> search{};
  std::shared_ptr<const FieldDrawing> field{};
};

using PlanningResult = tl::expected<Planned, PlanningFailure>;

/// Same problem, seed and parameters: the same bits. `plan` is const and may run on many threads at once.
template <class P>
concept Planner = requires(const P planner, const Problem& problem, Budget& budget) {
  { planner.plan(problem, budget) } -> std::same_as<PlanningResult>;
  { planner.name() } -> std::convertible_to<std::string_view>;
};

/// A planner that can make what it needs to know of a problem beforehand, once for many plans: the same answers, sooner.
template <class P>
concept PreparingPlanner = Planner<P> && requires(const P planner, const Problem& problem) {
  { planner.prepared(problem) } -> std::same_as<P>;
};

/// Any planner behind one value type.
class AnyPlanner {
 public:
  template <Planner P>
  AnyPlanner(P planner) : self_{std::make_shared<Model<P>>(std::move(planner))} {}  // NOLINT: implicit on purpose

  PlanningResult plan(const Problem& problem, Budget& budget) const { return self_->plan(problem, budget); }
  std::string_view name() const { return self_->name(); }
  /// This planner, ready for a problem that outlives it; itself where there is nothing to prepare.
  AnyPlanner prepared(const Problem& problem) const {
    auto ready = self_->prepared(problem);
    return ready ? AnyPlanner{std::move(ready)} : *this;
  }

 private:
  struct Concept {
    virtual ~Concept() = default;
    virtual PlanningResult plan(const Problem&, Budget&) const = 0;
    virtual std::string_view name() const = 0;
    virtual std::shared_ptr<const Concept> prepared(const Problem&) const = 0;  ///< nullptr: nothing to prepare
  };
  template <Planner P>
  struct Model final : Concept {
    explicit Model(P p) : planner{std::move(p)} {}
    PlanningResult plan(const Problem& problem, Budget& budget) const override { return planner.plan(problem, budget); }
    std::string_view name() const override { return planner.name(); }
    std::shared_ptr<const Concept> prepared(const Problem& problem) const override {
      if constexpr (PreparingPlanner<P>) {
        return std::make_shared<Model>(planner.prepared(problem));
      } else {
        return nullptr;
      }
    }
    P planner;
  };
  explicit AnyPlanner(std::shared_ptr<const Concept> self) : self_{std::move(self)} {}
  std::shared_ptr<const Concept> self_;
};

/// One parameter of a planner: the JSON, `waywright list planners` and the checks are made from this.
struct ParameterDescription {
  std::string name;
  ParameterValue default_value;
  std::string summary;                    ///< one line
  std::string unit = {};                  ///< "m", "rad", "" …
  double low = 0.0, high = 0.0;           ///< range of a number, both ends allowed
  bool whole = false;                     ///< a whole number
  std::vector<double> values = {};        ///< of a number, where only these are allowed
  std::vector<std::string> choices = {};  ///< of a word; empty for numbers and flags
};

struct PlannerDescription {
  std::string name;
  std::string summary;
  std::vector<ParameterDescription> parameters;
  /// Parameters are complete and checked against the description.
  std::function<AnyPlanner(const Parameters&, std::uint64_t seed)> make;
  /// Does it, with these parameters, keep a budget of samples? Empty: no. All keep one of evaluations.
  std::function<bool(const Parameters&)> counts_samples = {};
  bool goes_on_in_motion = false;  ///< it can begin where the vehicle moves; others begin where it has stopped
  bool passes_waypoints = false;   ///< of a mission; others are refused such a mission
  bool takes_free_goals = false;   ///< goals that leave the heading free; likewise
  bool counts_expansions = false;  ///< it keeps a budget of them
  bool plans_in_time = false;      ///< among what moves: its plans have times of their own
  bool turns_on_the_spot = false;  ///< always: vehicles that cannot are refused
  /// Does it, with these parameters, weigh preferred and penalty zones, and keep to directed ones by itself? Empty: no. (Forbidden ones are obstacles to all, and every path is judged.)
  std::function<bool(const Parameters&)> heeds_zones = {};
};

}  // namespace waywright
