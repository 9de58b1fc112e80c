#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/map/world.hpp"
#include "waywright/study/generate.hpp"

namespace waywright {
namespace {

constexpr double bay_width = 12.0, bay_depth = 13.0;  // m
constexpr double lane = 3.0;                          // m between rows of bays that face each other
constexpr double wall = 0.2;                          // m
constexpr double clear = 0.25;                        // m about start and docked pose
constexpr std::uint8_t free_grey = 254, occupied_grey = 0;

class Hall {
 public:
  Hall(double length, double width) {
    image_.width = static_cast<int>(std::lround(length / warehouse_cell));
    image_.height = static_cast<int>(std::lround(width / warehouse_cell));
    image_.pixels.assign(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height), free_grey);
  }
  /// Metres from the lower left corner.
  void block(const Box& box) {
    const auto cell = [](double v, int most) { return std::clamp(static_cast<int>(std::lround(v / warehouse_cell)), 0, most); };
    const int first = cell(box.low.x, image_.width), last = cell(box.high.x, image_.width);
    for (int r = image_.height - cell(box.high.y, image_.height); r < image_.height - cell(box.low.y, image_.height); ++r) {
      const auto row = image_.pixels.begin() + static_cast<std::ptrdiff_t>(r) * image_.width;
      std::fill(row + first, row + last, occupied_grey);
    }
  }
  GreyImage take() { return std::move(image_); }

 private:
  GreyImage image_;
};

bool clear_of(const Box& box, const Footprint& footprint, const Pose& pose) {
  World world{Map{}};
  world.add_obstacle(rectangle(box.low, box.high), "pallet");
  world.build();
  return world.is_free(footprint, pose, clear);
}

/// A box given in a bay's own frame: x along its back wall, y out of it; `flipped` bays look the other way.
Box placed(const Box& box, Vec2 corner, bool flipped) {
  if (!flipped) return {corner + box.low, corner + box.high};
  return {{corner.x + box.low.x, corner.y + bay_depth - box.high.y}, {corner.x + box.high.x, corner.y + bay_depth - box.low.y}};
}

}  // namespace

GeneratedSite generate_site(std::uint64_t seed, int count, const Vehicle& vehicle) {
  const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))));
  const int rows = (count + columns - 1) / columns;
  // Two rows that face each other share a lane; the next two stand back to back with them.
  const double pair = 2.0 * bay_depth + lane;
  const double length = columns * bay_width + 2.0 * wall;
  const double width = std::ceil(0.5 * rows) * pair + 2.0 * wall;
  Hall hall{length, width};
  hall.block({{0.0, 0.0}, {length, wall}});
  hall.block({{0.0, width - wall}, {length, width}});
  hall.block({{0.0, 0.0}, {wall, width}});
  hall.block({{length - wall, 0.0}, {length, width}});

  GeneratedSite site;
  site.stations = "name,start_x,start_y,start_heading,shelf_x,shelf_y,shelf_heading,shelf_depth,shelf_width,gap,slot,area\n";
  for (int i = 0; i < count; ++i) {
    Random random = Random::stream(seed, static_cast<std::uint64_t>(i) + 2);
    const int row = i / columns;
    const bool flipped = row % 2 == 1;
    const Vec2 corner{wall + bay_width * (i % columns), wall + std::floor(0.5 * row) * pair + (flipped ? bay_depth + lane : 0.0)};
    const double sign = flipped ? -1.0 : 1.0;
    const auto at = [&](Vec2 p) { return Vec2{corner.x + p.x, flipped ? corner.y + bay_depth - p.y : corner.y + p.y}; };

    Shelf shelf;
    shelf.depth = random.uniform(1.0, 1.4);
    shelf.width = random.uniform(2.2, 3.2);
    shelf.gap = random.uniform(0.10, 0.15);
    shelf.slot = random.uniform() < 0.3 ? random.uniform(-0.3, 0.3) : 0.0;
    shelf.heading = sign * 0.5 * pi;
    const double middle = random.uniform(3.5, bay_width - 3.5);
    shelf.center = at({middle, 0.3 + 0.5 * shelf.depth});
    const Pose dock = shelf.docked(vehicle.footprint.front());
    const Pose start = make_pose(at({std::clamp(middle + random.uniform(-2.0, 2.0), 2.0, bay_width - 2.0), random.uniform(8.5, 9.5)}), sign * (0.5 * pi + random.uniform(-0.3, 0.3)));

    const auto block_where_free = [&](const Box& own) {
      const Box box = placed(own, corner, flipped);
      if (clear_of(box, vehicle.footprint, start) && clear_of(box, vehicle.footprint, dock)) hall.block(box);
    };
    block_where_free({{0.0, 0.0}, {0.3, 0.3}});                  // a column of the hall
    block_where_free({{bay_width - 0.3, 0.0}, {bay_width, 0.3}});
    const auto pallets = random.integer(0, 5);
    for (std::int64_t k = 0; k < pallets; ++k) {
      const Vec2 size = random.uniform() < 0.5 ? Vec2{0.8, 1.2} : Vec2{1.2, 0.8};
      const Vec2 low{random.uniform(0.0, bay_width - size.x), random.uniform(0.2, bay_depth - size.y)};
      const bool on_shelf = low.y < 0.5 + shelf.depth && std::abs(low.x + 0.5 * size.x - middle) < 0.5 * (size.x + shelf.width) + 0.2;
      if (!on_shelf) block_where_free({low, low + size});
    }
    const Vec2 a = corner, c = corner + Vec2{bay_width, bay_depth};
    site.stations += fmt::format("{}{:02},{:.3f},{:.3f},{:.4f},{:.3f},{:.3f},{:.9f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f} {:.3f} | {:.3f} {:.3f}\n",
                                 static_cast<char>('A' + row % 26) + (row >= 26 ? std::to_string(row / 26) + "-" : std::string{"-"}), i % columns + 1, start.x, start.y, start.heading,
                                 shelf.center.x, shelf.center.y, shelf.heading, shelf.depth, shelf.width, shelf.gap, shelf.slot, a.x, a.y, c.x, c.y);
  }
  site.map = hall.take();
  return site;
}

}  // namespace waywright
