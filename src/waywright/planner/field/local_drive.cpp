#include "waywright/planner/field/local_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace waywright {
namespace {

constexpr double gets_on_by = 0.05;       // m along the way that count as getting on
constexpr double out_of_sight_for = 1.0;  // s, after which the way is planned anew
constexpr double looks_back = 1.0;        // m along the way, in which the nearest place is looked for
constexpr double blocks_within = 1.5;     // m: what stands as near as that may be what is in the way
constexpr double same_meeting = 0.3;      // s: a meeting that is later by more is another one
constexpr double held_after = 1.0;        // s after the meeting, until which it is held back
constexpr double thrown_over = 0.1;       // of the greatest speed on average: who is stuck and faster is thrown about

struct Option {
  LocalOrder::Kind kind;
  double back;  // s before the meeting
};
constexpr std::array<Option, 8> options_at_a_meeting{{{LocalOrder::Kind::hold, 2.0},
                                                      {LocalOrder::Kind::other_side, 4.0},
                                                      {LocalOrder::Kind::hold, 4.0},
                                                      {LocalOrder::Kind::hold, 7.0},
                                                      {LocalOrder::Kind::other_side, 8.0},
                                                      {LocalOrder::Kind::hold, 12.0},
                                                      {LocalOrder::Kind::other_side, 15.0},
                                                      {LocalOrder::Kind::hold, 25.0}}};

}  // namespace

std::vector<LocalOrder> LocalDriver::orders_of(const std::vector<Branch>& branches) const {
  std::vector<LocalOrder> orders;
  for (const Branch& branch : branches) {
    const Option& option = options_at_a_meeting[branch.option];
    orders.push_back({option.kind, branch.meeting.t - option.back, branch.meeting.t + held_after, branch.meeting.obstacle});
  }
  return orders;
}

LocalDrive LocalDriver::run(const FreeState& start, const std::vector<Vec2>& way, const Proves& proves, Budget& budget) const {
  LocalDrive all;
  all.ways.emplace_back(space_, way, field_options_.reach);
  all.last = start;
  std::vector<Branch> branches;
  FreeState at = start;
  Meeting first;
  std::size_t first_obstacle = LocalField::nobody;
  FreeState first_at{};
  while (true) {
    Meeting met = drive(all, at, orders_of(branches), budget);
    if (all.ended == LocalEnd::goal && budget.exhausted()) all.ended = budget.canceled() ? LocalEnd::canceled : LocalEnd::timed_out;
    if (all.ended == LocalEnd::goal) {
      const auto unproven = proves(all);
      if (!unproven) break;
      met = *unproven;
      all.ended = LocalEnd::met;
    }
    if (all.ended != LocalEnd::met) break;
    all.obstacle = met.obstacle;
    if (all.tries == 0) {
      first = met;
      first_obstacle = met.obstacle;
      first_at = all.last;
    }
    const auto give_up = [&] {
      all.ended = LocalEnd::met;
      all.last = first_at;
      all.last.t = first.t;
      all.obstacle = first_obstacle;
      return all;
    };
    if (all.tries >= options_.tries) return give_up();
    // Farther on than ever: a meeting of its own. Else the next that can be done about the last one.
    if (branches.empty() || met.t > branches.back().meeting.t + same_meeting) {
      branches.push_back({met, 0});
    } else {
      while (!branches.empty() && ++branches.back().option >= options_at_a_meeting.size()) branches.pop_back();
      if (branches.empty()) return give_up();
    }
    ++all.tries;
    const Branch& last = branches.back();
    const double back = last.meeting.t - options_at_a_meeting[last.option].back;
    while (!all.driven.empty() && all.driven.back().before.t > std::max(back, start.t)) all.driven.pop_back();
    // A turn on the spot that was begun before is not broken off.
    at = all.driven.empty() ? start : all.driven.back().step.after;
    const std::size_t ways = all.driven.empty() ? 1 : all.driven.back().way + 1;
    all.ways.resize(ways, all.ways.front());
    all.replans.resize(ways - 1);
  }
  for (const LocalOrder& order : orders_of(branches)) ++(order.kind == LocalOrder::Kind::hold ? all.holds : all.sides);
  return all;
}

bool LocalDriver::plan_anew(LocalDrive& all, const FreeState& at, std::size_t blocker) const {
  if (static_cast<int>(all.replans.size()) >= options_.replans) return false;
  std::vector<std::size_t> standing;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    if (i == blocker || movers_.stands(i, at.t, std::max(1.0, movers_.obstacle(i).patience))) standing.push_back(i);
  }
  auto way = plan_anew_(at, standing);
  if (!way || way->empty()) return false;
  all.replans.push_back({at.t, at.at, blocker});
  all.ways.emplace_back(space_, *way, field_options_.reach);
  return true;
}

std::optional<LocalDriver::Meeting> LocalDriver::taken(Vec2 goal) const {
  std::optional<Meeting> first;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const auto from = movers_.obstacle(i).stands_from();
    if (from && movers_.gap(i, goal, *from, 0.0) < 0.0 && (!first || *from < first->t)) first = Meeting{*from, i};
  }
  return first;
}

LocalDriver::Meeting LocalDriver::drive(LocalDrive& all, FreeState at, const std::vector<LocalOrder>& orders, Budget& budget) const {
  const auto ends = [&](LocalEnd why, std::size_t obstacle) {
    all.ended = why;
    all.last = at;
    all.obstacle = obstacle;
    return Meeting{at.t, obstacle};
  };
  double s = 0.0, best = 0.0, since = at.t;
  std::optional<double> lost_since;
  LocalField::Sides sides(movers_.size(), 0);
  if (!all.driven.empty()) {
    s = all.driven.back().s;
    best = all.driven.back().best;
    since = all.driven.back().since;
    sides = all.driven.back().sides;
  }
  bool tried_anew = false;  // at this place
  const auto is_taken = taken(all.ways.front().end());
  while (true) {
    const WayAhead* way = &all.ways.back();
    const Vec2 goal = way->end();
    if (at.at == goal && at.speed == 0.0) return ends(LocalEnd::goal, LocalField::nobody);
    if (is_taken && at.t + distance(at.at, goal) / motion_.top_speed() > is_taken->t) return ends(LocalEnd::taken, is_taken->obstacle);
    if (all.steps >= options_.steps || (budget.limits().evaluations && budget.evaluations() >= *budget.limits().evaluations)) return ends(LocalEnd::steps, LocalField::nobody);
    if ((all.steps & 15) == 0 && budget.exhausted()) return ends(budget.canceled() ? LocalEnd::canceled : LocalEnd::timed_out, LocalField::nobody);
    ++all.steps;
    budget.count_evaluations();
    s = way->nearest(at.at, s - looks_back, s + looks_back);
    const double top = top_(at);
    LocalDriven motion;
    motion.before = at;
    motion.way = all.ways.size() - 1;
    motion.s = s;
    motion.off = distance(at.at, way->at(s));
    const double left = distance(at.at, goal);
    const bool holds = std::any_of(orders.begin(), orders.end(), [&](const LocalOrder& o) { return o.kind == LocalOrder::Kind::hold && at.t >= o.from && at.t < o.until; });
    std::optional<FreeStep> last;
    if (!holds && left <= std::max(field_options_.look_ahead, motion_.braking(at.speed) + 0.3) && way->length() - s <= 2.0 * left + 0.1) last = field_.arrive(at, goal, top);
    if (last) {
      motion.step = *last;
    } else {
      const LocalField::Choice choice = field_.next(at, *way, s, top, orders, sides);
      if (choice.is_met) return ends(LocalEnd::met, choice.met);
      motion.step = choice.step;
      motion.pushed_by = choice.pushed_by;
      motion.kept_by = choice.kept_by;
      if (!choice.is_lost) lost_since.reset();
      else if (!lost_since) lost_since = at.t;
    }
    if (s > best + gets_on_by || holds || last) {
      best = std::max(s, best);
      since = at.t;
      tried_anew = false;
    }
    motion.best = best;
    motion.since = since;
    motion.sides = sides;
    all.driven.push_back(motion);
    at = motion.step.after;
    // Who gets no farther: because of what stands in the way, out of sight of it, or thrown about.
    const bool is_out_of_sight = lost_since && motion.before.t - *lost_since > out_of_sight_for;
    std::size_t blocker = motion.kept_by != LocalField::nobody ? motion.kept_by : motion.pushed_by;
    if (blocker != LocalField::nobody && movers_.gap(blocker, at.at, at.t, blocks_within) > blocks_within) blocker = LocalField::nobody;
    const double patience = blocker != LocalField::nobody ? movers_.obstacle(blocker).patience : options_.patience;
    const double idle = at.t - since;
    if (is_out_of_sight || idle > patience) {
      const bool stands = blocker != LocalField::nobody && movers_.stands(blocker, at.t, std::max(1.0, patience));
      const bool waits = blocker != LocalField::nobody && !stands && !is_out_of_sight;  // it moves on
      if (!waits && !tried_anew) {
        tried_anew = true;
        if (plan_anew(all, at, stands ? blocker : LocalField::nobody)) {
          s = best = 0.0;
          since = at.t;
          lost_since.reset();
          continue;
        }
      }
      const bool goes_on_later = blocker != LocalField::nobody && !movers_.stands(blocker, at.t, options_.longest_wait);
      if (idle > options_.longest_wait || (!waits && !goes_on_later && idle > 2.0 * std::max(patience, options_.patience))) {
        double way_driven = 0.0;
        for (std::size_t i = all.driven.size(); i-- > 0 && all.driven[i].before.t >= since;) way_driven += all.driven[i].step.length;
        return ends(way_driven > thrown_over * idle * motion_.top_speed() ? LocalEnd::thrown_about : LocalEnd::stuck, blocker);
      }
    }
  }
}

}  // namespace waywright
