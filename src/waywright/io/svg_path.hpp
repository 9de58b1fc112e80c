// The numbers, paths and transforms of SVG's attributes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/geometry/polygon.hpp"

namespace waywright::svg {

/// x' = a x + c y + e, y' = b x + d y + f.
struct Transform {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;
  Vec2 apply(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
};
Transform operator*(const Transform& outer, const Transform& inner);

struct Subpath {
  std::vector<Vec2> points;
  bool is_closed = false;
};

/// What is wrong, and what is allowed.
struct Wrong {
  std::string problem, allowed;
};

/// Numbers parted by white space, commas or nothing that is needed. Empty where there is anything else, or one is not finite.
std::optional<std::vector<double>> numbers(std::string_view text);

/// A `transform` attribute: matrix, translate, scale, rotate, skewX, skewY, one after another.
tl::expected<Transform, Wrong> transform(std::string_view text);

/// A `d` attribute of straight lines.
tl::expected<std::vector<Subpath>, Wrong> path(std::string_view text);

}  // namespace waywright::svg
