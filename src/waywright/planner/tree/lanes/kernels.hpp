// The inner loops of local whales: what an extension draws, and how its agents move until one of them has to be looked at, as many side by side as a register has
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

struct Place {
  float x = 0.0F, y = 0.0F;  ///< m
};

/// What is surely blocked: a line that comes as near as that to the middle is blocked.
struct Shadow {
  float x = 0.0F, y = 0.0F;  ///< of its middle, from where lines begin, m; not both 0
  float squared = -1.0F;     ///< of its radius, m²; negative: it hides nothing
};
inline constexpr std::size_t most_shadows = 4;
inline constexpr int directions = 2048;  ///< in which a view tells how far it sees: a power of two

/// Iterations until one leads to where something has to be looked at. An agent's key is what its distances cost: per_radius |x| + per_goal |x − goal|. Its bound is what it costs
/// at least: the key, `dark` where a shadow lies on its line, and `hidden` where the goal is hidden from it for sure. That is all that it costs where its line is lit, and whether
/// it sees the goal is told: such an agent becomes the leader, and the flight goes on.
struct Flight {
  std::size_t agents = 0;  ///< > 0
  float radius = 1.0F;
  float per_radius = 0.0F, per_goal = 0.0F, goal_x = 0.0F, goal_y = 0.0F;
  float dark = 0.0F, hidden = 0.0F;  ///< ≥ 0

  float begin_x = 0.0F, begin_y = 0.0F;  ///< where lines to the agents begin
  Shadow shadows[most_shadows]{};
  std::size_t shadow_count = 0;
  float lit_squared = -1.0F;                                     ///< m²: lines are lit whose squared length is less,
  float lit_x = 0.0F, lit_y = 0.0F, lit_around_squared = -1.0F;  ///< and those to places whose squared distance from this one is less
  enum class Goal { not_told, is_seen, is_hidden, told_by_view } goal = Goal::not_told;  ///< from all places, or as its view tells of each
  const float *seen_squares = nullptr, *hidden_squares = nullptr;  ///< of the view, see PlaneView; one for each direction
  float at_goal_squared = 0.0F;  ///< m²: nothing is told of places whose squared distance from the goal is no greater

  const float *factor = nullptr, *scale = nullptr;  ///< of all moves
  const std::int32_t* other = nullptr;
  std::size_t searching = 0;                ///< moves from this one on are no searches
  std::size_t first = 0, moves = 0;         ///< in, out: the first move that is not made yet; of all
  float leader_x = 0.0F, leader_y = 0.0F;   ///< in, out: the best place so far
  float enough = 0.0F;                      ///< in, out: what that costs; who costs less is promising
  float *x = nullptr, *y = nullptr;         ///< in, out: of each agent
  float *before_x = nullptr, *before_y = nullptr;  ///< memory for as many
  std::int32_t* is_known = nullptr;                ///< likewise
  bool is_promising = false;                       ///< out: one is, and has to be looked at
  // Out, where one is, after the last iteration that was made:
  std::size_t least = 0;                     ///< the first agent with the least bound
  float *keys = nullptr, *bounds = nullptr;  ///< of each agent
  std::int32_t* is_dark = nullptr;           ///< not 0 where a shadow lies on its line
};

struct Kernels {
  const char* name;
  void (*draw)(Drawing&);
  /// All agents at once, as make_whale_step (optimizer/whale_step) has it about the middle of the disc, then into the disc (a little less than the radius, so that rounding
  /// does not lead out of it); whoever searches goes to where the other one was before the iteration. Ends with the first iteration after which someone has
  /// to be looked at, or with the last one. Before the first iteration call `rank`.
  void (*fly)(Flight&);
  /// Keys, bounds, and whether one is promising, no move made.
  void (*rank)(Flight&);
  /// What one more shadow makes of bounds: those that are greater stay as they are.
  void (*shade)(const Flight&, const Shadow&);
};

/// Those that this processor can run, the plainest first.
std::span<const Kernels> available();
/// The widest of them.
const Kernels& best();

}  // namespace waywright::whale_lanes
