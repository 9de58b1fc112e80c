#include "waywright/planner/tree/plane_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "waywright/planner/plane/proven_radius.hpp"

namespace waywright {
namespace {

constexpr int tries_a_sample = 10'000;  // places drawn until one is free
constexpr int clock_every = 32;         // samples
constexpr double rounding_share = 1e-12;  // of a length, more than rounding can be

}  // namespace

bool PlaneTree::is_edge_free(Vec2 a, Vec2 b) {
  if (statistics_.edges >= most_edges_) return false;  // spent: the search ends
  ++statistics_.edges;
  return space_->is_free(a, b);
}

bool PlaneTree::is_edge_free(Vec2 a, Vec2 b, double length, double room_a, double room_b) {
  if (statistics_.edges >= most_edges_) return false;
  ++statistics_.edges;
  return space_->is_free(a, b, length, room_a, room_b);
}

std::uint32_t PlaneTree::add(Vec2 at, double room) {
  nodes_.emplace_back();
  costs_.push_back(0.0);
  rooms_.push_back(room);
  return bins_.add(at);
}

double PlaneTree::radius() const {
  if (options_.radius > 0.0) return options_.radius;
  return std::min(options_.step, proven_radius(space_->free_area(), static_cast<double>(bins_.size())));
}

std::optional<Vec2> PlaneTree::sampled(Random& random) {
  if (options_.goal_bias > 0.0 && random.uniform() < options_.goal_bias) {
    const Box box = bounding_box(goal_.area);
    return goal_.nearest({random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)});
  }
  const Box& region = space_->region();
  const Vec2 start = bins_[0], goal = goal_.nearest(start);
  const bool is_ellipse = options_.informed && is_found() && goal_.area.size() == 1;
  const Vec2 between = goal - start;
  const double least = norm(between);
  // Of an ellipse with its foci at start and goal, whose longer axis is the best length.
  const double a = 0.5 * best_length_, b = is_ellipse ? 0.5 * std::sqrt(std::max(0.0, best_length_ * best_length_ - least * least)) : 0.0;
  const Vec2 size = region.high - region.low;
  const bool from_ellipse = is_ellipse && std::numbers::pi * a * b < size.x * size.y;
  const Vec2 along = least > 0.0 ? (1.0 / least) * between : Vec2{1.0, 0.0};
  for (int i = 0; i < tries_a_sample; ++i) {
    Vec2 p{};
    if (from_ellipse) {
      Vec2 q{};
      do q = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
      while (squared_norm(q) > 1.0);
      p = 0.5 * (start + goal) + (a * q.x) * along + (b * q.y) * left_of(along);
      if (!region.contains(p)) continue;
    } else {
      p = {random.uniform(region.low.x, region.high.x), random.uniform(region.low.y, region.high.y)};
      if (is_ellipse && distance(p, start) + distance(p, goal) >= best_length_) continue;
    }
    if (space_->is_free(p)) return p;
  }
  return std::nullopt;
}

void PlaneTree::attach(std::uint32_t node, std::uint32_t parent, double edge) {
  Node& n = nodes_[node];
  Node& p = nodes_[parent];
  n.parent = parent;
  n.edge = edge;
  costs_[node] = costs_[parent] + edge;
  n.before = none;
  n.after = p.child;
  if (p.child != none) nodes_[p.child].before = node;
  p.child = node;
}

void PlaneTree::detach(std::uint32_t node) {
  const Node& n = nodes_[node];
  if (n.before != none) nodes_[n.before].after = n.after;
  else nodes_[n.parent].child = n.after;
  if (n.after != none) nodes_[n.after].before = n.before;
}

void PlaneTree::hang(std::uint32_t node, std::uint32_t parent, double edge) {
  attach(node, parent, edge);
  hung_.push_back({node, parent, static_cast<std::uint32_t>(statistics_.samples)});
}

/// A node's new cost, to all that hangs on it.
void PlaneTree::pass_on(std::uint32_t node) {
  waiting_.assign(1, node);
  while (!waiting_.empty()) {
    const std::uint32_t at = waiting_.back();
    waiting_.pop_back();
    for (std::uint32_t c = nodes_[at].child; c != none; c = nodes_[c].after) {
      costs_[c] = costs_[at] + nodes_[c].edge;
      waiting_.push_back(c);
    }
  }
}

void PlaneTree::look_for_goal(std::uint32_t node) {
  const Vec2 at = bins_[node], end = goal_.nearest(at);
  const double length = distance(at, end);
  if (length > options_.goal_threshold && !(node == 0 && options_.straight_first)) return;  // from the start: nothing is shorter than that line
  if (length > 0.0 && !is_edge_free(at, end)) return;
  goal_edges_.push_back({node, end, length});
  is_changed_ = true;
}

void PlaneTree::choose_best() {
  if (!is_changed_) return;
  is_changed_ = false;
  for (std::size_t i = 0; i < goal_edges_.size(); ++i) {
    const double metres = costs_[goal_edges_[i].node] + goal_edges_[i].length;
    if (metres < best_length_ || best_ == static_cast<std::uint32_t>(i)) {
      best_length_ = metres;
      best_ = static_cast<std::uint32_t>(i);
    }
  }
  if (is_found() && (best_ways_.empty() || best_length_ < drawn_length_)) {
    drawn_length_ = best_length_;
    best_ways_.push_back({way(), static_cast<std::uint32_t>(statistics_.samples)});
  }
}

/// As PointBins::nearest has it. `none` where there are none.
std::uint32_t PlaneTree::nearest_of_neighbours() const {
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t found = none;
  for (const PointBins::Near& n : std::span{near_.data(), near_count_}) {
    if (n.squared > best || (n.squared == best && n.index > found)) continue;
    best = n.squared;
    found = n.index;
  }
  return found;
}

/// Neighbours by whom the way to a new node could be shorter than `by_near`: most are left out by squares, without their roots.
void PlaneTree::look_for_parents(double by_near) {
  if (neighbours_.size() < near_count_) neighbours_.resize(2 * near_count_);
  Neighbour* const out = neighbours_.data();
  const PointBins::Near* const near = near_.data();
  const double bound = (1.0 + rounding_share) * by_near;
  std::size_t count = 0;
  for (std::size_t i = 0; i < near_count_; ++i) {  // each is written, and stays where it could: no branch to guess
    const std::uint32_t node = near[i].index;
    const double cost = costs_[node], most = bound - cost;
    out[count] = {cost, near[i].squared, node};
    count += (most > 0.0) & (near[i].squared <= most * most) ? 1 : 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    out[i].length = std::sqrt(out[i].length);
    out[i].through += out[i].length;
  }
  neighbour_count_ = count;
}

/// Neighbours whose ways could be shorter by a new node of that cost, likewise.
void PlaneTree::look_for_children(double cost) {
  if (neighbours_.size() < near_count_) neighbours_.resize(2 * near_count_);
  Neighbour* const out = neighbours_.data();
  const PointBins::Near* const near = near_.data();
  std::size_t count = 0;
  for (std::size_t i = 0; i < near_count_; ++i) {
    const std::uint32_t node = near[i].index;
    const double most = (1.0 + rounding_share) * costs_[node] - cost;
    out[count] = {0.0, near[i].squared, node};
    count += (most > 0.0) & (near[i].squared <= most * most) ? 1 : 0;
  }
  for (std::size_t i = 0; i < count; ++i) out[i].length = std::sqrt(out[i].length);
  neighbour_count_ = count;
}

/// @pre the edge from `near` is free; `is_near_known`: near_ holds those within the radius
void PlaneTree::insert(Vec2 at, double room, std::uint32_t near, double to_near, bool is_near_known) {
  if (!options_.rewires) {
    const std::uint32_t node = add(at, room);
    hang(node, near, to_near);
    look_for_goal(node);
    return;
  }
  if (!is_near_known) near_count_ = bins_.gather(at, radius(), near_);
  const double by_near = costs_[near] + to_near;
  look_for_parents(by_near);
  // The cheapest first that is free; nothing dearer than the way by `near`, which is.
  std::uint32_t parent = near;
  double edge = to_near;
  double passed = -1.0;
  while (true) {
    const Neighbour* cheapest = nullptr;
    for (const Neighbour& n : std::span{neighbours_.data(), neighbour_count_}) {
      if (n.through > passed && n.through < by_near && (cheapest == nullptr || n.through < cheapest->through)) cheapest = &n;
    }
    if (cheapest == nullptr) break;
    if (is_edge_free(bins_[cheapest->node], at, cheapest->length, rooms_[cheapest->node], room)) {
      parent = cheapest->node;
      edge = cheapest->length;
      break;
    }
    passed = cheapest->through;
  }
  const std::uint32_t node = add(at, room);
  hang(node, parent, edge);
  const double cost = costs_[node];
  look_for_children(cost);
  for (const Neighbour& n : std::span{neighbours_.data(), neighbour_count_}) {
    if (!(cost + n.length < costs_[n.node]) || n.node == parent || !is_edge_free(at, bins_[n.node], n.length, room, rooms_[n.node])) continue;
    detach(n.node);
    hang(n.node, node, n.length);
    pass_on(n.node);
    ++statistics_.rewired;
    is_changed_ = is_changed_ || !goal_edges_.empty();
  }
  look_for_goal(node);
}

void PlaneTree::grow(const PlaneSpace& space, const PlaneTreeOptions& options, Vec2 start, const PlaneTarget& goal, std::uint64_t seed, Budget& budget, std::int64_t edges,
                     TreeSteering* steering) {
  space_ = &space;
  options_ = options;
  goal_ = goal;
  most_edges_ = edges;
  bins_.clear(space.region());
  nodes_.clear();
  costs_.clear();
  rooms_.clear();
  goal_edges_.clear();
  best_ = none;
  best_length_ = std::numeric_limits<double>::infinity();
  is_changed_ = false;
  hung_.clear();
  best_ways_.clear();
  statistics_ = {};
  Random random = Random::stream(seed, 0);
  add(start, space.room(start));
  look_for_goal(0);
  if (kept_ != nullptr) take_over();
  choose_best();
  if (is_found()) {
    statistics_.first_length = best_length_;
    if (options_.first_path) return;
  }
  for (std::int64_t i = 0; i < options_.samples; ++i) {
    if (statistics_.edges >= edges) return;
    if (i % clock_every == 0 && budget.exhausted()) return;
    ++statistics_.samples;
    const std::optional<Vec2> sample = sampled(random);
    if (!sample) return;  // nowhere to go
    // Where the tree goes to the sample itself, its neighbours hold the nearest one, too.
    const bool looks_once = options.rewires && steering == nullptr;
    if (looks_once) near_count_ = bins_.gather(*sample, radius(), near_);
    std::uint32_t near = looks_once ? nearest_of_neighbours() : none;
    if (near == none) near = bins_.nearest(*sample);
    const Vec2 from = bins_[near];
    const Vec2 aim = steering != nullptr ? steering->aim(from, *sample, goal_.nearest(from), random) : *sample;
    const double way = distance(from, aim);
    if (!(way > 0.0)) continue;
    const bool is_far = way > options_.step;
    const Vec2 to = is_far ? from + (options_.step / way) * (aim - from) : aim;
    if (to == from) continue;
    const double room = space.room(to), length = distance(from, to);
    if (!is_edge_free(from, to, length, rooms_[near], room)) continue;
    insert(to, room, near, length, looks_once && !is_far);
    if (steering != nullptr) steering->grown(statistics_.samples);
    choose_best();
    if (is_found() && !statistics_.first_length) {
      statistics_.first_length = best_length_;
      statistics_.first_path_after = statistics_.samples;
    }
    if (is_found() && options_.first_path) return;
  }
}

SearchPicture PlaneTree::picture() const {
  SearchPicture picture;
  picture.name = options_.rewires ? "tree of RRT*" : "tree of RRT";
  picture.steps = static_cast<std::uint32_t>(statistics_.samples);
  std::vector<std::uint32_t> last(nodes_.size(), none);  // line of a node
  picture.lines.reserve(hung_.size());
  for (const Hung& h : hung_) {
    if (last[h.node] != none) picture.lines[last[h.node]].gone = h.sample;
    last[h.node] = static_cast<std::uint32_t>(picture.lines.size());
    picture.lines.push_back({bins_[h.parent], bins_[h.node], h.sample, SearchPicture::never});
  }
  picture.ways = best_ways_;
  return picture;
}

std::vector<Vec2> PlaneTree::way() const {
  if (!is_found()) return {};
  const GoalEdge& last = goal_edges_[best_];
  std::vector<Vec2> points;
  if (last.length > 0.0) points.push_back(last.end);
  for (std::uint32_t n = last.node; n != none; n = nodes_[n].parent) points.push_back(bins_[n]);
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace waywright
