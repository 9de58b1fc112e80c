// A lower bound of the length of any order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/planner/visiting_order.hpp"

namespace waywright {
namespace {

constexpr double none = 1e18;  // µm: no arc
constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

/// Costs of arcs from row to column.
struct Arcs {
  std::size_t size = 0;
  std::vector<double> costs;
  double& at(std::size_t from, std::size_t to) { return costs[from * size + to]; }
  double at(std::size_t from, std::size_t to) const { return costs[from * size + to]; }
};

/// Whom each node of the least arborescence from `root` hangs on (Chu and Liu 1965, Edmonds 1967: cycles of least arcs become nodes).
std::vector<std::size_t> least_arborescence(const Arcs& arcs, std::size_t root) {
  const std::size_t n = arcs.size;
  std::vector<std::size_t> parent(n, nobody);
  for (std::size_t to = 0; to < n; ++to) {
    if (to == root) continue;
    std::size_t least = to == 0 ? 1 : 0;
    for (std::size_t from = 0; from < n; ++from) {
      if (from != to && arcs.at(from, to) < arcs.at(least, to)) least = from;
    }
    parent[to] = least;
  }
  std::vector<std::size_t> part(n, nobody), walk(n, nobody);
  std::vector<bool> is_in_cycle(n, false);
  std::size_t parts = 0;
  for (std::size_t from = 0; from < n; ++from) {
    std::size_t at = from;
    while (at != nobody && walk[at] == nobody) {
      walk[at] = from;
      at = parent[at];
    }
    if (at == nobody || walk[at] != from) continue;
    for (std::size_t c = at; part[c] == nobody; c = parent[c]) {
      part[c] = parts;
      is_in_cycle[c] = true;
    }
    ++parts;
  }
  if (parts == 0) return parent;
  for (std::size_t i = 0; i < n; ++i) {
    if (part[i] == nobody) part[i] = parts++;
  }
  Arcs whole{parts, std::vector<double>(parts * parts, 2.0 * none)};
  std::vector<std::size_t> tail(parts * parts, nobody), head(parts * parts, nobody);
  for (std::size_t from = 0; from < n; ++from) {
    for (std::size_t to = 0; to < n; ++to) {
      if (part[from] == part[to] || to == root) continue;
      const double cost = arcs.at(from, to) - (is_in_cycle[to] ? arcs.at(parent[to], to) : 0.0);
      const std::size_t index = part[from] * parts + part[to];
      if (tail[index] != nobody && cost >= whole.costs[index]) continue;
      whole.costs[index] = cost;
      tail[index] = from;
      head[index] = to;
    }
  }
  const std::vector<std::size_t> above = least_arborescence(whole, part[root]);
  for (std::size_t p = 0; p < parts; ++p) {
    if (above[p] == nobody) continue;
    const std::size_t index = above[p] * parts + p;
    parent[head[index]] = tail[index];
  }
  return parent;
}

}  // namespace

std::int64_t visit_length_bound(const VisitProblem& problem, std::int64_t upper, const std::atomic<bool>* cancel) {
  const std::size_t n = problem.places.size();
  if (n == 0) return 0;
  const std::size_t start = n, end = n + 1;
  std::vector<bool> is_before_another(n, false);
  for (const VisitPlace& place : problem.places) {
    for (const std::size_t a : place.after) is_before_another[a] = true;
  }
  Arcs arcs{n + 2, std::vector<double>((n + 2) * (n + 2), none)};
  for (std::size_t from = 0; from <= n; ++from) {
    for (std::size_t to = 0; to < n; ++to) {
      if (may_follow(problem, from, to) && problem.length(from, to) < no_way) arcs.at(from, to) = static_cast<double>(problem.length(from, to));
    }
    if (from < n && !is_before_another[from] && (!problem.keeps_last || from == n - 1)) arcs.at(from, end) = 0.0;
  }
  std::vector<double> price(n + 1, 0.0);
  double best = 0.0, pace = 1.0;
  int since = 0;
  for (int round = 0; round < 400 && !(cancel != nullptr && cancel->load(std::memory_order_relaxed)); ++round) {
    Arcs priced = arcs;
    double bound = 0.0;
    for (std::size_t from = 0; from <= n; ++from) {
      bound -= price[from];
      for (std::size_t to = 0; to < n + 2; ++to) {
        if (priced.at(from, to) < none) priced.at(from, to) += price[from];
      }
    }
    const std::vector<std::size_t> parent = least_arborescence(priced, start);
    std::vector<double> leaving(n + 1, -1.0);
    for (std::size_t to = 0; to < n + 2; ++to) {
      if (to == start) continue;
      const double cost = priced.at(parent[to], to);
      if (cost >= 0.5 * none) return no_way;  // nothing leads there from anywhere
      bound += cost;
      leaving[parent[to]] += 1.0;
    }
    ++since;
    if (bound > best) best = bound, since = 0;
    double square = 0.0;
    for (const double g : leaving) square += g * g;
    if (square == 0.0) break;  // it is a way through all of them
    if (since >= 10) pace *= 0.7, since = 0;
    const double step = pace * std::max(static_cast<double>(upper) - bound, 1.0) / square;
    for (std::size_t i = 0; i <= n; ++i) price[i] += step * leaving[i];
  }
  // Lengths are whole; what the sums above round is less than what is taken off.
  return std::min(upper, static_cast<std::int64_t>(std::ceil(best - 0.01 - 1e-12 * best)));
}

}  // namespace waywright
