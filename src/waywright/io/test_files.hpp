// For the tests beside it: a folder of its own for each test, a scenario with every field, and fingerprints
// that tell two values apart by a single bit without going through the writers under test.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>

#include "waywright/judge/plan.hpp"

namespace waywright::test {

class Folder {
 public:
  Folder() {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() / fmt::format("waywright-io-{}-{}", ::getpid(), count++);
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream{path_ / name, std::ios::binary} << content;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// Every field that a scenario can have, with values that are not the defaults.
inline const char* const full_scenario = R"({
  "format": "waywright-scenario/1", "name": "dock at shelf 3 \u00e4\ud83d\ude9a", "meta": {"any": [1, 2.50, {"thing": null}], "n": 1.0},
  "map": {
    "polygons": {"boundaries": [[[0,0],[12,0],[12,10],[0,10]], [[-1,-1],[13,-1],[13,11],[-1,11]]],
                 "obstacles": [[[4,4],[5,4],[5,5]]], "lines": [[[1,1],[1,3],[0.1,1e-300]]], "points": [[2.0,3.1],[0.30000000000000004,-0.0]]},
    "cells": [{"name": "racks", "columns": 3, "rows": 2, "cell": 0.05, "origin": [1.5, 2.5, 0.1], "bounds": false, "runs": [0,2,1,3,2,1]}],
    "transform": [0.25, 0.5, 0.0], "obstacles": [[[6,6],[7,6],[7,7],[6,7]]],
    "overlay": [{"polygons": {"points": [[9,9]]}, "align": [[[0,0],[1,0]],[[1,0],[1,1.01]]]}]
  },
  "vehicle": {
    "name": "forklift", "footprint": [[-0.5,-0.5],[1.9,-0.5],[1.9,0.5],[-0.5,0.5]], "forks": [[0.7,-0.3],[1.9,-0.3],[1.9,0.3],[0.7,0.3]],
    "loads": {"pallet": {"footprint": [[0.7,-0.6],[1.9,-0.6],[1.9,0.6],[0.7,0.6]], "mass": 500}, "drum": {"footprint": {"disc": 0.4}}},
    "mass": 2400, "drive": {"type": "tricycle", "wheelbase": 1.3, "max_steering": 1.2, "max_steering_rate": 0.9, "steered_axle": "front"},
    "limits": {"speed": 2.0, "reverse_speed": 1.5, "acceleration": 0.4, "deceleration": 0.6, "lateral_acceleration": 0.7,
               "angular_speed": 0.8, "angular_acceleration": 1.1, "curvature": 0.66, "curvature_rate": 1.3},
    "control_point": [0.1, 0.0, 0.2]
  },
  "start": {"pose": [2, 8, 7.0], "speed": 0, "curvature": 0.0},
  "station": {"area": [[1,1],[11,1],[11,9],[1,9]], "manoeuvre": "dock",
              "shelf": {"center": [10.0, 5.0], "heading": -3.14159, "size": [1.0, 2.0], "gap": 0.12, "slot": -0.3}},
  "clearance": 0.05, "pose_error": {"lateral": 0.01, "longitudinal": 0.02, "heading": 0.005}, "moving": [],
  "zones": [{"type": "forbidden", "name": "charging \u00e4", "area": [[1,1],[2,1],[2,2],[1,2]]}, {"type": "directed", "area": [[3,1],[4,1],[4,2]], "direction": 7.0},
            {"type": "preferred", "area": [[5,1],[6,1],[6,2]], "factor": 0.30000000000000004}, {"type": "penalty", "area": [[7,1],[8,1],[8,2]], "factor": 12.5},
            {"type": "speed_limit", "name": "crossing", "area": [[9,1],[10,1],[10,2]], "speed": 0.4}],
  "budget": {"evaluations": 1000, "expansions": 2e3, "samples": 3000, "seconds": 12.5},
  "planner": {"name": "pattern_docking", "optimizer": "de", "population": 20, "polish": true, "weight": 0.1}, "seed": 9223372036854775807
})";

/// The least that a scenario can be.
inline const char* const least_scenario = R"({
  "format": "waywright-scenario/1", "map": {"polygons": {}},
  "vehicle": {"footprint": {"disc": 0}, "drive": {"type": "differential", "track": 0.5}}, "start": [0, 0, 0], "goal": [1, 0, 0]
})";

class Fingerprint {
 public:
  std::string text;

  void add(double v) { text += fmt::format("{:a} ", v); }
  void add(int v) { text += fmt::format("{} ", v); }
  void add(std::int64_t v) { text += fmt::format("{} ", v); }
  void add(std::uint64_t v) { text += fmt::format("{} ", v); }
  void add(bool v) { text += v ? "yes " : "no "; }
  void add(const std::string& v) { text += "\"" + v + "\" "; }
  void add(Vec2 p) { add_all(p.x, p.y); }
  void add(const Pose& p) { add_all(p.x, p.y, p.heading); }
  template <class T>
  void add(const std::optional<T>& v) {
    if (v)
      add(*v);
    else
      text += "none ";
  }
  template <class T>
  void add(const std::vector<T>& list) {
    add_list(list);
  }
  void add(const Pieces& pieces) { add_list(pieces); }
  void add(const Spans& spans) { add_list(spans); }
  void add(const CellGrid& g) {
    add_all(g.name, g.columns, g.rows, g.cell, g.origin, g.bounds);
    for (const std::uint8_t c : g.blocked) add(static_cast<int>(c));
  }
  void add(const Alignment& a) { add_all(a.transform, a.residuals); }
  void add(const Map& m) {
    add_all(m.boundaries, m.obstacles, m.lines, m.points, m.grids, m.alignment, m.notes);
  }
  void add(const Footprint& f) { add_all(f.polygon, f.disc); }
  void add(const Drive& drive) {
    add(static_cast<int>(drive.index()));
    if (const auto* t = std::get_if<Tricycle>(&drive)) {
      add_all(t->wheelbase, t->max_steering, t->max_steering_rate, t->steered_axle == SteeredAxle::front);
    } else if (const auto* d = std::get_if<Differential>(&drive)) {
      add(d->track);
    } else {
      const auto& m = std::get<Mecanum>(drive);
      add_all(m.wheel_radius, m.half_length, m.half_width, m.max_wheel_speed, m.max_torque, m.wheel_inertia, m.rolling_arm);
    }
  }
  void add(const Vehicle& v) {
    add_all(v.name, v.footprint, v.forks, v.mass, v.drive, v.control_point);
    for (const auto& [name, load] : v.loads) add_all(name, load.footprint, load.mass);
    const Limits& l = v.limits;
    add_all(l.speed, l.reverse_speed, l.acceleration, l.deceleration, l.lateral_acceleration, l.angular_speed,
            l.angular_acceleration, l.curvature, l.curvature_rate);
  }
  void add(const Parameters& parameters) {
    for (const auto& [name, value] : parameters) {
      add(name);
      add(static_cast<int>(value.index()));
      std::visit([this](const auto& v) { add(v); }, value);
    }
  }
  void add(const Zone& z) { add_all(static_cast<int>(z.type), z.name, z.area, z.direction, z.factor, z.speed); }
  void add(const Mission& mission) {
    if (const auto* station = std::get_if<Station>(&mission)) {
      const Shelf& f = station->shelf;
      add_all(station->area, f.center, f.heading, f.depth, f.width, f.gap, f.slot);
    } else if (const auto* free = std::get_if<FreeGoal>(&mission)) {
      add(free->area);
    } else {
      add(std::get<Pose>(mission));
    }
  }
  void add(const PlannerChoice& c) { add_all(c.name, c.parameters); }
  void add(const Leg& l) { add_all(l.name, l.mission, l.exit, l.waypoints, l.waypoint_radius, l.load, l.planner); }
  void add(const Scenario& s) {
    add(s.zones);
    add_all(s.name, s.meta, s.map, s.map_source, s.vehicle, s.start, s.mission);
    add_all(s.legs, static_cast<int>(s.order), s.waypoints);
    add_all(s.clearance, s.pose_error.lateral, s.pose_error.longitudinal, s.pose_error.heading,
            s.budget.evaluations, s.budget.expansions, s.budget.samples, s.budget.seconds, s.planner.name,
            s.planner.parameters, s.seed);
  }
  void add(const BezierSpan& span) {
    add(span.degree);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(span.degree); ++i) add(span.control[i]);
  }
  void add(const Line& c) { add_all(c.from, c.to); }
  void add(const Arc& c) { add_all(c.start, c.curvature, c.length); }
  void add(const Clothoid& c) { add_all(c.start, c.curvature, c.curvature_rate, c.length); }
  void add(const Turn& c) { add_all(c.at, c.from, c.angle); }
  void add(const PoseSequence& c) { add(c.poses); }
  void add(const Spline& c) { add_all(static_cast<int>(c.kind), c.spans); }
  void add(const Piece& p) {
    add_all(p.direction, static_cast<int>(p.curve.index()));
    std::visit([this](const auto& c) { add(c); }, p.curve);
  }
  void add(const Sample& s) {
    add_all(s.s, s.x, s.y, s.heading, s.course, s.curvature, s.direction, s.t, s.speed);
  }
  void add(const Alternative& a) { add_all(a.name, a.chosen, a.cost, a.outcome); }
  void add(const Plan& p) {
    add_all(p.version, std::string{to_string(p.status)}, p.reason, p.reproducible, p.scenario, p.planner,
            p.parameters, p.seed);
    add_all(p.timing.load, p.timing.prepare, p.timing.plan, p.timing.prove, p.effort.evaluations, p.effort.expansions,
            p.path.pieces, p.samples);
    const Metrics& m = p.metrics;
    add_all(m.length, m.min_clearance, m.mean_clearance, m.max_curvature, m.max_curvature_rate,
            m.curvature_change, m.curvature_change_printed, m.turning, m.direction_changes, m.collision_risk,
            m.travel_time);
    const Certificate& c = p.certificate;
    add_all(c.collision_free, c.clearance, c.tolerance, c.checked_length, c.tightest, c.tightest_point,
            p.tightest_obstacle);
    add_all(p.explanation, p.alternatives);
    for (const LegResult& l : p.legs) {
      add_all(l.name, l.load, l.planner, l.parameters, std::string{to_string(l.status)}, l.reason, l.start, l.end, l.has_path, static_cast<std::uint64_t>(l.pieces),
              static_cast<std::uint64_t>(l.samples), l.metrics.length, l.metrics.mean_clearance, l.certificate.clearance, l.certificate.checked_length, l.tightest_obstacle);
    }
  }

 private:
  template <class List>
  void add_list(const List& list) {
    text += fmt::format("[{}: ", list.size());
    for (const auto& v : list) add(v);
    text += "]\n";
  }
  template <class... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }
};

template <class T>
std::string fingerprint(const T& value) {
  Fingerprint f;
  f.add(value);
  return f.text;
}

}  // namespace waywright::test
