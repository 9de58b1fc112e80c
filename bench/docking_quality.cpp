// How near to the optimum does a search of one side of the shelf end, where few candidates are feasible? Prints a table of
// docs/performance.md. usage: docking_quality [SIDES]
//
// Stations with many boxes are drawn until SIDES sides of the shelf (100) have between 0.1 and 2 % of feasible candidates. The truth of each is
// the best of an exhaustive grid, polished. Our search and differential evolution with flat penalties get the same evaluations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "bench/docking_scene.hpp"
#include "waywright/objective/docking_cost.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/optimizer/pagmo/pagmo_optimizers.hpp"
#include "waywright/planner/docking/candidate.hpp"
#include "waywright/planner/docking/side_search.hpp"
#include "waywright/study/summary.hpp"

namespace waywright::bench {
namespace {

constexpr double good_enough = 1.01;  // of the optimum
constexpr int seeds = 5;              // of differential evolution on each side

/// One side of one station's shelf, as a function to be minimised.
class Task {
 public:
  Task(const PreparedDocking& prepared, const TransitionZone& zone, double heading_range)
      : prepared_{prepared}, zone_{zone}, evaluator_{prepared}, space_{search_space(zone, heading_range)} {}

  const SearchSpace& space() const { return space_; }
  CandidateScore score(std::span<const double> x) {
    return evaluator_.evaluate(docking_pattern(prepared_.problem().start(), prepared_.problem().goal(), transition_pose(prepared_.task(), zone_, x), {}));
  }
  /// The publication's weights against a path of 12 m and 2.4 1/m.
  static double base(const PathMeasures& m) { return 0.7 * m.curvature_change / 2.4 + 0.3 * m.length / 12.0; }
  Evaluation evaluate(std::span<const double> x, double enough) {
    const DockingPattern pattern =
        docking_pattern(prepared_.problem().start(), prepared_.problem().goal(), transition_pose(prepared_.task(), zone_, x), {});
    return evaluation_of(evaluator_, pattern, enough, base);
  }
  double graded(std::span<const double> x) {
    const CandidateScore s = score(x);
    return graded_cost(s, base(s.measures));
  }
  double flat(std::span<const double> x) {
    const CandidateScore s = score(x);
    return base(s.measures) + (!s.free ? 1000.0 : s.excess > 0.0 ? 100.0 : 0.0);
  }

 private:
  const PreparedDocking& prepared_;
  const TransitionZone& zone_;
  CandidateEvaluator evaluator_;
  SearchSpace space_;
};

double feasible_share(Task& task, Random& random) {
  constexpr int draws = 20000;
  int feasible = 0;
  std::vector<double> x(task.space().dimension());
  for (int i = 0; i < draws; ++i) {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = random.uniform(task.space().low[k], task.space().high[k]);
    feasible += task.score(x).feasible() ? 1 : 0;
  }
  return static_cast<double>(feasible) / draws;
}

/// Steps in random directions, the step halved when none of many helps: slow, and not caught by edges of what is feasible.
double polished(Task& task, std::vector<double> x, double value, double step, Random& random) {
  constexpr int tries = 60;
  const std::size_t n = x.size();
  std::vector<double> next(n);
  while (step > 1e-5) {
    bool moved = false;
    for (int t = 0; t < tries; ++t) {
      for (std::size_t k = 0; k < n; ++k) {
        const double low = task.space().low[k], high = task.space().high[k];
        next[k] = std::clamp(x[k] + random.uniform(-step, step) * (high - low), low, high);
      }
      if (const double v = task.graded(next); v < value) {
        value = v;
        x = next;
        moved = true;
      }
    }
    if (!moved) step *= 0.5;
  }
  return value;
}

double truth(Task& task) {
  const std::size_t n = task.space().dimension();
  const std::vector<int> sides = n == 2 ? std::vector<int>{256, 256} : std::vector<int>{80, 80, 41};
  struct Point {
    std::vector<double> x;
    double value;
  };
  std::vector<Point> points;
  std::vector<int> at(n, 0);
  for (bool more = true; more;) {
    std::vector<double> x(n);
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = task.space().low[k] + (task.space().high[k] - task.space().low[k]) * (at[k] + 0.5) / sides[k];
    }
    if (const double v = task.graded(x); v < 100.0) points.push_back({std::move(x), v});
    std::size_t k = 0;
    while (k < n && ++at[k] == sides[k]) at[k++] = 0;
    more = k < n;
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.value < b.value; });
  // From the best points that are not neighbours.
  double best = 1e9;
  Random random{1};
  std::vector<Point> from;
  for (const Point& p : points) {
    const auto near = [&](const Point& other) {
      double far = 0.0;
      for (std::size_t k = 0; k < n; ++k) {
        far = std::max(far, std::abs(p.x[k] - other.x[k]) / (task.space().high[k] - task.space().low[k]));
      }
      return far < 3.0 / sides[0];
    };
    if (std::any_of(from.begin(), from.end(), near)) continue;
    from.push_back(p);
    best = std::min(best, polished(task, p.x, p.value, 2.0 / sides[0], random));
    if (from.size() == 20) break;
  }
  return best;
}

std::unique_ptr<Optimizer> differential_evolution() {
  for (const OptimizerDescription& o : pagmo_optimizers()) {
    if (o.name == "de") return o.make();
  }
  return nullptr;
}

struct Tally {
  std::size_t runs = 0, good = 0, solved = 0;
  std::vector<double> gaps;
  void add(double cost, double optimum) {
    ++runs;
    if (cost < 100.0) {
      ++solved;
      gaps.push_back(100.0 * (cost / optimum - 1.0));
    }
    if (cost <= good_enough * optimum) ++good;
  }
  void print(int variables, std::int64_t evaluations, const char* name) const {
    const Share s = share_of(good, runs);
    const Spread gap = spread_of(gaps);
    fmt::print("| {} | {} | {} | {} of {} | {:.1f} % | {:.1f}–{:.1f} % | {} | {:.2f} % |\n", variables, evaluations, name, good, runs,
               100.0 * static_cast<double>(good) / static_cast<double>(runs), 100.0 * s.low, 100.0 * s.high, solved, gap.median);
  }
};

void run(int variables, std::int64_t evaluations, std::size_t wanted) {
  Tally ours, theirs;
  const auto de = differential_evolution();
  double shares = 0.0;
  std::size_t sides = 0;
  for (std::uint64_t seed = 1; sides < wanted; ++seed) {
    Random random{seed};
    const Problem problem = Problem::prepare(docking_scenario(Clutter::boxes, seed, 14 + seed % 12)).value();
    const PreparedDocking prepared{problem};
    for (const TransitionZone& zone : prepared.task().zones) {
      if (zone.left_out() || sides == wanted) continue;
      Task task{prepared, zone, variables == 3 ? 1.0 : 0.0};
      const double share = feasible_share(task, random);
      if (share < 0.001 || share > 0.02) continue;
      ++sides;
      shares += share;
      const double optimum = truth(task);
      SearchOptions options;
      options.evaluations = evaluations;
      Budget budget;
      const double best = LatticeSearch{}.minimise([&](std::span<const double> x, double enough) { return task.evaluate(x, enough); }, task.space(), options, budget).cost;
      ours.add(best, optimum);
      for (int s = 1; s <= seeds; ++s) {
        options.seed = static_cast<std::uint64_t>(s);
        const SearchResult r = de->minimise([&](std::span<const double> x, double) { return Evaluation{0.0, 0.0, task.flat(x)}; }, task.space(), options, budget);
        theirs.add(r.cost, optimum);
      }
    }
  }
  ours.print(variables, evaluations, "lattice_search");
  theirs.print(variables, evaluations, "pagmo's DE, flat penalties");
  fmt::print(stderr, "mean feasible share {:.2f} %\n", 100.0 * shares / static_cast<double>(sides));
}

}  // namespace
}  // namespace waywright::bench

int main(int argc, char** argv) {
  const auto sides = static_cast<std::size_t>(argc > 1 ? std::max(1, std::atoi(argv[1])) : 100);
  fmt::print("| variables | evaluations | search | within 1 % of the optimum | share | 95 % interval | solved | median gap of these |\n"
             "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [variables, evaluations] : {std::pair{2, 300}, std::pair{2, 600}, std::pair{3, 500}, std::pair{3, 1000}}) waywright::bench::run(variables, evaluations, sides);
  return 0;
}
