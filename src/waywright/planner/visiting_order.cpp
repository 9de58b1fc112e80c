#include "waywright/planner/visiting_order.hpp"

#include <algorithm>

namespace waywright {
namespace {

constexpr int never = -2;  // the state of a set of places that no order begins with

bool is_before(const VisitProblem& problem, std::size_t a, std::size_t b) {
  const auto& after = problem.places[b].after;
  return std::find(after.begin(), after.end(), a) != after.end();
}

}  // namespace

bool may_follow(const VisitProblem& problem, std::size_t from, std::size_t to) {
  const std::size_t n = problem.places.size();
  if (from == to) return false;
  if (problem.keeps_last && (from == n - 1 || (to == n - 1 && from == n && n > 1))) return false;
  if (from == n) return problem.places[to].after.empty() && problem.places[to].needs == problem.start_state;
  return !is_before(problem, to, from) && problem.places[to].needs == problem.places[from].gives;
}

std::optional<std::int64_t> visit_length(const VisitProblem& problem, const std::vector<std::size_t>& order) {
  std::vector<bool> visited(problem.places.size(), false);
  std::size_t at = problem.start();
  int state = problem.start_state;
  std::int64_t length = 0;
  for (const std::size_t to : order) {
    const VisitPlace& place = problem.places[to];
    if (place.needs != state || !std::all_of(place.after.begin(), place.after.end(), [&](std::size_t a) { return visited[a]; })) return std::nullopt;
    length += problem.length(at, to);
    state = place.gives;
    visited[to] = true;
    at = to;
  }
  if (problem.keeps_last && !order.empty() && order.back() + 1 != problem.places.size()) return std::nullopt;
  return length;
}

std::optional<std::vector<std::size_t>> shortest_visit_order(const VisitProblem& problem) {
  const std::size_t n = problem.places.size();
  const std::size_t sets = std::size_t{1} << n;
  std::vector<std::size_t> before(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::size_t a : problem.places[i].after) before[i] |= std::size_t{1} << a;
  }
  // What is carried follows from which places were visited, in whatever order.
  std::vector<int> state(sets, never);
  state[0] = problem.start_state;
  const auto fits = [&](std::size_t set, std::size_t to) {
    const std::size_t bit = std::size_t{1} << to;
    if ((set & bit) != 0 || (before[to] & ~set) != 0 || problem.places[to].needs != state[set]) return false;
    return !problem.keeps_last || to != n - 1 || (set | bit) == sets - 1;
  };
  for (std::size_t set = 0; set < sets; ++set) {
    if (state[set] == never) continue;
    for (std::size_t to = 0; to < n; ++to) {
      if (fits(set, to)) state[set | (std::size_t{1} << to)] = problem.places[to].gives;
    }
  }
  // The least that is left to drive from a place, the last of a set.
  std::vector<std::int64_t> left(sets * n, no_way);
  std::fill(left.end() - static_cast<std::ptrdiff_t>(n), left.end(), 0);
  const auto by = [&](std::size_t set, std::size_t from, std::size_t to) {
    const std::int64_t way = problem.length(from, to);
    const std::int64_t rest = left[(set | (std::size_t{1} << to)) * n + to];
    return way >= no_way || rest >= no_way ? no_way : way + rest;
  };
  for (std::size_t set = sets - 1; set-- > 1;) {
    if (state[set] == never) continue;
    for (std::size_t to = 0; to < n; ++to) {
      if (!fits(set, to)) continue;
      for (std::size_t from = 0; from < n; ++from) {
        if ((set >> from & 1U) != 0) left[set * n + from] = std::min(left[set * n + from], by(set, from, to));
      }
    }
  }
  std::vector<std::size_t> order;
  std::size_t set = 0, at = problem.start();
  while (order.size() < n) {
    std::int64_t least = no_way;
    std::size_t next = n;
    for (std::size_t to = 0; to < n; ++to) {
      if (!fits(set, to)) continue;
      const std::int64_t length = by(set, at, to);
      if (length < least) least = length, next = to;
    }
    if (next == n) return std::nullopt;
    order.push_back(next);
    set |= std::size_t{1} << next;
    at = next;
  }
  return order;
}

}  // namespace waywright
