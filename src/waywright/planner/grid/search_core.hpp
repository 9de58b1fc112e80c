// The search itself, for any space of states: A* on flat arrays, with costs in whole numbers.
//
// Nothing is cleared from search to search: a state's record says of which search it is. The queue is buckets of equal width of what a way over
// a state costs at least; within a bucket the state found last comes first, and one that turns out cheaper later is looked at again, so that the
// answer is the least cost whatever the width. Or it is a heap in the publication's order: least cost first, then least expected rest, then the older entry.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "waywright/core/budget.hpp"

namespace waywright::grid {

inline constexpr std::uint32_t no_cost = std::numeric_limits<std::uint32_t>::max();

/// What a search knows of a state. 8 bytes.
struct Visit {
  std::uint32_t cost = 0;        ///< from the start
  std::uint16_t generation = 0;  ///< of which search it is
  std::uint8_t came_by = 0;      ///< the move that led here
  std::uint8_t is_start = 0;     ///< nothing led here
};

/// A state that waits.
struct Waiting {
  std::uint32_t cost = 0;
  std::uint32_t state = 0;  ///< packed as the space has it
};

/// Buckets in a ring; their memory is kept from search to search.
class BucketQueue {
 public:
  /// `spread`: the greatest difference between what waits and the least of it. `width` of a bucket: a power of two.
  void begin(std::uint64_t least, std::uint64_t spread, std::uint32_t width) {
    shift_ = static_cast<unsigned>(std::countr_zero(width));
    const std::size_t ring = std::bit_ceil(static_cast<std::size_t>(spread >> shift_) + 3);
    for (std::vector<Waiting>& b : buckets_) b.clear();
    if (buckets_.size() < ring) buckets_.resize(ring);
    mask_ = buckets_.size() - 1;
    current_ = least >> shift_;
    waiting_ = 0;
  }
  void push(std::uint64_t bound, std::uint32_t /*rest*/, Waiting entry) {
    const std::uint64_t at = std::max(bound >> shift_, current_);
    buckets_[at & mask_].push_back(entry);
    ++waiting_;
  }
  /// False where nothing is left that could cost less than `enough`.
  bool pop(std::uint64_t enough, Waiting& entry) {
    if (waiting_ == 0) return false;
    while (buckets_[current_ & mask_].empty()) ++current_;
    if (current_ > enough >> shift_) return false;
    std::vector<Waiting>& bucket = buckets_[current_ & mask_];
    entry = bucket.back();
    bucket.pop_back();
    --waiting_;
    return true;
  }
  std::size_t bytes() const {
    std::size_t sum = buckets_.capacity() * sizeof(std::vector<Waiting>);
    for (const std::vector<Waiting>& b : buckets_) sum += b.capacity() * sizeof(Waiting);
    return sum;
  }

 private:
  unsigned shift_ = 0;
  std::uint64_t current_ = 0;
  std::size_t mask_ = 0, waiting_ = 0;
  std::vector<std::vector<Waiting>> buckets_;
};

/// The publication's order, exactly.
class OrderedQueue {
 public:
  void begin(std::uint64_t, std::uint64_t, std::uint32_t) {
    heap_.clear();
    serial_ = 0;
  }
  void push(std::uint64_t bound, std::uint32_t rest, Waiting entry) {
    heap_.push_back({bound, rest, serial_++, entry});
    std::push_heap(heap_.begin(), heap_.end(), later);
  }
  bool pop(std::uint64_t enough, Waiting& entry) {
    if (heap_.empty() || heap_.front().bound >= enough) return false;
    std::pop_heap(heap_.begin(), heap_.end(), later);
    entry = heap_.back().entry;
    heap_.pop_back();
    return true;
  }

 private:
  struct Ordered {
    std::uint64_t bound;
    std::uint32_t rest, serial;
    Waiting entry;
  };
  static bool later(const Ordered& a, const Ordered& b) {
    if (a.bound != b.bound) return a.bound > b.bound;
    return a.rest != b.rest ? a.rest > b.rest : a.serial > b.serial;
  }
  std::vector<Ordered> heap_;
  std::uint32_t serial_ = 0;
};

enum class Ended { found, exhausted, expansions, time, canceled, overflow };

struct Outcome {
  Ended ended = Ended::exhausted;
  std::uint64_t cost = 0;  ///< found: of the whole way, what follows the target included
  std::uint32_t target = 0;  ///< found: the packed state that the way ends in
  std::int64_t expansions = 0;
};

/// A state that the search begins or may end in, and what lies before or after it.
struct Terminal {
  std::uint32_t state = 0;
  std::uint32_t cost = 0;
};

/// Memory of searches; one thread at a time.
template <class Queue>
struct Memory {
  std::vector<Visit> visits;
  std::uint16_t generation = 0;
  Queue queue;

  void begin(std::size_t states) {
    if (visits.size() != states) {
      visits.assign(states, Visit{});
      generation = 0;
    }
    if (++generation == 0) {  // once in 65 535 searches
      std::fill(visits.begin(), visits.end(), Visit{});
      generation = 1;
    }
  }
};

/// Least cost from any of the starts to any of the targets. A space has
///   size()                             how many states,
///   index(state)                       of a packed state, below size(),
///   rest(state)                        what is left at least, as the heuristic has it; the search is exact where it is never too much,
///   may_be_target(state)               a quick look, false for most,
///   expand(state, emit(state, index, cost, move)),
///   most_cost(), most_rest()           of one move; of any state,
///   bucket_width()                     a power of two.
/// `before_expansion(n)` is asked every 1024 expansions, with how many there were, and may end the search.
template <class Space, class Queue, class Stop>
Outcome search(Space& space, Memory<Queue>& memory, const std::vector<Terminal>& starts, std::vector<Terminal> targets, std::int64_t most_expansions, Stop&& stop) {
  const auto before = [](const Terminal& a, const Terminal& b) { return a.state < b.state; };
  std::sort(targets.begin(), targets.end(), before);  // a region has many
  memory.begin(space.size());
  Visit* const visits = memory.visits.data();
  const std::uint16_t generation = memory.generation;
  Queue& queue = memory.queue;
  Outcome outcome;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max(), greatest = 0;
  for (const Terminal& s : starts) {
    const std::uint64_t bound = static_cast<std::uint64_t>(s.cost) + space.rest(s.state);
    least = std::min(least, bound);
    greatest = std::max(greatest, bound);
  }
  if (starts.empty() || targets.empty()) return outcome;
  // No sum of a cost, the next move and the rest may leave 32 bits.
  const std::uint64_t room = no_cost;
  if (greatest + space.most_cost() + space.most_rest() >= room) {
    outcome.ended = Ended::overflow;
    return outcome;
  }
  const auto most_cost = static_cast<std::uint32_t>(room - space.most_cost() - space.most_rest());
  queue.begin(least, greatest - least + 3ULL * space.most_cost(), space.bucket_width());
  for (const Terminal& s : starts) {
    Visit& v = visits[space.index(s.state)];
    if (v.generation == generation && v.cost <= s.cost) continue;
    v = {s.cost, generation, 0, 1};
    queue.push(static_cast<std::uint64_t>(s.cost) + space.rest(s.state), space.rest(s.state), {s.cost, s.state});
  }
  std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
  bool overflowed = false;
  Waiting at;
  while (queue.pop(best, at)) {
    if (visits[space.index(at.state)].cost != at.cost) continue;
    if (space.may_be_target(at.state)) {
      for (auto t = std::lower_bound(targets.begin(), targets.end(), Terminal{at.state, 0}, before); t != targets.end() && t->state == at.state; ++t) {
        const std::uint64_t whole = static_cast<std::uint64_t>(at.cost) + t->cost;
        if (whole < best) {
          best = whole;
          outcome.target = at.state;
        }
      }
    }
    if (outcome.expansions == most_expansions) {
      outcome.ended = Ended::expansions;
      return outcome;
    }
    if ((outcome.expansions & 1023) == 0) {
      if (const auto why = stop()) {
        outcome.ended = *why;
        return outcome;
      }
    }
    ++outcome.expansions;
    space.expand(at.state, [&](std::uint32_t next, std::size_t index, std::uint32_t cost, int move) {
      const std::uint32_t sum = at.cost + cost;
      Visit& v = visits[index];
      if (v.generation == generation && v.cost <= sum) return;
      if (sum > most_cost) {
        overflowed = true;
        return;
      }
      v = {sum, generation, static_cast<std::uint8_t>(move), 0};
      const std::uint32_t rest = space.rest(next);
      queue.push(static_cast<std::uint64_t>(sum) + rest, rest, {sum, next});
    });
  }
  outcome.cost = best;
  if (best != std::numeric_limits<std::uint64_t>::max()) outcome.ended = Ended::found;
  else outcome.ended = overflowed ? Ended::overflow : Ended::exhausted;
  return outcome;
}

}  // namespace waywright::grid
