// The lanes that a plant's vehicles are led along, as fleet software draws them: named places and lanes between them. Plain data, world frame.
//
// A lane says where vehicles are meant to drive, not what is free: that is a Map's matter. What planners can make of one: places as ends of missions, lanes as zones
// with rules (scenario/lane_zones), or the strips along lanes as all that is free (lane_corridors).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

struct LanePlace {
  std::string name;
  Vec2 at{};
  std::optional<double> heading{};  ///< rad, that a vehicle has there; absent: any
};
struct Lane {
  std::string name;
  std::size_t from = 0, to = 0;   ///< places
  Polyline course;                ///< from place to place, both among its points
  bool is_both_ways = false;      ///< may be driven from `to` to `from`, too
  std::optional<double> speed{};  ///< m/s, that it allows, > 0
};
struct LaneStation {
  std::string name;
  Vec2 at{};
  std::vector<std::size_t> places;  ///< that it is served from; may be none
};
struct LaneVehicle {
  std::string name;
  double length = 0.0, width = 0.0;  ///< m, of the box about it; 0: not told
  Vec2 reference{};                  ///< m, from the middle of the box to the point that follows lanes; body frame
  std::optional<double> speed{};     ///< m/s, > 0
};
struct LaneGraph {
  std::vector<LanePlace> places;
  std::vector<Lane> lanes;
  std::vector<LaneStation> stations;
  std::vector<LaneVehicle> vehicles;
  bool empty() const { return places.empty(); }
};

/// The shortest way along lanes.
struct LaneRoute {
  std::vector<std::size_t> places;  ///< from the first to the last
  struct Step {
    std::size_t lane = 0;
    bool is_backwards = false;  ///< from the lane's `to` to its `from`
  };
  std::vector<Step> steps;  ///< one fewer than places
  double length = 0.0;      ///< m
};

/// Of all lanes, along their courses. Of equally long ones the one through the places that stand first.
std::optional<LaneRoute> shortest_route(const LaneGraph& graph, std::size_t from, std::size_t to);

/// Which place has this name; of a station the first one that it is served from.
std::optional<std::size_t> place_named(const LaneGraph& graph, const std::string& name);

/// m, along its course.
double length(const Lane& lane);
/// rad, of the course where it leaves `from` (arrives at `to`).
double first_heading(const Lane& lane);
double last_heading(const Lane& lane);

/// In a sentence or two: how many there are, how long, and which places no lane leads away from or to.
std::vector<std::string> describe(const LaneGraph& graph);

/// Where nothing but lanes is known: all that is free are strips along them, `width` m across, with round ends, as cells of `cell` m. A cell is free where all of it
/// lies in one lane's strip; so strips are narrower than stated by up to 1.5 cells on either side. Refused: a width of less than 4 cells, more than 2²⁶ cells or 16384
/// a side, or too many lanes on so many cells.
Parsed<CellGrid> lane_corridors(const LaneGraph& graph, double width, double cell);
/// The size of cells that lane_corridors takes by default: a fortieth of the width, at least 1 cm, more where there would be over four million cells.
double corridor_cell(const LaneGraph& graph, double width);

/// All places and courses. @pre there is a place
Box bounding_box(const LaneGraph& graph);

void transform(LaneGraph& graph, const Pose& pose);
/// Adds the other one's places, lanes, stations and vehicles.
void append(LaneGraph& graph, LaneGraph more);

}  // namespace waywright
