#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/map/whale_maps.hpp"
#include "waywright/study/reproduce_rrt_woa.hpp"

namespace waywright::rrt_woa {
namespace {

constexpr std::array<const char*, 3> variants{"RRT*", "local variant", "global variant"};

const char* name_of(const std::string& parameter) {
  return parameter == "mu" ? "threshold mu" : parameter == "b" ? "spiral constant b" : parameter == "a0" ? "start value a0" : parameter == "lambda" ? "lambda" : parameter.c_str();
}

std::string with_interval(const Mean& mean, int digits) { return fmt::format("{:.{}f} ± {:.{}f}", mean.value, digits, mean.half_width, digits); }

/// Change over the rows, by a straight line through them, as a share of the mean.
struct Slope {
  double change = 0.0;
  double noise = 0.0;  ///< change that is within the intervals
};

template <class Value>
Slope slope_of(const std::vector<Row>& rows, Value&& value) {
  const auto n = static_cast<double>(rows.size());
  double mean = 0.0, across = 0.0, up = 0.0, noise = 0.0;
  for (const Row& row : rows) mean += value(row).value / n;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double x = static_cast<double>(i) - 0.5 * (n - 1.0);
    across += x * x;
    up += x * (value(rows[i]).value - mean);
    noise += x * x * value(rows[i]).half_width * value(rows[i]).half_width;
  }
  const double rows_between = n - 1.0;
  return {up / across * rows_between / mean, std::sqrt(noise) / across * rows_between / mean};
}

constexpr double little = 0.005;  // of the mean: no effect

int sign_of(const Slope& slope) { return std::abs(slope.change) < std::max(little, slope.noise) ? 0 : slope.change > 0.0 ? 1 : -1; }

std::string told(const Slope& slope) {
  return sign_of(slope) == 0 ? fmt::format("has no effect ({:+.1f} %)", 100.0 * slope.change) : fmt::format("{} by {:.1f} %", slope.change > 0.0 ? "grows" : "falls", 100.0 * std::abs(slope.change));
}

/// The tables of λ have three blocks, one for each a₀.
std::vector<std::vector<Row>> blocks_of(const Table& table) {
  std::vector<std::vector<Row>> blocks;
  for (const Row& row : table.rows) {
    if (blocks.empty() || (table.parameter == "lambda" && blocks.back().back().start != row.start)) blocks.emplace_back();
    blocks.back().push_back(row);
  }
  return blocks;
}

Mean printed_metres(const Row& row) { return {row.published.metres, 0.0}; }
Mean printed_nodes(const Row& row) { return {row.published.nodes, 0.0}; }
Mean our_metres(const Row& row) { return row.ours.metres; }
Mean our_nodes(const Row& row) { return row.ours.nodes; }

}  // namespace

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
                       name_of(table.parameter), "", has_blocks ? "    a0" : "");
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

std::vector<std::string> broken_trends(const Results& results) {
  std::vector<std::string> sentences;
  if (results.runs == 0) return sentences;
  for (const Table& table : results.tables) {
    for (const std::vector<Row>& block : blocks_of(table)) {
      const std::string what = fmt::format("{}, {}, {}{}", table.name, variants[static_cast<std::size_t>(table.variant)], name_of(table.parameter),
                                           table.parameter == "lambda" ? fmt::format(" at a0 = {:g}", block.front().start) : "");
      if (table.parameter == "lambda") {
        // What is printed of λ is that 0 is the worst.
        const auto longest = [&](auto&& value) { return std::max_element(block.begin(), block.end(), [&](const Row& a, const Row& b) { return value(a).value < value(b).value; }) - block.begin(); };
        if (longest(printed_metres) == 0 && longest(our_metres) != 0) {
          const Row& worst = block[static_cast<std::size_t>(longest(our_metres))];
          sentences.push_back(fmt::format("{}: lambda = 0 gives the longest ways as printed; here lambda = {:g} does, {} m against {} m.", what, worst.value, with_interval(worst.ours.metres, 3),
                                          with_interval(block.front().ours.metres, 3)));
        }
        continue;
      }
      const auto compare = [&](const char* of, const Slope& printed, const Slope& ours) {
        if (sign_of(printed) != sign_of(ours)) sentences.push_back(fmt::format("{}: the {} {} over the table as printed, here it {}.", what, of, told(printed), told(ours)));
      };
      compare("length", slope_of(block, printed_metres), slope_of(block, our_metres));
      if (table.variant == Variant::local) compare("number of nodes", slope_of(block, printed_nodes), slope_of(block, our_nodes));
    }
  }
  return sentences;
}

}  // namespace waywright::rrt_woa
