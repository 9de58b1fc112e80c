// The judged result as plan.json.
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "waywright/io/plan_io.hpp"
#include "waywright/io/plan_json.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

Json curve_to_json(const Piece& piece) {
  return std::visit(
      [&](const auto& curve) -> Json {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Line>) {
          return {{"kind", "line"},
                  {"direction", piece.direction},
                  {"from", to_json(curve.from)},
                  {"to", to_json(curve.to)}};
        } else if constexpr (std::is_same_v<C, Arc>) {
          return {{"kind", "arc"},
                  {"direction", piece.direction},
                  {"start", to_json(curve.start)},
                  {"curvature", curve.curvature},
                  {"length", curve.length}};
        } else if constexpr (std::is_same_v<C, Clothoid>) {
          return {{"kind", "clothoid"},
                  {"direction", piece.direction},
                  {"start", to_json(curve.start)},
                  {"curvature", curve.curvature},
                  {"curvature_rate", curve.curvature_rate},
                  {"length", curve.length}};
        } else if constexpr (std::is_same_v<C, Turn>) {
          return {{"kind", "turn"},
                  {"direction", piece.direction},
                  {"at", to_json(curve.at)},
                  {"from", curve.from},
                  {"angle", curve.angle}};
        } else if constexpr (std::is_same_v<C, PoseSequence>) {
          Json poses = Json::array();
          for (const Pose& p : curve.poses) poses.push_back(to_json(p));
          return {{"kind", "poses"}, {"direction", piece.direction}, {"poses", std::move(poses)}};
        } else {
          Json spans = Json::array();
          for (const BezierSpan& span : curve.spans) {
            Json points = Json::array();
            for (std::size_t i = 0; i <= static_cast<std::size_t>(span.degree); ++i)
              points.push_back(to_json(span.control[i]));
            spans.push_back(std::move(points));
          }
          return {{"kind", word_of(curve.kind)}, {"direction", piece.direction}, {"spans", std::move(spans)}};
        }
      },
      piece.curve);
}

Json piece_to_json(const Piece& piece) {
  Json j = curve_to_json(piece);
  if (piece.heading) j["heading"] = {{"from", piece.heading->from}, {"turn", piece.heading->turn}};
  return j;
}

/// A cusp's curvature has no number in JSON: the greatest there is stands for it.
double written(double value) {
  constexpr double most = std::numeric_limits<double>::max();
  return std::isnan(value) ? 0.0 : std::clamp(value, -most, most);
}

template <class Get>
Json column(const std::vector<Sample>& samples, Get get) {
  Json values = Json::array();
  for (const Sample& s : samples) values.push_back(get(s));
  return values;
}

Json samples_to_json(const std::vector<Sample>& samples) {
  Json j = Json::object();
  for (const SampleColumn& c : sample_columns) {
    j[c.name] = column(samples, [&](const Sample& s) { return written(s.*c.value); });
    // Where the contract's example has it: between curvature and t.
    if (c.value == &Sample::curvature)
      j["direction"] = column(samples, [](const Sample& s) { return s.direction; });
  }
  return j;
}

Json metrics_to_json(const Metrics& metrics) {
  Json j = Json::object();
  for (const MetricField& field : metric_fields) {
    // A figure that does not exist is left out rather than written wrongly.
    if (std::isfinite(metrics.*field.value)) j[field.name] = metrics.*field.value;
  }
  j["direction_changes"] = metrics.direction_changes;
  return j;
}

Json certificate_to_json(const Certificate& c, const std::string& obstacle) {
  Json j{{"collision_free", c.collision_free},
         {"clearance", written(c.clearance)},
         {"tolerance", c.tolerance},
         {"checked_length", c.checked_length}};
  if (c.pocket_clearance) j["pocket_clearance"] = written(*c.pocket_clearance);
  if (c.tightest) {
    j["tightest"] = {{"pose", to_json(*c.tightest)},
                     {"point", to_json(c.tightest_point)},
                     {"obstacle", obstacle}};
  }
  return j;
}

Json effort_to_json(const Effort& effort) {
  Json j{{"evaluations", effort.evaluations}};
  if (effort.expansions > 0) j["expansions"] = effort.expansions;
  return j;
}

Json leg_to_json(const LegResult& leg) {
  return {{"name", leg.name},
          {"load", leg.load.empty() ? Json(nullptr) : Json(leg.load)},
          {"planner", {{"name", leg.planner}, {"parameters", parameters_to_json(leg.parameters)}}},
          {"status", to_string(leg.status)},
          {"reason", leg.reason.empty() ? Json(nullptr) : Json(leg.reason)},
          {"start", to_json(leg.start)},
          {"end", to_json(leg.end)},
          {"pieces", leg.pieces},
          {"samples", leg.samples},
          {"effort", effort_to_json(leg.effort)},
          {"metrics", leg.has_path ? metrics_to_json(leg.metrics) : Json(nullptr)},
          {"certificate", leg.has_path ? certificate_to_json(leg.certificate, leg.tightest_obstacle) : Json(nullptr)}};
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

}  // namespace

std::string plan_json(const Plan& plan) {
  Json j{{"format", "waywright-plan/1"}, {"version", plan.version}, {"status", to_string(plan.status)}};
  j["reason"] = plan.reason.empty() ? Json(nullptr) : Json(plan.reason);
  j["reproducible"] = plan.reproducible;
  Scenario used = plan.scenario;
  // Who was not asked by the scenario (imported poses, outside planners) leaves its choice as it is.
  if (used.planner.name == plan.planner) used.planner = {plan.planner, plan.parameters};
  j["scenario"] = scenario_to_json(used);
  j["planner"] = {{"name", plan.planner}, {"parameters", parameters_to_json(plan.parameters)}};
  j["seed"] = plan.seed;
  j["timing"] = {{"load", plan.timing.load},
                 {"prepare", plan.timing.prepare},
                 {"plan", plan.timing.plan},
                 {"prove", plan.timing.prove}};
  j["effort"] = effort_to_json(plan.effort);
  if (!plan.legs.empty()) {
    Json legs = Json::array();
    for (const LegResult& leg : plan.legs) legs.push_back(leg_to_json(leg));
    j["legs"] = std::move(legs);
  }
  if (plan.path.pieces.empty()) {
    j["path"] = j["metrics"] = j["certificate"] = nullptr;
  } else {
    Json pieces = Json::array();
    for (const Piece& piece : plan.path.pieces) pieces.push_back(piece_to_json(piece));
    j["path"] = {{"pieces", std::move(pieces)}, {"samples", samples_to_json(plan.samples)}};
    j["metrics"] = metrics_to_json(plan.metrics);
    j["certificate"] = certificate_to_json(plan.certificate, plan.tightest_obstacle);
  }
  j["explanation"] = plan.explanation;
  j["meta"] = {{"alternatives", alternatives_to_json(plan.alternatives)}};
  if (const auto& o = plan.optimality) {
    j["meta"]["optimality"] = {{"cost", o->cost}, {"lower_bound", o->lower_bound}, {"gap", o->gap()}, {"boxes", o->boxes}};
  }
  if (const auto& o = plan.order) {
    j["meta"]["order"] = {{"given_as", o->given_as},        {"length", o->length},      {"length_as_given", o->given_length ? Json(*o->given_length) : Json(nullptr)},
                          {"lower_bound", o->lower_bound},  {"gap", o->gap()},          {"exact", o->is_exact},
                          {"ways_planned", o->ways},        {"ways_missing", o->ways_missing}};
  }
  return pretty(j);
}

}  // namespace waywright
