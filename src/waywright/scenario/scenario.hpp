// Map + vehicle + mission: one problem for every planner. Plain values; reading them from files is io/'s matter.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/map/map.hpp"
#include "waywright/scenario/moving_obstacle.hpp"
#include "waywright/scenario/zone.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// The certificate holds for every pose within this of the path. Metres and radians, ≥ 0, body frame.
struct PoseError {
  double lateral = 0.0;
  double longitudinal = 0.0;
  double heading = 0.0;
};

/// `heading` is where the loading face looks; size is [depth along heading, width across].
struct Shelf {
  Vec2 center{};
  double heading = 0.0;
  double depth = 0.0;  ///< m, > 0
  double width = 0.0;  ///< m, > 0
  double gap = 0.1;    ///< m between the face and the fork tips when docked
  double slot = 0.0;   ///< m along the face from its middle, left of heading positive

  /// Frame with its origin in the middle of the loading face, +x out of the shelf, +y to its left.
  Frame face() const { return Frame{make_pose(center + (0.5 * depth) * unit(heading), heading)}; }
  Ring outline() const;
  /// Docked pose of a vehicle whose footprint's greatest x is `front`.
  Pose docked(double front) const;
};

/// Forks go on into the shelf: straight, by gap + depth from the docked pose.
struct Insertion {
  struct Pocket {
    double right = 0.0, left = 0.0;  ///< m along the face from its middle, left of the shelf's heading positive; right < left
  };
  double depth = 0.0;           ///< m behind the face that the fork tips reach, > 0
  std::vector<Pocket> pockets;  ///< openings through the whole depth of the shelf; at least one
};

enum class Manoeuvre {
  dock,    ///< from the start to the shelf
  undock,  ///< from the shelf to the start, the way of docking driven back
};

struct Station {
  Ring area;  ///< the vehicle stays inside it
  Shelf shelf;
  Manoeuvre manoeuvre = Manoeuvre::dock;
  std::optional<Insertion> insertion{};
};

/// How the vehicle moves when the plan begins.
struct StartMotion {
  double speed = 0.0;      ///< m/s along the heading, backwards negative, or along the course; 0: it stands
  double curvature = 0.0;  ///< 1/m of its way, in the direction of travel, left positive; of one that stands: no matter, it can steer first
  std::optional<double> course{};  ///< rad, direction of travel of one that does not face along its way (holonomic); empty: it faces along
  double angular_velocity = 0.0;   ///< rad/s, of the heading of one with a course; what faces along turns with its way
  /// How it moves, for sentences. @pre it does
  const char* word() const { return course ? "without facing along its way" : speed < 0.0 ? "backwards" : "forwards"; }
};

/// The vehicle's origin ends there with any heading: at a point, or anywhere in a region.
struct FreeGoal {
  Ring area;  ///< one point, or a simple polygon
  bool is_point() const { return area.size() == 1; }
};

/// What is asked: reach a pose, dock at a station's shelf, or reach a place with any heading.
using Mission = std::variant<Pose, Station, FreeGoal>;

using ParameterValue = std::variant<bool, double, std::string>;
using Parameters = std::map<std::string, ParameterValue>;

struct PlannerChoice {
  std::string name = "pattern_docking";
  Parameters parameters;  ///< as given; checked against the planner's description
};

/// One part of a longer mission; what it does not say is the scenario's.
struct Leg {
  std::string name;  ///< free, for people
  Mission mission;
  Pose exit{};       ///< of the way out of a station (undock): where it ends
  std::vector<Vec2> waypoints{};
  double waypoint_radius = 0.0;         ///< m, ≥ 0
  std::optional<std::string> load{};    ///< of the vehicle's loads, carried from the leg's end on; "": none from there on; absent: as before
  std::optional<PlannerChoice> planner{};
};

/// In which order a mission's legs are driven.
enum class LegOrder {
  given,         ///< as they stand
  best,          ///< the shortest
  best_to_last,  ///< the shortest with the last leg as the last
};

struct Scenario {
  std::string name;
  std::string meta = "{}";  ///< JSON text, carried along
  Map map;
  std::string map_source = "{}";  ///< JSON text: where the map came from, with SHA-256 of its files
  Vehicle vehicle;
  Pose start{};
  StartMotion start_motion;
  Mission mission;
  std::vector<Leg> legs;         ///< where there are any, they take the place of mission and waypoints: see legs.hpp
  LegOrder order = LegOrder::given;
  std::vector<Vec2> waypoints;   ///< to be passed in this order on the way to the pose; headings are free
  double waypoint_radius = 0.0;  ///< m, ≥ 0: as near to each of them the path has to pass
  std::string carried_load;  ///< name of the vehicle's load that is carried all the way (of legs: at the beginning); empty: none
  double clearance = 0.0;  ///< m, ≥ 0, kept from everything by the whole footprint
  PoseError pose_error;
  std::vector<Zone> zones;
  std::vector<MovingObstacle> moving;  ///< the way leads past them in time
  BudgetLimits budget;
  PlannerChoice planner;
  std::uint64_t seed = 1;
};

}  // namespace waywright
