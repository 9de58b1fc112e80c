// The way to GDAL and back: libwaywright_dxf.so is opened when the first drawing is read.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/pose.hpp"
#include "waywright/core/result.hpp"

namespace waywright::dxf {

/// A chain of points in drawing units.
struct Piece {
  std::string kind;       ///< "LINE", "ARC" …
  std::size_t layer = 0;  ///< index of the drawing's layers
  std::optional<std::size_t> curve;  ///< its points are the knots of this one of the cleaned drawing
  bool by_fit_points = false;  ///< a spline whose form is not known between its points
  std::vector<Vec2> points;
};

/// Calls `take` for each piece of a cleaned drawing, in its order, until it returns false.
/// Refuses where the module is missing or GDAL cannot read the drawing.
Parsed<void> expand(const std::string& cleaned, const std::string& name, const std::function<bool(Piece&&)>& take);

}  // namespace waywright::dxf
