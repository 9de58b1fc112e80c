#include <fmt/format.h>

#include <cmath>

#include "waywright/study/reproduce_safe_astar.hpp"

namespace waywright::reproduction {
namespace {

std::string figure(std::size_t metric, std::optional<double> value) {
  if (!value) return "–";
  return metric == search ? fmt::format("{:.4f}", *value) : fmt::format("{:.2f}", *value);
}

std::string percent(std::optional<double> value) { return !value ? "–" : std::isfinite(*value) ? fmt::format("{:+.2f}", *value) : *value < 0.0 ? "-inf" : "+inf"; }

/// One line of figures with the reductions against the first three beside it.
struct Line {
  std::array<std::optional<double>, 4> values;
  std::array<std::optional<double>, 3> reductions;
};

Line line_of(std::size_t metric, const std::array<std::optional<double>, 4>& values) {
  Line line{values, {}};
  for (std::size_t m = 0; m < own; ++m) {
    if (values[m] && values[own]) line.reductions[m] = reduction_of(metric, *values[m], *values[own]);
  }
  return line;
}

Line published_line(const Experiment& e, std::size_t metric) {
  std::array<std::optional<double>, 4> values;
  for (std::size_t m = 0; m < methods.size(); ++m) values[m] = e.published[m][metric];
  return line_of(metric, values);
}

Line line_of_ways(const std::array<Way, 4>& ways, std::size_t metric) {
  std::array<std::optional<double>, 4> values;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (ways[m].is_found) values[m] = ways[m].figures[metric];
  }
  return line_of(metric, values);
}

std::string text_line(const char* metric, const char* source, std::size_t index, const Line& line) {
  std::string out = fmt::format("  {:<12} {:<10}", metric, source);
  for (const auto& v : line.values) out += fmt::format("  {:>9}", figure(index, v));
  out += "  |";
  for (const auto& v : line.reductions) out += fmt::format("  {:>9}", percent(v));
  return out + "\n";
}

std::string csv_line(const Experiment& e, const char* metric, const char* source, const Line& line) {
  std::string out = fmt::format("\"{}\",{},{},{}", e.name, e.map, metric, source);
  const auto cell = [](std::optional<double> v) { return v && std::isfinite(*v) ? fmt::format(",{}", *v) : std::string{","}; };
  for (const auto& v : line.values) out += cell(v);
  for (const auto& v : line.reductions) out += cell(v);
  return out + "\n";
}

}  // namespace

std::string text(const std::vector<Experiment>& experiments) {
  std::string out;
  for (const Experiment& e : experiments) {
    out += fmt::format("{} ({}){}\n", e.name, e.map, e.legs.size() > 1 ? ", two legs one after the other" : "");
    out += fmt::format("  {:<23}", "");
    for (const char* m : methods) out += fmt::format("  {:>9}", m);
    out += "  |  SHA* less than the first three, %\n";
    for (std::size_t metric = 0; metric < metrics.size(); ++metric) {
      out += text_line(metrics[metric], e.derived.empty() ? "published" : "derived", metric, published_line(e, metric));
      out += text_line("", "ours", metric, line_of_ways(e.ours, metric));
      out += text_line("", "corrected", metric, line_of_ways(e.corrected, metric));
    }
    if (!e.derived.empty()) out += fmt::format("  derived: {}\n", e.derived);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (!e.ours[m].reason.empty()) out += fmt::format("  {} as published: {}\n", methods[m], e.ours[m].reason);
      if (!e.corrected[m].reason.empty()) out += fmt::format("  {} corrected: {}\n", methods[m], e.corrected[m].reason);
    }
    out += "\n";
  }
  out += "published: as printed. ours: the same rules on the reconstructed maps. corrected: astar, danger_astar, block_astar and safe_astar for a point, each proven.\n"
         "search s: published on its machine; ours and corrected timed alike, prepared, after one search to warm up.\n"
         "run s is the length at 1 m/s (the printed ones are at 0.93 m/s, driven by a tracker); of power % the reduction is of what is used.\n";
  return out;
}

std::string csv(const std::vector<Experiment>& experiments) {
  std::string out = "experiment,map,metric,source,T_A,S_A,R_17,SHA,reduction_T_A_percent,reduction_S_A_percent,reduction_R_17_percent\n";
  for (const Experiment& e : experiments) {
    for (std::size_t metric = 0; metric < metrics.size(); ++metric) {
      out += csv_line(e, metrics[metric], e.derived.empty() ? "published" : "derived", published_line(e, metric));
      out += csv_line(e, metrics[metric], "ours", line_of_ways(e.ours, metric));
      out += csv_line(e, metrics[metric], "corrected", line_of_ways(e.corrected, metric));
    }
  }
  return out;
}

std::vector<std::string> broken_trends(const std::vector<Experiment>& experiments) {
  constexpr double nothing = 0.005;  // %: printed as 0.00
  const auto sign = [](double v) { return v > nothing ? 1 : v < -nothing ? -1 : 0; };
  const auto told = [](double v) { return v > 0.0 ? fmt::format("{:.2f} % less", v) : !std::isfinite(v) ? std::string{"more, of none"} : v < 0.0 ? fmt::format("{:.2f} % more", -v) : std::string{"as much"}; };
  std::vector<std::string> sentences;
  int times = 0, broken_times = 0;
  for (const Experiment& e : experiments) {
    for (std::size_t metric = 0; metric < metrics.size(); ++metric) {
      if (metric == run) continue;  // proportional to the length
      const Line printed = published_line(e, metric), ours = line_of_ways(e.ours, metric);
      for (std::size_t m = 0; m < own; ++m) {
        if (!printed.reductions[m] || !ours.reductions[m]) continue;
        const bool is_broken = sign(*printed.reductions[m]) != sign(*ours.reductions[m]);
        if (metric == search) {
          ++times;
          broken_times += is_broken ? 1 : 0;
        } else if (is_broken) {
          sentences.push_back(fmt::format("{} ({}), {} of SHA* against {}: {} as printed, {} here.", e.name, e.map, metric == power ? "power used" : metrics[metric], methods[m],
                                          told(*printed.reductions[m]), told(*ours.reductions[m])));
        }
      }
    }
  }
  if (broken_times > 0) {
    sentences.push_back(fmt::format("{} of {} printed orders of search times are others on this machine: all searches take milliseconds, and R_[17] searches around obstacles alone.", broken_times, times));
  }
  return sentences;
}

}  // namespace waywright::reproduction
