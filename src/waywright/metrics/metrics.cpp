#include "waywright/metrics/metrics.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/core/elementary.hpp"
#include "waywright/path/pose_motion.hpp"

namespace waywright {
namespace {

constexpr double printed_step = 0.05;  // m, sample distance of the published curvature change

/// Curvature of the path by arc length, exact from its curves.
class CurvatureAlong {
 public:
  /// Pieces [first, last) of one direction.
  CurvatureAlong(const Path& path, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      direction_ = path.pieces[i].direction;
      std::visit([this](const auto& curve) { add(curve); }, path.pieces[i].curve);
    }
  }

  double length() const { return length_; }

  double at(double s) const {
    const auto after = std::upper_bound(parts_.begin(), parts_.end(), s,
                                        [](double value, const Part& part) { return value < part.begin; });
    const Part& part = after == parts_.begin() ? parts_.front() : *(after - 1);
    if (part.spline == nullptr) return part.curvature + part.slope * (s - part.begin);
    return evaluate(*part.spline, spans_[part.table].parameter(s - part.begin)).curvature;
  }

 private:
  struct Part {
    double begin = 0.0;                  // m
    double curvature = 0.0;              // at its begin, where it is constant or linear
    double slope = 0.0;                  // 1/m²
    const BezierSpan* spline = nullptr;  // where it is neither
    std::size_t table = 0;
  };

  void add_linear(double length, double from, double to) {
    if (!(length > 0.0)) return;
    parts_.push_back({length_, from, (to - from) / length});
    length_ += length;
  }
  void add(const Line& line) { add_linear(arc_length(line), 0.0, 0.0); }
  void add(const Arc& arc) { add_linear(arc.length, arc.curvature, arc.curvature); }
  void add(const Clothoid& clothoid) { add_linear(clothoid.length, clothoid.curvature, end_curvature(clothoid)); }
  void add(const Turn&) {}
  void add(const PoseSequence& sequence) {
    const std::vector<EstimatedCurvature> estimates = estimated_curvature(sequence, direction_);
    for (std::size_t i = 0; i + 1 < sequence.poses.size(); ++i) {
      add_linear(distance(sequence.poses[i].position(), sequence.poses[i + 1].position()), estimates[i].curvature, estimates[i + 1].curvature);
    }
  }
  void add(const Spline& spline) {
    for (const BezierSpan& span : spline.spans) {
      ArcLengthTable table{span};
      if (!(table.length() > 0.0)) continue;
      parts_.push_back({length_, 0.0, 0.0, &span, spans_.size()});
      length_ += table.length();
      spans_.push_back(std::move(table));
    }
  }

  std::vector<Part> parts_;
  std::vector<ArcLengthTable> spans_;
  double length_ = 0.0;
  int direction_ = 1;
};

/// Σ|Δκ|/Δs with n = max(1, round(L / 0.05 m)) equal steps along each stretch of one direction, ends
/// included.
double printed_curvature_change(const Path& path) {
  double sum = 0.0;
  for (std::size_t first = 0; first < path.pieces.size();) {
    std::size_t last = first + 1;
    while (last < path.pieces.size() && path.pieces[last].direction == path.pieces[first].direction) ++last;
    const CurvatureAlong stretch{path, first, last};
    first = last;
    if (!(stretch.length() > 0.0)) continue;
    const auto n = static_cast<std::size_t>(std::max(1.0, std::round(stretch.length() / printed_step)));
    const double step = stretch.length() / static_cast<double>(n);
    double before = stretch.at(0.0);
    for (std::size_t i = 1; i <= n; ++i) {
      const double curvature = stretch.at(static_cast<double>(i) * step);
      sum += std::abs(curvature - before) / step;
      before = curvature;
    }
  }
  return sum;
}

int changes_of_direction(const std::vector<Sample>& samples) {
  int changes = 0;
  int driving = 0;
  for (const Sample& sample : samples) {
    if (sample.direction == 0) continue;
    if (driving != 0 && sample.direction != driving) ++changes;
    driving = sample.direction;
  }
  return changes;
}

double risk(double clearance) {
  const double ratio = clearance / risk_scale;
  return exponential(-0.5 * ratio * ratio);
}

}  // namespace

std::vector<double> clearances(const std::vector<Sample>& samples, const std::function<double(const Sample&)>& at) {
  std::vector<double> found;
  found.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0 && samples[i].pose() == samples[i - 1].pose() && samples[i].piece == samples[i - 1].piece) {
      found.push_back(found.back());
      continue;
    }
    found.push_back(std::min(clearance_cap, at(samples[i])));
  }
  return found;
}

Metrics measure(const Path& path, const std::vector<Sample>& samples, const std::vector<double>& clearances) {
  Metrics metrics;
  metrics.length = length(path);
  metrics.curvature_change_printed = printed_curvature_change(path);
  if (samples.empty()) return metrics;
  metrics.min_clearance = *std::min_element(clearances.begin(), clearances.end());
  metrics.direction_changes = changes_of_direction(samples);
  metrics.travel_time = samples.back().t;
  double clearance_integral = 0.0;
  double driven = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    metrics.max_curvature = std::max(metrics.max_curvature, std::abs(sample.curvature));
    metrics.max_curvature_rate = std::max(metrics.max_curvature_rate, std::abs(sample.curvature_rate));
    if (i == 0) continue;
    const Sample& before = samples[i - 1];
    const double step = sample.s - before.s;
    driven += step;
    clearance_integral += 0.5 * step * (clearances[i - 1] + clearances[i]);
    metrics.collision_risk += 0.5 * step * (risk(clearances[i - 1]) + risk(clearances[i]));
    metrics.turning += std::abs(shorter_turn(before.heading, sample.heading));
    const bool at_joint = step == 0.0 && before.piece != sample.piece;
    if (!at_joint && !is_direction_change(before, sample))
      metrics.curvature_change += std::abs(sample.curvature - before.curvature);
  }
  if (driven > 0.0) {
    metrics.mean_clearance = clearance_integral / driven;
  } else {  // only turns on the spot: no length to average over
    std::size_t places = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (i > 0 && samples[i].heading == samples[i - 1].heading) continue;  // a wait, or a joint
      metrics.mean_clearance += clearances[i];
      ++places;
    }
    metrics.mean_clearance /= static_cast<double>(places);
  }
  return metrics;
}

}  // namespace waywright
