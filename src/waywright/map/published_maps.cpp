#include "waywright/map/published_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

constexpr int side = 200, warehouse_side = 50;

struct CellBox {
  int x0, y0, x1, y1;  ///< both ends included
};

/// Nodes (x, y), y upwards.
class Nodes {
 public:
  explicit Nodes(int count) {
    grid_.columns = grid_.rows = count;
    grid_.cell = 1.0;
    grid_.origin = {-0.5, -0.5, 0.0};
    grid_.blocked.assign(static_cast<std::size_t>(count) * static_cast<std::size_t>(count), 0);
  }
  void block(const CellBox& box) {
    for (int y = box.y0; y <= box.y1; ++y) {
      for (int x = box.x0; x <= box.x1; ++x) at(x, y) = 1;
    }
  }
  /// Nodes inside or on the border.
  void block(const Ring& ring) {
    for (int y = 0; y < grid_.rows; ++y) {
      for (int x = 0; x < grid_.columns; ++x) {
        if (contains(ring, {static_cast<double>(x), static_cast<double>(y)})) at(x, y) = 1;
      }
    }
  }
  CellGrid take(std::string name) {
    grid_.name = std::move(name);
    return std::move(grid_);
  }

 private:
  std::uint8_t& at(int x, int y) { return grid_.blocked[static_cast<std::size_t>(grid_.rows - 1 - y) * static_cast<std::size_t>(grid_.columns) + static_cast<std::size_t>(x)]; }
  CellGrid grid_;
};

const std::vector<Ring>& convex_tips() {
  static const std::vector<Ring> all{{{24, 0}, {56, 0}, {40, 74}},      {{68, 199}, {104, 199}, {86, 52}},   {{112, 0}, {152, 0}, {132, 118}},
                                     {{158, 199}, {182, 199}, {170, 90}}};
  return all;
}

constexpr std::array<CellBox, 6> narrow_passages{{{48, 0, 52, 149}, {48, 156, 52, 199}, {98, 0, 102, 64}, {98, 71, 102, 199}, {148, 0, 152, 109}, {148, 116, 152, 199}}};

const std::vector<Ring>& irregular_obstacles() {
  static const std::vector<Ring> all{
      {{33, 34}, {44, 30}, {54, 35}, {49, 44}, {55, 52}, {42, 49}, {37, 55}, {34, 45}},
      {{27, 87}, {39, 81}, {48, 87}, {58, 82}, {62, 92}, {51, 96}, {47, 106}, {37, 101}, {30, 103}},
      {{89, 56}, {97, 47}, {108, 51}, {105, 61}, {114, 70}, {100, 74}, {93, 82}, {87, 70}},
      {{92, 116}, {103, 111}, {113, 116}, {109, 125}, {117, 135}, {105, 136}, {98, 144}, {94, 132}, {85, 126}},
      {{43, 142}, {55, 136}, {63, 145}, {57, 152}, {62, 162}, {50, 159}, {42, 164}, {39, 152}},
      {{141, 88}, {150, 81}, {163, 85}, {159, 95}, {167, 102}, {155, 106}, {149, 115}, {143, 103}, {136, 99}},
      {{141, 153}, {151, 144}, {156, 153}, {152, 160}, {156, 168}, {146, 165}, {138, 170}, {137, 160}},
  };
  return all;
}

/// A hair larger, so that nodes on its border are in it whatever rounding made of its corners.
Ring with_border(Ring ring) {
  constexpr double hair = 1e-8;
  Vec2 middle{};
  for (const Vec2 p : ring) middle = middle + (1.0 / static_cast<double>(ring.size())) * p;
  for (Vec2& p : ring) p = p + hair * (p - middle);
  return ring;
}

CellGrid warehouse() {
  Nodes nodes{warehouse_side};
  for (const int y : {8, 14, 20, 26, 32, 38}) {
    for (const auto& [x0, x1] : {std::pair{8, 18}, std::pair{22, 32}, std::pair{36, 44}}) nodes.block(CellBox{x0, y, x1, y + 2});
  }
  return nodes.take("SA-WH");
}

}  // namespace

CellGrid random_rectangles(std::uint64_t seed, Vec2 start, Vec2 goal) {
  constexpr int wanted = side * side / 5, apart = 3, around_ends = 4;
  Random random{seed};
  Nodes nodes{side};
  std::vector<CellBox> taken;
  int covered = 0;
  while (covered < wanted) {
    const auto draw = [&](int low, int high) { return static_cast<int>(random.integer(low, high)); };
    const int w = draw(6, 14), h = draw(6, 14), x = draw(0, side - w), y = draw(0, side - h);
    const auto is_near = [&](Vec2 p) { return p.x >= x - around_ends && p.x <= x + w + around_ends - 1 && p.y >= y - around_ends && p.y <= y + h + around_ends - 1; };
    if (is_near(start) || is_near(goal)) continue;
    const bool meets = std::any_of(taken.begin(), taken.end(), [&](const CellBox& o) {
      return x <= o.x1 + apart && x + w - 1 >= o.x0 - apart && y <= o.y1 + apart && y + h - 1 >= o.y0 - apart;
    });
    if (meets) continue;
    taken.push_back({x, y, x + w - 1, y + h - 1});
    nodes.block(taken.back());
    covered += w * h;
  }
  return nodes.take("SA-RAND");
}

Ring regularised(const Ring& obstacle) {
  double farthest = -1.0;
  Vec2 a{}, b{};
  for (std::size_t i = 0; i < obstacle.size(); ++i) {
    for (std::size_t j = i + 1; j < obstacle.size(); ++j) {
      const double squared = squared_norm(obstacle[j] - obstacle[i]);
      if (squared <= farthest) continue;
      farthest = squared;
      a = obstacle[i];
      b = obstacle[j];
    }
  }
  const double half = 0.5 * std::sqrt(farthest);
  const Vec2 middle = 0.5 * (a + b), along = (0.5 / half) * (b - a), across = left_of(along);
  double left = 0.0, right = 0.0;
  for (const Vec2 p : obstacle) {
    left = std::max(left, dot(p - middle, across));
    right = std::max(right, -dot(p - middle, across));
  }
  const Vec2 end = half * along;
  return {middle - end - right * across, middle + end - right * across, middle + end + left * across, middle - end + left * across};
}

std::uint64_t hash_of_cells(const CellGrid& grid) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (int row = grid.rows - 1; row >= 0; --row) {
    for (int column = 0; column < grid.columns; ++column) hash = (hash ^ (grid.is_blocked(column, row) ? 1U : 0U)) * 0x100000001b3ULL;
  }
  return hash;
}

const std::vector<std::string>& published_map_names() {
  static const std::vector<std::string> names{"SA-CONVEX", "SA-NARROW", "SA-RAND1", "SA-RAND2", "SA-RAND3", "SA-IRR", "SA-IRR-REG", "SA-WH"};
  return names;
}

std::optional<PublishedMap> published_map(std::string_view name) {
  const auto& names = published_map_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) return std::nullopt;
  PublishedMap map;
  map.name = std::string{name};
  const PublishedTask corner_to_corner{{10, 10}, {190, 190}}, between_rectangles{{25, 35}, {140, 190}}, between_irregular{{10, 10}, {170, 190}};
  Nodes nodes{side};
  if (name == "SA-CONVEX") {
    for (const Ring& ring : convex_tips()) nodes.block(ring);
    map.tasks = {corner_to_corner};
  } else if (name == "SA-NARROW") {
    for (const CellBox& box : narrow_passages) nodes.block(box);
    map.tasks = {corner_to_corner};
  } else if (name == "SA-IRR" || name == "SA-IRR-REG") {
    for (const Ring& ring : irregular_obstacles()) nodes.block(name == "SA-IRR" ? ring : with_border(regularised(ring)));
    map.tasks = {between_irregular};
  } else if (name == "SA-WH") {
    // Parking, goods and exit.
    map.grid = warehouse();
    map.tasks = {{{3, 5}, {29, 19}}, {{29, 19}, {46, 44}}, {{3, 5}, {21, 35}}, {{21, 35}, {46, 44}}};
    return map;
  } else {
    const std::uint64_t seed = name == "SA-RAND1" ? 1 : name == "SA-RAND2" ? 124 : 13;
    map.grid = random_rectangles(seed, between_rectangles.start, between_rectangles.goal);
    map.grid.name = map.name;
    map.tasks = {between_rectangles};
    return map;
  }
  map.grid = nodes.take(map.name);
  return map;
}

}  // namespace waywright
