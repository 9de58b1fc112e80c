#include "outputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "waywright/io/files.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/whale_config.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/report/report.hpp"

namespace waywright::app {

namespace fs = std::filesystem;

fs::path default_folder(const std::string& name) {
  std::string safe;
  for (const char c : name)
    safe += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '-';
  if (safe.empty()) safe = "plan";
  return fs::path{"waywright-out"} / safe.substr(0, 80);
}

Parsed<void> prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return tl::unexpected{
        InputError{folder.string(), "", "the folder cannot be made: " + error.message(), ""}};
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    return tl::unexpected{InputError{folder.string(), "", "the folder cannot be written to", ""}};
  }
  return {};
}

Parsed<void> prepare_folder_of(const fs::path& file) {
  std::error_code error;
  const fs::path folder = file.parent_path();
  if (folder.empty() || fs::is_directory(folder, error)) return {};
  auto made = prepare_folder(folder);
  if (made) note(fmt::format("the folder {} was made", folder.string()));
  return made;
}

Parsed<void> write_plan(const fs::path& folder, const Problem& problem, const Plan& plan) {
  std::vector<NamedContent> files{{folder / "plan.json", plan_json(plan)}, {folder / "plan.svg", plan_svg(problem, plan)}, {folder / "report.html", report_html(problem, plan)}};
  if (plan.search) files.push_back({folder / "search.svg", search_picture_svg(problem, plan)});
  auto written = write_files(files);
  if (written && !plan.search) {  // that of another plan would be beside this one
    std::error_code none;
    fs::remove(folder / "search.svg", none);
  }
  return written;
}

Parsed<void> write_plan(const fs::path& folder, const Plan& plan) {
  return write_files({{folder / "plan.json", plan_json(plan)}, {folder / "plan.svg", plan_svg(plan)}, {folder / "report.html", report_html(plan)}});
}

Parsed<void> refuse_legs(const Scenario& scenario, const fs::path& file, const char* why, const char* allowed) {
  if (scenario.legs.empty()) return {};
  return tl::unexpected{InputError{file.string(), "legs", why, allowed}};
}

namespace {

Parsed<Scenario> read_scenario_or_configuration(const fs::path& file, const std::string& planner) {
  auto text = read_file(file, largest_json);
  if (!text) return tl::unexpected{text.error()};
  if (!is_whale_config(*text)) return parse_scenario(*text, file.string(), file.parent_path());
  const auto takes = [](const std::string& name, const std::string& parameter) {
    const PlannerDescription* found = find_planner(name);
    return found == nullptr || std::any_of(found->parameters.begin(), found->parameters.end(), [&](const ParameterDescription& p) { return p.name == parameter; });
  };
  auto configured = parse_whale_config(*text, file.string(), file.parent_path(), planner, takes);
  if (!configured) return tl::unexpected{configured.error()};
  for (const std::string& line : configured->mapping) note(line);
  return std::move(configured->scenario);
}

}  // namespace

Parsed<LoadedScenario> load_scenario(const fs::path& file, const std::function<Parsed<void>(Scenario&)>& change, const std::string& planner) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  auto scenario = read_scenario_or_configuration(file, planner);
  if (!scenario) return tl::unexpected{scenario.error()};
  if (change) {
    if (auto changed = change(*scenario); !changed) return tl::unexpected{changed.error()};
  }
  return LoadedScenario{std::move(*scenario), std::chrono::duration<double>(Clock::now() - begin).count()};
}

Parsed<Loaded> load(const fs::path& file, const std::function<Parsed<void>(Scenario&)>& change) {
  auto read = load_scenario(file, change);
  if (!read) return tl::unexpected{read.error()};
  return prepare(std::move(*read), file);
}

Parsed<Loaded> prepare(LoadedScenario read, const fs::path& file) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  auto problem = Problem::prepare(std::move(read.scenario));
  if (!problem) {
    InputError error = problem.error();
    error.file = file.string();
    return tl::unexpected{error};
  }
  return Loaded{std::move(*problem), read.load, std::chrono::duration<double>(Clock::now() - begin).count()};
}

}  // namespace waywright::app
