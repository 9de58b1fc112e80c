#include "waywright/objective/fitness.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double mm = 1000.0;    // in a metre
constexpr double least = 1e-6;   // mm, for what is divided by

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum;
}

double mean_depth(const TrajectoryMeasures& m) { return sum_of(m.depth) / static_cast<double>(m.depth.size()); }

double pwavg_published(const TrajectoryMeasures& m) {
  const double depth = sum_of(m.depth) * mm;
  const double mean = mean_distance(m) * mm;
  if (depth > 0.0) return 1.0 + depth / std::max(mean, least);
  return 1.0 - mean / std::max(m.greatest * mm, least);
}

double pwavg_corrected(const TrajectoryMeasures& m) {
  const double depth = mean_depth(m);
  return depth > 0.0 ? 1.0 + depth / m.reference : 1.0 - mean_distance(m) / m.reference;
}

double levels(const TrajectoryMeasures& m, const FitnessWeights& w, bool counts_contact) {
  double value = 0.0;
  for (std::size_t i = 0; i < m.distance.size(); ++i) {
    if (m.distance[i] < w.first_level) value += w.first_weight;
    if (m.distance[i] < w.second_level) value += w.second_weight;
    if (counts_contact && m.depth[i] > 0.0) value += 1.0;
  }
  return value;
}

}  // namespace

int poses_in_contact(const TrajectoryMeasures& m) {
  return static_cast<int>(std::count_if(m.depth.begin(), m.depth.end(), [](double d) { return d > 0.0; }));
}
double least_distance(const TrajectoryMeasures& m) { return *std::min_element(m.distance.begin(), m.distance.end()); }
double mean_distance(const TrajectoryMeasures& m) { return sum_of(m.distance) / static_cast<double>(m.distance.size()); }

double fitness_of(Fitness fitness, FitnessForm form, const TrajectoryMeasures& m, const FitnessWeights& w) {
  const bool corrected = form == FitnessForm::corrected;
  if (fitness == Fitness::pwavg) return corrected ? pwavg_corrected(m) : pwavg_published(m);  // which asks nothing of the rest
  const int contacts = poses_in_contact(m);
  const double length = m.length * mm;
  switch (fitness) {
    case Fitness::mlpc: return contacts > 0 ? length * w.collision : length;
    case Fitness::mlmc: {
      const double knock_out = contacts > 0 ? w.collision : 1.0;
      return length * knock_out * (corrected ? std::max(1, contacts) : contacts);
    }
    case Fitness::mdobs: {
      const double flat = 1.0 / std::max(least_distance(m) * mm, least);
      return corrected && contacts > 0 ? flat * (1.0 + mean_depth(m) / m.reference) : flat;
    }
    case Fitness::avgmd: {
      if (!corrected) return 1.0 / std::max(mean_distance(m) * mm, least);
      const double mean = (mean_distance(m) - mean_depth(m)) * mm;  // signed
      return mean > least ? 1.0 / mean : 1.0 / least - mean;
    }
    case Fitness::pwavg: return corrected ? pwavg_corrected(m) : pwavg_published(m);
    case Fitness::levels: return levels(m, w, corrected);
  }
  return 0.0;
}

double fitness_with_margin(const TrajectoryMeasures& m, double margin) {
  const double short_by = margin - least_distance(m);
  if (short_by <= 0.0) return pwavg_corrected(m);
  double lacking = 0.0;
  for (std::size_t i = 0; i < m.distance.size(); ++i) lacking += std::max(0.0, margin - m.distance[i]) + m.depth[i];
  return 1.0 + lacking / static_cast<double>(m.distance.size()) / m.reference;
}

}  // namespace waywright
