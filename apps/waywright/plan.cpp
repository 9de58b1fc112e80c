#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "lane_words.hpp"
#include "outputs.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/solve_legs.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/words.hpp"

namespace waywright::app {

Parsed<void> check_no_budget_over(const std::string& setting, const BudgetLimits& budget) {
  if (setting.rfind("evaluations=", 0) != 0 || !budget.evaluations) return {};
  return tl::unexpected{InputError{"", "--set evaluations", fmt::format("the scenario's budget.evaluations, {}, would take its place", *budget.evaluations),
                                   "no --set evaluations, or a scenario without budget.evaluations"}};
}

Parsed<void> check_each_key_once(const std::vector<std::string>& settings) {
  std::set<std::string> keys;
  for (const std::string& setting : settings) {
    const std::string key = setting.substr(0, setting.find('='));
    if (!keys.insert(key).second) return tl::unexpected{InputError{"", "--set " + key, "it is given twice", "each KEY once"}};
  }
  return {};
}

Parsed<void> check_somebody_asks(const std::string& planner, const std::vector<std::string>& settings, const Scenario& scenario) {
  const bool asked = scenario.legs.empty() || std::any_of(scenario.legs.begin(), scenario.legs.end(), [](const Leg& leg) { return !leg.planner; });
  if (asked || (planner.empty() && settings.empty())) return {};
  return tl::unexpected{InputError{"", planner.empty() ? "--set" : "--planner", "every leg names a planner of its own", "legs without a planner"}};
}

Parsed<void> apply(const PlanArguments& arguments, Scenario& scenario) {
  if (auto once = check_each_key_once(arguments.set); !once) return once;
  if (auto asked = check_somebody_asks(arguments.planner, arguments.set, scenario); !asked) return asked;
  if (!arguments.planner.empty() && arguments.planner != scenario.planner.name) {
    scenario.planner = {arguments.planner, {}};  // another planner has other parameters
  }
  if (arguments.seed) {
    if (*arguments.seed > static_cast<std::uint64_t>(INT64_MAX)) {
      return tl::unexpected{
          InputError{"", "--seed", "the number is out of range", "0 to 9223372036854775807"}};
    }
    scenario.seed = *arguments.seed;
  }
  if (const PlannerDescription* planner = find_planner(scenario.planner.name)) {
    for (const std::string& key_value : arguments.set) {
      if (auto free = check_no_budget_over(key_value, scenario.budget); !free) {
        free.error().file = arguments.scenario.string();
        return free;
      }
      if (auto set = set_parameter(*planner, scenario.planner.parameters, key_value); !set) return set;
    }
  }
  if (!scenario.legs.empty()) {
    auto complete = complete_legs(scenario);
    if (!complete) complete.error().file = arguments.scenario.string();
    return complete;
  }
  auto complete = complete_parameters(scenario.planner);
  if (complete) {
    if (auto takes = check_mission(scenario.planner.name, scenario); !takes) {
      takes.error().file = arguments.scenario.string();
      return takes;
    }
    auto kept = check_budget(scenario.planner.name, *complete, scenario.budget);
    if (!kept) kept.error().file = arguments.scenario.string();
    return kept;
  }
  if (arguments.planner.empty()) complete.error().file = arguments.scenario.string();
  return tl::unexpected{complete.error()};
}

namespace {

/// What is planned: one problem, or a mission in legs, which are problems one after another.
struct Planning {
  std::optional<Loaded> one;
  LoadedScenario legs;
  const Scenario& scenario() const { return one ? one->problem.scenario() : legs.scenario; }
  double load() const { return one ? one->load : legs.load; }
  Parsed<Plan> solve(const std::atomic<bool>* cancel) const { return one ? waywright::solve(one->problem, cancel) : solve_legs(legs.scenario, cancel); }
  Parsed<void> write(const std::filesystem::path& folder, const Plan& plan) const { return one ? write_plan(folder, one->problem, plan) : write_plan(folder, plan); }
};

Parsed<Planning> ready(const PlanArguments& arguments) {
  auto read = load_scenario(arguments.scenario, [&](Scenario& scenario) { return apply(arguments, scenario); }, arguments.planner);
  if (!read) return tl::unexpected{read.error()};
  if (!read->scenario.legs.empty()) return Planning{std::nullopt, std::move(*read)};
  auto loaded = prepare(std::move(*read), arguments.scenario);
  if (!loaded) return tl::unexpected{loaded.error()};
  return Planning{std::move(*loaded), {}};
}

}  // namespace

int plan(const PlanArguments& arguments) {
  const auto planning = ready(arguments);
  if (!planning) return complain(planning.error());
  const std::string& name = planning->scenario().name;
  const std::filesystem::path folder = arguments.out.value_or(default_folder(name.empty() ? arguments.scenario.stem().string() : name));
  const bool write = !arguments.json || arguments.out;
  std::error_code unknown;
  const bool was_there = std::filesystem::exists(folder, unknown) || unknown;
  if (write) {
    if (auto made = prepare_folder(folder); !made) return complain(made.error());
  }
  auto plan = [&] {
    const Interruptible interruptible;
    return planning->solve(interruptible.flag());
  }();
  if (!plan) {
    InputError error = plan.error();
    error.file = arguments.scenario.string();
    if (write && !was_there) std::filesystem::remove(folder, unknown);  // nothing is in it
    return complain(error);
  }
  plan->timing.load = planning->load();
  if (planning->one) plan->timing.prepare += planning->one->prepare;
  tell_of_lanes(*plan);
  note_all(plan->scenario.map.notes, warnings(*plan));
  if (write) {
    if (auto written = planning->write(folder, *plan); !written) return complain(written.error());
  }
  const bool printed =
      arguments.json
          ? print_raw(plan_json(*plan))
          : print(plan_text(*plan) +
                  fmt::format("written: {0}/plan.json, {0}/plan.svg, {0}/report.html{1}\n", folder.string(), plan->search && planning->one ? ", and how the search went: " + (folder / "search.svg").string() : ""));
  return plan->status == Status::solved && printed ? solved : not_solved;
}

int plan_example() {
  PlanArguments arguments;
  arguments.scenario = examples_folder() / "dock_middle.json";
  const int status = plan(arguments);
  if (status == solved) print("Open report.html in a browser; `waywright --help` lists the commands.\n");
  return status;
}

}  // namespace waywright::app
