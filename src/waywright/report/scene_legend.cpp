// What the colours and marks of the picture mean.
#include <fmt/format.h>

#include <algorithm>

#include "waywright/report/scene_parts.hpp"
#include "waywright/report/text_size.hpp"

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
    case Shape::cross:
    case Shape::hollow:
    case Shape::peak:
    case Shape::trap:
      return critical_mark(entry.shape, x + 11.0, y - 4.0);
    case Shape::none:
      break;
  }
  return {};
}

double width_of(const LegendEntry& entry) {
  return (entry.shape == LegendEntry::Shape::none ? 18.0 : 46.0) + text_width(entry.text, 12.0, false);
}

constexpr double letter = 7.8;  // px, of the overlay's legend, at least as wide as the text comes out

/// At blanks, colons and commas, else anywhere; by code points.
std::vector<std::string> wrapped(const std::string& text, std::size_t most) {
  std::vector<std::string> lines(1);
  std::size_t wide = 0, kept_wide = 0;
  std::size_t kept = 0;  // bytes of the last line up to a place to break it
  for (const char c : text) {
    const bool begins = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    if (begins && wide >= most) {
      std::string rest;
      if (kept > 0) {
        rest = lines.back().substr(kept);
        lines.back().resize(kept);
        wide -= kept_wide;
      } else {
        wide = 0;
      }
      lines.push_back(std::move(rest));
      kept = kept_wide = 0;
    }
    lines.back() += c;
    wide += begins ? 1 : 0;
    if (c == ' ' || c == ':' || c == ',') kept = lines.back().size(), kept_wide = wide;
  }
  return lines;
}

}  // namespace

std::string critical_mark(LegendEntry::Shape shape, double x, double y) {
  using Shape = LegendEntry::Shape;
  const auto both = [&](const char* style, const std::string& d) { return fmt::format("<path class=\"markhalo\" d=\"{0}\"/><path class=\"{1}\" d=\"{0}\"/>", d, style); };
  const auto from = [](double px, double py) { return fmt::format("M{} {}", fixed(px, 1), fixed(py, 1)); };
  switch (shape) {
    case Shape::cross: return both("saddle", from(x - 4, y - 4) + "l8 8m0-8l-8 8");
    case Shape::hollow: return both("minimum", from(x - 5, y - 4) + "h10l-5 9z");
    case Shape::peak: return both("maximum", from(x - 5, y + 4) + "h10l-5-9z");
    default: return both("trapmark", from(x - 6, y) + "a6 6 0 1 0 12 0a6 6 0 1 0-12 0m1.8-4.2l8.4 8.4m0-8.4l-8.4 8.4");
  }
}

double draw_overlay_legend(SvgWriter& svg, const std::vector<OverlayEntry>& entries, const std::string& shared, double width, double y) {
  constexpr double sample = 56.0, gap = 10.0, line_height = 19.0;  // px
  constexpr std::size_t many = 4;
  const auto write = [&](double x, const std::string& text) { svg.raw(fmt::format("<text class=\"key\" x=\"{}\" y=\"{}\">{}</text>\n", fixed(x), fixed(y), escaped(text))); };
  const auto letters = [](double pixels) { return static_cast<std::size_t>(std::max(12.0, pixels / letter)); };
  if (!shared.empty()) {
    for (const std::string& line : wrapped("all: " + shared, letters(width - left_gutter))) {
      write(left_gutter, line);
      y += line_height;
    }
  }
  std::size_t longest = 0;
  for (const OverlayEntry& e : entries) longest = std::max(longest, e.text.size());
  const double needed = sample + gap + letter * static_cast<double>(longest) + 2.0 * gap;
  const auto columns = entries.size() > many ? std::clamp<std::size_t>(static_cast<std::size_t>((width - left_gutter) / needed), 1, 3) : 1;
  const double column = (width - left_gutter) / static_cast<double>(columns);
  const std::size_t rows = (entries.size() + columns - 1) / columns;
  const double top = y;
  double end = y;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double x = left_gutter + column * static_cast<double>(i / std::max<std::size_t>(rows, 1));
    if (i % rows == 0) y = top;
    if (!entries[i].stroke.empty()) {
      svg.raw(fmt::format("<line x1=\"{0}\" y1=\"{1}\" x2=\"{2}\" y2=\"{1}\" {3} stroke-width=\"4\"/>\n", fixed(x), fixed(y - 5), fixed(x + sample), entries[i].stroke));
    }
    for (const std::string& line : wrapped(entries[i].text, letters(column - sample - gap))) {
      write(x + sample + gap, line);
      y += line_height;
    }
    end = std::max(end, y);
  }
  return end;
}

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
