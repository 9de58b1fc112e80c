#include "waywright/planner/docking/nearby.hpp"

#include <algorithm>
#include <array>

#include "waywright/planner/docking/carry.hpp"

namespace waywright {
namespace {

constexpr double farthest_shift = 0.3;  // m
constexpr double farthest_turn = 0.2;   // rad
constexpr double metres_per_radian = 1.0;
constexpr double unit_of_shift = 0.1;   // m: so much costs 1

/// A path of two pieces, each a quintic between straight runs, as a pattern.
std::optional<DockingPattern> pattern_of(const Path& path) {
  if (path.pieces.size() != 2 || path.pieces[0].direction != -1 || path.pieces[1].direction != 1) return std::nullopt;
  DockingPattern pattern;
  const auto take = [](const Piece& piece, std::array<Vec2, 4>& points, BezierSpan& bend) {
    const auto* spline = std::get_if<Spline>(&piece.curve);
    if (spline == nullptr) return false;
    const auto& spans = spline->spans;
    const auto at = std::find_if(spans.begin(), spans.end(), [](const BezierSpan& s) { return s.degree == 5; });
    const auto before = at - spans.begin(), after = spans.end() - at - 1;
    if (at == spans.end() || before > 1 || after > 1) return false;
    if ((before == 1 && at[-1].degree != 1) || (after == 1 && at[1].degree != 1)) return false;
    bend = *at;
    points = {before == 1 ? at[-1].control[0] : bend.control[0], bend.control[0], bend.control[5], after == 1 ? at[1].control[1] : bend.control[5]};
    return true;
  };
  if (!take(path.pieces[0], pattern.points.back, pattern.back) || !take(path.pieces[1], pattern.points.forth, pattern.forth)) return std::nullopt;
  pattern.is_bent_at_start = true;
  return pattern;
}

/// No place of a curve moves by more than its control points.
double greatest_move(const DockingPattern& a, const DockingPattern& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < 6; ++i) greatest = std::max({greatest, distance(a.back.control[i], b.back.control[i]), distance(a.forth.control[i], b.forth.control[i])});
  for (std::size_t i = 0; i < 4; ++i) greatest = std::max({greatest, distance(a.points.back[i], b.points.back[i]), distance(a.points.forth[i], b.points.forth[i])});
  return greatest;
}

}  // namespace

NearbySearch::NearbySearch(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer)
    : prepared_{prepared}, options_{options}, evaluator_{prepared},
      space_{{-farthest_shift, -farthest_shift, -farthest_turn}, {farthest_shift, farthest_shift, farthest_turn}},
      cost_{[this](std::span<const double> x, double enough) {
        const double turn = metres_per_radian * x[2];
        const double off = (x[0] * x[0] + x[1] * x[1] + turn * turn) / (unit_of_shift * unit_of_shift);
        return evaluation_of(evaluator_, bent(x), enough, [off](const PathMeasures&) { return off; });
      }},
      optimizer_{optimizer} {
  search_.population = options.population;
  search_.evaluations = options.evaluations;
  resumable_ = optimizer.begin(space_, search_);
}

DockingPattern NearbySearch::bent(std::span<const double> x) const {
  DockingPattern pattern = carried_;
  const Vec2 along = pattern.forth.control[1] - pattern.forth.control[0];  // the vehicle's heading there
  const Pose from = make_pose(pattern.points.forth[0], angle_of(along));
  const Shift shift{from, Frame{from}.to_world(make_pose({x[0], x[1]}, x[2]))};
  double unused = 0.0;
  for (const std::size_t i : {std::size_t{2}, std::size_t{3}}) shift.move(pattern.points.back[i], unused);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) shift.move(pattern.points.forth[i], unused);
  for (std::size_t i = 3; i < 6; ++i) shift.move(pattern.back.control[i], unused);
  for (std::size_t i = 0; i < 3; ++i) shift.move(pattern.forth.control[i], unused);
  return pattern;
}

std::optional<Continuation> NearbySearch::search(const Path& old, double driven, std::uint64_t seed, Budget& budget) {
  const Problem& problem = prepared_.problem();
  const auto rest = pattern_left(problem, old, driven);
  if (!rest) return std::nullopt;
  const auto was = pattern_of(rest->before);
  const auto carried = pattern_of(rest->carried);
  if (!was || !carried) return std::nullopt;
  carried_ = *carried;
  evaluator_.enter_with(problem.motion() ? problem.motion()->speed : 0.0);
  search_.seed = seed;
  search_.evaluations = options_.evaluations;
  if (const auto left = budget.evaluations_left()) search_.evaluations = std::min(search_.evaluations, *left / 4);
  if (search_.evaluations < 1) return std::nullopt;
  SearchResult plain;
  if (resumable_) {
    resumable_->start_over(search_);
    resumable_->advance(cost_, search_.evaluations, budget);
  } else {
    plain = optimizer_.minimise(cost_, space_, search_, budget);
  }
  const SearchResult& found = resumable_ ? resumable_->result() : plain;
  if (found.best.empty()) return std::nullopt;
  const DockingPattern best = bent(found.best);
  if (!evaluator_.evaluate(best).feasible()) return std::nullopt;
  return Continuation{problem.whole_path(pattern_path(splines_of(best)), true), greatest_move(*was, best)};
}

}  // namespace waywright
