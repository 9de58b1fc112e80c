#include "waywright/study/merits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/metrics/grid_metrics.hpp"
#include "waywright/report/scene_parts.hpp"
#include "waywright/study/summary.hpp"

namespace waywright {
namespace {

constexpr std::array figures{"length", "turning", "risk", "power", "time"};
std::array<double, figures.size()> as_array(const Reductions& r) { return {r.length, r.turning, r.risk, r.power, r.time}; }

std::string percent(double value) {
  if (std::isfinite(value)) return fmt::format("{:+.1f}", value);
  return value < 0.0 ? "-inf" : "–";
}

std::vector<const Merits*> of_scenario(const std::vector<Merits>& merits, std::size_t scenario) {
  std::vector<const Merits*> some;
  for (const Merits& m : merits) {
    if (m.scenario == scenario) some.push_back(&m);
  }
  return some;
}

}  // namespace

std::vector<Merits> merits_of(const std::vector<Run>& runs, std::size_t scenarios, std::size_t contestants) {
  std::vector<Merits> all;
  for (std::size_t s = 0; s < scenarios; ++s) {
    for (std::size_t c = 0; c < contestants; ++c) {
      std::vector<double> length, turning, risk, time;
      for (const Run& run : runs) {
        if (run.scenario != s || run.contestant != c || run.plan.samples.empty()) continue;
        length.push_back(run.plan.metrics.length);
        turning.push_back(run.plan.metrics.turning);
        risk.push_back(run.plan.metrics.collision_risk);
        time.push_back(run.plan.metrics.travel_time);
      }
      if (length.empty()) continue;
      const auto median = [](const std::vector<double>& values) { return spread_of(values).median; };
      Merits m{s, c, median(length), median(turning), median(risk), 0.0, median(time)};
      m.power = residual_power(m.length, m.turning);
      all.push_back(m);
    }
  }
  return all;
}

Reductions reductions(const Merits& reference, const Merits& proposed) {
  return {reduction(reference.length, proposed.length), reduction(reference.turning, proposed.turning), reduction(reference.risk, proposed.risk),
          power_reduction(reference.power, proposed.power), reduction(reference.time, proposed.time)};
}

std::string merits_text(const std::vector<Merits>& merits, std::size_t scenario, const std::vector<std::string>& names) {
  const std::vector<const Merits*> some = of_scenario(merits, scenario);
  if (some.size() < 2) return "";
  std::size_t wide = 8;
  for (const Merits* m : some) wide = std::max(wide, names[m->contestant].size());
  std::string out = fmt::format("  {:<{}}  {:>9}  {:>7}  {:>8}  |  less than {}, %: {}\n", "", wide, "turning °", "risk m", "power %", names[some.front()->contestant], "length, turning, risk, power, time");
  for (const Merits* m : some) {
    out += fmt::format("  {:<{}}  {:>9.1f}  {:>7.3f}  {:>8.2f}  |", names[m->contestant], wide, m->turning * 180.0 / pi, m->risk, m->power);
    if (m != some.front()) {
      for (const double value : as_array(reductions(*some.front(), *m))) out += fmt::format("  {:>8}", percent(value));
    }
    out += "\n";
  }
  return out;
}

std::string merits_svg(const std::vector<Merits>& merits, std::size_t scenario, const std::vector<std::string>& names, const std::string& title, double width) {
  const std::vector<const Merits*> some = of_scenario(merits, scenario);
  if (some.size() < 2) return "";
  // Bars to the right: less than the first; to the left: more. What is beyond is cut, and its figure stands beside it.
  constexpr double bar = 14.0, between = 22.0, left = 90.0, right = 70.0, top = 64.0, most = 200.0;
  std::vector<std::array<double, figures.size()>> values;
  double low = 0.0, high = 0.0;
  for (std::size_t i = 1; i < some.size(); ++i) {
    values.push_back(as_array(reductions(*some.front(), *some[i])));
    for (double& v : values.back()) {
      v = std::isnan(v) ? 0.0 : std::clamp(v, -1e6, 1e6);
      low = std::max(-most, std::min(low, v));
      high = std::max(high, v);
    }
  }
  low = std::min(low, -5.0);
  high = std::max(high, 5.0);
  const double scale = (width - left - right - 60.0) / (high - low), zero = left + 60.0 - low * scale;
  std::string body = fmt::format("<text class=\"small\" x=\"12\" y=\"20\">{}: less than {} (to the right) or more (to the left), %</text>\n", escaped(title), escaped(names[some.front()->contestant]));
  double x = 12.0, y = 40.0;
  for (std::size_t i = 1; i < some.size(); ++i) {
    const std::string& name = names[some[i]->contestant];
    body += fmt::format("<rect x=\"{0}\" y=\"{1}\" width=\"12\" height=\"12\" fill=\"{2}\"/><text class=\"small\" x=\"{3}\" y=\"{4}\">{5}</text>\n", fixed(x), fixed(y - 10.0),
                        overlay_stroke(some[i]->contestant).colour, fixed(x + 18.0), fixed(y), escaped(name));
    y += 18.0;
  }
  y += top - 40.0;
  const double begin = y - 6.0;
  for (std::size_t f = 0; f < figures.size(); ++f) {
    body += fmt::format("<text class=\"small\" x=\"12\" y=\"{}\">{}</text>\n", fixed(y + 0.5 * bar * static_cast<double>(values.size()) + 4.0), figures[f]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double v = values[i][f], drawn = std::max(v, low);
      const double from = zero + std::min(drawn, 0.0) * scale, long_by = std::abs(drawn) * scale;
      body += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", fixed(from), fixed(y), fixed(std::max(long_by, 0.5)), fixed(bar - 2.0),
                          overlay_stroke(some[i + 1]->contestant).colour);
      body += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", fixed(v < 0.0 ? from - 4.0 : from + long_by + 4.0), fixed(y + bar - 3.5), v < 0.0 ? "end" : "start",
                          percent(v));
      y += bar;
    }
    y += between;
  }
  body += fmt::format("<line x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\" stroke=\"#333\"/>\n", fixed(zero), fixed(begin), fixed(y - between + 6.0));
  return framed(std::move(body), width, y, title);
}

}  // namespace waywright
