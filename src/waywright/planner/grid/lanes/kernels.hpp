// The inner loop of a grid search: what all sixteen moves out of a cell cost, and which of them are better than what is known, at once.
// Compiled for each instruction set and chosen at run time; whole numbers alone, so that every one gives the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace waywright::move_lanes {

inline constexpr int moves = 16;

/// What stays the same from cell to cell.
struct Lattice {
  alignas(64) std::uint32_t weight[moves];  ///< of each move's length; (2 × the greatest danger + 511) × weight fits 32 bits
  alignas(64) std::int32_t column[moves], row[moves];
  std::ptrdiff_t width = 0;               ///< cells from a row to the next
  const std::uint16_t* danger = nullptr;  ///< of each cell, or none. `before` and `after` cells can be read before the first and behind the last
  /// The rest over so many columns and rows is the greater of steep × most + flat × least, less `less` where it is more.
  std::uint32_t most[2] = {}, least[2] = {}, less = 0;

  static constexpr std::ptrdiff_t before(std::ptrdiff_t width) { return 2 * width + 2; }
  static constexpr std::ptrdiff_t after(std::ptrdiff_t width) { return 2 * width + 8; }
};

/// A cell that is left.
struct From {
  const std::uint32_t* key;  ///< of this cell; what is known of all the others lies around it, as danger does
  std::ptrdiff_t cell;
  std::uint32_t cost;     ///< to here
  std::uint32_t base;     ///< a key is a cost and this
  std::int32_t column, row;  ///< from what the rest is expected to, to here
  std::uint32_t free;     ///< bit i: move i
};

struct alignas(64) Arrivals {
  std::uint32_t cost[moves];   ///< over here
  std::uint32_t bound[moves];  ///< and of the rest
};

struct Kernels {
  const char* name;
  /// Bit i: move i is free and its key would be under the one that is known. Of the others what `Arrivals` has is nothing.
  std::uint32_t (*leave)(const Lattice&, const From&, Arrivals&);
};

/// Those that this processor can run, the plainest first.
std::span<const Kernels> available();
/// The widest of them.
const Kernels& best();

}  // namespace waywright::move_lanes
