#include "waywright/planner/waypoint/chain.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/clothoid.hpp"

namespace waywright {

std::optional<Clothoids> chain_through(std::span<const Pose> poses, Continuity continuity, std::span<const double> bends, std::size_t* unsolved) {
  const auto none_at = [&](std::size_t leg) -> std::optional<Clothoids> {
    if (unsolved != nullptr) *unsolved = leg;
    return std::nullopt;
  };
  std::vector<std::optional<Clothoid>> legs(poses.size() - 1);
  fit_clothoid_batch(poses.first(poses.size() - 1), poses.subspan(1), legs);
  Clothoids singles;
  singles.reserve(legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (!legs[i]) return none_at(i);
    singles.push_back(*legs[i]);
  }
  if (continuity == Continuity::g1) return singles;
  Clothoids chain;
  CurvaturePose from{poses.front(), 0.0};
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const bool is_last = i + 1 == singles.size();
    const CurvaturePose to{poses[i + 1], is_last ? 0.0 : 0.5 * (end_curvature(singles[i]) + singles[i + 1].curvature) + (bends.empty() ? 0.0 : bends[i])};
    const auto leg = fit_clothoids(from, to);
    if (!leg) return none_at(i);
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
  poses.reserve(n);
  const double step = length_of(chain) / static_cast<double>(n - 1);
  double begin = 0.0;  // m, of the leg
  for (std::size_t leg = 0; leg < chain.size(); ++leg) {
    const double end = begin + chain[leg].length;
    const std::size_t first = poses.size();
    // What rounding leaves beyond the end is of the next leg, or the end itself.
    const auto last = leg + 1 == chain.size() ? n - 1 : static_cast<std::size_t>(std::clamp(std::floor(end / step), 0.0, static_cast<double>(n - 1)));
    if (first > last) {
      begin = end;
      continue;
    }
    const double here = static_cast<double>(first) * step - begin;
    sample_clothoid(chain[leg], std::clamp(here, 0.0, chain[leg].length), step, last - first + 1, poses);
    begin = end;
  }
}

}  // namespace waywright
