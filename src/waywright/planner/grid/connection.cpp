#include "waywright/planner/grid/connection.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/planner/grid/free_goal.hpp"

namespace waywright {
namespace {

constexpr double same_place = 1e-9;  // m, and rad: less than any proof can tell
constexpr int widest = 3;            // cells to each side that are looked at
constexpr int most_straight_steps = 300;

bool is_middle(const GridFrame& frame, Cell c, Vec2 at) { return frame.contains(c) && distance(frame.centre(c), at) <= same_place; }

/// The 2k × 2k cells whose middles lie around a place, row by row.
std::vector<Cell> around(const GridFrame& frame, Vec2 at, int k) {
  const Vec2 p = frame.in_cells(at) - Vec2{0.5, 0.5};  // middles have whole numbers
  const int column = static_cast<int>(std::floor(p.x)), row = static_cast<int>(std::floor(p.y));
  std::vector<Cell> cells;
  for (int r = row - k + 1; r <= row + k; ++r) {
    for (int c = column - k + 1; c <= column + k; ++c) {
      if (frame.contains({c, r})) cells.push_back({c, r});
    }
  }
  return cells;
}

bool is_near(const GridFrame& frame, Vec2 at) {
  const Vec2 p = frame.in_cells(at);
  return p.x > -1.0 && p.y > -1.0 && p.x < frame.columns + 1.0 && p.y < frame.rows + 1.0;
}

double weighed(const ZoneRules& zones, Vec2 from, Vec2 to) { return zones.weighs() ? zones.cost(from, to) : distance(from, to); }

/// Connections of one pose, all actions told outwards, from the pose to the cell; into the pose they are driven the other way.
class Connector {
 public:
  Connector(const ZoneRules& zones, const HeadingSpace& space, double margin, bool is_start, MotionCheck& test)
      : zones_{zones}, space_{space}, margin_{margin}, is_start_{is_start}, test_{test} {}

  /// From `base`, with what was done before it came there.
  void from(const Pose& base, const std::vector<Action>& before, double cost) {
    const GridFrame& frame = space_.frame();
    if (!is_near(frame, base.position())) return;
    if (const Cell c = frame.cell_at(base.position()); is_middle(frame, c, base.position())) return turn_at(c, base.heading, before, cost);
    for (int k = 1; k <= widest && found_.empty(); ++k) {
      for (const Cell c : around(frame, base.position(), k)) drive_to(c, base, before, cost);
    }
  }
  /// From a place where it stands with any heading.
  void from_anywhere_facing(Vec2 at) {
    const GridFrame& frame = space_.frame();
    if (!is_near(frame, at)) return;
    if (const Cell c = frame.cell_at(at); is_middle(frame, c, at)) {
      for (int h = 0; h < space_.headings(); ++h) found_.push_back({{c, h}, 0.0, {}});
      return;
    }
    for (int k = 1; k <= widest && found_.empty(); ++k) {
      for (const Cell c : around(frame, at, k)) {
        const double course = angle_of(frame.centre(c) - at);
        drive_to(c, make_pose(at, course), {}, 0.0);
        drive_to(c, make_pose(at, wrap(course + pi)), {}, 0.0);
      }
    }
  }
  std::vector<HeadingConnection>& found() { return found_; }
  /// Cost of the straight way from `inner` to `outer`, outwards, with this direction.
  double driving(Vec2 inner, Vec2 outer, int outward) const {
    const double metres = weighed(zones_, inner, outer);
    const bool is_backwards = (outward < 0) == is_start_;
    return is_backwards ? metres * space_.costs().reverse : metres;
  }
  bool zones_allow(Vec2 inner, Vec2 outer) const { return is_start_ ? zones_.may_be_driven(inner, outer) : zones_.may_be_driven(outer, inner); }
  bool may_drive(int outward) const { return (outward < 0) != is_start_ || space_.costs().reverse > 0.0; }

 private:
  void drive_to(Cell cell, const Pose& base, const std::vector<Action>& before, double cost) {
    const Vec2 middle = space_.frame().centre(cell);
    const double course = angle_of(middle - base.position());
    if (!zones_allow(base.position(), middle)) return;
    for (const int outward : {1, -1}) {
      if (!may_drive(outward)) continue;
      const double facing = outward > 0 ? course : wrap(course + pi);
      const double turn = shorter_turn(base.heading, facing);
      if (!test_.is_drive_free(base.position(), middle, facing, margin_)) continue;
      if (std::abs(turn) > same_place && !test_.is_turn_free(base.position(), base.heading, turn, margin_)) continue;
      std::vector<Action> actions = before;
      actions.push_back({Action::Kind::turn, turn, {}, 1});
      actions.push_back({Action::Kind::drive, 0.0, middle, outward});
      turn_at(cell, facing, actions, cost + std::abs(turn) * space_.costs().turn + driving(base.position(), middle, outward));
    }
  }

  /// To the lattice's headings on both sides of one.
  void turn_at(Cell cell, double facing, const std::vector<Action>& before, double cost) {
    int nearest = 0;
    for (int h = 1; h < space_.headings(); ++h) {
      if (std::abs(shorter_turn(facing, space_.angle(h))) < std::abs(shorter_turn(facing, space_.angle(nearest)))) nearest = h;
    }
    const double off = shorter_turn(facing, space_.angle(nearest));
    const int other = space_.beside(nearest, (off > 0.0) == (space_.turn(nearest) > 0.0) ? -1 : 1);
    for (const int h : {nearest, other}) {
      const double turn = shorter_turn(facing, space_.angle(h));
      if (h == other && std::abs(off) <= same_place) continue;
      if (std::abs(turn) > same_place && !test_.is_turn_free(space_.frame().centre(cell), facing, turn, margin_)) continue;
      HeadingConnection c{{cell, h}, cost + std::abs(turn) * space_.costs().turn, before};
      c.actions.push_back({Action::Kind::turn, turn, {}, 1});
      found_.push_back(std::move(c));
    }
  }

  const ZoneRules& zones_;
  const HeadingSpace& space_;
  double margin_;
  bool is_start_;
  MotionCheck& test_;
  std::vector<HeadingConnection> found_;
};

/// What is done from `pose` outwards, as it is done from the cell into the pose.
void turn_round(HeadingConnection& connection, Vec2 pose) {
  Vec2 from = pose;
  for (Action& a : connection.actions) {
    if (a.kind == Action::Kind::turn) {
      a.angle = -a.angle;
    } else {
      std::swap(from, a.to);
      a.direction = -a.direction;
    }
  }
  std::reverse(connection.actions.begin(), connection.actions.end());
}

}  // namespace

std::vector<DiscConnection> disc_connections(const Problem& problem, const GridFrame& frame, Vec2 at, bool is_start, MotionCheck& test) {
  if (!is_near(frame, at)) return {};
  if (const Cell c = frame.cell_at(at); is_middle(frame, c, at)) return {{c, 0.0}};
  const double margin = connecting_margin(problem);
  const ZoneRules& zones = problem.zones_as_planned();
  std::vector<DiscConnection> found;
  for (int k = 1; k <= widest && found.empty(); ++k) {
    for (const Cell c : around(frame, at, k)) {
      const Vec2 middle = frame.centre(c);
      if (!(is_start ? zones.may_be_driven(at, middle) : zones.may_be_driven(middle, at))) continue;
      if (test.is_drive_free(at, middle, 0.0, margin)) found.push_back({c, weighed(zones, at, middle)});
    }
  }
  return found;
}

std::vector<HeadingConnection> free_connections(const Problem& problem, const HeadingSpace& space, MotionCheck& test) {
  if (!problem.free_goal()->is_point()) {
    std::vector<HeadingConnection> found;
    for (const Cell c : region_cells(problem, space.frame())) {
      for (int h = 0; h < space.headings(); ++h) found.push_back({{c, h}, 0.0, {}});
    }
    return found;
  }
  const Vec2 at = problem.goal().position();
  Connector connector{problem.zones_as_planned(), space, connecting_margin(problem), false, test};
  connector.from_anywhere_facing(at);
  // Of the two ways to face along a drive, one has nothing to turn before it; the other is a turn by half a circle that nobody needs.
  std::erase_if(connector.found(), [](const HeadingConnection& c) { return !c.actions.empty() && std::abs(c.actions.front().angle) > same_place; });
  for (HeadingConnection& c : connector.found()) turn_round(c, at);
  return std::move(connector.found());
}

std::vector<HeadingConnection> heading_connections(const Problem& problem, const HeadingSpace& space, const Pose& pose, bool is_start, MotionCheck& test) {
  const double margin = connecting_margin(problem);
  Connector connector{problem.zones_as_planned(), space, margin, is_start, test};
  connector.from(pose, {}, 0.0);
  // Out of an aisle or opening that it cannot turn in, as far as it goes straight on.
  const double step = std::max(space.frame().cell, 0.1 * problem.footprint().radius());
  bool goes_on[]{connector.may_drive(1), connector.may_drive(-1)};
  for (int i = 1; i <= most_straight_steps && connector.found().empty() && (goes_on[0] || goes_on[1]); ++i) {
    for (const int outward : {1, -1}) {
      bool& is_open = goes_on[outward > 0 ? 0 : 1];
      if (!is_open) continue;
      const double s = i * step;
      const Vec2 there = pose.position() + (outward * s) * unit(pose.heading);
      is_open = connector.zones_allow(pose.position(), there) && test.is_drive_free(pose.position(), there, pose.heading, margin);
      if (!is_open) continue;
      Connector next{problem.zones_as_planned(), space, margin, is_start, test};
      next.from(make_pose(there, pose.heading), {{Action::Kind::drive, 0.0, there, outward}}, connector.driving(pose.position(), there, outward));
      for (HeadingConnection& c : next.found()) connector.found().push_back(std::move(c));
    }
  }
  if (!is_start) {
    for (HeadingConnection& c : connector.found()) turn_round(c, pose.position());
  }
  return std::move(connector.found());
}

}  // namespace waywright
