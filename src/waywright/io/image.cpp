#include "waywright/io/image.hpp"

#include <fmt/format.h>
#include <png.h>

#include <cstring>
#include <utility>

namespace waywright {
namespace {

constexpr std::size_t pixels_per_byte = 1032 * 8;  // of a PNG, at most

tl::unexpected<InputError> refuse(const std::string& name, std::string problem, std::string allowed = "") {
  return tl::unexpected{InputError{name, "", std::move(problem), std::move(allowed)}};
}

bool is_png(const std::string& bytes) { return bytes.size() > 8 && bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0; }
bool is_pgm(const std::string& bytes) { return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '2'); }

std::string size_allowed() { return fmt::format("1 to {} pixels a side", largest_side); }

/// PGM's header and plain numbers: white space and comments between tokens.
class PgmReader {
 public:
  explicit PgmReader(const std::string& bytes) : bytes_{bytes}, at_{2} {}

  /// −1 where there is no number, or it is over a million.
  long number() {
    skip();
    if (at_ >= bytes_.size() || !digit()) return -1;
    long value = 0;
    while (at_ < bytes_.size() && digit()) {
      value = value * 10 + (bytes_[at_++] - '0');
      if (value > 1'000'000) return -1;
    }
    return value;
  }
  /// The one white space between header and binary pixels.
  std::size_t pixels_at() const { return at_ + 1; }

 private:
  bool digit() const { return bytes_[at_] >= '0' && bytes_[at_] <= '9'; }
  void skip() {
    while (at_ < bytes_.size()) {
      const char c = bytes_[at_];
      if (c == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f') {
        ++at_;
      } else {
        return;
      }
    }
  }
  const std::string& bytes_;
  std::size_t at_;
};

Parsed<GreyImage> decode_pgm(const std::string& bytes, const std::string& name) {
  const bool binary = bytes[1] == '5';
  PgmReader reader{bytes};
  const long width = reader.number();
  const long height = reader.number();
  const long most = reader.number();
  if (width < 0 || height < 0 || most < 0) return refuse(name, "the PGM header is broken", "P5 or P2, width, height, maximum");
  if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
    return refuse(name, fmt::format("the picture is {} × {} pixels", width, height), size_allowed());
  }
  if (most < 1 || most > 65535) return refuse(name, fmt::format("the PGM maximum is {}", most), "1 to 65535");
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const auto truncated = [&](std::size_t have) {
    return refuse(name, fmt::format("the picture is cut short: {} of {} pixels", have, count), "a whole picture");
  };
  const auto grey = [&](long value) { return static_cast<std::uint8_t>((value * 255 + most / 2) / most); };
  GreyImage image{static_cast<int>(width), static_cast<int>(height), {}};
  if (binary) {
    const std::size_t each = most > 255 ? 2 : 1;
    const std::size_t begin = reader.pixels_at();
    const std::size_t have = bytes.size() > begin ? (bytes.size() - begin) / each : 0;
    if (have < count) return truncated(have);
    image.pixels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto byte = [&](std::size_t k) { return static_cast<long>(static_cast<unsigned char>(bytes[begin + k])); };
      const long value = each == 1 ? byte(i) : byte(2 * i) * 256 + byte(2 * i + 1);
      image.pixels[i] = most == 255 && each == 1 ? static_cast<std::uint8_t>(value) : grey(value > most ? most : value);
    }
    return image;
  }
  if (bytes.size() / 2 + 1 < count) return truncated(0);  // every number takes a digit and a space
  image.pixels.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const long value = reader.number();
    if (value < 0) return truncated(i);
    image.pixels[i] = grey(value > most ? most : value);
  }
  return image;
}


Parsed<GreyImage> decode_png(const std::string& bytes, const std::string& name) {
  // libpng's simplified interface reports errors by value and needs no longjmp.
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    return refuse(name, fmt::format("the PNG cannot be read: {}", png.message), "a whole PNG");
  }
  if (png.width < 1 || png.height < 1 || png.width > largest_side || png.height > largest_side) {
    const auto sentence = fmt::format("the picture is {} × {} pixels", png.width, png.height);
    png_image_free(&png);
    return refuse(name, sentence, size_allowed());
  }
  // A few bytes must not ask for a gigabyte: deflate makes at most 1032 of one, and a pixel takes at least a bit.
  if (static_cast<std::size_t>(png.width) * png.height / pixels_per_byte > bytes.size()) {
    const auto sentence = fmt::format("the picture is cut short: {} bytes cannot hold {} × {} pixels", bytes.size(), png.width, png.height);
    png_image_free(&png);
    return refuse(name, sentence);
  }
  GreyImage image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  // Asked for as RGBA in file values, so that colours are averaged as they stand, whatever the transparency.
  png.format = PNG_FORMAT_RGBA;
  const std::size_t count = static_cast<std::size_t>(png.width) * png.height;
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, rgba.data(), 0, nullptr) == 0) {
    const auto sentence = fmt::format("the PNG cannot be read: {}", png.message);
    png_image_free(&png);
    return refuse(name, sentence, "a whole PNG");
  }
  image.pixels.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned sum = static_cast<unsigned>(rgba[4 * i]) + rgba[4 * i + 1] + rgba[4 * i + 2];
    image.pixels[i] = static_cast<std::uint8_t>((sum + 1) / 3);
    if (rgba[4 * i + 3] == 255) continue;
    image.see_through.resize(count);
    image.see_through[i] = true;
  }
  return image;
}

}  // namespace

Parsed<GreyImage> decode_image(const std::string& bytes, const std::string& name) {
  if (is_png(bytes)) return decode_png(bytes, name);
  if (is_pgm(bytes)) return decode_pgm(bytes, name);
  return refuse(name, "it is not a picture that can be read", "PGM (P2, P5) or PNG");
}

std::optional<InputError> refused_by_header(const std::string& head, const std::string& name) {
  long width = -1, height = -1;
  if (is_png(head)) {
    if (head.size() < 24) return std::nullopt;
    const auto word = [&](std::size_t at) {
      long value = 0;
      for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(head[at + i]);
      return value;
    };
    width = word(16);
    height = word(20);
  } else if (is_pgm(head)) {
    PgmReader reader{head};
    width = reader.number();
    height = reader.number();
    if (reader.number() < 0) return std::nullopt;  // the head ends before the header does, or it is broken
  }
  if (width <= largest_side && height <= largest_side) return std::nullopt;
  return InputError{name, "", fmt::format("the picture is {} × {} pixels", width, height), size_allowed()};
}

std::string encode_png(const GreyImage& image) {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = 0;
  if (png_image_write_to_memory(&png, nullptr, &size, 0, image.pixels.data(), 0, nullptr) == 0) return {};
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) return {};
  bytes.resize(size);
  return bytes;
}

}  // namespace waywright
