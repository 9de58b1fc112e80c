#include "waywright/planner/tree/whale_steering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {

using whale_lanes::Flight;
using whale_lanes::most_shadows;
using whale_lanes::Place;
using whale_lanes::Shadow;

namespace {

static_assert(whale_lanes::directions == PlaneView::count);
// A share of the radius: so far from the goal rounding is 4e-6 of a squared distance at most, and off by much less than a direction.
constexpr double at_goal_share = 0.05;
constexpr double at_goal = 0.01;  // m, at least
constexpr float blocked_weight = 10.0F;
constexpr std::size_t most_drawn = 100;  // swarms

}  // namespace

WhaleSteering::WhaleSteering(const PlaneSpace& space, const WhaleSteeringOptions& options) : space_{space}, options_{options}, population_{static_cast<std::size_t>(options.population)} {
  const std::size_t iterations = static_cast<std::size_t>(options.iterations), moves = population_ * iterations;
  for (std::vector<float>* values : {&x_, &y_, &before_x_, &before_y_, &keys_, &bounds_}) values->resize(population_ + whale_lanes::spare);
  for (std::vector<float>* values : {&reaches_, &factors_, &scales_}) values->resize(moves + whale_lanes::spare);
  others_.resize(moves + whale_lanes::spare);
  for (std::vector<std::int32_t>* values : {&is_dark_, &is_known_}) values->resize(population_ + whale_lanes::spare);
  drawing_.agents = flight_.agents = population_;
  drawing_.moves = flight_.moves = moves;
  drawing_.spiral = static_cast<float>(options.whale.spiral);
  drawing_.choice = static_cast<float>(options.whale.choice);
  drawing_.threshold = static_cast<float>(options.whale.threshold);
  drawing_.radius = flight_.radius = static_cast<float>(options.radius);
  for (std::size_t m = 0; m < moves; ++m) {
    reaches_[m] = static_cast<float>(whale_reach(options.whale.start, m / population_, iterations));
    if (reaches_[m] >= drawing_.threshold) flight_.searching = m + 1;  // |A| is no greater than it
  }
  drawing_.reach = reaches_.data();
  drawing_.x = flight_.x = x_.data();
  drawing_.y = flight_.y = y_.data();
  drawing_.factor = factors_.data();
  drawing_.scale = scales_.data();
  drawing_.other = others_.data();
  flight_.factor = factors_.data();
  flight_.scale = scales_.data();
  flight_.other = others_.data();
  flight_.before_x = before_x_.data();
  flight_.before_y = before_y_.data();
  flight_.keys = keys_.data();
  flight_.bounds = bounds_.data();
  flight_.is_dark = is_dark_.data();
  flight_.is_known = is_known_.data();
  flight_.per_radius = static_cast<float>(options.sample_weight / options.radius);
  flight_.per_goal = static_cast<float>(options.goal_weight / norm(space.region().high - space.region().low));
  flight_.dark = static_cast<float>(options.near_weight);
  flight_.hidden = static_cast<float>(options.view_weight);
  const double told_beyond = std::max(at_goal, at_goal_share * options.radius);
  flight_.at_goal_squared = static_cast<float>(told_beyond * told_beyond);
}

float WhaleSteering::cost(Place off, Vec2 near, Vec2 sample, Vec2 goal) const {
  const Vec2 x = sample + Vec2{off.x, off.y}, from = goal - sample;
  const float to_x = off.x - static_cast<float>(from.x), to_y = off.y - static_cast<float>(from.y);
  float sum = flight_.per_radius * std::sqrt(off.x * off.x + off.y * off.y) + flight_.per_goal * std::sqrt(to_x * to_x + to_y * to_y);
  if (!space_.is_free(near, x)) {
    sum += flight_.dark;
    if (!space_.is_free(x)) sum += blocked_weight;
  }
  if (!space_.is_free(x, goal)) sum += flight_.hidden;
  return sum;
}

void WhaleSteering::prepare_view(Vec2 goal) {
  const bool is_same = has_goal_ && last_goal_ == goal;
  if (is_same && !(view_.is_ready() && view_.from() == goal)) view_ = PlaneView{space_, goal};
  has_view_ = is_same;
  has_goal_ = true;
  last_goal_ = goal;
}

/// Of a length that is measured in single precision, a little less; negative where nothing is left.
float WhaleSteering::square_of_less(double length) const {
  const double less = 0.99999 * length - 1e-6 * options_.radius;
  return less > 0.0 ? static_cast<float>(less * less) : -1.0F;
}

/// Lines that come as near to the hit as all is blocked around it need not be looked along. A little before it or behind it may be a place that hides more.
void WhaleSteering::add_shadow(const Aim& aim, Vec2 along, double hit, double blocked) {
  const double first = hit, size = blocked;
  for (const double further : {-0.5, 0.5, 1.0, 1.5}) {
    const double at = first + further * size, around = space_.blocked_around(aim.near + at * along);
    if (around * hit > blocked * at) hit = at, blocked = around;
  }
  const float squared = square_of_less(0.999 * blocked - 1e-5 * hit);
  if (squared < 0.0F) return;
  Shadow& shadow = flight_.shadows[oldest_shadow_];
  shadow = {static_cast<float>(hit * along.x), static_cast<float>(hit * along.y), squared};
  oldest_shadow_ = (oldest_shadow_ + 1) % most_shadows;
  flight_.shadow_count = std::min(flight_.shadow_count + 1, most_shadows);
  lanes_.shade(flight_, shadow);
}

bool WhaleSteering::is_seen_from_tree(const Aim& aim, Place off, Vec2 at) {
  const double length = distance(aim.near, at);
  if (aim.room > length) return true;
  ++lines_;
  PlaneSpace::Line line;
  if (!space_.is_free(aim.near, at, length, aim.room, space_.room(at), line)) {
    if (line.hit > 0.0) add_shadow(aim, (1.0 / length) * (at - aim.near), line.hit, line.blocked);
    return false;
  }
  if (const float squared = square_of_less(line.around); squared > 0.0F) {
    flight_.lit_x = off.x;
    flight_.lit_y = off.y;
    flight_.lit_around_squared = squared;
  }
  return true;
}

bool WhaleSteering::sees_goal(const Aim& aim, Vec2 at, PlaneView::Seen told) {
  if (told != PlaneView::Seen::not_told) return told == PlaneView::Seen::yes;
  ++lines_;
  return has_view_ ? view_.sees_beyond(at) : space_.is_free(at, aim.goal);
}

/// Replaces the best where the agent is better, or as good and the first of equals. Its cost is looked at term by term, no further than to where it is too much.
bool WhaleSteering::try_out(const Aim& aim, std::size_t agent, bool is_first_of_equals, Best& best) {
  const Place off{x_[agent], y_[agent]};
  const Vec2 at = aim.sample + Vec2{off.x, off.y};
  const auto is_too_much = [&](float cost) { return is_first_of_equals ? cost > best.cost : cost >= best.cost; };
  PlaneView::Seen goal = aim.seen;
  if (goal == PlaneView::Seen::not_told && has_view_) {
    goal = view_.seen(at);
    if (goal == PlaneView::Seen::no && is_too_much(std::max(bounds_[agent], keys_[agent] + flight_.hidden))) return false;
  }
  const float at_last = goal == PlaneView::Seen::no ? flight_.hidden : 0.0F;
  float cost = keys_[agent];
  if (is_dark_[agent] != 0 || !is_seen_from_tree(aim, off, at)) {
    cost += flight_.dark;
    if (is_too_much(cost + at_last)) return false;
    if (!space_.is_free(at)) cost += blocked_weight;
  }
  if (is_too_much(cost + at_last)) return false;
  if (!sees_goal(aim, at, goal)) cost += flight_.hidden;
  if (is_too_much(cost)) return false;
  best = {off, cost};
  return true;
}

/// The best of all agents and of what was best before; of equal ones what was before, then the first agent. They are looked at in the order of their bounds, until no other
/// one can be better.
void WhaleSteering::look(const Aim& aim, Best& best) {
  std::size_t best_agent = 0, next = flight_.least;  // 0 also where the best is none of these: then no one comes first of equals
  while (true) {
    const bool is_first_of_equals = next < best_agent;
    if (is_first_of_equals ? bounds_[next] > best.cost : bounds_[next] >= best.cost) return;
    if (try_out(aim, next, is_first_of_equals, best)) best_agent = next;
    bounds_[next] = std::numeric_limits<float>::infinity();
    next = 0;
    for (std::size_t i = 1; i < population_; ++i) next = bounds_[i] < bounds_[next] ? i : next;
  }
}

Vec2 WhaleSteering::aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) {
  prepare_view(goal);
  sample_ = sample;
  const Aim aim{near, sample, goal, space_.room(near), has_view_ ? view_.seen_from_all(sample, options_.radius) : PlaneView::Seen::not_told};
  const Vec2 from_goal = goal - sample, from_near = near - sample;
  flight_.goal_x = static_cast<float>(from_goal.x);
  flight_.goal_y = static_cast<float>(from_goal.y);
  flight_.begin_x = static_cast<float>(from_near.x);
  flight_.begin_y = static_cast<float>(from_near.y);
  flight_.goal = !has_view_                          ? Flight::Goal::not_told
                 : aim.seen == PlaneView::Seen::no  ? Flight::Goal::is_hidden
                 : aim.seen == PlaneView::Seen::yes ? Flight::Goal::is_seen
                                                    : Flight::Goal::told_by_view;
  if (has_view_) {
    flight_.seen_squares = view_.seen_squares();
    flight_.hidden_squares = view_.hidden_squares();
  }
  flight_.lit_squared = square_of_less(aim.room);
  flight_.lit_around_squared = -1.0F;
  flight_.shadow_count = oldest_shadow_ = 0;
  drawing_.counter = random.take(whale_lanes::drawn(drawing_.agents, drawing_.moves));
  lanes_.draw(drawing_);
  Best best{{}, std::numeric_limits<float>::infinity()};
  flight_.first = 0;
  flight_.enough = best.cost;
  flight_.leader_x = flight_.leader_y = 0.0F;
  lanes_.rank(flight_);
  while (true) {
    best = {{flight_.leader_x, flight_.leader_y}, flight_.enough};
    if (flight_.is_promising) {
      look(aim, best);
      flight_.enough = best.cost;
      flight_.leader_x = best.off.x;
      flight_.leader_y = best.off.y;
    }
    if (!(flight_.first < flight_.moves)) break;
    lanes_.fly(flight_);
  }
  evaluations_ += options_.population * (options_.iterations + 1);
  return sample + Vec2{best.off.x, best.off.y};
}

/// Where there are too many every other one is left out, from then on, too.
void WhaleSteering::grown(std::int64_t samples) {
  if (extensions_++ % each_drawn_ != 0) return;
  if (drawn_.size() == most_drawn) {
    std::size_t kept = 1;
    for (std::size_t i = 2; i < drawn_.size(); i += 2) drawn_[kept++] = std::move(drawn_[i]);
    drawn_.resize(kept);
    each_drawn_ *= 2;
    if ((extensions_ - 1) % each_drawn_ != 0) return;
  }
  Drawn& drawn = drawn_.emplace_back();
  drawn.samples = static_cast<std::uint32_t>(samples);
  for (std::size_t i = 0; i < population_; ++i) drawn.agents.push_back(sample_ + Vec2{x_[i], y_[i]});
}

void WhaleSteering::draw(SearchPicture& picture) const {
  for (const Drawn& drawn : drawn_) {
    SearchPicture::Swarm& swarm = picture.swarms.emplace_back();
    swarm.born = drawn.samples;
    for (const Vec2 at : drawn.agents) swarm.agents.push_back({at});
  }
}

}  // namespace waywright
