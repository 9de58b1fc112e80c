// What is wrong in a scenario is one sentence: the field, what it holds, what is allowed.
#include <gtest/gtest.h>

#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/test_files.hpp"

namespace waywright {
namespace {

using test::Folder;
using test::full_scenario;
using test::least_scenario;

struct BadField {
  const char* pointer;   ///< the place that is changed in the full scenario
  const char* value;     ///< JSON put there; empty: the field is removed
  const char* sentence;  ///< after the file's name
};

std::string sentence_of(const std::string& text) {
  const auto scenario = parse_scenario(text, "s.json", "nowhere");
  return scenario ? "accepted" : scenario.error().message();
}

Json changed(const char* text, const BadField& field) {
  Json json = Json::parse(text);
  const Json::json_pointer place{field.pointer};
  if (*field.value == '\0')
    json[place.parent_pointer()].erase(place.back());
  else
    json[place] = Json::parse(field.value);
  return json;
}

TEST(BadScenario, EveryFieldIsRefusedWithItsSentence) {
  const BadField fields[] = {
      // clang-format off
      {"/format", R"()", R"(format: the field is missing (allowed: waywright-scenario/1))"},
      {"/format", R"("waywright-scenario/2")", R"(format: "waywright-scenario/2" was written by a newer version; this one reads /1 (allowed: waywright-scenario/1))"},
      {"/format", R"("waywright-scenario/12345678901234567890")", R"(format: "waywright-scenario/12345678901234567890" was written by a newer version; this one reads /1 (allowed: waywright-scenario/1))"},
      {"/format", R"("waywright-plan/1")", R"(format: "waywright-plan/1" is not a format that can be read here (allowed: waywright-scenario/1))"},
      {"/format", R"(1)", R"(format: it is a number (allowed: text))"},
      {"/name", R"(7)", R"(name: it is a number (allowed: text))"},
      {"/meta", R"([])", R"(meta: it is an array (allowed: an object))"},
      {"/clearence", R"(0.1)", R"(clearence: unknown field, did you mean "clearance"? (allowed: format, name, meta, map, vehicle, start, goal, waypoints, waypoint_radius, station, legs, order, clearance, pose_error, zones, moving, budget, planner, seed, carried_load))"},
      {"/map", R"()", R"(map: the field is missing (allowed: an object with polygons, cells, ros, image, dxf, movingai, generate, svg, rmf or opentcs))"},
      {"/map", R"("map.json")", R"(map: it is text (allowed: an object with polygons, cells, ros, image, dxf, movingai, generate, svg, rmf or opentcs))"},
      {"/vehicle", R"()", R"(vehicle: the field is missing (allowed: a vehicle, or the name of a file that holds one))"},
      {"/start", R"()", R"(start: the field is missing (allowed: [x, y, heading]))"},
      {"/clearance", R"("wide")", R"(clearance: it is text (allowed: a number from 0 to 1000))"},
      {"/clearance", R"(-0.1)", R"(clearance: -0.1 is out of range (allowed: 0 to 1000))"},
      {"/clearance", R"(null)", R"(clearance: it is null (allowed: a number from 0 to 1000))"},
      {"/clearance", R"(true)", R"(clearance: it is true (allowed: a number from 0 to 1000))"},
      {"/clearance", R"(1e300)", R"(clearance: 1e+300 is out of range (allowed: 0 to 1000))"},
      {"/pose_error", R"(0.1)", R"(pose_error: it is a number (allowed: an object))"},
      {"/pose_error/lateral", R"(-1)", R"(pose_error.lateral: -1 is out of range (allowed: 0 to 1000))"},
      {"/pose_error/heading", R"(4)", R"(pose_error.heading: 4 is out of range (allowed: 0 to 3.141592653589793))"},
      {"/pose_error/sideways", R"(0.1)", R"(pose_error.sideways: unknown field (allowed: lateral, longitudinal, heading))"},
      {"/zones", R"({})", R"(zones: it is an object (allowed: an array))"},
      {"/zones", R"([7])", R"(zones[0]: it is a number (allowed: an object))"},
      {"/zones", R"([{"area":[[0,0],[1,0],[1,1]]}])", R"(zones[0].type: the field is missing (allowed: forbidden, directed, preferred, penalty, speed_limit))"},
      {"/zones/0/type", R"("forbiden")", R"(zones[0].type: "forbiden" is not known, did you mean "forbidden"? (allowed: forbidden, directed, preferred, penalty, speed_limit))"},
      {"/zones/0/type", R"(3)", R"(zones[0].type: it is a number (allowed: forbidden, directed, preferred, penalty, speed_limit))"},
      {"/zones/0/name", R"(3)", R"(zones[0].name: it is a number (allowed: text))"},
      {"/zones/0/factor", R"(3)", R"(zones[0].factor: unknown field (allowed: type, name, area))"},
      {"/zones/0/area", R"()", R"(zones[0].area: the field is missing (allowed: an array of points [x, y]))"},
      {"/zones/0/area", R"([[0,0],[1,1],[1,0],[0,1]])", R"(zones[0].area: edges 0 and 2 cross at (0.5, 0.5) (allowed: a simple polygon of at least 3 corners with an area))"},
      {"/zones/0/area/1", R"([2e6,0])", R"(zones[0].area[1][0]: 2000000 is out of range (allowed: -1000000 to 1000000))"},
      {"/zones/1/direction", R"()", R"(zones[1].direction: the field is missing (allowed: a number from -1000000 to 1000000))"},
      {"/zones/1/direction", R"("east")", R"(zones[1].direction: it is text (allowed: a number from -1000000 to 1000000))"},
      {"/zones/1/speed", R"(1)", R"(zones[1].speed: unknown field (allowed: type, name, area, direction))"},
      {"/zones/2/factor", R"()", R"(zones[2].factor: the field is missing (allowed: a number from 0.01 to 1))"},
      {"/zones/2/factor", R"(0)", R"(zones[2].factor: 0 is out of range (allowed: 0.01 to 1))"},
      {"/zones/2/factor", R"(1)", R"(zones[2].factor: 1 changes nothing (allowed: 0.01 to under 1))"},
      {"/zones/2/factor", R"(1.5)", R"(zones[2].factor: 1.5 is out of range (allowed: 0.01 to 1))"},
      {"/zones/3/factor", R"(0.5)", R"(zones[3].factor: 0.5 is out of range (allowed: 1 to 1000))"},
      {"/zones/3/factor", R"(1)", R"(zones[3].factor: 1 changes nothing (allowed: over 1, at most 1000))"},
      {"/zones/3/factor", R"(1e9)", R"(zones[3].factor: 1000000000 is out of range (allowed: 1 to 1000))"},
      {"/zones/4/speed", R"(0)", R"(zones[4].speed: 0 is out of range (allowed: 0.001 to 1000))"},
      {"/zones/4/speed", R"(-1)", R"(zones[4].speed: -1 is out of range (allowed: 0.001 to 1000))"},
      {"/zones/4/speed", R"(null)", R"(zones[4].speed: it is null (allowed: a number from 0.001 to 1000))"},
      {"/moving", R"([1])", R"(moving[0]: it is a number (allowed: an object))"},
      {"/moving", R"([{"footprint":{"disc":0.3},"track":[[0,1,1],[0,2,2]]}])", R"(moving[0].track[1][0]: 0 s is not after the 0 s of the point before (allowed: times that rise by at least a microsecond))"},
      {"/budget", R"(1000)", R"(budget: it is a number (allowed: an object))"},
      {"/budget/evaluations", R"(0)", R"(budget.evaluations: 0 is out of range (allowed: 1 to 1000000000000))"},
      {"/budget/samples", R"(1.5)", R"(budget.samples: 1.5 is not a whole number (allowed: a whole number))"},
      {"/budget/seconds", R"(0)", R"(budget.seconds: 0 is out of range (allowed: above 0, at most 1000000))"},
      {"/budget/expansion", R"(1)", R"(budget.expansion: unknown field, did you mean "expansions"? (allowed: evaluations, expansions, samples, seconds))"},
      {"/planner", R"("de")", R"(planner: it is text (allowed: an object of parameters by name))"},
      {"/planner/name", R"()", R"(planner.name: the field is missing (allowed: text))"},
      {"/planner/optimizer", R"(["de"])", R"(planner.optimizer: it is an array (allowed: a number, text, true or false))"},
      {"/seed", R"(-1)", R"(seed: -1 is out of range (allowed: 0 to 9223372036854775807))"},
      {"/seed", R"(9223372036854775808)", R"(seed: 9223372036854775808 is out of range (allowed: 0 to 9223372036854775807))"},
      {"/seed", R"("1")", R"(seed: it is text (allowed: a whole number from 0 to 9223372036854775807))"},
      {"/start", R"([1,2])", R"(start: it has 2 elements (allowed: [x, y, heading]))"},
      {"/start", R"([1,2,"east"])", R"(start[2]: it is text (allowed: a number from -1000000 to 1000000))"},
      {"/start", R"([2e6,0,0])", R"(start[0]: 2000000 is out of range (allowed: -1000000 to 1000000))"},
      {"/start/speed", R"(1e4)", R"(start.speed: 10000 is out of range (allowed: -1000 to 1000))"},
      {"/start/curvature", R"("left")", R"(start.curvature: it is text (allowed: a number from -1000 to 1000))"},
      {"/start/course", R"("north")", R"(start.course: it is text (allowed: a number from -1000 to 1000))"},
      {"/start/angular_velocity", R"(0.1)", R"(start.angular_velocity: it is given without course (allowed: start.course beside it; what faces along its way turns with the way))"},
      {"/start/velocity", R"(0)", R"(start.velocity: unknown field (allowed: pose, speed, curvature, course, angular_velocity))"},
      {"/start/pose", R"()", R"(start.pose: the field is missing (allowed: [x, y, heading]))"},
      {"/goal", R"([1,2,3])", R"(goal, station: more than one mission is given (allowed: exactly one of goal, station, legs))"},
      {"/station", R"()", R"(goal: the mission is missing (allowed: exactly one of goal, station, legs))"},
      {"/legs", R"([])", R"(station, legs: more than one mission is given (allowed: exactly one of goal, station, legs))"},
      {"/waypoints", R"([[1,2],[3]])", R"(waypoints[1]: it has 1 element (allowed: [x, y]))"},
      {"/waypoints", R"(null)", R"(waypoints: it is null (allowed: an array of points [x, y]))"},
      {"/waypoint_radius", "-0.1", "waypoint_radius: -0.1 is out of range (allowed: 0 to 1000)"},
      {"/waypoint_radius", "0.1", "waypoint_radius: there are no waypoints (allowed: no such field)"},
      {"/station", R"([])", R"(station: it is an array (allowed: an object))"},
      {"/station/area", R"()", R"(station.area: the field is missing (allowed: an array of points [x, y]))"},
      {"/station/area", R"([])", R"(station.area: the polygon is empty (allowed: at least 3 corners [x, y]))"},
      {"/station/area", R"([[0,0],[1,1],[1,0],[0,1]])", R"(station.area: edges 0 and 2 cross at (0.5, 0.5) (allowed: a simple polygon of at least 3 corners with an area))"},
      {"/station/area", R"([[0,0],[1,0],[2,0]])", R"(station.area: the polygon has no area (allowed: a simple polygon of at least 3 corners with an area))"},
      {"/station/area/2", R"([11])", R"(station.area[2]: it has 1 element (allowed: [x, y]))"},
      {"/station/area/2/1", R"(null)", R"(station.area[2][1]: it is null (allowed: a number from -1000000 to 1000000))"},
      {"/station/manoeuvre", R"("dok")", R"(station.manoeuvre: "dok" is not known, did you mean "dock"? (allowed: dock, undock))"},
      {"/station/insertion", R"({"depth":1})", R"(station.insertion.pockets: the field is missing (allowed: an array))"},
      {"/station/insertion", R"([])", R"(station.insertion: it is an array (allowed: an object))"},
      {"/station/insertion", R"({"depth":0,"pockets":[[-0.3,0.3]]})", R"(station.insertion.depth: 0 is out of range (allowed: above 0, at most 1))"},
      {"/station/insertion", R"({"depth":0.5,"pockets":[]})", R"(station.insertion.pockets: there is no pocket (allowed: at least one [y0, y1]))"},
      {"/station/insertion", R"({"depth":0.5,"pockets":[[0.3,-0.3]]})", R"(station.insertion.pockets[0]: [0.3, -0.3] has no width (allowed: [y0, y1] with y0 < y1))"},
      {"/station/insertion", R"({"depth":0.5,"pockets":[[-0.3,9]]})", R"(station.insertion.pockets[0][1]: 9 is out of range (allowed: -1 to 1))"},
      {"/carried_load", R"(7)", R"(carried_load: it is a number (allowed: text))"},
      {"/station/shelf", R"({})", R"(station.shelf.center: the field is missing (allowed: [x, y]))"},
      {"/station/shelf/center", R"([10])", R"(station.shelf.center: it has 1 element (allowed: [x, y]))"},
      {"/station/shelf/size", R"([1.0])", R"(station.shelf.size: it has 1 element (allowed: [depth, width]))"},
      {"/station/shelf/size/0", R"(-1)", R"(station.shelf.size[0]: -1 is out of range (allowed: above 0, at most 10000))"},
      {"/station/shelf/size/1", R"(0)", R"(station.shelf.size[1]: 0 is out of range (allowed: above 0, at most 10000))"},
      {"/station/shelf/gap", R"(-0.1)", R"(station.shelf.gap: -0.1 is out of range (allowed: 0 to 10000))"},
      {"/station/shelf/slot", R"(1.01)", R"(station.shelf.slot: 1.01 is out of range (allowed: -1 to 1))"},
      {"/station/shelf/heading", R"("west")", R"(station.shelf.heading: it is text (allowed: a number from -1000000 to 1000000))"},
      {"/station/shelf/depth", R"(1)", R"(station.shelf.depth: unknown field (allowed: center, heading, size, gap, slot))"},
      {"/vehicle", R"(3)", R"(vehicle: it is a number (allowed: a vehicle, or the name of a file that holds one))"},
      {"/vehicle/footprint", R"()", R"(vehicle.footprint: the field is missing (allowed: a polygon [[x, y], ...] or {"disc": radius}))"},
      {"/vehicle/footprint", R"("box")", R"(vehicle.footprint: it is text (allowed: a polygon [[x, y], ...] or {"disc": radius}))"},
      {"/vehicle/footprint", R"({"disc":-0.1})", R"(vehicle.footprint.disc: -0.1 is out of range (allowed: 0 to 1000))"},
      {"/vehicle/footprint", R"({"radius":1})", R"(vehicle.footprint.radius: unknown field (allowed: disc))"},
      {"/vehicle/footprint", R"([[0,0],[1,0],[2,0]])", R"(vehicle.footprint: the polygon has no area (allowed: a simple polygon of at least 3 corners with an area))"},
      {"/vehicle/footprint", R"([[0,0],[2000,0],[0,1]])", R"(vehicle.footprint: it reaches 2000 m from the origin (allowed: at most 1000 m))"},
      {"/vehicle/forks", R"([[0,0],[1,0]])", R"(vehicle.forks: a polygon needs at least 3 different corners and this one has 2 (allowed: a simple polygon of at least 3 corners with an area))"},
      {"/vehicle/loads", R"([])", R"(vehicle.loads: it is an array (allowed: an object of loads by name))"},
      {"/vehicle/loads/pallet/mass", R"(-1)", R"(vehicle.loads.pallet.mass: -1 is out of range (allowed: 0 to 1000000))"},
      {"/vehicle/mass", R"(-1)", R"(vehicle.mass: -1 is out of range (allowed: 0 to 1000000))"},
      {"/vehicle/drive", R"()", R"(vehicle.drive: the field is missing (allowed: an object whose type is tricycle, differential or mecanum))"},
      {"/vehicle/drive/type", R"("sledge")", R"(vehicle.drive.type: "sledge" is not known (allowed: tricycle, differential, mecanum))"},
      {"/vehicle/drive/type", R"("tricicle")", R"(vehicle.drive.type: "tricicle" is not known, did you mean "tricycle"? (allowed: tricycle, differential, mecanum))"},
      {"/vehicle/drive/wheelbase", R"(0)", R"(vehicle.drive.wheelbase: 0 is out of range (allowed: above 0, at most 1000))"},
      {"/vehicle/drive/wheelbase", R"(-1.3)", R"(vehicle.drive.wheelbase: -1.3 is out of range (allowed: above 0, at most 1000))"},
      {"/vehicle/drive/max_steering", R"(1.5707963267948966)", R"(vehicle.drive.max_steering: 1.5707963267948966 is out of range (allowed: above 0, under 1.5707963267948966))"},
      {"/vehicle/drive/max_steering", R"(0)", R"(vehicle.drive.max_steering: 0 is out of range (allowed: above 0, under 1.5707963267948966))"},
      {"/vehicle/drive/steered_axle", R"("middle")", R"(vehicle.drive.steered_axle: "middle" is not known (allowed: rear, front))"},
      {"/vehicle/drive/track", R"(1)", R"(vehicle.drive.track: unknown field (allowed: type, wheelbase, max_steering, max_steering_rate, steered_axle))"},
      {"/vehicle/drive", R"({"type":"differential"})", R"(vehicle.drive.track: the field is missing (allowed: a number above 0, at most 1000))"},
      {"/vehicle/drive", R"({"type":"mecanum","wheel_radius":0.1,"half_length":1,"half_width":1,"rolling_arm":0.2})", R"(vehicle.drive.rolling_arm: 0.2 is out of range (allowed: 0 to 0.1))"},
      {"/vehicle/drive", R"({"type":"mecanum","wheel_radius":0.1,"half_length":1,"half_width":1,"max_wheel_speed":0})", R"(vehicle.drive.max_wheel_speed: 0 is out of range (allowed: above 0, at most 1000000))"},
      {"/vehicle/drive", R"({"type":"mecanum","wheel_radius":0.1,"half_length":1,"half_width":1,"max_torqe":1})", R"(vehicle.drive.max_torqe: unknown field, did you mean "max_torque"? (allowed: type, wheel_radius, half_length, half_width, max_wheel_speed, max_torque, wheel_inertia, rolling_arm))"},
      {"/vehicle/drive", R"({"type":"mecanum","wheel_radius":0.1,"half_length":0,"half_width":1})", R"(vehicle.drive.half_length: 0 is out of range (allowed: above 0, at most 1000))"},
      {"/vehicle/limits/speed", R"(0)", R"(vehicle.limits.speed: 0 is out of range (allowed: above 0, at most 1000000))"},
      {"/vehicle/limits/curvature", R"(-1)", R"(vehicle.limits.curvature: -1 is out of range (allowed: above 0, at most 1000000))"},
      {"/vehicle/limits/jerk", R"(1)", R"(vehicle.limits.jerk: unknown field (allowed: speed, reverse_speed, acceleration, deceleration, lateral_acceleration, angular_speed, angular_acceleration, curvature, curvature_rate))"},
      {"/vehicle/control_point", R"([0,0])", R"(vehicle.control_point: it has 2 elements (allowed: [x, y, heading]))"},
      {"/map", R"({})", R"(map: no kind of map is given (allowed: exactly one of polygons (with cells), ros, image, dxf, movingai, generate, svg, rmf, opentcs))"},
      {"/map/ros", R"("m.yaml")", R"(map: 2 kinds of map are given (allowed: exactly one of polygons (with cells), ros, image, dxf, movingai, generate, svg, rmf, opentcs))"},
      {"/map/image", R"("m.png")", R"(map: 2 kinds of map are given (allowed: exactly one of polygons (with cells), ros, image, dxf, movingai, generate, svg, rmf, opentcs))"},
      {"/map/polygon", R"({})", R"(map.polygon: unknown field, did you mean "polygons"? (allowed: polygons, cells, ros, image, resolution, origin, occupied_below, unknown_is_free, movingai, cell, generate, dxf, unit, obstacle_layers, boundary_layer, tolerance, closing, svg, scale, rmf, level, opentcs, corridor, margin, trace, trace_relative, dilate, transform, align, overlay, obstacles, source, notes, alignment))"},
      {"/map/unknown_is_free", R"(true)", R"(map.unknown_is_free: it does not go with a map of kind polygons (allowed: no such field))"},
      {"/map", R"({"ros":"m.yaml","resolution":0.05})", R"(map.resolution: it does not go with a map of kind ros (allowed: no such field))"},
      {"/map", R"({"ros":"gone.yaml"})", R"(map.ros: nowhere/gone.yaml: there is no such file (allowed: a file that can be read))"},
      {"/map", R"({"ros":""})", R"(map.ros: the file name is empty (allowed: a file name))"},
      {"/map", R"({"image":"m.pgm"})", R"(map.resolution: the field is missing (allowed: a number above 0, at most 1000))"},
      {"/map", R"({"movingai":"hall.map"})", R"(map.cell: the field is missing (allowed: a number above 0, at most 1000))"},
      {"/map", R"({"dxf":"hall.dxf","unit":"km"})", R"(map.unit: "km" is not known, did you mean "mm"? (allowed: mm, cm, m, in, ft))"},
      {"/map", R"({"dxf":"hall.dxf","resolution":1})", R"(map.resolution: it does not go with a map of kind dxf (allowed: no such field))"},
      {"/map", R"({"polygons":{},"boundary_layer":"B"})", R"(map.boundary_layer: it does not go with a map of kind polygons (allowed: no such field))"},
      {"/map", R"({"movingai":"a.map","cell":1})", R"(map.movingai: nowhere/a.map: there is no such file (allowed: a file that can be read))"},
      {"/map", R"({"movingai":"a.map","cell":0})", R"(map.cell: 0 is out of range (allowed: above 0, at most 1000))"},
      {"/map", R"({"movingai":"a.map","cell":1,"origin":[0,0,0]})", R"(map.origin: it does not go with a map of kind movingai (allowed: no such field))"},
      {"/map", R"({"ros":"a.yaml","cell":1})", R"(map.cell: it does not go with a map of kind ros (allowed: no such field))"},
      {"/map", R"({"generate":"maze"})", R"(map.generate: "maze" is not known (allowed: SA-CONVEX, SA-NARROW, SA-RAND1, SA-RAND2, SA-RAND3, SA-IRR, SA-IRR-REG, SA-WH, WOA-1, WOA-2, WOA-3, WOA-4, WOA-5, APF-1, APF-2, NF-TWO, NF-S3, NF-ST))"},
      {"/map", R"({"generate":7})", R"(map.generate: it is a number (allowed: text))"},
      {"/map", R"({"generate":"SA-WH","cell":1})", R"(map.cell: it does not go with a map of kind generate (allowed: no such field))"},
      {"/map/polygons", R"([])", R"(map.polygons: it is an array (allowed: an object))"},
      {"/map/polygons", R"("gone.json")", R"(map.polygons: nowhere/gone.json: there is no such file (allowed: a file that can be read))"},
      {"/map/polygons/obstacles/0", R"([])", R"(map.polygons.obstacles[0]: the polygon is empty (allowed: at least 3 corners [x, y]))"},
      {"/map/polygons/obstacles/0/1", R"([1e7,4])", R"(map: it reaches (1e+07, 4.5) in the world frame (allowed: coordinates within 1e+06 m after the transform))"},
      {"/map/polygons/lines/0", R"([[1,1]])", R"(map.polygons.lines[0]: a line of fewer than two points (allowed: at least two points [x, y]))"},
      {"/map/polygons/points/1", R"({"x":1})", R"(map.polygons.points[1]: it is an object (allowed: [x, y]))"},
      {"/map/polygons/walls", R"([])", R"(map.polygons.walls: unknown field (allowed: boundary, boundaries, obstacles, lines, points))"},
      {"/map/transform", R"([1,2])", R"(map.transform: it has 2 elements (allowed: [x, y, heading]))"},
      {"/map/align", R"([[[0,0],[1,1]],[[1,0],[2,1]]])", R"(map.align: both transform and align are given (allowed: one of them))"},
      {"/map/transform", R"([2e6,0,0])", R"(map: it reaches (2e+06, 0) in the world frame (allowed: coordinates within 1e+06 m after the transform))"},
      {"/map/overlay", R"({})", R"(map.overlay: it is an object (allowed: an array))"},
      {"/map/overlay/0/align", R"([[[0,0],[1,0]]])", R"(map.overlay[0].align: 1 pairs of points (allowed: at least two pairs of different points))"},
      {"/map/overlay/0/align", R"([[0,0]])", R"(map.overlay[0].align[0][0]: it is a number (allowed: [x, y]))"},
      {"/map/overlay/0/align/0", R"([[0,0]])", R"(map.overlay[0].align[0]: it has 1 element (allowed: [[x, y] on the map, [x, y] in the world]))"},
      {"/map/obstacles/0", R"([[0,0],[1,0]])", R"(map.obstacles[0]: a polygon needs at least 3 different corners and this one has 2 (allowed: a simple polygon of at least 3 corners with an area))"},
      {"/map/source", R"(5)", R"(map.source: it is a number (allowed: an object))"},
      {"/map/notes", R"("mended")", R"(map.notes: it is text (allowed: an array))"},
      {"/map/alignment", R"({"transform":[0,0,0],"scale":2})", R"(map.alignment.scale: unknown field (allowed: transform, residuals))"},
      {"/map/cells/0/columns", R"(0)", R"(map.cells[0].columns: 0 is out of range (allowed: 1 to 1048576))"},
      {"/map/cells/0/columns", R"(4)", R"(map.cells[0].runs: the runs cover 6 cells (allowed: 4 columns x 2 rows = 8 cells))"},
      {"/map/cells/0/rows", R"(1)", R"(map.cells[0].runs: the runs cover more cells than there are (allowed: 3 columns x 1 rows = 3 cells))"},
      {"/map/cells/0/cell", R"(0)", R"(map.cells[0].cell: 0 is out of range (allowed: above 0, at most 1000))"},
      {"/map/cells/0/runs", R"([0,2,1])", R"(map.cells[0].runs: it is not a list of values and counts (allowed: [value, count, value, count, ...]))"},
      {"/map/cells/0/runs", R"([3,6])", R"(map.cells[0].runs[0]: 3 is out of range (allowed: 0 to 2))"},
      {"/map/cells/0/runs", R"([0,6.0])", R"(map.cells[0].runs: a value or count is not written as a whole number (allowed: whole numbers without a fraction))"},
      {"/map/cells/0/runs", R"([0,2,1,-3])", R"(map.cells[0].runs[3]: -3 is out of range (allowed: 1 to 6))"},
      {"/map/cells/0/origin", R"()", R"(map.cells[0].origin: the field is missing (allowed: [x, y, heading]))"},
      {"/map/cells/0/height", R"(1)", R"(map.cells[0].height: unknown field (allowed: name, columns, rows, cell, origin, bounds, runs))"},
      {"/map/cells/0", R"({"columns":1048576,"rows":1048576,"cell":0.1,"origin":[0,0,0],"runs":[0,1099511627776]})", R"(map.cells[0]: the grids hold 1099511627776 cells (allowed: at most 536870912 cells in all))"},
      // clang-format on
  };
  ASSERT_EQ(sentence_of(full_scenario), "accepted");
  for (const BadField& field : fields) {
    SCOPED_TRACE(std::string{field.pointer} + " = " + field.value);
    const bool other_file = std::string{field.sentence}.rfind("nowhere/", 0) == 0;
    EXPECT_EQ(sentence_of(changed(full_scenario, field).dump()),
              (other_file ? "" : "s.json: ") + std::string{field.sentence});
  }
}

TEST(BadScenario, ZonesAreBoundedInNumberAndCorners) {
  Json scenario = Json::parse(least_scenario);
  const Json zone = Json::parse(R"({"type": "forbidden", "area": [[5,5],[6,5],[6,6]]})");
  scenario["zones"] = Json::array();
  for (int i = 0; i < 1000; ++i) scenario["zones"].push_back(zone);
  EXPECT_EQ(sentence_of(scenario.dump()), "accepted");
  scenario["zones"].push_back(zone);
  EXPECT_EQ(sentence_of(scenario.dump()), "s.json: zones: there are 1001 zones (allowed: at most 1000)");
  Json area = Json::array();
  for (int i = 0; i < 1001; ++i) area.push_back({i, i * i * 1e-3});
  scenario["zones"] = Json::array({zone});
  scenario["zones"][0]["area"] = area;
  EXPECT_EQ(sentence_of(scenario.dump()), "s.json: zones[0].area: the polygon has 1001 corners (allowed: at most 1000)");
}

TEST(BadScenario, EachKindOfGoalIsRefusedWithItsSentence) {
  const std::string kinds = " (allowed: [x, y, heading]; [x, y] with any heading; {\"region\": polygon})";
  const BadField fields[] = {
      {"/goal", "[1]", "goal: it has 1 element"},
      {"/goal", "[1, 2, 3, 4]", "goal: it has 4 elements"},
      {"/goal", "null", "goal: it is null"},
      {"/goal", "\"dock\"", "goal: it is text"},
  };
  for (const BadField& field : fields) EXPECT_EQ(sentence_of(changed(least_scenario, field).dump()), "s.json: " + std::string{field.sentence} + kinds);
  const BadField others[] = {
      {"/goal", "[1, \"east\"]", "goal[1]: it is text (allowed: a number from -1000000 to 1000000)"},
      {"/goal", "{}", "goal.region: the field is missing (allowed: an array of points [x, y])"},
      {"/goal", R"({"region": [[0,0],[1,0]]})", "goal.region: a polygon needs at least 3 different corners and this one has 2 (allowed: a simple polygon of at least 3 corners with an area)"},
      {"/goal", R"({"region": [[0,0],[1,1],[1,0],[0,1]]})", "goal.region: edges 0 and 2 cross at (0.5, 0.5) (allowed: a simple polygon of at least 3 corners with an area)"},
      {"/goal", R"({"area": []})", "goal.area: unknown field (allowed: region)"},
  };
  for (const BadField& field : others) EXPECT_EQ(sentence_of(changed(least_scenario, field).dump()), "s.json: " + std::string{field.sentence});
  EXPECT_EQ(sentence_of(changed(least_scenario, {"/goal", R"({"region": [[0,0],[1,0],[1,1]]})", ""}).dump()), "accepted");
  EXPECT_EQ(sentence_of(changed(least_scenario, {"/goal", "[1, 2]", ""}).dump()), "accepted");
}

TEST(BadScenario, EachLegIsRefusedWithItsSentence) {
  const BadField fields[] = {
      // clang-format off
      {"/legs", "[]", "legs: there is none (allowed: 1 to 1000)"},
      {"/legs", "null", "legs: it is null (allowed: an array)"},
      {"/legs", "{}", "legs: it is an object (allowed: an array)"},
      {"/legs/1", "7", "legs[1]: it is a number (allowed: an object)"},
      {"/legs/1", "{}", "legs[1].goal: the mission is missing (allowed: one of goal, station; with \"undock\" both)"},
      {"/legs/1/legs", "[]", "legs[1].legs: unknown field (allowed: name, goal, station, waypoints, waypoint_radius, load, planner)"},
      {"/legs/1/start", "[0,0,0]", "legs[1].start: unknown field (allowed: name, goal, station, waypoints, waypoint_radius, load, planner)"},
      {"/legs/1/name", "1", "legs[1].name: it is a number (allowed: text)"},
      {"/legs/1/goal", "[1]", "legs[1].goal: it has 1 element (allowed: [x, y, heading]; [x, y] with any heading; {\"region\": polygon})"},
      {"/legs/1/load", "5", "legs[1].load: it is a number (allowed: the name of a load, or null)"},
      {"/legs/1/load", "\"\"", "legs[1].load: the name is empty (allowed: the name of a load, or null)"},
      {"/legs/1/planner", "\"astar\"", "legs[1].planner: it is text (allowed: an object of parameters by name)"},
      {"/legs/1/planner", "{}", "legs[1].planner.name: the field is missing (allowed: text)"},
      {"/legs/1/waypoints", "[[1]]", "legs[1].waypoints[0]: it has 1 element (allowed: [x, y])"},
      {"/legs/1/waypoint_radius", "0.1", "legs[1].waypoint_radius: there are no waypoints (allowed: no such field)"},
      {"/legs/0/goal", "[1,0,0]", "legs[0].goal: it stands beside a station to dock at (allowed: it goes with \"manoeuvre\": \"undock\")"},
      {"/legs/0/station/manoeuvre", "\"undock\"", "legs[0].goal: the field is missing (allowed: a pose [x, y, heading]: where the way out of the station ends)"},
      {"/legs/0/station/manoeuvre", "\"park\"", "legs[0].station.manoeuvre: \"park\" is not known (allowed: dock, undock)"},
      {"/legs/0/station/area", "[]", "legs[0].station.area: the polygon is empty (allowed: at least 3 corners [x, y])"},
      {"/waypoints", "[]", "waypoints: it stands beside legs (allowed: waypoints of a leg)"},
      {"/goal", "[1,0,0]", "goal, legs: more than one mission is given (allowed: exactly one of goal, station, legs)"},
      // clang-format on
  };
  Json legs = Json::parse(least_scenario);
  legs.erase("goal");
  legs["legs"] = Json::array({Json{{"station", Json::parse(full_scenario)["station"]}, {"load", nullptr}}, Json{{"goal", Json::array({1, 0, 0})}, {"name", "there"}}});
  const std::string text = legs.dump();
  ASSERT_EQ(sentence_of(text), "accepted");
  for (const BadField& field : fields) {
    SCOPED_TRACE(std::string{field.pointer} + " = " + field.value);
    EXPECT_EQ(sentence_of(changed(text.c_str(), field).dump()), "s.json: " + std::string{field.sentence});
  }
  legs["legs"] = Json::array();
  for (int i = 0; i < 1001; ++i) legs["legs"].push_back({{"goal", {1, 0, 0}}});
  EXPECT_EQ(sentence_of(legs.dump()), "s.json: legs: there are 1001 (allowed: 1 to 1000)");
}

TEST(BadScenario, ANewerFormatComesBeforeItsUnknownFields) {
  EXPECT_EQ(sentence_of(R"({"format": "waywright-scenario/3", "wishes": []})"),
            "s.json: format: \"waywright-scenario/3\" was written by a newer version; this one reads /1 "
            "(allowed: waywright-scenario/1)");
  EXPECT_EQ(sentence_of("[1, 2]"), "s.json: it is an array (allowed: an object)");
}

TEST(BadScenario, FilesThatAreNamedSpeakForThemselves) {
  const Folder folder;
  const auto with = [&](const char* pointer, const std::string& value) {
    const auto scenario =
        read_scenario(folder.write("s.json", changed(least_scenario, {pointer, value.c_str(), ""}).dump()));
    if (scenario) return std::string{"accepted"};
    std::string sentence = scenario.error().message();
    const std::string prefix = folder.path().string() + "/";
    EXPECT_EQ(sentence.rfind(prefix, 0), 0U) << sentence;
    for (std::size_t at = 0; (at = sentence.find(prefix)) != std::string::npos;) sentence.erase(at, prefix.size());
    return sentence;
  };
  folder.write("v.json", R"({"footprint": {"disc": -1}, "drive": {"type": "differential", "track": 0.5}})");
  folder.write("broken.json", "{");
  folder.write("deep.json", std::string(1000, '['));
  folder.write("m.json", R"({"polygons": {"obstacles": [[[0,0],[1,1],[1,0],[0,1]]]}})");
  folder.write("bare.json", R"({"obstacles": [[[0,0],[1,1]]]})");
  folder.write("circle.json", R"({"polygons": "circle.json"})");
  folder.write("other.json", R"({"wall": []})");
  std::string corners = "[";
  for (int i = 0; i < 501; ++i) corners += (i == 0 ? "[" : ",[") + std::to_string(i) + "," + std::to_string(i * i * 1e-3) + "]";
  EXPECT_EQ(with("/vehicle", R"({"drive": {"type": "differential", "track": 0.5}, "footprint": )" + corners + "]}"),
            "s.json: vehicle.footprint: the polygon has 501 corners (allowed: at most 500)");
  EXPECT_EQ(with("/vehicle", "\"v.json\""),
            "v.json: footprint.disc: -1 is out of range (allowed: 0 to 1000)");
  // Of a file that is not there, the field that names it is told too.
  EXPECT_EQ(with("/vehicle", "\"gone.json\""), "s.json: vehicle: gone.json: there is no such file (allowed: a file that can be read)");
  EXPECT_EQ(with("/vehicle", "\".\""), "s.json: vehicle: .: it is a folder (allowed: a file)");
  EXPECT_EQ(with("/vehicle", "\"a\\nb\""),
            "s.json: vehicle: \"a?b\" is not a file name (allowed: a file name)");
  EXPECT_EQ(with("/vehicle", "\"a\\u0000b\""),
            "s.json: vehicle: \"a?b\" is not a file name (allowed: a file name)");
  EXPECT_EQ(with("/vehicle", "\"\""), "s.json: vehicle: the file name is empty (allowed: a file name)");
  EXPECT_EQ(
      with("/vehicle", "\"broken.json\""),
      "broken.json: line 1, column 1: not valid JSON: unexpected end of input; expected string literal");
  EXPECT_EQ(with("/map/polygons", "\"deep.json\""),
            "deep.json: the JSON is nested too deeply (allowed: at most 64 levels)");
  EXPECT_EQ(with("/map/polygons", "\"m.json\""),
            "m.json: polygons.obstacles[0]: edges 0 and 2 cross at (0.5, 0.5) (allowed: a simple polygon of "
            "at least 3 corners with an area)");
  EXPECT_EQ(with("/map/polygons", "\"bare.json\""),
            "bare.json: obstacles[0]: a polygon needs at least 3 different corners and this one has 2 "
            "(allowed: a simple polygon of at least 3 "
            "corners with an area)");
  EXPECT_EQ(with("/map/polygons", "\"circle.json\""),
            "circle.json: polygons: map files name each other in a circle or too deeply (allowed: at most 4 "
            "levels)");
  EXPECT_EQ(with("/map/polygons", "\"other.json\"")
                .rfind("other.json: wall: unknown field (allowed: polygons, ", 0),
            0U);
}

TEST(BadScenario, ManyFilesAndDeepOverlaysAreBounded) {
  const Folder folder;
  // Each level names the next sixty times: sixty to the fourth power of files in all.
  const auto fan = [](const std::string& next) {
    Json json{{"polygons", Json::object()}, {"overlay", Json::array()}};
    for (int i = 0; i < 60; ++i) json["overlay"].push_back({{"polygons", next}});
    return json;
  };
  folder.write("a.json", fan("b.json").dump());
  folder.write("b.json", fan("c.json").dump());
  folder.write("c.json", fan("d.json").dump());
  folder.write("d.json", R"({"polygons": {}})");
  Json scenario = Json::parse(least_scenario);
  scenario["map"] = fan("a.json");
  const auto refused = parse_scenario(scenario.dump(), "s.json", folder.path());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("too many map files are named (allowed: at most 256 in all)"),
            std::string::npos)
      << refused.error().message();

  Json nested{{"polygons", Json::object()}};
  for (int i = 0; i < 9; ++i) nested = Json{{"polygons", Json::object()}, {"overlay", Json::array({nested})}};
  scenario["map"] = nested;
  EXPECT_NE(sentence_of(scenario.dump()).find("overlays are nested too deeply (allowed: at most 8 levels)"),
            std::string::npos);
  Json deep = Json::object();
  for (int i = 0; i < 30; ++i) deep = Json{{"a", deep}};
  scenario["map"] = {{"polygons", Json::object()}, {"source", deep}};
  EXPECT_EQ(sentence_of(scenario.dump()),
            "s.json: map.source: it is nested too deeply (allowed: at most 24 levels)");
}

}  // namespace
}  // namespace waywright
