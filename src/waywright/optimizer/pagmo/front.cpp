#include "waywright/optimizer/pagmo/front.hpp"

#include <algorithm>
#include <exception>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>

#include "waywright/optimizer/pagmo/search.hpp"

namespace waywright {
namespace {

constexpr double infeasible = 1e12;  // what each objective has in addition where a point is not feasible

constexpr std::size_t most_kept = 4000;  // points of a front: enough for any picture, and comparing with all of them stays quick

bool dominates(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  bool is_better = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i] > b[i]) return false;
    is_better = is_better || a[i] < b[i];
  }
  return is_better;
}

struct Recorder {
  const std::function<TradeOff(std::span<const double>)>& cost;
  std::int64_t limit;
  Budget& budget;
  std::int64_t evaluations = 0;
  std::vector<FrontPoint> front{};

  pagmo::vector_double evaluate(const std::vector<double>& x) {
    if (evaluations >= limit || budget.exhausted()) throw BudgetSpent{};
    const TradeOff t = cost(x);
    ++evaluations;
    budget.count_evaluations();
    if (t.violation > 0.0) {
      pagmo::vector_double worse;
      for (const double o : t.objectives) worse.push_back(o + infeasible * (1.0 + t.violation));
      return worse;
    }
    keep(x, t.objectives);
    return {t.objectives.begin(), t.objectives.end()};
  }

  void keep(const std::vector<double>& x, const std::array<double, 3>& objectives) {
    for (const FrontPoint& p : front) {
      if (p.objectives == objectives || dominates(p.objectives, objectives)) return;
    }
    std::erase_if(front, [&](const FrontPoint& p) { return dominates(objectives, p.objectives); });
    if (front.size() < most_kept) front.push_back({x, objectives});
  }
};

struct Problem {
  Recorder* recorder = nullptr;
  pagmo::vector_double low{0.0};
  pagmo::vector_double high{1.0};
  pagmo::vector_double fitness(const pagmo::vector_double& x) const { return recorder->evaluate(x); }
  pagmo::vector_double::size_type get_nobj() const { return 3; }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {low, high}; }
};

}  // namespace

std::vector<FrontPoint> search_front(const std::function<TradeOff(std::span<const double>)>& cost, const SearchSpace& space, const SearchOptions& options, Budget& budget) {
  Recorder recorder{cost, options.evaluations, budget};
  if (space.dimension() == 0) {
    if (options.evaluations > 0 && !budget.exhausted()) {
      const TradeOff only = cost({});
      budget.count_evaluations();
      if (!(only.violation > 0.0)) recorder.keep({}, only.objectives);
    }
    return std::move(recorder.front);
  }
  const auto size = static_cast<unsigned>(4 * std::max(2, (options.population + 3) / 4));  // NSGA-II pairs them in fours
  PagmoSeeds seeds{options.seed};
  try {
    pagmo::population population = first_population(Problem{&recorder, space.low, space.high}, space, options.seed, size, seeds);
    const auto generations = static_cast<unsigned>(std::min<std::int64_t>(options.evaluations / size + 2, 1'000'000));
    pagmo::algorithm{pagmo::nsga2{generations, 0.95, 10.0, 0.1, 20.0, seeds.next()}}.evolve(population);
  } catch (const BudgetSpent&) {
    // The usual end.
  } catch (const std::exception&) {
    // What pagmo refuses leaves what was found so far.
  }
  std::sort(recorder.front.begin(), recorder.front.end(), [](const FrontPoint& a, const FrontPoint& b) { return a.objectives < b.objectives; });
  return std::move(recorder.front);
}

}  // namespace waywright
