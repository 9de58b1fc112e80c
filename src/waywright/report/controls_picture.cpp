#include "waywright/report/controls_picture.hpp"

#include <fmt/format.h>

#include "waywright/report/chart.hpp"
#include "waywright/report/scene_parts.hpp"
#include "waywright/report/svg_writer.hpp"

namespace waywright {
namespace {

constexpr double width = 860.0, height = 190.0, title_height = 44.0, gap = 10.0, legend_line = 18.0;  // px
constexpr double degrees = 180.0 / pi;

std::string spaced(std::string name) {
  for (char& c : name) {
    if (c == '_') c = ' ';
  }
  return name;
}

/// Each command holds until the next: two points each.
void hold(std::span<const ControlRow> rows, const auto& value, std::vector<double>& time, std::vector<double>& values) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double v = value(rows[i]);
    time.push_back(rows[i].t);
    values.push_back(v);
    if (i + 1 < rows.size()) {
      time.push_back(rows[i + 1].t);
      values.push_back(v);
    }
  }
}

Chart chart_of(std::string title, std::span<const ControlRow> rows, const auto& value) {
  Chart chart;
  chart.title = std::move(title);
  chart.axis = "t in s";
  hold(rows, value, chart.s, chart.value);
  std::vector<double> unused;
  std::vector<double> forward;
  hold(rows, [](const ControlRow& row) { return row.twist.forward; }, unused, forward);
  for (const double v : forward) chart.direction.push_back(v > 0.0 ? 1 : v < 0.0 ? -1 : 0);
  return chart;
}

}  // namespace

std::string controls_svg(const Vehicle& vehicle, const std::string& title, std::span<const ControlRow> rows, const WheelTorques* torques) {
  const Limits& limits = vehicle.limits;
  std::vector<Chart> charts;
  charts.push_back(chart_of("Speed v in m/s, forward positive", rows, [](const ControlRow& row) { return row.twist.forward; }));
  bool goes_back = false;
  for (const ControlRow& row : rows) goes_back = goes_back || row.twist.forward < 0.0;
  charts.back().limits = {{limits.speed, goes_back ? "limit forw." : "limit"}};
  if (goes_back) charts.back().limits.push_back({-limits.reverse_speed, "limit backw."});
  charts.push_back(chart_of("Turning rate ω in rad/s, left positive", rows, [](const ControlRow& row) { return row.twist.turn; }));
  if (limits.angular_speed) charts.back().limits = {{*limits.angular_speed, "limit"}, {-*limits.angular_speed, "limit"}};
  const std::vector<WheelColumn> columns = wheel_columns(vehicle.drive);
  if (const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive)) {
    charts.push_back(chart_of("Steering angle in degrees", rows, [&](const ControlRow& row) { return degrees * wheel_values(vehicle.drive, row)[0]; }));
    charts.back().limits = {{degrees * tricycle->max_steering, "limit"}, {-degrees * tricycle->max_steering, "limit"}};
    charts.push_back(chart_of("Speed of the steered wheel in m/s", rows, [&](const ControlRow& row) { return wheel_values(vehicle.drive, row)[1]; }));
  } else {
    Chart chart;
    chart.title = fmt::format("Wheels in {}", columns.front().unit);
    chart.axis = "t in s";
    for (std::size_t k = 0; k < columns.size(); ++k) {
      ChartSeries series{spaced(columns[k].name), stroke_attributes(overlay_stroke(k)), {}, {}};
      hold(rows, [&](const ControlRow& row) { return wheel_values(vehicle.drive, row)[k]; }, series.s, series.value);
      chart.series.push_back(std::move(series));
    }
    if (torques != nullptr && torques->motors.most_speed > 0.0) chart.limits = {{torques->motors.most_speed, "limit"}, {-torques->motors.most_speed, "limit"}};
    charts.push_back(std::move(chart));
  }
  if (torques != nullptr) {
    Chart chart;
    chart.title = "Torques of the motors at the wheels in N·m, driving forward positive";
    chart.axis = "t in s";
    for (std::size_t k = 0; k < torque_columns.size(); ++k) {
      ChartSeries series{spaced(columns[k].name), stroke_attributes(overlay_stroke(k)), {}, {}};
      const auto torque = torque_columns[k].torque;
      hold(rows, [&](const ControlRow& row) { return torques->rows[static_cast<std::size_t>(&row - rows.data())].*torque; }, series.s, series.value);
      chart.series.push_back(std::move(series));
    }
    if (torques->motors.most_torque > 0.0) chart.limits = {{torques->motors.most_torque, "limit"}, {-torques->motors.most_torque, "limit"}};
    charts.push_back(std::move(chart));
  }
  std::string body;
  double below = title_height;
  for (const Chart& chart : charts) {
    std::string svg = chart_svg(chart, width, height);
    svg.insert(4, fmt::format(" y=\"{}\"", fixed(below)));  // after "<svg"
    body += svg;
    below += height + gap + legend_line * static_cast<double>(chart.series.size());
  }
  return fmt::format(
      "<svg class=\"ww\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\"><style>{2}</style><title>{3}</title>"
      "<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/><text class=\"title\" x=\"58\" y=\"18\">{3}</text>"
      "<text class=\"small\" x=\"58\" y=\"34\">orange ground: backwards, blue ground: forwards, none: the vehicle stands or turns on the spot</text>\n{4}</svg>\n",
      fixed(width), fixed(below), picture_styles(), escaped(title), body);
}

}  // namespace waywright
