#include "waywright/planner/field/local_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double sight_step = 0.1;      // m along the way, by which a place that attracts comes nearer until it is seen
constexpr double braking_share = 0.7;   // of the deceleration, with which it comes to the goal
constexpr double stops_before = 0.15;   // m, of the goal: one whose curvature cannot jump, to turn to it
constexpr double least_reach = 0.03;    // m: ways with less room than that are kept to without repulsion
constexpr double look_step = 0.2;       // s
constexpr double rounding = 5e-3;       // m, that a way planned around what stands may come nearer than it should
constexpr int directions = 16;
constexpr double comfortable = 0.25;    // m beside what moves
constexpr double middle_within = 0.05;  // m: met in the middle
constexpr double turned_aside = 0.6;    // of what pushes back
constexpr double for_contact = 8.0, for_nearness = 0.5;  // weights, of contact at once against driving another way altogether

double bow(const FreeStep& step) {
  const double curved = std::max(std::abs(step.curvature), std::abs(step.curvature + step.curvature_rate * step.length));
  return 0.125 * curved * step.length * step.length;
}

}  // namespace

std::vector<LocalField::Nearby> LocalField::about(const FreeState& from) const {
  std::vector<Nearby> all;
  const double own = motion_.top_speed() * options_.horizon + options_.moving_reach;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const MovingObstacle& obstacle = movers_.obstacle(i);
    // As fast as it is at any time of the horizon.
    double theirs = 0.0;
    Vec2 before = obstacle.at(from.t).position();
    const Vec2 now = before;
    for (double ahead = look_step; ahead <= options_.horizon + look_step; ahead += look_step) {
      before = obstacle.at(from.t + ahead).position();
      theirs = std::max(theirs, distance(now, before));
    }
    if (movers_.gap(i, from.at, from.t, own + theirs) <= own + theirs) all.push_back({i, comfortable, false});
  }
  return all;
}

bool LocalField::is_step_free(const FreeState& from, const FreeStep& step) const {
  if (step.kind != FreeStep::Kind::drive) return true;
  return space_.is_free(from.at, step.after.at, space_.needed() + bow(step));
}

std::size_t LocalField::met_on(const FreeState& from, const FreeStep& step, const std::vector<Nearby>& about) const {
  const double time = step.after.t - from.t;
  const int looks = std::max(2, static_cast<int>(std::ceil(time / 0.05)));
  for (const auto& [i, comfort, is_passed] : about) {
    for (int k = 1; k <= looks; ++k) {
      const double share = static_cast<double>(k) / looks;
      const Vec2 at = from.at + share * (step.after.at - from.at);
      if (movers_.gap(i, at, from.t + share * time, comfortable) < 0.0) return i;
    }
  }
  return nobody;
}

/// On which side of an obstacle to pass, seen along `axis`: where there is room; else on the side where it is already; from the middle to the right.
signed char LocalField::side_of(std::size_t i, Vec2 disc, double t, Vec2 axis, Vec2 along) const {
  const MovingObstacle& obstacle = movers_.obstacle(i);
  const Vec2 there = obstacle.at(t).position(), left = left_of(axis);
  const double aside = obstacle.footprint.radius() + space_.needed() + obstacle.off_by(t) + 0.5 * comfortable;
  const bool is_left_free = space_.is_free(there + aside * left), is_right_free = space_.is_free(there - aside * left);
  if (is_left_free != is_right_free) return is_left_free ? 1 : -1;
  const double lateral = dot(disc - there, left);
  if (std::abs(lateral) > middle_within) return lateral > 0.0 ? 1 : -1;
  return dot(left_of(along), left) > 0.0 ? -1 : 1;
}

std::optional<double> LocalField::room_beside(std::size_t i, double t, const WayAhead& way, double s, double target, double most) const {
  if (!movers_.stands(i, t, options_.horizon)) return std::nullopt;
  double room = most;
  for (double at = s; room >= -rounding; at = std::min(at + sight_step, target)) {
    room = std::min(room, movers_.gap(i, way.at(at), t, most));
    if (at >= target) break;
  }
  return room < -rounding ? std::nullopt : std::optional<double>{std::max(room, 0.0)};
}

bool LocalField::is_seen(const FreeState& from, Vec2 to, const std::vector<Nearby>& about) const {
  const int looks = std::max(1, static_cast<int>(std::ceil(distance(from.at, to) / (0.5 * sight_step))));
  for (const Nearby& near : about) {
    for (int k = 1; near.is_passed && k <= looks; ++k) {
      if (movers_.gap(near.obstacle, from.at + (static_cast<double>(k) / looks) * (to - from.at), from.t, comfortable) < -rounding) return false;
    }
  }
  return true;
}

std::size_t LocalField::hit_on(const FreeState& from, const FreeStep& step, const std::vector<Nearby>& about) const {
  if (step.kind != FreeStep::Kind::drive) return nobody;
  for (const Nearby& near : about) {
    if (!near.is_passed) continue;
    for (const double share : {0.5, 1.0}) {
      if (movers_.gap(near.obstacle, from.at + share * (step.after.at - from.at), from.t + share * (step.after.t - from.t), comfortable) < 0.0) return near.obstacle;
    }
  }
  return nobody;
}

Vec2 LocalField::push(std::size_t i, const FreeState& from, double reach, Vec2 along, const std::vector<LocalOrder>& orders, signed char& side) const {
  if (reach < least_reach) {
    side = 0;
    return {};
  }
  const double most = 2.0 * motion_.top_speed(), fast = norm(along);
  const auto strength = [&](double gap) {
    const double rho = std::max(gap, 0.05);
    return rho < reach ? std::min(most, options_.moving_repulsion * (1.0 / rho - 1.0 / reach) / (rho * rho)) : 0.0;
  };
  const Movers::Near now = movers_.at(i, from.at, from.t, reach);
  // Where they would be nearest, were the wanted velocity kept.
  double least = reach, when = -1.0;
  for (double ahead = look_step; fast > 0.0 && ahead <= options_.horizon; ahead += look_step) {
    const double gap = movers_.gap(i, from.at + ahead * along, from.t + ahead, reach);
    if (gap < least) {
      least = gap;
      when = ahead;
    }
    if (gap < -0.2) break;
  }
  if (when < 0.0 && !(now.gap < reach)) {
    side = 0;
    return {};
  }
  // As it is now: radially off.
  Vec2 all{};
  if (now.gap < reach) {
    const Vec2 off = from.at - now.point;
    const double n = norm(off);
    all = strength(now.gap) * (n > 1e-9 ? (1.0 / n) * off : left_of(unit(from.course)));
  }
  if (!(fast > 0.0)) return all;
  const double t = from.t + std::max(when, 0.0);
  const Vec2 meeting = from.at + std::max(when, 0.0) * along, relative = along - movers_.velocity(i, t);
  const Vec2 ahead = (1.0 / fast) * along, axis = norm(relative) > 0.05 ? (1.0 / norm(relative)) * relative : ahead;
  if (side == 0 && when >= 0.0) side = side_of(i, meeting, t, axis, along);
  double sign = side;
  for (const LocalOrder& order : orders) {
    if (order.kind == LocalOrder::Kind::other_side && order.obstacle == i && from.t >= order.from && from.t <= order.until) sign = -sign;
  }
  // What pushes back is turned to that side, as far as it is in the way: who would only be pushed back gets past.
  const double back = -dot(all, ahead);
  const Vec2 aside = sign * left_of(axis);
  if (back > 0.0 && sign != 0.0) all = all + (turned_aside * back) * (ahead + aside);
  // As it will be: to that side, the more the sooner.
  if (when >= 0.0) all = all + ((1.0 - when / (options_.horizon + look_step)) * strength(least)) * aside;
  return all;
}

LocalField::Wanted LocalField::wanted(const FreeState& from, const WayAhead& way, double s, double top, const std::vector<LocalOrder>& orders, const std::vector<Nearby>& about, Sides& sides) const {
  Wanted all;
  const bool holds = std::any_of(orders.begin(), orders.end(), [&](const LocalOrder& o) { return o.kind == LocalOrder::Kind::hold && from.t >= o.from && from.t < o.until; });
  double target = std::min(way.length(), s + options_.look_ahead);
  while (target > s && !space_.is_free(from.at, way.at(target))) target -= sight_step;
  target = std::max(target, s);
  while (target > s + sight_step && !is_seen(from, way.at(target), about)) target -= sight_step;
  all.is_lost = !space_.is_free(from.at, way.at(target));
  const Vec2 to = way.at(target) - from.at;
  const double left = std::max(0.0, distance(from.at, way.end()) - (motion_.is_smooth() ? stops_before : 0.0));
  const double speed = std::min(top, std::sqrt(2.0 * braking_share * motion_.deceleration() * left));
  const double away = norm(to);
  const Vec2 along = away > 1e-9 ? (std::min(speed, 2.0 * away + 0.05) / away) * to : Vec2{};
  if (!holds) all.velocity = along;
  // What stands pushes off from where it is nearer than it is to the way.
  const double reach = std::min(options_.reach, way.room(s, target));
  if (const double most = holds ? options_.reach : reach; most > least_reach && options_.repulsion > 0.0) {
    PotentialOptions still;
    still.attraction = 0.0;
    still.repulsion = options_.repulsion;
    still.reach = most;
    if (const auto value = PotentialField{space_, still, from.at}.at(from.at)) {
      const double steep = norm(value->gradient), strong = std::min(steep, motion_.top_speed());
      if (steep > 0.0) all.velocity = all.velocity - (strong / steep) * value->gradient;
    }
  }
  double greatest = 0.0;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    // What stands beside the way pushes as it is now: were what is asked for kept, the vehicle would often run on into it beyond a bend or the goal.
    const auto room = room_beside(i, from.t, way, s, target, options_.moving_reach);
    const Vec2 off = push(i, from, room.value_or(options_.moving_reach), holds || room ? Vec2{} : along, orders, sides[i]);
    all.velocity = all.velocity + off;
    if (norm(off) > greatest) {
      greatest = norm(off);
      all.pushed_by = i;
    }
  }
  if (greatest < 0.05 * motion_.top_speed()) all.pushed_by = nobody;
  if (const double fast = norm(all.velocity); fast > top) all.velocity = (top / fast) * all.velocity;
  return all;
}

LocalField::Outlook LocalField::outlook(const FreeState& from, Vec2 velocity, double top, const std::vector<Nearby>& about) const {
  Outlook out{options_.horizon, comfortable, nobody, true};
  FreeState at = from;
  bool is_blocked = false;
  const double must_be_free = from.speed / motion_.deceleration() + 2.0 * options_.period;
  while (at.t - from.t < options_.horizon - 1e-9) {
    FreeStep step;
    if (!is_blocked) {
      step = motion_.towards(at, velocity, top, at.t == from.t ? options_.period : look_step, false);
      const std::size_t hit = hit_on(at, step, about);
      if (hit != nobody) out.obstacle = hit;
      if (hit != nobody || !is_step_free(at, step)) {
        if (step.after.t - from.t <= must_be_free + motion_.towards(at, {}, top, look_step, false).after.t - at.t) {
          out.is_free = false;
          return out;
        }
        is_blocked = true;  // by then it has stopped
      }
    }
    FreeState next = step.after;
    if (is_blocked) {
      next = at;
      next.speed = 0.0;
      next.t = at.t + look_step;
    }
    for (const auto& [i, comfort, is_passed] : about) {
      for (const double share : {0.5, 1.0}) {
        const double gap = movers_.gap(i, at.at + share * (next.at - at.at), at.t + share * (next.t - at.t), comfortable);
        if (comfort > least_reach) out.least = std::min(out.least, gap * (comfortable / comfort));
        if (gap < 0.0 && !is_passed) {
          out.clear = at.t - from.t;
          out.obstacle = i;
          return out;
        }
      }
    }
    at = next;
  }
  return out;
}

LocalField::Choice LocalField::next(const FreeState& from, const WayAhead& way, double s, double top, const std::vector<LocalOrder>& orders, Sides& sides) const {
  std::vector<Nearby> near = about(from);
  for (Nearby& n : near) {
    const auto room = room_beside(n.obstacle, from.t, way, s, std::min(way.length(), s + options_.look_ahead), comfortable);
    n.is_passed = room.has_value();
    n.comfortable = room.value_or(comfortable);
  }
  const Wanted asked = wanted(from, way, s, top, orders, near, sides);
  Choice choice;
  choice.pushed_by = asked.pushed_by;
  choice.is_lost = asked.is_lost;
  Vec2 velocity = asked.velocity;
  const Outlook first = outlook(from, velocity, top, near);
  if (!first.is_free || first.clear < options_.horizon || first.least < 0.5 * comfortable) {
    choice.kept_by = first.obstacle;
    // Of all velocities the one that costs least: how far it is from what is asked for, how soon it is not clear, how near it comes.
    const auto cost = [&](Vec2 v, const Outlook& out) {
      double sum = norm(v - asked.velocity) / motion_.top_speed() + for_nearness * (comfortable - std::max(out.least, 0.0)) / comfortable;
      if (out.clear < options_.horizon) sum += for_contact * (options_.horizon - out.clear) / options_.horizon;
      return out.is_free ? sum : sum + 100.0;
    };
    double least = cost(velocity, first);
    const auto consider = [&](Vec2 v) {
      const double c = cost(v, outlook(from, v, top, near));
      if (c < least - 1e-9) {
        least = c;
        velocity = v;
      }
    };
    consider({});
    consider(0.5 * asked.velocity);
    const double base = norm(asked.velocity) > 0.0 ? angle_of(asked.velocity) : from.course;
    for (int k = 0; k < directions; ++k) {
      const Vec2 direction = unit(wrap(base + k * (two_pi / directions)));
      consider(top * direction);
      consider(0.5 * top * direction);
    }
  }
  choice.step = motion_.towards(from, velocity, top, options_.period, true);
  if (!is_step_free(from, choice.step) || hit_on(from, choice.step, near) != nobody) {
    // Straight on, as short as it can.
    choice.step = motion_.towards(from, {}, top, options_.period, true);
    if (!is_step_free(from, choice.step)) choice.is_met = true;
  }
  choice.met = met_on(from, choice.step, near);
  if (choice.met != nobody) choice.is_met = true;
  return choice;
}

std::optional<FreeStep> LocalField::arrive(const FreeState& from, Vec2 goal, double top) const {
  const FreeStep step = motion_.onto(from, goal, top, options_.period);
  if (step.kind == FreeStep::Kind::stand || !is_step_free(from, step)) return std::nullopt;
  if (!space_.is_free(from.at, goal, space_.needed() + 0.125 * std::abs(step.curvature) * squared_norm(goal - from.at))) return std::nullopt;
  // Clear all the way there.
  const std::vector<Nearby> near = about(from);
  FreeState at = from;
  for (int k = 0; k < 1000 && at.at != goal; ++k) {
    const FreeStep then = k == 0 ? step : motion_.onto(at, goal, top, options_.period);
    if (then.kind == FreeStep::Kind::stand || met_on(at, then, near) != nobody) return std::nullopt;
    at = then.after;
  }
  return at.at == goal ? std::optional<FreeStep>{step} : std::nullopt;
}

}  // namespace waywright
