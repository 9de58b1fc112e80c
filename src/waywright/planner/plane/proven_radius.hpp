// Within which distance, or for how many, a sampling planner has to look for neighbours, so that its ways tend to the shortest.
#pragma once

namespace waywright {

/// S. Karaman, E. Frazzoli: Sampling-based algorithms for optimal motion planning, IJRR 30 (2011), theorems 34 (PRM*) and 38 (RRT*):
/// γ √(ln n / n) with γ just over 2 (1 + 1/d)^{1/d} (μ(free)/ζ_d)^{1/d}, d = 2. m; the same bits everywhere.
/// (K. Solovey et al.: Revisiting the asymptotic optimality of RRT*, ICRA 2020, found a gap in the proof of theorem 38: of RRT* this is what is published and used, not what is proven.)
/// @param free_area m², not under the truth  @param places n; fewer than two count as two
double proven_radius(double free_area, double places);

/// The same source, theorems 35 (k-nearest PRM*) and 39 (k-nearest RRT*): the least whole number over e (1 + 1/d) ln n, d = 3: of positions with headings.
/// @param states n; fewer than two count as two
int proven_neighbours(double states);

}  // namespace waywright
