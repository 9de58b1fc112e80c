#include "waywright/io/map_align.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/io/map_io.hpp"

namespace waywright {
namespace {

double worst_of(const Alignment& found) { return *std::max_element(found.residuals.begin(), found.residuals.end()); }

/// Diagonal of the box about the points, m.
double extent_of(const std::vector<Vec2>& points) {
  const Box box = bounding_box(points);
  return norm(box.high - box.low);
}

/// Where the same turn and a scale bring the pairs together ten times as well: in words what the scale is.
std::optional<std::string> scale_words(const std::vector<Vec2>& from, const std::vector<Vec2>& to, const Alignment& found) {
  constexpr double clear_scale = 0.01;
  const double n = static_cast<double>(from.size());
  const Frame turn{make_pose({}, found.transform.heading)};
  Vec2 a{}, b{};
  for (std::size_t i = 0; i < from.size(); ++i) a = a + (1.0 / n) * from[i], b = b + (1.0 / n) * to[i];
  double along = 0.0, spread = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    along += dot(turn.rotate(from[i] - a), to[i] - b);
    spread += squared_norm(from[i] - a);
  }
  const double scale = along / spread;
  for (std::size_t i = 0; i < from.size(); ++i) worst = std::max(worst, norm(to[i] - b - scale * turn.rotate(from[i] - a)));
  if (!(std::abs(scale - 1.0) > clear_scale) || !(worst <= 0.1 * worst_of(found))) return std::nullopt;
  return fmt::format("the pairs fit a map {} times as large: wrong unit?", scale >= 0.1 ? fmt::format("{:.2f}", scale) : fmt::format("{:.3g}", scale));
}

/// Pairs that no turn and shift bring together within a tenth of their extent are not those of this map, whatever is planned on it: refused.
/// (Points read off a map are within some centimetres; of two pairs, a tenth is a scale that is off by a fifth and more.)
bool is_far_off(const Node& node, const std::vector<Vec2>& from, const std::vector<Vec2>& to, const Alignment& found, std::vector<std::string>& notes) {
  constexpr double clearly_off = 0.05;  // m
  constexpr double hopeless = 0.1, worth_a_note = 0.01;  // of the extent
  const double worst = worst_of(found), extent = std::max(extent_of(from), extent_of(to));
  if (worst <= std::max(clearly_off, worth_a_note * extent)) return false;
  const auto scale = scale_words(from, to, found);
  if (worst > hopeless * extent) {
    node.fail(fmt::format("the pairs do not fit the map: as placed they are up to {:.3f} m apart, more than a tenth of the {:.1f} m over which they lie{}", worst, extent, scale ? "; " + *scale : ""),
              "pairs that a turn and a shift bring together, in metres");
    return true;
  }
  if (scale) notes.push_back(node.path() + ": " + *scale);
  return false;
}

/// Axes swapped or one turned over: no turn and shift can bring such points together, however small the error seems. Refused.
bool is_mirrored(const Node& node, std::vector<Vec2> from, const std::vector<Vec2>& to, const Alignment& found) {
  constexpr double clearly_off = 0.05;  // m
  for (Vec2& p : from) p.y = -p.y;
  const auto mirrored = align(from, to);
  if (from.size() < 3 || !mirrored || worst_of(found) < clearly_off || worst_of(*mirrored) > 0.1 * worst_of(found)) return false;
  node.fail(fmt::format("the pairs fit a mirrored map: they are up to {:.3f} m apart as they stand, {:.3f} m when the map is mirrored", worst_of(found), worst_of(*mirrored)),
            "pairs that a turn and a shift bring together");
  return true;
}

}  // namespace

std::optional<Alignment> read_align(const Node& node, double most, std::vector<std::string>& notes) {
  std::vector<Vec2> from, to;
  for (const Node& pair : node.elements()) {
    if (!pair.is_array_of(2, "[[x, y] on the map, [x, y] in the world]")) return std::nullopt;
    from.push_back(pair.at(std::size_t{0}).point(most));
    to.push_back(pair.at(1).point(most));
    if (node.failed()) return std::nullopt;
  }
  if (node.failed()) return std::nullopt;
  auto found = align(from, to);
  if (found && !is_mirrored(node, from, to, *found) && !is_far_off(node, from, to, *found, notes)) return *found;
  if (found) return std::nullopt;
  node.fail(found.error().problem, found.error().allowed);
  return std::nullopt;
}

}  // namespace waywright
