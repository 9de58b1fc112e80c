// What many runs came to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "waywright/study/compare.hpp"

namespace waywright {

struct Spread {
  double low_quartile = 0.0, median = 0.0, high_quartile = 0.0;
};
/// Quartiles by linear interpolation (type 7); zeros for no values.
Spread spread_of(std::vector<double> values);

/// Wilson's score interval of a share at 95 %.
struct Share {
  std::size_t hits = 0, all = 0;
  double low = 0.0, high = 1.0;
};
Share share_of(std::size_t hits, std::size_t all);

struct Summary {
  std::size_t scenario = 0, contestant = 0;
  Share solved;
  std::size_t unproven = 0;  ///< runs with a path that could not be proven
  std::size_t paths = 0;     ///< runs with a path, proven or not
  bool all_alike =
      false;  ///< several runs, the same to the last bit: the seed changes nothing, and they count as one
  struct Failures {
    Status status = Status::no_path;
    std::size_t count = 0;
    std::uint64_t seed = 0;  ///< of the first
    std::string reason;      ///< of the first
  };
  std::vector<Failures> failures;  ///< what was not solved, by status, in the order in which they came
  Spread length, clearance, curvature_change, travel_time, evaluations,
      seconds;  ///< paths found, proven or not; effort of all
  std::string objective;  ///< whose costs these are; of the first path that has one
  std::size_t costs = 0;  ///< paths with a cost by it
  Spread cost;
};
std::vector<Summary> summarise(const std::vector<Run>& runs, std::size_t scenarios, std::size_t contestants);

/// Aligned for a terminal, with what all contestants share in a line above; figures of no path or no run are dashes, and what was not solved has its
/// reasons below.
std::string summary_text(const std::vector<Summary>& summaries, const std::vector<std::string>& scenarios,
                         const std::vector<Contestant>& contestants);
/// One line a run, every metric; contestants by their whole labels.
std::string runs_csv(const std::vector<Run>& runs, const std::vector<std::string>& scenarios,
                     const std::vector<Contestant>& contestants);

}  // namespace waywright
