#include "waywright/planner/tree/whale_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "waywright/core/random.hpp"

namespace waywright {

double WhaleRefinement::length_of(const double* corners) {
  const double* const x = corners;
  const double* const y = corners + corners_;
  double* const lengths = squares_.data();
  const auto between = [](double dx, double dy) { return std::sqrt(dx * dx + dy * dy); };
  for (std::size_t k = 1; k < corners_; ++k) lengths[k] = between(x[k] - x[k - 1], y[k] - y[k - 1]);
  double metres = between(x[0] - start_.x, y[0] - start_.y) + between(goal_.x - x[corners_ - 1], goal_.y - y[corners_ - 1]);
  for (std::size_t k = 1; k < corners_; ++k) metres += lengths[k];
  return metres;
}

bool WhaleRefinement::is_free(const double* corners) {
  Vec2 before = start_;
  for (std::size_t k = 0; k <= corners_; ++k) {
    const Vec2 next = k < corners_ ? Vec2{corners[k], corners[corners_ + k]} : goal_;
    ++lines_;
    if (!space_->is_free(before, next)) return false;
    before = next;
  }
  return true;
}

void WhaleRefinement::draw(int population) {
  if (drawn_ == nullptr || iterations_++ % each_drawn_ != 0) return;
  if (drawn_->size() == most_drawn) {
    std::size_t kept = 1;
    for (std::size_t i = 2; i < drawn_->size(); i += 2) (*drawn_)[kept++] = std::move((*drawn_)[i]);
    drawn_->resize(kept);
    each_drawn_ *= 2;
    if ((iterations_ - 1) % each_drawn_ != 0) return;
  }
  std::vector<std::vector<Vec2>>& agents = drawn_->emplace_back();
  for (int i = 0; i < population; ++i) {
    const double* const a = agents_.data() + static_cast<std::size_t>(i) * 2 * corners_;
    std::vector<Vec2>& points = agents.emplace_back();
    points.push_back(start_);
    for (std::size_t k = 0; k < corners_; ++k) points.push_back({a[k], a[corners_ + k]});
    points.push_back(goal_);
  }
}

std::vector<Vec2> WhaleRefinement::refined(const std::vector<Vec2>& way, const PlaneSpace& space, const WhaleRefinementOptions& options, std::uint64_t seed, Budget& budget) {
  evaluations_ = lines_ = 0;
  if (way.size() < 3 || options.evaluations < 1) return way;
  space_ = &space;
  start_ = way.front();
  goal_ = way.back();
  corners_ = way.size() - 2;
  const std::size_t variables = 2 * corners_;
  low_.resize(variables);
  high_.resize(variables);
  best_.resize(variables);
  squares_.resize(corners_ + 1);
  agents_.resize(variables * static_cast<std::size_t>(options.population));
  for (std::size_t k = 0; k < corners_; ++k) {
    best_[k] = way[k + 1].x;
    best_[corners_ + k] = way[k + 1].y;
  }
  for (std::size_t i = 0; i < variables; ++i) {
    low_[i] = best_[i] - options.bound;
    high_[i] = best_[i] + options.bound;
  }
  // The way itself is free: whatever is no shorter need not be looked at, and what is not free never takes its place.
  double shortest = length_of(best_.data());
  ++evaluations_;
  Random random = Random::stream(seed, 1);
  const auto look = [&](const double* agent) {
    if (evaluations_ >= options.evaluations) return;
    ++evaluations_;
    const double metres = length_of(agent);
    if (!(metres < shortest) || !is_free(agent)) return;
    shortest = metres;
    std::copy(agent, agent + variables, best_.begin());
  };
  const auto agent = [&](int i) { return agents_.data() + static_cast<std::size_t>(i) * variables; };
  std::copy(best_.begin(), best_.end(), agents_.begin());
  for (int i = 1; i < options.population; ++i) {
    double* const a = agent(i);
    for (std::size_t k = 0; k < corners_; ++k) {
      Vec2 q{};
      do q = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
      while (squared_norm(q) > 1.0);
      a[k] = agents_[k] + options.bound * q.x;
      a[corners_ + k] = agents_[corners_ + k] + options.bound * q.y;
    }
  }
  for (int i = 1; i < options.population; ++i) look(agent(i));
  draw(options.population);
  std::vector<double> leader;
  for (int t = 0; t < options.iterations && evaluations_ < options.evaluations && !budget.exhausted(); ++t) {
    const double reach = whale_reach(options.whale.start, static_cast<std::size_t>(t), static_cast<std::size_t>(options.iterations));
    leader = best_;
    for (int i = 0; i < options.population; ++i) {
      const WhaleStep step = whale_step(options.whale, reach, WhaleDraws::from(random));
      const double* const target = step.move == WhaleMove::search ? agent(static_cast<int>(random.integer(0, options.population - 1))) : leader.data();
      make_whale_step(step, {target, variables}, low_, high_, {agent(i), variables});
    }
    for (int i = 0; i < options.population; ++i) look(agent(i));
    draw(options.population);
  }
  std::vector<Vec2> points{start_};
  for (std::size_t k = 0; k < corners_; ++k) points.push_back({best_[k], best_[corners_ + k]});
  points.push_back(goal_);
  return points;
}

}  // namespace waywright
