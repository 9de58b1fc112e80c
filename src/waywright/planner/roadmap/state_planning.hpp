// What searches among positions with headings share: ends, draws and motions before, the path and its words after.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/judge/search_picture.hpp"
#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/planner.hpp"
#include "waywright/planner/steering/search_ends.hpp"
#include "waywright/planner/steering/spaces.hpp"

namespace waywright {

/// What is asked of a search: a way of the steering's motions, each called free by the test.
struct StateQuery {
  const Steering& steering;
  MotionTest& test;
  Pose start{}, goal{};
  Box region{};              ///< where positions are drawn
  std::int64_t motions = 0;  ///< at most so many may be tested when the search ends

  /// A free state, its position from the region and, where `cost` is finite, from the ellipse of those past which a way of that cost (m) can lead; headings evenly. Where a
  /// hundred draws were not wanted the next free one is taken. Empty where thousands of draws were not free, or the budget ends.
  std::optional<Pose> draw(Random& random, Budget& budget, const std::function<bool(const Pose&)>& is_wanted, double cost) const;
  /// Where a motion leads past between both states, for pictures; empty where it is straight.
  std::vector<Vec2> bend_between(const Pose& from, const Pose& to) const;
  std::vector<Vec2> places_along(const std::vector<Pose>& states) const;
};

/// What a search answers.
struct StateAnswer {
  std::vector<Pose> states;   ///< from the start to the goal; empty where it found no way
  std::vector<Pose> nearest;  ///< else: to the state reached from which a motion to the goal costs least
  bool is_least = false;      ///< no chain of such motions costs less
  std::string found;          ///< "its tree has 12 nodes after 40 samples"
  std::string missed;         ///< "RRT found no way … before all 100 samples were drawn: …"
  SearchPicture picture{};
};

/// "all 50 motions of its budget were tested", or "45 of the 50 motions …": the number that was given.
std::string motions_spent(const StateQuery& query);

/// The space was left to the planner, and where the disc around the footprint finds no way, the footprint itself may, with turns on the spot.
bool may_turn_instead(const Problem& problem, const SpaceOptions& options);
/// What the footprint itself comes to where the disc around it failed; what the disc came to is told before, its ways drawn behind.
PlanningResult after_the_disc(const PlanningFailure& disc, PlanningResult itself);

/// From a problem to a search and back: the same for every method.
class StatePlanning {
 public:
  /// Space and problem outlive it. @param space not the plane  @param label "RRT*"
  StatePlanning(const PlaneSpace& plane, SteeringKind space, const SpaceOptions& options, std::string_view name, std::string_view label)
      : plane_{plane}, kind_{space}, options_{options}, name_{name}, label_{label} {}

  /// The search is asked once, unless there is nothing to search. What it finds is shortened where `shortens` says so; of a limited number of evaluations a tenth is kept for
  /// that. Its work, in motions, is counted as the budget's evaluations.
  PlanningResult plan(const std::function<StateAnswer(const StateQuery&)>& search, bool shortens, std::uint64_t seed, Budget& budget) const;

 private:
  PlanningFailure failure(Status status, const std::string& reason) const;
  PlanningFailure not_found(const StateQuery& query, const StateAnswer& answer, Budget& budget) const;
  Alternative alternative(std::string name, const Path& path, bool is_chosen) const;

  const PlaneSpace& plane_;
  SteeringKind kind_;
  SpaceOptions options_;
  std::string name_, label_;
};

}  // namespace waywright
