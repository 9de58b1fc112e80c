#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/study/paired.hpp"
#include "waywright/study/reproduce_rrt_woa.hpp"
#include "waywright/study/rrt_woa_words.hpp"

namespace waywright::rrt_woa {
namespace {

constexpr double little = 0.005;  // of the mean: no effect
constexpr double sure = 0.95;     // of intervals

enum class Verdict { holds, broken, undecided };

/// Change over n rows, by a straight line through their values.
template <class Value>
double change_over(std::size_t n, Value&& value) {
  const double middle = 0.5 * (static_cast<double>(n) - 1.0);
  double across = 0.0, up = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) - middle;
    across += x * x;
    up += x * value(i);
  }
  return up / across * 2.0 * middle;
}

/// The same of each seed, so that what the seeds have in common drops out; as shares of the mean over all.
template <class Value>
PairedDifference our_change(const std::vector<Row>& rows, Value&& by_seed) {
  const std::size_t seeds = by_seed(rows.front()).size();
  double mean = 0.0;
  std::vector<double> changes;
  for (std::size_t s = 0; s < seeds; ++s) {
    changes.push_back(change_over(rows.size(), [&](std::size_t i) { return by_seed(rows[i])[s]; }));
    for (const Row& row : rows) mean += by_seed(row)[s] / static_cast<double>(rows.size() * seeds);
  }
  for (double& change : changes) change /= mean;
  return paired_difference(changes, sure);
}

template <class Value>
double printed_change(const std::vector<Row>& rows, Value&& value) {
  double mean = 0.0;
  for (const Row& row : rows) mean += value(row) / static_cast<double>(rows.size());
  return change_over(rows.size(), [&](std::size_t i) { return value(rows[i]); }) / mean;
}

/// Printed effects under half a per cent are none. What is printed is refuted where the interval holds nothing of it, and holds where it holds nothing else.
Verdict verdict_of(double printed, const PairedDifference& ours) {
  if (std::abs(printed) < little) {
    if (ours.low > little || ours.high < -little) return Verdict::broken;
    return ours.low > -little && ours.high < little ? Verdict::holds : Verdict::undecided;
  }
  const double low = printed > 0.0 ? ours.low : -ours.high, high = printed > 0.0 ? ours.high : -ours.low;
  if (high < little) return Verdict::broken;
  return low > 0.0 ? Verdict::holds : Verdict::undecided;
}

std::string told(double printed) {
  if (std::abs(printed) < little) return fmt::format("does not change as printed ({:+.1f} %)", 100.0 * printed);
  return fmt::format("{} by {:.1f} % as printed", printed > 0.0 ? "grows" : "falls", 100.0 * std::abs(printed));
}

/// What is printed of λ is that 0 gives the longest ways.
struct OfZero {
  Verdict verdict = Verdict::holds;
  const Row* other = nullptr;   ///< the one that decides, or leaves it open
  PairedDifference longer{};    ///< m, the other's ways than those of 0
};

OfZero longest_at_zero(const std::vector<Row>& block) {
  // Of so many comparisons each has its part of what may go wrong.
  const double each = 1.0 - (1.0 - sure) / static_cast<double>(block.size() - 1);
  OfZero result;
  for (std::size_t i = 1; i < block.size(); ++i) {
    std::vector<double> longer;
    for (std::size_t s = 0; s < block[i].ours.metres_by_seed.size(); ++s) longer.push_back(block[i].ours.metres_by_seed[s] - block[0].ours.metres_by_seed[s]);
    const PairedDifference by = paired_difference(longer, each);
    const Verdict verdict = by.low > 0.0 ? Verdict::broken : by.high < 0.0 ? Verdict::holds : Verdict::undecided;
    const bool is_worse = verdict == Verdict::broken ? result.verdict != Verdict::broken : verdict == Verdict::undecided && result.verdict == Verdict::holds;
    if (is_worse || (verdict == result.verdict && verdict != Verdict::holds && by.mean > result.longer.mean)) result = {verdict, &block[i], by};
  }
  return result;
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

}  // namespace

Trends trends(const Results& results) {
  Trends all;
  if (results.runs == 0) return all;
  const auto note = [&](Verdict verdict, const std::string& sentence) {
    if (verdict == Verdict::holds) ++all.holding;
    if (verdict == Verdict::broken) all.broken.push_back(sentence);
    if (verdict == Verdict::undecided) all.undecided.push_back(sentence);
  };
  for (const Table& table : results.tables) {
    for (const std::vector<Row>& block : blocks_of(table)) {
      const std::string what = fmt::format("{}, {}, {}{}", table.name, variant_name(table.variant), parameter_name(table.parameter),
                                           table.parameter == "lambda" ? fmt::format(" at a0 = {:g}", block.front().start) : "");
      if (table.parameter == "lambda") {
        const auto longest = std::max_element(block.begin(), block.end(), [](const Row& a, const Row& b) { return a.published.metres < b.published.metres; });
        if (longest != block.begin()) continue;
        const OfZero zero = longest_at_zero(block);
        note(zero.verdict, zero.other == nullptr ? std::string{}
                                                 : fmt::format("{}: lambda = 0 gives the longest ways as printed; here those of lambda = {:g} are longer by {:+.3f} m ({}).", what, zero.other->value,
                                                               zero.longer.mean, between(zero.longer.low, zero.longer.high, 3, "m")));
        continue;
      }
      const auto compare = [&](const char* of, double printed, const PairedDifference& ours) {
        note(verdict_of(printed, ours),
             fmt::format("{}: the {} {}, here it changes by {:+.1f} % ({}).", what, of, told(printed), 100.0 * ours.mean, between(100.0 * ours.low, 100.0 * ours.high, 1, "%")));
      };
      compare("length", printed_change(block, [](const Row& row) { return row.published.metres; }), our_change(block, [](const Row& row) -> const auto& { return row.ours.metres_by_seed; }));
      if (table.variant == Variant::local) {
        compare("number of nodes", printed_change(block, [](const Row& row) { return row.published.nodes; }), our_change(block, [](const Row& row) -> const auto& { return row.ours.nodes_by_seed; }));
      }
    }
  }
  return all;
}

}  // namespace waywright::rrt_woa
