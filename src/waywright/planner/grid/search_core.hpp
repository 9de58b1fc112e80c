// The search itself, for any space of states: A* on flat arrays, with costs in whole numbers.
//
// Nothing is cleared from search to search: what a former one left is greater than all that a new one writes, until the numbers run out. The queue is buckets of equal width of what a way over
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

/// The move that led somewhere. A type of its own, as a write to bytes could change anything, for all that the compiler knows.
enum class CameBy : std::uint8_t { nothing = 255 };  ///< nothing led to a start

/// What a search knows of its states, 5 bytes of each; one thread at a time. A state's key is its cost and `base`, which goes down from search to
/// search by so much that all keys of former ones are greater than any of the new.
class Reached {
 public:
  /// `margin`: numbers that can be read before the first key and behind the last. `expected`: of a cost, to guess how great they get.
  void begin(std::size_t states, std::size_t margin, std::uint64_t expected) {
    if (came_by_.size() != states || margin_ != margin) {
      keys_.assign(states + 2 * margin, never);
      came_by_.resize(states);
      margin_ = margin;
      first_ = keys_.data() + margin;
      base_ = never;
    }
    const auto span = static_cast<std::uint32_t>(std::min<std::uint64_t>(4 * expected, never));
    if (base_ < span) {
      std::fill(keys_.begin(), keys_.end(), never);
      base_ = never;
    }
    top_ = base_;
    base_ -= span;
  }
  /// Costs under `cost` can be told from what former searches left, from now on.
  void make_room(std::uint64_t cost) {
    if (cost > top_ - base_) move_to_zero();
  }
  bool is(std::size_t index, std::uint32_t cost) const { return key(index) == base_ + cost; }
  bool is_better(std::size_t index, std::uint32_t cost) const { return base_ + cost < key(index); }
  void reach(std::size_t index, std::uint32_t cost, CameBy came_by) {
    first_[index] = base_ + cost;
    came_by_[index] = came_by;
  }
  CameBy came_by(std::size_t index) const { return came_by_[index]; }
  std::uint32_t base() const { return base_; }
  const std::uint32_t* keys() const { return first_; }

 private:
  static constexpr std::uint32_t never = no_cost;
  std::uint32_t key(std::size_t index) const { return first_[index]; }
  [[gnu::noinline]] void move_to_zero() {
    for (std::uint32_t& key : keys_) key = key >= top_ ? never : key - base_;
    top_ = never;
    base_ = 0;
  }

  std::vector<std::uint32_t> keys_;
  std::vector<CameBy> came_by_;
  std::size_t margin_ = 0;
  std::uint32_t* first_ = nullptr;  // of the states' keys
  std::uint32_t base_ = never, top_ = never;
};

/// Memory of searches; one thread at a time.
template <class Queue>
struct Memory {
  Reached reached;
  Queue queue;
};

/// Least cost from any of the starts to any of the targets. A space has
///   size(), margin()                   how many states; see Reached,
///   index(state)                       of a packed state, below size(),
///   rest(state)                        what is left at least, as the heuristic has it; the search is exact where it is never too much,
///   may_be_target(state)               a quick look, false for most,
///   expand(state, cost, reached, reach(state, index, cost, bound, rest, move))   of each state that is reached for less than is known: the cost to it,
///                                      that and the rest, the rest,
///   most_cost(), most_rest()           of one move; of any state,
///   bucket_width()                     a power of two.
/// `before_expansion(n)` is asked every 1024 expansions, with how many there were, and may end the search.
template <class Space, class Queue, class Stop>
Outcome search(Space& space, Memory<Queue>& memory, const std::vector<Terminal>& starts, std::vector<Terminal> targets, std::int64_t most_expansions, Stop&& stop) {
  const auto before = [](const Terminal& a, const Terminal& b) { return a.state < b.state; };
  std::sort(targets.begin(), targets.end(), before);  // a region has many
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
  const auto most_cost = static_cast<std::uint32_t>(room - space.most_cost() - space.most_rest());  // of a state that is left
  Reached& reached = memory.reached;
  reached.begin(space.size(), space.margin(), greatest + 16ULL * space.most_cost());
  reached.make_room(greatest + 1);
  queue.begin(least, greatest - least + 3ULL * space.most_cost(), space.bucket_width());
  for (const Terminal& s : starts) {
    if (!reached.is_better(space.index(s.state), s.cost)) continue;
    reached.reach(space.index(s.state), s.cost, CameBy::nothing);
    queue.push(static_cast<std::uint64_t>(s.cost) + space.rest(s.state), space.rest(s.state), {s.cost, s.state});
  }
  std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
  bool overflowed = false;
  Waiting at;
  while (queue.pop(best, at)) {
    if (!reached.is(space.index(at.state), at.cost)) continue;
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
    if (at.cost > most_cost) {
      overflowed = true;
      continue;
    }
    reached.make_room(static_cast<std::uint64_t>(at.cost) + space.most_cost() + 1);
    space.expand(at.state, at.cost, reached, [&](std::uint32_t next, std::size_t index, std::uint32_t cost, std::uint64_t bound, std::uint32_t rest, int move) {
      reached.reach(index, cost, static_cast<CameBy>(move));
      queue.push(bound, rest, {cost, next});
    });
  }
  outcome.cost = best;
  if (best != std::numeric_limits<std::uint64_t>::max()) outcome.ended = Ended::found;
  else outcome.ended = overflowed ? Ended::overflow : Ended::exhausted;
  return outcome;
}

}  // namespace waywright::grid
