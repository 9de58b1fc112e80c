// Good orders of more places than can be searched exactly.
#include <algorithm>
#include <numeric>

#include "waywright/core/random.hpp"
#include "waywright/planner/visiting_order.hpp"

namespace waywright {
namespace {

using Order = std::vector<std::size_t>;

constexpr std::size_t few_places = 40;  // up to so many blocks of any length are exchanged
constexpr std::size_t short_block = 3;  // beyond, one of the two is at most so long

/// An order that is being made shorter. A change is looked at between its first and its last place only: what is carried before and after is the same.
class Tour {
 public:
  Tour(const VisitProblem& problem, Order order) : problem_{problem}, seen_(problem.places.size(), 0) { set(std::move(order)); }

  const Order& order() const { return order_; }
  std::int64_t length() const { return sums_.back(); }

  /// Exchanges and turns until nothing gets shorter.
  void improve(const std::atomic<bool>* cancel) {
    const std::size_t n = movable();
    const std::size_t longest = n <= few_places ? n : short_block;
    for (bool is_shorter = true; is_shorter;) {
      is_shorter = false;
      for (std::size_t first = 0; first + 1 < n; ++first) {
        if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return;
        for (std::size_t end = first + 2; end <= n; ++end) {
          is_shorter = try_turned(first, end) || is_shorter;
          for (std::size_t middle = first + 1; middle < end; ++middle) {
            if (std::min(middle - first, end - middle) > longest) {
              middle = end - longest - 1;  // the blocks between are both too long
              continue;
            }
            is_shorter = try_exchanged(first, middle, end) || is_shorter;
          }
        }
      }
    }
  }

  /// Two neighbouring blocks change places, whatever that costs. False where it breaks a rule.
  bool shake(std::size_t first, std::size_t middle, std::size_t end) {
    exchange(first, middle, end);
    return length_of_trial(first) && accept(first);
  }
  /// So many places, from the first on, may change their places.
  std::size_t movable() const { return problem_.places.size() - (problem_.keeps_last ? 1 : 0); }

 private:
  void set(Order order) {
    order_ = std::move(order);
    const std::size_t n = order_.size();
    sums_.assign(n + 1, 0);
    states_.assign(n + 1, problem_.start_state);
    position_.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      sums_[i + 1] = sums_[i] + problem_.length(before(i), order_[i]);
      states_[i + 1] = problem_.places[order_[i]].gives;
      position_[order_[i]] = i;
    }
  }
  std::size_t before(std::size_t i) const { return i == 0 ? problem_.start() : order_[i - 1]; }

  /// The length of the places in trial_, which stand from `first` on, and of the way on from them; empty where they break a rule.
  std::optional<std::int64_t> length_of_trial(std::size_t first) {
    ++epoch_;
    std::int64_t length = 0;
    int state = states_[first];
    std::size_t at = before(first);
    for (const std::size_t to : trial_) {
      const VisitPlace& place = problem_.places[to];
      if (place.needs != state) return std::nullopt;
      for (const std::size_t a : place.after) {
        if (position_[a] >= first && seen_[a] != epoch_) return std::nullopt;
      }
      length += problem_.length(at, to);
      state = place.gives;
      seen_[to] = epoch_;
      at = to;
    }
    const std::size_t end = first + trial_.size();
    return end < order_.size() ? length + problem_.length(at, order_[end]) : length;
  }
  bool accept(std::size_t first) {
    Order next = order_;
    std::copy(trial_.begin(), trial_.end(), next.begin() + static_cast<std::ptrdiff_t>(first));
    set(std::move(next));
    return true;
  }
  bool take_if_shorter(std::size_t first) {
    const auto length = length_of_trial(first);
    const std::size_t end = std::min(first + trial_.size() + 1, order_.size());
    return length && *length < sums_[end] - sums_[first] && accept(first);
  }
  void exchange(std::size_t first, std::size_t middle, std::size_t end) {
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    trial_.assign(at(middle), at(end));
    trial_.insert(trial_.end(), at(first), at(middle));
  }
  bool try_exchanged(std::size_t first, std::size_t middle, std::size_t end) {
    exchange(first, middle, end);
    return take_if_shorter(first);
  }
  bool try_turned(std::size_t first, std::size_t end) {
    trial_.assign(order_.rend() - static_cast<std::ptrdiff_t>(end), order_.rend() - static_cast<std::ptrdiff_t>(first));
    return take_if_shorter(first);
  }

  const VisitProblem& problem_;
  Order order_, trial_;
  std::vector<std::int64_t> sums_;  ///< of the ways up to a place
  std::vector<int> states_;         ///< in which a place is come to
  std::vector<std::size_t> position_;
  std::vector<std::uint64_t> seen_;
  std::uint64_t epoch_ = 0;
};

/// Always on to the nearest place that may be next, after this one; empty where there is none once.
std::optional<Order> nearest_neighbours(const VisitProblem& problem, std::size_t first) {
  const std::size_t n = problem.places.size();
  Order order;
  std::vector<bool> visited(n, false);
  std::size_t at = problem.start();
  int state = problem.start_state;
  while (order.size() < n) {
    std::int64_t least = 0;
    std::size_t next = n;
    for (std::size_t to = 0; to < n; ++to) {
      const VisitPlace& place = problem.places[to];
      if (visited[to] || place.needs != state || (order.empty() && to != first)) continue;
      if (problem.keeps_last && to == n - 1 && order.size() + 1 < n) continue;
      if (!std::all_of(place.after.begin(), place.after.end(), [&](std::size_t a) { return visited[a]; })) continue;
      const std::int64_t length = problem.length(at, to);
      if (next == n || length < least) least = length, next = to;
    }
    if (next == n) return std::nullopt;
    order.push_back(next);
    visited[next] = true;
    at = next;
    state = problem.places[next].gives;
  }
  return order;
}

}  // namespace

std::optional<Order> good_visit_order(const VisitProblem& problem, const std::atomic<bool>* cancel) {
  constexpr std::size_t starts = 8;
  const std::size_t n = problem.places.size();
  Order given(n);
  std::iota(given.begin(), given.end(), std::size_t{0});
  if (n == 0) return given;
  Tour first{problem, std::move(given)};
  first.improve(cancel);
  Order best = first.order();
  std::int64_t length = first.length();
  const auto keep_if_shorter = [&](Tour& tour) {
    tour.improve(cancel);
    if (tour.length() >= length) return;
    length = tour.length();
    best = tour.order();
  };
  for (std::size_t i = 0; i < std::min(starts, n); ++i) {
    auto order = nearest_neighbours(problem, i * n / std::min(starts, n));
    if (!order) continue;
    Tour tour{problem, std::move(*order)};
    keep_if_shorter(tour);
  }
  const std::size_t shakes = n <= few_places ? 200 : 8000 / n;
  const std::size_t m = first.movable();
  for (std::size_t shake = 0; shake < shakes && m >= 3; ++shake) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) break;
    Random random = Random::stream(1, shake);
    const auto at = [&](std::size_t low, std::size_t high) {
      return static_cast<std::size_t>(random.integer(static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)));
    };
    Tour tour{problem, best};
    bool is_shaken = false;
    for (int draw = 0; draw < 20 && !is_shaken; ++draw) {
      const std::size_t begin = at(0, m - 2);
      const std::size_t middle = at(begin + 1, m - 1);
      is_shaken = tour.shake(begin, middle, at(middle + 1, m));
    }
    if (is_shaken) keep_if_shorter(tour);
  }
  if (length >= no_way) return std::nullopt;
  return best;
}

}  // namespace waywright
