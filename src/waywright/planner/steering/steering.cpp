#include "waywright/planner/steering/steering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "waywright/planner/grid/free_goal.hpp"
#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/steering/dubins.hpp"
#include "waywright/planner/steering/pose_order.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"

namespace waywright {
namespace {

constexpr double no_way = 1e-9;       // m
constexpr double no_turn = 1e-9;      // rad
constexpr double same_cost = 1e-12;   // rad: of two ways to turn

class PlaneSteering final : public Steering {
 public:
  explicit PlaneSteering(double disc) : disc_{disc} {}
  SteeringKind kind() const override { return SteeringKind::plane; }
  double distance(const Pose& from, const Pose& to) const override { return waywright::distance(from.position(), to.position()); }
  Pieces between(const Pose& from, const Pose& to) const override {
    Pieces pieces;
    if (from.position() != to.position()) pieces.push_back({Line{from.position(), to.position()}, 1});
    return pieces;
  }
  Pose at(const Pose& from, const Pose& to, double t) const override {
    if (t >= 1.0) return to;
    return make_pose(from.position() + t * (to.position() - from.position()), 0.0);
  }
  std::string words() const override { return fmt::format("straight lines of a disc of {:.3f} m", disc_); }
  std::string_view piece_word() const override { return "straight line"; }

 private:
  double disc_;
};

/// The vehicle faces the way it drives or the other way, whichever turns less; of two that turn the same that which points to +x, so that the
/// motion back is the same one.
class TurnSteering final : public Steering {
 public:
  explicit TurnSteering(double turn_cost) : turn_cost_{turn_cost} {}
  SteeringKind kind() const override { return SteeringKind::turns; }
  double distance(const Pose& from, const Pose& to) const override {
    const Motion m = motion(from, to);
    return m.way + turn_cost_ * (std::abs(m.first) + std::abs(m.last));
  }
  double least(const Pose& from, const Pose& to) const override {
    return waywright::distance(from.position(), to.position()) + turn_cost_ * std::abs(shorter_turn(from.heading, to.heading));
  }
  double bound(const Facing& from, const Facing& to) const override { return least(from.pose, to.pose); }
  Pieces between(const Pose& from, const Pose& to) const override {
    const Motion m = motion(from, to);
    Pieces pieces;
    if (m.first != 0.0) pieces.push_back({Turn{from.position(), from.heading, m.first}, 0});
    if (m.way > 0.0) pieces.push_back({Line{from.position(), to.position()}, m.direction});
    if (m.last != 0.0) pieces.push_back({Turn{to.position(), m.heading, m.last}, 0});
    return pieces;
  }
  double cost(const Piece& piece) const override {
    const auto* turn = std::get_if<Turn>(&piece.curve);
    return turn != nullptr ? turn_cost_ * std::abs(turn->angle) : length(piece);
  }
  Pose at(const Pose& from, const Pose& to, double t) const override {
    if (t <= 0.0) return from;
    if (t >= 1.0) return to;
    const Motion m = motion(from, to);
    const double first = turn_cost_ * std::abs(m.first), last = turn_cost_ * std::abs(m.last);
    double done = t * (first + m.way + last);
    if (done < first) return make_pose(from.position(), wrap(from.heading + m.first * (done / first)));
    done -= first;
    if (done < m.way) return make_pose(from.position() + (done / m.way) * (to.position() - from.position()), m.heading);
    done -= m.way;
    return last > 0.0 ? make_pose(to.position(), wrap(m.heading + m.last * std::min(1.0, done / last))) : to;
  }
  std::string words() const override { return "straight drives between turns on the spot"; }
  std::string_view piece_word() const override { return "driving and turning"; }

 private:
  struct Motion {
    double first = 0.0;    ///< rad
    double heading = 0.0;  ///< of the vehicle while it drives
    double way = 0.0;      ///< m
    int direction = 1;
    double last = 0.0;     ///< rad
  };

  static bool points_to_x(double heading) { return heading > -0.5 * pi && heading <= 0.5 * pi; }
  /// Half a turn goes to the left from headings that point to +x, back to the right: the motion back is the same one.
  static double turn_between(double from, double to) {
    const double turn = shorter_turn(from, to);
    if (std::abs(turn) < no_turn) return 0.0;
    if (std::abs(turn) < pi - same_cost) return turn;
    return points_to_x(from) ? std::abs(turn) : -std::abs(turn);
  }

  /// That of both orders of the ends which comes first, driven back in the other: the same one to the last bit.
  Motion motion(const Pose& from, const Pose& to) const {
    if (comes_first(from, to)) return motion_forth(from, to);
    Motion m = motion_forth(to, from);
    if (m.way <= 0.0) m.heading = from.heading;
    m.direction = -m.direction;
    std::swap(m.first, m.last);
    m.first = -m.first;
    m.last = -m.last;
    return m;
  }

  Motion motion_forth(const Pose& from, const Pose& to) const {
    Motion m;
    const Vec2 way = to.position() - from.position();
    m.way = norm(way);
    if (m.way <= no_way) {
      m.way = 0.0;
      m.heading = from.heading;
      m.last = turn_between(from.heading, to.heading);
      return m;
    }
    const double course = angle_of(way), back = wrap(course + pi);
    const auto turning = [&](double heading) { return std::abs(shorter_turn(from.heading, heading)) + std::abs(shorter_turn(heading, to.heading)); };
    const double along = turning(course), against = turning(back);
    const bool is_forward = std::abs(along - against) <= same_cost ? points_to_x(course) : along < against;
    m.heading = is_forward ? course : back;
    m.direction = is_forward ? 1 : -1;
    m.first = turn_between(from.heading, m.heading);
    m.last = turn_between(m.heading, to.heading);
    return m;
  }

  double turn_cost_;
};

template <class Curves>
class CurveSteering final : public Steering {
 public:
  explicit CurveSteering(double radius) : curves_{radius} {}
  static constexpr bool is_reeds_shepp = std::is_same_v<Curves, ReedsShepp>;

  SteeringKind kind() const override { return is_reeds_shepp ? SteeringKind::reeds_shepp : SteeringKind::dubins; }
  double distance(const Pose& from, const Pose& to) const override { return curves_.distance(from, to); }
  double distance_under(const Pose& from, const Pose& to, double limit) const override {
    if constexpr (is_reeds_shepp) {
      return curves_.distance_under(from, to, limit);
    } else {
      return curves_.distance(from, to);
    }
  }
  /// The heading turns by no more than length/radius. So after the length L nothing is farther beside the line along an end's heading than radius (1 − cos(L/radius)),
  /// which is under L²/(2 radius), and up to a quarter of a circle no more than that, whence on no more than what is driven.
  double bound(const Facing& from, const Facing& to) const override {
    const Vec2 way = to.pose.position() - from.pose.position();
    const double radius = curves_.radius();
    const double beside = std::max(std::abs(cross(from.along, way)), std::abs(cross(to.along, way)));
    const double sideways = beside < radius ? std::sqrt(2.0 * radius * beside) : beside + radius * (0.5 * pi - 1.0);
    return std::max({norm(way), sideways, radius * std::abs(shorter_turn(from.pose.heading, to.pose.heading))});
  }
  Pieces between(const Pose& from, const Pose& to) const override { return curves_.between(from, to); }
  Pose at(const Pose& from, const Pose& to, double t) const override {
    const Pieces pieces = curves_.between(from, to);
    if (t >= 1.0 || pieces.empty()) return to;
    return t <= 0.0 ? from : pose_at(pieces, t * length(Path{pieces}));
  }
  bool is_symmetric() const override { return is_reeds_shepp; }
  std::string words() const override { return fmt::format("{}s of {:.3f} m turning radius", piece_word(), curves_.radius()); }
  std::string_view piece_word() const override { return is_reeds_shepp ? "Reeds-Shepp curve" : "Dubins curve"; }

 private:
  Curves curves_;
};

/// Drives on one straight line in one direction become one.
void append_drive(std::vector<Action>& actions, Vec2& at, const Line& line, int direction) {
  if (!actions.empty() && actions.back().kind == Action::Kind::drive && actions.back().direction == direction) {
    const Vec2 before = at, way = actions.back().to - before, more = line.to - line.from;
    if (dot(way, more) > 0.0 && std::abs(cross(way, more)) <= no_turn * norm(way) * norm(more)) {
      actions.back().to = line.to;
      return;
    }
  }
  at = line.from;
  actions.push_back({Action::Kind::drive, 0.0, line.to, direction});
}

}  // namespace

std::string_view to_string(SteeringKind kind) {
  switch (kind) {
    case SteeringKind::plane: return "plane";
    case SteeringKind::turns: return "turns";
    case SteeringKind::dubins: return "dubins";
    case SteeringKind::reeds_shepp: break;
  }
  return "reeds_shepp";
}

std::unique_ptr<const Steering> make_steering(SteeringKind kind, const SteeringOptions& options) {
  switch (kind) {
    case SteeringKind::plane: return std::make_unique<PlaneSteering>(options.disc);
    case SteeringKind::turns: return std::make_unique<TurnSteering>(options.turn_cost);
    case SteeringKind::dubins: return std::make_unique<CurveSteering<Dubins>>(options.radius);
    case SteeringKind::reeds_shepp: break;
  }
  return std::make_unique<CurveSteering<ReedsShepp>>(options.radius);
}

Path path_along_states(const Steering& steering, const std::vector<Pose>& states, const Pose& start, const std::optional<Pose>& goal) {
  std::vector<Action> actions;
  Path path;
  Vec2 at = start.position();
  for (std::size_t i = 1; i < states.size(); ++i) {
    for (const Piece& piece : steering.between(states[i - 1], states[i])) {
      if (steering.is_curve()) {
        append_merged(path.pieces, piece);
      } else if (const auto* turn = std::get_if<Turn>(&piece.curve)) {
        actions.push_back({Action::Kind::turn, turn->angle, {}, 1});
      } else {
        append_drive(actions, at, std::get<Line>(piece.curve), piece.direction);
      }
    }
  }
  if (steering.is_curve()) return path;
  return goal ? path_of(start, actions, *goal) : path_along(start, actions);
}

}  // namespace waywright
