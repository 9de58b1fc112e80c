#include "waywright/planner/state_lattice/motion_primitives.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace waywright {
namespace {

constexpr int most_headings_turned = 4;     // 90°, near enough
constexpr double most_askew = 0.35;         // rad, between the chord and the one of an arc
constexpr int most_cells = 800;             // of a primitive's chord
constexpr double widest_search = 3.0;       // times the least chord that there can be
constexpr double apart = 1.5;                // cells, between places of a way that are looked at to bound its cost
constexpr int lattice_quarter = lattice_headings / 4;

Vec2 way_of(LatticeStep step, double cell) { return {step.column * cell, step.row * cell}; }

LatticeStep turned_quarter(LatticeStep s) { return {-s.row, s.column}; }

struct Found {
  LatticeStep step{};
  std::vector<Clothoid> curves;
};

/// The shortest that turns from one heading to another.
std::optional<Found> turning(int from, int turned, const PrimitiveOptions& options) {
  const double begin = lattice_heading(from), angle = wrap(lattice_heading((from + turned + lattice_headings) % lattice_headings) - begin);
  // A curvature that rises and falls in a quarter of the length each turns by ¾ of its greatest; where its rate is limited by less.
  double shortest = std::abs(angle) / (0.75 * options.limits.curvature);
  if (std::isfinite(options.limits.curvature_rate)) shortest = std::max(shortest, std::sqrt(std::abs(angle) / (0.1875 * options.limits.curvature_rate)));
  const double half = 0.5 * std::abs(angle);
  const double chord = shortest * sin_cos(half).sin / half;
  const int reach = std::min(most_cells, static_cast<int>(std::ceil(widest_search * chord / options.cell)) + 3);
  std::vector<std::pair<int, LatticeStep>> order;  // by the square of the chord
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const int squared = column * column + row * row;
      if (squared == 0 || squared > reach * reach || squared * options.cell * options.cell < 0.64 * chord * chord) continue;
      const double askew = wrap(angle_of(Vec2{static_cast<double>(column), static_cast<double>(row)}) - begin) - 0.5 * angle;
      if (std::abs(askew) <= std::min(most_askew, half)) order.push_back({squared, {column, row}});
    }
  }
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.row != b.second.row ? a.second.row < b.second.row : a.second.column < b.second.column;
  });
  for (const auto& [squared, step] : order) {
    const Vec2 to = way_of(step, options.cell);
    auto curves = fitted_within({0.0, 0.0, begin}, 0.0, make_pose(to, wrap(begin + angle)), 0.0, options.limits);
    if (!curves.empty()) return Found{step, std::move(curves)};
  }
  return std::nullopt;
}

/// The shortest to the next line of cells beside that leads the same way.
std::optional<Found> shifting(int from, int side, const PrimitiveOptions& options) {
  const LatticeStep ahead = lattice_steps[static_cast<std::size_t>(from)];
  const double begin = lattice_heading(from);
  for (int n = 1; n <= most_cells; ++n) {
    // Steps whose cross product with the way ahead is ±1 lie on the next line; for straight and diagonal ones that is one beside, for knight's steps two lines over.
    const LatticeStep beside = ahead.column * ahead.column + ahead.row * ahead.row == 5 ? LatticeStep{ahead.column > 0 ? 1 : ahead.column < 0 ? -1 : 0, ahead.row > 0 ? 1 : ahead.row < 0 ? -1 : 0}
                                                                                         : lattice_steps[static_cast<std::size_t>((from + side * 2 + lattice_headings) % lattice_headings)];
    LatticeStep step = beside;
    if (ahead.column * ahead.column + ahead.row * ahead.row == 5) {
      // (1, 1) lies on one side of a knight's step, the single straight one on the other.
      const int is_left = ahead.column * beside.row - ahead.row * beside.column > 0 ? 1 : -1;
      if (is_left != side) step = {ahead.column - beside.column, ahead.row - beside.row};
    }
    step = {step.column + n * ahead.column, step.row + n * ahead.row};
    auto curves = fitted_within({0.0, 0.0, begin}, 0.0, make_pose(way_of(step, options.cell), begin), 0.0, options.limits);
    if (!curves.empty()) return Found{step, std::move(curves)};
  }
  return std::nullopt;
}

Found turned_quarters(const Found& found, int quarters) {
  Found out = found;
  const Frame frame{{0.0, 0.0, wrap(0.5 * pi * quarters)}};
  for (int i = 0; i < quarters; ++i) out.step = turned_quarter(out.step);
  for (Clothoid& c : out.curves) c.start = frame.to_world(c.start);
  out.curves.front().start.x = out.curves.front().start.y = 0.0;
  return out;
}

/// Some of the poses, at least so far apart.
void choose_places(MotionPrimitive& p, double apart_at_least) {
  double way = 0.0;
  for (std::size_t i = 1; i < p.poses.size(); ++i) {
    way += p.poses[i].way;
    if (way < apart_at_least || i + 1 == p.poses.size()) continue;
    p.between.push_back({p.poses[i].offset, way});
    way = 0.0;
  }
  p.last_way = way;
}

}  // namespace

double lattice_heading(int heading) {
  const LatticeStep s = lattice_steps[static_cast<std::size_t>(heading)];
  return angle_of(Vec2{static_cast<double>(s.column), static_cast<double>(s.row)});
}

MotionPrimitives motion_primitives(const PrimitiveOptions& options, const MotionCost& cost) {
  MotionPrimitives all;
  const double look = std::min(0.1, options.cell);
  const Frame axes{{0.0, 0.0, options.turn_frame}};
  const auto add = [&](int heading, LatticeStep step, int to, LatticeStretch stretch) {
    MotionPrimitive p;
    p.stretch = std::move(stretch);
    p.step = step;
    p.to = to;
    p.length = length_of(p.stretch);
    p.poses = cost.poses_of(placed(p.stretch, axes), look);
    p.metres = cost.costs().metres_of(p.stretch);
    p.middle = p.poses[p.poses.size() / 2].offset;
    for (const CostedPose& pose : p.poses) p.reach = std::max(p.reach, distance(pose.offset, p.middle) + pose.sweep);
    choose_places(p, apart * options.cell);
    all[static_cast<std::size_t>(heading)].push_back(std::move(p));
  };
  const auto add_both_ways = [&](int course, int to_course, const Found& found) {
    if (length_of(LatticeStretch{1, found.curves, {}}) > options.longest) return;
    if (options.may_forward) add(course, found.step, to_course, LatticeStretch{1, found.curves, {}});
    if (options.may_reverse) add(other_way(course), found.step, other_way(to_course), LatticeStretch{-1, found.curves, {}});
  };
  for (int from = 0; from < lattice_quarter; ++from) {
    std::vector<std::pair<int, Found>> moves;  // headings turned
    const LatticeStep ahead = lattice_steps[static_cast<std::size_t>(from)];
    moves.push_back({0, Found{ahead, {Clothoid{{0.0, 0.0, lattice_heading(from)}, 0.0, 0.0, norm(way_of(ahead, options.cell))}}}});
    for (const int side : {1, -1}) {
      if (auto found = shifting(from, side, options)) moves.push_back({0, std::move(*found)});
      for (int n = 1; n <= most_headings_turned; ++n) {
        if (auto found = turning(from, side * n, options)) moves.push_back({side * n, std::move(*found)});
      }
    }
    for (int quarter = 0; quarter < 4; ++quarter) {
      const int course = from + quarter * lattice_quarter;
      for (const auto& [turned, found] : moves) {
        add_both_ways(course, (course + turned + lattice_headings) % lattice_headings, turned_quarters(found, quarter));
      }
    }
  }
  if (options.may_turn) {
    for (int heading = 0; heading < lattice_headings; ++heading) {
      for (const int side : {1, -1}) {
        const int to = (heading + side + lattice_headings) % lattice_headings;
        const double from = lattice_heading(heading);
        add(heading, {}, to, LatticeStretch{0, {}, Turn{{0.0, 0.0}, from, wrap(lattice_heading(to) - from)}});
      }
    }
  }
  return all;
}

}  // namespace waywright
