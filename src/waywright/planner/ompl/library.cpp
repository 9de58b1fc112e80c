#include "waywright/planner/ompl/library.hpp"

#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/samplers/InformedStateSampler.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "waywright/core/random.hpp"

namespace waywright::library {
namespace {

class Headings final : public ob::SE2StateSpace {
 public:
  explicit Headings(const Steering& steering) : states_{steering}, steering_{steering} {}

  double distance(const ob::State* from, const ob::State* to) const override { return steering_.distance(states_.pose(from), states_.pose(to)); }
  void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override {
    if (t >= 1.0) {
      if (to != state) copyState(state, to);
    } else {
      states_.assign(state, steering_.at(states_.pose(from), states_.pose(to), t));
    }
  }
  // Small ways to the side cost more in one motion of two turns than in some, and Dubins' ways back are others.
  bool isMetricSpace() const override { return steering_.kind() == SteeringKind::reeds_shepp; }
  bool hasSymmetricDistance() const override { return steering_.is_symmetric(); }
  bool hasSymmetricInterpolate() const override { return steering_.is_symmetric(); }

 private:
  States states_;
  const Steering& steering_;
};

/// The same pair in the same order, whichever comes first: symmetric costs are the same to the last bit both ways, which searches from both ends rely on.
std::pair<Pose, Pose> ordered(const Pose& a, const Pose& b) {
  return std::tie(b.x, b.y, b.heading) < std::tie(a.x, a.y, a.heading) ? std::pair{b, a} : std::pair{a, b};
}

/// The library's own of the plane writes past what it is given.
class Positions final : public ob::ProjectionEvaluator {
 public:
  Positions(const ob::StateSpace* space, const Steering& steering, const Box& region) : ob::ProjectionEvaluator{space}, states_{steering} {
    constexpr double cells = 20.0;  // along a side, as the library has it
    setCellSizes({(region.high.x - region.low.x) / cells, (region.high.y - region.low.y) / cells});
  }
  unsigned int getDimension() const override { return 2; }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    const Pose pose = states_.pose(state);
    projection(0) = pose.x;
    projection(1) = pose.y;
  }

 private:
  States states_;
};

/// Positions in the ellipse of those through which a way of the given cost can lead, headings evenly.
class Ellipse final : public ob::InformedSampler {
 public:
  Ellipse(const ob::ProblemDefinitionPtr& definition, unsigned int calls, const Steering& steering, Vec2 start, const std::vector<Pose>& goals, const Box& region, std::uint64_t seed)
      : ob::InformedSampler{definition, calls},
        states_{steering},
        has_headings_{steering.has_headings()},
        start_{start},
        goals_{goals},
        region_{region},
        random_{Random::stream(seed, 1)},
        everywhere_{space_->allocStateSampler()} {}

  bool sampleUniform(ob::State* state, const ob::Cost& cost) override {
    if (!std::isfinite(cost.value()) || goals_.size() > 1) {
      everywhere_->sampleUniform(state);
      return true;
    }
    const Vec2 goal = goals_.front().position(), middle = 0.5 * (start_ + goal);
    const double between = waywright::distance(start_, goal);
    const Vec2 along = between > 0.0 ? (1.0 / between) * (goal - start_) : Vec2{1.0, 0.0};
    const double half = 0.5 * std::max(cost.value(), between);
    const double across = 0.5 * std::sqrt(std::max(0.0, cost.value() * cost.value() - between * between));
    constexpr int tries = 100;
    Vec2 position{};
    for (int i = 0; i < tries; ++i) {
      const double r = std::sqrt(random_.uniform());
      const SinCos angle = sin_cos(random_.uniform(-pi, pi));
      position = middle + (half * r * angle.cos) * along + (across * r * angle.sin) * left_of(along);
      if (region_.contains(position)) break;
    }
    position = {std::clamp(position.x, region_.low.x, region_.high.x), std::clamp(position.y, region_.low.y, region_.high.y)};
    states_.assign(state, make_pose(position, has_headings_ ? random_.uniform(-pi, pi) : 0.0));
    return true;
  }
  bool sampleUniform(ob::State* state, const ob::Cost& least, const ob::Cost& most) override {
    constexpr int tries = 100;
    for (int i = 0; i < tries; ++i) {
      if (sampleUniform(state, most) && !opt_->isCostBetterThan(heuristicSolnCost(state), least)) return true;
    }
    return false;
  }
  bool hasInformedMeasure() const override { return goals_.size() == 1; }
  double getInformedMeasure(const ob::Cost& cost) const override {
    const double all = space_->getMeasure(), between = waywright::distance(start_, goals_.front().position());
    if (!std::isfinite(cost.value()) || goals_.size() > 1) return all;
    const double across = std::sqrt(std::max(0.0, cost.value() * cost.value() - between * between));
    return std::min(all, 0.25 * pi * cost.value() * across * (has_headings_ ? two_pi : 1.0));
  }

 private:
  States states_;
  bool has_headings_;
  Vec2 start_;
  const std::vector<Pose>& goals_;
  Box region_;
  Random random_;
  ob::StateSamplerPtr everywhere_;
};

}  // namespace

Pose States::pose(const ob::State* state) const {
  if (has_headings_) {
    const auto* s = state->as<ob::SE2StateSpace::StateType>();
    return {s->getX(), s->getY(), s->getYaw()};
  }
  const auto* s = state->as<ob::RealVectorStateSpace::StateType>();
  return {s->values[0], s->values[1], 0.0};
}

/// OMPL's headings are in [−π, π), ours in (−π, π]: π itself, a frequent docked heading, would be out of its bounds.
void States::assign(ob::State* state, const Pose& pose) const {
  if (has_headings_) {
    auto* s = state->as<ob::SE2StateSpace::StateType>();
    const double heading = wrap(pose.heading);
    s->setXY(pose.x, pose.y);
    s->setYaw(heading >= pi ? -pi : heading);
    return;
  }
  auto* s = state->as<ob::RealVectorStateSpace::StateType>();
  s->values[0] = pose.x;
  s->values[1] = pose.y;
}

ob::StateSpacePtr make_space(const Steering& steering, const Box& region) {
  ob::RealVectorBounds bounds{2};
  bounds.setLow(0, region.low.x);
  bounds.setLow(1, region.low.y);
  bounds.setHigh(0, region.high.x);
  bounds.setHigh(1, region.high.y);
  const auto with = [&](auto space) -> ob::StateSpacePtr {
    space->setBounds(bounds);
    space->registerDefaultProjection(std::make_shared<Positions>(space.get(), steering, region));
    return space;
  };
  if (steering.has_headings()) return with(std::make_shared<Headings>(steering));
  return with(std::make_shared<ob::RealVectorStateSpace>(2));
}

bool Validity::isValid(const ob::State* state) const {
  // The work is done: planners that draw until a state is valid would draw for ever. No motion is called free any more, and the search ends.
  if (test_.spent()) return true;
  const bool is_free = test_.pose_free(states_.pose(state));
  if (is_free) ++free_states_;
  return is_free;
}

bool ContinuousMotion::is_free(const Pose& from, const Pose& to, const Pieces& pieces) const {
  if (!test_.motion_free(pieces)) return false;
  if (from != to) {
    const double missing = missing_to(steering_, to, goals_);
    if (!nearest_ || missing < missing_) {
      nearest_ = to;
      missing_ = missing;
    }
  }
  return true;
}

bool ContinuousMotion::checkMotion(const ob::State* from, const ob::State* to) const {
  const Pose a = states_.pose(from), b = states_.pose(to);
  return is_free(a, b, steering_.between(a, b));
}

bool ContinuousMotion::checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last) const {
  const Pose a = states_.pose(from), b = states_.pose(to);
  const Pieces pieces = steering_.between(a, b);
  if (is_free(a, b, pieces)) return true;
  const MotionTest::Stop stop = test_.stop();
  double before = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double cost = steering_.cost(pieces[i]);
    whole += cost;
    before += i < stop.piece ? cost : i == stop.piece ? stop.share * cost : 0.0;
  }
  double share = whole > 0.0 ? before / whole : 0.0;
  const Pose there = steering_.at(a, b, share);
  if (share <= 0.0 || !is_free(a, there, steering_.between(a, there))) share = 0.0;
  last.second = share;
  if (last.first != nullptr) states_.assign(last.first, share > 0.0 ? there : a);
  return false;
}

double missing_to(const Steering& steering, const Pose& from, const std::vector<Pose>& goals) {
  double least = std::numeric_limits<double>::infinity();
  for (const Pose& goal : goals) least = std::min(least, steering.distance(from, goal));
  return least;
}

Cost::Cost(const ob::SpaceInformationPtr& si, const Steering& steering, const Pose& start, const std::vector<Pose>& goals, const Box& region, std::uint64_t seed)
    : ob::OptimizationObjective{si}, states_{steering}, steering_{steering}, start_{start}, goals_{goals}, region_{region}, seed_{seed} {
  description_ = "length";
  const auto to_go = [this](const Pose& from) {
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& goal : goals_) {
      const auto [a, b] = steering_.is_symmetric() ? ordered(from, goal) : std::pair{from, goal};
      least = std::min(least, steering_.least(a, b));
    }
    return least;
  };
  setCostToGoHeuristic([this, to_go](const ob::State* state, const ob::Goal*) { return ob::Cost{to_go(states_.pose(state))}; });
  constexpr double enough = 1e-6;  // of the length: nothing shorter can be
  setCostThreshold(ob::Cost{(1.0 + enough) * to_go(start)});
}

ob::Cost Cost::motionCost(const ob::State* from, const ob::State* to) const {
  Pose a = states_.pose(from), b = states_.pose(to);
  if (steering_.is_symmetric()) std::tie(a, b) = ordered(a, b);
  return ob::Cost{steering_.distance(a, b)};
}

/// Some planners ask it of motions from the goal back.
ob::Cost Cost::motionCostHeuristic(const ob::State* from, const ob::State* to) const {
  const auto [a, b] = ordered(states_.pose(from), states_.pose(to));
  return ob::Cost{steering_.is_symmetric() ? steering_.least(a, b) : std::min(steering_.least(a, b), steering_.least(b, a))};
}

ob::InformedSamplerPtr Cost::allocInformedStateSampler(const ob::ProblemDefinitionPtr& definition, unsigned int calls) const {
  return std::make_shared<Ellipse>(definition, calls, steering_, start_.position(), goals_, region_, seed_);
}

}  // namespace waywright::library
