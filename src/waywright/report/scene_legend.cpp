// What the colours and marks of the picture mean.
#include <fmt/format.h>

#include "waywright/report/scene_parts.hpp"

namespace waywright {
namespace {

/// A sample of the mark, 22 px wide, on the text's base line.
std::string mark(const LegendEntry& entry, double x, double y) {
  using Shape = LegendEntry::Shape;
  switch (entry.shape) {
    case Shape::line:
      return fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>", entry.style,
                         fixed(x), fixed(y - 4), fixed(x + 22), fixed(y - 4));
    case Shape::box:
      return fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"22\" height=\"10\"/>", entry.style,
                         fixed(x), fixed(y - 9));
    case Shape::dot:
      return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"3.5\"/>", entry.style, fixed(x + 11),
                         fixed(y - 4));
    case Shape::square:
      return fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"8\" height=\"8\"/>", entry.style,
                         fixed(x + 7), fixed(y - 8));
    case Shape::none:
      break;
  }
  return {};
}

double width_of(const LegendEntry& entry) {
  return (entry.shape == LegendEntry::Shape::none ? 14.0 : 42.0) +
         6.4 * static_cast<double>(entry.text.size());
}

}  // namespace

double draw_legend(SvgWriter& svg, const std::vector<LegendEntry>& entries, double width, double y) {
  double x = left_gutter;
  for (const LegendEntry& e : entries) {
    if (x > left_gutter && x + width_of(e) > width) {
      x = left_gutter;
      y += 20.0;
    }
    const double text = e.shape == LegendEntry::Shape::none ? x : x + 28.0;
    svg.raw(fmt::format("{}<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n", mark(e, x, y), fixed(text),
                        fixed(y), escaped(e.text)));
    x += width_of(e);
  }
  return y;
}

std::string legend_html(const std::vector<LegendEntry>& entries) {
  std::string out = "<ul class=\"legend\">\n";
  for (const LegendEntry& e : entries) {
    const std::string shape = mark(e, 0.0, 10.0);
    out +=
        fmt::format("<li>{}{}</li>\n",
                    shape.empty() ? "" : "<svg class=\"ww\" width=\"22\" height=\"12\">" + shape + "</svg>",
                    escaped(e.text));
  }
  return out + "</ul>\n";
}

}  // namespace waywright
