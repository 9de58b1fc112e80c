#include "waywright/report/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/judge/judge.hpp"
#include "waywright/report/chart.hpp"
#include "waywright/report/scene_parts.hpp"
#include "waywright/report/spots.hpp"
#include "waywright/report/svg_writer.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

constexpr double broad = 780.0, narrow = 400.0, height = 168.0;  // px
constexpr double degrees = 180.0 / pi;
constexpr double least_top = 0.5;   // m of clearance that is shown at least
constexpr double top_factor = 6.0;  // of the required clearance

/// Where a chart of clearances is cut off: what is known of them ends at clearance_cap.
double top_of(double least, double required) { return std::min(std::max(least, top_factor * required), clearance_cap); }

/// A chart of one value a sample.
Chart chart_of(std::string title, const Plan& plan, const auto& value) {
  Chart chart;
  chart.title = std::move(title);
  for (std::size_t i = 0; i < plan.samples.size(); ++i) {
    chart.s.push_back(plan.samples[i].s);
    chart.direction.push_back(plan.samples[i].direction);
    chart.value.push_back(value(i));
  }
  for (const std::size_t i : steering_stops(plan)) chart.stops.push_back(plan.samples[i].s);
  constexpr std::size_t most_named = 30;  // more would stand on each other
  const std::vector<std::size_t> borders = leg_borders(plan);
  if (!borders.empty() && borders.size() < most_named) {
    chart.borders.push_back({0.0, "1"});
    for (std::size_t i = 0; i < borders.size(); ++i) chart.borders.push_back({plan.samples[borders[i]].s, fmt::format("{}", i + 2)});
  }
  return chart;
}

Chart clearance_chart(const Plan& plan, const AskedAlong& asked) {
  const std::vector<double>& clearance = asked.clearance;
  const double required = asked.required;
  // What is near matters: metres of room would press the requirement and the last approach into the axis.
  const double top = top_of(least_top, required);
  const bool over = *std::max_element(clearance.begin(), clearance.end()) >= top;
  Chart chart = chart_of(over ? fmt::format("Clearance in m, cut off at {:g} m", top) : "Clearance in m",
                         plan, [&](std::size_t i) { return std::min(clearance[i], top); });
  if (required > 0.0) chart.limits = {{required, "required"}};
  return chart;
}

/// A picture of its own brings its styles along.
std::string with_styles(std::string svg) {
  const std::size_t begin = svg.find('>');
  if (begin != std::string::npos) svg.insert(begin + 1, "<style>" + picture_styles() + "</style>");
  return svg;
}

}  // namespace

std::string charts_html(const Problem& problem, const Plan& plan) {
  if (plan.samples.size() < 2) return {};
  return charts_html(plan, {clearances_along(problem, plan.path, plan.samples), problem.required_clearance(), problem.pose_error_margin(),
                            zone_limits(problem, plan.samples, plan.certificate.tolerance).samples});
}

std::string charts_html(const Plan& plan, const AskedAlong& asked) {
  if (plan.samples.size() < 2) return {};
  const Vehicle& vehicle = plan.scenario.vehicle;
  const auto& samples = plan.samples;
  std::vector<Chart> charts;
  charts.push_back(
      chart_of("Curvature in 1/m, left positive", plan, [&](std::size_t i) { return samples[i].curvature; }));
  if (const double k = vehicle.max_curvature(); std::isfinite(k) && k < 100.0)
    charts.back().limits = {{k, "limit"}, {-k, "limit"}};
  if (const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive)) {
    // The followed curve bends in the direction of travel; backwards the same angle bends it the other way.
    charts.push_back(chart_of("Steering angle in degrees", plan, [&](std::size_t i) {
      return degrees * vehicle.steering_angle(samples[i].direction * samples[i].curvature);
    }));
    const double most = degrees * tricycle->max_steering;
    charts.back().limits = {{most, "limit"}, {-most, "limit"}};
  }
  charts.push_back(clearance_chart(plan, asked));
  charts.push_back(chart_of("Speed in m/s", plan, [&](std::size_t i) { return samples[i].speed; }));
  const Limits& limits = vehicle.limits;
  const bool alike = limits.speed == limits.reverse_speed;
  charts.back().limits = {{limits.speed, alike ? "limit" : "limit forw."}};
  if (!alike) charts.back().limits.push_back({limits.reverse_speed, "limit backw."});
  charts.back().ceiling = asked.zone_speed;

  const bool turns = std::any_of(samples.begin(), samples.end(), [](const Sample& s) { return s.direction == 0; });
  std::string out = fmt::format(
      "<p class=\"soft\">Orange ground: backwards, blue ground: forwards. Dotted line: change between "
      "forwards and backwards{}{}{}.{}</p>\n",
      turns ? "; pink line: turn on the spot" : "", asked.zone_speed.empty() ? "" : "; stepped line of the speed: limit of a zone", steering_stops(plan).empty() ? "" : "; solid line: stop where the curvature jumps",
      (plan.legs.size() > 1 ? std::string{" Solid lines with numbers: where a leg begins."} : std::string{}) +
          (asked.required > 0.0
               ? fmt::format(" Required: {} m of clearance{}.", fixed(asked.required, 4), asked.margin > 0.0 ? fmt::format(", {} m of it for the pose error", fixed(asked.margin, 4)) : "")
               : ""));
  for (const Chart& chart : charts) {
    out += "<div class=\"broad\">" + chart_svg(chart, broad, height) + "</div><div class=\"narrow\">" +
           chart_svg(chart, narrow, height) + "</div>\n";
  }
  return out;
}

std::string clearances_svg(const Problem& problem, const std::vector<std::pair<std::string, const Plan*>>& plans, double width) {
  constexpr double far = 2.0;  // m
  const double top = top_of(far, problem.required_clearance());
  Chart chart;
  bool is_cut = false;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const auto& [name, plan] = plans[i];
    if (plan->samples.empty()) continue;
    ChartSeries series{fmt::format("{} ({})", name, to_string(plan->status)), stroke_attributes(overlay_stroke(i)), {}, {}};
    const std::vector<double> clearance = clearances_along(problem, plan->path, plan->samples);
    for (std::size_t k = 0; k < clearance.size(); ++k) {
      series.s.push_back(plan->samples[k].s);
      series.value.push_back(std::min(clearance[k], top));
      is_cut = is_cut || clearance[k] >= top;
    }
    chart.series.push_back(std::move(series));
  }
  chart.title = is_cut ? fmt::format("Clearance along the path in m, cut off at {:g} m", top) : "Clearance along the path in m";
  if (problem.required_clearance() > 0.0) chart.limits = {{problem.required_clearance(), "required"}};
  return with_styles(chart_svg(chart, width, 300.0));
}

}  // namespace waywright
