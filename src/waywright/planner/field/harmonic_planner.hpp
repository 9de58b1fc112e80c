// Planner `harmonic`: along a streamline of a potential without local minima, on any map.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "waywright/planner/field/harmonic.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

struct HarmonicOptions {
  double resolution = 0.0;  ///< m; 0: as fine as a hundred thousand cells allow, the map's own or 0.05 m at least
  HarmonicField::Options field{};
};

/// For the disc around the footprint, of vehicles that move any way or turn on the spot.
class HarmonicPlanner {
 public:
  static constexpr std::int64_t most_cells = 1'000'000;  ///< that are solved for

  explicit HarmonicPlanner(const HarmonicOptions& options) : options_{options} {}
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "harmonic"; }
  /// The cells; the potential itself hangs on the goal.
  HarmonicPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  HarmonicOptions options_;
  std::shared_ptr<const Ready> ready_;
};

PlannerDescription harmonic_description();

}  // namespace waywright
