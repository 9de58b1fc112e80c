// A whale search in memory that the caller has: agents row after row, their best place. Standard library only, allocates nothing.
#pragma once

#include <algorithm>
#include <cmath>

#include "waywright/optimizer/whale_step.hpp"

namespace waywright {

/// How many moves of each kind were made.
struct WhaleCounts {
  std::int64_t encircles = 0, searches = 0, spirals = 0;
};

/// Agents of a search. Views: the memory is the caller's.
struct WhaleAgents {
  std::span<const double> low, high;  ///< bounds; their length is the dimension
  std::span<double> places;           ///< of all agents, one after another
  std::span<double> best;             ///< the best place so far
  double best_value = 0.0;            ///< and its value
  std::span<double> mean{};           ///< room for the mean of all agents, as long as a place: the unbiased form. Empty: the published one

  std::size_t size() const { return best.empty() ? 0 : places.size() / best.size(); }
  std::span<double> place(std::size_t i) const { return places.subspan(i * best.size(), best.size()); }
  /// Takes agent i's place as the best one where it is better.
  void learn(std::size_t i, double value) {
    if (!(value < best_value)) return;
    best_value = value;
    std::copy_n(place(i).begin(), best.size(), best.begin());
  }
  void find_mean() const {
    std::fill(mean.begin(), mean.end(), 0.0);
    const double share = 1.0 / static_cast<double>(size());
    for (std::size_t i = 0; i < size() && !mean.empty(); ++i) {
      for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += share * place(i)[k];
    }
  }
};

/// Iterations as published: all agents move, one after another, and then all are evaluated; the best place is kept, agents move on from it. An
/// agent that searches does so about any agent where that is by then. Every agent draws as many numbers, whatever it does.
/// @param value    (index of the agent, its place) → its value. Only places better than the best one matter, so it may say +∞ of any other
/// @param is_over  asked before each iteration with its index; true ends the search
/// @pre at least one agent; places within the bounds; best and best_value set
template <class Value, class IsOver>
WhaleCounts whale_search(const WhaleParameters& parameters, std::size_t iterations, WhaleAgents& agents, Random& random, Value&& value, IsOver&& is_over) {
  WhaleCounts counts;
  const std::size_t size = agents.size();
  for (std::size_t t = 0; t < iterations && !is_over(t); ++t) {
    const double reach = whale_reach(parameters.start, t, iterations);
    agents.find_mean();
    for (std::size_t i = 0; i < size; ++i) {
      const WhaleDraws draws = WhaleDraws::from(random);
      const auto other = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(size) - 1));
      const WhaleStep step = whale_step(parameters, reach, draws);
      ++(step.move == WhaleMove::encircle ? counts.encircles : step.move == WhaleMove::search ? counts.searches : counts.spirals);
      const std::span<const double> target = step.move == WhaleMove::search ? agents.place(other) : agents.best;
      if (agents.mean.empty()) {
        make_whale_step(step, target, agents.low, agents.high, agents.place(i));
      } else {
        make_unbiased_whale_step(parameters, step, target, agents.mean, agents.low, agents.high, agents.place(i), random);
      }
    }
    for (std::size_t i = 0; i < size; ++i) agents.learn(i, value(i, std::span<const double>{agents.place(i)}));
  }
  return counts;
}

}  // namespace waywright
