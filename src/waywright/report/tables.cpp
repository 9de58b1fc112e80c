#include "waywright/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/metrics/metrics.hpp"
#include "waywright/report/spots.hpp"
#include "waywright/report/svg_writer.hpp"
#include "waywright/report/words.hpp"

namespace waywright {
namespace {

constexpr std::size_t most_zone_rows = 30;

std::string zone_words(const Zone& zone) {
  switch (zone.type) {
    case ZoneType::forbidden: return "forbidden";
    case ZoneType::directed: return fmt::format("one way, {:.1f}°", zone.direction * 180.0 / pi);
    case ZoneType::preferred: return fmt::format("preferred, a metre costs {:g} m", zone.factor);
    case ZoneType::penalty: return fmt::format("penalty, a metre costs {:g} m", zone.factor);
    case ZoneType::speed_limit: return fmt::format("at most {:g} m/s", zone.speed);
  }
  return "";
}

struct Row {
  std::string name, value, remark;
};

/// The remark stands below its value, so that a narrow column does not break a number from its unit.
std::string table(const std::vector<Row>& rows) {
  std::string out = "<table>\n";
  for (const Row& r : rows) {
    const std::string remark =
        r.remark.empty() ? "" : fmt::format("<span class=\"soft\">{}</span>", escaped(r.remark));
    out += fmt::format("<tr><th scope=\"row\">{}</th><td>{}{}</td></tr>\n", escaped(r.name), escaped(r.value),
                       remark);
  }
  return out + "</table>\n";
}

std::string with_limit(double value, std::optional<double> limit, const char* unit) {
  if (!limit || !std::isfinite(*limit)) return "";
  return fmt::format("limit {} {}, {:.0f} % used", fixed(*limit, 3), unit, 100.0 * value / *limit);
}

std::string motion_words(const StartMotion& motion) {
  if (motion.speed == 0.0) return {};
  if (motion.course) {
    return fmt::format("moving with a course of {:.4f} rad at {:.2f} m/s, curvature {:.3f} 1/m, turning {:.3f} rad/s", *motion.course, motion.speed, motion.curvature, motion.angular_velocity);
  }
  return fmt::format("moving {} at {:.2f} m/s, curvature {:.3f} 1/m", motion.speed < 0.0 ? "backwards" : "forwards", std::abs(motion.speed), motion.curvature);
}

std::string pose_words(const Pose& p) {
  return fmt::format("({:.3f}, {:.3f}), {:.4f} rad ({:.2f}°)", p.x, p.y, p.heading, p.heading * 180.0 / pi);
}

Row clearance_row(const Plan& plan) {
  const PoseError& e = plan.scenario.pose_error;
  const std::string asked =
      fmt::format("{} m asked for{}", fixed(plan.scenario.clearance, 4),
                  e.lateral + e.longitudinal + e.heading > 0.0 ? ", pose error taken off" : "");
  if (!plan.certificate.collision_free)
    return {"Proven clearance", "none", "the path touches or may touch something; " + asked};
  return {plan.status == Status::solved ? "Proven clearance" : "Clearance (path not proven)",
          clearance_words(plan.certificate), asked};
}

std::string drive_words(const Vehicle& vehicle) {
  if (const auto* t = std::get_if<Tricycle>(&vehicle.drive)) {
    return fmt::format("tricycle, {} axle steered, wheelbase {} m, steering to {:.1f}°",
                       t->steered_axle == SteeredAxle::rear ? "rear" : "front", fixed(t->wheelbase, 3),
                       t->max_steering * 180.0 / pi);
  }
  if (const auto* d = std::get_if<Differential>(&vehicle.drive))
    return fmt::format("differential, track {} m", fixed(d->track, 3));
  return "mecanum";
}

std::string footprint_words(const Footprint& footprint) {
  if (footprint.is_disc()) return fmt::format("disc of radius {} m", fixed(footprint.disc, 3));
  const Box box = bounding_box(footprint.polygon);
  return fmt::format("{} corners, {} × {} m, from {} m behind to {} m before the origin",
                     footprint.polygon.size(), fixed(box.high.x - box.low.x, 3),
                     fixed(box.high.y - box.low.y, 3), fixed(-box.low.x, 3), fixed(box.high.x, 3));
}

std::string waypoint_words(const std::vector<Vec2>& waypoints) {
  constexpr std::size_t most_told = 40;
  std::string text;
  for (std::size_t i = 0; i < waypoints.size() && i < most_told; ++i)
    text += fmt::format("{}{}: ({}, {})", i == 0 ? "" : ", ", i + 1, fixed(waypoints[i].x, 3), fixed(waypoints[i].y, 3));
  if (waypoints.size() > most_told) text += fmt::format(" … and {} more", waypoints.size() - most_told);
  return text;
}

std::string parameter_words(const Parameters& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters) {
    text += text.empty() ? "" : ", ";
    if (const auto* b = std::get_if<bool>(&value))
      text += fmt::format("{} {}", name, *b ? "true" : "false");
    else if (const auto* d = std::get_if<double>(&value))
      text += fmt::format("{} {}", name, *d);
    else
      text += fmt::format("{} {}", name, std::get<std::string>(value));
  }
  return text;
}

std::vector<Row> metric_rows(const Plan& plan, const std::optional<Row>& off_straight) {
  const Metrics& m = plan.metrics;
  const Scenario& s = plan.scenario;
  const auto capped = [](double clearance) { return clearance >= clearance_cap; };
  std::vector<Row> rows{clearance_row(plan)};
  if (plan.certificate.pocket_clearance)
    rows.push_back({"Forks to the pocket's sides",
                    fmt::format("{:.4f} m", *plan.certificate.pocket_clearance), "pose error taken off"});
  if (off_straight) rows.push_back(*off_straight);
  rows.push_back({"Least clearance at samples",
                  capped(m.min_clearance) ? fmt::format("more than {:g} m", clearance_cap)
                                          : fmt::format("{:.4f} m", m.min_clearance),
                  ""});
  rows.push_back({"Mean clearance",
                  fmt::format("{}{:.3f} m", capped(m.mean_clearance) ? "more than " : "", m.mean_clearance),
                  ""});
  rows.push_back({"Length", fmt::format("{:.3f} m", m.length), ""});
  rows.push_back({"Travel time", fmt::format("{:.1f} s", m.travel_time), ""});
  rows.push_back({"Changes of direction", fmt::format("{}", m.direction_changes), ""});
  if (const std::size_t stops = steering_stops(plan).size(); stops > 0)
    rows.push_back({"Stops where the curvature jumps", fmt::format("{}", stops), ""});
  rows.push_back({"Greatest curvature", fmt::format("{:.4f} 1/m", m.max_curvature),
                  with_limit(m.max_curvature, s.vehicle.max_curvature(), "1/m")});
  rows.push_back({"Greatest curvature rate", fmt::format("{:.4f} 1/m²", m.max_curvature_rate),
                  with_limit(m.max_curvature_rate, s.vehicle.limits.curvature_rate, "1/m²")});
  rows.push_back({"Change of curvature Σ|Δκ|", fmt::format("{:.3f} 1/m", m.curvature_change), ""});
  rows.push_back({"… as printed Σ|Δκ|/Δs", fmt::format("{:.2f} 1/m²", m.curvature_change_printed), ""});
  rows.push_back({"Turning", fmt::format("{:.3f} rad ({:.0f}°)", m.turning, m.turning * 180.0 / pi), ""});
  rows.push_back({"Collision risk", fmt::format("{:.3f} m", m.collision_risk), "∫ exp(−½(d/0.5 m)²) ds"});
  return rows;
}

/// @pre the mission is no station
std::string goal_words(const Mission& mission) {
  const auto* free = std::get_if<FreeGoal>(&mission);
  if (free == nullptr) return pose_words(std::get<Pose>(mission));
  if (free->is_point()) return fmt::format("({:.3f}, {:.3f}) with any heading", free->area.front().x, free->area.front().y);
  const Box box = bounding_box(free->area);
  return fmt::format("anywhere in a region of {} corners, x {:.3f} to {:.3f}, y {:.3f} to {:.3f} m, with any heading", free->area.size(), box.low.x, box.high.x, box.low.y, box.high.y);
}

std::string mission_words(const Leg& leg) {
  const auto* station = std::get_if<Station>(&leg.mission);
  if (station == nullptr) return "to " + goal_words(leg.mission);
  const Shelf& shelf = station->shelf;
  const std::string at = fmt::format("at the shelf at ({:.3f}, {:.3f}), slot {} m", shelf.center.x, shelf.center.y, fixed(shelf.slot, 3));
  if (station->manoeuvre == Manoeuvre::undock) return fmt::format("out of the pose {}, to {}", at, pose_words(leg.exit));
  return "to the pose " + at + (station->insertion ? ", forks in" : ", docked");
}

/// What stands in the scenario's table of every mission, below the mission.
void append_shared_rows(const Plan& plan, std::vector<Row>& rows) {
  const Scenario& s = plan.scenario;
  rows.push_back({"Clearance asked for", fmt::format("{} m", fixed(s.clearance, 4)), ""});
  rows.push_back({"Pose error",
                  fmt::format("{} m lateral, {} m longitudinal, {} rad ({:.2f}°) heading",
                              fixed(s.pose_error.lateral, 4), fixed(s.pose_error.longitudinal, 4),
                              fixed(s.pose_error.heading, 4), s.pose_error.heading * 180.0 / pi),
                  ""});
  if (plan.legs.empty()) rows.push_back({"Planner", plan.planner, parameter_words(plan.parameters)});
  for (std::size_t i = 0; i < plan.legs.size(); ++i)
    rows.push_back({fmt::format("Planner of leg {}", i + 1), plan.legs[i].planner, fmt::format("{}; {}", parameter_words(plan.legs[i].parameters), effort_words(plan.legs[i].effort))});
  rows.push_back({"Work", fmt::format("{}, seed {}", effort_words(plan.effort), plan.seed),
                  plan.reproducible ? "reproducible" : "cut short: another run may differ"});
  std::string map = fmt::format("{} obstacles, {} lines, {} points", s.map.obstacles.size(),
                                s.map.lines.size(), s.map.points.size());
  for (const CellGrid& g : s.map.grids)
    map += fmt::format(", {} ({} × {} cells of {} m)", g.name, g.columns, g.rows, fixed(g.cell, 4));
  rows.push_back({"Map", map, ""});
  if (s.map.alignment && !s.map.alignment->residuals.empty()) {
    rows.push_back({"Alignment residuals", residual_words(*s.map.alignment), ""});
  }
  for (std::size_t i = 0; i < s.zones.size() && i < most_zone_rows; ++i) rows.push_back({i == 0 ? "Zones" : "", title_of(s.zones[i], i), zone_words(s.zones[i])});
  if (s.zones.size() > most_zone_rows) rows.push_back({"", fmt::format("and {} more", s.zones.size() - most_zone_rows), ""});
  for (const std::string& note : s.map.notes) rows.push_back({"Noted", note, ""});
}

std::vector<Row> first_rows(const Scenario& s) {
  return {
      {"Vehicle", s.vehicle.name.empty() ? "(no name)" : s.vehicle.name, drive_words(s.vehicle)},
      {"Footprint", footprint_words(s.vehicle.footprint), ""},
      {"Start", pose_words(s.start), motion_words(s.start_motion)},
  };
}

}  // namespace

std::string metric_table(const Problem& problem, const Plan& plan) {
  const auto spot = tightest_off_straight(problem, plan);
  if (!spot) return metric_table(plan);
  return table(metric_rows(plan, Row{problem.is_driven_back() ? "Tightest after the first straight" : "Tightest before the final straight", fmt::format("{:.3f} m", spot->clearance),
                                     fmt::format("at samples, from {} at ({:.2f}, {:.2f})", spot->against, spot->point.x, spot->point.y)}));
}

std::string metric_table(const Plan& plan) { return table(metric_rows(plan, std::nullopt)); }
std::string scenario_table(const Problem& problem, const Plan& plan) {
  const Scenario& s = plan.scenario;
  std::vector<Row> rows = first_rows(s);
  if (const auto* station = std::get_if<Station>(&s.mission)) {
    const Pose& d = problem.goal();
    rows.push_back({"Docked pose", pose_words(d),
                    fmt::format("fork tips {} m before the face, slot {} m", fixed(station->shelf.gap, 3),
                                fixed(station->shelf.slot, 3))});
  } else {
    rows.push_back({"Goal", goal_words(s.mission), ""});
  }
  if (!s.waypoints.empty()) {
    rows.push_back({"Waypoints", waypoint_words(s.waypoints),
                    s.waypoint_radius > 0.0 ? fmt::format("passed in this order, each within {} m", fixed(s.waypoint_radius, 4)) : "passed in this order, each exactly"});
  }
  if (problem.pocket()) {
    const Pose& p = problem.pocket()->inner;
    rows.push_back({"Forks in the shelf", pose_words(p),
                    fmt::format("fork tips {} m behind the face",
                                fixed(std::get<Station>(s.mission).insertion->depth, 3))});
  }
  if (!s.carried_load.empty()) {
    const double mass = s.vehicle.loads.at(s.carried_load).mass;
    rows.push_back({"Load", s.carried_load,
                    fmt::format("{} kg{}; {}", fixed(mass, 1),
                                s.vehicle.mass > 0.0
                                    ? fmt::format(", {} kg with the vehicle", fixed(mass + s.vehicle.mass, 1))
                                    : "",
                                footprint_words(problem.footprint()))});
  }
  append_shared_rows(plan, rows);
  return table(rows);
}

std::string scenario_table(const Plan& plan) {
  std::vector<Row> rows = first_rows(plan.scenario);
  if (!plan.scenario.carried_load.empty()) rows.push_back({"Load at the beginning", plan.scenario.carried_load, ""});
  for (std::size_t i = 0; i < plan.scenario.legs.size(); ++i) {
    const Leg& leg = plan.scenario.legs[i];
    std::string change;
    if (leg.load) change = leg.load->empty() ? "; the load is left there" : fmt::format("; the load \"{}\" is taken there", *leg.load);
    rows.push_back({fmt::format("Leg {}{}", i + 1, leg.name.empty() ? "" : ", " + leg.name), mission_words(leg) + change, leg.waypoints.empty() ? "" : "through " + waypoint_words(leg.waypoints)});
  }
  append_shared_rows(plan, rows);
  return table(rows);
}

std::string legs_table(const Plan& plan) {
  const Scenario& s = plan.scenario;
  std::string out = "<h2>Legs</h2>\n<table><tr><th>leg</th><th>length</th><th>time</th><th>tightest</th><th>load</th><th>mass</th><th>planner</th></tr>\n";
  for (std::size_t i = 0; i < plan.legs.size(); ++i) {
    const LegResult& leg = plan.legs[i];
    const auto load = s.vehicle.loads.find(leg.load);
    const double mass = s.vehicle.mass + (load == s.vehicle.loads.end() ? 0.0 : load->second.mass);
    std::string tightest = to_string(leg.status);
    if (leg.has_path && leg.certificate.collision_free) {
      tightest = clearance_words(leg.certificate);
      if (!is_beyond_measure(leg.certificate))
        tightest += fmt::format("<span class=\"soft\">{} at ({:.2f}, {:.2f})</span>", escaped(leg.tightest_obstacle), leg.certificate.tightest_point.x, leg.certificate.tightest_point.y);
    }
    out += fmt::format("<tr><th scope=\"row\">{}{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td><td>{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n", i + 1,
                       leg.name.empty() ? "" : ". " + escaped(leg.name), leg.has_path ? fmt::format("{:.3f} m", leg.metrics.length) : "–",
                       leg.has_path ? fmt::format("{:.1f} s", leg.metrics.travel_time) : "–", tightest, leg.load.empty() ? "–" : escaped(leg.load),
                       mass > 0.0 ? fmt::format("{} kg", fixed(mass, 1)) : "–", escaped(leg.planner));
  }
  return out + "</table>\n<p class=\"soft\">Tightest: proven, pose error taken off. Mass: vehicle and load.</p>\n";
}

std::string alternatives_table(const Plan& plan) {
  if (plan.alternatives.empty()) return {};
  const bool any = std::any_of(plan.alternatives.begin(), plan.alternatives.end(),
                               [](const Alternative& a) { return a.cost.has_value(); });
  const bool is_length = std::all_of(plan.alternatives.begin(), plan.alternatives.end(), [](const Alternative& a) { return a.is_length || !a.cost; });
  std::string out =
      fmt::format("<h2>What was tried</h2>\n<table><tr><th>alternative</th>{}<th>outcome</th></tr>\n",
                  any ? is_length ? "<th>length</th>" : "<th>cost</th>" : "");
  for (const Alternative& a : plan.alternatives) {
    const std::string cost = !a.cost                   ? "–"
                             : a.is_length             ? fmt::format("{:.2f} m", *a.cost)
                                                       : fmt::format("{:.4f}", *a.cost);
    out += fmt::format("<tr{}><th scope=\"row\">{}{}</th>{}<td>{}</td></tr>\n",
                       a.chosen ? " class=\"chosen\"" : "", escaped(a.name), a.chosen ? " (taken)" : "",
                       any ? "<td class=\"number\">" + cost + "</td>" : "", escaped(a.outcome));
  }
  return out + "</table>\n";
}

}  // namespace waywright
