#include "waywright/study/pareto.hpp"

#include <fmt/format.h>

#include "outputs.hpp"
#include "waywright/io/files.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/study/front_folder.hpp"

namespace waywright::app {

int pareto(const ParetoArguments& arguments) {
  auto loaded = load(arguments.plan.scenario, [&](Scenario& scenario) -> Parsed<void> {
    if (auto one = refuse_legs(scenario, arguments.plan.scenario, "trade-offs are those of one mission"); !one) return one;
    if (auto can = check_pareto(scenario); !can) {
      can.error().file = arguments.plan.scenario.string();
      return can;
    }
    return apply(arguments.plan, scenario);
  });
  if (!loaded) return complain(loaded.error());
  const Problem& problem = loaded->problem;
  const Scenario& scenario = problem.scenario();
  note_all(scenario.map.notes, {});
  const std::filesystem::path folder = arguments.plan.out.value_or(default_folder((scenario.name.empty() ? arguments.plan.scenario.stem().string() : scenario.name) + "-pareto"));
  if (auto ready = prepare_folder(folder); !ready) return complain(ready.error());
  auto failure = problem.check_ends();
  if (!failure) failure = problem.check_stop();
  if (failure) {
    print(fmt::format("{}: {}\n", to_string(failure->status), failure->reason));
    return not_solved;
  }
  ParetoOptions options;
  options.points = static_cast<std::size_t>(arguments.points);
  auto front = [&] {
    const Interruptible interruptible;
    options.cancel = interruptible.flag();
    return waywright::pareto(problem, options);
  }();
  if (!front) {
    InputError error = front.error();
    error.file = arguments.plan.scenario.string();
    return complain(error);
  }
  std::vector<std::pair<std::string, const Plan*>> named;
  for (std::size_t i = 0; i < front->plans.size(); ++i) {
    const Plan& plan = front->plans[i];
    named.emplace_back(fmt::format("{}: {:.2f} m, clearance {:.3f} m, curvature {:.3f} 1/m", i + 1, plan.metrics.length, plan.certificate.clearance, plan.metrics.max_curvature), &plan);
    const auto place = folder / front_plan_folder(i);
    if (auto ready = prepare_folder(place); !ready) return complain(ready.error());
    if (auto written = write_plan(place, problem, plan); !written) return complain(written.error());
  }
  // While the earlier front.csv still tells which they are.
  if (auto removed = remove_earlier_plans(folder, front->plans.size()); !removed) return complain(removed.error());
  const std::vector<NamedContent> files{{folder / "front.csv", front_csv(*front)}, {folder / "front.svg", front_svg(*front, 760.0)}, {folder / "paths.svg", overlay_svg(problem, named, "", 860.0)}};
  if (auto written = write_files(files); !written) return complain(written.error());
  const std::size_t count = front->plans.size();
  const std::string plans = count == 0 ? "" : count == 1 ? ", 01: plan.json, plan.svg, report.html" : fmt::format(", 01 … {}: plan.json, plan.svg, report.html each", front_plan_folder(count - 1));
  const bool printed = print(fmt::format("{} proven {} of {} {} ({} on the search's front, {} of those looked at refused by the proof{})\n{}written: {}/front.csv, front.svg, paths.svg{}\n", count,
                                         count == 1 ? "trade-off" : "trade-offs", front->evaluations, front->evaluations == 1 ? "candidate" : "candidates", front->found, front->refused,
                                         front->is_cut_short ? "; cut short" : "", front_text(*front), folder.string(), plans));
  return !front->plans.empty() && !front->is_cut_short && printed ? solved : not_solved;
}

}  // namespace waywright::app
