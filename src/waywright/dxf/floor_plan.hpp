// A floor plan from CAD as boundaries, obstacles and walls in metres.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/geometry/polygon.hpp"

namespace waywright::dxf {

struct Options {
  std::string unit;  ///< "mm", "cm", "m", "in", "ft"; empty: the drawing's own, if the size that it gives is one of a floor plan
  std::vector<std::string> obstacle_layers;  ///< empty: all but the boundary's and those of annotations
  std::string boundary_layer;                ///< empty: none
  double tolerance = 1e-3;                   ///< m, between curves and the chords that stand for them, 1e-5 to 1
  double closing = 0.01;                     ///< m: a polyline whose ends are no farther apart is closed, 0 to 1
};

struct FloorPlan {
  std::vector<Ring> boundaries;   ///< counter-clockwise, simple
  std::vector<Ring> obstacles;    ///< the same
  std::vector<Polyline> lines;
  std::vector<std::string> notes;  ///< what was taken, left out and repaired, a sentence each
};

inline constexpr double least_tolerance = 1e-5, most_tolerance = 1.0, most_closing = 1.0;  // m

/// Metres a unit; empty where it is not one of those above.
std::optional<double> metres_of(std::string_view unit);

/// Lines, polylines with bulges, arcs, circles, ellipses, splines, solids and what blocks insert of them, from model space. Closed ones are
/// obstacles, open ones lines; those on the boundary layer are boundaries, where lines that meet are joined. A closed one about most of
/// the rest is the plan's outline: lines, not solid. Curves and what stands for them are within the tolerance of each other: solids contain what
/// their curves enclose, boundaries are contained in it, lines have their corners on the curve.
/// Refuses: what scan() refuses; no unit, or one that gives no floor plan's size; layers that are not there; a drawing with nothing to take.
/// @param name  of the file, for messages
Parsed<FloorPlan> read_floor_plan(std::string_view text, const std::string& name, const Options& options);

}  // namespace waywright::dxf
