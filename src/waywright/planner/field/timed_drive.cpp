#include "waywright/planner/field/timed_drive.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/proof/moving_clearance.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

constexpr double no_turn = 1e-9;        // rad
constexpr double least_wait = 1e-6;     // s
constexpr double tolerance = ProofOptions{}.tolerance;

/// The way of one that faces along from a heading: what it turns by before it drives is a piece of its own.
class Driven {
 public:
  explicit Driven(double heading) : heading_{heading} {}
  void turn_by(Vec2 at, double angle) {
    if (std::abs(angle) > no_turn) path_.pieces.push_back({Turn{at, heading_, angle}, 0, {}});
    heading_ = wrap(heading_ + angle);
  }
  void turn_to(Vec2 at, double heading) { turn_by(at, shorter_turn(heading_, heading)); }
  void line(Vec2 from, Vec2 to, int direction) {
    if (!(distance(from, to) > 0.0)) return;
    turn_to(from, direction > 0 ? angle_of(to - from) : wrap(angle_of(to - from) + pi));
    path_.pieces.push_back({Line{from, to}, direction, {}});
  }
  void curve(const Curve& curve) {
    path_.pieces.push_back({curve, 1, {}});
    heading_ = end_pose(path_.pieces.back()).heading;
  }
  double heading() const { return heading_; }
  Path& path() { return path_; }

 private:
  Path path_;
  double heading_;
};

/// Straight stretches of one course as one.
std::vector<Curve> curves_of(const FreeMotion& motion, const std::vector<LocalDriven>& driven) {
  std::vector<Curve> curves;
  double course = 0.0;
  for (const LocalDriven& d : driven) {
    if (d.step.kind != FreeStep::Kind::drive) continue;
    const Curve curve = motion.curve(d.before, d.step);
    const auto* line = std::get_if<Line>(&curve);
    auto* before = curves.empty() ? nullptr : std::get_if<Line>(&curves.back());
    if (line != nullptr && before != nullptr && d.step.begins == course && before->to == line->from) before->to = d.step.after.at;
    else curves.push_back(curve);
    course = d.step.begins;
    if (auto* last = std::get_if<Line>(&curves.back())) last->to = d.step.after.at;
  }
  return curves;
}

}  // namespace

TimedDrive::TimedDrive(const PlaneSpace& space, const PlaneEnd& start, const PlaneEnd& goal) : space_{space}, start_{start}, goal_{goal} {
  const Problem& problem = space.problem();
  begin_.at = start.at;
  const Path first = problem.whole_path(before());
  begin_.course = first.pieces.empty() ? problem.start().heading : problem.vehicle().moves_any_way() ? problem.start().heading : end_pose(first).heading;
  if (first.pieces.empty() || problem.is_driven_back() || problem.pocket()) return;
  std::vector<Sample> samples = sample(first, problem.footprint().radius(), tolerance);
  SpeedWorkspace workspace;
  begin_.t = assign_speed(samples, problem.vehicle(), problem.motion() ? problem.motion()->speed : 0.0, workspace, zone_limits(problem, samples, tolerance));
  s_begin_ = samples.back().s;
}

Path TimedDrive::before() const {
  const Problem& problem = space_.problem();
  Driven driven{problem.start().heading};
  if (start_.run == 0) return {};
  if (problem.vehicle().moves_any_way()) driven.path().pieces.push_back({Line{problem.start().position(), start_.at}, 1, HeadingAlong{problem.start().heading, 0.0}});
  else driven.line(problem.start().position(), start_.at, start_.run);
  return driven.path();
}

Path TimedDrive::path(const LocalDrive& drive) const {
  const Problem& problem = space_.problem();
  const bool is_free = problem.free_goal() != nullptr;
  const FreeMotion motion{problem, 0.0, 0.0};  // of curves alone
  Path path = before();
  if (problem.vehicle().moves_any_way()) {
    const double heading = problem.start().heading, turn = is_free ? 0.0 : shorter_turn(heading, problem.goal().heading);
    const std::vector<Curve> curves = curves_of(motion, drive.driven);
    double whole = 0.0, done = 0.0;
    for (const Curve& curve : curves) whole += length(Piece{curve, 1, {}});
    for (const Curve& curve : curves) {
      Piece piece{curve, 1, {}};
      const double share = length(piece) / whole;
      piece.heading = HeadingAlong{wrap(heading + done * turn), share * turn};
      done += share;
      path.pieces.push_back(std::move(piece));
    }
    if (goal_.run != 0) path.pieces.push_back({Line{goal_.at, problem.goal().position()}, 1, HeadingAlong{wrap(heading + turn), 0.0}});
    return path;
  }
  Driven driven{path.pieces.empty() ? problem.start().heading : end_pose(path).heading};
  std::vector<LocalDriven> stretch;
  const auto drive_on = [&] {
    for (const Curve& curve : curves_of(motion, stretch)) driven.curve(curve);
    stretch.clear();
  };
  for (const LocalDriven& d : drive.driven) {
    if (d.step.kind == FreeStep::Kind::turn) {
      drive_on();
      driven.turn_by(d.before.at, d.step.turn);
    } else {
      stretch.push_back(d);
    }
  }
  drive_on();
  if (goal_.run != 0) driven.line(goal_.at, problem.goal().position(), goal_.run);
  if (!is_free) driven.turn_to(problem.goal().position(), problem.goal().heading);
  for (Piece& piece : driven.path().pieces) path.pieces.push_back(std::move(piece));
  return path;
}

Pace TimedDrive::pace(const LocalDrive& drive, const Movers& movers) const {
  Pace pace;
  const FreeMotion motion{space_.problem(), 0.0, 0.0};
  double s = s_begin_, turned = 0.0, stood = 0.0;
  std::size_t who = LocalField::nobody;
  const auto wait_until = [&](double t) {
    // It turns when it has stood: the profile knows where it stands, not in which order.
    if (stood > least_wait && movers.size() > 0) pace.waits.push_back({s, t - turned, who == LocalField::nobody ? 0 : who});
    turned = stood = 0.0;
    who = LocalField::nobody;
  };
  for (const LocalDriven& d : drive.driven) {
    const double time = d.step.after.t - d.before.t;
    if (d.step.kind == FreeStep::Kind::turn) turned += time;
    if (d.step.kind == FreeStep::Kind::stand) {
      stood += time;
      if (const std::size_t by = d.kept_by != LocalField::nobody ? d.kept_by : d.pushed_by; by != LocalField::nobody) who = by;
      if (who == LocalField::nobody) {  // whoever is nearest
        double least = 1e9;
        for (std::size_t i = 0; i < movers.size(); ++i) {
          if (const double gap = movers.gap(i, d.before.at, d.before.t, least); gap < least) {
            least = gap;
            who = i;
          }
        }
      }
    }
    if (d.step.kind != FreeStep::Kind::drive) continue;
    wait_until(d.before.t);
    pace.places.push_back({s, d.before.speed});
    if (d.before.speed <= 0.0 && d.step.after.speed <= 0.0) {  // from rest to rest: fastest in between
      const double up = motion.acceleration(), down = motion.deceleration();
      pace.places.push_back({s + d.step.length * down / (up + down), std::sqrt(2.0 * d.step.length * up * down / (up + down))});
    }
    s += d.step.length;
    pace.places.push_back({s, d.step.after.speed});
  }
  return pace;
}

Timed TimedDrive::timed(const Path& path, const Pace& pace) const {
  const Problem& problem = space_.problem();
  const std::vector<Sample> samples = sample(problem.whole_path(path), problem.footprint().radius(), tolerance);
  return timed_at_pace(problem, samples, zone_limits(problem, samples, tolerance), pace);
}

std::optional<LocalDriver::Meeting> TimedDrive::meets(const std::vector<Sample>& samples) const {
  const Problem& problem = space_.problem();
  if (check_in_time(problem, samples, tolerance).empty()) return std::nullopt;
  const MovingClearance clearance{problem, problem.required_clearance(), tolerance};
  std::vector<TimeSpan> spans;
  std::optional<LocalDriver::Meeting> first;
  for (std::size_t k = 0; k + 1 < samples.size() && !first; ++k) {
    for (std::size_t i = 0; i < clearance.size(); ++i) {
      clearance.blocked(samples[k].pose(), samples[k + 1].pose(), i, samples[k].t, samples[k + 1].t, spans);
      if (!spans.empty() && (!first || spans.front().begin < first->t)) first = LocalDriver::Meeting{spans.front().begin, i};
    }
  }
  return first ? first : LocalDriver::Meeting{samples.back().t, 0};
}

}  // namespace waywright
