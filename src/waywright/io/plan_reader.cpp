// plan.json read back: what it claims, for others to judge.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "waywright/io/files.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/plan_json.hpp"
#include "waywright/io/scenario_json.hpp"

namespace waywright {
namespace {

constexpr std::size_t deepest_plan = deepest_json + 1;  // a scenario of the greatest depth stands inside
constexpr double largest_on_path = 1e7;                 // m; control points may lie beyond the curve
constexpr double largest_angle = 1e6;                   // rad
constexpr double largest_number = std::numeric_limits<double>::max();
constexpr std::int64_t largest_count = std::numeric_limits<std::int64_t>::max();

/// The course is kept as written, not wrapped: it defines the curve to the last bit.
Pose read_course(const Node& node) {
  if (!node.is_array_of(3, "[x, y, course]")) return {};
  return {node.at(std::size_t{0}).number(-largest_on_path, largest_on_path), node.at(1).number(-largest_on_path, largest_on_path),
          node.at(2).number(-largest_angle, largest_angle)};
}

Arc read_arc(const Node& node) {
  Arc arc;
  arc.start = read_course(node.at("start"));
  arc.curvature = node.at("curvature").number(-1e6, 1e6);
  arc.length = node.at("length").number_above(0.0, largest_on_path);
  return arc;
}

Clothoid read_clothoid(const Node& node) {
  Clothoid clothoid;
  clothoid.start = read_course(node.at("start"));
  clothoid.curvature = node.at("curvature").number(-1e6, 1e6);
  clothoid.curvature_rate = node.at("curvature_rate").number(-1e12, 1e12);
  clothoid.length = node.at("length").number_above(0.0, largest_on_path);
  return clothoid;
}

Spline read_spline(const Node& node, SplineKind kind) {
  Spline spline{kind, {}};
  for (const Node& span : node.elements()) {
    const std::vector<Vec2> points = span.points(largest_on_path);
    if (node.failed()) return spline;
    if (points.size() < 2 || points.size() > 6) {
      span.fail(fmt::format("a span of {} control point{}", points.size(), points.size() == 1 ? "" : "s"),
                "2 to 6 points [x, y]");
      return spline;
    }
    BezierSpan& added = spline.spans.emplace_back();
    added.degree = static_cast<int>(points.size()) - 1;
    std::copy(points.begin(), points.end(), added.control.begin());
  }
  if (spline.spans.empty()) node.fail("a spline without spans", "at least one span");
  return spline;
}

Curve read_curve(const Node& node, const std::string& kind) {
  if (kind == "line") {
    if (!node.is_object_of({"kind", "direction", "from", "to", "heading"})) return {};
    return Line{node.at("from").point(largest_on_path), node.at("to").point(largest_on_path)};
  }
  if (kind == "arc") {
    if (!node.is_object_of({"kind", "direction", "start", "curvature", "length", "heading"})) return {};
    return read_arc(node);
  }
  if (kind == "clothoid") {
    if (!node.is_object_of({"kind", "direction", "start", "curvature", "curvature_rate", "length"})) return {};
    return read_clothoid(node);
  }
  if (kind == "turn") {
    if (!node.is_object_of({"kind", "direction", "at", "from", "angle"})) return {};
    return Turn{node.at("at").point(largest_on_path), node.at("from").number(-largest_angle, largest_angle),
                node.at("angle").number(-1e3, 1e3)};
  }
  if (kind == "poses") {
    if (!node.is_object_of({"kind", "direction", "poses"})) return {};
    PoseSequence sequence{node.at("poses").poses(largest_on_path)};
    if (sequence.poses.size() < 2)
      node.at("poses").fail("fewer than two poses", "at least two poses [x, y, heading]");
    return sequence;
  }
  if (!node.is_object_of({"kind", "direction", "spans"})) return {};
  return read_spline(node.at("spans"),
                     kind == word_of(SplineKind::quintic) ? SplineKind::quintic : SplineKind::natural_cubic);
}

Piece read_piece(const Node& node) {
  Piece piece;
  const std::string kind = node.at("kind").word(
      {"line", "arc", "clothoid", "turn", "poses", word_of(SplineKind::natural_cubic), word_of(SplineKind::quintic)});
  if (node.failed()) return piece;
  piece.curve = read_curve(node, kind);
  if (node.failed()) return piece;
  const Node direction = node.at("direction");
  piece.direction = static_cast<int>(direction.integer(-1, 1));
  if (!node.failed() && (piece.direction == 0) != (kind == "turn")) {
    direction.fail(fmt::format("{} on a piece of kind \"{}\"", piece.direction, kind),
                   kind == "turn" ? "0" : "1, -1");
  }
  if (node.failed() || !node.given("heading")) return piece;
  const Node heading = node.at("heading");
  if (piece.direction != 1) heading.fail("it is told along a piece that is driven backwards", "direction 1 where the vehicle does not face along");
  if (heading.is_object_of({"from", "turn"})) piece.heading = HeadingAlong{heading.at("from").number(-largest_angle, largest_angle), heading.at("turn").number(-1e3, 1e3)};
  return piece;
}

std::vector<Sample> read_samples(const Node& node) {
  std::vector<Sample> samples;
  if (!node.is_object_of({"s", "x", "y", "heading", "course", "curvature", "direction", "t", "speed"}))
    return samples;
  samples.resize(node.at("s").json().size());
  const auto read = [&](const char* name, double low, double high, auto set) {
    if (node.failed()) return;
    const Node column = node.at(name);
    const std::vector<double> values = column.numbers(low, high);
    if (node.failed()) return;
    if (values.size() != samples.size()) {
      return column.fail(fmt::format("it has {} elements", values.size()),
                         fmt::format("as many as s: {}", samples.size()));
    }
    for (std::size_t i = 0; i < samples.size(); ++i) set(samples[i], values[i], column, i);
  };
  for (const SampleColumn& c : sample_columns) {
    read(c.name, -largest_number, largest_number,
         [&](Sample& s, double v, const Node&, std::size_t) { s.*c.value = v; });
  }
  read("direction", -1.0, 1.0, [](Sample& s, double v, const Node& column, std::size_t i) {
    s.direction = v > 0.0 ? 1 : v < 0.0 ? -1 : 0;
    if (v != s.direction) column.at(i).fail(fmt::format("{} is no direction", v), "1, -1, 0");
  });
  return samples;
}

Metrics read_metrics(const Node& node) {
  Metrics metrics;
  if (!node.is_object_of({"length", "min_clearance", "mean_clearance", "max_curvature", "max_curvature_rate",
                          "curvature_change", "curvature_change_printed", "turning", "direction_changes",
                          "collision_risk", "travel_time"})) {
    return metrics;
  }
  for (const MetricField& field : metric_fields) {
    // Left out where it is not finite.
    metrics.*field.value = node.has(field.name) ? node.at(field.name).number(-largest_number, largest_number)
                                                : std::numeric_limits<double>::infinity();
  }
  metrics.direction_changes = static_cast<int>(node.at("direction_changes").integer(0, 1'000'000'000));
  return metrics;
}

Certificate read_certificate(const Node& node, std::string& obstacle) {
  Certificate c;
  if (!node.is_object_of({"collision_free", "clearance", "tolerance", "checked_length", "pocket_clearance", "tightest"}))
    return c;
  c.collision_free = node.at("collision_free").boolean();
  c.clearance = node.at("clearance").number(0.0, 1e9);
  c.tolerance = node.at("tolerance").number(0.0, 1e3);
  c.checked_length = node.at("checked_length").number(0.0, 1e9);
  if (node.has("pocket_clearance")) c.pocket_clearance = node.at("pocket_clearance").number(0.0, 1e9);
  if (node.has("tightest")) {
    const Node tightest = node.at("tightest");
    if (!tightest.is_object_of({"pose", "point", "obstacle"})) return c;
    c.tightest = tightest.at("pose").pose(largest_on_path);
    c.tightest_point = tightest.at("point").point(largest_on_path);
    obstacle = tightest.at("obstacle").text();
  }
  return c;
}

Status read_status(const Node& node) {
  const std::string status = node.word({"solved", "unproven", "no_path", "start_in_collision", "goal_in_collision", "start_outside", "goal_outside", "timed_out", "canceled"});
  return status_from_string(status).value_or(Status::no_path);
}

Timing read_timing(const Node& node) {
  Timing timing;
  if (!node.is_object_of({"load", "prepare", "plan", "prove"})) return timing;
  const auto seconds = [&](const char* field) {
    return node.has(field) ? node.at(field).number(0.0, 1e9) : 0.0;
  };
  return {seconds("load"), seconds("prepare"), seconds("plan"), seconds("prove")};
}

Effort read_effort(const Node& node) {
  Effort effort;
  if (!node.is_object_of({"evaluations", "expansions", "samples"})) return effort;
  if (node.has("samples")) node.at("samples").integer(0, largest_count);  // of other planners' plans; there is no place for them here
  if (node.has("expansions")) effort.expansions = node.at("expansions").integer(0, largest_count);
  if (node.has("evaluations")) effort.evaluations = node.at("evaluations").integer(0, largest_count);
  return effort;
}

LegResult read_leg_result(const Node& node) {
  LegResult leg;
  if (!node.is_object_of({"name", "load", "planner", "status", "reason", "start", "end", "pieces", "samples", "effort", "metrics", "certificate"})) return leg;
  leg.name = node.at("name").text();
  if (node.given("load")) leg.load = node.at("load").text();
  const Node planner = node.at("planner");
  if (!planner.is_object_of({"name", "parameters"})) return leg;
  leg.planner = planner.at("name").text();
  leg.parameters = read_parameters(planner.at("parameters"));
  leg.status = read_status(node.at("status"));
  if (node.given("reason")) leg.reason = node.at("reason").text();
  leg.start = node.at("start").pose(largest_on_path);
  leg.end = node.at("end").pose(largest_on_path);
  const auto count = [&](const char* field) { return static_cast<std::size_t>(node.at(field).integer(0, largest_count)); };
  leg.pieces = count("pieces");
  leg.samples = count("samples");
  if (node.has("effort")) leg.effort = read_effort(node.at("effort"));
  if (node.failed()) return leg;
  leg.has_path = leg.pieces > 0 || node.given("metrics") || node.given("certificate");
  if (!leg.has_path) return leg;
  leg.metrics = read_metrics(node.at("metrics"));
  leg.certificate = read_certificate(node.at("certificate"), leg.tightest_obstacle);
  return leg;
}

/// As many as the scenario has, or fewer where the mission came to its end before.
void read_leg_results(const Node& node, Plan& plan) {
  const std::size_t most = plan.scenario.legs.size();
  if (node.is_array() && node.json().size() > most) {
    return node.fail(fmt::format("there are {}", node.json().size()), most == 0 ? "no such field, as the scenario has no legs" : fmt::format("at most {}, as the scenario has", most));
  }
  for (const Node& leg : node.elements()) {
    plan.legs.push_back(read_leg_result(leg));
    if (node.failed()) return;
  }
}

/// `meta` is free: alternatives are taken where they are what our writer writes, and left alone where they
/// are not.
std::vector<Alternative> read_alternatives(const Json& meta) {
  const auto found = meta.find("alternatives");
  if (found == meta.end() || !found->is_array()) return {};
  std::vector<Alternative> alternatives;
  ReadContext ours;
  for (const Node& node : Node{*found, "", ours}.elements()) {
    if (!node.is_object_of({"name", "chosen", "cost", "outcome"})) return {};
    Alternative a;
    a.name = node.at("name").text();
    a.chosen = node.at("chosen").boolean();
    if (node.given("cost")) a.cost = node.at("cost").number(-largest_number, largest_number);
    a.outcome = node.at("outcome").text();
    alternatives.push_back(std::move(a));
  }
  if (ours.error) return {};
  return alternatives;
}

void read_result(const Node& node, Plan& plan) {
  for (const char* field : {"path", "metrics", "certificate"}) {
    if (const Node value = node.at(field); value.missing()) return value.fail("", "an object, or null where there is no path");
  }
  const bool path_given = !node.at("path").json().is_null();
  for (const char* field : {"metrics", "certificate"}) {
    const Node value = node.at(field);
    if (node.failed() || value.json().is_null() != path_given) continue;
    value.fail(path_given ? "it is null" : "it is given without a path",
               path_given ? "an object, as there is a path" : "null");
  }
  if (node.failed() || !path_given) return;
  const Node path = node.at("path");
  if (!path.is_object_of({"pieces", "samples"})) return;
  const Node pieces = path.at("pieces");
  for (const Node& piece : pieces.elements()) {
    plan.path.pieces.push_back(read_piece(piece));
    if (node.failed()) return;
  }
  if (plan.path.pieces.empty())
    pieces.fail("a path without pieces", "at least one piece, or null as the path");
  if (node.failed()) return;
  plan.samples = read_samples(path.at("samples"));
  plan.metrics = read_metrics(node.at("metrics"));
  plan.certificate = read_certificate(node.at("certificate"), plan.tightest_obstacle);
}

Plan read_plan_node(const Node& node, const std::filesystem::path& folder) {
  Plan plan;
  check_format(node, "plan");  // first: a newer one may well have fields that are unknown here
  if (node.failed() || !node.is_object_of({"format", "version", "status", "reason", "reproducible",
                                           "scenario", "planner", "seed", "timing", "effort", "legs", "path",
                                           "metrics", "certificate", "explanation", "meta"})) {
    return plan;
  }
  plan.version = node.at("version").text();
  plan.status = read_status(node.at("status"));
  if (node.given("reason")) plan.reason = node.at("reason").text();
  if (node.has("reproducible")) plan.reproducible = node.at("reproducible").boolean();
  if (node.failed()) return plan;

  const Node scenario = node.at("scenario");
  plan.scenario = read_scenario_node(scenario, folder);
  if (node.failed()) return plan;
  const Node planner = node.at("planner");
  if (!planner.is_object_of({"name", "parameters"})) return plan;
  plan.planner = planner.at("name").text();
  plan.parameters = read_parameters(planner.at("parameters"));
  plan.seed = node.has("seed") ? static_cast<std::uint64_t>(node.at("seed").integer(0, largest_count))
                               : plan.scenario.seed;
  if (node.has("timing")) plan.timing = read_timing(node.at("timing"));
  if (node.has("effort")) plan.effort = read_effort(node.at("effort"));
  if (node.failed()) return plan;
  if (node.has("legs")) read_leg_results(node.at("legs"), plan);
  read_result(node, plan);
  if (node.has("explanation")) {
    for (const Node& sentence : node.at("explanation").elements())
      plan.explanation.push_back(sentence.text());
  }
  if (node.has("meta")) {
    const Node meta = node.at("meta");
    if (!meta.is_object())
      meta.fail(fmt::format("it is {}", kind_of(meta.json())), "an object");
    else
      plan.alternatives = read_alternatives(meta.json());
  }
  return plan;
}

}  // namespace

Parsed<Plan> parse_plan(const std::string& text, const std::string& name) {
  auto json = parse_json(text, name, deepest_plan);
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{name, {}};
  Plan plan = read_plan_node(Node{*json, "", context}, std::filesystem::path{name}.parent_path());
  if (context.error) return tl::unexpected{*context.error};
  return plan;
}

Parsed<Plan> read_plan(const std::filesystem::path& file) {
  auto text = read_file(file, largest_json);
  if (!text) return tl::unexpected{text.error()};
  return parse_plan(*text, file.string());
}

}  // namespace waywright
