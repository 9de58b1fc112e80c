// Samples are a view of the exact curves, dense enough for straight interpolation.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/curve/span_bounds.hpp"
#include "waywright/path/path.hpp"
#include "waywright/path/pose_motion.hpp"

namespace waywright {
namespace {

struct Density {
  double radius, tolerance, step;
  double widening = 1.0;  // of all steps, where the path would need more samples than there may be
};

double as_count(double count) { return count > 1.0 ? std::ceil(count) : 1.0; }

/// Equal steps of a stretch of `length` metres with the given greatest |κ| and |dκ/ds|, and a heading that follows the course or one of its own. Between samples
/// Δs apart the true position leaves the chord by at most κΔs²/8 and the heading leaves its interpolation by at most θ″Δs²/8.
double steps_of(double length, const CurvaturePeaks& peaks, const Density& density, const std::optional<HeadingAlong>& heading = {}) {
  const double turning = heading ? std::abs(heading->turn) / length : peaks.curvature;  // |θ′|
  const double turning_rate = heading ? 0.0 : peaks.rate;                               // |θ″|
  double step = density.step;
  if (const double fastest = std::max(peaks.curvature, turning); fastest > 0.0) step = std::min(step, density.step / fastest);
  // A footprint point at `radius` also follows the rotation, whose chord error is radius·(θ′Δs)²/8.
  const double bend = peaks.curvature + density.radius * (turning_rate + turning * turning);
  if (bend > 0.0) step = std::min(step, std::sqrt(8.0 * 0.8 * density.tolerance / bend));
  return as_count(length / step);
}

double steps_of(const Turn& turn, const Density& density) {
  const double by = density.radius > 0.0 ? std::min(density.step, std::sqrt(8.0 * 0.8 * density.tolerance / density.radius)) : density.step;
  return as_count(std::abs(turn.angle) / by);
}

/// Straight interpolation is the motion itself.
double steps_of(const Pose& a, const Pose& b, const Density& density) {
  return as_count(std::max(distance(a.position(), b.position()), std::abs(shorter_turn(a.heading, b.heading))) / density.step);
}

double steps_of(const BezierSpan& span, const Density& density) {
  return steps_of(ArcLengthTable{span}.length(), curvature_peaks(span), density);
}

double steps_of(const Clothoid& clothoid, const Density& density) {
  return steps_of(clothoid.length, {greatest_curvature(clothoid), std::abs(clothoid.curvature_rate)}, density);
}

/// At least as many, at a glance.
double coarse_steps_of(const BezierSpan& span, const Density& density) {
  return steps_of(control_length(span), coarse_curvature_peaks(span), density);
}

using SpanSteps = double (*)(const BezierSpan&, const Density&);

double steps_of(const Piece& piece, const Density& density, SpanSteps span_steps) {
  return std::visit(
      [&](const auto& curve) -> double {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Line>) {
          return steps_of(arc_length(curve), {}, density, piece.heading);
        } else if constexpr (std::is_same_v<C, Arc>) {
          return steps_of(curve.length, {std::abs(curve.curvature), 0.0}, density, piece.heading);
        } else if constexpr (std::is_same_v<C, Clothoid>) {
          return steps_of(curve, density);
        } else if constexpr (std::is_same_v<C, Turn>) {
          return steps_of(curve, density);
        } else {
          double sum = 0.0;
          if constexpr (std::is_same_v<C, Spline>) {
            for (const BezierSpan& span : curve.spans) sum += span_steps(span, density);
          } else {
            for (std::size_t i = 0; i + 1 < curve.poses.size(); ++i) sum += steps_of(curve.poses[i], curve.poses[i + 1], density);
          }
          return sum;
        }
      },
      piece.curve);
}

/// Heading and course go on as before: always so where the vehicle faces along.
bool is_smooth_joint(const Sample& before, const Sample& after) {
  return (before.faces_along && after.faces_along) || (!is_course_jump(before, after, 1e-9) && std::abs(before.turning() - after.turning()) <= 1e-6);
}

class Sampler {
 public:
  Sampler(const Density& density, std::vector<Sample>& samples) : density_{density}, samples_{samples} {}

  /// More samples were needed than there may be.
  bool is_full() const { return is_full_; }

  void add(const Piece& piece, std::size_t index) {
    direction_ = piece.direction;
    piece_ = index;
    at_joint_ = !samples_.empty();
    heading_ = piece.heading;
    length_ = heading_ ? length(piece) : 0.0;
    s0_ = begin();
    std::visit([this](const auto& curve) { follow(curve); }, piece.curve);
  }

 private:
  std::size_t count(double steps) {
    const double widened = std::ceil(steps / density_.widening);
    const bool may_widen = density_.widening == 1.0;
    if (may_widen && !(static_cast<double>(samples_.size()) + widened <= static_cast<double>(most_samples))) is_full_ = true;
    if (is_full_) return 1;
    return widened >= 1.0 ? static_cast<std::size_t>(std::min(widened, static_cast<double>(most_samples))) : 1;
  }

  void push(double s, const CurvePoint& point) {
    if (heading_) {
      const double heading = heading_->from + heading_->turn * std::min(1.0, (s - s0_) / length_);
      push_pose(s, make_pose(point.position, heading), point.course, point.curvature, point.curvature_rate);
      return;
    }
    push_pose(s, make_pose(point.position, direction_ < 0 ? wrap(point.course + pi) : point.course), point.course,
              point.curvature, point.curvature_rate);
  }

  void push_pose(double s, const Pose& pose, double course, double curvature, double rate) {
    Sample sample;
    sample.s = s;
    sample.x = pose.x;
    sample.y = pose.y;
    sample.heading = wrap(pose.heading);
    sample.course = wrap(course);
    sample.curvature = curvature;
    sample.curvature_rate = rate;
    sample.direction = direction_;
    sample.piece = piece_;
    sample.faces_along = !heading_;
    sample.heading_rate = heading_ ? heading_->turn / length_ : 0.0;
    if (at_joint_) {
      at_joint_ = false;
      const Sample& before = samples_.back();
      // Smooth joints need one sample only; where the vehicle stands still, the pose stands twice.
      if (before.direction == direction_ && std::abs(before.curvature - curvature) <= 1e-6 && direction_ != 0 && is_smooth_joint(before, sample)) return;
    }
    samples_.push_back(sample);
  }

  double begin() const { return samples_.empty() ? 0.0 : samples_.back().s; }

  void follow(const Line& line) {
    const double s0 = begin();
    const double total = arc_length(line);
    const std::size_t steps = count(steps_of(total, {}, density_, heading_));
    for (std::size_t i = 0; i <= steps; ++i) {
      const double s = total * static_cast<double>(i) / static_cast<double>(steps);
      CurvePoint point = evaluate(line, s);
      if (i == steps) point.position = line.to;
      push(s0 + s, point);
    }
  }

  void follow(const Arc& arc) {
    const double s0 = begin();
    const std::size_t steps = count(steps_of(arc.length, {std::abs(arc.curvature), 0.0}, density_, heading_));
    for (std::size_t i = 0; i <= steps; ++i) {
      const double s = arc.length * static_cast<double>(i) / static_cast<double>(steps);
      push(s0 + s, evaluate(arc, s));
    }
  }

  void follow(const Clothoid& clothoid) {
    const double s0 = begin();
    const std::size_t steps = count(steps_of(clothoid, density_));
    const ClothoidPanels panels{clothoid};
    for (std::size_t i = 0; i < steps; ++i) {
      const double s = clothoid.length * static_cast<double>(i) / static_cast<double>(steps);
      push(s0 + s, panels.at(s));
    }
    push(s0 + clothoid.length, evaluate(clothoid, clothoid.length));
  }

  /// Each span by its own bounds. Where two spans meet with different curvature, the place stands twice.
  void follow(const Spline& spline) {
    for (const BezierSpan& span : spline.spans) {
      at_joint_ = !samples_.empty();
      const ArcLengthTable table{span};
      const SpanDerivatives derivatives{span};
      const double s0 = begin();
      const double total = table.length();
      const std::size_t steps = count(steps_of(total, curvature_peaks(span), density_));
      for (std::size_t i = 0; i <= steps; ++i) {
        const double s = total * static_cast<double>(i) / static_cast<double>(steps);
        push(s0 + s, curve_point(derivatives.at(i == steps ? 1.0 : table.parameter(s))));
      }
    }
  }

  void follow(const Turn& turn) {
    const double s0 = begin();
    const std::size_t steps = count(steps_of(turn, density_));
    for (std::size_t i = 0; i <= steps; ++i) {
      const double heading = turn.from + turn.angle * static_cast<double>(i) / static_cast<double>(steps);
      push_pose(s0, make_pose(turn.at, heading), heading, 0.0, 0.0);
    }
  }

  /// Position and heading are interpolated, which is the motion itself; curvature and its rate are estimates (pose_motion.hpp).
  void follow(const PoseSequence& sequence) {
    const std::vector<EstimatedCurvature> estimates = estimated_curvature(sequence, direction_);
    double s = begin();
    for (std::size_t i = 0; i + 1 < sequence.poses.size(); ++i) {
      const Pose& a = sequence.poses[i];
      const Pose& b = sequence.poses[i + 1];
      const Vec2 chord = b.position() - a.position();
      const double length = norm(chord);
      const double turn = shorter_turn(a.heading, b.heading);
      const double course = length > 0.0 ? angle_of(chord) : a.heading;
      const std::size_t steps = count(steps_of(a, b, density_));
      for (std::size_t k = i == 0 ? 0 : 1; k <= steps; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(steps);
        push_pose(s + t * length, make_pose(a.position() + t * chord, wrap(a.heading + t * turn)), course,
                  estimates[i].curvature + t * (estimates[i + 1].curvature - estimates[i].curvature),
                  estimates[i].rate + t * (estimates[i + 1].rate - estimates[i].rate));
      }
      s += length;
    }
  }

  Density density_;
  std::vector<Sample>& samples_;
  int direction_ = 1;
  std::size_t piece_ = 0;
  std::optional<HeadingAlong> heading_;
  double length_ = 0.0, s0_ = 0.0;  // m, of the piece, where a heading is told along it; where it begins
  bool at_joint_ = false;
  bool is_full_ = false;
};

/// False, and not all of them, where more than there may be were needed and steps were not widened.
bool sampled(const Path& path, const Density& density, std::vector<Sample>& samples) {
  samples.clear();
  Sampler sampler{density, samples};
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    sampler.add(path.pieces[i], i);
    if (sampler.is_full()) return false;
  }
  return true;
}

double all_samples(const Path& path, const Density& density, SpanSteps span_steps) {
  double needed = 1.0;
  for (const Piece& piece : path.pieces) needed += 1.0 + steps_of(piece, density, span_steps);
  return needed;
}

}  // namespace

double samples_needed(const Path& path, double radius, double tolerance, double step) {
  return all_samples(path, {radius, tolerance, step}, steps_of);
}

bool can_be_sampled(const Path& path, double radius, double tolerance, double step) {
  return all_samples(path, {radius, tolerance, step}, coarse_steps_of) <= most_samples || samples_needed(path, radius, tolerance, step) <= most_samples;
}

std::vector<Sample> sample(const Path& path, double radius, double tolerance, double step) {
  std::vector<Sample> samples;
  sample(path, radius, tolerance, step, samples);
  return samples;
}

void sample(const Path& path, double radius, double tolerance, double step, std::vector<Sample>& samples) {
  if (sampled(path, {radius, tolerance, step}, samples)) return;
  sampled(path, {radius, tolerance, step, std::max(1.0, samples_needed(path, radius, tolerance, step) / static_cast<double>(most_samples))}, samples);
}

}  // namespace waywright
