#include "waywright/io/plan_io.hpp"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include "waywright/io/files.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

constexpr std::uint64_t largest_plan = 512ULL << 20;

const char* kind_of(SplineKind kind) {
  return kind == SplineKind::natural_cubic ? "natural_cubic_spline" : "quintic_spline";
}

Json piece_to_json(const Piece& piece) {
  return std::visit(
      [&](const auto& curve) -> Json {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Line>) {
          return {{"kind", "line"}, {"direction", piece.direction}, {"from", to_json(curve.from)}, {"to", to_json(curve.to)}};
        } else if constexpr (std::is_same_v<C, Arc>) {
          return {{"kind", "arc"}, {"direction", piece.direction}, {"start", to_json(curve.start)},
                  {"curvature", curve.curvature}, {"length", curve.length}};
        } else if constexpr (std::is_same_v<C, Turn>) {
          return {{"kind", "turn"}, {"direction", piece.direction}, {"at", to_json(curve.at)}, {"from", curve.from},
                  {"angle", curve.angle}};
        } else if constexpr (std::is_same_v<C, PoseSequence>) {
          Json poses = Json::array();
          for (const Pose& p : curve.poses) poses.push_back(to_json(p));
          return {{"kind", "poses"}, {"direction", piece.direction}, {"poses", std::move(poses)}};
        } else {
          Json spans = Json::array();
          for (const BezierSpan& span : curve.spans) {
            Json points = Json::array();
            for (std::size_t i = 0; i <= static_cast<std::size_t>(span.degree); ++i) points.push_back(to_json(span.control[i]));
            spans.push_back(std::move(points));
          }
          return {{"kind", kind_of(curve.kind)}, {"direction", piece.direction}, {"spans", std::move(spans)}};
        }
      },
      piece.curve);
}

template <class Get>
Json column(const std::vector<Sample>& samples, Get get) {
  Json values = Json::array();
  for (const Sample& s : samples) values.push_back(get(s));
  return values;
}

Json samples_to_json(const std::vector<Sample>& samples) {
  return {{"s", column(samples, [](const Sample& s) { return s.s; })},
          {"x", column(samples, [](const Sample& s) { return s.x; })},
          {"y", column(samples, [](const Sample& s) { return s.y; })},
          {"heading", column(samples, [](const Sample& s) { return s.heading; })},
          {"course", column(samples, [](const Sample& s) { return s.course; })},
          {"curvature", column(samples, [](const Sample& s) { return s.curvature; })},
          {"direction", column(samples, [](const Sample& s) { return s.direction; })},
          {"t", column(samples, [](const Sample& s) { return s.t; })},
          {"speed", column(samples, [](const Sample& s) { return s.speed; })}};
}

struct MetricField {
  const char* name;
  double Metrics::* value;
};
constexpr MetricField metric_fields[] = {
    {"length", &Metrics::length},
    {"min_clearance", &Metrics::min_clearance},
    {"mean_clearance", &Metrics::mean_clearance},
    {"max_curvature", &Metrics::max_curvature},
    {"max_curvature_rate", &Metrics::max_curvature_rate},
    {"curvature_change", &Metrics::curvature_change},
    {"curvature_change_printed", &Metrics::curvature_change_printed},
    {"turning", &Metrics::turning},
    {"collision_risk", &Metrics::collision_risk},
    {"travel_time", &Metrics::travel_time},
};

Json metrics_to_json(const Metrics& metrics) {
  Json j = Json::object();
  for (const MetricField& field : metric_fields) {
    // A cusp has no finite curvature; a figure that does not exist is left out rather than written wrongly.
    if (std::isfinite(metrics.*field.value)) j[field.name] = metrics.*field.value;
  }
  j["direction_changes"] = metrics.direction_changes;
  return j;
}

Json certificate_to_json(const Certificate& c) {
  Json j{{"collision_free", c.collision_free}, {"clearance", c.clearance}, {"tolerance", c.tolerance},
         {"checked_length", c.checked_length}};
  if (c.tightest) {
    j["tightest"] = {{"pose", to_json(*c.tightest)}, {"point", to_json(c.tightest_point)}, {"obstacle", c.tightest_obstacle}};
  }
  return j;
}

Json alternatives_to_json(const std::vector<Alternative>& alternatives) {
  Json list = Json::array();
  for (const Alternative& a : alternatives) {
    Json j{{"name", a.name}, {"chosen", a.chosen}};
    j["cost"] = a.cost && std::isfinite(*a.cost) ? Json(*a.cost) : Json(nullptr);
    j["outcome"] = a.outcome;
    list.push_back(std::move(j));
  }
  return list;
}

// Reading.

int read_direction(const Node& node) { return static_cast<int>(node.at("direction").integer(-1, 1)); }

std::vector<Pose> read_poses(const Node& node) {
  std::vector<Pose> poses;
  for (const Node& p : node.elements()) {
    poses.push_back(p.pose());
    if (node.failed()) break;
  }
  return poses;
}

Spline read_spline(const Node& node, SplineKind kind) {
  Spline spline{kind, {}};
  for (const Node& points : node.at("spans").elements()) {
    const std::size_t count = points.is_array() ? points.json().size() : 0;
    if (count < 2 || count > 6) {
      points.fail(fmt::format("a span has {} control points", count), "2 to 6 points [x, y]");
      return spline;
    }
    BezierSpan span;
    span.degree = static_cast<int>(count) - 1;
    for (std::size_t i = 0; i < count; ++i) span.control[i] = points.at(i).point();
    spline.spans.push_back(span);
    if (node.failed()) return spline;
  }
  if (spline.spans.empty()) node.at("spans").fail("a spline needs at least one span");
  return spline;
}

Piece read_piece(const Node& node) {
  Piece piece;
  const std::string kind = node.at("kind").text();
  if (node.failed()) return piece;
  if (kind == "line") {
    if (node.is_object_of({"kind", "direction", "from", "to"})) piece.curve = Line{node.at("from").point(), node.at("to").point()};
  } else if (kind == "arc") {
    if (node.is_object_of({"kind", "direction", "start", "curvature", "length"})) {
      piece.curve = Arc{node.at("start").pose(), node.at("curvature").number(-1e6, 1e6), node.at("length").number_above(0.0, 1e7)};
    }
  } else if (kind == "turn") {
    if (node.is_object_of({"kind", "direction", "at", "from", "angle"})) {
      piece.curve = Turn{node.at("at").point(), node.at("from").number(-1e6, 1e6), node.at("angle").number(-1e3, 1e3)};
    }
  } else if (kind == "poses") {
    if (node.is_object_of({"kind", "direction", "poses"})) piece.curve = PoseSequence{read_poses(node.at("poses"))};
  } else if (kind == "natural_cubic_spline" || kind == "quintic_spline") {
    if (node.is_object_of({"kind", "direction", "spans"})) {
      piece.curve = read_spline(node, kind == "quintic_spline" ? SplineKind::quintic : SplineKind::natural_cubic);
    }
  } else {
    node.at("kind").fail(fmt::format("\"{}\" is not known", kind.substr(0, 40)),
                         "line, arc, turn, poses, natural_cubic_spline, quintic_spline");
  }
  if (!node.failed()) piece.direction = read_direction(node);
  return piece;
}

std::vector<Sample> read_samples(const Node& node) {
  std::vector<Sample> samples;
  if (!node.is_object_of({"s", "x", "y", "heading", "course", "curvature", "direction", "t", "speed"})) return samples;
  const Node s = node.at("s");
  if (!s.is_array()) {
    s.fail("it is not an array", "an array of numbers");
    return samples;
  }
  samples.resize(s.json().size());
  const auto read = [&](const char* name, auto set) {
    const Node values = node.at(name);
    if (node.failed()) return;
    if (!values.is_array() || values.json().size() != samples.size()) {
      return values.fail("it is not an array as long as s", fmt::format("{} numbers", samples.size()));
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Json& value = values.json()[i];
      if (!value.is_number()) return values.at(i).fail("it is not a number", "a number");
      set(samples[i], value.get<double>());
    }
  };
  read("s", [](Sample& x, double v) { x.s = v; });
  read("x", [](Sample& x, double v) { x.x = v; });
  read("y", [](Sample& x, double v) { x.y = v; });
  read("heading", [](Sample& x, double v) { x.heading = v; });
  read("course", [](Sample& x, double v) { x.course = v; });
  read("curvature", [](Sample& x, double v) { x.curvature = v; });
  read("direction", [](Sample& x, double v) { x.direction = v > 0.5 ? 1 : v < -0.5 ? -1 : 0; });
  read("t", [](Sample& x, double v) { x.t = v; });
  read("speed", [](Sample& x, double v) { x.speed = v; });
  // The pieces are not named in the file: a new one begins where a pose stands twice.
  for (std::size_t i = 1; i < samples.size(); ++i) {
    samples[i].piece = samples[i - 1].piece + (samples[i].s == samples[i - 1].s ? 1 : 0);
  }
  return samples;
}

Metrics read_metrics(const Node& node) {
  Metrics metrics;
  if (!node.is_object_of({"length", "min_clearance", "mean_clearance", "max_curvature", "max_curvature_rate", "curvature_change",
                          "curvature_change_printed", "turning", "direction_changes", "collision_risk", "travel_time"})) {
    return metrics;
  }
  for (const MetricField& field : metric_fields) {
    if (node.has(field.name)) metrics.*field.value = node.at(field.name).number(-1e300, 1e300);
  }
  metrics.direction_changes = static_cast<int>(node.at("direction_changes").integer(0, 1'000'000'000));
  return metrics;
}

Certificate read_certificate(const Node& node) {
  Certificate c;
  if (!node.is_object_of({"collision_free", "clearance", "tolerance", "checked_length", "tightest"})) return c;
  c.collision_free = node.at("collision_free").boolean();
  c.clearance = node.at("clearance").number(0.0, 1e7);
  c.tolerance = node.at("tolerance").number(0.0, 1e3);
  c.checked_length = node.at("checked_length").number(0.0, 1e9);
  if (node.has("tightest")) {
    const Node tightest = node.at("tightest");
    if (tightest.is_object_of({"pose", "point", "obstacle"})) {
      c.tightest = tightest.at("pose").pose();
      c.tightest_point = tightest.at("point").point();
      c.tightest_obstacle = tightest.at("obstacle").text();
    }
  }
  return c;
}

Plan read_plan_node(const Node& node) {
  Plan plan;
  if (!node.is_object_of({"format", "version", "status", "reason", "reproducible", "scenario", "planner", "seed", "timing", "effort",
                          "path", "metrics", "certificate", "explanation", "meta"})) {
    return plan;
  }
  check_format(node, "plan");
  if (node.failed()) return plan;
  plan.version = node.at("version").text();
  const std::string word = node.at("status").text();
  if (const auto status = status_from_string(word)) {
    plan.status = *status;
  } else if (!node.failed()) {
    node.at("status").fail(fmt::format("\"{}\" is not known", word.substr(0, 40)), "solved, unproven, no_path, …");
  }
  if (node.has("reason")) plan.reason = node.at("reason").text();
  if (node.has("reproducible")) plan.reproducible = node.at("reproducible").boolean();
  if (node.failed()) return plan;
  plan.scenario = read_scenario_node(node.at("scenario"), {});
  if (node.failed()) return plan;
  const Node planner = node.at("planner");
  if (planner.is_object_of({"name", "parameters"})) plan.planner = planner.at("name").text();
  plan.parameters = plan.scenario.planner.parameters;
  if (node.has("seed")) plan.seed = static_cast<std::uint64_t>(node.at("seed").integer(0, INT64_MAX));
  if (node.has("effort") && node.at("effort").has("evaluations")) {
    plan.effort.evaluations = node.at("effort").at("evaluations").integer(0, INT64_MAX);
  }
  if (node.has("path")) {
    const Node path = node.at("path");
    if (!path.is_object_of({"pieces", "samples"})) return plan;
    for (const Node& piece : path.at("pieces").elements()) {
      plan.path.pieces.push_back(read_piece(piece));
      if (node.failed()) return plan;
    }
    plan.samples = read_samples(path.at("samples"));
  }
  if (node.failed()) return plan;
  if (node.has("metrics")) plan.metrics = read_metrics(node.at("metrics"));
  if (node.has("certificate")) plan.certificate = read_certificate(node.at("certificate"));
  if (node.has("explanation")) {
    for (const Node& sentence : node.at("explanation").elements()) plan.explanation.push_back(sentence.text());
  }
  return plan;
}

}  // namespace

std::string plan_json(const Plan& plan) {
  Json j{{"format", "waywright-plan/1"}, {"version", plan.version}, {"status", to_string(plan.status)}};
  j["reason"] = plan.reason.empty() ? Json(nullptr) : Json(plan.reason);
  j["reproducible"] = plan.reproducible;
  Scenario used = plan.scenario;
  used.planner.name = plan.planner;
  used.planner.parameters = plan.parameters;
  j["scenario"] = scenario_to_json(used);
  j["planner"] = {{"name", plan.planner}, {"parameters", parameters_to_json(plan.parameters)}};
  j["seed"] = plan.seed;
  j["timing"] = {{"load", plan.timing.load}, {"prepare", plan.timing.prepare}, {"plan", plan.timing.plan}, {"prove", plan.timing.prove}};
  j["effort"] = {{"evaluations", plan.effort.evaluations}};
  if (plan.path.pieces.empty()) {
    j["path"] = j["metrics"] = j["certificate"] = nullptr;
  } else {
    Json pieces = Json::array();
    for (const Piece& piece : plan.path.pieces) pieces.push_back(piece_to_json(piece));
    j["path"] = {{"pieces", std::move(pieces)}, {"samples", samples_to_json(plan.samples)}};
    j["metrics"] = metrics_to_json(plan.metrics);
    j["certificate"] = certificate_to_json(plan.certificate);
  }
  j["explanation"] = plan.explanation;
  j["meta"] = {{"alternatives", alternatives_to_json(plan.alternatives)}};
  return pretty(j);
}

Parsed<Plan> parse_plan(const std::string& text, const std::string& name) {
  auto json = parse_json(text, name);
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{name, {}, 0};
  Plan plan = read_plan_node(Node{*json, "", context});
  if (context.error) return tl::unexpected{*context.error};
  return plan;
}

Parsed<Plan> read_plan(const std::filesystem::path& file) {
  auto text = read_file(file, largest_plan);
  if (!text) return tl::unexpected{text.error()};
  return parse_plan(*text, file.string());
}

}  // namespace waywright
