#include "waywright/planner/field/field_picture_of.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace waywright {
namespace {

constexpr int most_across = 220;          // nodes along the longer side
constexpr double lines_across = 20.0;     // streamlines side by side along the side of a square as large
constexpr double near_share = 0.45;       // of their distance: nearer than that to an earlier one a line ends
constexpr double shortest_line = 1.5;     // in their distances
constexpr double step_of_cell = 0.5;
constexpr int halvings = 7, squares_halved = 20;

/// Where streamlines are already.
class Taken {
 public:
  Taken(const Box& region, double bucket) : low_{region.low}, bucket_{bucket} {
    columns_ = static_cast<int>((region.high.x - region.low.x) / bucket) + 1;
    rows_ = static_cast<int>((region.high.y - region.low.y) / bucket) + 1;
    points_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }
  void add(const Polyline& line) {
    for (const Vec2 p : line) points_[bucket(column(p.x), row(p.y))].push_back(p);
  }
  /// @pre reach ≤ bucket
  bool is_near(Vec2 p, double reach) const {
    for (int r = std::max(0, row(p.y) - 1); r <= std::min(rows_ - 1, row(p.y) + 1); ++r) {
      for (int c = std::max(0, column(p.x) - 1); c <= std::min(columns_ - 1, column(p.x) + 1); ++c) {
        for (const Vec2 other : points_[bucket(c, r)]) {
          if (distance(p, other) < reach) return true;
        }
      }
    }
    return false;
  }

 private:
  int column(double x) const { return std::clamp(static_cast<int>((x - low_.x) / bucket_), 0, columns_ - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - low_.y) / bucket_), 0, rows_ - 1); }
  std::size_t bucket(int c, int r) const { return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c); }

  Vec2 low_;
  double bucket_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<Vec2>> points_;
};

Vec2 node(const FieldPicture& picture, std::size_t i) {
  const auto columns = static_cast<std::size_t>(picture.columns);
  return picture.origin + picture.cell * Vec2{static_cast<double>(i % columns), static_cast<double>(i / columns)};
}

void rank(std::vector<double>& values) {
  std::vector<double> sorted;
  for (const double v : values) {
    if (!std::isnan(v)) sorted.push_back(v);
  }
  std::sort(sorted.begin(), sorted.end());
  const double all = std::max<double>(1.0, static_cast<double>(sorted.size()));
  for (double& v : values) {
    if (std::isnan(v)) continue;
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), v);
    v = 0.5 * static_cast<double>((low - sorted.begin()) + (high - sorted.begin())) / all;
  }
}

void trace(const FieldSeen& field, const Box& region, FieldPicture& picture) {
  const double apart = std::max(std::sqrt((region.high.x - region.low.x) * (region.high.y - region.low.y)) / lines_across, picture.cell);
  // From the highest places on, so that lines are long.
  std::vector<std::size_t> seeds;
  const int every = std::max(1, static_cast<int>(apart / picture.cell));
  for (int row = every / 2; row < picture.rows; row += every) {
    for (int column = every / 2; column < picture.columns; column += every) {
      const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.columns) + static_cast<std::size_t>(column);
      if (!std::isnan(picture.shares[i])) seeds.push_back(i);
    }
  }
  std::stable_sort(seeds.begin(), seeds.end(), [&](std::size_t a, std::size_t b) { return picture.shares[a] > picture.shares[b]; });
  Taken taken{region, apart};
  std::int64_t steps_left = 2 * field.most_values;
  const double step = step_of_cell * picture.cell;
  const auto most_steps = static_cast<std::size_t>(40 * most_across);
  for (const std::size_t seed : seeds) {
    Polyline line{node(picture, seed)};
    if (taken.is_near(line.front(), 0.8 * apart)) continue;
    if (steps_left <= 0) return;
    double way = 0.0;
    while (line.size() < most_steps && steps_left-- > 0 && region.contains(line.back())) {
      const auto next = field.next(line.back(), step);
      if (!next) break;
      way += distance(line.back(), *next);
      line.push_back(*next);
      if (taken.is_near(*next, near_share * apart)) break;
    }
    if (!region.contains(line.back())) line.pop_back();
    if (way < shortest_line * apart || line.size() < 2) continue;
    taken.add(line);
    picture.streamlines.push_back(std::move(line));
  }
}

/// How often g turns around a square, counter-clockwise.
int turns_of(const std::array<Vec2, 4>& g) {
  int turns = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 a = g[k], b = g[(k + 1) % 4];
    if ((a.y < 0.0) == (b.y < 0.0)) continue;
    const double side = cross(a, b);
    if (a.y < 0.0 && side > 0.0) ++turns;
    if (b.y < 0.0 && side < 0.0) --turns;
  }
  return turns;
}

/// Corners of a square, counter-clockwise from the lower left one, and the slopes there.
struct TurningSquare {
  Vec2 low{};
  double side = 0.0;
  std::array<Vec2, 4> g{};
};

/// The quarter of a square that the slope turns around as often; empty where none is.
std::optional<TurningSquare> turning_quarter(const FieldSlope& slope, const TurningSquare& whole) {
  const double half = 0.5 * whole.side;
  const auto at = [&](double x, double y) { return slope(whole.low + Vec2{x * half, y * half}); };
  const auto middle = at(1, 1), below = at(1, 0), right = at(2, 1), above = at(1, 2), left = at(0, 1);
  if (!middle || !below || !right || !above || !left) return std::nullopt;
  const int turns = turns_of(whole.g);
  const auto& g = whole.g;
  const std::array<TurningSquare, 4> quarters{{{whole.low, half, {g[0], *below, *middle, *left}},
                                               {whole.low + Vec2{half, 0}, half, {*below, g[1], *right, *middle}},
                                               {whole.low + Vec2{half, half}, half, {*middle, *right, g[2], *above}},
                                               {whole.low + Vec2{0, half}, half, {*left, *middle, *above, g[3]}}}};
  for (const TurningSquare& quarter : quarters) {
    if (turns_of(quarter.g) == turns) return quarter;
  }
  return std::nullopt;
}

}  // namespace

FieldPicture field_picture(const FieldSeen& field, const Box& region) {
  FieldPicture picture;
  picture.name = field.name;
  picture.levels = {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.96};
  const Vec2 size = region.high - region.low;
  if (!(size.x > 0.0 && size.y > 0.0)) return picture;
  picture.cell = std::max(std::max(size.x, size.y) / most_across, std::sqrt(size.x * size.y / static_cast<double>(field.most_values)));
  picture.columns = std::max(1, static_cast<int>(size.x / picture.cell));
  picture.rows = std::max(1, static_cast<int>(size.y / picture.cell));
  picture.origin = region.low + 0.5 * (size - picture.cell * Vec2{picture.columns - 1.0, picture.rows - 1.0});
  picture.shares.assign(static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < picture.shares.size(); ++i) {
    if (const auto value = field.value(node(picture, i)); value && std::isfinite(*value)) picture.shares[i] = *value;
  }
  rank(picture.shares);
  trace(field, region, picture);
  return picture;
}

std::optional<Vec2> place_down(const FieldSeen& field, const FieldSlope& slope, Vec2 from, double step) {
  const auto down_at = [&](Vec2 q) -> std::optional<Vec2> {
    const auto uphill = slope(q);
    const double steep = uphill ? norm(*uphill) : 0.0;
    return steep > 0.0 && std::isfinite(steep) ? std::optional{(-1.0 / steep) * *uphill} : std::nullopt;
  };
  const auto here = field.value(from);
  const auto first = here ? down_at(from) : std::nullopt;
  if (!first) return std::nullopt;
  const auto falls_at = [&](Vec2 next) {
    const auto there = field.value(next);
    return there && *there < *here;
  };
  for (int k = 0; k < halvings; ++k, step *= 0.5) {
    if (const auto halfway = down_at(from + (0.5 * step) * *first); halfway && falls_at(from + step * *halfway)) return from + step * *halfway;
    if (falls_at(from + step * *first)) return from + step * *first;
  }
  return std::nullopt;
}

std::vector<FieldPicture::Critical> where_slope_vanishes(const FieldPicture& picture, const FieldSlope& slope) {
  using Kind = FieldPicture::Critical::Kind;
  std::vector<std::optional<Vec2>> known(picture.shares.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!std::isnan(picture.shares[i])) known[i] = slope(node(picture, i));
  }
  std::vector<FieldPicture::Critical> found;
  const auto columns = static_cast<std::size_t>(picture.columns);
  for (std::size_t i = 0; i + columns + 1 < known.size(); ++i) {
    if (i % columns + 1 == columns || !known[i] || !known[i + 1] || !known[i + columns] || !known[i + columns + 1]) continue;
    TurningSquare square{node(picture, i), picture.cell, {*known[i], *known[i + 1], *known[i + columns + 1], *known[i + columns]}};
    const int turns = turns_of(square.g);
    if (turns == 0) continue;
    for (int halved = 0; halved < squares_halved; ++halved) {
      const auto quarter = turning_quarter(slope, square);
      if (!quarter) break;
      square = *quarter;
    }
    // Around a minimum the slope points outwards.
    double outwards = 0.0;
    const std::array<Vec2, 4> from_middle{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t k = 0; k < 4; ++k) outwards += dot(square.g[k], from_middle[k]);
    found.push_back({turns < 0 ? Kind::saddle : outwards > 0.0 ? Kind::minimum : Kind::maximum, square.low + 0.5 * Vec2{square.side, square.side}});
  }
  return found;
}

}  // namespace waywright
