#include "waywright/planner/grid/grid_path.hpp"

#include <cmath>

#include "waywright/planner/grid/free_goal.hpp"

namespace waywright {
namespace {

constexpr double no_turn = 1e-9;  // rad: far under what counts as continuous
constexpr double no_way = 1e-9;   // m

class Builder {
 public:
  explicit Builder(const Pose& start) : at_{start} {}

  void turn(double angle) { told_ += angle; }
  void drive(Vec2 to, int direction) {
    if (distance(at_.position(), to) <= no_way) return;
    const double course = angle_of(to - at_.position());
    face(direction > 0 ? course : wrap(course + pi));
    path_.pieces.push_back({Line{at_.position(), to}, direction});
    at_ = make_pose(to, at_.heading);
  }
  void face(double heading) {
    const double angle = told_ + wrap(heading - (at_.heading + told_));
    told_ = 0.0;
    if (std::abs(angle) > no_turn) path_.pieces.push_back({Turn{at_.position(), at_.heading, angle}, 0});
    at_.heading = heading;
  }
  Path take() { return std::move(path_); }

 private:
  Path path_;
  Pose at_;
  double told_ = 0.0;
};

}  // namespace

Path path_of(const Pose& start, const std::vector<Action>& actions, const Pose& goal) {
  Builder builder{start};
  for (const Action& a : actions) {
    if (a.kind == Action::Kind::turn) builder.turn(a.angle);
    else builder.drive(a.to, a.direction);
  }
  builder.drive(goal.position(), 1);
  builder.face(goal.heading);
  return builder.take();
}

Path path_along(const Pose& start, const std::vector<Action>& actions) {
  Builder builder{start};
  for (const Action& a : actions) {
    if (a.kind == Action::Kind::turn) builder.turn(a.angle);
    else builder.drive(a.to, a.direction);
  }
  return builder.take();
}

std::vector<Action> drives_along(const GridFrame& frame, const std::vector<Cell>& cells) {
  std::vector<Action> actions;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const Cell a = cells[i - 1], b = cells[i];
    const bool goes_on = i + 1 < cells.size() && cells[i + 1].column - b.column == b.column - a.column && cells[i + 1].row - b.row == b.row - a.row;
    if (!goes_on) actions.push_back({Action::Kind::drive, 0.0, frame.centre(b), 1});
  }
  return actions;
}

std::vector<Action> actions_along(const HeadingSpace& space, const HeadingAnswer& answer) {
  std::vector<Action> actions;
  HeadingState at = answer.first;
  for (std::size_t i = 0; i < answer.steps.size(); ++i) {
    const HeadingStep step = answer.steps[i];
    if (step == HeadingStep::to_next || step == HeadingStep::to_previous) {
      const int before = step == HeadingStep::to_next ? at.heading : space.beside(at.heading, -1);
      actions.push_back({Action::Kind::turn, step == HeadingStep::to_next ? space.turn(before) : -space.turn(before), {}, 1});
      at.heading = space.beside(at.heading, step == HeadingStep::to_next ? 1 : -1);
      continue;
    }
    const int direction = step == HeadingStep::forwards ? 1 : -1;
    const Move m = moves[static_cast<std::size_t>(space.move(at.heading))];
    at.cell = {at.cell.column + direction * m.column, at.cell.row + direction * m.row};
    if (i + 1 < answer.steps.size() && answer.steps[i + 1] == step) continue;
    actions.push_back({Action::Kind::drive, 0.0, space.frame().centre(at.cell), direction});
  }
  return actions;
}

Turning turning_of(const Path& path) {
  Turning turning;
  for (const Piece& piece : path.pieces) {
    if (const auto* turn = std::get_if<Turn>(&piece.curve)) {
      turning.angle += std::abs(turn->angle);
      ++turning.turns;
    }
  }
  return turning;
}

}  // namespace waywright
