#include "waywright/planner/order_legs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <set>

#include "waywright/planner/solve_legs.hpp"
#include "waywright/planner/threads.hpp"

namespace waywright {
namespace {

constexpr double per_metre = 1e6;  // lengths are whole micrometres

/// What planning a way has come to.
struct Way {
  std::int64_t length = no_way;
  Failure failure;
  Effort effort;
  bool reproducible = true;
};

struct Asked {
  std::size_t from = 0, to = 0;  ///< from == to: the legs after the first of a group
};

class Ways {
 public:
  Ways(const Scenario& mission, const OrderedLegs& ordered, const std::atomic<bool>* cancel)
      : ordered_{ordered}, cancel_{cancel}, from_start_{mission}, resting_{mission}, of_map_{mission.map} {
    resting_.start_motion = {};  // of the first leg alone
    const VisitProblem& visits = ordered.visits;
    for (std::size_t to = 0; to < visits.places.size(); ++to) {
      for (std::size_t from = 0; from <= visits.places.size(); ++from) {
        if (may_follow(visits, from, to)) asked_.push_back({from, to});
      }
      if (ordered.groups[to].count > 1) asked_.push_back({to, to});
    }
    ways_.resize(asked_.size());
  }

  void plan(unsigned threads) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> has_thrown{false};
    std::exception_ptr thrown;
    on_threads(threads, asked_.size(), [&] {
      try {
        for (std::size_t i = next++; i < asked_.size() && !is_canceled() && !has_thrown; i = next++) ways_[i] = way_of(asked_[i]);
      } catch (...) {  // a thread has nobody above it to catch anything
        if (!has_thrown.exchange(true)) thrown = std::current_exception();
      }
    });
    if (thrown) std::rethrow_exception(thrown);
  }
  bool is_canceled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }
  const std::vector<Asked>& asked() const { return asked_; }
  const std::vector<Way>& ways() const { return ways_; }

  /// The lengths, each with the legs that belong to its end.
  void fill(VisitProblem& visits) const {
    const std::size_t n = visits.places.size();
    std::vector<std::int64_t> within(n, 0);
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      if (asked_[i].from == asked_[i].to) within[asked_[i].to] = ways_[i].length;
    }
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const auto& [from, to] = asked_[i];
      if (from != to && ways_[i].length < no_way && within[to] < no_way) visits.lengths[from * n + to] = ways_[i].length + within[to];
    }
  }

 private:
  Way way_of(const Asked& asked) const {
    const auto& [from, to] = asked;
    const LegGroup& group = ordered_.groups[to];
    if (from == to) return way_within(ordered_.after[to]);
    const bool is_from_start = from == ordered_.groups.size();
    LegBegin begin = is_from_start ? ordered_.start : ordered_.after[from].back();
    if (!is_from_start || ordered_.fixed > 0 || from_start_.start_motion.speed == 0.0) {
      begin.index = group.first;
      return leg_way(resting_, begin);
    }
    Scenario first = from_start_;
    std::swap(first.legs.front(), first.legs[group.first]);
    return leg_way(first, begin);
  }
  /// @param followed what follows each leg of a group
  Way way_within(const std::vector<LegBegin>& followed) const {
    Way all;
    all.length = 0;
    for (std::size_t i = 0; i + 1 < followed.size(); ++i) {
      Way way = leg_way(resting_, followed[i]);
      all.effort.evaluations += way.effort.evaluations;
      all.effort.expansions += way.effort.expansions;
      all.reproducible = all.reproducible && way.reproducible;
      if (way.length >= no_way) {
        all.length = no_way;
        all.failure = std::move(way.failure);
        break;
      }
      all.length += way.length;
    }
    return all;
  }
  Way leg_way(const Scenario& mission, const LegBegin& begin) const {
    Way way;
    const auto solved = solve_leg(mission, begin, of_map_, cancel_);
    if (!solved) {
      way.failure = {Status::no_path, solved.error().message()};
      return way;
    }
    const Plan& plan = solved->plan;
    way.effort = plan.effort;
    way.reproducible = plan.reproducible;
    if (plan.status == Status::solved && plan.metrics.length < static_cast<double>(no_way) / per_metre)
      way.length = std::llround(plan.metrics.length * per_metre);
    else
      way.failure = {plan.status, plan.reason};
    return way;
  }

  const OrderedLegs& ordered_;
  const std::atomic<bool>* cancel_;
  Scenario from_start_, resting_;
  World of_map_;
  std::vector<Asked> asked_;
  std::vector<Way> ways_;
};

double metres(std::int64_t length) { return static_cast<double>(length) / per_metre; }

/// "2 (shelf B), 1, 3 to 4 (goods)": groups by their numbers in the order given.
std::string order_words(const Scenario& mission, const OrderedLegs& ordered, const std::vector<std::size_t>& order) {
  constexpr std::size_t most_named = 40;
  std::string words;
  for (std::size_t i = 0; i < order.size() && i < most_named; ++i) {
    const std::string label = group_label(mission, ordered.groups[order[i]]);
    words += (i == 0 ? "" : ", ") + label.substr(label.find(' ') + 1);
  }
  return order.size() > most_named ? fmt::format("{} and {} more", words, order.size() - most_named) : words;
}

std::string from_label(const Scenario& mission, const OrderedLegs& ordered, std::size_t from) {
  return from == ordered.groups.size() ? std::string{"the start"} : group_label(mission, ordered.groups[from]);
}

/// Why there is no order: places that no ways lead to from the start, one whose own way out is not there, or one that nothing leads away from.
Failure failure_of(const Scenario& mission, const OrderedLegs& ordered, const Ways& ways) {
  const std::size_t n = ordered.groups.size();
  std::vector<bool> is_reached(n + 1, false);
  is_reached[n] = true;
  const auto each_way = [&](const auto& look) {
    for (std::size_t i = 0; i < ways.asked().size(); ++i) {
      if (ways.asked()[i].from != ways.asked()[i].to) look(ways.asked()[i], ways.ways()[i]);
    }
  };
  for (bool is_more = true; is_more;) {
    is_more = false;
    each_way([&](const Asked& asked, const Way& way) {
      if (!is_reached[asked.from] || is_reached[asked.to] || way.length >= no_way) return;
      is_reached[asked.to] = is_more = true;
    });
  }
  // Where a place is missing for want of another it is the other that tells why: the first that a way was planned to from where the vehicle can be.
  const Failure* why = nullptr;
  std::size_t first = 0, count = 0;
  each_way([&](const Asked& asked, const Way& way) {
    if (why != nullptr || !is_reached[asked.from] || is_reached[asked.to]) return;
    why = &way.failure;
    first = asked.to;
  });
  if (why != nullptr) {
    std::string unreached;
    for (std::size_t to = 0; to < n; ++to) {
      if (is_reached[to]) continue;
      unreached += (count++ == 0 ? "" : ", ") + group_label(mission, ordered.groups[to]);
    }
    if (count == n) return {why->status, fmt::format("no place can be reached from the start: {}", why->reason)};
    const std::string of_first = count > 1 ? "; to " + group_label(mission, ordered.groups[first]) : "";
    return {why->status, fmt::format("no order reaches every place: no way leads to {}{}: {}", unreached, of_first, why->reason)};
  }
  for (std::size_t i = 0; i < ways.asked().size(); ++i) {
    const Asked& asked = ways.asked()[i];
    if (asked.from != asked.to || ways.ways()[i].length < no_way) continue;
    return {ways.ways()[i].failure.status, fmt::format("no order drives {}: {}", group_label(mission, ordered.groups[asked.to]), ways.ways()[i].failure.reason)};
  }
  std::vector<bool> leads_on(n + 1, false);
  std::vector<const Failure*> why_not(n + 1, nullptr);
  each_way([&](const Asked& asked, const Way& way) {
    if (way.length < no_way)
      leads_on[asked.from] = true;
    else if (why_not[asked.from] == nullptr)
      why_not[asked.from] = &way.failure;
  });
  for (std::size_t from = 0; from < n; ++from) {
    // A job has to go on; of other places one may be the last.
    if (!leads_on[from] && why_not[from] != nullptr && ordered.visits.places[from].gives != 0)
      return {why_not[from]->status, fmt::format("no way leads on from {}: {}", from_label(mission, ordered, from), why_not[from]->reason)};
  }
  return {Status::no_path, "every place can be reached, but the ways that there are make no order of all of them"};
}

/// The way that the order given lacks, in words.
std::string missing_words(const Scenario& mission, const OrderedLegs& ordered, const VisitProblem& visits) {
  std::size_t at = visits.start();
  for (std::size_t to = 0; to < visits.places.size(); ++to) {
    if (visits.length(at, to) >= no_way)
      return fmt::format("the order given cannot be driven: no way was found from {} to {}", from_label(mission, ordered, at),
                         group_label(mission, ordered.groups[to]));
    at = to;
  }
  return "the order given cannot be driven";
}

std::string planners_words(const Scenario& mission) {
  std::set<std::string> names;
  for (const Leg& leg : mission.legs) names.insert(planner_of(mission, leg).name);
  std::string words;
  for (const std::string& name : names) words += (words.empty() ? "" : ", ") + name;
  return words;
}

void explain(const Scenario& mission, const OrderedLegs& ordered, const VisitProblem& visits, const std::vector<std::size_t>& order, ChosenOrder& chosen) {
  const VisitingOrder& o = chosen.order;
  const bool is_given = std::is_sorted(order.begin(), order.end());
  std::string first =
      is_given ? fmt::format("The legs are driven in the order given, {:.3f} m by the lengths of the ways between the places", o.length)
               : fmt::format("The legs are driven in the order {}, as numbered in the order given: {:.3f} m by the lengths of the ways between the places",
                             order_words(mission, ordered, order), o.length);
  if (!is_given) {
    first += o.given_length
                 ? fmt::format("; the order given is {:.3f} m, {:.1f} % longer", *o.given_length, o.length > 0.0 ? 100.0 * (*o.given_length / o.length - 1.0) : 0.0)
                 : "; " + missing_words(mission, ordered, visits);
  }
  chosen.sentences.push_back(first + ".");
  const std::size_t n = visits.places.size();
  const bool has_rules =
      std::any_of(visits.places.begin(), visits.places.end(), [](const VisitPlace& p) { return p.needs != 0 || p.gives != 0 || !p.after.empty(); });
  const std::string which = fmt::format("{}{}", has_rules ? "that takes each load before it is left, one at a time," : "",
                                        mission.order == LegOrder::best_to_last ? (has_rules ? " and ends with the last leg" : "that ends with the last leg") : "");
  const std::string space = which.empty() ? "" : " " + which;
  chosen.sentences.push_back(
      n <= most_exact_places
          ? fmt::format("No order{} is shorter: all of them were weighed by dynamic programming over the sets of {} place{}.", space, n, n == 1 ? "" : "s")
      : o.is_exact ? fmt::format("No order{} is shorter: found by exchanging and turning blocks of {} places, and as long as the lower bound.", space, n)
                   : fmt::format("No order{} is shorter than {:.3f} m, so this one is at most {:.2f} % longer than the shortest: found by exchanging and turning "
                                 "blocks of {} places, bounded by spanning arborescences.",
                                 space, o.lower_bound, 100.0 * o.gap(), n));
  chosen.sentences.push_back(fmt::format("{} between places {} planned for that by {}, each once{}.",
                                         o.ways == 1 ? std::string{"1 way"} : fmt::format("{} ways", o.ways), o.ways == 1 ? "was" : "were", planners_words(mission),
                                         o.ways_missing > 0 ? fmt::format("; on {} of them no proven path was found", o.ways_missing) : ""));
}

}  // namespace

Parsed<ChosenOrder> choose_order(const Scenario& mission, const std::atomic<bool>* cancel, unsigned threads) {
  auto ordered = ordered_legs(mission);
  if (!ordered) return tl::unexpected{ordered.error()};
  ChosenOrder chosen;
  chosen.mission = mission;
  chosen.order.given_as.resize(mission.legs.size());
  std::iota(chosen.order.given_as.begin(), chosen.order.given_as.end(), std::size_t{0});
  Ways ways{mission, *ordered, cancel};
  ways.plan(threads);
  for (const Way& way : ways.ways()) {
    chosen.effort.evaluations += way.effort.evaluations;
    chosen.effort.expansions += way.effort.expansions;
    chosen.reproducible = chosen.reproducible && way.reproducible;
    chosen.order.ways_missing += way.length >= no_way ? 1 : 0;
  }
  chosen.order.ways = static_cast<std::int64_t>(ways.ways().size());
  chosen.is_canceled = ways.is_canceled();
  if (chosen.is_canceled) return chosen;
  VisitProblem& visits = ordered->visits;
  ways.fill(visits);
  const std::size_t n = visits.places.size();
  const auto order = n <= most_exact_places ? shortest_visit_order(visits) : good_visit_order(visits, cancel);
  chosen.is_canceled = ways.is_canceled();
  if (chosen.is_canceled) return chosen;
  if (!order) {
    chosen.failure = failure_of(mission, *ordered, ways);
    return chosen;
  }
  const std::int64_t length = *visit_length(visits, *order);
  const std::int64_t bound = n <= most_exact_places ? length : visit_length_bound(visits, length, cancel);
  chosen.is_canceled = ways.is_canceled();
  if (chosen.is_canceled) return chosen;
  std::vector<std::size_t> given(n);
  std::iota(given.begin(), given.end(), std::size_t{0});
  const auto given_length = visit_length(visits, given);
  Reordered reordered = in_order(mission, *ordered, *order);
  chosen.is_found = true;
  chosen.mission = std::move(reordered.mission);
  chosen.order.given_as = std::move(reordered.given_as);
  chosen.order.length = metres(length);
  chosen.order.lower_bound = metres(bound);
  chosen.order.is_exact = bound >= length;
  if (given_length && *given_length < no_way) chosen.order.given_length = metres(*given_length);
  explain(mission, *ordered, visits, *order, chosen);
  return chosen;
}

}  // namespace waywright
