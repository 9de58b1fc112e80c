// Chains of clothoids through waypoints.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "waywright/curve/clothoid_g2.hpp"
#include "waywright/path/path.hpp"

namespace waywright {

using Clothoids = std::vector<Clothoid>;

enum class Continuity {
  g1,  ///< one clothoid a leg: the curvature jumps at waypoints (published)
  g2,  ///< three clothoids a leg: the curvature goes on
};

/// The trajectory through poses in order (headings are courses). With G2, curvature is 0 at the first and last pose, and at each one between what is
/// in `bends` (1/m, one element a pose between; empty: zeros) more than the mean of what the single clothoids before and after it have there.
/// nullopt where a leg has no solution: the first such is told in `unsolved`.
std::optional<Clothoids> chain_through(std::span<const Pose> poses, Continuity continuity, std::span<const double> bends = {}, std::size_t* unsolved = nullptr);

/// The same driven forwards.
Path path_of(const Clothoids& chain);

double length_of(const Clothoids& chain);
/// Greatest |κ| (1/m) and |dκ/ds| (1/m²).
double greatest_curvature(const Clothoids& chain);
double greatest_curvature_rate(const Clothoids& chain);

/// Vehicle poses at n ≥ 2 places of equal distance along the chain, first and last included (the publication samples so, n = 100).
void sample_evenly(const Clothoids& chain, std::size_t n, std::vector<Pose>& poses);

}  // namespace waywright
