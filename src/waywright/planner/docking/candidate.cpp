#include "waywright/planner/docking/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

constexpr int steps_per_quintic = 96;
constexpr double reserve = 0.001;        // m kept beyond what is required, so that the proof never ends on a knife's edge
constexpr double limit_share = 0.9995;   // of curvature and its rate: what the peak between samples may be off by
constexpr double least_step = 0.002;     // m of motion below which a passage counts as blocked
constexpr double far_enough = 0.4;       // m of clearance beyond what is required: more says nothing

// Bands of the graded cost. Costs of feasible paths are of the order of 1.
constexpr double contact_band = 1000.0;
constexpr double limit_band = 100.0;

/// Greatest value of a smooth function from samples at equal steps: between three of them whose middle is the highest, the top
/// of the parabola through them.
class Peak {
 public:
  double add(double value, bool first_of_run) {
    count_ = first_of_run ? 1 : count_ + 1;
    greatest_ = std::max(greatest_, value);
    if (count_ > 2 && b_ >= a_ && b_ >= value) {
      const double bend = a_ - 2.0 * b_ + value;
      if (bend < 0.0) greatest_ = std::max(greatest_, b_ - (a_ - value) * (a_ - value) / (8.0 * bend));
    }
    a_ = b_;
    b_ = value;
    return greatest_;
  }

 private:
  double a_ = 0.0, b_ = 0.0, greatest_ = 0.0;
  int count_ = 0;
};

}  // namespace

CandidateEvaluator::CandidateEvaluator(const Problem& problem)
    : problem_{problem},
      radius_{problem.vehicle().footprint.is_disc() ? 0.0 : problem.vehicle().footprint.radius()},
      required_{problem.required_clearance() + reserve},
      curvature_limit_{problem.vehicle().max_curvature() * limit_share},
      rate_limit_{problem.vehicle().limits.curvature_rate.value_or(std::numeric_limits<double>::infinity()) * limit_share} {}

void CandidateEvaluator::sample(const std::array<Spline, 2>& splines, CandidateScore& score) {
  states_.clear();
  double s = 0.0;
  double turned = 0.0;
  Peak curvature_peak, rate_peak;
  PathMeasures& m = score.measures;
  for (std::size_t k = 0; k < splines.size(); ++k) {
    const double facing = k == 0 ? pi : 0.0;
    double last_curvature = 0.0;
    for (std::size_t i = 0; i < splines[k].spans.size(); ++i) {
      const BezierSpan& span = splines[k].spans[i];
      const int steps = span.degree == 1 ? 1 : steps_per_quintic;
      const double h = 1.0 / steps;
      double last_speed = 0.0;
      double last_turn_rate = 0.0;
      for (int j = 0; j <= steps; ++j) {
        const double u = h * j;
        const Derivatives d = derivatives(span, u);
        const CurvePoint point = curve_point(d);
        const double speed = norm(d.d1);
        const double turn_rate = std::abs(point.curvature) * speed;
        if (j > 0) {
          s += 0.5 * h * (last_speed + speed);
          turned += 0.5 * h * (last_turn_rate + turn_rate);
        }
        last_speed = speed;
        last_turn_rate = turn_rate;
        m.max_curvature = curvature_peak.add(std::abs(point.curvature), j == 0);
        score.max_curvature_rate = rate_peak.add(std::abs(point.curvature_rate), j == 0);
        if (j > 0 || i > 0) m.curvature_change += std::abs(point.curvature - last_curvature);
        last_curvature = point.curvature;
        if (j == 0 && !states_.empty()) continue;  // joints stand once
        states_.push_back({make_pose(point.position, point.course + facing), s, turned, k, i, u});
      }
    }
  }
  m.length = s;
}

CandidateEvaluator::State CandidateEvaluator::between(const std::array<Spline, 2>& splines, const State& a,
                                                      const State& b) const {
  // b closes an interval of one span; a may still be counted to the span before it (u = 1 there is u = 0 here).
  State middle = b;
  const double u0 = a.spline == b.spline && a.span == b.span ? a.u : 0.0;
  middle.u = 0.5 * (u0 + b.u);
  const CurvePoint point = waywright::evaluate(splines[b.spline].spans[b.span], middle.u);
  middle.pose = make_pose(point.position, point.course + (b.spline == 0 ? pi : 0.0));
  middle.s = 0.5 * (a.s + b.s);
  middle.turned = 0.5 * (a.turned + b.turned);
  return middle;
}

/// Goes along the samples as far as the clearance lets it; halves where two neighbours do not reach each other.
void CandidateEvaluator::drive(const std::array<Spline, 2>& splines, CandidateScore& score) const {
  const Footprint& footprint = problem_.vehicle().footprint;
  const auto slack_at = [&](const State& state, Contact& contact) {
    contact = problem_.world().clearance(footprint, state.pose, required_ + far_enough);
    return std::min(contact.clearance - required_, far_enough);
  };
  const auto motion = [&](const State& a, const State& b) { return (b.s - a.s) + radius_ * (b.turned - a.turned); };

  Contact contact;
  const auto block = [&](const State& at, const Contact& by) {
    score.reach = at.s;
    score.contact = by;
    score.free = false;
  };
  std::size_t at = 0;
  double slack = std::max(slack_at(states_[0], contact), reserve);  // the ends have been checked as such
  while (at + 1 < states_.size()) {
    // The farthest sample that this slack and an equal one there could bridge.
    std::size_t next = at + 1;
    while (next + 1 < states_.size() && motion(states_[at], states_[next + 1]) < 1.8 * slack) ++next;
    double next_slack = 0.0;
    for (;;) {
      next_slack = slack_at(states_[next], contact);
      if (next + 1 == states_.size()) next_slack = std::max(next_slack, reserve);
      if (slack + next_slack > motion(states_[at], states_[next]) && next_slack > 0.0) break;
      if (next == at + 1) {
        // Neighbours: look at the curve between them, ever closer.
        State a = states_[at];
        double a_slack = slack;
        std::array<State, 24> ahead;
        std::size_t count = 0;
        ahead[count++] = states_[next];
        while (count > 0) {
          const State b = ahead[count - 1];
          Contact by;
          double b_slack = slack_at(b, by);
          if (next + 1 == states_.size() && count == 1) b_slack = std::max(b_slack, reserve);
          if (b_slack <= 0.0) return block(a, by);
          if (a_slack + b_slack > motion(a, b)) {
            a = b;
            a_slack = b_slack;
            --count;
            continue;
          }
          if (motion(a, b) < least_step || count == ahead.size()) return block(a, by);
          ahead[count++] = between(splines, a, b);
        }
        next_slack = a_slack;
        break;
      }
      next = at + (next - at) / 2;
    }
    at = next;
    slack = next_slack;
  }
  score.reach = states_.back().s;
  score.free = true;
}

CandidateScore CandidateEvaluator::evaluate(const std::array<Spline, 2>& splines, bool check_contact) {
  CandidateScore score;
  sample(splines, score);
  const auto over = [](double value, double limit) { return value > limit ? value / limit - 1.0 : 0.0; };
  score.excess = over(score.measures.max_curvature, curvature_limit_) + over(score.max_curvature_rate, rate_limit_);
  if (!std::isfinite(score.excess)) score.excess = 1e6;
  if (check_contact) drive(splines, score);
  return score;
}

double graded_cost(const CandidateScore& score, double base) {
  double cost = std::isfinite(base) ? std::min(base, 50.0) : 50.0;
  if (score.excess > 0.0) cost += limit_band + limit_band * score.excess / (1.0 + score.excess);
  if (!score.free) {
    const double share = score.measures.length > 0.0 ? score.reach / score.measures.length : 0.0;
    cost += contact_band * (2.0 - share);
  }
  return cost;
}

}  // namespace waywright
