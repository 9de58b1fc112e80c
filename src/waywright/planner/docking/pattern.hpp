// The docking pattern: back from the start to a transition point beside the shelf, change direction, drive forks first into
// the docked pose. Two splines of four waypoints each (docking publication, §3.2).
#pragma once

#include <array>

#include "waywright/curve/curve.hpp"
#include "waywright/path/path.hpp"
#include "waywright/planner/docking/partition.hpp"

namespace waywright {

/// Distances of the orientation points from the key poses, m.
struct PatternLeads {
  double start = 0.0;       ///< straight on leaving the start
  double transition = 0.0;  ///< straight on arriving at and leaving the transition point
  double dock = 0.3;        ///< straight run into the docked pose
};

inline constexpr PatternLeads published_leads{1.0, 1.0, 1.5};

/// Four waypoints of each spline: start, S_o, T_o, T and T, T_o, D_o, D.
struct PatternPoints {
  std::array<Vec2, 4> back;
  std::array<Vec2, 4> forth;
};

/// A pose of the vehicle with its heading as a unit vector: what a search makes by the thousand needs no angles.
struct Placement {
  Vec2 position{};
  Vec2 heading{1.0, 0.0};
  friend bool operator==(const Placement&, const Placement&) = default;
};
inline Placement placement_of(const Pose& pose) { return {pose.position(), unit(pose.heading)}; }

/// Where a pattern begins.
struct PatternStart {
  PatternStart() = default;
  PatternStart(const Placement& where, double begins_with = 0.0) : at{where}, curvature{begins_with} {}  // NOLINT: implicit on purpose
  Placement at;
  double curvature = 0.0;  ///< 1/m in the direction of travel, which is backwards: of a vehicle that moves already. Not 0: no straight start
};

PatternPoints pattern_points(const Placement& start, const Placement& dock, const Placement& transition, const PatternLeads& leads);

/// Vehicle heading at the transition: the forks point at the shelf's axis, turned by `offset` (away from the shelf positive).
double transition_heading(Side side, double dock_heading, double offset = 0.0);

/// The published form: natural cubic splines. Misses the wanted headings by some degrees.
std::array<Spline, 2> published_pattern(const Pose& start, const Pose& dock, const Pose& transition,
                                        const PatternLeads& leads = published_leads);

/// Our form before it becomes a path: fixed size, so that a search can make thousands.
struct DockingPattern {
  PatternPoints points;
  BezierSpan back, forth;  ///< the quintics between points 1 and 2 of each
  bool is_bent_at_start = false;  ///< the second derivative of `back` is not 0 where it begins
};
DockingPattern docking_pattern(const PatternStart& start, const Placement& dock, const Placement& transition, const PatternLeads& leads);
inline DockingPattern docking_pattern(const Pose& start, const Pose& dock, const Pose& transition, const PatternLeads& leads) {
  return docking_pattern({placement_of(start)}, placement_of(dock), placement_of(transition), leads);
}
std::array<Spline, 2> splines_of(const DockingPattern& pattern);

/// Our form: straight first and last stretches and a quintic between them whose curvature is 0 at both ends. The headings are
/// met exactly, and the curvature is 0 and continuous wherever the vehicle stands still; at the start it may be another one.
std::array<Spline, 2> straight_ended_pattern(const Pose& start, const Pose& dock, const Pose& transition,
                                             const PatternLeads& leads);

/// The quintic between two courses (unit vectors), tangent lengths chosen for little change of curvature between straight ends.
BezierSpan joining_quintic(Vec2 from, Vec2 from_course, Vec2 to, Vec2 to_course, double start_curvature = 0.0);

/// Both splines as a path: backwards, then forwards.
Path pattern_path(std::array<Spline, 2> splines);

}  // namespace waywright
