#include "waywright/planner/tree/whale_steering.hpp"

#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double blocked_weight = 10.0;
constexpr std::size_t most_drawn = 100;  // swarms

}  // namespace

WhaleSteering::WhaleSteering(const PlaneSpace& space, const WhaleSteeringOptions& options)
    : space_{space}, options_{options}, per_radius_{options.sample_weight / options.radius}, per_diagonal_{options.goal_weight / norm(space.region().high - space.region().low)} {
  const auto population = static_cast<std::size_t>(options.population);
  for (std::vector<double>* values : {&x_, &y_, &new_x_, &new_y_, &bases_}) values->resize(population);
  candidates_.reserve(population);
  const std::size_t moves = population * static_cast<std::size_t>(options.iterations);
  factors_.resize(moves);
  scales_.resize(moves);
  others_.resize(moves);
  spirals_.resize(moves + 1);
  spiral_moves_.resize(moves + 1);
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
  if (candidate.goal == PlaneView::Seen::yes) return sum;
  if (candidate.goal == PlaneView::Seen::not_told) {
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
  const double* const x = x_.data();
  const double* const y = y_.data();
  double* const bases = bases_.data();
  const auto root = [](double dx, double dy) { return std::sqrt(dx * dx + dy * dy); };
#pragma GCC ivdep
  for (std::size_t i = 0; i < population; ++i) bases[i] = per_radius_ * root(x[i] - aim.sample.x, y[i] - aim.sample.y) + per_diagonal_ * root(x[i] - aim.goal.x, y[i] - aim.goal.y);
  candidates_.clear();
  for (std::size_t i = 0; i < population; ++i) {
    double least = bases_[i];
    if (!(least < best.cost)) continue;
    const PlaneView::Seen goal = has_view_ ? view_.seen(agent(i)) : PlaneView::Seen::not_told;
    if (goal == PlaneView::Seen::no) least += options_.view_weight;
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
      factors_[m] = -step.factor;
      scales_[m] = is_spiral ? 1.0 : step.scale;
      others_[m] = none;
      spirals_[spirals] = draws.l;  // each is written, and stays where it is one: no branch to guess
      spiral_moves_[spirals] = m;
      spirals += is_spiral ? 1 : 0;
      if (!is_spiral && step.move == WhaleMove::search) others_[m] = static_cast<std::uint32_t>(random.integer(0, options_.population - 1));
    }
  }
  whale_spirals(options_.whale, {spirals_.data(), spirals});
  for (std::size_t k = 0; k < spirals; ++k) factors_[spiral_moves_[k]] = spirals_[k];
}

namespace {

/// Moves coordinate by coordinate as make_whale_step has it, then into the disc about the sample. All plain numbers, so that the compiler makes vectors of many.
struct Mover {
  Vec2 low, high, middle, sample;
  double radius;

  static double moved(double factor, double scale, double target, double low, double high, double middle, double x) {
    const double from_target = std::abs(scale * (target - middle) - (x - middle));
    const double wanted = target + factor * from_target;
    const double above = wanted < low ? low : wanted;
    return above > high ? high : above;
  }
  void operator()(double factor, double scale, double target_x, double target_y, double x, double y, double& to_x, double& to_y) const {
    const double at_x = moved(factor, scale, target_x, low.x, high.x, middle.x, x), at_y = moved(factor, scale, target_y, low.y, high.y, middle.y, y);
    const double off_x = at_x - sample.x, off_y = at_y - sample.y, squared = off_x * off_x + off_y * off_y, most = radius * radius;
    // The root is taken whether it is needed or not, which cannot be guessed: of the square of the radius where it is not.
    const double share = radius / std::sqrt(squared > most ? squared : most);
    to_x = squared > most ? sample.x + share * off_x : at_x;
    to_y = squared > most ? sample.y + share * off_y : at_y;
  }
};

}  // namespace

/// One iteration, agent after agent: whoever searches goes to where the other one is by then.
void WhaleSteering::move(std::size_t iteration, Vec2 leader, Vec2 sample) {
  const std::size_t population = x_.size(), first = iteration * population;
  const Vec2 reach{options_.radius, options_.radius};
  const Vec2 low = sample - reach, high = sample + reach;
  const Mover mover{low, high, {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}, sample, options_.radius};
  const double* const factors = factors_.data() + first;
  const double* const scales = scales_.data() + first;
  const double* const x = x_.data();
  const double* const y = y_.data();
  double* const new_x = new_x_.data();
  double* const new_y = new_y_.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < population; ++i) mover(factors[i], scales[i], leader.x, leader.y, x[i], y[i], new_x[i], new_y[i]);
  for (std::size_t i = 0; i < population; ++i) {
    const std::uint32_t other = others_[first + i];
    if (other == none) continue;
    const bool has_moved = other < i;
    mover(factors[i], scales[i], has_moved ? new_x[other] : x[other], has_moved ? new_y[other] : y[other], x[i], y[i], new_x[i], new_y[i]);
  }
  x_.swap(new_x_);
  y_.swap(new_y_);
}

Vec2 WhaleSteering::aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) {
  prepare_view(goal);
  const Aim aim{near, sample, goal, space_.room(near)};
  Best best{sample, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < x_.size(); ++i) {
    Vec2 q{};
    do q = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    while (squared_norm(q) > 1.0);
    x_[i] = sample.x + options_.radius * q.x;
    y_[i] = sample.y + options_.radius * q.y;
  }
  draw_moves(random);
  look(aim, best);
  for (std::size_t t = 0; t < static_cast<std::size_t>(options_.iterations); ++t) {
    move(t, best.at, sample);
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
  for (std::size_t i = 0; i < x_.size(); ++i) drawn.agents.push_back(agent(i));
}

void WhaleSteering::draw(SearchPicture& picture) const {
  for (const Drawn& drawn : drawn_) {
    SearchPicture::Swarm& swarm = picture.swarms.emplace_back();
    swarm.born = drawn.samples;
    for (const Vec2 at : drawn.agents) swarm.agents.push_back({at});
  }
}

}  // namespace waywright
