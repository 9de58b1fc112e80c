// What is asked and how long it takes when something appears while a plan is driven: kept, against a whole proof and against planning anew.
// usage: seen [RUNS]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/replan_seen.hpp"
#include "waywright/planner/rest_of_plan.hpp"

namespace waywright::bench {
namespace {

double now_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/// 200 octagons in 40 × 40 m; a disc of 0.2 m from corner to corner.
Scenario hall(Random& random) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {40, 40})};
  const Vec2 start{1, 1}, goal{39, 39};
  while (s.map.obstacles.size() < 200) {
    const Vec2 at{random.uniform(0.5, 39.5), random.uniform(0.5, 39.5)};
    const double radius = random.uniform(0.3, 0.9);
    if (distance(at, start) < radius + 0.6 || distance(at, goal) < radius + 0.6) continue;
    Ring ring;
    for (int i = 0; i < 8; ++i) ring.push_back(at + radius * unit(wrap(two_pi * i / 8.0)));
    s.map.obstacles.push_back(ring);
  }
  s.vehicle.footprint = {{}, 0.2};
  s.vehicle.drive = Differential{0.4};
  s.start = make_pose(start, 0.0);
  s.mission = make_pose(goal, 0.0);
  s.clearance = 0.02;
  return s;
}

void run(const char* planner, int runs) {
  Random random{11};
  std::vector<double> held, questions, proven, anew, whole;
  int kept = 0, solved = 0, asked = 0;
  for (int i = 0; i < runs; ++i) {
    Scenario s = hall(random);
    s.planner.name = planner;
    const Problem problem = Problem::prepare(s).value();
    double begin = now_ms();
    const Plan old = *solve(problem);
    anew.push_back(now_ms() - begin);
    const Vec2 at{random.uniform(3, 36), random.uniform(3, 36)};
    if (old.status != Status::solved) continue;
    SeenObstacles seen;
    seen.still.obstacles = {rectangle(at, at + Vec2{1.5, 1.5})};
    const double t = time_at(old.samples, 8.0);
    const RestOfPlan rest = rest_of(old, problem, t).value();
    begin = now_ms();
    const HeldAgainst found = held_against(seen.still, problem, rest.path, nullptr);
    held.push_back(now_ms() - begin);
    questions.push_back(static_cast<double>(found.queries));
    begin = now_ms();
    prove(problem, old.path);
    proven.push_back(now_ms() - begin);
    begin = now_ms();
    const Plan plan = replan(old, t, seen).value();
    whole.push_back(now_ms() - begin);
    ++asked;
    kept += found.is_free ? 1 : 0;
    solved += plan.status == Status::solved ? 1 : 0;
  }
  fmt::print("| {} | {} | {} | {} | {:.0f}, {:.3f} | {:.2f} | {:.1f} | {:.1f} |\n", planner, asked, kept, solved, median(questions), median(held), median(proven), median(whole), median(anew));
}

}  // namespace
}  // namespace waywright::bench

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 20;
  fmt::print("200 octagons in 40 x 40 m; after 8 m a box of 1.5 m appears somewhere. Medians, CPU ms\n\n");
  fmt::print("| planner | plans | kept | solved | held against the new: questions, ms | proof of the whole | replanned, world and metrics included | planned the first time |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const char* planner : {"visibility_graph", "theta_star", "astar", "rrt_star"}) waywright::bench::run(planner, runs);
}
