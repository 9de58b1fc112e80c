#include "waywright/proof/moving_clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double rounding = 1e-8;          // m, of poses and distances
constexpr std::size_t most_pairs = 40'000'000;  // samples times points of tracks
constexpr double beyond = 1e-3;            // m, that distances are asked for over what is compared
constexpr double shortest_time = 0.01;     // s, of a span that is looked at
constexpr double shortest_share = 1e-3;    // of the time since the start, that is one moment: so a spread that follows a track at its own speed is settled, too
constexpr double shortest_way = 1e-3;      // m, of a step that is looked at

Map in_own_frame(const Footprint& footprint) {
  Map map;
  if (footprint.is_disc()) map.points.push_back({0.0, 0.0});
  else map.obstacles.push_back(footprint.polygon);
  return map;
}

Pose blend(const Pose& a, const Pose& b, double share) {
  return make_pose(a.position() + share * (b.position() - a.position()), wrap(a.heading + share * shorter_turn(a.heading, b.heading)));
}

void add(std::vector<TimeSpan>& spans, double from, double to) {
  if (!spans.empty() && spans.back().begin <= from && from <= spans.back().end) {
    spans.back().end = std::max(spans.back().end, to);
    return;
  }
  spans.push_back({from, to});
}

}  // namespace

MovingClearance::Body::Body(const MovingObstacle& obstacle) : world{in_own_frame(obstacle.footprint)}, grown{obstacle.footprint.is_disc() ? obstacle.footprint.disc : 0.0}, places{obstacle} {
  world.build();
}

MovingClearance::MovingClearance(const Problem& problem, double needed, double tolerance)
    : problem_{problem}, needed_{needed}, tolerance_{tolerance}, radius_{problem.footprint().radius()} {
  for (const MovingObstacle& obstacle : problem.scenario().moving) bodies_.emplace_back(obstacle);
}

double MovingClearance::distance(const Body& body, const Pose& vehicle, const Pose& obstacle, double enough) const {
  const double between = waywright::distance(vehicle.position(), obstacle.position());
  const double far = between - radius_ - problem_.scenario().moving[static_cast<std::size_t>(&body - bodies_.data())].footprint.radius();
  if (far > enough) return far;
  return body.world.least_clearance(problem_.footprint(), Frame{obstacle}.to_local(vehicle), enough + body.grown) - body.grown;
}

double MovingClearance::distance_at(const Pose& pose, std::size_t obstacle, double t, double cap) const {
  return std::min(cap, std::max(0.0, distance(bodies_[obstacle], pose, problem_.scenario().moving[obstacle].at(t), cap)));
}

/// s, from which on nothing changes any more for what is within `reach` m of a place: the obstacle stands, or has gone too far away.
double MovingClearance::last_time(const Body& body, std::size_t index, Vec2 about, double reach) const {
  const MovingObstacle& obstacle = problem_.scenario().moving[index];
  const double last = body.places.breaks().back();
  const double speed = norm(obstacle.velocity);
  if (speed == 0.0 && obstacle.spread == 0.0) return last;
  if (!(speed > obstacle.spread)) return latest_time;
  const double away = waywright::distance(obstacle.track.back().pose.position(), about) + reach + obstacle.footprint.radius() + needed_ + obstacle.off_by(last) + 1.0;
  return std::min(latest_time, last + away / (speed - obstacle.spread));
}

/// Appends when something between `low` and `high` (shares of the step) may be too near within [from, to]; true where all of [from, to] is.
bool MovingClearance::look(const Body& body, const Step& step, double low, double high, double from, double to, std::vector<TimeSpan>& spans) const {
  const MovingPlaces::Stretch there = body.places.between(from, to);
  const double moved = 0.5 * (high - low) * step.way, slack = step.slack + moved + there.reach + rounding;
  const double least = distance(body, blend(step.a, step.b, 0.5 * (low + high)), there.pose, needed_ + slack + beyond);
  if (least - slack > needed_) return false;
  const bool is_short = !(to - from > std::max(shortest_time, shortest_share * from));
  // Wherever within its spread it may be, it may also be as near as that lets it: the spread at the beginning is there all the time.
  const MovingObstacle& obstacle = problem_.scenario().moving[static_cast<std::size_t>(&body - bodies_.data())];
  if (least + (there.reach - obstacle.off_by(to)) - obstacle.off_by(from) <= needed_ || (is_short && !(2.0 * moved > shortest_way))) {
    add(spans, from, to);
    return true;
  }
  const double middle = 0.5 * (low + high), then = 0.5 * (from + to);
  if (is_short || (2.0 * moved > shortest_way && moved >= there.reach)) {
    return look(body, step, low, middle, from, to, spans) || look(body, step, middle, high, from, to, spans);
  }
  const bool first = look(body, step, low, high, from, then, spans);
  const bool second = look(body, step, low, high, then, to, spans);
  return first && second;
}

void MovingClearance::blocked(const Pose& a, const Pose& b, std::size_t obstacle, double from, double to, std::vector<TimeSpan>& spans) const {
  spans.clear();
  const Body& body = bodies_[obstacle];
  const Step step{a, b, waywright::distance(a.position(), b.position()) + radius_ * std::abs(shorter_turn(a.heading, b.heading)), a == b ? 0.0 : tolerance_};
  const double last = last_time(body, obstacle, a.position(), radius_ + step.way);
  const double until = std::min(to, std::max(from, last));
  // Even stretches of its motion one after another.
  const std::vector<double>& breaks = body.places.breaks();
  double begin = from;
  for (auto next = std::upper_bound(breaks.begin(), breaks.end(), from);; ++next) {
    const double end = next == breaks.end() ? until : std::min(until, *next);
    look(body, step, 0.0, 1.0, begin, end, spans);
    if (end >= until) break;
    begin = end;
  }
  if (to > until && (problem_.scenario().moving[obstacle].stands_from() || until >= latest_time)) {  // as it is then it stays
    std::vector<TimeSpan> then;
    look(body, step, 0.0, 1.0, until, until, then);
    if (!then.empty()) spans.push_back({until, to});
  }
  std::sort(spans.begin(), spans.end(), [](const TimeSpan& x, const TimeSpan& y) { return x.begin < y.begin; });
  auto out = spans.begin();
  for (auto in = spans.begin(); in != spans.end(); ++in) {
    if (in != spans.begin() && in->begin <= out->end) out->end = std::max(out->end, in->end);
    else if (in != spans.begin()) *++out = *in;
  }
  if (!spans.empty()) spans.erase(out + 1, spans.end());
}

bool MovingClearance::is_clear(const Pose& about, double reach, std::size_t obstacle, double from, double to) const {
  const Body& body = bodies_[obstacle];
  const MovingPlaces::Stretch there = body.places.between(from, to);
  const double slack = reach + there.reach + tolerance_ + rounding;
  return distance(body, about, there.pose, needed_ + slack + beyond) - slack > needed_;
}

namespace {

/// Halves the way until what is left is clear by one look, or one step.
class InTime {
 public:
  InTime(const Problem& problem, const std::vector<Sample>& samples, double tolerance) : samples_{samples}, clearance_{problem, problem.required_clearance(), tolerance} {
    const double radius = problem.footprint().radius();
    moved_.reserve(samples.size());
    double moved = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (i > 0) moved += distance(samples[i - 1].pose().position(), samples[i].pose().position()) + radius * std::abs(shorter_turn(samples[i - 1].heading, samples[i].heading));
      moved_.push_back(moved);
    }
  }

  struct Meeting {
    std::size_t step;
    double t;
  };
  std::optional<Meeting> first(std::size_t obstacle) { return first(obstacle, 0, samples_.size() - 1); }
  double distance_at(std::size_t obstacle, const Meeting& m) const { return clearance_.distance_at(samples_[m.step].pose(), obstacle, m.t, 10.0); }

 private:
  std::optional<Meeting> first(std::size_t obstacle, std::size_t from, std::size_t to) {
    const Sample &a = samples_[from], &b = samples_[to];
    if (to - from == 1) {
      clearance_.blocked(a.pose(), b.pose(), obstacle, a.t, b.t, spans_);
      if (spans_.empty()) return std::nullopt;
      return Meeting{from, spans_.front().begin};
    }
    const std::size_t middle = from + (to - from) / 2;
    const double reach = std::max(moved_[middle] - moved_[from], moved_[to] - moved_[middle]);
    if (clearance_.is_clear(samples_[middle].pose(), reach, obstacle, a.t, b.t)) return std::nullopt;
    if (auto found = first(obstacle, from, middle)) return found;
    return first(obstacle, middle, to);
  }

  const std::vector<Sample>& samples_;
  MovingClearance clearance_;
  std::vector<double> moved_;  // m, of any point of the footprint no more
  std::vector<TimeSpan> spans_;
};

}  // namespace

bool is_too_much_in_time(const Problem& problem, std::size_t samples) {
  std::size_t points = 0;
  for (const MovingObstacle& obstacle : problem.scenario().moving) points += obstacle.track.size();
  return points > 0 && samples > most_pairs / points;
}

std::vector<Violation> check_in_time(const Problem& problem, const std::vector<Sample>& samples, double tolerance) {
  std::vector<Violation> violations;
  const std::vector<MovingObstacle>& moving = problem.scenario().moving;
  if (moving.empty() || samples.size() < 2) return violations;
  if (is_too_much_in_time(problem, samples.size())) {
    violations.push_back({fmt::format("{} samples of the path and the tracks of what moves are too many to be held against each other", samples.size()), std::nullopt});
    return violations;
  }
  InTime in_time{problem, samples, tolerance};
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const auto meeting = in_time.first(i);
    if (!meeting) continue;
    const Pose pose = samples[meeting->step].pose();
    violations.push_back({fmt::format("{:.2f} s after the start, at s = {:.2f} m, the footprint cannot be shown to keep more than {:.3f} m from {}, which is predicted {:.3f} m away then", meeting->t,
                                      samples[meeting->step].s, problem.required_clearance(), one_line(title_of(moving[i], i)), in_time.distance_at(i, *meeting)),
                          pose});
  }
  return violations;
}

}  // namespace waywright
