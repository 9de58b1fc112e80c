#include "waywright/map/clearance_field.hpp"
#include "waywright/map/distance_field.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr int large_side = 32;  // cells
constexpr int small_side = 8;

/// A little less, so that rounding to single precision and of the index never makes it too much.
float rounded_down(double value) { return static_cast<float>(std::max(0.0, value - 4e-7 * value - 1e-6)); }

}  // namespace

double ClearanceField::Near::squared_distance(Vec2 p) const {
  const Vec2 to = p - a;
  return squared_norm(to - std::clamp(dot(to, along) * inverse, 0.0, 1.0) * along);
}

struct ClearanceField::Block {
  int column, row, last_column, last_row;
  Vec2 middle;
  double radius;
};

ClearanceField::ClearanceField(const World& world, const Box& region, const Options& options) : cell_{options.cell} {
  const Vec2 size = region.high - region.low;
  const auto cells = [&](double along) { return std::floor(along / cell_) + 3.0; };
  const auto shift = [&] {
    int bits = 2;
    while (static_cast<double>(1 << bits) < cells(size.x) && bits < 30) ++bits;
    return bits;
  };
  while (static_cast<double>(1 << shift()) * cells(size.y) > static_cast<double>(options.most_cells)) cell_ *= 2.0;
  cells_per_metre_ = 1.0 / cell_;
  row_shift_ = shift();
  columns_ = static_cast<int>(cells(size.x));
  rows_ = static_cast<int>(cells(size.y));
  origin_ = region.low - Vec2{cell_, cell_};
  values_.assign(static_cast<std::size_t>(rows_) << row_shift_, -1.0F);
  for (int row = 1; row < rows_ - 1; row += large_side) {
    for (int column = 1; column < columns_ - 1; column += large_side) fill(world, column, row, options);
  }
  near_ = {};
}

ClearanceField::Block ClearanceField::block_at(int column, int row, int side) const {
  const int last_column = std::min(column + side, columns_ - 1);
  const int last_row = std::min(row + side, rows_ - 1);
  const Vec2 low = origin_ + cell_ * Vec2{static_cast<double>(column), static_cast<double>(row)};
  const Vec2 high = origin_ + cell_ * Vec2{static_cast<double>(last_column), static_cast<double>(last_row)};
  return {column, row, last_column, last_row, 0.5 * (low + high), 0.5 * norm(high - low)};
}

/// A large block: at once where all of it is blocked or far from everything, else by small ones.
void ClearanceField::fill(const World& world, int column, int row, const Options& options) {
  const Block block = block_at(column, row, large_side);
  const double limit = options.cap + block.radius + cell_;
  const double nearest = world.index().distance({&block.middle, 1}, limit);
  const bool blocked = nearest > block.radius && world.is_blocked(block.middle);
  if (blocked || nearest >= limit) {
    for (int r = row; r < block.last_row; ++r) {
      std::fill(&value(column, r), &value(block.last_column - 1, r) + 1, blocked ? 0.0F : rounded_down(options.cap));
    }
    return;
  }
  for (int r = row; r < block.last_row; r += small_side) {
    for (int c = column; c < block.last_column; c += small_side) {
      fill_block(world, c, r, nearest + 1.01 * block.radius, options);
    }
  }
}

/// A small block; its middle is within `limit` of something.
void ClearanceField::fill_block(const World& world, int column, int row, double limit, const Options& options) {
  const Block block = block_at(column, row, small_side);
  const double nearest = world.index().distance({&block.middle, 1}, limit);
  // Where nothing crosses the block, all of it is inside or outside.
  const bool uniform = nearest > block.radius;
  const bool blocked = uniform && world.is_blocked(block.middle);
  const bool sharp = !blocked && nearest - block.radius <= options.sharp + cell_;
  near_.clear();
  // The nearest segment of any point of the block is within the middle's distance and twice the radius of the middle.
  if (sharp) {
    const double reach = nearest + 2.0 * block.radius;
    world.index().visit(block.middle, reach, [&](const Segment& s) {
      const double length2 = squared_norm(s.b - s.a);
      const Near near{s.a, s.b - s.a, length2 > 0.0 ? 1.0 / length2 : 0.0};
      if (near.squared_distance(block.middle) <= reach * reach) near_.push_back(near);
    });
  }
  const double cell_radius = half_cell_diagonal * cell_;
  for (int r = row; r < block.last_row; ++r) {
    for (int c = column; c < block.last_column; ++c) {
      const Vec2 at = origin_ + cell_ * Vec2{c + 0.5, r + 0.5};
      if (uniform ? blocked : world.is_blocked(at)) {
        value(c, r) = 0.0F;
        continue;
      }
      double distance = nearest - waywright::distance(at, block.middle);
      if (sharp) {
        double squared = (options.cap + cell_) * (options.cap + cell_);
        for (const Near& s : near_) squared = std::min(squared, s.squared_distance(at));
        distance = std::sqrt(squared);
      }
      value(c, r) = rounded_down(std::min(distance - cell_radius, options.cap));
    }
  }
}

}  // namespace waywright
