#include "waywright/planner/tree/whale_steering.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double blocked_weight = 10.0;

}  // namespace

WhaleSteering::WhaleSteering(const PlaneSpace& space, const WhaleSteeringOptions& options)
    : space_{space}, options_{options}, per_radius_{options.sample_weight / options.radius}, per_diagonal_{options.goal_weight / norm(space.region().high - space.region().low)} {
  const auto population = static_cast<std::size_t>(options.population);
  for (std::vector<double>* values : {&x_, &y_, &bases_}) values->resize(population);
  candidates_.reserve(population);
  moves_.resize(population * static_cast<std::size_t>(options.iterations));
  spirals_.resize(moves_.size() + 1);
  spiral_moves_.resize(moves_.size() + 1);
}

double WhaleSteering::cost(Vec2 x, Vec2 near, Vec2 sample, Vec2 goal) const {
  double sum = per_radius_ * distance(x, sample) + per_diagonal_ * distance(x, goal);
  if (!space_.is_free(near, x)) sum += options_.near_weight + (space_.is_free(x) ? 0.0 : blocked_weight);
  if (!space_.is_free(x, goal)) sum += options_.view_weight;
  return sum;
}

void WhaleSteering::prepare_view(Vec2 goal) {
  const bool is_same = has_goal_ && last_goal_ == goal;
  if (is_same && !(view_.is_ready() && view_.from() == goal)) view_ = View{space_, goal};
  has_view_ = is_same;
  has_goal_ = true;
  last_goal_ = goal;
}

/// The cost of a place, term by term, no further than to where it is `enough` at least.
double WhaleSteering::whole_cost(const Aim& aim, const Candidate& candidate, double enough) {
  const Vec2 x = agent(candidate.agent);
  double sum = bases_[candidate.agent];
  ++lines_;
  if (!space_.is_free(aim.near, x, distance(aim.near, x), aim.room, space_.room(x))) {
    sum += options_.near_weight;
    if (sum >= enough) return sum;
    if (!space_.is_free(x)) sum += blocked_weight;
    if (sum >= enough) return sum;
  }
  if (candidate.goal == View::Seen::yes) return sum;
  if (candidate.goal == View::Seen::not_told) {
    ++lines_;
    if (space_.is_free(x, aim.goal)) return sum;
  }
  return sum + options_.view_weight;
}

/// The best of all agents and of what was best before; of equal ones the first. What is cheap is told of all, then those that could be the best are looked at, the
/// most promising one first, until no other one can be better.
void WhaleSteering::look(const Aim& aim, Best& best) {
  const std::size_t population = x_.size();
  evaluations_ += static_cast<std::int64_t>(population);
  for (std::size_t i = 0; i < population; ++i) bases_[i] = per_radius_ * distance(agent(i), aim.sample) + per_diagonal_ * distance(agent(i), aim.goal);
  candidates_.clear();
  for (std::size_t i = 0; i < population; ++i) {
    double least = bases_[i];
    if (!(least < best.cost)) continue;
    const View::Seen goal = has_view_ ? view_.seen(agent(i)) : View::Seen::not_told;
    if (goal == View::Seen::no) least += options_.view_weight;
    if (least < best.cost) candidates_.push_back({least, i, goal});
  }
  std::size_t best_agent = population;
  while (!candidates_.empty()) {
    std::size_t next = 0;
    for (std::size_t k = 1; k < candidates_.size(); ++k) {
      if (candidates_[k].least < candidates_[next].least) next = k;
    }
    const Candidate candidate = candidates_[next];
    candidates_[next] = candidates_.back();
    candidates_.pop_back();
    if (candidate.least > best.cost) break;
    const bool is_before = best_agent < population && candidate.agent < best_agent;  // of this population, where equal costs go to the first
    const double enough = is_before ? std::nextafter(best.cost, std::numeric_limits<double>::infinity()) : best.cost;
    const double cost = whole_cost(aim, candidate, enough);
    if (!(cost < enough)) continue;
    best = {agent(candidate.agent), cost};
    best_agent = candidate.agent;
  }
}

Vec2 WhaleSteering::into_disc(Vec2 x, Vec2 middle) const {
  const Vec2 off = x - middle;
  const double squared = squared_norm(off);
  // The root is taken whether it is needed or not, which cannot be guessed: of the square of the radius where it is not.
  const double most = options_.radius * options_.radius;
  const Vec2 moved = middle + (options_.radius / std::sqrt(std::max(squared, most))) * off;
  const bool is_outside = squared > most;
  return {is_outside ? moved.x : x.x, is_outside ? moved.y : x.y};
}

/// Of all iterations: what is drawn does not depend on what is found.
void WhaleSteering::draw_moves(Random& random) {
  std::size_t spirals = 0;
  std::uint32_t m = 0;
  for (int t = 0; t < options_.iterations; ++t) {
    const double reach = whale_reach(options_.whale.start, static_cast<std::size_t>(t), static_cast<std::size_t>(options_.iterations));
    for (int i = 0; i < options_.population; ++i, ++m) {
      const WhaleDraws draws = WhaleDraws::from(random);
      const bool is_spiral = is_whale_spiral(options_.whale, draws);
      const WhaleStep step = whale_step_but_spiral(options_.whale, reach, draws);
      Move& move = moves_[m];
      move.step = {is_spiral ? WhaleMove::spiral : step.move, step.factor, is_spiral ? 1.0 : step.scale};
      spirals_[spirals] = draws.l;  // each is written, and stays where it is one: no branch to guess
      spiral_moves_[spirals] = m;
      spirals += is_spiral ? 1 : 0;
      if (move.step.move == WhaleMove::search) move.other = static_cast<std::size_t>(random.integer(0, options_.population - 1));
    }
  }
  whale_spirals(options_.whale, {spirals_.data(), spirals});
  for (std::size_t k = 0; k < spirals; ++k) moves_[spiral_moves_[k]].step.factor = spirals_[k];
}

Vec2 WhaleSteering::aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) {
  prepare_view(goal);
  const Aim aim{near, sample, goal, space_.room(near)};
  Best best{sample, std::numeric_limits<double>::infinity()};
  const std::size_t population = x_.size();
  for (std::size_t i = 0; i < population; ++i) {
    Vec2 q{};
    do q = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    while (squared_norm(q) > 1.0);
    const Vec2 at = sample + options_.radius * q;
    x_[i] = at.x;
    y_[i] = at.y;
  }
  draw_moves(random);
  look(aim, best);
  const std::array<double, 2> low{sample.x - options_.radius, sample.y - options_.radius}, high{sample.x + options_.radius, sample.y + options_.radius};
  const Move* move = moves_.data();
  for (int t = 0; t < options_.iterations; ++t) {
    const Vec2 leader = best.at;
    for (std::size_t i = 0; i < population; ++i, ++move) {
      const Vec2 target = move->step.move == WhaleMove::search ? agent(move->other) : leader;
      std::array<double, 2> x{x_[i], y_[i]};
      make_whale_step(move->step, std::array{target.x, target.y}, low, high, x);
      const Vec2 at = into_disc({x[0], x[1]}, sample);
      x_[i] = at.x;
      y_[i] = at.y;
    }
    look(aim, best);
  }
  return best.at;
}

}  // namespace waywright
