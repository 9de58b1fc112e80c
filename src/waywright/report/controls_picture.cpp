#include "waywright/report/controls_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/chart.hpp"
#include "waywright/report/svg_writer.hpp"

namespace waywright {
namespace {

constexpr double width = 860.0, height = 190.0, wheel_height = 150.0, title_height = 44.0, gap = 10.0;  // px
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

/// Does the vehicle ever go sideways?
bool slides(std::span<const ControlRow> rows) {
  return std::any_of(rows.begin(), rows.end(), [](const ControlRow& row) { return row.twist.left != 0.0; });
}

/// Where the vehicle goes, seen from itself: mainly ahead, back, to the left or to the right, each as Chart has it. The main way changes where another is clearly more.
std::vector<int> directions_of(std::span<const ControlRow> rows) {
  constexpr double clearly = 1.2;
  const auto sign = [](double v) { return v > 0.0 ? 1 : -1; };
  std::vector<int> directions;
  int before = 0;
  for (const ControlRow& row : rows) {
    const double ahead = std::abs(row.twist.forward), aside = std::abs(row.twist.left);
    const bool was_aside = std::abs(before) == 2;
    const bool is_aside = was_aside ? ahead <= clearly * aside : aside > clearly * ahead || (before == 0 && aside > ahead);
    before = ahead == 0.0 && aside == 0.0 ? 0 : is_aside && aside > 0.0 ? 2 * sign(row.twist.left) : ahead > 0.0 ? sign(row.twist.forward) : 2 * sign(row.twist.left);
    directions.push_back(before);
  }
  return directions;
}

Chart chart_of(std::string title, std::span<const ControlRow> rows, const std::vector<int>& directions, const auto& value) {
  Chart chart;
  chart.title = std::move(title);
  chart.axis = "t in s";
  hold(rows, value, chart.s, chart.value);
  for (std::size_t i = 0; i < rows.size(); ++i) chart.direction.insert(chart.direction.end(), i + 1 < rows.size() ? 2 : 1, directions[i]);
  return chart;
}

/// Charts below each other, or of wheels beside each other as the wheels lie, seen from above with the front upwards.
class Page {
 public:
  void write(const std::string& title) {
    below_ += 16.0;
    body_ += fmt::format("<text class=\"title\" x=\"58\" y=\"{}\">{}</text>\n", fixed(below_), escaped(title));
    below_ += 4.0;
  }
  void add(const Chart& chart, double high) { add(chart, 0.0, width, high, true); }
  /// One of each wheel, with one axis of values for all.
  void add_wheels(std::vector<Chart> charts, double high) {
    constexpr double column = 0.5 * width;
    double low = 0.0, top = 0.0;
    for (const Chart& chart : charts) {
      for (const double v : chart.value) low = std::min(low, v), top = std::max(top, v);
    }
    for (std::size_t k = 0; k < charts.size(); ++k) {
      charts[k].range = {low, top};
      charts[k].right = 44.0;
      add(charts[k], k % 2 == 0 ? 0.0 : column, column, high, k % 2 == 1 || k + 1 == charts.size());
    }
  }
  double below() const { return below_; }
  const std::string& body() const { return body_; }

 private:
  void add(const Chart& chart, double x, double wide, double high, bool ends_row) {
    std::string svg = chart_svg(chart, wide, high);
    svg.insert(4, fmt::format(" x=\"{}\" y=\"{}\"", fixed(x), fixed(below_)));  // after "<svg"
    body_ += svg;
    if (ends_row) below_ += high + gap;
  }
  std::string body_;
  double below_ = title_height;
};

}  // namespace

std::string controls_svg(const Vehicle& vehicle, const std::string& title, std::span<const ControlRow> rows, const WheelTorques* torques) {
  const Limits& limits = vehicle.limits;
  const bool is_sideways = slides(rows);
  const std::vector<int> directions = directions_of(rows);
  const auto chart = [&](std::string name, const auto& value) { return chart_of(std::move(name), rows, directions, value); };
  const auto both_ways = [](double limit) { return std::vector<ChartLimit>{{limit, "limit"}, {-limit, "limit"}}; };
  Page page;
  Chart speed = chart(is_sideways ? "Speed forward v_x in m/s" : "Speed v in m/s, forward positive", [](const ControlRow& row) { return row.twist.forward; });
  const bool goes_back = std::any_of(rows.begin(), rows.end(), [](const ControlRow& row) { return row.twist.forward < 0.0; });
  speed.limits = {{limits.speed, goes_back ? "limit forw." : "limit"}};
  if (goes_back) speed.limits.push_back({-limits.reverse_speed, "limit backw."});
  Chart aside = chart("Speed sideways v_y in m/s, left positive", [](const ControlRow& row) { return row.twist.left; });
  aside.names_bands = true;
  if (is_sideways) {
    // One scale, so that the two compare.
    const auto [least, greatest] = std::minmax_element(aside.value.begin(), aside.value.end());
    const auto [back, ahead] = std::minmax_element(speed.value.begin(), speed.value.end());
    speed.range = aside.range = {std::min({*least, *back, goes_back ? -limits.reverse_speed : 0.0}), std::max({*greatest, *ahead, limits.speed})};
  }
  page.add(speed, height);
  if (is_sideways) page.add(aside, height);
  Chart turn = chart("Turning rate ω in rad/s, left positive", [](const ControlRow& row) { return row.twist.turn; });
  if (limits.angular_speed) turn.limits = both_ways(*limits.angular_speed);
  page.add(turn, height);
  const std::vector<WheelColumn> columns = wheel_columns(vehicle.drive);
  if (const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive)) {
    Chart angle = chart("Steering angle in degrees", [&](const ControlRow& row) { return degrees * wheel_values(vehicle.drive, row)[0]; });
    angle.limits = both_ways(degrees * tricycle->max_steering);
    page.add(angle, height);
    page.add(chart("Speed of the steered wheel in m/s", [&](const ControlRow& row) { return wheel_values(vehicle.drive, row)[1]; }), height);
  } else {
    page.write(fmt::format("Wheels in {}, driving forward positive", columns.front().unit));
    std::vector<Chart> wheels;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      wheels.push_back(chart(spaced(columns[k].name), [&](const ControlRow& row) { return wheel_values(vehicle.drive, row)[k]; }));
      if (torques != nullptr && torques->motors.most_speed > 0.0) wheels.back().limits = both_ways(torques->motors.most_speed);
    }
    page.add_wheels(std::move(wheels), wheel_height);
  }
  if (torques != nullptr) {
    page.write("Torques of the motors at the wheels in N·m, driving forward positive");
    std::vector<Chart> wheels;
    for (std::size_t k = 0; k < torque_columns.size(); ++k) {
      const auto torque = torque_columns[k].torque;
      wheels.push_back(chart(spaced(columns[k].name), [&](const ControlRow& row) { return torques->rows[static_cast<std::size_t>(&row - rows.data())].*torque; }));
      if (torques->motors.most_torque > 0.0) wheels.back().limits = both_ways(torques->motors.most_torque);
    }
    page.add_wheels(std::move(wheels), wheel_height);
  }
  return fmt::format(
      "<svg class=\"ww\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\"><style>{2}</style><title>{3}</title>"
      "<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/><text class=\"title\" x=\"58\" y=\"18\">{3}</text>"
      "<text class=\"small\" x=\"58\" y=\"34\">{5}</text>\n{4}</svg>\n",
      fixed(width), fixed(page.below()), picture_styles(), escaped(title), page.body(),
      is_sideways ? "ground, by where the base mainly goes: blue forward, orange back, green sideways, none: it stands or turns on the spot"
                  : "orange ground: backwards, blue ground: forwards, none: the vehicle stands or turns on the spot");
}

}  // namespace waywright
