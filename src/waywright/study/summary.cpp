#include "waywright/study/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double q) {
    const double place = q * static_cast<double>(values.size() - 1);
    const auto i = static_cast<std::size_t>(place);
    const std::size_t k = std::min(i + 1, values.size() - 1);
    return values[i] + (place - static_cast<double>(i)) * (values[k] - values[i]);
  };
  return {at(0.25), at(0.5), at(0.75)};
}

Share share_of(std::size_t hits, std::size_t all) {
  Share share{hits, all, 0.0, 1.0};
  if (all == 0) return share;
  constexpr double z = 1.959963984540054;
  const double n = static_cast<double>(all);
  const double p = static_cast<double>(hits) / n;
  const double centre = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  share.low = hits == 0 ? 0.0 : std::max(0.0, centre - half);
  share.high = hits == all ? 1.0 : std::min(1.0, centre + half);
  return share;
}

std::vector<Summary> summarise(const std::vector<Run>& runs, std::size_t scenarios, std::size_t contestants) {
  std::vector<Summary> summaries;
  for (std::size_t p = 0; p < scenarios; ++p) {
    for (std::size_t c = 0; c < contestants; ++c) {
      Summary summary;
      summary.scenario = p;
      summary.contestant = c;
      std::size_t all = 0, solved = 0;
      std::vector<double> length, clearance, change, time, evaluations, seconds;
      for (const Run& run : runs) {
        if (run.scenario != p || run.contestant != c) continue;
        ++all;
        evaluations.push_back(static_cast<double>(run.plan.effort.evaluations));
        seconds.push_back(run.plan.timing.plan);
        if (run.plan.status == Status::solved) ++solved;
        if (run.plan.samples.empty()) continue;
        if (run.plan.status != Status::solved) ++summary.unproven;
        length.push_back(run.plan.metrics.length);
        clearance.push_back(run.plan.certificate.clearance);
        change.push_back(run.plan.metrics.curvature_change);
        time.push_back(run.plan.metrics.travel_time);
      }
      summary.solved = share_of(solved, all);
      summary.length = spread_of(length);
      summary.clearance = spread_of(clearance);
      summary.curvature_change = spread_of(change);
      summary.travel_time = spread_of(time);
      summary.evaluations = spread_of(evaluations);
      summary.seconds = spread_of(seconds);
      summaries.push_back(summary);
    }
  }
  return summaries;
}

std::string summary_text(const std::vector<Summary>& summaries, const std::vector<std::string>& scenarios,
                         const std::vector<Contestant>& contestants) {
  std::size_t wide = 10;
  for (const Contestant& c : contestants) wide = std::max(wide, c.label.size());
  std::string out;
  std::size_t last = scenarios.size();
  for (const Summary& s : summaries) {
    if (s.scenario != last) {
      last = s.scenario;
      out += fmt::format("{}{}\n  {:<{}}  {:>18}  {:>8}  {:>22}  {:>9}  {:>8}  {:>7}  {:>7}  {:>9}\n", out.empty() ? "" : "\n", scenarios[s.scenario], "planner",
                         wide, "solved (95 %)", "unproven", "length m [quartiles]", "clear. m", "Σ|Δκ|", "time s", "evals", "plan ms");
    }
    out += fmt::format("  {:<{}}  {:>4}/{:<4} {:.2f}–{:.2f}  {:>8}  {:>7.3f} [{:>5.2f}–{:>6.2f}]  {:>9.4f}  {:>8.3f}  {:>7.2f}  {:>7.0f}  {:>9.2f}\n",
                       contestants[s.contestant].label, wide, s.solved.hits, s.solved.all, s.solved.low, s.solved.high, s.unproven, s.length.median,
                       s.length.low_quartile, s.length.high_quartile, s.clearance.median, s.curvature_change.median, s.travel_time.median,
                       s.evaluations.median, 1000.0 * s.seconds.median);
  }
  return out;
}

std::string runs_csv(const std::vector<Run>& runs, const std::vector<std::string>& scenarios, const std::vector<Contestant>& contestants) {
  std::string out =
      "scenario,planner,seed,status,evaluations,plan_seconds,length,clearance,min_clearance,mean_clearance,max_curvature,max_curvature_rate,"
      "curvature_change,curvature_change_printed,turning,direction_changes,collision_risk,travel_time,reason\n";
  for (const Run& run : runs) {
    const Plan& p = run.plan;
    out += fmt::format("{},{},{},{},{},{:.6f}", quoted(scenarios[run.scenario]), quoted(contestants[run.contestant].label), run.seed, to_string(p.status),
                       p.effort.evaluations, p.timing.plan);
    if (p.samples.empty()) {
      out += ",,,,,,,,,,,,";
    } else {
      const Metrics& m = p.metrics;
      out += fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{}", m.length, p.certificate.clearance, m.min_clearance, m.mean_clearance, m.max_curvature,
                         m.max_curvature_rate, m.curvature_change, m.curvature_change_printed, m.turning, m.direction_changes, m.collision_risk, m.travel_time);
    }
    out += "," + quoted(p.reason) + "\n";
  }
  return out;
}

}  // namespace waywright
