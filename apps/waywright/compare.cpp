#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "outputs.hpp"
#include "waywright/io/files.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/study/compare.hpp"
#include "waywright/study/summary.hpp"

namespace waywright::app {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (end > begin) parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool has_parameter(const PlannerDescription& planner, const std::string& name) {
  return std::any_of(planner.parameters.begin(), planner.parameters.end(), [&](const ParameterDescription& p) { return p.name == name; });
}

/// NAME, NAME:key=value:…, exec:COMMAND (which takes the rest of the list).
Parsed<std::vector<Contestant>> named_contestants(const std::string& list) {
  std::vector<Contestant> contestants;
  if (list.empty()) {
    for (const PlannerDescription& p : planners()) contestants.push_back({p.name, p.name, {}, {}});
    return contestants;
  }
  std::string planners_part = list;
  std::string command;
  const std::size_t exec = list.rfind("exec:", 0) == 0 ? 0 : list.find(",exec:");
  if (exec != std::string::npos) {
    planners_part = list.substr(0, exec);
    command = list.substr(list.find("exec:") + 5);
    if (command.empty()) return tl::unexpected{InputError{"", "--planners", "exec: names no command", "exec:COMMAND"}};
  }
  for (const std::string& entry : split(planners_part, ',')) {
    const auto parts = split(entry, ':');
    const PlannerDescription* planner = parts.empty() ? nullptr : find_planner(parts[0]);
    if (planner == nullptr) {
      std::string names;
      for (const PlannerDescription& p : planners()) names += p.name + ", ";
      return tl::unexpected{InputError{"", "--planners", fmt::format("\"{}\" is not known", entry), names + "exec:COMMAND"}};
    }
    Contestant contestant{entry, planner->name, {}, {}};
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (auto set = set_parameter(*planner, contestant.parameters, parts[i]); !set) return tl::unexpected{set.error()};
    }
    contestants.push_back(std::move(contestant));
  }
  if (!command.empty()) contestants.push_back({"exec:" + command, "", {}, command});
  return contestants;
}

/// KEY=A,B makes one contestant of each value, of every planner that has the parameter.
Parsed<std::vector<Contestant>> with_settings(std::vector<Contestant> contestants, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      return tl::unexpected{InputError{"", "--set", fmt::format("\"{}\" is not KEY=VALUE", setting), ""}};
    }
    const std::string key = setting.substr(0, equals);
    const auto values = split(setting.substr(equals + 1), ',');
    std::vector<Contestant> more;
    bool used = false;
    for (const Contestant& contestant : contestants) {
      const PlannerDescription* planner = contestant.planner.empty() ? nullptr : find_planner(contestant.planner);
      if (planner == nullptr || !has_parameter(*planner, key)) {
        more.push_back(contestant);
        continue;
      }
      used = true;
      for (const std::string& value : values) {
        Contestant one = contestant;
        if (auto set = set_parameter(*planner, one.parameters, key + "=" + value); !set) return tl::unexpected{set.error()};
        one.label += ":" + key + "=" + value;
        more.push_back(std::move(one));
      }
    }
    if (!used) return tl::unexpected{InputError{"", "--set " + key, "no planner compared has this parameter", "see: waywright list PLANNER"}};
    contestants = std::move(more);
  }
  return contestants;
}

void show_progress(std::size_t done, std::size_t total) {
  if (::isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r%zu of %zu runs%s", done, total, done == total ? "\n" : "");
  std::fflush(stderr);
}

/// Of each contestant its shortest proven path, or else any path.
std::vector<std::pair<std::string, const Plan*>> best_plans(const std::vector<Run>& runs, std::size_t scenario, const std::vector<Contestant>& contestants) {
  std::vector<std::pair<std::string, const Plan*>> best;
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    const Plan* chosen = nullptr;
    const auto rank = [](const Plan& p) { return std::pair{p.status == Status::solved ? 0 : p.samples.empty() ? 2 : 1, p.metrics.length}; };
    for (const Run& run : runs) {
      if (run.scenario == scenario && run.contestant == c && (chosen == nullptr || rank(run.plan) < rank(*chosen))) chosen = &run.plan;
    }
    if (chosen != nullptr) best.emplace_back(contestants[c].label, chosen);
  }
  return best;
}

}  // namespace

int compare(const CompareArguments& arguments) {
  std::vector<Problem> problems;
  std::vector<std::string> names;
  for (const auto& file : arguments.scenarios) {
    auto loaded = load(file);
    if (!loaded) return complain(loaded.error());
    names.push_back(loaded->problem.scenario().name.empty() ? file.stem().string() : loaded->problem.scenario().name);
    problems.push_back(std::move(loaded->problem));
  }
  auto contestants = named_contestants(arguments.planners);
  if (contestants) contestants = with_settings(std::move(*contestants), arguments.set);
  if (!contestants) return complain(contestants.error());
  if (auto ready = prepare_folder(arguments.out); !ready) return complain(ready.error());

  CompareOptions options;
  options.runs = arguments.runs;
  options.threads = arguments.threads;
  options.budget.evaluations = arguments.evaluations;
  options.progress = show_progress;
  const std::vector<Run> runs = [&] {
    const Interruptible interruptible;
    options.cancel = interruptible.flag();
    return waywright::compare(problems, *contestants, options);
  }();

  const auto summaries = summarise(runs, problems.size(), contestants->size());
  std::string text = summary_text(summaries, names, *contestants);
  std::vector<NamedContent> files{{arguments.out / "compare.csv", runs_csv(runs, names, *contestants)}};
  text += fmt::format("\nwritten: {0}/compare.csv", arguments.out.string());
  for (std::size_t p = 0; p < problems.size(); ++p) {
    const std::string name = problems.size() == 1 ? "compare.svg" : fmt::format("compare-{}.svg", p + 1);
    const std::string picture = overlay_svg(problems[p], best_plans(runs, p, *contestants), 860.0);
    files.push_back({arguments.out / name, picture});
    text += fmt::format(", {}/{}", arguments.out.string(), name);
  }
  if (auto written = write_files(files); !written) return complain(written.error());
  const std::size_t wanted = problems.size() * contestants->size() * static_cast<std::size_t>(arguments.runs);
  if (runs.size() < wanted) text += fmt::format("\ninterrupted: {} of {} runs are in the tables", runs.size(), wanted);
  return print(text + "\n") && runs.size() == wanted ? solved : not_solved;
}

}  // namespace waywright::app
