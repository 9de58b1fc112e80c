#include "waywright/io/site_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "waywright/core/angle.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/io/csv_table.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_json.hpp"

namespace waywright {
namespace {

constexpr std::uint64_t largest_csv = 64ULL << 20;  // bytes
constexpr std::size_t most_rows = 100'000;
constexpr std::size_t most_steps = 6;  // of a column's dotted name
constexpr const char* known_columns =
    "name, start_x, start_y, start_heading, goal_x, goal_y, goal_heading, shelf_x, shelf_y, shelf_heading, shelf_depth, shelf_width, gap, slot, "
    "area, waypoints, clearance, planner, seed, carried_load, zones, and dotted names of scenario.json such as station.manoeuvre";

/// Columns with names of their own, and the field of scenario.json that each fills.
struct Known {
  const char* name;
  const char* path;
  enum class Kind { number, degrees, text, points } kind;
};
constexpr Known known[] = {
    {"name", "name", Known::Kind::text},
    {"start_x", "start[0]", Known::Kind::number},
    {"start_y", "start[1]", Known::Kind::number},
    {"start_heading", "start[2]", Known::Kind::number},
    {"start_heading_deg", "start[2]", Known::Kind::degrees},
    {"goal_x", "goal[0]", Known::Kind::number},
    {"goal_y", "goal[1]", Known::Kind::number},
    {"goal_heading", "goal[2]", Known::Kind::number},
    {"goal_heading_deg", "goal[2]", Known::Kind::degrees},
    {"shelf_x", "station.shelf.center[0]", Known::Kind::number},
    {"shelf_y", "station.shelf.center[1]", Known::Kind::number},
    {"shelf_heading", "station.shelf.heading", Known::Kind::number},
    {"shelf_heading_deg", "station.shelf.heading", Known::Kind::degrees},
    {"shelf_depth", "station.shelf.size[0]", Known::Kind::number},
    {"shelf_width", "station.shelf.size[1]", Known::Kind::number},
    {"gap", "station.shelf.gap", Known::Kind::number},
    {"slot", "station.shelf.slot", Known::Kind::number},
    {"area", "station.area", Known::Kind::points},
    {"waypoints", "waypoints", Known::Kind::points},
    {"clearance", "clearance", Known::Kind::number},
    {"planner", "planner.name", Known::Kind::text},
};
/// Fields of scenario.json that a dotted name may begin with, and those that stand alone.
constexpr std::array<std::string_view, 5> openings{"station", "pose_error", "budget", "planner", "meta"};
constexpr std::array<std::string_view, 3> alone{"seed", "carried_load", "zones"};
/// Arrays that are made of several columns, with what each element is called.
struct Group {
  const char* path;
  std::size_t size;
};
constexpr Group groups[] = {{"start", 3}, {"goal", 3}, {"station.shelf.center", 2}, {"station.shelf.size", 2}};

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps(1);
  for (const char c : path) {
    if (c == '.') steps.emplace_back();
    else steps.back() += c;
  }
  return steps;
}

/// A word, or words joined by dots, of letters, digits and _.
bool is_dotted(const std::string& name) {
  const auto steps = steps_of(name);
  const bool words = std::all_of(steps.begin(), steps.end(), [](const std::string& step) {
    return !step.empty() && std::all_of(step.begin(), step.end(), [](unsigned char c) { return (c < 0x80 && std::isalnum(c) != 0) || c == '_'; });
  });
  if (!words || steps.size() > most_steps) return false;
  if (steps.size() == 1) return std::find(alone.begin(), alone.end(), name) != alone.end();
  return std::find(openings.begin(), openings.end(), steps.front()) != openings.end();
}

struct Column {
  std::string name;  ///< as the file has it
  std::string path;  ///< of the field
  std::optional<Known::Kind> kind;  ///< absent: a dotted name, whose cells are JSON or text
};

std::optional<Column> column_of(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return static_cast<char>(c < 0x80 ? std::tolower(c) : c); });
  for (const Known& k : known) {
    if (lower == k.name) return Column{name, k.path, k.kind};
  }
  if (is_dotted(name)) return Column{name, name, std::nullopt};
  return std::nullopt;
}

/// Sets a field by its dotted path; false where something else stands in the way.
bool set_field(Json& root, const std::string& path, Json value) {
  Json* at = &root;
  for (const std::string& step : steps_of(path)) {
    if (at->is_null()) *at = Json::object();
    if (!at->is_object()) return false;
    at = &(*at)[step];
  }
  if (!at->is_null()) return false;
  *at = std::move(value);
  return true;
}

/// "0 1 | 2 3": points between bars, numbers between blanks.
std::optional<Json> points_from(std::string_view text) {
  Json points = Json::array();
  Json point = Json::array();
  for (;;) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    if (text.empty() || text.front() == '|') {
      if (point.size() != 2) return std::nullopt;
      points.push_back(std::move(point));
      point = Json::array();
      if (text.empty()) return points;
      text.remove_prefix(1);
      continue;
    }
    const std::string_view word = text.substr(0, text.find_first_of(" \t|"));
    const auto value = csv_number(word);
    if (!value) return std::nullopt;
    point.push_back(*value);
    text.remove_prefix(word.size());
  }
}

/// Two corners of a rectangle become its four.
Json area_from(Json points) {
  if (points.size() != 2) return points;
  const Json a = points[0], c = points[1];
  return Json::array({a, Json::array({c[0], a[1]}), c, Json::array({a[0], c[1]})});
}

class RowReader {
 public:
  RowReader(const std::vector<Column>& columns, const std::string& file, const Site& site, const SiteDefaults& defaults)
      : columns_{columns}, file_{file}, site_{site}, defaults_{defaults} {
    const Json source = Json::parse(site.map_source, nullptr, false);
    is_drawing_ = source.is_object() && source.value("kind", "") == "dxf";
  }

  Parsed<SiteRow> read(const CsvRow& row) {
    row_ = &row;
    json_ = Json{{"format", "waywright-scenario/1"}};
    parts_.clear();
    noted_.clear();
    error_.reset();
    for (std::size_t i = 0; i < columns_.size() && !error_; ++i) {
      if (!row.cells[i].empty()) read_cell(columns_[i], row.cells[i]);
    }
    if (!error_) join_groups();
    if (!error_ && !json_.contains("name")) refuse("name", "the place has no name", "a name that no other place has");
    if (error_) return tl::unexpected{*error_};
    fill_defaults();
    if (is_drawing_ && parts_.contains("start[0]") && parts_.contains("start[1]")) {
      for (std::string& sentence : outline_doubts(site_.map, {parts_["start[0]"], parts_["start[1]"]})) noted_.push_back(std::move(sentence));
    }
    ReadContext context{origin(), {}};
    SiteRow result{json_["name"].get<std::string>(), fmt::format("{}: line {}", file_, row.line), {}, {}};
    result.scenario = read_scenario_node(Node{json_, "", context}, {}, &site_, noted_);
    if (!context.error) {
      const std::vector<std::string>& all = result.scenario.map.notes;
      result.notes.assign(all.begin() + static_cast<std::ptrdiff_t>(std::min(site_.notes.size(), all.size())), all.end());
      return result;
    }
    InputError error = *context.error;
    error.field = column_for(error.field);
    return tl::unexpected{error};
  }

 private:
  void read_cell(const Column& column, const std::string& cell) {
    if (!column.kind) return set(column, value_from(cell));
    if (*column.kind == Known::Kind::text) return set(column, cell);
    if (*column.kind == Known::Kind::points) {
      auto points = points_from(cell);
      if (!points) return refuse(column.name, fmt::format("\"{}\" is no list of points", shortened(cell)), "x y | x y | …, decimal points");
      return set(column, column.path == "station.area" ? area_from(std::move(*points)) : std::move(*points));
    }
    const auto value = csv_number(cell);
    if (!value) return refuse(column.name, fmt::format("\"{}\" is no number", shortened(cell)), "a finite number with a decimal point");
    double radians = *column.kind == Known::Kind::degrees ? *value / 180.0 * pi : *value;
    if (is_heading(column)) {
      if (const auto doubt = *column.kind == Known::Kind::number ? heading_doubt(radians) : std::nullopt) {
        noted_.push_back(fmt::format("{}: {} (a column {}_deg takes degrees)", column.name, *doubt, column.name));
      }
      radians = wrap(radians);
    }
    if (column.path.back() == ']') parts_[column.path] = radians;
    else set(column, radians);
  }

  static bool is_heading(const Column& column) { return column.path == "start[2]" || column.path == "goal[2]" || column.path == "station.shelf.heading"; }

  /// Of a dotted name: a number, true, false, an array or an object; anything else is text.
  static Json value_from(const std::string& cell) {
    const char first = cell.front();
    const bool maybe = first == '[' || first == '{' || first == '-' || (first >= '0' && first <= '9') || cell == "true" || cell == "false";
    auto value = maybe ? parse_json(cell, "") : Parsed<Json>{Json(cell)};
    return value ? std::move(*value) : Json(cell);
  }

  void set(const Column& column, Json value) {
    if (!set_field(json_, column.path, std::move(value))) refuse(column.name, "another column of this row says the same", "one column for a field");
  }

  /// x, y and heading that stand in columns of their own become one array; all of them are needed, or none.
  void join_groups() {
    for (const Group& group : groups) {
      Json array = Json::array();
      std::string missing;
      for (std::size_t i = 0; i < group.size; ++i) {
        const std::string path = fmt::format("{}[{}]", group.path, i);
        const auto part = parts_.find(path);
        if (part == parts_.end()) missing = missing.empty() ? path : missing;
        else array.push_back(part->second);
      }
      if (array.empty()) continue;
      if (!missing.empty()) return refuse(column_for(missing), "it is missing, and others of its kind are given", "a number");
      if (!set_field(json_, group.path, std::move(array))) return refuse(group.path, "another column of this row says the same", "one column for a field");
    }
  }

  void fill_defaults() {
    if (defaults_.clearance && !json_.contains("clearance")) json_["clearance"] = *defaults_.clearance;
    if (defaults_.seed && !json_.contains("seed")) json_["seed"] = *defaults_.seed;
    const bool named = json_.contains("planner") && json_["planner"].is_object() && json_["planner"].contains("name");
    if (!named && (!defaults_.planner.empty() || json_.contains("planner"))) {
      const std::string otherwise = json_.contains("waypoints") ? planner_through_waypoints : PlannerChoice{}.name;
      json_["planner"]["name"] = defaults_.planner.empty() ? otherwise : defaults_.planner;
    }
  }

  /// The column that fills a field, or one that would.
  std::string column_for(const std::string& field) const {
    for (const Column& column : columns_) {
      if (column.path == field) return column.name;
    }
    for (const Known& k : known) {
      if (field == k.path) return k.name;
    }
    for (const Known& k : known) {  // an element of a list
      if (k.kind == Known::Kind::points && field.rfind(k.path, 0) == 0) return k.name;
    }
    return field;
  }

  std::string origin() const {
    const bool named = json_.contains("name");
    return fmt::format("{}: line {}{}", file_, row_->line, named ? fmt::format(" ({})", shortened(json_["name"].get<std::string>())) : "");
  }
  void refuse(const std::string& column, std::string problem, std::string allowed) {
    error_ = InputError{origin(), column, std::move(problem), std::move(allowed)};
  }

  const std::vector<Column>& columns_;
  const std::string& file_;
  const Site& site_;
  const SiteDefaults& defaults_;
  bool is_drawing_ = false;  ///< the site's map
  const CsvRow* row_ = nullptr;
  Json json_;
  std::vector<std::string> noted_;
  std::map<std::string, double> parts_;
  std::optional<InputError> error_;
};

}  // namespace

Parsed<std::vector<SiteRow>> parse_site_csv(const std::string& text, const std::string& name, const Site& site, const SiteDefaults& defaults) {
  const auto table = parse_csv_table(text, name, most_rows, "a header that names name, start_x, start_y, start_heading and a goal or a shelf");
  if (!table) return tl::unexpected{table.error()};
  std::vector<Column> columns;
  const auto refuse = [&](std::string problem, std::string allowed) {
    return tl::unexpected{InputError{name, "the header", std::move(problem), std::move(allowed)}};
  };
  for (const std::string& title : table->header) {
    auto column = column_of(title);
    if (!column) {
      std::vector<std::string> names;
      for (const Known& k : known) names.emplace_back(k.name);
      return refuse(title.empty() ? "a column has no name" : fmt::format("the column \"{}\" is not known{}", shortened(title), meant_instead(title, names)), known_columns);
    }
    const auto same = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.path == column->path; });
    if (same != columns.end()) return refuse(fmt::format("the columns \"{}\" and \"{}\" say the same", shortened(same->name), shortened(title)), "one of them");
    columns.push_back(std::move(*column));
  }
  for (const char* needed : {"name", "start[0]", "start[1]", "start[2]"}) {
    if (std::any_of(columns.begin(), columns.end(), [&](const Column& c) { return c.path == needed; })) continue;
    const auto* k = std::find_if(std::begin(known), std::end(known), [&](const Known& one) { return std::string_view{one.path} == needed; });
    return refuse(fmt::format("the column \"{}\" is missing", k->name), known_columns);
  }
  if (table->rows.empty()) return tl::unexpected{InputError{name, "", "there is no place below the header", "at least one row"}};
  std::vector<SiteRow> rows;
  RowReader reader{columns, name, site, defaults};
  for (const CsvRow& row : table->rows) {
    auto read = reader.read(row);
    if (!read) return tl::unexpected{read.error()};
    rows.push_back(std::move(*read));
  }
  return rows;
}

Parsed<std::vector<SiteRow>> read_site_csv(const std::filesystem::path& file, const Site& site, const SiteDefaults& defaults) {
  auto text = read_file(file, largest_csv);
  if (!text) return tl::unexpected{text.error()};
  return parse_site_csv(*text, file.string(), site, defaults);
}

}  // namespace waywright
