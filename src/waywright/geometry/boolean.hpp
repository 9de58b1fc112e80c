// Union and difference of two simple polygons, by Boost.Geometry; every answer is checked by its area.
#pragma once

#include <optional>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// The area of both. Empty where it is not one simple polygon (two pieces, a hole).
std::optional<Ring> joined(const Ring& a, const Ring& b);

/// What of `a` is not in `b`: none, one or several rings. Empty where that has a hole.
std::optional<std::vector<Ring>> without(const Ring& a, const Ring& b);

}  // namespace waywright
