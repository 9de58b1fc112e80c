// A dozen plans to the last bit, as text: what two processors must agree on. Only the docking core.
#include <cstdio>
#include <memory>

#include "waywright/core/random.hpp"
#include "waywright/docking/docking.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/docking/pattern_docking.hpp"

namespace waywright {
namespace {

void print(const char* name, double value) { std::printf(" %s %a", name, value); }
void print(Vec2 p) { std::printf(" (%a, %a)", p.x, p.y); }

void print_curve(const Spline& spline) {
  for (const BezierSpan& span : spline.spans) {
    for (std::size_t i = 0; i <= static_cast<std::size_t>(span.degree); ++i) print(span.control[i]);
  }
}
void print_curve(const Line& line) {
  print(line.from);
  print(line.to);
}
void print_curve(const auto&) {}

void plan(const char* name, const Scenario& scenario) {
  const Problem problem = Problem::prepare(scenario).value();
  Budget budget{scenario.budget};
  const PatternDockingPlanner planner{{}, std::make_shared<LatticeSearch>(), 1};
  const PlanningResult result = planner.plan(problem, budget);
  std::printf("%s: %lld evaluations\n", name, static_cast<long long>(budget.evaluations()));
  if (!result) {
    std::printf(" %s\n", result.error().failure.reason.c_str());
    return;
  }
  const Plan plan = judge(problem, problem.whole_path(result->path, result->begins_in_motion));
  std::printf(" %s %s\n", to_string(plan.status), plan.reason.c_str());
  for (const Piece& piece : plan.path.pieces) {
    std::printf(" piece %d:", piece.direction);
    std::visit([](const auto& curve) { print_curve(curve); }, piece.curve);
    std::printf("\n");
  }
  for (const Sample& s : plan.samples) {
    for (const double v : {s.s, s.x, s.y, s.heading, s.curvature, s.t, s.speed}) std::printf(" %a", v);
    std::printf("\n");
  }
  const Metrics& m = plan.metrics;
  for (const double v : {m.length, m.min_clearance, m.mean_clearance, m.max_curvature, m.curvature_change, m.turning, m.travel_time}) std::printf(" %a", v);
  print("clearance", plan.certificate.clearance);
  print("pocket", plan.certificate.pocket_clearance.value_or(-1.0));
  std::printf("\n");
}

/// Half way the shelf turns out to be elsewhere: carried along, and where that is too tight bent beside or planned anew.
void replan(const char* name, const Scenario& scenario, double share, Vec2 shift) {
  const auto docking = Docking::prepare(scenario);
  if (!docking) return;
  const DockingPlan old = docking->plan();
  if (old.status != Status::solved) return;
  const Handover at = handover_at(old.path, old.samples, share * old.travel_time);
  Shelf shelf = std::get<Station>(scenario.mission).shelf;
  shelf.center = shelf.center + shift;
  const auto again = docking->from(at.pose, at.motion, shelf);
  if (!again) return;
  const DockingPlan next = again->replan(old, at.driven);
  std::printf("%s: %lld evaluations\n %s %d %d %a %a\n", name, static_cast<long long>(next.evaluations), to_string(next.status), next.is_carried_on, next.in_motion, next.moved,
              next.certificate.clearance);
  for (const Sample& s : next.samples) {
    for (const double v : {s.s, s.x, s.y, s.heading, s.curvature, s.t, s.speed}) std::printf(" %a", v);
    std::printf("\n");
  }
}

}  // namespace
}  // namespace waywright

int main() {
  using namespace waywright;
  using fixture::Id;
  const Pose somewhere{-37.5, 12.25, 2.1};
  plan("open", fixture::station(Id::d0));
  plan("two boxes", fixture::station(Id::d1));
  plan("cluttered", fixture::station(Id::d2));
  plan("narrow", fixture::station(Id::d3));
  plan("two boxes, turned", fixture::station(Id::d1, somewhere));
  plan("cluttered, turned", fixture::station(Id::d2, somewhere));
  Scenario moving = fixture::station(Id::d1, somewhere);
  moving.vehicle.limits.curvature_rate = 1.5;
  for (const double speed : {-0.8, 0.5}) {
    moving.start_motion = {speed, 0.2};
    plan(speed < 0.0 ? "backing" : "driving forwards", moving);
  }
  for (const double share : {0.2, 0.6, 0.9}) replan("shelf elsewhere", moving, share, {0.02, -0.02});
  replan("shelf elsewhere in a cluttered station", fixture::station(Id::d2, somewhere), 0.3, {0.03, 0.03});
  Scenario s = fixture::station(Id::d2, somewhere);
  s.pose_error = {0.02, 0.01, 0.005};
  s.clearance = 0.04;
  plan("with pose error", s);
  s.vehicle.limits.curvature_rate = 1.0;
  plan("with a curvature rate", s);
  s.vehicle.footprint = {{}, 0.6};
  s.vehicle.drive = Differential{0.7};
  plan("disc", s);
  Scenario far = fixture::station(Id::d1, {123456.0, -654321.0, -1.3});
  plan("far out", far);
  plan("forks in", fixture::with_pockets(Manoeuvre::dock));
  plan("out with the load", fixture::with_pockets(Manoeuvre::undock));
  Scenario goal = fixture::station(Id::d0);
  goal.mission = Pose{2.0, -1.0, 2.8};
  plan("goal pose", goal);
}
