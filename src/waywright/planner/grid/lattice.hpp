// The moves from cell to cell, what they cost in whole numbers, and how long a way is where nothing stands in it.
//
// Lengths are a + b·√2 + c·√5 cells for a straight, b diagonal and c knight's moves. Searches add whole-number weights of the three instead,
// `scale` units a cell, so that equal lengths are equal, sums are exact and queues are buckets. The weights are so near to the true ratios that
// the way of least weight is at most `error` cells a move longer than the shortest: with 4 and 8 neighbours the shortest itself up to
// 30 000 moves (see MoveWeights).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "waywright/map/distance_field.hpp"

namespace waywright {

/// 4: along columns and rows. 8: diagonals, too. 16: and two along one, one along the other, as a knight moves.
enum class Neighbours { four = 4, eight = 8, sixteen = 16 };

/// All sixteen in the order of their angle: move i and move i + 8 are opposite. Multiples of 4 are straight, other even ones diagonal, odd
/// ones knight's moves.
inline constexpr int all_moves = 16;
struct Move {
  int column = 0, row = 0;
};
inline constexpr std::array<Move, all_moves> moves{{{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {1, -1}, {2, -1}}};
constexpr int opposite(int move) { return (move + 8) % all_moves; }
constexpr int steps_of(Neighbours n) { return all_moves / static_cast<int>(n); }  ///< every so many moves of the sixteen are used

enum class MoveKind { straight = 0, diagonal = 1, knight = 2 };
constexpr MoveKind kind_of(int move) { return move % 4 == 0 ? MoveKind::straight : move % 2 == 0 ? MoveKind::diagonal : MoveKind::knight; }

/// How many moves of each kind a way has.
struct MoveCounts {
  std::int64_t straight = 0, diagonal = 0, knight = 0;
  double length() const;  ///< cells, rounded once
  void add(int move);
  friend bool operator==(const MoveCounts&, const MoveCounts&) = default;
};

/// Whole-number weights, finest first; a search that runs out of 32 bits begins again with the next.
///
/// Why the finest for 8 neighbours finds the shortest way itself: two ways of at most n moves whose lengths differ do so by Δa + Δb·√2 with whole
/// numbers Δa, Δb, at least 1 / (2.42·n); their weights misjudge that by at most n·|diagonal/scale − √2| = 3.2e-10·n, which is less up to n = 36 000.
struct MoveWeights {
  std::uint32_t scale = 1;  ///< of a straight move
  std::uint32_t diagonal = 1;
  std::uint32_t knight = 2;
  std::uint32_t of(int move) const { return kind_of(move) == MoveKind::straight ? scale : kind_of(move) == MoveKind::diagonal ? diagonal : knight; }
  /// Of the costliest move.
  std::uint32_t most(Neighbours neighbours) const { return neighbours == Neighbours::four ? scale : neighbours == Neighbours::eight ? diagonal : knight; }
  double error() const;  ///< cells a move, by which the weights may misjudge
};
inline constexpr int weight_levels = 3;
MoveWeights move_weights(Neighbours neighbours, int level);
/// A cost ≥ 0 in whole units; what 32 bits cannot hold is the greatest that they can, with which no search begins.
inline std::uint32_t rounded_cost(double units) { return units < 4294967295.0 ? static_cast<std::uint32_t>(std::llround(units)) : 4294967295U; }

/// What a search expects of the rest of the way. `free_way` is the exact length where nothing is in the way, for the neighbourhood that is
/// searched. Of the others those of the publication: manhattan is too much for 8 and 16 neighbours, octile for 16 (the way found may then be
/// longer than the shortest), the rest are never too much.
enum class Heuristic { free_way, manhattan, euclidean, octile, chebyshev, none };
inline constexpr std::array heuristics{Heuristic::free_way, Heuristic::manhattan, Heuristic::euclidean, Heuristic::octile, Heuristic::chebyshev, Heuristic::none};
const char* to_string(Heuristic heuristic);
/// Is it never more than what is left, so that the way found is the shortest?
bool never_too_much(Heuristic heuristic, Neighbours neighbours);

/// Of the greater of the columns and rows that are left and of the lesser.
struct WayTerm {
  std::uint32_t most = 0, least = 0;
};
/// The weight of the free way is the greater of the two. (Of 16 neighbours: straight and knight's moves while most ≥ 2 least, then knight's and diagonal
/// ones; straight + diagonal > knight makes either the greater where it holds.)
constexpr std::array<WayTerm, 2> free_way_terms(Neighbours neighbours, const MoveWeights& w) {
  const WayTerm four{w.scale, w.scale}, eight{w.scale, w.diagonal - w.scale};
  if (neighbours == Neighbours::four) return {four, four};
  if (neighbours == Neighbours::eight) return {eight, eight};
  return {{{w.scale, w.knight - 2 * w.scale}, {w.knight - w.diagonal, 2 * w.diagonal - w.knight}}};
}

/// Weights of the free way over so many columns and rows.
inline std::uint32_t free_way(Neighbours neighbours, const MoveWeights& w, int columns, int rows) {
  const auto most = static_cast<std::uint32_t>(std::max(std::abs(columns), std::abs(rows)));
  const auto least = static_cast<std::uint32_t>(std::min(std::abs(columns), std::abs(rows)));
  const std::array<WayTerm, 2> terms = free_way_terms(neighbours, w);
  return std::max(terms[0].most * most + terms[0].least * least, terms[1].most * most + terms[1].least * least);
}

}  // namespace waywright
