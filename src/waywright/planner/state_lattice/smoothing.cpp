#include "waywright/planner/state_lattice/smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double look_step = 0.1;      // m, between poses while it is sought
constexpr double knot_step = 0.4;       // m, between places that may be joined
constexpr double farthest_join = 60.0;  // m
constexpr std::size_t each_ahead = 16;  // places that are all tried; farther ones ever more sparsely
constexpr int most_rounds = 8;
constexpr double first_move = 0.16, last_move = 0.01;  // m
constexpr double no_dearer = 1e-12;                     // m, rounding
constexpr double worthwhile = 1e-4;                     // m of cost that a change has to save


double end_curvature_of(const std::vector<Clothoid>& curves) { return end_curvature(curves.back()); }

Pose end_course(const Clothoid& c) { return make_pose(evaluate(c, c.length).position, wrap(course_at(c, c.length))); }

double greatest_move(double length) { return std::min(first_move, 0.1 * length); }

/// Runs of stretches in one direction; turns on the spot between.
class Smoother {
 public:
  Smoother(MotionCost& cost, const BendLimits& limits, Budget& budget) : cost_{cost}, limits_{limits}, budget_{budget} {}

  std::int64_t evaluations() const { return evaluations_; }

  std::vector<LatticeStretch> run(const std::vector<LatticeStretch>& way) {
    std::vector<LatticeStretch> out;
    for (std::size_t i = 0; i < way.size();) {
      if (way[i].direction == 0) {
        out.push_back(way[i++]);
        continue;
      }
      // Turns on the spot within a run are places like others: a join may leave them out.
      std::size_t end = i + 1, last = i + 1;
      for (; end < way.size() && (way[end].direction == 0 || way[end].direction == way[i].direction); ++end) {
        if (way[end].direction != 0) last = end + 1;
      }
      for (const LatticeStretch& s : refined(joined(way, i, last))) out.push_back(s);
      i = last;
    }
    return out;
  }

 private:
  struct Part {
    LatticeStretch stretch;
    double cost = 0.0;
  };

  /// Where it is free and costs less.
  std::optional<double> evaluated(const LatticeStretch& stretch, double than) {
    if (cost_.at_least(stretch) >= than) return std::nullopt;
    ++evaluations_;
    const auto cost = cost_.of(stretch, look_step);
    return cost && *cost < than ? cost : std::nullopt;
  }

  /// The way cut at its places.
  std::vector<Part> cut(const std::vector<LatticeStretch>& way, std::size_t begin, std::size_t end) {
    std::vector<Part> parts;
    for (std::size_t i = begin; i < end; ++i) {
      if (way[i].direction == 0) {
        parts.push_back({way[i], 0.0});
        continue;
      }
      for (const Clothoid& c : way[i].curves) {
        const int n = std::max(1, static_cast<int>(std::ceil(c.length / knot_step)));
        Clothoid rest = c;
        for (int k = 0; k < n; ++k) {
          Clothoid piece = rest;
          if (k + 1 < n) {
            piece.length = c.length / n;
            rest = rest_from(rest, piece.length);
          }
          parts.push_back({LatticeStretch{way[i].direction, {piece}, {}}, 0.0});
        }
      }
    }
    for (Part& p : parts) p.cost = cost_.of(p.stretch, look_step).value_or(infinity);
    return parts;
  }

  /// The least costly choice of places.
  std::vector<Part> joined(const std::vector<LatticeStretch>& way, std::size_t begin, std::size_t end) {
    std::vector<Part> parts = cut(way, begin, end);
    const std::size_t n = parts.size();
    std::vector<double> best(n + 1, infinity);
    std::vector<std::optional<Part>> by(n + 1);
    std::vector<std::size_t> from(n + 1, 0);
    best[0] = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      // As it is. What could not be seen to be free at finer steps stays: the lattice has proven it.
      const double as_is = parts[i].cost < infinity ? parts[i].cost : (1.0 + cost_.costs().weight) * cost_.costs().metres_of(parts[i].stretch);
      if (best[i] + as_is < best[i + 1]) {
        best[i + 1] = best[i] + as_is;
        by[i + 1] = parts[i];
        from[i + 1] = i;
      }
      if (parts[i].stretch.direction == 0 || budget_.exhausted()) continue;
      double far = length_of(parts[i].stretch);
      std::size_t sparse = 1;
      for (std::size_t j = i + 1; j < n && far < farthest_join; ++j) {
        far += length_of(parts[j].stretch);
        if (j - i >= 2 * each_ahead * sparse) sparse *= 2;
        if ((j - i) % sparse != 0 && j + 1 != n) continue;
        if (parts[j].stretch.direction == 0) continue;
        const Clothoid &first = parts[i].stretch.curves.front(), &last = parts[j].stretch.curves.back();
        const Pose to = end_course(last);
        // It can cost no less than the straight line.
        if (best[i] + cost_.least_factor() * distance(first.start.position(), to.position()) >= best[j + 1]) continue;
        auto curves = fitted_within(first.start, first.curvature, to, end_curvature(last), limits_);
        if (curves.empty()) continue;
        Part part{LatticeStretch{parts[i].stretch.direction, std::move(curves), {}}, 0.0};
        const auto cost = evaluated(part.stretch, best[j + 1] - best[i]);
        if (!cost) continue;
        part.cost = *cost;
        best[j + 1] = best[i] + *cost;
        by[j + 1] = std::move(part);
        from[j + 1] = i;
      }
    }
    std::vector<Part> chosen;
    for (std::size_t at = n; at > 0; at = from[at]) chosen.push_back(std::move(*by[at]));
    std::reverse(chosen.begin(), chosen.end());
    return chosen;
  }

  /// Places between two drives moved across, turned and bent, as long as it pays.
  std::vector<LatticeStretch> refined(std::vector<Part> parts) {
    for (double move = first_move; move >= last_move; move *= 0.5) {
      bool is_better = true;
      for (int round = 0; is_better && round < most_rounds; ++round) {
        is_better = false;
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
          if (budget_.exhausted()) break;
          is_better = improve(parts, i, move) || is_better;
        }
      }
    }
    std::vector<LatticeStretch> out;
    for (Part& p : parts) out.push_back(std::move(p.stretch));
    return out;
  }

  /// The place between parts i and i + 1.
  bool improve(std::vector<Part>& parts, std::size_t i, double move) {
    Part &a = parts[i], &b = parts[i + 1];
    if (a.stretch.direction == 0 || b.stretch.direction == 0) return false;
    const double shorter = std::min(length_of(a.stretch), length_of(b.stretch));
    const double across = std::min(move, greatest_move(shorter));
    const double turn = across / std::max(shorter, 1e-3), bend = turn / std::max(shorter, 1e-3);
    if (merge(parts, i)) return true;
    bool is_better = false;
    // Onto the straight line between the places beside.
    {
      const Vec2 from = a.stretch.curves.front().start.position(), to = end_course(b.stretch.curves.back()).position(), chord = to - from;
      const Pose at = b.stretch.curves.front().start;
      const double share = dot(at.position() - from, chord) / std::max(squared_norm(chord), 1e-12);
      if (share > 0.0 && share < 1.0) {
        const double course = angle_of(chord);
        is_better = replace(a, b, make_pose(from + share * chord, course), 0.0) || replace(a, b, make_pose(at.position(), course), b.stretch.curves.front().curvature);
      }
    }
    struct Change {
      double left, along, turn, bend;
    };
    for (const Change& c : {Change{across, 0, 0, 0}, Change{-across, 0, 0, 0}, Change{0, 0, turn, 0}, Change{0, 0, -turn, 0}, Change{0, 0, 0, bend}, Change{0, 0, 0, -bend}, Change{0, across, 0, 0},
                            Change{0, -across, 0, 0}}) {
      const Pose at = b.stretch.curves.front().start;
      const double curvature = b.stretch.curves.front().curvature;
      const Vec2 course = unit(at.heading);
      const Pose there = make_pose(at.position() + c.along * course + c.left * left_of(course), wrap(at.heading + c.turn));
      is_better = replace(a, b, there, curvature + c.bend) || is_better;
    }
    return is_better;
  }

  /// Both parts by others that meet elsewhere.
  bool replace(Part& a, Part& b, const Pose& there, double curvature) {
    const Clothoid &first = a.stretch.curves.front(), &last = b.stretch.curves.back();
    const double now = a.cost + b.cost;
    const Pose to = end_course(last);
    if (cost_.least_factor() * (distance(first.start.position(), there.position()) + distance(there.position(), to.position())) >= now) return false;
    auto before = fitted_within(first.start, first.curvature, there, curvature, limits_);
    if (before.empty()) return false;
    auto after = fitted_within(there, curvature, to, end_curvature_of(b.stretch.curves), limits_);
    if (after.empty()) return false;
    Part x{LatticeStretch{a.stretch.direction, std::move(before), {}}, 0.0}, y{LatticeStretch{b.stretch.direction, std::move(after), {}}, 0.0};
    const double enough = now - worthwhile;
    const auto one = evaluated(x.stretch, enough - cost_.at_least(y.stretch));
    if (!one) return false;
    const auto two = evaluated(y.stretch, enough - *one);
    if (!two) return false;
    x.cost = *one;
    y.cost = *two;
    a = std::move(x);
    b = std::move(y);
    return true;
  }

  /// Both parts by one.
  bool merge(std::vector<Part>& parts, std::size_t i) {
    const Part &a = parts[i], &b = parts[i + 1];
    const Clothoid &first = a.stretch.curves.front(), &last = b.stretch.curves.back();
    if (length_of(a.stretch) + length_of(b.stretch) > farthest_join) return false;
    auto curves = fitted_within(first.start, first.curvature, end_course(last), end_curvature(last), limits_);
    if (curves.empty()) return false;
    Part part{LatticeStretch{a.stretch.direction, std::move(curves), {}}, 0.0};
    const auto cost = evaluated(part.stretch, a.cost + b.cost + no_dearer);
    if (!cost) return false;
    part.cost = *cost;
    parts[i] = std::move(part);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return true;
  }

  MotionCost& cost_;
  const BendLimits& limits_;
  Budget& budget_;
  std::int64_t evaluations_ = 0;
};

}  // namespace

double cost_of(const std::vector<LatticeStretch>& stretches, MotionCost& cost) {
  double sum = 0.0;
  int direction = 0;
  for (const LatticeStretch& s : stretches) {
    if (s.direction == 0 && s.turn.angle == 0.0) continue;
    sum += cost.of(s, fine_step).value_or(infinity);
    if (s.direction == 0) continue;
    if (direction != 0 && direction != s.direction) sum += cost.costs().change;
    direction = s.direction;
  }
  return sum;
}

Smoothed smoothed(const std::vector<LatticeStretch>& way, MotionCost& cost, const BendLimits& limits, Budget& budget) {
  Smoother smoother{cost, limits, budget};
  Smoothed out;
  out.stretches = smoother.run(way);
  out.cost = cost_of(out.stretches, cost);
  out.evaluations = smoother.evaluations();
  const double as_it_was = cost_of(way, cost);
  if (!(out.cost <= as_it_was) || !std::isfinite(out.cost)) {
    out.stretches = way;
    out.cost = as_it_was;
  }
  return out;
}

}  // namespace waywright
