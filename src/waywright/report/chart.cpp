#include "waywright/report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/svg_writer.hpp"
#include "waywright/report/text_size.hpp"

namespace waywright {
namespace {

constexpr double left = 58.0, top = 26.0, bottom = 30.0;  // px around the plot

constexpr double legend_line = 18.0;  // px

/// A round step that gives about `count` of them.
double round_step(double range, double count) {
  if (!(range > 0.0)) return 1.0;
  const double raw = range / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double k : {1.0, 2.0, 5.0}) {
    if (k * power >= raw) return k * power;
  }
  return 10.0 * power;
}

const char* band_style(int direction) { return direction == 1 ? "bandfwd" : direction == -1 ? "bandback" : "bandside"; }
const char* band_name(int direction) { return direction == 1 ? "forward" : direction == -1 ? "back" : direction == 2 ? "left" : "right"; }

}  // namespace

std::string chart_svg(const Chart& chart, double width, double height) {
  if (chart.s.empty() && chart.series.empty()) return {};
  double low = 0.0, high = 0.0, end = 1e-9;
  const auto reach = [&](const std::vector<double>& s, const std::vector<double>& values) {
    for (const double v : values) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
    if (!s.empty()) end = std::max(end, s.back());
  };
  reach(chart.s, chart.value);
  for (const ChartSeries& series : chart.series) reach(series.s, series.value);
  for (const double limit : chart.ceiling) {
    if (std::isfinite(limit)) high = std::max(high, limit);
  }
  for (const ChartLimit& limit : chart.limits) {
    low = std::min(low, limit.value);
    high = std::max(high, limit.value);
  }
  if (chart.range) {
    low = std::min(low, chart.range->first);
    high = std::max(high, chart.range->second);
  }
  const double right = chart.right;
  if (!(high > low)) high = low + 1.0;
  const double pad = 0.06 * (high - low);
  high += pad;
  if (low < 0.0) low -= pad;
  const double plot_width = width - left - right;
  const double plot_height = height - top - bottom;
  const auto x_of = [&](double s) { return left + plot_width * s / end; };
  const auto y_of = [&](double v) { return top + plot_height * (high - v) / (high - low); };

  const double whole_height = height + legend_line * static_cast<double>(chart.series.size());
  std::string out = fmt::format(
      "<svg class=\"ww\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" role=\"img\"><title>{2}</title>"
      "<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n",
      fixed(width), fixed(whole_height), escaped(chart.title));
  for (std::size_t i = 0; i < chart.s.size();) {  // bands by direction
    std::size_t k = i;
    while (k + 1 < chart.s.size() && chart.direction[k + 1] == chart.direction[i]) ++k;
    const double a = x_of(chart.s[i]);
    const double b = x_of(chart.s[k]);
    if (chart.direction[i] != 0) {
      out += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                         band_style(chart.direction[i]), fixed(a), fixed(top), fixed(b - a),
                         fixed(plot_height));
      const std::string name = band_name(chart.direction[i]);
      if (chart.names_bands && b - a > text_width(name, 12.0, false) + 6.0)
        out += fmt::format("<text class=\"small middle\" x=\"{}\" y=\"{}\">{}</text>", fixed(0.5 * (a + b)), fixed(top + plot_height - 5.0), name);
    }
    const bool is_turn = chart.direction[i] == 0 || (i > 0 && chart.direction[i - 1] == 0);
    if (i > 0 || is_turn)
      out += fmt::format("<line class=\"{3}\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/>\n", fixed(a),
                         fixed(top), fixed(top + plot_height), is_turn ? "spin" : "change");
    i = k + 1;
  }
  const double step = round_step(high - low, 4.0);
  for (double v = std::ceil(low / step) * step; v <= high; v += step) {
    const double value = std::abs(v) < 1e-9 * step ? 0.0 : v;
    out += fmt::format(
        "<line class=\"gridline\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/><text class=\"small end\" "
        "x=\"{}\" y=\"{}\">{}</text>\n",
        fixed(left), fixed(y_of(v)), fixed(width - right), fixed(y_of(v)), fixed(left - 6),
        fixed(y_of(v) + 4), fixed(value, 3));
  }
  for (const double at : chart.stops) {
    out += fmt::format("<line class=\"axis\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/>\n",
                       fixed(x_of(at)), fixed(top), fixed(top + plot_height));
  }
  for (const ChartLimit& border : chart.borders) {
    const double x = x_of(border.value);
    if (border.value > 0.0)
      out += fmt::format("<line class=\"axis\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/>\n", fixed(x), fixed(top), fixed(top + plot_height));
    out += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n", fixed(x + 4.0), fixed(top + 13.0), escaped(border.name));
  }
  const double s_step = round_step(end, plot_width / 80.0);
  for (double s = 0.0; s <= end * (1.0 + 1e-9); s += s_step) {
    out += fmt::format(
        "<line class=\"gridline\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/><text class=\"small middle\" "
        "x=\"{0}\" y=\"{3}\">{4}</text>\n",
        fixed(x_of(s)), fixed(top), fixed(top + plot_height), fixed(top + plot_height + 16), fixed(s));
  }
  if (!chart.axis.empty()) out += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>", fixed(4.0), fixed(top + plot_height + 16), escaped(chart.axis));
  const auto points_of = [&](const std::vector<double>& s, const std::vector<double>& values) {
    std::string points;
    for (std::size_t i = 0; i < s.size(); ++i) points += fixed(x_of(s[i])) + "," + fixed(y_of(values[i])) + " ";
    return points;
  };
  if (!chart.s.empty()) out += fmt::format("<polyline class=\"curve\" points=\"{}\"/>\n", points_of(chart.s, chart.value));
  double below = height + 4.0;
  for (const ChartSeries& series : chart.series) {
    out += fmt::format("<polyline fill=\"none\" {0} stroke-width=\"1.8\" points=\"{1}\"/>\n<line x1=\"{2}\" y1=\"{3}\" x2=\"{4}\" y2=\"{3}\" {0} stroke-width=\"3\"/>"
                       "<text class=\"small\" x=\"{5}\" y=\"{6}\">{7}</text>\n",
                       series.stroke, points_of(series.s, series.value), fixed(left), fixed(below - 4.0), fixed(left + 40.0), fixed(left + 48.0), fixed(below), escaped(series.name));
    below += legend_line;
  }
  for (std::size_t i = 0; i < chart.ceiling.size();) {
    if (!std::isfinite(chart.ceiling[i])) {
      ++i;
      continue;
    }
    std::string points;
    for (; i < chart.ceiling.size() && std::isfinite(chart.ceiling[i]); ++i) {
      if (i > 0 && std::isfinite(chart.ceiling[i - 1])) points += fixed(x_of(chart.s[i])) + "," + fixed(y_of(chart.ceiling[i - 1])) + " ";
      points += fixed(x_of(chart.s[i])) + "," + fixed(y_of(chart.ceiling[i])) + " ";
    }
    out += fmt::format("<polyline class=\"ceiling\" points=\"{}\"/>\n", points);
  }
  std::vector<double> names;  // where names stand: two limits close together keep theirs apart
  for (const ChartLimit& limit : chart.limits) {
    double y = y_of(limit.value) + 4.0;
    for (const double other : names) {
      if (std::abs(y - other) < 13.0) y = other + (y < other ? -13.0 : 13.0);
    }
    names.push_back(y);
    out += fmt::format(
        "<line class=\"limit\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/><text class=\"small\" x=\"{}\" "
        "y=\"{}\">{}</text>\n",
        fixed(left), fixed(y_of(limit.value)), fixed(width - right), fixed(y_of(limit.value)),
        fixed(width - right + 6), fixed(y), escaped(limit.name));
  }
  out += fmt::format("<text class=\"title\" x=\"{}\" y=\"16\">{}</text></svg>\n", fixed(left),
                     escaped(chart.title));
  return out;
}

}  // namespace waywright
