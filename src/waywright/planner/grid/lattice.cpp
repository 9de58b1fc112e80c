#include "waywright/planner/grid/lattice.hpp"

#include <cmath>

namespace waywright {
namespace {

constexpr double root2 = 1.41421356237309504880;
constexpr double root5 = 2.23606797749978969641;

// Of √2 alone: convergents of its continued fraction. Of both: the best denominators found by trying all.
constexpr std::array<MoveWeights, weight_levels> of_eight{{{33461, 47321, 66922}, {985, 1393, 1970}, {12, 17, 24}}};
constexpr std::array<MoveWeights, weight_levels> of_sixteen{{{13691, 19362, 30614}, {915, 1294, 2046}, {12, 17, 27}}};

}  // namespace

double MoveCounts::length() const {
  return static_cast<double>(straight) + static_cast<double>(diagonal) * root2 + static_cast<double>(knight) * root5;
}

void MoveCounts::add(int move) {
  switch (kind_of(move)) {
    case MoveKind::straight: ++straight; break;
    case MoveKind::diagonal: ++diagonal; break;
    case MoveKind::knight: ++knight; break;
  }
}

double MoveWeights::error() const {
  return std::max(std::abs(static_cast<double>(diagonal) / scale - root2), knight == 2 * scale ? 0.0 : std::abs(static_cast<double>(knight) / scale - root5));
}

MoveWeights move_weights(Neighbours neighbours, int level) {
  const auto i = static_cast<std::size_t>(level);
  return neighbours == Neighbours::sixteen ? of_sixteen[i] : of_eight[i];
}

const char* to_string(Heuristic heuristic) {
  switch (heuristic) {
    case Heuristic::free_way: return "free_way";
    case Heuristic::manhattan: return "manhattan";
    case Heuristic::euclidean: return "euclidean";
    case Heuristic::octile: return "octile";
    case Heuristic::chebyshev: return "chebyshev";
    case Heuristic::none: return "none";
  }
  return "";
}

bool never_too_much(Heuristic heuristic, Neighbours neighbours) {
  if (heuristic == Heuristic::manhattan) return neighbours == Neighbours::four;
  if (heuristic == Heuristic::octile) return neighbours != Neighbours::sixteen;
  return true;
}

}  // namespace waywright
