#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/svg_writer.hpp"
#include "waywright/study/pareto.hpp"

namespace waywright {
namespace {

constexpr double left = 70.0, right = 30.0, top = 44.0, bottom = 48.0, height = 420.0;  // px

/// A scale with a little room at both ends and round ticks.
struct Axis {
  double low, high, step;
  Axis(double least, double most) {
    const double range = std::max({most - least, 1e-3, 1e-6 * std::abs(most)});
    low = least - 0.08 * range;
    high = most + 0.08 * range;
    const double raw = (high - low) / 6.0;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    step = 10.0 * power;
    for (const double k : {5.0, 2.0, 1.0}) {
      if (k * power >= raw) step = k * power;
    }
  }
  double share(double v) const { return (v - low) / (high - low); }
};

}  // namespace

std::string front_svg(const Front& front, double width) {
  std::string body;
  const double plot_width = width - left - right, plot_height = height - top - bottom;
  if (front.plans.empty()) {
    body = fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">no proven plan</text>\n", fixed(left), fixed(top + 20.0));
  } else {
    const auto range = [&](auto value) {
      const auto [low, high] = std::minmax_element(front.plans.begin(), front.plans.end(), [&](const Plan& a, const Plan& b) { return value(a) < value(b); });
      return std::pair{value(*low), value(*high)};
    };
    const auto length = [](const Plan& p) { return p.metrics.length; };
    const auto clearance = [](const Plan& p) { return p.certificate.clearance; };
    const auto curvature = [](const Plan& p) { return p.metrics.max_curvature; };
    const auto [shortest, longest] = range(length);
    const auto [nearest, farthest] = range(clearance);
    const auto [mildest, sharpest] = range(curvature);
    const Axis x{shortest, longest}, y{nearest, farthest};
    const auto x_of = [&](double v) { return left + plot_width * x.share(v); };
    const auto y_of = [&](double v) { return top + plot_height * (1.0 - y.share(v)); };
    for (double v = std::ceil(x.low / x.step) * x.step; v <= x.high; v += x.step) {
      body += fmt::format("<line class=\"gridline\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/><text class=\"small middle\" x=\"{0}\" y=\"{3}\">{4}</text>\n", fixed(x_of(v)),
                          fixed(top), fixed(top + plot_height), fixed(top + plot_height + 16.0), fixed(v, 2));
    }
    for (double v = std::ceil(y.low / y.step) * y.step; v <= y.high; v += y.step) {
      body += fmt::format("<line class=\"gridline\" x1=\"{0}\" y1=\"{1}\" x2=\"{2}\" y2=\"{1}\"/><text class=\"small end\" x=\"{3}\" y=\"{4}\">{5}</text>\n", fixed(left), fixed(y_of(v)),
                          fixed(width - right), fixed(left - 6.0), fixed(y_of(v) + 4.0), fixed(v, 3));
    }
    for (std::size_t i = 0; i < front.plans.size(); ++i) {
      const Plan& p = front.plans[i];
      const double bend = sharpest > mildest ? (curvature(p) - mildest) / (sharpest - mildest) : 0.0;
      body += fmt::format("<circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\" fill=\"#0072b2\" fill-opacity=\".35\" stroke=\"#0072b2\"/><text class=\"small middle\" x=\"{0}\" y=\"{3}\">{4}</text>\n",
                          fixed(x_of(length(p))), fixed(y_of(clearance(p))), fixed(5.0 + 9.0 * bend), fixed(y_of(clearance(p)) - 8.0 - 9.0 * bend), i + 1);
    }
    body += fmt::format("<text class=\"small end\" x=\"{}\" y=\"{}\">length in m</text>\n", fixed(width - right), fixed(height - 12.0));
    body += fmt::format("<text class=\"title\" x=\"{}\" y=\"18\">Proven clearance in m over length; larger dots bend more sharply ({} to {} 1/m)</text>\n", fixed(left),
                        fixed(mildest, 3), fixed(sharpest, 3));
  }
  return fmt::format("<svg class=\"ww\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\"><title>Trade-offs</title><style>{2}</style>"
                     "<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n{3}</svg>\n",
                     fixed(width), fixed(height), picture_styles(), body);
}

}  // namespace waywright
