#include "waywright/planner/waypoint/chain.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/clothoid.hpp"

namespace waywright {

std::optional<Clothoids> chain_through(std::span<const Pose> poses, Continuity continuity, std::span<const double> bends) {
  Clothoids singles;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const auto leg = fit_clothoid(poses[i], poses[i + 1]);
    if (!leg) return std::nullopt;
    singles.push_back(*leg);
  }
  if (continuity == Continuity::g1) return singles;
  Clothoids chain;
  CurvaturePose from{poses.front(), 0.0};
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const bool is_last = i + 1 == singles.size();
    const CurvaturePose to{poses[i + 1], is_last ? 0.0 : 0.5 * (end_curvature(singles[i]) + singles[i + 1].curvature) + (bends.empty() ? 0.0 : bends[i])};
    const auto leg = fit_clothoids(from, to);
    if (!leg) return std::nullopt;
    chain.insert(chain.end(), leg->begin(), leg->end());
    from = to;
  }
  return chain;
}

Path path_of(const Clothoids& chain) {
  Path path;
  for (const Clothoid& c : chain) path.pieces.push_back({c, 1});
  return path;
}

double length_of(const Clothoids& chain) {
  double sum = 0.0;
  for (const Clothoid& c : chain) sum += c.length;
  return sum;
}

double greatest_curvature(const Clothoids& chain) {
  double greatest = 0.0;
  for (const Clothoid& c : chain) greatest = std::max(greatest, greatest_curvature(c));
  return greatest;
}

double greatest_curvature_rate(const Clothoids& chain) {
  double greatest = 0.0;
  for (const Clothoid& c : chain) greatest = std::max(greatest, std::abs(c.curvature_rate));
  return greatest;
}

void sample_evenly(const Clothoids& chain, std::size_t n, std::vector<Pose>& poses) {
  poses.clear();
  const double step = length_of(chain) / static_cast<double>(n - 1);
  std::size_t leg = 0;
  double begin = 0.0;
  // From sample to sample: what lies between turns by little.
  Clothoid rest = chain.front();
  double done = 0.0;  // m of the leg that `rest` leaves out
  for (std::size_t i = 0; i < n; ++i) {
    const double s = std::min(static_cast<double>(i) * step, begin + chain[leg].length + step);
    while (leg + 1 < chain.size() && s > begin + chain[leg].length) {
      begin += chain[leg].length;
      rest = chain[++leg];
      done = 0.0;
    }
    const double here = std::clamp(s - begin, 0.0, chain[leg].length);
    const CurvePoint point = evaluate(rest, here - done);
    poses.push_back(make_pose(point.position, point.course));
    rest = {make_pose(point.position, course_at(chain[leg], here)), chain[leg].curvature + chain[leg].curvature_rate * here, chain[leg].curvature_rate, chain[leg].length - here};
    done = here;
  }
}

}  // namespace waywright
