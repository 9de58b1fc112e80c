#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/study/generate.hpp"

namespace waywright {
namespace {

constexpr double length = 60.0, width = 40.0;  // m
constexpr std::uint8_t free_grey = 254, occupied_grey = 0;

class Drawing {
 public:
  Drawing() {
    image_.width = static_cast<int>(std::lround(length / warehouse_cell));
    image_.height = static_cast<int>(std::lround(width / warehouse_cell));
    image_.pixels.assign(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height), free_grey);
  }

  /// Metres from the lower left corner.
  void block(double x, double y, double w, double h) {
    const auto cell = [](double v, int most) { return std::clamp(static_cast<int>(std::lround(v / warehouse_cell)), 0, most); };
    for (int r = image_.height - cell(y + h, image_.height); r < image_.height - cell(y, image_.height); ++r) {
      for (int c = cell(x, image_.width); c < cell(x + w, image_.width); ++c) {
        image_.pixels[static_cast<std::size_t>(r) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(c)] = occupied_grey;
      }
    }
  }
  GreyImage take() { return std::move(image_); }

 private:
  GreyImage image_;
};

}  // namespace

GreyImage generate_warehouse(std::uint64_t seed) {
  Random random = Random::stream(seed, 1);
  Drawing d;
  const double wall = 0.2;
  d.block(0, 0, length, wall);
  d.block(0, width - wall, length, wall);
  d.block(0, 0, wall, width);
  d.block(length - wall, 0, wall, width);
  // Two blocks of double racks along x, aisles of 3.2 m between them, a cross aisle of 4 m in the middle.
  for (int row = 0; row < 4; ++row) {
    const double y = 21.0 + 4.4 * static_cast<double>(row);
    d.block(3.0, y, 24.0, 1.2);
    d.block(31.0, y, 24.0, 1.2);
  }
  for (int row = 0; row < 4; ++row) {
    const double y = 3.0 + 4.2 * static_cast<double>(row);
    d.block(3.0, y, 17.0, 1.2);
    d.block(24.0, y, 14.0, 1.2);
  }
  for (int i = 1; i < 6; ++i) {  // columns that carry the roof
    d.block(10.0 * i - 0.2, 18.6, 0.4, 0.4);
  }
  for (int i = 0; i < 14; ++i) {  // pallets left along the west and north walls and in the cross aisle
    const double side = random.uniform();
    const double w = random.uniform(0.8, 1.2);
    if (side < 0.5) {
      d.block(0.3, random.uniform(2.0, 36.0), w, 0.8);
    } else {
      d.block(random.uniform(2.0, 56.0), width - 1.3, w, 0.8);
    }
  }
  return d.take();
}

}  // namespace waywright
