// Grey pictures from PGM (P2, P5) and PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"

namespace waywright {

/// Row 0 is the top. 0 black … 1 white is value/255; colours are averaged as they stand.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
  std::vector<bool> see_through{};  ///< pixels that are not opaque; empty where all are
};

inline constexpr int largest_side = 16384;  ///< pixels

/// Bytes of a file to a picture, by their first bytes. Sizes are checked before memory is asked for.
Parsed<GreyImage> decode_image(const std::string& bytes, const std::string& name);

/// What the first bytes of a picture already show: a size that decode_image would refuse. Empty where they do not show it.
std::optional<InputError> refused_by_header(const std::string& head, const std::string& name);

/// A PNG of 8-bit grey; empty where libpng refuses.
std::string encode_png(const GreyImage& image);

}  // namespace waywright
