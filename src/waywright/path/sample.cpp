// Samples are a view of the exact curves, dense enough for straight interpolation.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/path/path.hpp"

namespace waywright {
namespace {

constexpr int probes_per_span = 48;        // places where curvature and its rate are looked up to choose the step
constexpr double most_bends = 20000;       // steps of one piece for its bends: curves with cusps would ask for any number
constexpr double most_samples = 4'000'000;  // of a path: a few poses a million metres apart would ask for all memory

struct Density {
  double radius, tolerance, step;
};

/// Equal steps of a stretch of `length` metres with the given greatest |κ| and |dκ/ds|. Between samples Δs apart the true
/// position leaves the chord by at most κΔs²/8 and the heading leaves its interpolation by at most κ′Δs²/8.
double steps_for(double length, double curvature, double rate, const Density& density) {
  double step = density.step;
  if (curvature > 0.0) step = std::min(step, density.step / curvature);
  // A footprint point at `radius` also follows the rotation, whose chord error is radius·(κΔs)²/8.
  const double bend = curvature + density.radius * (rate + curvature * curvature);
  if (bend > 0.0) step = std::min(step, std::sqrt(8.0 * 0.8 * density.tolerance / bend));
  if (!(length > 0.0)) return 1.0;
  return std::max({1.0, std::ceil(length / density.step), std::min(most_bends, std::ceil(length / step))});
}

class Sampler {
 public:
  Sampler(const Density& density) : density_{density} {}

  void add(const Piece& piece, std::size_t index) {
    direction_ = piece.direction;
    piece_ = index;
    at_joint_ = !samples_.empty();
    std::visit([this](const auto& curve) { follow(curve); }, piece.curve);
  }

  bool full() const { return full_; }
  std::vector<Sample> take() { return full_ ? std::vector<Sample>{} : std::move(samples_); }

 private:
  void push(double s, const CurvePoint& point) {
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
    if (at_joint_) {
      at_joint_ = false;
      const Sample& before = samples_.back();
      // Smooth joints need one sample only; where the vehicle stands still, the pose stands twice.
      if (before.direction == direction_ && std::abs(before.curvature - curvature) <= 1e-6 && direction_ != 0) return;
    }
    samples_.push_back(sample);
  }

  /// The steps as a number to count to; none where the path would have too many samples.
  std::size_t room_for(double steps) {
    full_ = full_ || !(static_cast<double>(samples_.size()) + steps < most_samples);
    return full_ ? 0 : static_cast<std::size_t>(steps);
  }

  double begin() const { return samples_.empty() ? 0.0 : samples_.back().s; }

  void follow(const Line& line) {
    const double s0 = begin();
    const double total = arc_length(line);
    const std::size_t steps = room_for(steps_for(total, 0.0, 0.0, density_));
    for (std::size_t i = 0; i <= steps && !full_; ++i) {
      const double s = total * static_cast<double>(i) / static_cast<double>(steps);
      CurvePoint point = evaluate(line, s);
      if (i == steps) point.position = line.to;
      push(s0 + s, point);
    }
  }

  void follow(const Arc& arc) {
    const double s0 = begin();
    const std::size_t steps = room_for(steps_for(arc.length, std::abs(arc.curvature), 0.0, density_));
    for (std::size_t i = 0; i <= steps && !full_; ++i) {
      const double s = arc.length * static_cast<double>(i) / static_cast<double>(steps);
      push(s0 + s, evaluate(arc, s));
    }
  }

  void follow(const Spline& spline) {
    double curvature = 0.0;
    double rate = 0.0;
    double total = 0.0;
    std::vector<ArcLengthTable> tables;
    for (const BezierSpan& span : spline.spans) {
      tables.emplace_back(span);
      total += tables.back().length();
      for (int i = 0; i <= probes_per_span; ++i) {
        const CurvePoint p = evaluate(span, static_cast<double>(i) / probes_per_span);
        curvature = std::max(curvature, std::abs(p.curvature));
        rate = std::max(rate, std::abs(p.curvature_rate));
      }
    }
    const double s0 = begin();
    const std::size_t steps = room_for(steps_for(total, 1.05 * curvature, 1.2 * rate, density_));
    std::size_t span = 0;
    double before = 0.0;  // length of the spans already left behind
    for (std::size_t i = 0; i <= steps && !full_; ++i) {
      const double s = total * static_cast<double>(i) / static_cast<double>(steps);
      while (span + 1 < tables.size() && s > before + tables[span].length()) before += tables[span++].length();
      const double u = i == steps ? 1.0 : tables[span].parameter(s - before);
      push(s0 + s, evaluate(spline.spans[span], u));
    }
  }

  void follow(const Turn& turn) {
    const double s0 = begin();
    const double by = density_.radius > 0.0
                          ? std::min(density_.step, std::sqrt(8.0 * 0.8 * density_.tolerance / density_.radius))
                          : density_.step;
    const std::size_t steps = room_for(std::max(1.0, std::ceil(std::abs(turn.angle) / by)));
    for (std::size_t i = 0; i <= steps && !full_; ++i) {
      const double heading = turn.from + turn.angle * static_cast<double>(i) / static_cast<double>(steps);
      push_pose(s0, make_pose(turn.at, heading), heading, 0.0, 0.0);
    }
  }

  void follow(const PoseSequence& sequence) {
    double s = begin();
    for (std::size_t i = 0; i + 1 < sequence.poses.size() && !full(); ++i) {
      const Pose& a = sequence.poses[i];
      const Pose& b = sequence.poses[i + 1];
      const Vec2 chord = b.position() - a.position();
      const double length = norm(chord);
      const double turn = shorter_turn(a.heading, b.heading);
      const double curvature = length > 0.0 ? turn / length : 0.0;
      const double course = length > 0.0 ? angle_of(chord) : a.heading;
      const double angular = std::abs(turn) / density_.step;
      const std::size_t steps = room_for(std::max(1.0, std::ceil(std::max(length / density_.step, angular))));
      for (std::size_t k = i == 0 ? 0 : 1; k <= steps && !full_; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(steps);
        push_pose(s + t * length, make_pose(a.position() + t * chord, wrap(a.heading + t * turn)), course, curvature, 0.0);
      }
      s += length;
    }
  }

  Density density_;
  std::vector<Sample> samples_;
  int direction_ = 1;
  std::size_t piece_ = 0;
  bool at_joint_ = false;
  bool full_ = false;  // too many: nothing more is added
};

}  // namespace

std::vector<Sample> sample(const Path& path, double radius, double tolerance, double step) {
  Sampler sampler{{radius, tolerance, step}};
  for (std::size_t i = 0; i < path.pieces.size() && !sampler.full(); ++i) sampler.add(path.pieces[i], i);
  return sampler.take();
}

}  // namespace waywright
