// A particle swarm with chaotic factors, parameters that follow a cosine, and antennae (CAPSO of the safe-A* publication, reconstructed) as a pagmo algorithm.
#pragma once

#include <pagmo/population.hpp>
#include <string>

namespace waywright {

/// Each of T iterations t moves each particle x with speed v, its own best p and the swarm's best g (components by themselves):
///   v ← ω v + c₁ z₁ (p − x) + c₂ z₂ (g − x) − δ b sgn(f(x + ρ b) − f(x − ρ b)),   x ← x + v,
/// with ω = 0.4 + 0.5 cos(πt/2T), c₁ = 1.5 + cos(πt/2T), c₂ = 1.5 + sin(πt/2T), z from the logistic map z ← 4z(1 − z) that begins at 0.7, b a random
/// direction of length 1, and δ = ρ = 0.05 · 0.97ᵗ of each variable's range. Feeling with both antennae takes two evaluations: an iteration takes
/// three a particle. Not published, ours: speeds are at most a fifth of the range, antennae end at the bounds, a particle stops at one.
///
/// Each particle's best place is what the population holds afterwards.
class ChaoticSwarm {
 public:
  explicit ChaoticSwarm(unsigned iterations = 1, unsigned seed = 1) : iterations_{iterations}, seed_{seed} {}
  pagmo::population evolve(pagmo::population population) const;
  std::string get_name() const { return "chaotic particle swarm with antennae"; }

  static constexpr unsigned evaluations_a_move = 3;

 private:
  static constexpr double fastest = 0.2;   // of the range, an iteration
  static constexpr double reach = 0.05;    // of the range, of antennae and of what they move
  static constexpr double fading = 0.97;   // of both, from one iteration to the next
  unsigned iterations_;
  unsigned seed_;
};

}  // namespace waywright
