// Random numbers that are the same on every machine and for any number of threads.
#pragma once

#include <cstdint>

namespace waywright {

/// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014).
/// Seed 1 gives 0x910a2dec89025cc1, 0xbeeb8da1658eec67, 0xf893a2eefb32555e.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_{seed} {}
  /// An independent stream: the answer to (seed, index) never depends on who draws first.
  static Random stream(std::uint64_t seed, std::uint64_t index) {
    Random mixer{seed ^ (increment * (index + 1))};
    return Random{mixer.next()};
  }

  std::uint64_t next() {
    state_ += increment;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  /// Leaves out the next `count` numbers, for code that makes many of them side by side: number i of them, from 0, is what next() makes of
  /// the returned value + (i + 1) 0x9E3779B97F4A7C15.
  std::uint64_t take(std::uint64_t count) {
    const std::uint64_t counter = state_;
    state_ += count * increment;
    return counter;
  }
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform integer in [low, high], both included; @pre low ≤ high.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    const auto first = static_cast<std::uint64_t>(low);  // unsigned: the widest range overflows otherwise
    const std::uint64_t span = static_cast<std::uint64_t>(high) - first + 1;
    return static_cast<std::int64_t>(first + (span == 0 ? next() : next() % span));
  }

 private:
  static constexpr std::uint64_t increment = 0x9E3779B97F4A7C15ULL;
  std::uint64_t state_;
};

}  // namespace waywright
