#include "waywright/planner/roadmap/tangent_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/planner/roadmap/region_ends.hpp"

namespace waywright {
namespace {

constexpr double straight = 1e-9;  // rad: a bend by less is none
constexpr double on_circle = 1e-9;  // m
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr int clock_every = 16;  // expansions

/// Counter-clockwise angle in [0, 2π) from one direction to another; just under 2π, by rounding, counts as 0.
double turn_left(Vec2 from, Vec2 to) {
  const double angle = arc_tangent(cross(from, to), dot(from, to));
  return angle < -straight ? angle + two_pi : std::max(0.0, angle);
}

struct Leaving {
  Vec2 along{};
  double length = 0.0;
};

/// From a point to the circle about a corner that is passed on the left or right.
std::optional<Leaving> to_circle(Vec2 from, Vec2 center, double radius, bool is_left) {
  const Vec2 way = center - from;
  const double d = norm(way);
  if (d < radius - std::max(on_circle, 1e-9 * radius) || d == 0.0) return std::nullopt;
  const double sine = std::min(1.0, radius / d), cosine = std::sqrt(1.0 - sine * sine);
  const Vec2 w = (1.0 / d) * way;
  return Leaving{cosine * w - (is_left ? sine : -sine) * left_of(w), cosine * d};
}

}  // namespace

TangentGraph::TangentGraph(const PlaneSpace& space, double radius, double margin, Rounding rounding)
    : space_{space}, radius_{radius}, margin_{margin}, rounding_{rounding}, corners_{corners_of(space, radius, margin, rounding)} {}

std::optional<TangentGraph::Tangent> TangentGraph::tangent(std::uint32_t from, bool from_left, std::uint32_t to, bool to_left) const {
  const Corner& a = corners_[from];
  const Corner& b = corners_[to];
  const Vec2 way = b.at - a.at;
  const double d = norm(way);
  const double across = from_left == to_left ? 0.0 : to_left ? 2.0 * radius_ : -2.0 * radius_;
  if (d <= std::abs(across) || d == 0.0) return std::nullopt;
  const Vec2 w = (1.0 / d) * way;
  Vec2 along = w;
  double length = d;
  if (across != 0.0) {
    const double sine = across / d, cosine = std::sqrt(1.0 - sine * sine);
    along = cosine * w - sine * left_of(w);
    length = cosine * d;
  }
  const Vec2 n = left_of(along);
  if (!a.holds(from_left ? -n : n) || !b.holds(to_left ? -n : n)) return std::nullopt;
  return Tangent{to, along, length, to_left};
}

void TangentGraph::see_all() {
  if (sees_all_) return;
  const auto count = static_cast<std::uint32_t>(corners_.size());
  for (std::uint32_t c = 0; c < count; ++c) {
    for (const bool is_left : {false, true}) {
      first_.push_back(static_cast<std::uint32_t>(tangents_.size()));
      for (std::uint32_t other = 0; other < count; ++other) {
        if (other == c) continue;
        for (const bool other_left : {false, true}) {
          const auto t = tangent(c, is_left, other, other_left);
          if (!t) continue;
          const Vec2 from = touching(c, is_left, t->along);
          if (is_free(from, from + t->length * t->along)) tangents_.push_back(*t);
        }
      }
    }
  }
  first_.push_back(static_cast<std::uint32_t>(tangents_.size()));
  sees_all_ = true;
}

std::vector<std::pair<Vec2, Vec2>> TangentGraph::lines() const {
  std::vector<std::pair<Vec2, Vec2>> all;
  if (!sees_all_) return all;
  for (std::uint32_t s = 0; s < 2 * corners_.size(); ++s) {
    for (std::uint32_t i = first_[s]; i < first_[s + 1]; ++i) {
      const Tangent& t = tangents_[i];
      if (t.to <= s / 2) continue;  // each is there both ways
      const Vec2 from = touching(s / 2, s % 2 == 1, t.along);
      all.emplace_back(from, from + t.length * t.along);
    }
  }
  return all;
}

/// A* over places where lines touch circles: what is left of the way cannot be shorter than the straight line. Whether a line is free is asked when its turn comes.
class TangentSearch {
 public:
  TangentSearch(const TangentGraph& graph, Vec2 start, const PlaneTarget& goal) : graph_{graph}, start_{start}, goal_{goal}, ends_{region_ends(graph.space_, goal, graph.radius_, graph.margin_)}, arrived_(2 * graph.corners_.size()) {}

  TangentAnswer run(Budget& budget, std::optional<std::int64_t> most) {
    TangentAnswer answer;
    const auto add_direct = [&](Vec2 end) { add({goal_side, none, {}, start_, end, distance(start_, end), true}); };
    add_direct(goal_.nearest(start_));
    if (!goal_.is_point()) {
      for (const Vec2 end : ends_) add_direct(end);
      each_edge([&](Vec2 a, Vec2, Vec2 along, double length) {
        const Vec2 edge = -left_of(along);
        const double t = dot(start_ - a, edge);
        if (t > 0.0 && t < length && dot(a - start_, along) > 0.0) add_direct(a + t * edge);
      });
    }
    for (std::uint32_t c = 0; c < graph_.corners_.size(); ++c) {
      for (const bool is_left : {false, true}) {
        const auto t = to_circle(start_, graph_.corners_[c].at, graph_.radius_, is_left);
        if (!t) continue;
        const Vec2 normal = is_left ? -left_of(t->along) : left_of(t->along);
        if (!graph_.corners_[c].holds(normal)) continue;
        add({TangentGraph::side(c, is_left), none, normal, start_, graph_.touching(c, is_left, t->along), t->length, true});
      }
    }
    while (!open_.empty()) {
      std::pop_heap(open_.begin(), open_.end());
      const std::uint32_t at = open_.back().visit;
      answer.least = open_.back().estimate;  // of all that is open the least, and a shortest way leads through one of them
      open_.pop_back();
      const Visit visit = visits_[at];
      if (visit.side != goal_side && is_dominated(visit)) continue;
      if (visit.parent != none && !is_arc_to_free(visit)) continue;
      if (visit.is_asked) {
        ++answer.lines;
        if (!graph_.is_free(visit.from, visit.to)) continue;
      }
      if (visit.side == goal_side) {
        answer.ended = TangentEnd::found;
        answer.way = way_to(at);
        return answer;
      }
      if (most && answer.expansions >= *most) {
        answer.ended = TangentEnd::expansions;
        return answer;
      }
      if (answer.expansions % clock_every == 0 && budget.exhausted()) {
        answer.ended = TangentEnd::stopped;
        return answer;
      }
      ++answer.expansions;
      arrived_[visit.side].push_back(at);
      expand(at, visit);
    }
    return answer;
  }

 private:
  static constexpr std::uint32_t goal_side = none;
  struct Visit {
    std::uint32_t side;    // where the line touches
    std::uint32_t parent;  // visit; none: the start
    Vec2 normal;           // from the corner to there
    Vec2 from, to;         // of the line
    double cost;           // m
    bool is_asked;         // whether the line is free
  };
  struct Open {
    double estimate;
    std::uint32_t visit;
    bool operator<(const Open& other) const { return estimate != other.estimate ? estimate > other.estimate : visit > other.visit; }
  };

  void add(const Visit& visit) {
    open_.push_back({visit.cost + distance(visit.to, goal_.nearest(visit.to)), static_cast<std::uint32_t>(visits_.size())});
    std::push_heap(open_.begin(), open_.end());
    visits_.push_back(visit);
  }

  /// Of a region: ends, the direction straight at it from outside, length.
  template <class Take>
  void each_edge(const Take& take) const {
    for (std::size_t i = 0; !goal_.is_point() && i < goal_.area.size(); ++i) {
      const Vec2 a = goal_.area[i], b = goal_.area[(i + 1) % goal_.area.size()];
      const double length = distance(a, b);
      if (length > 0.0) take(a, b, left_of((1.0 / length) * (b - a)), length);
    }
  }

  /// rad along the arc, in the direction in which the side is driven. Law of arcs that are no whole circle: under 0 where `to` lies before `from`.
  double along_arc(std::uint32_t side, Vec2 from, Vec2 to) const {
    const bool is_left = side % 2 == 1;
    if (graph_.corners_[side / 2].is_point) return is_left ? turn_left(from, to) : turn_left(to, from);
    const double angle = arc_tangent(cross(from, to), dot(from, to));
    return is_left ? angle : -angle;
  }

  bool is_dominated(const Visit& visit) const {
    if (!graph_.corners_[visit.side / 2].is_open) {
      return std::any_of(arrived_[visit.side].begin(), arrived_[visit.side].end(), [&](std::uint32_t i) { return visits_[i].normal == visit.normal && visits_[i].cost <= visit.cost; });
    }
    return std::any_of(arrived_[visit.side].begin(), arrived_[visit.side].end(), [&](std::uint32_t i) {
      const double angle = along_arc(visit.side, visits_[i].normal, visit.normal);
      return angle >= 0.0 && visits_[i].cost + graph_.radius_ * angle <= visit.cost;
    });
  }

  Vec2 leaving_normal(const Visit& parent, const Visit& visit) const { return (1.0 / graph_.radius_) * (visit.from - graph_.corners_[parent.side / 2].at); }

  bool is_arc_to_free(const Visit& visit) const {
    const Visit& parent = visits_[visit.parent];
    const Corner& corner = graph_.corners_[parent.side / 2];
    if (corner.is_open) return true;
    const double angle = std::max(0.0, along_arc(parent.side, parent.normal, leaving_normal(parent, visit)));
    return is_arc_free(graph_.space_, corner.at, graph_.radius_, parent.normal, parent.side % 2 == 1 ? angle : -angle, graph_.margin_, graph_.rounding_);
  }

  void leave(std::uint32_t at, const Visit& visit, std::uint32_t side, Vec2 along, Vec2 from, Vec2 to, double length, bool is_asked) {
    const bool is_left = visit.side % 2 == 1;
    const Vec2 normal = is_left ? -left_of(along) : left_of(along);
    double angle = along_arc(visit.side, visit.normal, normal);
    if (angle < -straight) return;  // the arc ends behind it
    angle = std::max(0.0, angle);
    const Vec2 arrival = side == goal_side ? Vec2{} : side % 2 == 1 ? -left_of(along) : left_of(along);
    add({side, at, arrival, from, to, visit.cost + graph_.radius_ * angle + length, is_asked});
  }

  void leave_to_goal(std::uint32_t at, const Visit& visit, Vec2 along, Vec2 to, double length) {
    const std::uint32_t c = visit.side / 2;
    const bool is_left = visit.side % 2 == 1;
    if (!graph_.corners_[c].holds(is_left ? -left_of(along) : left_of(along))) return;
    leave(at, visit, goal_side, along, graph_.touching(c, is_left, along), to, length, true);
  }

  void expand(std::uint32_t at, const Visit& visit) {
    const std::uint32_t c = visit.side / 2;
    const bool is_left = visit.side % 2 == 1;
    // To points of the goal: as from there to the circle, the other way round.
    for (const Vec2 end : ends_) {
      const auto t = to_circle(end, graph_.corners_[c].at, graph_.radius_, !is_left);
      if (t) leave_to_goal(at, visit, -t->along, end, t->length);
    }
    // To edges of it: straight at them.
    each_edge([&](Vec2 a, Vec2 b, Vec2 along, double edge) {
      const Vec2 from = graph_.touching(c, is_left, along);
      const double off = dot(a - from, along);
      const Vec2 foot = from + off * along;
      const double share = dot(foot - a, b - a);
      if (off >= 0.0 && share >= 0.0 && share <= edge * edge) leave_to_goal(at, visit, along, foot, off);
    });
    const auto go = [&](const TangentGraph::Tangent& t, bool is_asked) {
      const Vec2 from = graph_.touching(c, is_left, t.along);
      leave(at, visit, TangentGraph::side(t.to, t.to_left), t.along, from, from + t.length * t.along, t.length, is_asked);
    };
    if (graph_.sees_all_) {
      for (std::uint32_t i = graph_.first_[visit.side]; i < graph_.first_[visit.side + 1]; ++i) go(graph_.tangents_[i], false);
      return;
    }
    for (std::uint32_t other = 0; other < graph_.corners_.size(); ++other) {
      if (other == c) continue;
      for (const bool other_left : {false, true}) {
        if (const auto t = graph_.tangent(c, is_left, other, other_left)) go(*t, true);
      }
    }
  }

  TangentWay way_to(std::uint32_t at) const {
    TangentWay way{start_, visits_[at].to, {}, visits_[at].cost};
    while (visits_[at].parent != none) {
      const Visit& visit = visits_[at];
      const Visit& parent = visits_[visit.parent];
      const double angle = std::max(0.0, along_arc(parent.side, parent.normal, leaving_normal(parent, visit)));
      if (angle > straight) way.bends.push_back({graph_.corners_[parent.side / 2].at, parent.normal, parent.side % 2 == 1 ? angle : -angle});
      at = visit.parent;
    }
    std::reverse(way.bends.begin(), way.bends.end());
    return way;
  }

  const TangentGraph& graph_;
  Vec2 start_;
  const PlaneTarget& goal_;
  const std::vector<Vec2> ends_;  // points of it
  std::vector<std::vector<std::uint32_t>> arrived_;
  std::vector<Visit> visits_;
  std::vector<Open> open_;
};

TangentAnswer TangentGraph::shortest(Vec2 start, const PlaneTarget& goal, Budget& budget, std::optional<std::int64_t> expansions) const {
  return TangentSearch{*this, start, goal}.run(budget, expansions);
}

}  // namespace waywright
