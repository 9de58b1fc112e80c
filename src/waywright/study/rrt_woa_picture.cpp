#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/scene_parts.hpp"
#include "waywright/study/reproduce_rrt_woa.hpp"

namespace waywright::rrt_woa {
namespace {

constexpr double gap = 18.0, top = 62.0, title = 34.0, foot = 20.0;  // px
constexpr std::size_t columns = 4;

/// One table: length over the parameter's rows, in per cent of its own mean, printed (dashed) and ours with its interval.
struct Panel {
  double x, y, width, height;  // px, of the plot
  double most;                 // %, at its upper edge; as much below at its lower one

  std::string place(double share, double percent) const { return fmt::format("{},{}", fixed(x + share * width), fixed(y + 0.5 * height * (1.0 - percent / most))); }
};

std::vector<std::vector<Row>> lines_of(const Table& table) {
  std::vector<std::vector<Row>> lines;
  for (const Row& row : table.rows) {
    if (lines.empty() || (table.parameter == "lambda" && lines.back().back().start != row.start)) lines.emplace_back();
    lines.back().push_back(row);
  }
  return lines;
}

template <class Value>
double mean_of(const std::vector<Row>& rows, Value&& value) {
  double sum = 0.0;
  for (const Row& row : rows) sum += value(row);
  return sum / static_cast<double>(rows.size());
}

double printed(const Row& row) { return row.published.metres; }
double ours(const Row& row) { return row.ours.metres.value; }

std::string panel_of(const Table& table, double x, double y, double width, double height) {
  const auto lines = lines_of(table);
  Panel panel{x, y + title, width, height, 0.5};
  for (const std::vector<Row>& line : lines) {
    const double p = mean_of(line, printed), o = mean_of(line, ours);
    for (const Row& row : line) {
      panel.most = std::max({panel.most, 105.0 * std::abs(printed(row) / p - 1.0), 105.0 * (std::abs(ours(row) / o - 1.0) + row.ours.metres.half_width / o)});
    }
  }
  std::string out = fmt::format("<text class=\"key\" x=\"{}\" y=\"{}\">{} {}, {}</text>\n", fixed(x), fixed(y + 14.0), table.name, table.variant == Variant::local ? "local" : "global",
                                table.parameter);
  out += fmt::format("<text class=\"small\" x=\"{0}\" y=\"{1}\">±{2:.1f} %</text>\n<rect class=\"frame\" x=\"{0}\" y=\"{3}\" width=\"{4}\" height=\"{5}\"/>\n<line class=\"gridline\" x1=\"{0}\" "
                     "y1=\"{6}\" x2=\"{7}\" y2=\"{6}\"/>\n",
                     fixed(x), fixed(y + 30.0), panel.most, fixed(panel.y), fixed(width), fixed(height), fixed(panel.y + 0.5 * height), fixed(x + width));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<Row>& line = lines[i];
    const double p = mean_of(line, printed), o = mean_of(line, ours);
    std::string of_printed, of_ours, bars;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const double share = line.size() > 1 ? static_cast<double>(k) / static_cast<double>(line.size() - 1) : 0.5;
      of_printed += panel.place(share, 100.0 * (printed(line[k]) / p - 1.0)) + " ";
      of_ours += panel.place(share, 100.0 * (ours(line[k]) / o - 1.0)) + " ";
      const double half = 100.0 * line[k].ours.metres.half_width / o, at = 100.0 * (ours(line[k]) / o - 1.0);
      bars += fmt::format("M{}L{}", panel.place(share, at - half), panel.place(share, at + half));
    }
    const std::string colour = overlay_stroke(i).colour;
    out += fmt::format("<polyline fill=\"none\" stroke=\"{0}\" stroke-width=\"1.4\" stroke-dasharray=\"5 4\" points=\"{1}\"/>\n<polyline fill=\"none\" stroke=\"{0}\" stroke-width=\"2.4\" "
                       "points=\"{2}\"/>\n<path stroke=\"{0}\" stroke-width=\"1\" d=\"{3}\"/>\n",
                       colour, of_printed, of_ours, bars);
  }
  out += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{:g}</text>\n<text class=\"small end\" x=\"{}\" y=\"{}\">{:g}</text>\n", fixed(x), fixed(panel.y + height + 14.0), lines.front().front().value,
                     fixed(x + width), fixed(panel.y + height + 14.0), lines.back().back().value);
  return out;
}

}  // namespace

std::string svg(const Results& results, double width) {
  const double side = (width - gap * (columns + 1)) / columns, height = 0.6 * side;
  std::string body = fmt::format(
      "<text class=\"key\" x=\"{0}\" y=\"22\">Mean length against each parameter, in % of the mean of its own line: dashed as printed, solid here with 95 % intervals ({1} seeds on each of five maps).</text>\n"
      "<text class=\"small\" x=\"{0}\" y=\"42\">Tables of lambda: a line for each a0 = 2, 4, 6, the parameter from 0 to a0. Lengths themselves cannot be compared: the publication's maps have no scale.</text>\n",
      fixed(gap), results.runs);
  for (std::size_t i = 0; i < results.tables.size(); ++i) {
    const double x = gap + static_cast<double>(i % columns) * (side + gap), y = top + static_cast<double>(i / columns) * (height + title + foot + gap);
    body += panel_of(results.tables[i], x, y, side, height);
  }
  const auto rows = static_cast<double>((results.tables.size() + columns - 1) / columns);
  return framed(std::move(body), width, top + rows * (height + title + foot + gap), "Parameter study of the publication on RRT* with the whale optimisation algorithm");
}

}  // namespace waywright::rrt_woa
