#include "waywright/planner/ompl/rrt_connect.hpp"

#include <fmt/format.h>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "waywright/planner/ompl/arc_motion.hpp"

namespace waywright {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Space = ob::ReedsSheppStateSpace;

/// OMPL draws the seeds of all its generators from one global: runs take turns.
std::mutex& ompl_mutex() {
  static std::mutex mutex;
  return mutex;
}

Pose pose_of(const ob::State* state) {
  const auto* s = state->as<Space::StateType>();
  return {s->getX(), s->getY(), s->getYaw()};
}

void assign(ob::State* state, const Pose& pose) {
  auto* s = state->as<Space::StateType>();
  s->setXY(pose.x, pose.y);
  s->setYaw(pose.heading >= pi ? -pi : pose.heading);  // OMPL's range is [−π, π)
}

/// The Reeds–Shepp curve between two states as exact pieces.
std::vector<Piece> pieces_between(const Space& space, double radius, const ob::State* from, const ob::State* to) {
  std::vector<Piece> pieces;
  const Space::ReedsSheppPath path = space.reedsShepp(from, to);
  Pose pose = pose_of(from);
  for (unsigned i = 0; i < 5; ++i) {
    const double length = path.length_[i];
    if (path.type_[i] == Space::RS_NOP || std::abs(length) < 1e-10) continue;
    Piece piece;
    piece.direction = length > 0.0 ? 1 : -1;
    // Curvature in the direction of travel: a left curve driven backwards turns the course to the right.
    const double side = path.type_[i] == Space::RS_LEFT ? 1.0 : path.type_[i] == Space::RS_RIGHT ? -1.0 : 0.0;
    const Pose start = make_pose(pose.position(), piece.direction > 0 ? pose.heading : wrap(pose.heading + pi));
    const double metres = std::abs(length) * radius;
    if (side == 0.0) {
      piece.curve = Line{start.position(), start.position() + metres * unit(start.heading)};
    } else {
      piece.curve = Arc{start, side * static_cast<double>(piece.direction) / radius, metres};
    }
    pose = end_pose(piece);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

class Validity final : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& si, MotionTest& test) : ob::StateValidityChecker{si}, test_{test} {}
  bool isValid(const ob::State* state) const override { return test_.pose_free(pose_of(state)); }

 private:
  MotionTest& test_;
};

class ExactMotion final : public ob::MotionValidator {
 public:
  ExactMotion(const ob::SpaceInformationPtr& si, const Space& space, double radius, MotionTest& test)
      : ob::MotionValidator{si}, space_{space}, radius_{radius}, test_{test} {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    for (const Piece& piece : pieces_between(space_, radius_, from, to)) {
      if (!test_.piece_free(piece)) return false;
    }
    return true;
  }
  /// RRTConnect as used here does not ask for the last valid state.
  bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last) const override {
    last.second = 0.0;
    if (last.first != nullptr) si_->copyState(last.first, from);
    return checkMotion(from, to);
  }

 private:
  const Space& space_;
  double radius_;
  MotionTest& test_;
};

bool same_circle(const Piece& a, const Piece& b) {
  if (a.direction != b.direction || a.curve.index() != b.curve.index()) return false;
  if (const auto* arc = std::get_if<Arc>(&a.curve)) return arc->curvature == std::get<Arc>(b.curve).curvature;
  return true;
}

/// Neighbouring pieces on one line or circle become one.
void append_merged(Path& path, const Piece& piece) {
  if (path.pieces.empty() || !same_circle(path.pieces.back(), piece)) {
    path.pieces.push_back(piece);
    return;
  }
  Curve& last = path.pieces.back().curve;
  if (auto* arc = std::get_if<Arc>(&last)) {
    arc->length += std::get<Arc>(piece.curve).length;
  } else {
    std::get<Line>(last).to = std::get<Line>(piece.curve).to;
  }
}

Path exact_path(const Space& space, double radius, const og::PathGeometric& found) {
  const auto& states = const_cast<og::PathGeometric&>(found).getStates();  // OMPL has no const access
  Path path;
  for (std::size_t i = 0; i + 1 < states.size(); ++i) {
    for (const Piece& piece : pieces_between(space, radius, states[i], states[i + 1])) {
      append_merged(path, piece);
    }
  }
  return path;
}

ob::RealVectorBounds bounds_of(const Problem& problem, double radius) {
  const double reach = 4.0 * radius + 2.0 * problem.vehicle().footprint.radius();
  Box box = bounding_box({problem.start().position(), problem.goal().position()});
  const Vec2 margin{reach, reach};
  Box wide{box.low - margin, box.high + margin};
  if (!problem.world().empty()) {
    const Box world = problem.world().bounds();
    // Search where the map says something, but always around the task itself.
    wide.low = {std::min(box.low.x, std::max(world.low.x, box.low.x - 10.0 * reach)),
                std::min(box.low.y, std::max(world.low.y, box.low.y - 10.0 * reach))};
    wide.high = {std::max(box.high.x, std::min(world.high.x, box.high.x + 10.0 * reach)),
                 std::max(box.high.y, std::min(world.high.y, box.high.y + 10.0 * reach))};
    if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) wide = bounding_box(station->area);
  }
  ob::RealVectorBounds bounds{2};
  bounds.setLow(0, wide.low.x - 1e-6);
  bounds.setLow(1, wide.low.y - 1e-6);
  bounds.setHigh(0, wide.high.x + 1e-6);
  bounds.setHigh(1, wide.high.y + 1e-6);
  return bounds;
}

/// The shortest of the path found and its simplifications that is free when looked at again as exact pieces: OMPL's shortcuts cut
/// curves at inner states, and the Reeds–Shepp curve from there can be another one than the rest of the curve that was tested.
Path simplified(const og::PathGeometric& found, const Path& first, const ob::SpaceInformationPtr& si, const Space& space,
                double radius, int shortcuts, MotionTest& test, Budget& budget) {
  Path best = first;
  const auto steps = static_cast<unsigned>(shortcuts);
  if (steps == 0) return best;
  og::PathSimplifier simplifier{si};
  og::PathGeometric current{found};
  const auto keep = [&] {
    const Path path = exact_path(space, radius, current);
    if (length(path) >= length(best)) return;
    if (std::all_of(path.pieces.begin(), path.pieces.end(), [&](const Piece& p) { return test.piece_free(p); })) best = path;
  };
  if (!budget.exhausted()) simplifier.reduceVertices(current, steps, steps);
  keep();
  for (int round = 0; round < 2 && !budget.exhausted(); ++round) {
    simplifier.shortcutPath(current, steps, steps);
    keep();
    simplifier.reduceVertices(current, steps, steps);
    keep();
  }
  return best;
}

struct Counts {
  int direction_changes = 0;
  int stops_to_steer = 0;
};

Counts count(const Path& path) {
  Counts counts;
  for (std::size_t i = 1; i < path.pieces.size(); ++i) {
    const Piece& a = path.pieces[i - 1];
    const Piece& b = path.pieces[i];
    if (a.direction != b.direction) {
      ++counts.direction_changes;
    } else if (std::abs(end_curvature(a) - start_curvature(b)) > 1e-6) {
      ++counts.stops_to_steer;
    }
  }
  return counts;
}

}  // namespace

PlanningResult RrtConnectPlanner::plan(const Problem& problem, Budget& budget) const {
  const std::lock_guard lock{ompl_mutex()};
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed_ % 0x7FFFFFFEULL) + 1);

  const double curvature = problem.vehicle().max_curvature();
  const double radius = std::isfinite(curvature) ? options_.radius_factor / std::max(curvature, 1e-6)
                                                 : options_.radius_without_limit;
  MotionTest test{problem};
  auto space = std::make_shared<Space>(radius);
  space->setBounds(bounds_of(problem, radius));
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(std::make_shared<Validity>(si, test));
  si->setMotionValidator(std::make_shared<ExactMotion>(si, *space, radius, test));
  si->setup();

  auto definition = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<Space> start{space};
  ob::ScopedState<Space> goal{space};
  assign(start.get(), problem.start());
  assign(goal.get(), problem.goal());
  definition->setStartAndGoalStates(start, goal, 1e-9);

  og::RRTConnect planner{si};
  planner.setProblemDefinition(definition);
  planner.setup();
  Alternative alternative;
  alternative.name = "Reeds-Shepp, RRTConnect";
  for (const ob::State* end : {start.get(), goal.get()}) {
    if (si->satisfiesBounds(end) && si->isValid(end)) continue;
    // OMPL would wait for another goal for ever.
    const Pose pose = pose_of(end);
    PlanningFailure failure;
    failure.failure = {Status::no_path, fmt::format("the {} pose is not one that RRTConnect can use", end == start.get() ? "start" : "goal"), pose, {}};
    alternative.outcome = failure.failure.reason;
    failure.alternatives.push_back(std::move(alternative));
    return tl::unexpected{std::move(failure)};
  }
  const std::int64_t limit = budget.limits().samples.value_or(options_.checks);
  const ob::PlannerTerminationCondition stop{
      [&] { return test.placements() >= limit || budget.exhausted(); }};
  const ob::PlannerStatus status = planner.solve(stop);
  const auto* found = status == ob::PlannerStatus::EXACT_SOLUTION
                          ? dynamic_cast<const og::PathGeometric*>(definition->getSolutionPath().get())
                          : nullptr;

  if (found == nullptr) {
    budget.count_evaluations(test.placements());
    PlanningFailure failure;
    failure.failure.status = budget.canceled()    ? Status::canceled
                             : budget.cut_short() ? Status::timed_out
                                                  : Status::no_path;
    const auto [name, share] = test.worst_obstacle();
    failure.failure.reason = fmt::format("RRTConnect found no way from start to goal in {} footprint placements (budget {})",
                                         test.placements(), limit);
    if (!name.empty()) failure.failure.reason += fmt::format("; {} stood in the way of {:.0f} % of the blocked ones", name, 100.0 * share);
    failure.failure.reason += ".";
    alternative.outcome = failure.failure.reason;
    failure.explanation.push_back(failure.failure.reason);
    failure.alternatives.push_back(std::move(alternative));
    return tl::unexpected{std::move(failure)};
  }

  const Path first = exact_path(*space, radius, *found);
  Planned planned;
  planned.path = simplified(*found, first, si, *space, radius, options_.shortcuts, test, budget);
  budget.count_evaluations(test.placements());

  const Counts counts = count(planned.path);
  const double metres = length(planned.path);
  alternative.chosen = true;
  alternative.cost = metres;
  const std::string changes = fmt::format("{} change{} of direction", counts.direction_changes, counts.direction_changes == 1 ? "" : "s");
  alternative.outcome = fmt::format("{:.2f} m, {}", metres, changes);
  for (const Sample& s : sample(planned.path, 0.0, 0.01, 0.12)) alternative.poses.push_back(s.pose());
  planned.explanation.push_back(
      fmt::format("RRTConnect in the Reeds-Shepp space (turning radius {:.3f} m) found a path of {:.2f} m, {:.2f} m after "
                  "simplification, with {}, in {} footprint placements.",
                  radius, length(first), metres, changes, test.placements()));
  if (counts.stops_to_steer > 0) {
    planned.explanation.push_back(fmt::format("Its curvature jumps at {} joint{} on the way; a vehicle whose steering takes time stops there.",
                                              counts.stops_to_steer, counts.stops_to_steer == 1 ? "" : "s"));
  }
  planned.alternatives.push_back(std::move(alternative));
  return planned;
}

PlannerDescription rrt_connect_description() {
  return {"ompl_rrt_connect",
          "RRTConnect with Reeds-Shepp curves by OMPL, simplified; for any goal pose, stops to steer where the curvature jumps",
          {
              {.name = "radius_factor", .default_value = 1.001, .summary = "turning radius over the least one", .low = 1.0,
               .high = 100.0},
              {.name = "radius_without_limit", .default_value = 0.3,
               .summary = "turning radius of a vehicle without a curvature limit", .unit = "m", .low = 0.01, .high = 100.0},
              {.name = "checks", .default_value = 60000.0, .summary = "footprint placements that may be tested", .low = 1,
               .high = 1e9, .whole = true},
              {.name = "shortcuts", .default_value = 300.0, .summary = "shortcuts tried on the path found", .low = 0, .high = 1e6,
               .whole = true},
          },
          [](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
            RrtConnectOptions options;
            options.radius_factor = std::get<double>(p.at("radius_factor"));
            options.radius_without_limit = std::get<double>(p.at("radius_without_limit"));
            options.checks = static_cast<std::int64_t>(std::get<double>(p.at("checks")));
            options.shortcuts = static_cast<int>(std::get<double>(p.at("shortcuts")));
            return RrtConnectPlanner{options, seed};
          }};
}

}  // namespace waywright
