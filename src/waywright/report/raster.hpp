// A small picture of few colours inside another one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace waywright {

struct Rgba {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
};

/// A PNG as a data: address. `indices` of the palette, row by row from the top; empty where the library refuses.
/// @pre indices.size() = columns · rows; 1 to 256 colours; every index is one of theirs
std::string png_address(int columns, int rows, const std::vector<std::uint8_t>& indices, const std::vector<Rgba>& palette);

}  // namespace waywright
