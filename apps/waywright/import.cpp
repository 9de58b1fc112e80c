#include "waywright/judge/import.hpp"

#include <fmt/format.h>

#include "lane_words.hpp"
#include "outputs.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/planner/moving_ends.hpp"
#include "waywright/planner/solve_words.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/words.hpp"

namespace waywright::app {

int import(const ImportArguments& arguments) {
  auto loaded = load(arguments.scenario, [&](const Scenario& scenario) {
    return refuse_legs(scenario, arguments.scenario, "poses from outside do not tell where a leg ends and which load is carried");
  });
  if (!loaded) return complain(loaded.error());
  const Problem& problem = loaded->problem;
  std::vector<std::string> of_poses;
  std::vector<PoseSpeed> speeds;
  auto path = read_poses_csv(arguments.path, &of_poses, &speeds);
  if (!path) return complain(path.error());
  const std::filesystem::path folder =
      arguments.out.value_or(default_folder(problem.scenario().name + "-import"));
  if (auto ready = prepare_folder(folder); !ready) return complain(ready.error());
  Plan plan = judge_imported(problem, std::move(*path), std::move(speeds));
  if (plan.status == Status::unproven) {
    if (const auto ends = moving_at_ends(problem)) {
      plan.status = ends->status;
      plan.reason = ends->reason;
    }
  }
  explain_driven(problem, plan, plan.explanation);
  if (plan.status == Status::solved) plan.explanation.push_back(proof_sentence(problem, plan));
  tell_of_lanes(plan);
  plan.timing.load = loaded->load;
  plan.timing.prepare = loaded->prepare;
  note_all(of_poses, {});
  note_all(plan.scenario.map.notes, warnings(plan));
  if (auto written = write_plan(folder, problem, plan); !written) return complain(written.error());
  const bool printed =
      print(plan_text(plan) +
            fmt::format("written: {0}/plan.json, {0}/plan.svg, {0}/report.html\n", folder.string()));
  return plan.status == Status::solved && printed ? solved : not_solved;
}

}  // namespace waywright::app
