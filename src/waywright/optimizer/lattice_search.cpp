#include "waywright/optimizer/lattice_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

using Point = std::vector<double>;  // in the unit box

/// One run: everything that changes while searching.
class Run {
 public:
  Run(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options, Budget& budget,
      const LatticeSearchOptions& tuning)
      : cost_{cost}, space_{space}, limit_{options.evaluations}, budget_{budget}, tuning_{tuning}, x_(space.dimension()) {
    double root = 2.0;  // φ_d: Newton on x^(d+1) − x − 1 from above
    for (int i = 0; i < 64; ++i) {
      double power = 1.0;
      for (std::size_t k = 0; k < space.dimension(); ++k) power *= root;
      root -= (power * root - root - 1.0) / (static_cast<double>(space.dimension() + 1) * power - 1.0);
    }
    double power = 1.0;
    for (std::size_t i = 0; i < space.dimension(); ++i) alpha_.push_back(power /= root);
  }

  SearchResult search() {
    const auto lattice = static_cast<std::int64_t>(std::ceil(tuning_.lattice_share * static_cast<double>(limit_)));
    add_lattice(lattice);
    std::vector<Start> starts = choose_starts();
    std::int64_t round_work = std::max<std::int64_t>(1, (limit_ - result_.evaluations) / 4);
    while (!starts.empty() && may_go_on()) {
      const auto share = std::max<std::int64_t>(1, round_work / static_cast<std::int64_t>(starts.size()));
      for (Start& start : starts) compass(start, share);
      std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.value < b.value; });
      std::erase_if(starts, [&](const Start& s) { return s.step < tuning_.finest; });
      if (result_.cost >= tuning_.good_enough && may_go_on()) {
        add_lattice(std::max<std::int64_t>(1, round_work / 2));
        starts = choose_starts();
        continue;
      }
      if (starts.size() > 1) starts.resize((starts.size() + 1) / 2);
    }
    while (may_go_on() && result_.cost >= tuning_.good_enough) add_lattice(64);
    return std::move(result_);
  }

 private:
  struct Start {
    Point at;
    double value;
    double step;
  };
  struct Seen {
    Point at;
    double value;
    bool used = false;
  };

  bool may_go_on() { return result_.evaluations < limit_ && !budget_.exhausted(); }

  double evaluate(const Point& unit_point) {
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = space_.low[i] + unit_point[i] * (space_.high[i] - space_.low[i]);
    double value = cost_(x_);
    if (std::isnan(value)) value = std::numeric_limits<double>::max();
    ++result_.evaluations;
    budget_.count_evaluations();
    if (result_.best.empty() || value < result_.cost) {
      result_.best = x_;
      result_.cost = value;
    }
    result_.trace.push_back(result_.cost);
    return value;
  }

  void add_lattice(std::int64_t count) {
    for (std::int64_t k = 0; k < count && may_go_on(); ++k, ++index_) {
      Point p(alpha_.size());
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double v = 0.5 + alpha_[i] * static_cast<double>(index_);
        p[i] = v - std::floor(v);
      }
      const double value = evaluate(p);
      seen_.push_back({std::move(p), value, false});
    }
  }

  /// The best points seen that are not near a better one already chosen.
  std::vector<Start> choose_starts() {
    std::stable_sort(seen_.begin(), seen_.end(), [](const Seen& a, const Seen& b) { return a.value < b.value; });
    std::vector<Start> starts;
    for (Seen& s : seen_) {
      if (starts.size() >= static_cast<std::size_t>(tuning_.starts)) break;
      if (s.used) continue;
      const bool near = std::any_of(starts.begin(), starts.end(), [&](const Start& other) {
        double far = 0.0;
        for (std::size_t i = 0; i < s.at.size(); ++i) far = std::max(far, std::abs(s.at[i] - other.at[i]));
        return far < tuning_.first_step;
      });
      if (near) continue;
      s.used = true;
      starts.push_back({s.at, s.value, tuning_.first_step});
    }
    return starts;
  }

  void compass(Start& start, std::int64_t work) {
    const std::int64_t end = result_.evaluations + work;
    const std::size_t n = start.at.size();
    while (result_.evaluations < end && start.step >= tuning_.finest && may_go_on()) {
      bool moved = false;
      for (std::size_t k = 0; k < 2 * n && result_.evaluations < end && may_go_on(); ++k) {
        const std::size_t axis = k / 2;
        const double sign = k % 2 == 0 ? 1.0 : -1.0;
        double step = start.step;
        while (result_.evaluations < end && may_go_on()) {
          Point next = start.at;
          next[axis] = std::clamp(next[axis] + sign * step, 0.0, 1.0);
          if (next[axis] == start.at[axis]) break;
          const double value = evaluate(next);
          if (!(value < start.value)) break;
          start.at = std::move(next);
          start.value = value;
          moved = true;
          step *= 2.0;
        }
      }
      if (!moved) start.step *= 0.5;
    }
  }

  const CostFunction& cost_;
  const SearchSpace& space_;
  std::int64_t limit_;
  Budget& budget_;
  const LatticeSearchOptions& tuning_;
  std::vector<double> x_;
  std::vector<double> alpha_;
  std::int64_t index_ = 0;
  std::vector<Seen> seen_;
  SearchResult result_;
};

}  // namespace

SearchResult LatticeSearch::minimise(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options,
                                     Budget& budget) const {
  if (space.dimension() == 0 || options.evaluations < 1) return {};
  return Run{cost, space, options, budget, options_}.search();
}

OptimizerDescription lattice_search_description() {
  return {"lattice_search", "deterministic: low-discrepancy lattice, then compass searches from its best points (default)",
          [] { return std::make_unique<LatticeSearch>(); }};
}

}  // namespace waywright
