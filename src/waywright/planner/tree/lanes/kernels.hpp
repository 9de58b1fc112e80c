// The inner loops of local whales: what an extension draws, and how its agents move until one of them is promising, as many side by side as a register has
// numbers. Written once, compiled for each instruction set, chosen at run time; every one gives the same bits, because each lane is plain IEEE arithmetic in a fixed order.
//
// Places count from the sample, in metres. They are single precision: a disc of 2.5 m in steps of a quarter of a micrometre, twice as many agents in a register.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace waywright::whale_lanes {

/// Arrays have so many more elements than they are said to have, which are read and written, and mean nothing.
inline constexpr std::size_t spare = 16;

/// What an extension draws; moves are numbered iteration after iteration. Each of a stream's words (core/random) gives two numbers, its lower half first:
/// ⌊half/2^8⌋/2^24, uniform in [0, 1). In this order, each kind from a new word on: u of each agent, v of each agent; r of each move, s of each move, p of each move. Agents
/// begin at radius √u (cos 2πv, sin 2πv), evenly over the disc. A move with p ≥ choice is a spiral with l = 2 r − 1; else A = 2 a r − a and C = 2 s, and where
/// |A| ≥ threshold the agent goes to agent ⌊p/min(choice, 1) · agents⌋: of what p can be there, that is uniform, too.
struct Drawing {
  std::uint64_t counter = 0;  ///< of the stream, see Random::take
  std::size_t agents = 0, moves = 0;
  const float* reach = nullptr;  ///< [a] of each move
  float spiral = 1.0F, choice = 0.5F, threshold = 1.0F;
  float radius = 1.0F;  ///< m

  float *x = nullptr, *y = nullptr;           ///< out, of each agent
  float *factor = nullptr, *scale = nullptr;  ///< out, of each move: −A, C; of a spiral: e^{bl} cos 2πl, 1
  std::int32_t* other = nullptr;              ///< out, of each move: the agent that a search goes to; negative of every other move
};
/// Words that it takes of the stream.
inline std::uint64_t drawn(std::size_t agents, std::size_t moves) {
  const std::uint64_t a = (std::uint64_t{agents} + 1) / 2, m = (std::uint64_t{moves} + 1) / 2;
  return 2 * a + 3 * m;
}

/// Iterations until one leads to where it is promising. What an agent's place says of its cost is its key: per_radius |x| + along_x x + along_y y.
struct Flight {
  std::size_t agents = 0;  ///< > 0
  float radius = 1.0F;
  float per_radius = 0.0F, along_x = 0.0F, along_y = 0.0F;
  const float *factor = nullptr, *scale = nullptr;  ///< of all moves
  const std::int32_t* other = nullptr;
  std::size_t searching = 0;            ///< moves from this one on are no searches
  std::size_t first = 0, moves = 0;     ///< in, out: the first move that is not made yet; of all
  float leader_x = 0.0F, leader_y = 0.0F;
  float enough = 0.0F;                  ///< keys under it are promising
  float *x = nullptr, *y = nullptr;     ///< in, out: of each agent
  float *before_x = nullptr, *before_y = nullptr;  ///< memory for as many
  float* keys = nullptr;                ///< out: after the last iteration that was made
  bool is_promising = false;            ///< out: one is
  std::size_t least = 0;                ///< out, where one is: the first agent with the least key
};

struct Kernels {
  const char* name;
  void (*draw)(Drawing&);
  /// All agents at once, as make_whale_step (optimizer/whale_step) has it about the middle of the disc, then into the disc (a little less than the radius, so that rounding
  /// does not lead out of it); whoever searches goes to where the other one was before the iteration. Ends with the first iteration after which a key is promising,
  /// or with the last one. Before the first iteration call `rank`.
  void (*fly)(Flight&);
  /// The keys and whether one is promising, no move made.
  void (*rank)(Flight&);
};

/// Those that this processor can run, the plainest first.
std::span<const Kernels> available();
/// The widest of them.
const Kernels& best();

}  // namespace waywright::whale_lanes
