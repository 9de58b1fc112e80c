// Pictures of fields: values on a grid, streamlines, and where the slope vanishes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/judge/field_picture.hpp"

namespace waywright {

/// A field as a picture needs it.
struct FieldSeen {
  std::string name;
  std::function<std::optional<double>(Vec2)> value;             ///< falls towards the goal, any unit; empty where there is no field
  std::function<std::optional<Vec2>(Vec2, double step)> next;   ///< from a place about a step (m) down, as the planner goes; empty where it ends
  std::int64_t most_values = 40'000;                            ///< nodes: what asking costs bounds how many there are
};

/// Values of a region's nodes and streamlines that keep apart. Work is bounded by `most_values` nodes and twice as many steps of all lines.
FieldPicture field_picture(const FieldSeen& field, const Box& region);

/// Uphill, of any length; empty where there is no field.
using FieldSlope = std::function<std::optional<Vec2>(Vec2)>;

/// The place `step` down, along the slope halfway there (which does not go to and fro across a valley), or as near as half of that, a quarter … down to a hundredth of it,
/// so that the value falls. Empty where it falls at none.
std::optional<Vec2> place_down(const FieldSeen& field, const FieldSlope& slope, Vec2 from, double step);

/// Where a slope that is continuous vanishes, between nodes of the picture: each square around whose corners it turns by a whole turn is quartered twenty times. Two of
/// them in one square that undo each other are not seen, nor is one in a square with a corner without a field.
std::vector<FieldPicture::Critical> where_slope_vanishes(const FieldPicture& picture, const FieldSlope& slope);

}  // namespace waywright
