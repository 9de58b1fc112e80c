#include "waywright/planner/docking/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "waywright/curve/bezier.hpp"
#include "waywright/planner/docking/sweep.hpp"

namespace waywright {
namespace {

constexpr double limit_share = 0.9995;  // of curvature and its rate: what the peak between samples may be off by
constexpr double end_reserve = 1e-6;    // m: start and docked pose were checked as such and may stand exactly at the required clearance

// Bands of the graded cost. Costs of feasible paths are of the order of 1.
constexpr double contact_band = 1000.0;
constexpr double limit_band = 100.0;

lanes::Quintic lane_quintic(const BezierSpan& span, Vec2 origin, int direction, bool is_bent) {
  const auto f = [](double v) { return static_cast<float>(v); };
  const Vec2 from = span.control[0] - origin;
  const Vec2 chord = span.control[5] - span.control[0];
  const Vec2 tangent = 5.0 * (span.control[1] - span.control[0]);
  const Vec2 end = 5.0 * (span.control[5] - span.control[4]);
  const Vec2 bend = is_bent ? 20.0 * ((span.control[2] - span.control[1]) - (span.control[1] - span.control[0])) : Vec2{};
  return {f(from.x), f(from.y), f(chord.x), f(chord.y), f(tangent.x), f(tangent.y), f(end.x), f(end.y), f(bend.x), f(bend.y), direction < 0 ? -1.0F : 1.0F};
}

bool is_open(const lanes::Screen& screen, int interval) {
  constexpr int each = lanes::width - 1;
  return (screen.open[interval / each] >> (interval % each) & 1) != 0;
}

double length_up_to(const lanes::Track& track, int sample) {
  std::array<double, 4> length{};  // side by side: one sum would wait for itself
  for (int i = 0; i < sample; ++i) length[static_cast<std::size_t>(i % 4)] += static_cast<double>(track.step[i]);
  return (length[0] + length[1]) + (length[2] + length[3]);
}

double straight_lengths(const PatternPoints& p) {
  return distance(p.back[0], p.back[1]) + distance(p.back[2], p.back[3]) + distance(p.forth[0], p.forth[1]) +
         distance(p.forth[2], p.forth[3]);
}

}  // namespace

CandidateEvaluator::CandidateEvaluator(const PreparedDocking& prepared, const lanes::Kernels& kernels)
    : prepared_{prepared},
      kernels_{kernels},
      field_{prepared.lane_field()},
      sweep_{prepared},
      curvature_limit_{prepared.problem().vehicle().max_curvature() * limit_share},
      has_rate_limit_{prepared.problem().vehicle().limits.curvature_rate.has_value()},
      rate_limit_{prepared.problem().vehicle().limits.curvature_rate.value_or(std::numeric_limits<double>::infinity()) *
                  limit_share} {
  if (!prepared.problem().motion()) return;
  entry_.resize(lanes::samples + 2);  // with both straight runs
  timing_.reserve(entry_.size());
}

CandidateScore CandidateEvaluator::measure(const DockingPattern& pattern) {
  CandidateScore score;
  const Vec2 origin = prepared_.field().origin();
  kernels_.trace(lane_quintic(pattern.back, origin, -1, pattern.is_bent_at_start), has_rate_limit_ || entry_speed_ > 0.0, tracks_[0]);
  kernels_.trace(lane_quintic(pattern.forth, origin, 1, false), has_rate_limit_, tracks_[1]);
  PathMeasures& m = score.measures;
  m.length = straight_lengths(pattern.points);
  for (const lanes::Track& track : tracks_) {
    m.length += static_cast<double>(track.length);
    m.curvature_change += static_cast<double>(track.curvature_change);
    m.max_curvature = std::max(m.max_curvature, static_cast<double>(track.max_curvature));
    if (has_rate_limit_) score.max_curvature_rate = std::max(score.max_curvature_rate, static_cast<double>(track.max_rate));
  }
  const auto over = [](double value, double limit) { return value > limit ? value / limit - 1.0 : 0.0; };
  score.excess = over(m.max_curvature, curvature_limit_) + over(score.max_curvature_rate, rate_limit_);
  if (entry_speed_ > 0.0) {
    score.entry_excess = entry_excess(pattern.points);
    score.excess += score.entry_excess;
  }
  if (!std::isfinite(score.excess) || !std::isfinite(m.length)) score.excess = 1e6;
  return score;
}

void CandidateEvaluator::enter_with(double speed) { entry_speed_ = speed; }

/// How far the speed is over that with which the way back can be entered, at the end of which the vehicle stands.
double CandidateEvaluator::entry_excess(const PatternPoints& points) {
  const lanes::Track& track = tracks_[0];
  const double head = distance(points.back[0], points.back[1]);
  for (Sample& sample : entry_) sample = {.direction = -1};
  for (std::size_t i = 0; i < lanes::samples; ++i) {
    Sample& sample = entry_[i + 1];
    sample.s = i == 0 ? head : entry_[i].s + static_cast<double>(track.step[i - 1]);
    sample.curvature = static_cast<double>(track.curvature[i]);
    sample.curvature_rate = static_cast<double>(track.rate[i]);
  }
  // The straight run before the bend counts where there is one; else the sample there is the first of the bend once more.
  if (head == 0.0) entry_.front().curvature = entry_[1].curvature;
  entry_.back().s = entry_[lanes::samples].s + distance(points.back[2], points.back[3]);
  const Vehicle& vehicle = prepared_.problem().vehicle();
  if (can_start_with(entry_, vehicle, entry_speed_, timing_)) return 0.0;
  constexpr double least = 1e-6;  // it is over
  const double greatest = greatest_start_speed(entry_, vehicle, timing_);
  return greatest > 0.0 ? std::max(least, entry_speed_ / greatest - 1.0) : 1e3;
}

Placement CandidateEvaluator::pose_at(const lanes::Track& track, std::size_t i) const {
  return {prepared_.field().origin() + Vec2{static_cast<double>(track.x[i]), static_cast<double>(track.y[i])},
          {static_cast<double>(track.heading_x[i]), static_cast<double>(track.heading_y[i])}};
}

/// How far a pose of interval i can be from the straight interpolation of its ends: from the bend of the positions and the turning, with half
/// as much again for what they do between samples.
double CandidateEvaluator::bow_of(const lanes::Track& track, std::size_t i) const {
  const auto bend = [&](std::size_t k) {
    const Vec2 before{track.x[k - 1], track.y[k - 1]}, here{track.x[k], track.y[k]}, after{track.x[k + 1], track.y[k + 1]};
    return norm(before - 2.0 * here + after);
  };
  constexpr std::size_t last = lanes::samples - 2;
  const double position = std::max(bend(std::max<std::size_t>(i, 1)), bend(std::min(i + 1, last))) / 8.0;
  const double step = static_cast<double>(track.step[i]);
  const double turned = static_cast<double>(track.turn[i]);
  const double next = static_cast<double>(track.step[std::min(i + 1, last)]);
  const double before = static_cast<double>(track.step[i > 0 ? i - 1 : i]);
  const double uneven = step * std::abs(static_cast<double>(track.curvature[i + 1]) - static_cast<double>(track.curvature[i])) +
                        turned * std::abs(next - before) / std::max(step, 1e-9);
  return 1.5 * (position + prepared_.radius() * (turned * turned + uneven) / 8.0);
}

void CandidateEvaluator::check(const DockingPattern& pattern, CandidateScore& score) {
  const auto& [back, forth] = pattern.points;
  const auto heading_of = [](const BezierSpan& span, bool at_end, double facing) {
    const Vec2 tangent = at_end ? span.control[5] - span.control[4] : span.control[1] - span.control[0];
    const double speed = norm(tangent);
    return speed > 0.0 ? (facing / speed) * tangent : Vec2{1.0, 0.0};
  };
  const double wanted = prepared_.wanted_clearance();
  const double at_ends = prepared_.problem().required_clearance() - end_reserve;
  const auto blocked = [&](double driven, Vec2 at, Vec2 heading) {
    score.reach = score.measures.length > 0.0 ? std::clamp(driven / score.measures.length, 0.0, 1.0) : 0.0;
    score.blocked_at = make_pose(at, angle_of(heading));
    constexpr double least_deficit = 1e-9;  // m²: what is blocked is never feasible, whatever the measure says
    score.deficit += least_deficit;
  };

  std::array<lanes::Screen, 2> screens;
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    kernels_.screen(tracks_[k], prepared_.coarse(), prepared_.fine(), field_, screens[k]);
    score.deficit += static_cast<double>(screens[k].deficit);
  }

  // The straight runs out of the start and into the docked pose are the same for every candidate.
  const double head = distance(back[0], back[1]);
  const double tail = distance(forth[2], forth[3]);
  if (head > 0.0 && !start_run_.is_clear(sweep_, back[0], back[1], heading_of(pattern.back, false, -1.0), at_ends)) {
    return blocked(0.0, back[1], heading_of(pattern.back, false, -1.0));
  }

  // What is surely too near ends it before anything is looked at closely.
  const double middle = head + static_cast<double>(tracks_[0].length) + 2.0 * distance(back[2], back[3]);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const lanes::Screen& screen = screens[k];
    const int hit = screen.hit;
    if (hit == lanes::samples) continue;
    int known = hit;
    while (known > 0 && is_open(screen, known - 1)) --known;
    const Placement pose = pose_at(tracks_[k], static_cast<std::size_t>(hit));
    return blocked((k == 0 ? head : middle) + length_up_to(tracks_[k], known), pose.position, pose.heading);
  }

  // Poses first: most of what is not free shows at one, and sweeps cost more.
  struct Interval {
    std::size_t track;
    int index;
  };
  std::array<Interval, 2 * (lanes::samples - 1)> unsettled;
  std::size_t count = 0;
  const auto is_at_end = [&](std::size_t k, int i) { return (k == 0 && i == 0 && head == 0.0) || (k == 1 && i + 2 == lanes::samples && tail == 0.0); };
  const auto driven_to = [&](std::size_t k, int i) { return (k == 0 ? head : middle) + length_up_to(tracks_[k], i); };
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    for (int i = 0; i + 1 < lanes::samples; ++i) {
      if (!is_open(screens[k], i)) continue;
      const auto at = static_cast<std::size_t>(i);
      if (!is_at_end(k, i)) {
        const Placement end = pose_at(tracks_[k], at + 1);
        if (sweep_.is_surely_clear(pose_at(tracks_[k], at), end, wanted, bow_of(tracks_[k], at))) continue;
        if (!sweep_.is_free(end, wanted)) return blocked(driven_to(k, i), end.position, end.heading);
      }
      unsettled[count++] = {k, i};
    }
  }
  if (back[2] != back[3] && !sweep_.is_clear(back[2], back[3], heading_of(pattern.back, true, -1.0), wanted)) {
    return blocked(middle - distance(back[2], back[3]), back[3], heading_of(pattern.back, true, -1.0));
  }
  if (tail > 0.0 && !dock_run_.is_clear(sweep_, forth[2], forth[3], heading_of(pattern.forth, true, 1.0), at_ends)) {
    return blocked(score.measures.length - tail, forth[3], heading_of(pattern.forth, true, 1.0));
  }
  for (const auto [k, i] : std::span{unsettled.data(), count}) {
    const SweptQuintic quintic{k == 0 ? pattern.back : pattern.forth, k == 0 ? -1 : 1};
    constexpr double h = 1.0 / (lanes::samples - 1);
    if (sweep_.is_clear(quintic, i * h, (i + 1) * h, is_at_end(k, i) ? at_ends : wanted)) continue;
    const SweptQuintic::State state = quintic.at((i + 1) * h);
    return blocked(driven_to(k, i), state.position, state.heading);
  }
  score.reach = 1.0;
  score.deficit = 0.0;
  score.free = true;
}

bool CandidateEvaluator::KnownRun::is_clear(Sweep& sweep, Vec2 begin, Vec2 end, Vec2 along, double margin) {
  if (!known || begin != from || end != to || along != heading) {
    from = begin;
    to = end;
    heading = along;
    known = true;
    clear = sweep.is_clear(from, to, heading, margin);
  }
  return clear;
}

double graded_cost(const CandidateScore& score, double base) {
  double cost = std::isfinite(base) ? std::min(base, 50.0) : 50.0;
  if (score.excess > 0.0) cost += limit_band + limit_band * score.excess / (1.0 + score.excess);
  if (!score.free) cost += contact_band * (2.0 - score.reach);
  return cost;
}

}  // namespace waywright
