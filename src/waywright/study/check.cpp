#include "waywright/study/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>

#include "waywright/core/version.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/solve_legs.hpp"
#include "waywright/planner/threads.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/report/spots.hpp"
#include "waywright/report/words.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_kept = 1ULL << 30;  // bytes
constexpr const char* record_name = "place.json";
constexpr std::array<const char*, 4> kept_files{"plan.json", "plan.svg", "report.html", "small.svg"};

/// `problem`: none of a mission in legs, which has many.
PlaceFigures figures_of(const Place& place, const Problem* problem, const Plan& plan) {
  PlaceFigures f;
  f.name = place.name;
  f.status = plan.status;
  f.reason = plan.reason;
  f.reproducible = plan.reproducible;
  f.planner = plan.planner;
  f.asked = plan.scenario.clearance;
  f.plan_seconds = plan.timing.plan;
  f.has_path = !plan.samples.empty();
  if (!f.has_path) return f;
  const Certificate& c = plan.certificate;
  f.collision_free = c.collision_free;
  if (c.tightest && !is_beyond_measure(c)) f.tightest = TightSpot{c.collision_free ? c.clearance : 0.0, c.tightest_point, plan.tightest_obstacle};
  if (c.pocket_clearance && std::isfinite(*c.pocket_clearance)) f.pocket_clearance = std::max(0.0, *c.pocket_clearance);
  const auto spot = c.collision_free && problem != nullptr ? tightest_off_straight(*problem, plan) : std::nullopt;
  if (spot) f.on_the_way = TightSpot{spot->clearance, spot->point, spot->against};
  f.length = plan.metrics.length;
  f.max_curvature = std::isfinite(plan.metrics.max_curvature) ? plan.metrics.max_curvature : std::numeric_limits<double>::max();
  if (const double limit = plan.scenario.vehicle.max_curvature(); std::isfinite(limit)) f.curvature_limit = limit;
  f.direction_changes = static_cast<int>(plan.metrics.direction_changes);
  f.travel_time = plan.metrics.travel_time;
  return f;
}

/// The result that is there for the same key, whole.
std::optional<PlaceFigures> kept_result(const fs::path& folder, const std::string& key) {
  std::error_code error;
  if (!fs::is_regular_file(folder / record_name, error)) return std::nullopt;
  const auto text = read_file(folder / record_name, largest_kept);
  if (!text) return std::nullopt;
  const auto record = parse_place_record(*text);
  if (!record || record->key != key) return std::nullopt;
  for (const char* name : kept_files) {
    const auto hash = record->files.find(name);
    if (hash == record->files.end()) return std::nullopt;
    const auto content = read_file(folder / name, largest_kept);
    if (!content || sha256(*content) != hash->second) return std::nullopt;
  }
  const bool out_of_time = !record->figures.reproducible && record->figures.status != Status::solved;
  if (out_of_time || record->figures.status == Status::canceled) return std::nullopt;
  return record->figures;
}

Parsed<void> write_result(const fs::path& folder, const std::string& key, const Problem* problem, const Plan& plan, PlaceFigures& figures) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return tl::unexpected{InputError{folder.string(), "", "the folder cannot be made: " + error.message(), ""}};
  SmallPicture small = problem ? small_picture(*problem, plan) : small_picture(plan);
  figures.picture_width = small.width;
  figures.picture_height = small.height;
  const std::array<std::string, 4> contents{plan_json(plan), problem ? plan_svg(*problem, plan) : plan_svg(plan), problem ? report_html(*problem, plan) : report_html(plan),
                                            std::move(small.svg)};
  PlaceRecord record{key, {}, figures};
  std::vector<NamedContent> files;
  for (std::size_t i = 0; i < kept_files.size(); ++i) {
    record.files[kept_files[i]] = sha256(contents[i]);
    files.push_back({folder / kept_files[i], contents[i]});
  }
  files.push_back({folder / record_name, place_record_json(record)});
  return write_files(files);
}

/// Empty where it was canceled.
Parsed<std::optional<Checked>> check_one(const Place& place, std::size_t index, const CheckOptions& options) {
  const std::string key = key_of(place);
  const fs::path folder = options.folder / place.folder;
  if (!options.fresh) {
    if (auto kept = kept_result(folder, key)) {
      kept->name = place.name;  // of a scenario without one: its file may have another by now
      return Checked{index, true, std::move(*kept)};
    }
  }
  const auto of_place = [&](InputError error) {
    error.file = place.origin;
    return tl::unexpected{std::move(error)};
  };
  Scenario scenario = place.scenario;
  std::vector<std::string> notes = std::move(scenario.map.notes);
  scenario.map = place.map->map();
  scenario.map.notes = std::move(notes);
  std::optional<Problem> problem;
  if (scenario.legs.empty()) {
    auto prepared = Problem::prepare(std::move(scenario), &place.map->world());
    if (!prepared) return of_place(prepared.error());
    problem = std::move(*prepared);
  }
  const auto plan = problem ? solve(*problem, options.cancel) : solve_legs(scenario, options.cancel);
  if (!plan) return of_place(plan.error());
  const bool canceled = options.cancel != nullptr && options.cancel->load();
  if (plan->status == Status::canceled || (canceled && !plan->reproducible)) return std::optional<Checked>{};
  const Problem* one = problem ? &*problem : nullptr;
  Checked checked{index, false, figures_of(place, one, *plan)};
  if (auto written = write_result(folder, key, one, *plan, checked.figures); !written) return tl::unexpected{written.error()};
  return checked;
}

/// Of the planner that the scenario names, or of its legs'.
Parsed<void> complete_planners(Scenario& scenario) {
  if (!scenario.legs.empty()) return complete_legs(scenario);
  auto parameters = complete_parameters(scenario.planner);
  if (!parameters) return tl::unexpected{parameters.error()};
  if (auto takes = check_mission(scenario.planner.name, scenario); !takes) return takes;
  if (auto kept = check_budget(scenario.planner.name, *parameters, scenario.budget); !kept) return kept;
  scenario.planner.parameters = std::move(*parameters);
  return {};
}

/// A thread has nobody above it to catch anything.
Parsed<std::optional<Checked>> checked_or_out_of_memory(const Place& place, std::size_t index, const CheckOptions& options) try {
  return check_one(place, index, options);
} catch (const std::bad_alloc&) {
  return tl::unexpected{InputError{place.origin, "", "there is not enough memory for this place", ""}};
}

/// A byte of a character of UTF-8 that is not its first.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

const World& SharedMap::world() const {
  std::call_once(made_, [this] { world_ = World{map_}; });
  return world_;
}

std::shared_ptr<const SharedMap> SharedMaps::take(Map& map) {
  std::vector<std::string> notes = std::move(map.notes);
  map.notes.clear();
  const std::string hash = sha256(map_json(map));
  auto& kept = maps_[hash];
  if (!kept) kept = std::make_shared<const SharedMap>(std::move(map), hash);
  map = {};
  map.notes = std::move(notes);
  return kept;
}

std::string folder_name(const std::string& name) {
  constexpr std::size_t longest = 80;
  std::string safe;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool c1 = c == 0xC2 && i + 1 < name.size() && static_cast<unsigned char>(name[i + 1]) < 0xA0;  // control characters
    if (c1) ++i;
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || (c == '.' && !safe.empty());
    safe += !c1 && (plain || c >= 0x80) ? static_cast<char>(c) : '-';
  }
  if (safe.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && continues(safe[end])) --end;
    safe.resize(end);
  }
  return safe.empty() ? "place" : safe;
}

std::string key_of(const Place& place) {
  return sha256(fmt::format("waywright {}\nmap {}\n{}", version, place.map->sha256(), scenario_json(place.scenario, -1)));
}

Parsed<void> complete_places(std::vector<Place>& places) {
  std::map<std::string, const Place*> folders;
  for (Place& place : places) {
    const auto refuse = [&](InputError error) {
      error.file = place.origin;
      return tl::unexpected{std::move(error)};
    };
    if (auto complete = complete_planners(place.scenario); !complete) return refuse(complete.error());
    place.folder = folder_name(place.name);
    if (place.folder == "check.csv" || place.folder == "check.html") {
      return refuse({"", "name", fmt::format("\"{}\" is a file of the check itself", place.name), "another name"});
    }
    const auto [other, is_new] = folders.emplace(place.folder, &place);
    if (!is_new) {
      return refuse({"", "name", fmt::format("\"{}\" and \"{}\" ({}) would have the same folder, {}", place.name, other->second->name, other->second->origin, place.folder),
                     "names that differ in letters, digits, '-', '_' or '.' within their first 80 bytes"});
    }
    // Without the map it costs nothing, and what it refuses is not found when half of the site is done.
    if (!place.scenario.legs.empty()) continue;  // complete_planners has looked at them
    if (const auto problem = Problem::prepare(place.scenario); !problem) return refuse(problem.error());
  }
  return {};
}

Parsed<std::vector<Checked>> check(const std::vector<Place>& places, const CheckOptions& options) {
  std::vector<std::optional<Checked>> all(places.size());
  std::vector<std::optional<InputError>> errors(places.size());
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::size_t done = 0;
  std::mutex progress_mutex;
  const auto work = [&] {
    for (;;) {
      const std::size_t i = next.fetch_add(1);
      if (i >= places.size() || failed.load() || (options.cancel != nullptr && options.cancel->load())) return;
      auto checked = checked_or_out_of_memory(places[i], i, options);
      if (!checked) {
        errors[i] = checked.error();
        failed = true;
        return;
      }
      if (!*checked) return;
      all[i] = std::move(*checked);
      const std::lock_guard lock{progress_mutex};
      ++done;
      if (options.progress) options.progress(done, places.size());
    }
  };
  on_threads(options.threads, places.size(), work);
  for (const auto& error : errors) {
    if (error) return tl::unexpected{*error};
  }
  std::vector<Checked> kept;
  for (auto& checked : all) {
    if (checked) kept.push_back(std::move(*checked));
  }
  return kept;
}

}  // namespace waywright
