#include "waywright/planner/docking/prepared.hpp"

#include <algorithm>

#include "waywright/geometry/convex_parts.hpp"
#include "waywright/geometry/disc_cover.hpp"

namespace waywright {
namespace {

constexpr double reserve = 0.001;        // m beyond what is required
constexpr double coarse_bulge = 0.20;    // m
constexpr double fine_bulge = 0.02;      // m
constexpr int most_discs = 16;
constexpr double pad = 0.5;              // m of field around where the vehicle may stand
constexpr double sharp_beyond = 0.15;    // m of clearance that the field tells apart well, beyond what a fine disc needs
constexpr double beyond = 0.3;           // m of clearance that it tells apart at all, beyond what the largest disc needs

/// Where paths can be: the station, or the sides and both ends with the footprint around them.
Box region_of(const Problem& problem, const DockingTask& task) {
  std::vector<Vec2> points;
  double reach = pad;
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) {
    points = station->area;
  } else {
    for (const TransitionZone& zone : task.zones) {
      for (const Ring& polygon : zone.polygons) {
        for (const Vec2 p : polygon) points.push_back(task.frame.to_world(p));
      }
    }
    points.push_back(problem.start().position());
    points.push_back(problem.first_pose().position());
    points.push_back(problem.goal().position());
    reach += problem.footprint().radius();
  }
  Box box = bounding_box(points);
  return {box.low - Vec2{reach, reach}, box.high + Vec2{reach, reach}};
}

}  // namespace

PreparedDocking::PreparedDocking(const Problem& problem)
    : problem_{&problem}, task_{partition(problem)}, wanted_{problem.required_clearance() + reserve} {
  const Footprint& footprint = problem.footprint();
  std::vector<CoverDisc> coarse, fine;
  if (footprint.is_disc()) {
    disc_ = footprint.disc;
    parts_ = {Ring{Vec2{}}};
    coarse = fine = {{Vec2{}, disc_, disc_}};
  } else {
    radius_ = footprint.radius();
    parts_ = convex_parts(footprint.polygon);
    coarse = disc_cover(footprint.polygon, coarse_bulge, most_discs);
    fine = disc_cover(footprint.polygon, fine_bulge, most_discs);
  }
  const auto largest = [](const std::vector<CoverDisc>& discs) {
    double radius = 0.0;
    for (const CoverDisc& d : discs) radius = std::max(radius, d.radius);
    return radius;
  };
  const double sharp = largest(fine) + wanted_ + sharp_beyond;
  const double cap = std::max(sharp, largest(coarse) + wanted_ + beyond);
  field_ = ClearanceField{problem.world(), region_of(problem, task_), {.sharp = sharp, .cap = cap}};

  const double extent = field_.cell() * std::max(field_.columns(), field_.rows());
  const double rounding = 1e-5 + 1e-6 * extent;  // of single precision
  const auto lanes_of = [&](const std::vector<CoverDisc>& discs) {
    std::vector<lanes::Disc> out;
    for (const CoverDisc& d : discs) {
      out.push_back({static_cast<float>(d.center.x), static_cast<float>(d.center.y),
                     static_cast<float>(norm(d.center)), static_cast<float>(d.radius + wanted_ + rounding),
                     static_cast<float>(d.inner + problem.required_clearance() - field_.slack() - rounding),
                     static_cast<float>(0.5 * (d.radius + d.inner) + wanted_)});
    }
    return out;
  };
  coarse_ = lanes_of(coarse);
  fine_ = lanes_of(fine);
}

bool PreparedDocking::is_surely_clear(const Pose& pose) const {
  const Frame body{pose};
  return std::all_of(fine_.begin(), fine_.end(), [&](const lanes::Disc& disc) {
    return field_.at(body.to_world(Vec2{static_cast<double>(disc.x), static_cast<double>(disc.y)})) > disc.outer;
  });
}

lanes::Field PreparedDocking::lane_field() const {
  return {field_.values().data(), field_.row_shift(), field_.columns() - 1, field_.rows() - 1, static_cast<float>(1.0 / field_.cell())};
}

}  // namespace waywright
