#include "waywright/study/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "waywright/study/run_cost.hpp"
#include "waywright/study/short_names.hpp"

namespace waywright {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

constexpr std::size_t longest_reason = 180;  // bytes that the table shows

/// The same answer bit for bit; the time it took may differ.
bool is_same_answer(const Plan& a, const Plan& b) {
  const auto row = [](const Sample& s) {
    return std::tie(s.s, s.x, s.y, s.heading, s.curvature, s.direction, s.t, s.speed);
  };
  return a.status == b.status && a.reason == b.reason && a.effort.evaluations == b.effort.evaluations &&
         std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(),
                    [&](const Sample& p, const Sample& q) { return row(p) == row(q); });
}

void count_failure(std::vector<Summary::Failures>& failures, const Run& run) {
  const auto known = std::find_if(failures.begin(), failures.end(),
                                  [&](const auto& f) { return f.status == run.plan.status; });
  if (known == failures.end())
    failures.push_back({run.plan.status, 1, run.seed, run.plan.reason});
  else
    ++known->count;
}

/// Cut at a word, or at a whole character where it is one long word.
std::string cut(const std::string& text) {
  if (text.size() <= longest_reason) return text;
  std::size_t end = text.rfind(' ', longest_reason);
  if (end == std::string::npos) {
    end = longest_reason;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  }
  return text.substr(0, end) + " …";
}

/// A figure, or a dash where there is nothing to measure.
std::string figure(bool any, double value, int digits) {
  return any ? fmt::format("{:.{}f}", value, digits) : "–";
}

/// "  4/5    0.38–0.96", one run "1/1", none a dash.
std::string solved_words(const Summary& s) {
  if (s.solved.all == 0) return "–";
  const std::string share = fmt::format("{}/{}", s.solved.hits, s.solved.all);
  if (s.all_alike) return share + " all alike";
  return s.solved.all == 1 ? share : fmt::format("{} {:.2f}–{:.2f}", share, s.solved.low, s.solved.high);
}

/// What the costs of one scenario are, and whether they can be held against each other.
std::string cost_words(const std::vector<Summary>& summaries, std::size_t scenario, const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, std::string>> objectives;  // and who has them
  for (const Summary& s : summaries) {
    if (s.scenario != scenario || s.costs == 0) continue;
    const auto known = std::find_if(objectives.begin(), objectives.end(), [&](const auto& o) { return o.first == s.objective; });
    if (known == objectives.end()) objectives.emplace_back(s.objective, names[s.contestant]);
    else known->second += ", " + names[s.contestant];
  }
  if (objectives.empty()) return {};
  if (objectives.size() == 1) return fmt::format("  cost: by the planner's own objective ({})\n", objectives.front().first);
  std::string out = "  cost: by each planner's own objective; only those of one objective can be compared\n";
  for (const auto& [objective, who] : objectives) out += fmt::format("    {}: {}\n", objective, who);
  return out;
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
      const Run* first = nullptr;
      bool alike = true;
      std::vector<double> length, clearance, change, time, evaluations, seconds, cost;
      for (const Run& run : runs) {
        if (run.scenario != p || run.contestant != c) continue;
        ++all;
        if (first == nullptr) first = &run;
        alike = alike && is_same_answer(first->plan, run.plan);
        evaluations.push_back(static_cast<double>(run.plan.effort.evaluations));
        seconds.push_back(run.plan.timing.plan);
        if (run.plan.status == Status::solved)
          ++solved;
        else
          count_failure(summary.failures, run);
        if (run.plan.samples.empty()) continue;
        if (run.plan.status != Status::solved) ++summary.unproven;
        length.push_back(run.plan.metrics.length);
        clearance.push_back(run.plan.certificate.clearance);
        change.push_back(run.plan.metrics.curvature_change);
        time.push_back(run.plan.metrics.travel_time);
        const auto own = cost_of(run.plan);
        if (own && summary.objective.empty()) summary.objective = own->objective;
        if (own && own->objective == summary.objective) cost.push_back(own->cost);
      }
      summary.solved = share_of(solved, all);
      summary.paths = length.size();
      summary.all_alike = all > 1 && alike;
      summary.length = spread_of(length);
      summary.clearance = spread_of(clearance);
      summary.curvature_change = spread_of(change);
      summary.travel_time = spread_of(time);
      summary.costs = cost.size();
      summary.cost = spread_of(cost);
      summary.evaluations = spread_of(evaluations);
      summary.seconds = spread_of(seconds);
      summaries.push_back(summary);
    }
  }
  return summaries;
}

std::string summary_text(const std::vector<Summary>& summaries, const std::vector<std::string>& scenarios,
                         const std::vector<Contestant>& contestants) {
  const ShortNames shown = short_names(contestants);
  std::size_t wide = 10;
  for (const std::string& name : shown.names) wide = std::max(wide, name.size());
  std::string out = shown.shared.empty() ? "" : "all of them: " + shown.shared + "\n";
  for (std::size_t p = 0; p < scenarios.size(); ++p) {
    out += fmt::format("{}{}\n  {:<{}}  {:>19}  {:>8}  {:>22}  {:>9}  {:>8}  {:>7}  {:>9}  {:>7}  {:>9}\n",
                       p == 0 ? "" : "\n", scenarios[p], shown.heading, wide, "solved (95 %)", "unproven",
                       "length m [quartiles]", "clear. m", "Σ|Δκ|", "time s", "cost", "evals", "plan ms");
    std::string below;
    for (const Summary& s : summaries) {
      if (s.scenario != p) continue;
      const std::string& label = shown.names[s.contestant];
      const bool ran = s.solved.all > 0;
      const bool any = s.paths > 0;
      const std::string length = any ? fmt::format("{:>7.3f} [{:>5.2f}–{:>6.2f}]", s.length.median,
                                                   s.length.low_quartile, s.length.high_quartile)
                                     : "–";
      out += fmt::format("  {:<{}}  {:>19}  {:>8}  {:>22}  {:>9}  {:>8}  {:>7}  {:>9}  {:>7}  {:>9}\n", label, wide,
                         solved_words(s), ran ? std::to_string(s.unproven) : "–", length,
                         figure(any, s.clearance.median, 4), figure(any, s.curvature_change.median, 3),
                         figure(any, s.travel_time.median, 2), figure(s.costs > 0, s.cost.median, 4),
                         figure(ran && contestants[s.contestant].command.empty(), s.evaluations.median, 0),
                         figure(ran, 1000.0 * s.seconds.median, 2));
      if (s.all_alike)
        below += fmt::format(
            "  {}: its {} runs are the same to the last bit: none of these seeds changed anything, and they count as "
            "one\n",
            label, s.solved.all);
      for (const Summary::Failures& f : s.failures) {
        below += fmt::format("  {}: {} × {}{}: {}\n", label, f.count, to_string(f.status),
                             f.count > 1 ? fmt::format(", with seed {}", f.seed) : "", cut(f.reason));
      }
    }
    out += below + cost_words(summaries, p, shown.names);
  }
  return out;
}

std::string runs_csv(const std::vector<Run>& runs, const std::vector<std::string>& scenarios,
                     const std::vector<Contestant>& contestants) {
  std::string out =
      "scenario,planner,seed,status,evaluations,plan_seconds,length,clearance,min_clearance,mean_clearance,"
      "max_curvature,max_curvature_rate,"
      "curvature_change,curvature_change_printed,turning,direction_changes,collision_risk,travel_time,"
      "cost,objective,reason\n";
  for (const Run& run : runs) {
    const Plan& p = run.plan;
    out += fmt::format("{},{},{},{},{},{:.6f}", quoted(scenarios[run.scenario]),
                       quoted(contestants[run.contestant].label), run.seed, to_string(p.status),
                       p.effort.evaluations, p.timing.plan);
    if (p.samples.empty()) {
      out += ",,,,,,,,,,,,";
    } else {
      const Metrics& m = p.metrics;
      out += fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{}", m.length, p.certificate.clearance,
                         m.min_clearance, m.mean_clearance, m.max_curvature, m.max_curvature_rate,
                         m.curvature_change, m.curvature_change_printed, m.turning, m.direction_changes,
                         m.collision_risk, m.travel_time);
    }
    const auto own = cost_of(p);
    out += own ? fmt::format(",{},{}", own->cost, quoted(own->objective)) : std::string{",,"};
    out += "," + quoted(p.reason) + "\n";
  }
  return out;
}

}  // namespace waywright
