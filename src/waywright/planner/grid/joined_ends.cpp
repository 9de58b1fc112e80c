#include "waywright/planner/grid/joined_ends.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace waywright {
namespace {

constexpr double same_place = 1e-9;  // m, and rad
constexpr double rounding = 1e-9;    // of lengths, turns and costs

/// A straight drive, and the turn before it.
struct Leg {
  double turn = 0.0;  ///< rad, signed; may be the longer way round
  Vec2 from{}, to{};
  int direction = 1;

  double facing() const { return wrap(angle_of(to - from) + (direction > 0 ? 0.0 : pi)); }
};

struct Way {
  std::vector<Leg> legs;
  double last_turn = 0.0;  ///< rad, at the goal
};

bool is_off_middles(const GridFrame& frame, Vec2 at) {
  const Cell c = frame.cell_at(at);
  return !frame.contains(c) || distance(frame.centre(c), at) > same_place;
}

class Joiner {
 public:
  Joiner(const Problem& problem, const EndsToJoin& ends, MotionCheck& test)
      : start_{problem.start()}, zones_{problem.zones_as_planned()}, ends_{ends}, margin_{connecting_margin(problem)}, test_{test} {
    if (problem.free_goal() == nullptr) last_heading_ = problem.goal().heading;
  }

  /// As Path is built of them: turns that are told are kept, whatever is left to turn goes the shorter way.
  Way way_of(const std::vector<Action>& actions) const {
    Way way;
    Pose at = start_;
    double told = 0.0;
    const auto turn_to = [&](double heading) {
      const double angle = told + wrap(heading - (at.heading + told));
      told = 0.0;
      at.heading = heading;
      return angle;
    };
    for (const Action& a : actions) {
      if (a.kind == Action::Kind::turn) {
        told += a.angle;
      } else if (distance(at.position(), a.to) > same_place) {
        Leg leg{0.0, at.position(), a.to, a.direction};
        leg.turn = turn_to(leg.facing());
        way.legs.push_back(leg);
        at = make_pose(a.to, at.heading);
      }
    }
    way.last_turn = last_heading_ ? turn_to(*last_heading_) : told;
    return way;
  }

  static std::vector<Action> actions_of(const Way& way) {
    std::vector<Action> actions;
    for (const Leg& leg : way.legs) {
      actions.push_back({Action::Kind::turn, leg.turn, {}, 1});
      actions.push_back({Action::Kind::drive, 0.0, leg.to, leg.direction});
    }
    actions.push_back({Action::Kind::turn, way.last_turn, {}, 1});
    return actions;
  }

  void join_start(Way& way) const {
    Way joined = way;
    for (int left_out = 1; left_out <= ends_.most_corners && left_out < static_cast<int>(way.legs.size()); ++left_out) {
      const auto next = with_one(way, 0, static_cast<std::size_t>(left_out));
      if (!next) break;
      joined = *next;
    }
    way = std::move(joined);
  }
  void join_goal(Way& way) const {
    Way joined = way;
    for (int left_out = 1; left_out <= ends_.most_corners && left_out < static_cast<int>(way.legs.size()); ++left_out) {
      const std::size_t last = way.legs.size() - 1;
      const auto next = with_one(way, last - static_cast<std::size_t>(left_out), last);
      if (!next) break;
      joined = *next;
    }
    way = std::move(joined);
  }

 private:
  /// With one drive in place of those from `first` to `last`, where that is allowed, free, and no worse.
  std::optional<Way> with_one(const Way& way, std::size_t first, std::size_t last) const {
    Leg one{0.0, way.legs[first].from, way.legs[last].to, way.legs[first].direction};
    if (distance(one.from, one.to) <= same_place || !zones_.may_be_driven(one.from, one.to)) return std::nullopt;
    for (std::size_t i = first; i <= last; ++i) {
      if (way.legs[i].direction != one.direction) return std::nullopt;
    }
    const double before = first == 0 ? start_.heading : way.legs[first - 1].facing();
    one.turn = shorter_turn(before, one.facing());
    Way joined;
    joined.legs.assign(way.legs.begin(), way.legs.begin() + static_cast<std::ptrdiff_t>(first));
    joined.legs.push_back(one);
    joined.legs.insert(joined.legs.end(), way.legs.begin() + static_cast<std::ptrdiff_t>(last) + 1, way.legs.end());
    joined.last_turn = last + 1 < way.legs.size() ? way.last_turn : 0.0;
    double after = 0.0;  // of the turn behind it
    if (last + 1 < way.legs.size()) after = joined.legs[first + 1].turn = shorter_turn(one.facing(), way.legs[last + 1].facing());
    else if (last_heading_) after = joined.last_turn = shorter_turn(one.facing(), *last_heading_);
    if (turning(joined) > turning(way) + rounding || cost(joined) > cost(way) + rounding) return std::nullopt;
    const bool is_free = test_.is_drive_free(one.from, one.to, one.facing(), margin_) && test_.is_turn_free(one.from, before, one.turn, margin_) &&
                         test_.is_turn_free(one.to, one.facing(), after, margin_);
    return is_free ? std::optional{joined} : std::nullopt;
  }

  static double turning(const Way& way) {
    double sum = std::abs(way.last_turn);
    for (const Leg& leg : way.legs) sum += std::abs(leg.turn);
    return sum;
  }
  double cost(const Way& way) const {
    double sum = ends_.turn_cost * turning(way);
    for (const Leg& leg : way.legs) sum += (leg.direction > 0 ? 1.0 : ends_.reverse_cost) * (zones_.weighs() ? zones_.cost(leg.from, leg.to) : distance(leg.from, leg.to));
    return sum;
  }

  const Pose& start_;
  const ZoneRules& zones_;
  const EndsToJoin& ends_;
  double margin_;
  MotionCheck& test_;
  std::optional<double> last_heading_;
};

}  // namespace

std::vector<Action> with_joined_ends(const Problem& problem, const GridFrame& frame, const std::vector<Action>& actions, const EndsToJoin& ends, MotionCheck& test) {
  const Joiner joiner{problem, ends, test};
  Way way = joiner.way_of(actions);
  if (way.legs.size() < 2) return actions;
  // A drive straight on from a pose, or straight into one, is no stub: out of an aisle it may be all that goes.
  const bool at_start = ends.start && is_off_middles(frame, problem.start().position()) && std::abs(way.legs.front().turn) > same_place;
  const bool at_goal = ends.goal && is_off_middles(frame, way.legs.back().to) && (problem.free_goal() != nullptr || std::abs(way.last_turn) > same_place);
  if (!at_start && !at_goal) return actions;
  if (at_goal) joiner.join_goal(way);
  if (at_start) joiner.join_start(way);
  return Joiner::actions_of(way);
}

}  // namespace waywright
