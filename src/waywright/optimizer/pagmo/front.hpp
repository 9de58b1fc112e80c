// Fronts of several objectives, through pagmo.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "waywright/optimizer/optimizer.hpp"

namespace waywright {

/// Three objectives, each the less the better, and how far from feasible; finite.
struct TradeOff {
  std::array<double, 3> objectives{};
  double violation = 0.0;
};

struct FrontPoint {
  std::vector<double> x;
  std::array<double, 3> objectives{};
};

/// Feasible points that were evaluated, none of which is better in all objectives than another, at most 4000: NSGA-II (Deb et al. 2002, pagmo's). In order of
/// the first objective. The same cost function, space, options: the same front.
std::vector<FrontPoint> search_front(const std::function<TradeOff(std::span<const double>)>& cost, const SearchSpace& space, const SearchOptions& options, Budget& budget);

}  // namespace waywright
