// Union and difference of simple polygons, by Boost.Geometry; every answer is checked by its area.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// The area of both. Empty where it is not one simple polygon (two pieces, a hole).
std::optional<Ring> joined(const Ring& a, const Ring& b);

/// What of `a` is not in `b`: none, one or several rings. Empty where that has a hole.
std::optional<std::vector<Ring>> without(const Ring& a, const Ring& b);

/// An area with holes in it. Counter-clockwise rings, all of them.
struct Region {
  Ring outer;
  std::vector<Ring> holes;
};

/// What of `a` is in none of the others. `stops`, asked for each, ends it early: empty.
std::optional<std::vector<Region>> without(const Ring& a, const std::vector<Ring>& others, const std::function<bool()>& stops = {});

}  // namespace waywright
