// In which order places are visited, by the lengths of the ways between them: nothing here knows of maps or vehicles.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace waywright {

/// A way that is not there. Lengths are whole micrometres, so that sums are exact and equal orders are equal.
inline constexpr std::int64_t no_way = 1'000'000'000'000'000;

/// What the vehicle carries is a state: 0 is nothing, k ≥ 1 the load of job k, which is taken at one place and left at another.
struct VisitPlace {
  int needs = 0;                     ///< the state in which it is visited
  int gives = 0;                     ///< the state after it
  std::vector<std::size_t> after{};  ///< places that have to be visited before it
};

struct VisitProblem {
  std::vector<VisitPlace> places;
  int start_state = 0;
  std::vector<std::int64_t> lengths;  ///< row `from` (the last row: the start), column `to`; µm, ≥ 0, or no_way
  bool keeps_last = false;            ///< the last place stays the last

  std::int64_t length(std::size_t from, std::size_t to) const { return lengths[from * places.size() + to]; }
  std::size_t start() const { return places.size(); }
};

/// May some order lead from one place (or the start) to another at once, by the rules of the places?
bool may_follow(const VisitProblem& problem, std::size_t from, std::size_t to);

/// Of an order of all places: its length, no_way or more where ways are missing; empty where it breaks a rule of the places.
std::optional<std::int64_t> visit_length(const VisitProblem& problem, const std::vector<std::size_t>& order);

/// Up to so many places the shortest order is found by dynamic programming over their subsets (Held and Karp 1962).
inline constexpr std::size_t most_exact_places = 16;

/// The shortest order of all, the first in the order of the places where several are as short; empty where there is none.
/// @pre at most most_exact_places
std::optional<std::vector<std::size_t>> shortest_visit_order(const VisitProblem& problem);

/// A good order: neighbouring blocks exchanged (Or-opt) and blocks turned around (2-opt) until nothing gets shorter, from the order of the places
/// and from nearest neighbours, then shaken and mended again a fixed number of times. Empty where none without a missing way was found.
/// A raised flag ends it early. @pre the order of the places breaks no rule
std::optional<std::vector<std::size_t>> good_visit_order(const VisitProblem& problem, const std::atomic<bool>* cancel = nullptr);

/// No order is shorter than this: the spanning arborescence from the start, with multipliers for places that more or fewer than one way leaves
/// (Held and Karp 1970, for ways that are longer one way than the other). `upper`: the length of a known order. no_way: there is no order.
std::int64_t visit_length_bound(const VisitProblem& problem, std::int64_t upper, const std::atomic<bool>* cancel = nullptr);

}  // namespace waywright
