// The inner loops of local whales: what an extension draws, how its agents move, and which of them is the most promising, as many side by side as a register has
// numbers. Written once, compiled for each instruction set, chosen at run time; every one gives the same bits, because each lane is plain IEEE arithmetic in a fixed order.
//
// Places count from the sample, in metres.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace waywright::whale_lanes {

/// Arrays have so many more elements than they are said to have, which are read and written, and mean nothing.
inline constexpr std::size_t spare = 8;

/// A move that goes to another agent.
struct Search {
  std::uint32_t move, other;
};

/// What an extension draws; moves are numbered iteration after iteration. Numbers of a stream (core/random, uniform in [0, 1)) in this order: u of each agent, v of each
/// agent; r of each move, s of each move, p of each move. Agents begin at radius √u (cos 2πv, sin 2πv), evenly over the disc. A move with p ≥ choice is a spiral with
/// l = 2 r − 1; else A = 2 a r − a and C = 2 s, and where |A| ≥ threshold the agent goes to agent ⌊p/min(choice, 1) · agents⌋: of what p can be there, that is uniform, too.
struct Drawing {
  std::uint64_t counter = 0;  ///< of the stream, see Random::take
  std::size_t agents = 0, moves = 0;
  std::size_t searching = 0;      ///< moves from this one on are no searches
  const double* reach = nullptr;  ///< [a] of each move
  double spiral = 1.0, choice = 0.5, threshold = 1.0;
  double radius = 1.0;  ///< m

  double *x = nullptr, *y = nullptr;            ///< out, of each agent
  double *factor = nullptr, *scale = nullptr;   ///< out, of each move: −A, C; of a spiral: e^{bl} cos 2πl, 1
  Search* searches = nullptr;                   ///< out, in order, `searching` at most (and the spare ones)
  std::size_t searches_count = 0;               ///< out
};
/// Numbers that it takes of the stream.
inline std::uint64_t drawn(std::size_t agents, std::size_t moves) { return 2 * std::uint64_t{agents} + 3 * std::uint64_t{moves}; }

/// One iteration.
struct Moving {
  std::size_t agents = 0;
  double radius = 1.0;
  double leader_x = 0.0, leader_y = 0.0;
  const double *factor = nullptr, *scale = nullptr;  ///< of this iteration
  const Search* searches = nullptr;                  ///< of this iteration
  std::size_t searches_count = 0;
  std::size_t first = 0;                             ///< number of its first move
  const double *x = nullptr, *y = nullptr;           ///< of each agent, before
  double *new_x = nullptr, *new_y = nullptr;         ///< out: after
};

/// What of an agent's cost is told by where it is: per_radius |x| + along_x x + along_y y.
struct Ranking {
  std::size_t agents = 0;  ///< > 0
  const double *x = nullptr, *y = nullptr;
  double per_radius = 0.0, along_x = 0.0, along_y = 0.0;
  double* keys = nullptr;  ///< out
  std::size_t least = 0;   ///< out: the first agent with the least of them
};

struct Kernels {
  const char* name;
  void (*draw)(Drawing&);
  /// Agent after agent, as make_whale_step (optimizer/whale_step) has it about the middle of the disc, then into the disc: whoever searches goes to where the other one is by then.
  void (*move)(const Moving&);
  void (*rank)(Ranking&);
};

/// Those that this processor can run, the plainest first.
std::span<const Kernels> available();
/// The widest of them.
const Kernels& best();

}  // namespace waywright::whale_lanes
