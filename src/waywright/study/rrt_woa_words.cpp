#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/map/whale_maps.hpp"
#include "waywright/study/rrt_woa_words.hpp"

namespace waywright::rrt_woa {
namespace {

constexpr std::array<const char*, 3> variants{"RRT*", "local variant", "global variant"};

std::string with_interval(const Mean& mean, int digits) { return fmt::format("{:.{}f} ± {:.{}f}", mean.value, digits, mean.half_width, digits); }

}  // namespace

const char* variant_name(Variant variant) { return variants[static_cast<std::size_t>(variant)]; }

const char* parameter_name(const std::string& parameter) {
  return parameter == "mu" ? "threshold mu" : parameter == "b" ? "spiral constant b" : parameter == "a0" ? "start value a0" : parameter == "lambda" ? "lambda" : parameter.c_str();
}

std::string between(double low, double high, int digits, const char* unit) {
  if (!std::isfinite(low) || !std::isfinite(high)) return "one run tells no more";
  return fmt::format("between {:+.{}f} and {:+.{}f} {}", low, digits, high, digits, unit);
}

std::string text(const Results& results) {
  std::string out = fmt::format("Five maps of 20 x 20 m, a point from (1.5, 1.5) to (18.5, 18.5), {} seeds each; first path of RRT*, step 1 m, radius 1.5 m, goal threshold 1 m.\n\n", results.runs);
  out += "3.1 comparison                 printed: s    length m     nodes  |  here: ms      length m             nodes        share of the possible saving\n";
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const Row& row = results.comparison[v];
    out += fmt::format("  {:<24} {:>12.3f} {:>11.3f} {:>9.1f}  |  {:>8.3f} {:>18} {:>15} {:>14}\n", variants[v], row.published.seconds, row.published.metres, row.published.nodes,
                       1e3 * row.ours.seconds.value, with_interval(row.ours.metres, 3), with_interval(row.ours.nodes, 0),
                       v == 0 ? "" : fmt::format("{:.1f} ± {:.1f} %", 100.0 * row.ours.share.value, 100.0 * row.ours.share.half_width));
  }
  const double least = (results.shortest[0] + results.shortest[1] + results.shortest[2] + results.shortest[3] + results.shortest[4]) / 5.0;
  const auto less = [&](std::size_t v, bool printed) {
    const auto metres = [&](std::size_t i) { return printed ? results.comparison[i].published.metres : results.comparison[i].ours.metres.value; };
    return 100.0 * (1.0 - metres(v) / metres(0));
  };
  out += fmt::format("  length less than RRT*'s: local {:.1f} % as printed, {:.1f} % here; global {:.1f} % and {:.1f} %. The shortest ways are {:.3f} m on average, {:.1f} % under RRT*'s here:\n"
                     "  more than that cannot be saved on these maps.\n\n",
                     less(1, true), less(1, false), less(2, true), less(2, false), least, 100.0 * (1.0 - least / results.comparison[0].ours.metres.value));
  out += "by map           shortest m      RRT* m       nodes     local m       nodes    global m   (means)\n";
  for (std::size_t m = 0; m < results.by_map.size(); ++m) {
    const auto& [star, local, global] = results.by_map[m];
    const WhaleMap map = *whale_map(whale_map_names()[m]);
    out += fmt::format("  {:<7} {:<16} {:>7.3f} {:>11.3f} {:>11.0f} {:>11.3f} {:>11.0f} {:>11.3f}\n", map.name, map.about, results.shortest[m], star.metres.value, star.nodes.value, local.metres.value,
                       local.nodes.value, global.metres.value);
  }
  out += "\n";
  for (const Table& table : results.tables) {
    const bool has_blocks = table.parameter == "lambda";
    out += fmt::format("{} {}, {}\n  {:>8}{}  printed: s  length m    nodes  |  here: ms          length m           nodes   share\n", table.name, variants[static_cast<std::size_t>(table.variant)],
                       parameter_name(table.parameter), "", has_blocks ? "    a0" : "");
    for (const Row& row : table.rows) {
      out += fmt::format("  {:>8g}{}  {:>10.4f} {:>9.3f} {:>8.1f}  |  {:>8.3f} {:>17} {:>15} {:>5.1f} %\n", row.value, has_blocks ? fmt::format("{:>6g}", row.start) : "", row.published.seconds,
                         row.published.metres, row.published.nodes, 1e3 * row.ours.seconds.value, with_interval(row.ours.metres, 3), with_interval(row.ours.nodes, 0), 100.0 * row.ours.share.value);
    }
    out += "\n";
  }
  return out;
}

std::string csv(const Results& results) {
  std::string out = "table,variant,parameter,value,a0,printed_s,printed_m,printed_nodes,s,m,m_95,nodes,nodes_95,share,share_95\n";
  const auto line = [&](const std::string& table, Variant variant, const std::string& parameter, const Row& row) {
    const Measured& o = row.ours;
    out += fmt::format("{},{},{},{:g},{:g},{},{},{},{},{},{},{},{},{},{}\n", table, variants[static_cast<std::size_t>(variant)], parameter, row.value, row.start, row.published.seconds,
                       row.published.metres, row.published.nodes, o.seconds.value, o.metres.value, o.metres.half_width, o.nodes.value, o.nodes.half_width, o.share.value, o.share.half_width);
  };
  for (std::size_t v = 0; v < variants.size(); ++v) line("3.1", static_cast<Variant>(v), "", results.comparison[v]);
  for (const Table& table : results.tables) {
    for (const Row& row : table.rows) line(table.name, table.variant, table.parameter, row);
  }
  return out;
}

}  // namespace waywright::rrt_woa
