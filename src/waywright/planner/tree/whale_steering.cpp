#include "waywright/planner/tree/whale_steering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double blocked_weight = 10.0;
constexpr std::size_t most_drawn = 100;  // swarms

}  // namespace

WhaleSteering::WhaleSteering(const PlaneSpace& space, const WhaleSteeringOptions& options)
    : space_{space},
      options_{options},
      population_{static_cast<std::size_t>(options.population)},
      per_radius_{options.sample_weight / options.radius},
      per_diagonal_{options.goal_weight / norm(space.region().high - space.region().low)},
      rounding_{1e-6 * (options.sample_weight + options.radius * per_diagonal_)} {
  const std::size_t iterations = static_cast<std::size_t>(options.iterations), moves = population_ * iterations;
  for (std::vector<float>* values : {&x_, &y_, &before_x_, &before_y_, &keys_}) values->resize(population_ + whale_lanes::spare);
  for (std::vector<float>* values : {&reaches_, &factors_, &scales_}) values->resize(moves + whale_lanes::spare);
  others_.resize(moves + whale_lanes::spare);
  promising_.resize(population_);
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
  flight_.per_radius = static_cast<float>(per_radius_);
}

double WhaleSteering::cost(Vec2 x, Vec2 near, Vec2 sample, Vec2 goal) const {
  double sum = per_radius_ * distance(x, sample) + per_diagonal_ * distance(x, goal);
  if (!space_.is_free(near, x)) sum += options_.near_weight + (space_.is_free(x) ? 0.0 : blocked_weight);
  if (!space_.is_free(x, goal)) sum += options_.view_weight;
  return sum;
}

void WhaleSteering::prepare_view(Vec2 goal) {
  const bool is_same = has_goal_ && last_goal_ == goal;
  if (is_same && !(view_.is_ready() && view_.from() == goal)) view_ = PlaneView{space_, goal};
  has_view_ = is_same;
  has_goal_ = true;
  last_goal_ = goal;
}

/// What was in the way of one line is often in the way of the next one, at the same distance: that is looked at first.
bool WhaleSteering::is_surely_hit(const Aim& aim, const Candidate& candidate) const {
  const Vec2 along = (1.0 / candidate.from_near) * (candidate.at - aim.near);
  bool is_hit = false;
  for (const double hit : hits_) is_hit |= (hit < candidate.from_near) & space_.is_surely_blocked(aim.near + hit * along, 0.0);
  return is_hit;
}

bool WhaleSteering::is_seen_from_tree(const Aim& aim, const Candidate& candidate) {
  const double length = candidate.from_near;
  if (aim.room > length) return true;
  double hit = -1.0;
  if (space_.is_free(aim.near, candidate.at, length, aim.room, space_.room(candidate.at), hit)) return true;
  if (hit >= 0.0) {
    hits_[1] = hits_[0];
    hits_[0] = hit;
  }
  return false;
}

/// The cost of a place, term by term, no further than to where it is more than `enough`.
double WhaleSteering::whole_cost(const Aim& aim, const Candidate& candidate, double enough) {
  const Vec2 x = candidate.at;
  const bool is_hidden = candidate.goal == PlaneView::Seen::no;
  const double hidden = is_hidden ? options_.view_weight : 0.0;
  double sum = candidate.base;
  if (sum + hidden > enough) return sum + hidden;
  if (candidate.is_hit || !is_seen_from_tree(aim, candidate)) {
    sum += options_.near_weight;
    if (sum + hidden > enough) return sum + hidden;
    if (!space_.is_free(x)) sum += blocked_weight;
    if (sum + hidden > enough) return sum + hidden;
  }
  if (candidate.goal == PlaneView::Seen::not_told) {
    ++lines_;
    if (has_view_ ? view_.sees_beyond(x) : space_.is_free(x, aim.goal)) return sum;
  }
  return candidate.goal == PlaneView::Seen::yes ? sum : sum + options_.view_weight;
}

/// Keys that are not under it cannot lead to a lesser cost.
float WhaleSteering::enough(const Aim& aim, const Best& best) const {
  const double most = best.cost - aim.same;
  return static_cast<float>(most + rounding_ + 1e-6 * std::abs(most));
}

/// Replaces the best where an agent is better; of equal ones of this population the first is. `best_agent`: of this population, or its size where it is none of it.
bool WhaleSteering::try_out(const Aim& aim, Promising promising, float most, std::size_t best_agent, Best& best) {
  const Vec2 off{x_[promising.agent], y_[promising.agent]};
  Candidate c;
  c.at = aim.sample + off;
  c.from_near = distance(aim.near, c.at);
  ++lines_;
  c.is_hit = !(aim.room > c.from_near) && is_surely_hit(aim, c);
  if (c.is_hit && best.cost < options_.near_weight) return false;  // costs that much at least
  c.goal = aim.seen;
  if (promising.is_goal_open) {
    c.goal = view_.seen(c.at);
    if (c.goal == PlaneView::Seen::no && !(promising.key + static_cast<float>(options_.view_weight) < most)) return false;
  }
  c.base = per_radius_ * distance(c.at, aim.sample) + per_diagonal_ * distance(c.at, aim.goal);
  const double cost = whole_cost(aim, c, best.cost);
  if (!(cost < best.cost || (cost == best.cost && promising.agent < best_agent && best_agent < population_))) return false;
  best = {c.at, off, cost};
  return true;
}

/// The best of all agents and of what was best before. Agents have keys that are no more than what they cost, but for what is the same of all: the goal is no nearer than
/// along the straight line from the sample to it. They are looked at in this order, until no other one can be better. What is enough() then.
float WhaleSteering::look(const Aim& aim, Best& best) {
  const bool is_open = has_view_ && aim.seen == PlaneView::Seen::not_told;
  const auto first = static_cast<std::uint32_t>(flight_.least);
  float most = flight_.enough;
  std::size_t best_agent = population_;
  if (try_out(aim, {keys_[first], first, is_open}, most, best_agent, best)) {
    best_agent = first;
    most = enough(aim, best);
  }
  keys_[first] = std::numeric_limits<float>::infinity();
  Promising* const promising = promising_.data();
  std::size_t count = 0;
  for (std::size_t i = 0; i < population_; ++i) {  // each is written, and stays where it could be better: no branch to guess
    promising[count] = {keys_[i], static_cast<std::uint32_t>(i), is_open};
    count += keys_[i] < most ? 1 : 0;
  }
  while (count > 0) {
    std::size_t least = 0;
    for (std::size_t k = 1; k < count; ++k) least = promising[k].key < promising[least].key ? k : least;
    const Promising next = promising[least];
    if (!(next.key < most)) break;
    promising[least] = promising[--count];
    if (!try_out(aim, next, most, best_agent, best)) continue;
    best_agent = next.agent;
    most = enough(aim, best);
  }
  return most;
}

Vec2 WhaleSteering::aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) {
  prepare_view(goal);
  sample_ = sample;
  hits_.fill(std::numeric_limits<double>::infinity());
  Aim aim{near, sample, goal, space_.room(near), has_view_ ? view_.seen_from_all(sample, options_.radius) : PlaneView::Seen::not_told, distance(sample, goal), 0.0};
  aim.same = per_diagonal_ * aim.away + (aim.seen == PlaneView::Seen::no ? options_.view_weight : 0.0);
  const Vec2 along = (aim.away > 0.0 ? per_diagonal_ / aim.away : 0.0) * (sample - goal);
  flight_.along_x = static_cast<float>(along.x);
  flight_.along_y = static_cast<float>(along.y);
  drawing_.counter = random.take(whale_lanes::drawn(drawing_.agents, drawing_.moves));
  lanes_.draw(drawing_);
  Best best{sample, {}, std::numeric_limits<double>::infinity()};
  flight_.first = 0;
  flight_.enough = enough(aim, best);
  lanes_.rank(flight_);
  while (true) {
    if (flight_.is_promising) {
      flight_.enough = look(aim, best);
      flight_.leader_x = static_cast<float>(best.off.x);
      flight_.leader_y = static_cast<float>(best.off.y);
    }
    if (!(flight_.first < flight_.moves)) break;
    lanes_.fly(flight_);
  }
  evaluations_ += options_.population * (options_.iterations + 1);
  return best.at;
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
