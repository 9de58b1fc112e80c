#include "waywright/planner/waypoint/distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double least_depth = 1e-6;  // m

double squared_distance(const Box& box, Vec2 p) {
  const double dx = std::max({0.0, box.low.x - p.x, p.x - box.high.x});
  const double dy = std::max({0.0, box.low.y - p.y, p.y - box.high.y});
  return dx * dx + dy * dy;
}

/// By how often a ray to the right crosses the edges.
bool is_inside(const std::vector<Segment>& edges, Vec2 p) {
  bool inside = false;
  for (const Segment& e : edges) {
    if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
    if (p.x < e.a.x + (p.y - e.a.y) * (e.b.x - e.a.x) / (e.b.y - e.a.y)) inside = !inside;
  }
  return inside;
}

double distance_to(const std::vector<Segment>& edges, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& e : edges) {
    const Vec2 along = e.b - e.a, to = p - e.a;
    const double length2 = squared_norm(along);
    const double t = length2 > 0.0 ? std::clamp(dot(to, along) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, squared_norm(to - t * along));
  }
  return std::sqrt(least);
}

}  // namespace

MapObjects::MapObjects(const Problem& problem) : problem_{problem} {
  const World& world = problem.world();
  for (const Segment& s : world.index().segments()) {
    if (objects_.size() <= s.source) objects_.resize(s.source + 1);
    objects_[s.source].edges.push_back(s);
  }
  // Inside or not and how far is asked of the world; objects are gone through for depth and for the greatest distance.
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    Object& object = objects_[i];
    object.is_boundary = world.is_boundary(i);
    object.is_solid = world.is_solid(i);
    std::vector<Vec2> ends;
    for (const Segment& s : object.edges) {
      ends.push_back(s.a);
      ends.push_back(s.b);
    }
    if (!ends.empty()) object.box = bounding_box(ends);
  }
  std::erase_if(objects_, [](const Object& o) { return o.edges.empty(); });
  const Footprint& footprint = problem.footprint();
  corners_ = footprint.is_disc() ? Ring{Vec2{}} : footprint.polygon;
  radius_ = footprint.is_disc() ? footprint.disc : 0.0;
  constexpr Vec2 rounding{1e-9, 1e-9};  // m
  body_ = bounding_box(corners_);
  body_ = {body_.low - rounding, body_.high + rounding};
  if (!world.empty()) reference_ = std::max(1e-3, 0.5 * distance(world.bounds().low, world.bounds().high));
  along_ = std::make_unique<ClearanceAlong>(world, footprint, reference_);
}

MapObjects::Corner MapObjects::corner_against(const Object& object, Vec2 corner) const {
  const double d = distance_to(object.edges, corner);
  const bool is_in = object.is_boundary ? !is_inside(object.edges, corner) : object.is_solid && is_inside(object.edges, corner);
  if (is_in) return {0.0, d + radius_};
  return d >= radius_ ? Corner{d - radius_, 0.0} : Corner{0.0, radius_ - d};
}

/// How deep a corner that the world calls in contact is in any object.
double MapObjects::corner_depth(Vec2 corner) const {
  double deepest = 0.0;
  for (const Object& object : objects_) {
    if (!object.is_boundary && squared_distance(object.box, corner) > radius_ * radius_) continue;
    deepest = std::max(deepest, corner_against(object, corner).depth);
  }
  // In no ring, and yet in contact: in a grid's blocked cells, or beyond it.
  if (deepest == 0.0 && problem_.world().is_blocked(corner)) {
    deepest = problem_.world().index().nearest(std::span{&corner, 1}, std::numeric_limits<double>::infinity()).distance + radius_;
  }
  return std::isfinite(deepest) ? deepest : reference_;
}

void MapObjects::measure_corners(const Pose& pose, bool wants_greatest, TrajectoryMeasures& measures) const {
  const Frame frame{pose};
  double least = reference_;
  double deepest = 0.0;
  for (const Vec2 corner : corners_) {
    const Vec2 at = frame.to_world(corner);
    const double d = problem_.world().least_clearance(std::span{&at, 1}, radius_, std::max(least, 1e-9));
    least = std::min(least, d);
    if (d <= 0.0) deepest = std::max(deepest, corner_depth(at));
    if (!wants_greatest) continue;
    for (const Object& object : objects_) measures.greatest = std::max(measures.greatest, corner_against(object, at).distance);
  }
  measures.distance.push_back(least);
  measures.depth.push_back(least > 0.0 ? 0.0 : std::max(deepest, least_depth));
}

double MapObjects::depth_of(const Pose& pose) const {
  const Frame frame{pose};
  double deepest = least_depth;
  for (const Vec2 corner : corners_) {
    const Vec2 at = frame.to_world(corner);
    if (problem_.world().least_clearance(std::span{&at, 1}, radius_, 1e-9) <= 0.0) deepest = std::max(deepest, corner_depth(at));
  }
  if (radius_ > 0.0) return deepest;
  // Ends of edges in the footprint.
  problem_.world().index().visit(pose.position(), problem_.footprint().radius(), [&](const Segment& edge) {
    const Vec2 local = frame.to_local(edge.a);
    if (!body_.contains(local) || !contains(corners_, local)) return;
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      depth = std::min(depth, point_segment_distance(local, corners_[i], corners_[(i + 1) % corners_.size()]));
    }
    deepest = std::max(deepest, depth);
  });
  return deepest;
}

void MapObjects::measure(std::span<const Pose> poses, FitnessForm form, bool wants_greatest, TrajectoryMeasures& measures) {
  measures.distance.clear();
  measures.depth.clear();
  measures.greatest = 0.0;
  measures.reference = reference_;
  if (form == FitnessForm::published) {
    for (const Pose& pose : poses) measure_corners(pose, wants_greatest, measures);
    return;
  }
  along_->forget();
  along_->at(poses, measures.distance);
  measures.depth.resize(poses.size(), 0.0);
  double greatest = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double clearance = measures.distance[i];
    if (!(clearance > 0.0)) measures.depth[i] = depth_of(poses[i]);
    greatest = std::max(greatest, clearance);
  }
  measures.greatest = greatest;
}

}  // namespace waywright
