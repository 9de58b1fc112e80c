#include "tests/fuzz/station_bytes.hpp"

#include <algorithm>

namespace waywright::fuzz {
namespace {

constexpr double tine_inside = 0.05, tine_outside = 0.14;  // m from the vehicle's axis
constexpr double body_front = -0.3;                        // m, where the tines begin

Ring body_with_tines(double back, double half_width, double front) {
  return {{back, -half_width},          {body_front, -half_width},   {body_front, -tine_outside}, {front, -tine_outside},
          {front, -tine_inside},        {body_front, -tine_inside},  {body_front, tine_inside},   {front, tine_inside},
          {front, tine_outside},        {body_front, tine_outside},  {body_front, half_width},    {back, half_width}};
}

Vehicle vehicle_of(ByteSource& source) {
  Vehicle v;
  v.name = "v";
  const double back = -source.real(0.5, 1.2), half_width = source.real(0.15, 0.3), front = source.real(0.1, 0.3);
  switch (source.below(6)) {
    case 0:
      v.footprint.polygon = rectangle({back, -half_width}, {front, half_width});
      break;
    case 1:
      v.footprint.disc = half_width;
      break;
    case 2:  // an L
      v.footprint.polygon = {{back, -half_width}, {front, -half_width}, {front, 0.0}, {body_front, 0.0}, {body_front, half_width}, {back, half_width}};
      break;
    case 3: {  // anything
      for (int i = 3 + source.below(4); i > 0; --i) v.footprint.polygon.push_back(source.point({back, -half_width}, {front, half_width}));
      break;
    }
    default:
      v.footprint.polygon = body_with_tines(back, half_width, front);
      v.forks = {rectangle({body_front, -tine_outside}, {front, -tine_inside}), rectangle({body_front, tine_inside}, {front, tine_outside})};
      break;
  }
  if (source.one_in(3)) {
    v.drive = Differential{0.3};
  } else {
    v.drive = Tricycle{source.real(0.4, 0.8), source.real(0.5, 1.3), std::nullopt, source.one_in(2) ? SteeredAxle::front : SteeredAxle::rear};
  }
  if (!source.one_in(4)) v.limits.curvature = source.real(1.5, 4.0);
  if (source.one_in(3)) v.limits.curvature_rate = source.real(2.0, 40.0);
  if (source.one_in(3)) {
    const double load = source.real(0.1, 0.35);
    v.loads["load"] = {source.one_in(4) ? Footprint{{}, load} : Footprint{rectangle({body_front, -load}, {front + source.real(-0.1, 0.1), load}), 0.0}, 10.0};
  }
  return v;
}

Ring area_of(ByteSource& source, double depth, double half_width) {
  const Vec2 low{-depth - source.real(0.0, 0.4), -half_width}, high{source.real(2.0, 4.0), half_width};
  Ring ring;
  const Ring corners = rectangle(low, high);
  for (std::size_t i = 0; i < 4; ++i) {
    ring.push_back(corners[i]);
    if (source.one_in(4)) ring.push_back(corners[i] + source.real(0.0, 1.0) * (corners[(i + 1) % 4] - corners[i]));  // a straight corner
    if (source.one_in(6)) ring.push_back(source.point(low, high));
  }
  return ring;
}

void fill_map(ByteSource& source, double half_width, Map& map) {
  const Vec2 low{-0.2, -half_width - 0.2}, high{4.0, half_width + 0.2};
  for (int i = source.below(6); i > 0; --i) {
    const Vec2 at = source.point(low, high);
    const Vec2 size{source.real(0.0, 0.6), source.real(0.0, 0.6)};
    switch (source.below(5)) {
      case 0:
        map.obstacles.push_back({at, at + size, source.point(low, high)});
        break;
      case 1:
        map.lines.push_back({at, at + size, source.point(low, high)});
        break;
      case 2:
        map.points.push_back(at);
        break;
      case 3: {
        CellGrid grid{"cells", 4, 3, 0.02 + 0.1 * size.x, make_pose(at, source.real(-pi, pi)), {}, false};
        for (int k = 0; k < 12; ++k) grid.blocked.push_back(static_cast<std::uint8_t>(source.below(3)));
        map.grids.push_back(std::move(grid));
        break;
      }
      default:
        map.obstacles.push_back(rectangle(at, at + size));
        break;
    }
  }
}

void place(Scenario& scenario, Station& station, const Frame& frame) {
  const auto move = [&](std::vector<Ring>& rings) {
    for (Ring& ring : rings) ring = transformed(ring, frame);
  };
  move(scenario.map.obstacles);
  move(scenario.map.lines);
  for (Vec2& p : scenario.map.points) p = frame.to_world(p);
  for (CellGrid& grid : scenario.map.grids) grid.origin = frame.to_world(grid.origin);
  scenario.start = frame.to_world(scenario.start);
  station.area = transformed(station.area, frame);
  station.shelf.center = frame.to_world(station.shelf.center);
  station.shelf.heading = wrap(station.shelf.heading + frame.heading());
}

}  // namespace

double ByteSource::real(double low, double high) {
  const int kind = byte();
  double value = low + (high - low) * (256 * byte() + byte()) / 65535.0;
  if (kind >= 240) {
    switch (kind % 8) {
      case 0: value = low; break;
      case 1: value = high; break;
      case 2: value = before_; break;
      case 3: value = before_ + 1e-9; break;
      case 4: value = before_ - 1e-12; break;
      case 5: value = 0.0; break;
      case 6: value = 1e-9; break;
      default: value = -before_; break;
    }
  }
  before_ = value;
  return value;
}

Vec2 ByteSource::point(Vec2 low, Vec2 high) {
  const double x = real(low.x, high.x);
  return {x, real(low.y, high.y)};
}

StationBytes station_of(const std::string& bytes) {
  ByteSource source{bytes};
  StationBytes made;
  Scenario& s = made.scenario;
  s.vehicle = vehicle_of(source);
  Station station;
  station.shelf.depth = source.real(0.3, 0.6);
  station.shelf.width = source.real(0.4, 1.2);
  station.shelf.center = {-0.5 * station.shelf.depth, 0.0};
  station.shelf.gap = source.real(0.03, 0.15);
  station.shelf.slot = source.one_in(2) ? source.real(-0.3, 0.3) : 0.0;
  const double half_width = 0.5 * station.shelf.width + source.real(0.3, 2.2);
  station.area = area_of(source, station.shelf.depth, half_width);
  if (source.one_in(3)) station.manoeuvre = Manoeuvre::undock;
  if (source.one_in(2)) {
    Insertion insertion;
    insertion.depth = source.real(0.05, 0.4);
    const double play = source.real(-0.005, 0.04), slot = station.shelf.slot;
    insertion.pockets = {{slot - tine_outside - play, slot - tine_inside + play}, {slot + tine_inside - play, slot + tine_outside + play}};
    station.insertion = insertion;
  }
  if (!s.vehicle.loads.empty() && source.one_in(2)) s.carried_load = "load";
  s.start = make_pose(source.point({1.5, -0.5}, {3.5, 0.5}), source.real(-0.6, 0.6));
  s.clearance = source.one_in(3) ? 0.0 : source.real(0.0, 0.03);
  if (source.one_in(3)) s.pose_error = {source.real(0.0, 0.01), source.real(0.0, 0.01), source.real(0.0, 0.01)};
  s.seed = static_cast<std::uint64_t>(source.below(4));
  fill_map(source, half_width, s.map);
  // Somewhere in the world; at times as far out as coordinates go.
  const double reach = source.one_in(8) ? 0.99e6 : 50.0;
  if (!source.one_in(4)) place(s, station, Frame{make_pose(source.point({-reach, -reach}, {reach, reach}), source.real(-pi, pi))});
  s.mission = station;
  if (source.one_in(2) && station.manoeuvre == Manoeuvre::dock) s.start_motion = {source.real(-1.0, 0.6), source.one_in(2) ? source.real(-0.8, 0.8) : 0.0};
  made.surprise.at = source.real(0.0, 1.0);
  if (source.one_in(2)) made.surprise.shelf = make_pose(source.point({-0.04, -0.04}, {0.04, 0.04}), source.real(-0.02, 0.02));
  if (source.one_in(4)) {
    made.surprise.vehicle = make_pose(source.point({-0.02, -0.02}, {0.02, 0.02}), source.real(-0.02, 0.02));
    made.surprise.curvature = source.real(-0.05, 0.05);
  }
  return made;
}

}  // namespace waywright::fuzz
