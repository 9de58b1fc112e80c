#include "waywright/report/raster.hpp"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace waywright {
namespace {

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t held = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < held ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= held ? letters[three >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

}  // namespace

std::string png_address(int columns, int rows, const std::vector<std::uint8_t>& indices, const std::vector<Rgba>& palette) {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(columns);
  png.height = static_cast<png_uint_32>(rows);
  png.format = PNG_FORMAT_RGBA_COLORMAP;
  png.colormap_entries = static_cast<png_uint_32>(palette.size());
  std::vector<std::uint8_t> colours;
  for (const Rgba& c : palette) colours.insert(colours.end(), {c.red, c.green, c.blue, c.alpha});
  std::vector<std::uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, indices.data(), 0, colours.data()) == 0) {
    png_image_free(&png);
    return {};
  }
  bytes.resize(size);
  return "data:image/png;base64," + base64(bytes);
}

}  // namespace waywright
