// Building SVG text: numbers fixed to hundredths of a pixel, every string escaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/pose.hpp"

namespace waywright {

/// For text and attributes of XML and HTML; characters that XML does not allow become '?'.
std::string escaped(std::string_view text);

/// "12.34", never in scientific notation, "0" for what is not finite.
std::string fixed(double value, int digits = 2);

/// World metres to pixels: y up becomes y down.
struct View {
  double left = 0.0, top = 0.0;  ///< world x of the left edge, world y of the top edge
  double scale = 1.0;            ///< pixels per metre
  Vec2 operator()(Vec2 p) const { return {(p.x - left) * scale, (top - p.y) * scale}; }
};

class SvgWriter {
 public:
  explicit SvgWriter(View view) : view_{view} {}

  void open_group(std::string_view style_class, std::string_view extra = "");
  void close_group();
  /// World coordinates.
  void polygon(const std::vector<Vec2>& ring, std::string_view style_class);
  void polyline(const std::vector<Vec2>& points, std::string_view style_class);
  void stroked_polyline(const std::vector<Vec2>& points, std::string_view attributes, double width = 3.0);  ///< attributes: of the stroke, as XML; width in px
  void line(Vec2 a, Vec2 b, std::string_view style_class);
  void dot(Vec2 p, double pixels, std::string_view style_class);
  void square(Vec2 middle, double pixels, std::string_view style_class);
  /// Many rings as one shape, filled as their union where all turn the same way.
  void union_of(const std::vector<std::vector<Vec2>>& rings, std::string_view style_class);
  /// Text whose reference point is `offset` pixels from a world point.
  void label(Vec2 p, Vec2 offset, std::string_view text, std::string_view style_class);
  void raw(std::string_view svg) { out_ += svg; }
  const View& view() const { return view_; }
  std::string take() { return std::move(out_); }

 private:
  std::string points(const std::vector<Vec2>& ring) const;
  View view_;
  std::string out_;
};

/// The styles of all pictures, light and dark, safe for the colour-blind (Okabe and Ito's palette).
const std::string& picture_styles();

}  // namespace waywright
