#include "waywright/study/compare.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "outputs.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/io/files.hpp"
#include "waywright/report/charts.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/report/words.hpp"
#include "waywright/study/merits.hpp"
#include "waywright/study/short_names.hpp"
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
  return std::any_of(planner.parameters.begin(), planner.parameters.end(),
                     [&](const ParameterDescription& p) { return p.name == name; });
}

/// Parts between commas; "\\," stands for a comma inside a part.
std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == ',')
      parts.back() += text[++i];
    else if (text[i] == ',')
      parts.emplace_back();
    else
      parts.back() += text[i];
  }
  std::erase(parts, "");
  return parts;
}

std::vector<std::string> known_planners() {
  std::vector<std::string> names;
  for (const PlannerDescription& p : planners()) names.push_back(p.name);
  names.emplace_back("exec:COMMAND");
  return names;
}

/// NAME, NAME:key=value:… or exec:COMMAND.
Parsed<Contestant> contestant_from(const std::string& entry) {
  if (entry.rfind("exec:", 0) == 0) {
    if (entry.size() == 5)
      return tl::unexpected{InputError{"", "--planners", "exec: names no command", "exec:COMMAND"}};
    return Contestant{entry, "", {}, entry.substr(5)};
  }
  const auto parts = split(entry, ':');
  const PlannerDescription* planner = parts.empty() ? nullptr : find_planner(parts[0]);
  if (planner == nullptr) {
    const std::vector<std::string> known = known_planners();
    return tl::unexpected{InputError{"", "--planners", fmt::format("\"{}\" is not known{}", entry, meant_instead(parts.empty() ? entry : parts[0], known)), list_of_words(known)}};
  }
  Contestant contestant{entry, planner->name, {}, {}};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (auto set = set_parameter(*planner, contestant.parameters, parts[i]); !set)
      return tl::unexpected{set.error()};
    contestant.settings.push_back(parts[i]);
  }
  return contestant;
}

/// Who can take each of the missions, where none is named.
std::vector<Contestant> able_contestants(const std::vector<Problem>& problems) {
  std::vector<Contestant> contestants;
  for (const PlannerDescription& planner : planners()) {
    const bool is_able = std::all_of(problems.begin(), problems.end(), [&](const Problem& p) { return check_mission(planner.name, p.scenario()).has_value(); });
    if (is_able) contestants.push_back({planner.name, planner.name, {}, {}});
  }
  return contestants;
}

Parsed<std::vector<Contestant>> named_contestants(const std::string& list, const std::vector<Problem>& problems) {
  std::vector<Contestant> contestants;
  if (list.empty()) {
    contestants = able_contestants(problems);
    if (contestants.empty()) return tl::unexpected{InputError{"", "--planners", "no planner can take all of these missions", "scenarios of one kind"}};
    return contestants;
  }
  for (const std::string& entry : split_list(list)) {
    auto contestant = contestant_from(entry);
    if (!contestant) return tl::unexpected{contestant.error()};
    const bool twice = std::any_of(contestants.begin(), contestants.end(),
                                   [&](const Contestant& c) { return c.label == entry; });
    if (twice)
      return tl::unexpected{InputError{"", "--planners", fmt::format("\"{}\" is named twice", entry),
                                       "each once; --runs repeats them"}};
    contestants.push_back(std::move(*contestant));
  }
  if (contestants.empty())
    return tl::unexpected{InputError{"", "--planners", "no planner is named", list_of_words(known_planners())}};
  return contestants;
}

/// Of all planners that are compared.
std::vector<std::string> parameters_of(const std::vector<Contestant>& contestants) {
  std::vector<std::string> names;
  for (const Contestant& contestant : contestants) {
    if (contestant.planner.empty()) continue;
    for (const ParameterDescription& p : find_planner(contestant.planner)->parameters) names.push_back(p.name);
  }
  return names;
}

/// KEY=A,B makes one contestant of each value, of every planner that has the parameter.
Parsed<std::vector<Contestant>> with_settings(std::vector<Contestant> contestants,
                                              const std::vector<std::string>& settings) {
  if (auto once = check_each_key_once(settings); !once) return tl::unexpected{once.error()};
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      return tl::unexpected{
          InputError{"", "--set", fmt::format("\"{}\" is not KEY=VALUE", setting), "KEY=VALUE or KEY=A,B"}};
    }
    const std::string key = setting.substr(0, equals);
    const auto values = split(setting.substr(equals + 1), ',');
    if (values.empty())
      return tl::unexpected{InputError{"", "--set " + key, "it names no value", "KEY=VALUE or KEY=A,B"}};
    for (auto value = values.begin(); value != values.end(); ++value) {
      if (std::find(values.begin(), value, *value) != value)
        return tl::unexpected{InputError{"", "--set " + key, fmt::format("\"{}\" is named twice", *value), "each value once; --runs repeats them"}};
    }
    std::vector<Contestant> more;
    bool used = false;
    for (const Contestant& contestant : contestants) {
      const PlannerDescription* planner =
          contestant.planner.empty() ? nullptr : find_planner(contestant.planner);
      if (planner == nullptr || !has_parameter(*planner, key)) {
        more.push_back(contestant);
        continue;
      }
      used = true;
      for (const std::string& value : values) {
        Contestant one = contestant;
        if (auto set = set_parameter(*planner, one.parameters, key + "=" + value); !set)
          return tl::unexpected{set.error()};
        one.settings.push_back(key + "=" + value);
        one.label += ":" + one.settings.back();
        more.push_back(std::move(one));
      }
    }
    if (!used)
      return tl::unexpected{InputError{"", "--set " + key, "no planner compared has this parameter" + meant_instead(key, parameters_of(contestants)), "see: waywright list PLANNER"}};
    contestants = std::move(more);
  }
  return contestants;
}

void show_progress(std::size_t done, std::size_t total) {
  if (::isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r%zu of %zu runs%s", done, total, done == total ? "\n" : "");
  std::fflush(stderr);
}

constexpr std::int64_t default_evaluations = 2000;

bool names_budget(const Problem& problem) {
  const BudgetLimits& limits = problem.scenario().budget;
  return limits.evaluations || limits.samples || limits.seconds;
}

/// One budget for all: what was asked for, or the scenario's own, or the default. Who names `evaluations` for
/// a contestant wants another one for it, and gets no default. Returns what to say of it.
Parsed<std::string> set_budget(const CompareArguments& arguments, const std::vector<Problem>& problems,
                               const std::vector<Contestant>& contestants, CompareOptions& options) {
  const bool own = std::any_of(contestants.begin(), contestants.end(),
                               [](const Contestant& c) { return c.parameters.contains("evaluations"); });
  const bool in_scenario = std::any_of(problems.begin(), problems.end(), [](const Problem& p) {
    return p.scenario().budget.evaluations.has_value();
  });
  if (own && (arguments.evaluations || in_scenario)) {
    return tl::unexpected{InputError{
        "", arguments.evaluations ? "--evaluations" : "budget.evaluations of a scenario",
        "a contestant has a number of evaluations of its own, which this budget would take the place of",
        "one of the two"}};
  }
  options.budget.evaluations = arguments.evaluations;
  if (arguments.evaluations)
    return fmt::format(
        "budget: at most {} evaluations a run, the same for all; who is done earlier stops earlier\n",
        *arguments.evaluations);
  if (own) return std::string{"budget: the numbers of evaluations that the contestants name\n"};
  options.default_evaluations = default_evaluations;
  if (std::any_of(problems.begin(), problems.end(), names_budget)) {
    return fmt::format(
        "budget: the scenario's, the same for all; at most {} evaluations a run where it names none\n",
        default_evaluations);
  }
  return fmt::format(
      "budget: at most {} evaluations a run, the same for all; who is done earlier stops earlier\n",
      default_evaluations);
}

/// Of each contestant its shortest proven path, or else any path; the name says which of its runs that is.
std::vector<std::pair<std::string, const Plan*>> best_plans(const std::vector<Run>& runs, std::size_t scenario, const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, const Plan*>> best;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const Plan* chosen = nullptr;
    std::size_t all = 0;
    const auto rank = [](const Plan& p) {
      return std::pair{p.status == Status::solved ? 0 : p.samples.empty() ? 2 : 1, p.metrics.length};
    };
    for (const Run& run : runs) {
      if (run.scenario != scenario || run.contestant != c) continue;
      ++all;
      if (chosen == nullptr || rank(run.plan) < rank(*chosen)) chosen = &run.plan;
    }
    if (chosen == nullptr) continue;
    best.emplace_back(
        names[c] +
            (all > 1 ? fmt::format(", seed {}, the shortest of {} runs", chosen->seed, all) : ""),
        chosen);
  }
  return best;
}

}  // namespace

int compare(const CompareArguments& arguments) {
  if (!arguments.suite.empty()) return complain({"", "--suite", "it is not supported yet", "scenario files"});
  if (arguments.scenarios.empty())
    return complain({"", "command line", "SCENARIO is required", "one or more scenario files"});
  std::vector<Problem> problems;
  std::vector<std::string> names;
  for (const auto& file : arguments.scenarios) {
    auto loaded = load(file, [&](const Scenario& scenario) { return refuse_legs(scenario, file, "planners are compared on one mission, and legs may each want another"); });
    if (!loaded) return complain(loaded.error());
    note_all(loaded->problem.scenario().map.notes, {});
    if (auto warning = alignment_warning(loaded->problem.scenario())) note_all({}, {*warning});
    names.push_back(loaded->problem.scenario().name.empty() ? file.stem().string()
                                                            : loaded->problem.scenario().name);
    problems.push_back(std::move(loaded->problem));
  }
  auto contestants = named_contestants(arguments.planners, problems);
  if (contestants) contestants = with_settings(std::move(*contestants), arguments.set);
  if (!contestants) return complain(contestants.error());
  for (const Contestant& contestant : *contestants) {
    for (std::size_t p = 0; p < problems.size(); ++p) {
      if (contestant.planner.empty()) continue;
      if (auto takes = check_mission(contestant.planner, problems[p].scenario()); !takes) {
        takes.error().file = arguments.scenarios[p].string();
        return complain(takes.error());
      }
    }
  }
  CompareOptions options;
  const auto budget = set_budget(arguments, problems, *contestants, options);
  if (!budget) return complain(budget.error());
  if (auto ready = prepare_folder(arguments.out); !ready) return complain(ready.error());

  options.runs = arguments.runs;
  options.threads = arguments.threads;
  options.progress = show_progress;
  const std::vector<Run> runs = [&] {
    const Interruptible interruptible;
    options.cancel = interruptible.flag();
    return waywright::compare(problems, *contestants, options);
  }();

  const auto summaries = summarise(runs, problems.size(), contestants->size());
  std::string text = *budget + summary_text(summaries, names, *contestants);
  const ShortNames shown = short_names(*contestants);
  const std::vector<Merits> merits = merits_of(runs, problems.size(), contestants->size());
  for (std::size_t p = 0; p < problems.size(); ++p) {
    if (const std::string table = merits_text(merits, p, shown.names); !table.empty()) text += "\n" + (problems.size() == 1 ? "" : names[p] + "\n") + table;
  }
  std::vector<NamedContent> files{{arguments.out / "compare.csv", runs_csv(runs, names, *contestants)}};
  text += fmt::format("\nwritten: {0}/compare.csv", arguments.out.string());
  for (std::size_t p = 0; p < problems.size(); ++p) {
    const std::string name = problems.size() == 1 ? "compare.svg" : fmt::format("compare-{}.svg", p + 1);
    const auto best = best_plans(runs, p, shown.names);
    files.push_back({arguments.out / name, overlay_svg(problems[p], best, shown.shared, 860.0)});
    const std::string chart = problems.size() == 1 ? "clearance.svg" : fmt::format("clearance-{}.svg", p + 1);
    files.push_back({arguments.out / chart, clearances_svg(problems[p], best, 860.0)});
    text += fmt::format(", {0}/{1}, {0}/{2}", arguments.out.string(), name, chart);
    if (std::string bars = merits_svg(merits, p, shown.names, names[p]); !bars.empty()) {
      const std::string merit = problems.size() == 1 ? "merits.svg" : fmt::format("merits-{}.svg", p + 1);
      files.push_back({arguments.out / merit, std::move(bars)});
      text += fmt::format(", {}/{}", arguments.out.string(), merit);
    }
  }
  if (auto written = write_files(files); !written) return complain(written.error());
  const std::size_t wanted = problems.size() * contestants->size() * static_cast<std::size_t>(arguments.runs);
  if (runs.size() < wanted)
    text +=
        fmt::format("\ninterrupted: {} of {} runs are in the tables, as many of each contestant as were done",
                    runs.size(), wanted);
  return print(text + "\n") && runs.size() == wanted ? solved : not_solved;
}

}  // namespace waywright::app
