#include "waywright/planner/tree/state_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/planner/plane/proven_radius.hpp"

namespace waywright {
namespace {

constexpr int clock_every = 32;               // samples
constexpr double enough = 1e-6;               // of the cost: nothing less can be
constexpr std::size_t most_drawn = 24'000;    // lines of a picture with their bends; what comes after is not drawn

}  // namespace

std::optional<Pose> StateTree::sampled(Random& random, Budget& budget) {
  if (options_.goal_bias > 0.0 && random.uniform() < options_.goal_bias) return query_->goal;
  const Steering& steering = query_->steering;
  return query_->draw(random, budget, [&](const Pose& pose) {
    if (!options_.informed || !is_found()) return true;
    const Facing start{query_->start}, at{pose}, goal{query_->goal};
    return steering.bound(start, at) + steering.bound(at, goal) < best_cost_ && steering.least(query_->start, pose) + steering.least(pose, query_->goal) < best_cost_;
  }, options_.informed && is_found() ? best_cost_ : std::numeric_limits<double>::infinity());
}

void StateTree::near_states(const Pose& at, StateBins::Way way, std::vector<StateBins::Near>& found) const {
  if (options_.radius > 0.0) {
    bins_.within(at, way, options_.radius, found);
  } else {
    bins_.nearest(at, way, static_cast<std::size_t>(proven_neighbours(static_cast<double>(size()))), found);
  }
}

void StateTree::look_for_goal(std::uint32_t node) {
  const Pose& at = bins_[node];
  if (node != 0 && distance(at.position(), query_->goal.position()) > options_.goal_threshold) return;
  goal_edges_.push_back({node, Freedom::unknown, query_->steering.distance(at, query_->goal)});
  is_changed_ = true;
}

/// Motions to the goal are tested where the way by them would be the best one, the least costly first.
void StateTree::choose_best() {
  if (!is_changed_) return;
  is_changed_ = false;
  if (is_found()) best_cost_ = nodes_.cost(goal_edges_[best_].node) + goal_edges_[best_].cost;
  while (!is_spent()) {
    std::uint32_t next = none;
    double least = best_cost_;
    for (std::size_t i = 0; i < goal_edges_.size(); ++i) {
      const GoalEdge& edge = goal_edges_[i];
      if (edge.freedom == Freedom::blocked) continue;
      const double whole = nodes_.cost(edge.node) + edge.cost;
      if (whole < least) {
        least = whole;
        next = static_cast<std::uint32_t>(i);
      }
    }
    if (next == none) break;
    GoalEdge& edge = goal_edges_[next];
    if (edge.freedom == Freedom::unknown) edge.freedom = edge.cost <= 0.0 || is_free(bins_[edge.node], query_->goal) ? Freedom::free : Freedom::blocked;
    if (edge.freedom == Freedom::blocked) continue;
    best_ = next;
    best_cost_ = least;
    break;
  }
  if (is_found() && (best_ways_.empty() || best_cost_ < drawn_cost_)) {
    drawn_cost_ = best_cost_;
    best_ways_.push_back({query_->places_along(way()), step()});
  }
  if (is_found() && !statistics_.first_cost) {
    statistics_.first_cost = best_cost_;
    statistics_.first_path_after = statistics_.samples;
  }
  statistics_.is_least = is_found() && best_cost_ <= (1.0 + enough) * least_;
}

/// @pre the motion from `near` is free
void StateTree::insert(const Pose& at, std::uint32_t near, double to_near) {
  std::uint32_t parent = near;
  double edge = to_near;
  if (options_.rewires) {
    near_states(at, StateBins::Way::to_it, near_);
    neighbours_.clear();
    for (const StateBins::Near& n : near_) {
      const double through = nodes_.cost(n.index) + n.cost;
      if (n.index != near && through < nodes_.cost(near) + to_near) neighbours_.push_back({through, n.cost, n.index});
    }
    // The cheapest first that is free; nothing dearer than the way by `near`, which is.
    std::sort(neighbours_.begin(), neighbours_.end());
    for (const Neighbour& n : neighbours_) {
      if (!is_free(bins_[n.node], at)) continue;
      parent = n.node;
      edge = n.cost;
      break;
    }
  }
  const std::uint32_t node = bins_.add(at);
  nodes_.add(parent, edge, step());
  if (options_.rewires) {
    const Steering& steering = query_->steering;
    if (!steering.is_symmetric()) near_states(at, StateBins::Way::from_it, near_);
    const double cost = nodes_.cost(node);
    for (const StateBins::Near& n : near_) {
      if (n.index == parent || n.index == node || !(cost + n.cost < nodes_.cost(n.index))) continue;
      // What the motion back costs may differ in its last bits.
      const double back = steering.is_symmetric() ? steering.distance(at, bins_[n.index]) : n.cost;
      if (!(cost + back < nodes_.cost(n.index)) || !is_free(at, bins_[n.index])) continue;
      nodes_.rehang(n.index, node, back, step());
      ++statistics_.rewired;
      is_changed_ = true;
    }
  }
  look_for_goal(node);
}

void StateTree::grow(const StateQuery& query, const PlaneTreeOptions& options, std::uint64_t seed, Budget& budget) {
  query_ = &query;
  options_ = options;
  least_ = query.steering.least(query.start, query.goal);
  bins_.clear(query.steering, query.region);
  nodes_.clear();
  goal_edges_.clear();
  best_ways_.clear();
  best_ = none;
  best_cost_ = std::numeric_limits<double>::infinity();
  is_changed_ = false;
  statistics_ = {};
  Random random = Random::stream(seed, 0);
  bins_.add(query.start);
  look_for_goal(0);
  choose_best();
  if (statistics_.is_least || (is_found() && options.first_path)) return;
  for (std::int64_t i = 0; i < options.samples; ++i) {
    if (is_spent() || (i % clock_every == 0 && budget.exhausted())) return;
    ++statistics_.samples;
    const std::optional<Pose> sample = sampled(random, budget);
    if (!sample) {
      statistics_.is_stuck = true;
      return;
    }
    const StateBins::Near near = bins_.nearest(*sample, StateBins::Way::to_it);
    if (!(near.cost > 0.0)) continue;
    const Pose from = bins_[near.index];
    const bool is_whole = near.cost <= options.step;
    const Pose to = is_whole ? *sample : query.steering.at(from, *sample, options.step / near.cost);
    const double edge = is_whole ? near.cost : query.steering.distance(from, to);
    if (!(edge > 0.0) || !is_free(from, to)) continue;
    insert(to, near.index, edge);
    choose_best();
    if (statistics_.is_least || (is_found() && options.first_path)) return;
  }
}

std::vector<Pose> StateTree::way_to(std::uint32_t node) const {
  std::vector<Pose> poses;
  for (const std::uint32_t n : nodes_.way(node)) poses.push_back(bins_[n]);
  return poses;
}

std::vector<Pose> StateTree::way() const {
  if (!is_found()) return {};
  const GoalEdge& last = goal_edges_[best_];
  std::vector<Pose> poses = way_to(last.node);
  if (last.cost > 0.0) poses.push_back(query_->goal);
  return poses;
}

SearchPicture StateTree::picture() const {
  SearchPicture picture;
  picture.name = options_.rewires ? "tree of RRT*" : "tree of RRT";
  picture.steps = step();
  std::vector<std::size_t> last(nodes_.size(), nodes_.hung().size());  // line of a node
  for (const TreeNodes::Hung& h : nodes_.hung()) {
    if (last[h.node] < picture.lines.size()) picture.lines[last[h.node]].gone = h.step;
    last[h.node] = picture.lines.size();
    SearchPicture::Line& line = picture.lines.emplace_back(SearchPicture::Line{bins_[h.parent].position(), bins_[h.node].position(), h.step});
    if (picture.lines.size() <= most_drawn) line.bend = query_->bend_between(bins_[h.parent], bins_[h.node]);
  }
  picture.ways = best_ways_;
  return picture;
}

}  // namespace waywright
