#include "waywright/planner/roadmap/state_planning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/curve/arc.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/steering/shortcut.hpp"
#include "waywright/planner/steering/way_words.hpp"

namespace waywright {
namespace {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
constexpr int tries_a_draw = 10'000;      // states until one is free and wanted
constexpr int clock_every = 256;          // of them
constexpr int most_unwanted = 100;        // of them, until one is taken as it comes
constexpr int shortcuts = 300;            // tried on the way found
constexpr double picture_sagitta = 0.02;  // m, of chords in pictures

const char* space_word(SteeringKind kind) { return kind == SteeringKind::turns ? "Turns" : kind == SteeringKind::dubins ? "Dubins" : "Reeds-Shepp"; }

}  // namespace

std::optional<Pose> StateQuery::draw(Random& random, Budget& budget, const std::function<bool(const Pose&)>& is_wanted, double cost) const {
  const Vec2 from = start.position(), between = goal.position() - from, size = region.high - region.low;
  const double straight = norm(between);
  // Foci at both ends, the longer axis as long as the way.
  const double a = 0.5 * cost, b = std::isfinite(cost) ? 0.5 * std::sqrt(std::max(0.0, cost * cost - straight * straight)) : 0.0;
  const bool from_ellipse = std::isfinite(cost) && pi * a * b < size.x * size.y;
  const Vec2 along = straight > 0.0 ? (1.0 / straight) * between : Vec2{1.0, 0.0};
  int unwanted = 0;
  for (int i = 0; i < tries_a_draw; ++i) {
    if (i % clock_every == clock_every - 1 && budget.exhausted()) return std::nullopt;
    Vec2 at{};
    if (from_ellipse) {
      Vec2 q{};
      do {
        q.x = random.uniform(-1.0, 1.0);
        q.y = random.uniform(-1.0, 1.0);
      } while (squared_norm(q) > 1.0);
      at = from + 0.5 * between + (a * q.x) * along + (b * q.y) * left_of(along);
      if (!region.contains(at)) continue;
    } else {
      at.x = random.uniform(region.low.x, region.high.x);
      at.y = random.uniform(region.low.y, region.high.y);
    }
    const Pose pose = make_pose(at, wrap(random.uniform(-pi, pi)));
    if (unwanted < most_unwanted && !is_wanted(pose)) {
      ++unwanted;
      continue;
    }
    if (test.pose_free(pose)) return pose;
  }
  return std::nullopt;
}

std::vector<Vec2> StateQuery::bend_between(const Pose& from, const Pose& to) const {
  std::vector<Vec2> bend;
  const Pieces pieces = steering.between(from, to);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (const auto* arc = std::get_if<Arc>(&piece.curve)) {
      const double chord = std::sqrt(8.0 * picture_sagitta / std::abs(arc->curvature));
      const int chords = static_cast<int>(std::ceil(arc->length / chord));
      for (int k = 1; k < chords; ++k) bend.push_back(evaluate(*arc, arc->length * k / chords).position);
    }
    if (i + 1 < pieces.size() && !std::holds_alternative<Turn>(piece.curve)) bend.push_back(end_pose(piece).position());
  }
  return bend;
}

std::vector<Vec2> StateQuery::places_along(const std::vector<Pose>& states) const {
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i > 0) {
      for (const Vec2 place : bend_between(states[i - 1], states[i])) places.push_back(place);
    }
    places.push_back(states[i].position());
  }
  return places;
}

std::string motions_spent(const StateQuery& query) {
  const std::int64_t all = query.test.limits().motions, tested = query.test.motions();
  if (tested >= all) return fmt::format("all {} of its budget were tested", grid::counted(all, "motion"));
  return fmt::format("{} of the {} of its budget were tested, the others being kept for shortening a way", tested, grid::counted(all, "motion"));
}

bool may_turn_instead(const Problem& problem, const SpaceOptions& options) {
  return !options.space && problem.free_goal() == nullptr && !problem.footprint().is_disc() && problem.vehicle().can_turn_on_the_spot();
}

PlanningResult after_the_disc(const PlanningFailure& disc, PlanningResult itself) {
  const std::string before = fmt::format("The footprint itself was searched for in the space \"turns\", since the disc around it came to nothing: {}.", disc.failure.reason);
  auto& text = itself ? itself->explanation : itself.error().explanation;
  text.insert(text.begin() + (text.empty() ? 0 : 1), before);
  auto& tried = itself ? itself->alternatives : itself.error().alternatives;
  for (Alternative alternative : disc.alternatives) {
    alternative.name += ", disc";
    tried.push_back(std::move(alternative));
  }
  if (!itself) itself.error().failure.reason += "; before that, for the disc around the footprint, " + disc.failure.reason;
  return itself;
}

PlanningFailure StatePlanning::failure(Status status, const std::string& reason) const {
  PlanningFailure failed = grid::failure(status, reason);
  failed.explanation.push_back(reason + ".");
  Alternative tried;
  tried.name = fmt::format("{}, {}", space_word(kind_), label_);
  tried.outcome = reason + ".";
  failed.alternatives.push_back(std::move(tried));
  return failed;
}

Alternative StatePlanning::alternative(std::string name, const Path& path, bool is_chosen) const {
  Alternative one;
  one.name = std::move(name);
  one.chosen = is_chosen;
  one.cost = length(path);
  one.is_length = true;
  one.outcome = fmt::format("{:.3f} m, {}.", *one.cost, changes_words(counts_of(path), kind_ == SteeringKind::turns));
  one.poses = poses_along(path);
  return one;
}

PlanningFailure StatePlanning::not_found(const StateQuery& query, const StateAnswer& answer, Budget& budget) const {
  const Pose reached = answer.nearest.empty() ? query.start : answer.nearest.back();
  std::string reason = fmt::format("{}; nearest to the goal it came to ({:.3f}, {:.3f}, {:.4f} rad), where {:.2f} m of {} are missing", answer.missed, reached.x, reached.y, wrap(reached.heading),
                                   query.steering.distance(reached, query.goal), query.steering.piece_word());
  const Blocker blocker = query.test.worst_blocker();
  if (!blocker.name.empty()) reason += fmt::format("; {} stood in the way of {:.0f} % of the blocked placements", blocker.name, 100.0 * blocker.share);
  const bool is_late = budget.cut_short();
  if (!is_late) {
    if (const std::string more = unreachable_sentence(least_length(plane_, budget), plane_.problem()); !more.empty()) reason += "; " + more;
  }
  PlanningFailure failed = failure(is_late ? Status::timed_out : Status::no_path, reason);
  failed.failure.pose = reached;
  if (!blocker.name.empty()) failed.failure.point = blocker.point;
  if (answer.nearest.size() > 1) failed.alternatives.back().poses = poses_along(path_along_states(query.steering, answer.nearest, query.start, std::nullopt));
  failed.search = answer.picture;
  return failed;
}

PlanningResult StatePlanning::plan(const std::function<StateAnswer(const StateQuery&)>& search, bool shortens, std::uint64_t seed, Budget& budget) const {
  const Problem& problem = plane_.problem();
  if (std::string reason = space_refusal(problem, kind_, name_, label_); !reason.empty()) return tl::unexpected{failure(Status::no_path, reason)};
  if (budget.exhausted()) {
    return tl::unexpected{budget.canceled() ? failure(Status::canceled, "canceled before the search began")
                                            : failure(Status::timed_out, fmt::format("the {:g} s of its budget were over before the search began", budget.limits().seconds.value_or(0.0)))};
  }
  const std::unique_ptr<const Steering> steering = make_steering(problem, kind_, options_);
  if (steering->between(problem.start(), problem.goal()).empty()) return tl::unexpected{failure(Status::no_path, "start and goal are the same pose, there is nothing to drive")};
  const std::int64_t left = budget.evaluations_left().value_or(no_limit);
  MotionTest test{problem, {no_limit, left, options_.resolution}, budget};
  const bool backwards_too = kind_ != SteeringKind::dubins;
  const StateEnd start = end_of_search(test, problem.start(), true, backwards_too), goal = end_of_search(test, problem.goal(), false, backwards_too);
  StateQuery query{*steering, test, start.pose, goal.pose};
  query.region = search_region(problem, steering->is_curve() ? turning_radius(problem, options_) : 0.0, steering->is_curve());
  query.motions = shortens && left != no_limit ? left - left / 10 : left;
  const StateAnswer answer = search(query);
  if (budget.canceled() || answer.states.empty()) {
    budget.count_evaluations(std::max<std::int64_t>(1, test.motions()));
    if (budget.canceled()) return tl::unexpected{failure(Status::canceled, fmt::format("canceled after {} were tested", grid::counted(test.motions(), "motion")))};
    return tl::unexpected{not_found(query, answer, budget)};
  }

  const Path found = path_along_states(*steering, answer.states, query.start, query.goal);
  Path middle = found;
  if (shortens && steering->is_curve()) {
    middle = shortened(found, *steering, test, shortcuts, seed);
  } else if (shortens) {
    middle = path_along_states(*steering, shortened(answer.states, *steering, test, shortcuts, seed), query.start, query.goal);
  }
  budget.count_evaluations(std::max<std::int64_t>(1, test.motions()));
  Planned planned;
  planned.path = with_runs(*steering, start, middle, goal);
  planned.search = answer.picture;
  const std::string name = fmt::format("{}, {}", space_word(kind_), label_);
  const double metres = length(planned.path), before = length(found);
  const bool is_other = std::abs(length(middle) - before) > 1e-9 || middle.pieces.size() != found.pieces.size();
  if (is_other) planned.alternatives.push_back(alternative(name, with_runs(*steering, start, found, goal), false));
  planned.alternatives.push_back(alternative(is_other ? "as driven" : name, planned.path, true));
  std::vector<std::string>& text = planned.explanation;
  text.push_back(fmt::format("This is the path of a sampling planner, {} with {}: another seed gives another path. {}; {} of the footprint and {} were tested.",
                             label_, steering->words(), answer.found, grid::counted(test.placements(), "placement"), grid::counted(test.motions(), "motion")));
  if (is_other) text.push_back(fmt::format("Motions between places on it that cost less took the place of what lay between: {:.3f} m, {:.3f} m before.", length(middle), before));
  if (answer.is_least && !is_other) text.push_back("It is the least costly one that such motions can make between its ends.");
  if (start.run || goal.run) {
    text.push_back(fmt::format("It leads straight where the footprint just keeps its clearance: {}{}{}.", start.run ? fmt::format("{:.2f} m from the start", length(*start.run)) : std::string{},
                               start.run && goal.run ? ", " : "", goal.run ? fmt::format("{:.2f} m into the goal", length(*goal.run)) : std::string{}));
  }
  const WayCounts counts = counts_of(planned.path);
  text.push_back(fmt::format("It is {:.3f} m long, with {}.", metres, changes_words(counts, !steering->is_curve())));
  if (std::string jumps = jumps_sentence(counts); !jumps.empty()) text.push_back(std::move(jumps));
  if (std::string bound = bound_sentence(least_length(plane_, budget), metres); !bound.empty()) text.push_back(std::move(bound));
  return planned;
}

}  // namespace waywright
