#include "waywright/study/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "outputs.hpp"
#include "waywright/core/version.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/site_csv.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/report/words.hpp"
#include "waywright/study/check_table.hpp"

namespace waywright::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t rows_told = 20;  // of what is solved, on the terminal

bool is_table(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(c < 0x80 ? std::tolower(c) : c); });
  return extension == ".csv" || extension == ".tsv" || extension == ".txt";
}

/// A VDA 5050 layout (LIF), by what only it has at its top.
bool is_layout(const fs::path& file) {
  if (file.extension() == ".lif") return true;
  const auto text = read_file(file, largest_json);
  if (!text) return false;
  const auto json = parse_json(*text, file.string());
  return json && json->is_object() && !json->contains("format") && (json->contains("metaInformation") || json->contains("layouts"));
}

InputError wrong(std::string field, std::string problem, std::string allowed) { return {"", std::move(field), std::move(problem), std::move(allowed)}; }

tl::unexpected<InputError> no_layout(const fs::path& file) {
  return tl::unexpected{InputError{file.string(), "", "VDA 5050 layouts (LIF) are not supported yet", "STATIONS.csv with --map and --vehicle, or scenario files"}};
}

/// --set goes to every place whose planner has the parameter and takes that value; what none takes is refused.
Parsed<void> apply_settings(const std::vector<std::string>& settings, std::vector<Place>& places) {
  if (auto once = check_each_key_once(settings); !once) return once;
  for (const std::string& setting : settings) {
    const std::string key = setting.substr(0, setting.find('='));
    bool used = false;
    std::optional<InputError> unknown, refused;
    for (Place& place : places) {
      const PlannerDescription* planner = find_planner(place.scenario.planner.name);
      if (planner == nullptr) continue;  // told with the place
      if (auto asked = check_somebody_asks("", settings, place.scenario); !asked) {
        unknown = asked.error();
        continue;
      }
      const bool has = std::any_of(planner->parameters.begin(), planner->parameters.end(), [&](const ParameterDescription& p) { return p.name == key; });
      auto set = set_parameter(*planner, place.scenario.planner.parameters, setting);
      if (!set) {
        if (!has) {
          unknown = set.error();
        } else if (!refused) {
          refused = set.error();
          refused->problem = planner->name + ": " + refused->problem;
        }
        continue;
      }
      if (auto free = has ? check_no_budget_over(setting, place.scenario.budget) : Parsed<void>{}; !free) {
        free.error().file = place.origin;
        return free;
      }
      used = true;
    }
    if (used) continue;
    if (refused || unknown) return tl::unexpected{refused ? *refused : *unknown};
  }
  return {};
}

/// What was repaired in rows, or is strange in them: the first in full, of the others how many.
void note_rows(const std::vector<SiteRow>& rows) {
  constexpr std::size_t told = 5;
  std::size_t noted = 0;
  for (const SiteRow& row : rows) {
    if (row.notes.empty() || ++noted > told) continue;
    for (const std::string& sentence : row.notes) note(fmt::format("note: {} ({}): {}", row.origin, row.name, sentence));
  }
  if (noted > told) note(fmt::format("note: {} more {}: see the reports", noted - told, noted == told + 1 ? "row has such notes" : "rows have such notes"));
}

/// One map, one vehicle, a place a line.
Parsed<std::vector<Place>> places_of_table(const CheckArguments& arguments) {
  if (!arguments.map) return tl::unexpected{wrong("--map", "it is missing", "the map of the site: a map.json, a ROS yaml, a DXF floor plan or a MovingAI map")};
  if (!arguments.vehicle) return tl::unexpected{wrong("--vehicle", "it is missing", "vehicle.json")};
  if (arguments.clearance && !(*arguments.clearance >= 0.0 && std::isfinite(*arguments.clearance)))
    return tl::unexpected{wrong("--clearance", "the number is out of range", "metres from 0")};
  auto site = read_site(*arguments.map, *arguments.vehicle);
  if (!site) return tl::unexpected{site.error()};
  note_all(site->notes, {});
  Scenario aligned;
  aligned.map.alignment = site->map.alignment;
  aligned.clearance = arguments.clearance.value_or(0.0);
  if (auto warning = alignment_warning(aligned)) note_all({}, {*warning});
  auto rows = read_site_csv(arguments.inputs.front(), *site, {arguments.clearance, arguments.planner, arguments.seed});
  if (!rows) return tl::unexpected{rows.error()};
  note_rows(*rows);
  SharedMaps maps;
  const auto map = maps.take(site->map);
  std::vector<Place> places;
  for (SiteRow& row : *rows) places.push_back({row.name, "", row.origin, std::move(row.scenario), map});
  return places;
}

/// A place a scenario.
Parsed<std::vector<Place>> places_of_scenarios(const CheckArguments& arguments) {
  for (const auto& [given, name] : {std::pair{arguments.map.has_value(), "--map"}, {arguments.vehicle.has_value(), "--vehicle"}, {arguments.clearance.has_value(), "--clearance"}}) {
    if (given && is_layout(arguments.inputs.front())) return no_layout(arguments.inputs.front());
    if (given) return tl::unexpected{wrong(name, "scenario files have their own", "it goes with STATIONS.csv alone")};
  }
  SharedMaps maps;
  std::vector<Place> places;
  for (const fs::path& file : arguments.inputs) {
    auto scenario = read_scenario(file);
    if (!scenario && is_layout(file)) return no_layout(file);
    if (!scenario) return tl::unexpected{scenario.error()};
    note_all(scenario->map.notes, {});
    if (auto warning = alignment_warning(*scenario)) note_all({}, {*warning});
    if (!arguments.planner.empty() && arguments.planner != scenario->planner.name) scenario->planner = {arguments.planner, {}};
    if (auto asked = check_somebody_asks(arguments.planner, {}, *scenario); !asked) {
      asked.error().file = file.string();
      return tl::unexpected{asked.error()};
    }
    if (arguments.seed) scenario->seed = *arguments.seed;
    auto map = maps.take(scenario->map);
    const std::string name = scenario->name.empty() ? file.stem().string() : scenario->name;
    places.push_back({name, "", file.string(), std::move(*scenario), std::move(map)});
  }
  return places;
}

Parsed<std::vector<Place>> places_of(const CheckArguments& arguments) {
  if (arguments.inputs.empty()) return tl::unexpected{wrong("command line", "there is nothing to check", "STATIONS.csv with --map and --vehicle, or scenario files")};
  const bool table = std::any_of(arguments.inputs.begin(), arguments.inputs.end(), is_table);
  if (table && arguments.inputs.size() > 1) return tl::unexpected{wrong("command line", "a table of stations stands beside other files", "one STATIONS.csv, or scenario files")};
  if (arguments.seed && *arguments.seed > static_cast<std::uint64_t>(INT64_MAX)) return tl::unexpected{wrong("--seed", "the number is out of range", "0 to 9223372036854775807")};
  auto places = table ? places_of_table(arguments) : places_of_scenarios(arguments);
  if (!places) return places;
  if (auto set = apply_settings(arguments.set, *places); !set) return tl::unexpected{set.error()};
  if (auto complete = complete_places(*places); !complete) return tl::unexpected{complete.error()};
  return places;
}

void show_progress(std::size_t done, std::size_t total) {
  if (::isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r%zu of %zu places%s", done, total, done == total ? "\n" : "");
  std::fflush(stderr);
}

}  // namespace

int check(const CheckArguments& arguments) {
  auto places = places_of(arguments);
  if (!places) return complain(places.error());
  if (auto ready = prepare_folder(arguments.out); !ready) return complain(ready.error());
  CheckOptions options;
  options.folder = arguments.out;
  options.fresh = arguments.fresh;
  options.threads = arguments.threads;
  options.progress = show_progress;
  auto checked = [&] {
    const Interruptible interruptible;
    options.cancel = interruptible.flag();
    return waywright::check(*places, options);
  }();
  if (!checked) return complain(checked.error());
  const CheckCounts counts = counts_of(*checked, places->size());
  const std::vector<Checked> table = by_tightness(std::move(*checked));
  const fs::path csv = arguments.out / "check.csv", html = arguments.out / "check.html";
  const std::string title = is_table(arguments.inputs.front()) ? arguments.inputs.front().stem().string() : places->size() == 1 ? places->front().name : fmt::format("{} scenarios", places->size());
  if (auto written = write_files({{csv, check_csv(table, *places)}, {html, check_html(table, *places, counts, title)}}); !written) return complain(written.error());
  bool printed = false;
  if (arguments.json) {
    std::vector<PlaceFigures> rows;
    std::vector<std::string> folders;
    for (const Checked& c : table) {
      rows.push_back(c.figures);
      folders.push_back((*places)[c.place].folder);
    }
    printed = print_raw(check_json(rows, folders, counts, version));
  } else {
    printed = print(check_text(table, *places, counts, rows_told) + fmt::format("written: {}, {}, {}/NAME/plan.json, …/plan.svg, …/report.html\n", csv.string(), html.string(), arguments.out.string()));
  }
  return counts.solved == counts.places && printed ? solved : not_solved;
}

}  // namespace waywright::app
