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
      per_diagonal_{options.goal_weight / norm(space.region().high - space.region().low)} {
  const Box& region = space.region();
  const double farthest = std::max(std::max(std::abs(region.low.x), std::abs(region.low.y)), std::max(std::abs(region.high.x), std::abs(region.high.y))) + options.radius;
  rounding_ = 1e-14 * (per_radius_ + per_diagonal_) * farthest + 1e-12 * (options.sample_weight + options.goal_weight);
  const std::size_t iterations = static_cast<std::size_t>(options.iterations), moves = population_ * iterations;
  for (std::vector<double>* values : {&x_, &y_, &new_x_, &new_y_, &keys_}) values->resize(population_ + whale_lanes::spare);
  for (std::vector<double>* values : {&reaches_, &factors_, &scales_}) values->resize(moves + whale_lanes::spare);
  seen_.resize(population_, PlaneView::Seen::not_told);
  drawing_.agents = population_;
  drawing_.moves = moves;
  for (std::size_t m = 0; m < moves; ++m) {
    reaches_[m] = whale_reach(options.whale.start, m / population_, iterations);
    if (reaches_[m] >= options.whale.threshold) drawing_.searching = m + 1;  // |A| is no greater than it
  }
  searches_.resize(drawing_.searching + whale_lanes::spare);
  drawing_.reach = reaches_.data();
  drawing_.spiral = options.whale.spiral;
  drawing_.choice = options.whale.choice;
  drawing_.threshold = options.whale.threshold;
  drawing_.radius = options.radius;
  drawing_.factor = factors_.data();
  drawing_.scale = scales_.data();
  drawing_.searches = searches_.data();
  ranking_.agents = population_;
  ranking_.per_radius = per_radius_;
  ranking_.keys = keys_.data();
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
bool WhaleSteering::is_seen_from_tree(const Aim& aim, const Candidate& candidate) {
  ++lines_;
  const Vec2 x = candidate.at;
  const double length = candidate.from_near;
  if (aim.room + candidate.room > length) return true;
  const Vec2 along = (1.0 / length) * (x - aim.near);
  bool is_hit = false;
  for (const double hit : hits_) is_hit |= (hit < length) & space_.is_surely_blocked(aim.near + hit * along, 0.0);
  if (is_hit) return false;
  double hit = -1.0;
  if (space_.is_free(aim.near, x, length, aim.room, candidate.room, hit)) return true;
  if (hit >= 0.0) {
    hits_[1] = hits_[0];
    hits_[0] = hit;
  }
  return false;
}

/// The cost of a place, term by term, no further than to where it is `enough` at least.
double WhaleSteering::whole_cost(const Aim& aim, const Candidate& candidate, double enough) {
  const Vec2 x = candidate.at;
  double sum = candidate.base;
  if (!is_seen_from_tree(aim, candidate)) {
    sum += options_.near_weight;
    if (sum >= enough) return sum;
    if (!space_.is_free(x)) sum += blocked_weight;
    if (sum >= enough) return sum;
  }
  if (candidate.goal == PlaneView::Seen::yes) return sum;
  if (candidate.goal == PlaneView::Seen::not_told) {
    ++lines_;
    if (has_view_ ? view_.sees_beyond(x) : space_.is_free(x, aim.goal)) return sum;
  }
  return sum + options_.view_weight;
}

/// What is cheap of an agent's cost.
void WhaleSteering::told(const Aim& aim, Candidate& c) const {
  c.at = aim.sample + Vec2{x_[c.agent], y_[c.agent]};
  c.base = per_radius_ * distance(c.at, aim.sample) + per_diagonal_ * distance(c.at, aim.goal);
  c.room = space_.room(c.at);
  c.from_near = distance(aim.near, c.at);
  c.goal = aim.is_hidden ? PlaneView::Seen::no : seen_[c.agent];
  c.least = c.goal == PlaneView::Seen::no ? c.base + options_.view_weight : c.base;
}

/// The best of all agents and of what was best before; of equal ones the first. Agents have keys that are no more than what they cost, but for what is the same of all:
/// the goal is no nearer than along the straight line from the sample to it. They are looked at in this order, until no other one can be better.
void WhaleSteering::look(const Aim& aim, Best& best) {
  evaluations_ += options_.population;
  ranking_.x = x_.data();
  ranking_.y = y_.data();
  lanes_.rank(ranking_);
  const double same = per_diagonal_ * aim.away + (aim.is_hidden ? options_.view_weight : 0.0) - rounding_;
  double* const keys = keys_.data();
  std::size_t next = ranking_.least;
  const auto rank_again = [&] {
    next = 0;
    for (std::size_t i = 1; i < population_; ++i) next = keys[i] < keys[next] ? i : next;
  };
  if (!aim.is_hidden) {
    for (std::size_t i = 0; i < population_; ++i) {
      if (!(keys[i] + same < best.cost)) continue;
      seen_[i] = has_view_ ? view_.seen(aim.sample + Vec2{x_[i], y_[i]}) : PlaneView::Seen::not_told;
      if (seen_[i] == PlaneView::Seen::no) keys[i] += options_.view_weight;
    }
    rank_again();
  }
  std::uint32_t best_agent = std::numeric_limits<std::uint32_t>::max();
  while (keys[next] + same < best.cost) {
    keys[next] = std::numeric_limits<double>::infinity();
    Candidate candidate;
    candidate.agent = static_cast<std::uint32_t>(next);
    told(aim, candidate);
    const bool is_before = candidate.agent < best_agent && best_agent < population_;  // of this population, where equal costs go to the first
    const double enough = is_before ? std::nextafter(best.cost, std::numeric_limits<double>::infinity()) : best.cost;
    if (candidate.least < enough) {
      const double cost = whole_cost(aim, candidate, enough);
      if (cost < enough) {
        best = {candidate.at, {x_[candidate.agent], y_[candidate.agent]}, cost};
        best_agent = candidate.agent;
      }
    }
    bool is_any = false;
    for (std::size_t i = 0; i < population_; ++i) is_any |= keys[i] + same < best.cost;
    if (!is_any) break;
    rank_again();
  }
}

Vec2 WhaleSteering::aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) {
  prepare_view(goal);
  sample_ = sample;
  hits_.fill(std::numeric_limits<double>::infinity());
  Aim aim{near, sample, goal, space_.room(near), has_view_ && view_.hides(sample, options_.radius), sample - goal};
  aim.away = norm(aim.from_goal);
  aim.from_goal = (aim.away > 0.0 ? 1.0 / aim.away : 0.0) * aim.from_goal;
  ranking_.along_x = per_diagonal_ * aim.from_goal.x;
  ranking_.along_y = per_diagonal_ * aim.from_goal.y;
  drawing_.counter = random.take(whale_lanes::drawn(drawing_.agents, drawing_.moves));
  drawing_.x = x_.data();
  drawing_.y = y_.data();
  lanes_.draw(drawing_);
  Best best{sample, {}, std::numeric_limits<double>::infinity()};
  look(aim, best);
  whale_lanes::Moving moving;
  moving.agents = population_;
  moving.radius = options_.radius;
  const whale_lanes::Search* search = searches_.data();
  const whale_lanes::Search* const searches_end = search + drawing_.searches_count;
  for (; moving.first < drawing_.moves; moving.first += population_) {
    moving.leader_x = best.off.x;
    moving.leader_y = best.off.y;
    moving.factor = factors_.data() + moving.first;
    moving.scale = scales_.data() + moving.first;
    moving.searches = search;
    while (search != searches_end && search->move < moving.first + population_) ++search;
    moving.searches_count = static_cast<std::size_t>(search - moving.searches);
    moving.x = x_.data();
    moving.y = y_.data();
    moving.new_x = new_x_.data();
    moving.new_y = new_y_.data();
    lanes_.move(moving);
    x_.swap(new_x_);
    y_.swap(new_y_);
    look(aim, best);
  }
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
