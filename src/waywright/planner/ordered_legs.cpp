#include "waywright/planner/ordered_legs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace waywright {
namespace {

const Station* station_of(const Leg& leg) { return std::get_if<Station>(&leg.mission); }
bool is_way_out(const Leg& leg) { return station_of(leg) != nullptr && station_of(leg)->manoeuvre == Manoeuvre::undock; }

InputError at_goal(std::size_t leg, const char* problem, const char* allowed) { return InputError{"", fmt::format("legs[{}].goal", leg), problem, allowed}; }

/// Does a way begin with any heading where the vehicle is round, and stays so?
bool is_always_round(const Scenario& mission) {
  return mission.vehicle.footprint.polygon.empty() && mission.carried_load.empty() &&
         std::none_of(mission.legs.begin(), mission.legs.end(), [](const Leg& leg) { return leg.load.has_value(); });
}

Parsed<void> check_goals(const Scenario& mission) {
  const std::size_t asked = mission.legs.size() - (mission.order == LegOrder::best_to_last ? 1 : 0);
  for (std::size_t i = 0; i < asked; ++i) {
    const auto* free = std::get_if<FreeGoal>(&mission.legs[i].mission);
    if (free == nullptr) continue;
    if (!free->is_point())
      return tl::unexpected{at_goal(i, "it leaves the place free, and the lengths of the ways from there depend on where that is",
                                    "a pose [x, y, heading] where the order of the legs is asked for")};
    if (!is_always_round(mission)) {
      return tl::unexpected{at_goal(i, "it leaves the heading free, and the ways from there depend on it",
                                    "a pose [x, y, heading] where the order of the legs is asked for; [x, y] of round vehicles without loads")};
    }
  }
  return {};
}

/// The groups and what is before them.
void find_groups(const Scenario& mission, OrderedLegs& ordered) {
  std::size_t i = 0;
  while (i < mission.legs.size() && is_way_out(mission.legs[i])) ++i;
  ordered.fixed = i;
  for (; i < mission.legs.size(); ++i) {
    if (is_way_out(mission.legs[i]))
      ++ordered.groups.back().count;
    else
      ordered.groups.push_back({i, 1});
  }
}

/// Follows the mission in the order given: jobs, and what has to come before what.
class Precedence {
 public:
  Precedence(const Scenario& mission, OrderedLegs& ordered) : mission_{mission}, ordered_{ordered}, group_of_(mission.legs.size(), none_) {
    if (!mission.carried_load.empty()) state_ = ++jobs_;
    for (std::size_t g = 0; g < ordered.groups.size(); ++g) {
      for (std::size_t i = 0; i < ordered.groups[g].count; ++i) group_of_[ordered.groups[g].first + i] = g;
    }
    ordered_.visits.places.assign(ordered.groups.size(), {});
    ordered_.visits.start_state = state_;
  }

  /// @pre the legs before were followed; `end` is what follows the leg
  void follow(const LegBegin& begin, const LegBegin& end) {
    const std::size_t leg = begin.index, group = group_of_[leg];
    for (const LeftLoad& load : begin.left) {
      if (is_taken_again(mission_, leg, load)) come_after(leg, load.leg);
    }
    const bool is_first = group != none_ && leg == ordered_.groups[group].first;
    if (is_first) ordered_.visits.places[group].needs = state_;
    if (is_first && state_ != 0) {
      // Job by job, so that no way is begun that cannot go on: first who takes the load, then who is driven to with it.
      for (const std::size_t before : with_load_) {
        if (mission_.legs[leg].load) add(group, before);
      }
      if (const auto taker = taker_.find(state_); taker != taker_.end()) add(group, taker->second);
      with_load_.push_back(group);
    }
    if (mission_.legs[leg].load) change(begin, end);
    if (group != none_) ordered_.visits.places[group].gives = state_;
    if (leg + 1 == ordered_.fixed) ordered_.visits.start_state = state_;
  }

 private:
  void change(const LegBegin& begin, const LegBegin& end) {
    const std::size_t leg = begin.index;
    const std::string& taken = *mission_.legs[leg].load;
    if (!taken.empty()) {
      state_ = ++jobs_;
      taken_.push_back({taken, leg, end.pose, true});
      with_load_.clear();
      if (group_of_[leg] != none_) taker_[state_] = group_of_[leg];
      return;
    }
    if (state_ == 0) return;
    const LeftLoad set_down{begin.load, leg, end.pose, true};
    for (const LeftLoad& other : taken_) {
      if (is_touching(mission_, other, set_down)) come_after(leg, other.leg);
    }
    state_ = 0;
    with_load_.clear();
  }
  void come_after(std::size_t leg, std::size_t earlier) {
    const std::size_t group = group_of_[leg], before = group_of_[earlier];
    if (group != none_ && before != none_ && group != before) add(group, before);
  }
  void add(std::size_t group, std::size_t before) {
    auto& after = ordered_.visits.places[group].after;
    if (group != before && std::find(after.begin(), after.end(), before) == after.end()) after.push_back(before);
  }

  static constexpr std::size_t none_ = static_cast<std::size_t>(-1);
  const Scenario& mission_;
  OrderedLegs& ordered_;
  int state_ = 0, jobs_ = 0;
  std::vector<std::size_t> group_of_;
  std::vector<LeftLoad> taken_;         ///< what was taken, and where
  std::vector<std::size_t> with_load_;  ///< groups driven to with what is carried now
  std::map<int, std::size_t> taker_;
};

}  // namespace

Parsed<OrderedLegs> ordered_legs(const Scenario& mission) {
  if (auto checked = check_goals(mission); !checked) return tl::unexpected{checked.error()};
  OrderedLegs ordered;
  find_groups(mission, ordered);
  if (ordered.groups.size() > most_ordered) {
    return tl::unexpected{
        InputError{"", "legs", fmt::format("the order of {} places is asked for", ordered.groups.size()), fmt::format("at most {} with \"order\"", most_ordered)}};
  }
  ordered.visits.keeps_last = mission.order == LegOrder::best_to_last;
  Scenario without_map = mission;
  without_map.map = {};
  for (Leg& leg : without_map.legs) leg.waypoints.clear();  // they do not matter to where a leg ends
  const World empty;
  const auto follow = [&](const LegBegin& begin) -> Parsed<LegBegin> {
    const auto problem = prepare_leg(without_map, begin, empty);
    if (!problem) return tl::unexpected{problem.error()};
    return next_leg(without_map, begin, problem->last_pose());
  };
  Precedence precedence{without_map, ordered};
  std::vector<LegBegin> begins;
  ordered.start = first_leg(without_map);
  for (LegBegin begin = first_leg(without_map); begin.index < mission.legs.size();) {
    auto next = follow(begin);
    if (!next) return tl::unexpected{next.error()};
    precedence.follow(begin, *next);
    begins.push_back(begin);
    begin = std::move(*next);
    if (begin.index == ordered.fixed) ordered.start = begin;
  }
  const std::size_t n = ordered.groups.size();
  ordered.visits.lengths.assign((n + 1) * n, no_way);
  ordered.after.resize(n);
  for (std::size_t g = 0; g < n; ++g) {
    LegBegin begin = begins[ordered.groups[g].first];
    begin.left.clear();
    for (std::size_t i = 0; i < ordered.groups[g].count; ++i) {
      auto next = follow(begin);
      if (!next) return tl::unexpected{next.error()};
      begin = std::move(*next);
      ordered.after[g].push_back(begin);
    }
  }
  return ordered;
}

Reordered in_order(const Scenario& mission, const OrderedLegs& ordered, const std::vector<std::size_t>& order) {
  Reordered reordered{mission, {}};
  for (std::size_t i = 0; i < ordered.fixed; ++i) reordered.given_as.push_back(i);
  for (const std::size_t group : order) {
    for (std::size_t i = 0; i < ordered.groups[group].count; ++i) reordered.given_as.push_back(ordered.groups[group].first + i);
  }
  for (std::size_t i = 0; i < reordered.given_as.size(); ++i) reordered.mission.legs[i] = mission.legs[reordered.given_as[i]];
  return reordered;
}

std::string group_label(const Scenario& mission, const LegGroup& group) {
  const std::string& name = mission.legs[group.first].name;
  const std::string numbers = group.count == 1 ? fmt::format("leg {}", group.first + 1)
                                               : fmt::format("legs {} {} {}", group.first + 1, group.count == 2 ? "and" : "to", group.first + group.count);
  return name.empty() ? numbers : fmt::format("{} ({})", numbers, name);
}

}  // namespace waywright
