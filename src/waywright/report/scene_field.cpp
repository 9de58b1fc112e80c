#include "waywright/report/scene_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/geometry/contour.hpp"
#include "waywright/report/raster.hpp"

namespace waywright {
namespace {

constexpr Rgba tint{112, 84, 176, 0};                    // one on light pages and on dark ones: it is laid over the paper
constexpr double faintest = 0.03, strongest = 0.58;      // of the tint
constexpr int tints = 40;
constexpr std::size_t most_contour_points = 9000, most_stream_points = 6000;
constexpr double finest = 0.3, coarsest = 3.0;           // px off a line that is drawn
constexpr double least_closed = 6.0, least_open = 24.0;  // px: shorter contours are specks, most of them between a wall and the nodes beside it
constexpr double head_long = 6.0, head_wide = 3.2, between_heads = 110.0;  // px

double strength(double share) { return faintest + (strongest - faintest) * share; }

std::string heat(const SvgWriter& svg, const FieldPicture& field) {
  std::vector<Rgba> palette{{0, 0, 0, 0}};
  for (int i = 0; i < tints; ++i) {
    Rgba c = tint;
    c.alpha = static_cast<std::uint8_t>(std::lround(255.0 * strength((i + 0.5) / tints)));
    palette.push_back(c);
  }
  std::vector<std::uint8_t> indices(field.shares.size(), 0);
  const auto columns = static_cast<std::size_t>(field.columns), rows = static_cast<std::size_t>(field.rows);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const double share = field.shares[(rows - 1 - i / columns) * columns + i % columns];  // the picture's rows go down
    if (!std::isnan(share)) indices[i] = static_cast<std::uint8_t>(1 + std::min(tints - 1, static_cast<int>(share * tints)));
  }
  const std::string address = png_address(field.columns, field.rows, indices, palette);
  if (address.empty()) return {};
  const Vec2 corner = svg.view()(field.origin + field.cell * Vec2{-0.5, field.rows - 0.5});
  return fmt::format("<image class=\"fieldheat\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"{}\"/>\n", fixed(corner.x), fixed(corner.y),
                     fixed(field.columns * field.cell * svg.view().scale), fixed(field.rows * field.cell * svg.view().scale), address);
}

struct Stroke {
  Polyline points;  ///< px
  bool is_closed = false;
};

std::size_t points_of(const std::vector<Stroke>& lines) {
  std::size_t sum = 0;
  for (const Stroke& line : lines) sum += line.points.size();
  return sum;
}

/// With as little left out as makes them `most` points.
std::vector<Stroke> thinned_to(const std::vector<Stroke>& lines, std::size_t most) {
  std::vector<Stroke> fewer;
  for (double off = finest; off <= coarsest; off *= 1.6) {
    fewer.clear();
    for (const Stroke& line : lines) {
      Polyline whole = line.points;
      if (line.is_closed) whole.push_back(whole.front());
      whole = simplified(whole, off);
      if (line.is_closed) whole.pop_back();
      if (whole.size() > 1) fewer.push_back({std::move(whole), line.is_closed});
    }
    if (points_of(fewer) <= most) break;
  }
  return fewer;
}

/// In tenths of a pixel, each point from the one before.
std::string path_data(const std::vector<Stroke>& lines) {
  std::string d;
  const auto number = [&](long tenths, bool first) {
    const std::string text = fixed(0.1 * static_cast<double>(tenths), 1);
    if (!first && text.front() != '-') d += ' ';
    d += text;
  };
  for (const Stroke& line : lines) {
    long x = 0, y = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const long to_x = std::lround(10.0 * line.points[i].x), to_y = std::lround(10.0 * line.points[i].y);
      if (i > 0 && to_x == x && to_y == y) continue;
      d += i == 0 ? 'M' : 'l';
      number(i == 0 ? to_x : to_x - x, true);
      number(i == 0 ? to_y : to_y - y, false);
      x = to_x;
      y = to_y;
    }
    if (line.is_closed) d += 'z';
  }
  return d;
}

double length_in_pixels(const Stroke& line) {
  double sum = line.is_closed ? distance(line.points.back(), line.points.front()) : 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i) sum += distance(line.points[i - 1], line.points[i]);
  return sum;
}

std::vector<Stroke> contours(const SvgWriter& svg, const FieldPicture& field) {
  std::vector<Stroke> lines;
  for (std::size_t every = 1; every <= field.levels.size(); every *= 2) {
    std::vector<Stroke> all;
    for (std::size_t k = (every - 1) / 2; k < field.levels.size(); k += every) {
      for (const ContourLine& contour : contour_lines(field.shares, field.columns, field.rows, field.levels[k])) {
        Stroke line{{}, contour.is_closed};
        for (const Vec2 p : contour.points) line.points.push_back(svg.view()(field.origin + field.cell * p));
        if (length_in_pixels(line) >= (line.is_closed ? least_closed : least_open)) all.push_back(std::move(line));
      }
    }
    lines = thinned_to(all, most_contour_points);
    if (points_of(lines) <= most_contour_points) return lines;
  }
  return {};
}

std::vector<Stroke> streams(const SvgWriter& svg, const FieldPicture& field) {
  std::vector<Stroke> lines;
  for (const Polyline& line : field.streamlines) {
    Stroke& stroke = lines.emplace_back();
    for (const Vec2 p : line) stroke.points.push_back(svg.view()(p));
  }
  lines = thinned_to(lines, most_stream_points);
  while (points_of(lines) > most_stream_points && !lines.empty()) lines.pop_back();  // the latest are the shortest
  return lines;
}

/// Small arrows on the way, the first halfway to the second.
std::string heads(const std::vector<Stroke>& lines) {
  std::string d;
  for (const Stroke& line : lines) {
    double next = std::min(0.5 * between_heads, 0.6 * length_in_pixels(line)), way = 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Vec2 a = line.points[i - 1], b = line.points[i];
      const double step = distance(a, b);
      for (; step > 0.0 && way + step >= next; next += between_heads) {
        const Vec2 along = (1.0 / step) * (b - a), tip = a + (next - way) * along, back = tip - head_long * along, aside = 0.5 * head_wide * left_of(along);
        const Vec2 one = back + aside, other = back - aside;
        d += fmt::format("M{} {}L{} {}L{} {}z", fixed(tip.x, 1), fixed(tip.y, 1), fixed(one.x, 1), fixed(one.y, 1), fixed(other.x, 1), fixed(other.y, 1));
      }
      way += step;
    }
  }
  return d;
}

using Kind = FieldPicture::Critical::Kind;

std::size_t count_of(const std::vector<FieldPicture::Critical>& critical, Kind kind) {
  return static_cast<std::size_t>(std::count_if(critical.begin(), critical.end(), [&](const FieldPicture::Critical& c) { return c.kind == kind; }));
}

/// Those that are drawn, what matters most first.
std::vector<FieldPicture::Critical> marked(const FieldPicture& field, const View& view) {
  constexpr double room = 8.0;  // px
  std::vector<FieldPicture::Critical> marks;
  for (const Kind kind : {Kind::trap, Kind::minimum, Kind::saddle, Kind::maximum}) {
    for (const FieldPicture::Critical& c : field.critical) {
      if (c.kind != kind || std::any_of(marks.begin(), marks.end(), [&](const FieldPicture::Critical& other) { return distance(view(other.at), view(c.at)) < room; })) continue;
      marks.push_back(c);
    }
  }
  return marks;
}

}  // namespace

void draw_field(SvgWriter& svg, const FieldPicture& field) {
  svg.raw(fmt::format("<defs><linearGradient id=\"fieldbar\"><stop offset=\"0\" stop-color=\"rgb({0},{1},{2})\" stop-opacity=\"{3}\"/><stop offset=\"1\" stop-color=\"rgb({0},{1},{2})\" "
                      "stop-opacity=\"{4}\"/></linearGradient></defs>\n",
                      tint.red, tint.green, tint.blue, faintest, strongest));
  if (field.columns < 1 || field.rows < 1) return;
  svg.raw(heat(svg, field));
  if (const std::string d = path_data(contours(svg, field)); !d.empty()) svg.raw(fmt::format("<path class=\"contour\" d=\"{}\"/>\n", d));
  const std::vector<Stroke> down = streams(svg, field);
  if (down.empty()) return;
  svg.raw(fmt::format("<path class=\"stream\" d=\"{}\"/>\n<path class=\"streamhead\" d=\"{}\"/>\n", path_data(down), heads(down)));
}

void draw_field_marks(SvgWriter& svg, const FieldPicture& field) {
  std::vector<FieldPicture::Critical> marks = marked(field, svg.view());
  std::reverse(marks.begin(), marks.end());  // the trap lies on top
  for (const FieldPicture::Critical& c : marks) {
    const Vec2 p = svg.view()(c.at);
    const std::string shape = critical_mark(c.kind == Kind::saddle    ? LegendEntry::Shape::cross
                                            : c.kind == Kind::minimum ? LegendEntry::Shape::hollow
                                            : c.kind == Kind::maximum ? LegendEntry::Shape::peak
                                                                      : LegendEntry::Shape::trap,
                                            p.x, p.y);
    svg.raw(shape + "\n");
  }
}

std::vector<LegendEntry> field_legend(const FieldPicture& field, const View& view) {
  using Shape = LegendEntry::Shape;
  std::vector<LegendEntry> entries;
  entries.push_back({"fieldbar", Shape::box, field.name + ", from low at the goal to high, by rank"});
  entries.push_back({"contour", Shape::line, "equal values"});
  if (!field.streamlines.empty()) entries.push_back({"stream", Shape::line, "the way down"});
  const std::vector<FieldPicture::Critical> marks = marked(field, view);
  const auto counted = [&](Kind kind, const char* one, const char* more) {
    const std::size_t n = count_of(field.critical, kind), drawn = count_of(marks, kind);
    return n == 1 ? std::string{one} : fmt::format("{} {}{}", n, more, drawn < n ? fmt::format("; {} have room", drawn) : std::string{});
  };
  if (count_of(field.critical, Kind::trap) > 0) entries.push_back({"", Shape::trap, "the trap: the run ended here"});
  if (count_of(field.critical, Kind::minimum) > 0) entries.push_back({"", Shape::hollow, counted(Kind::minimum, "local minimum, another trap than the goal", "local minima, each a trap")});
  if (count_of(field.critical, Kind::saddle) > 0) entries.push_back({"", Shape::cross, counted(Kind::saddle, "saddle: the way down parts", "saddles: the way down parts")});
  if (count_of(field.critical, Kind::maximum) > 0) entries.push_back({"", Shape::peak, counted(Kind::maximum, "local maximum", "local maxima")});
  return entries;
}

}  // namespace waywright
