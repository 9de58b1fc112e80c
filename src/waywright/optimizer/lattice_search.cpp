#include "waywright/optimizer/lattice_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace waywright {
namespace {

constexpr std::int64_t most_seen = 4096;  // lattice points kept
constexpr double collapsed = 0.05;  // extent of a simplex over its size when it was built
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Point {
  std::array<double, LatticeSearch::most_variables> u{};  // in the unit box
  double objective = 0.0, violation = 0.0;
  double merit = infinity;
  std::int64_t order = 0;  ///< of its evaluation, among lattice points
  bool used = false;       ///< as a start
};

/// Equal merits stay as they stand. For the few elements of simplices and starts: needs no memory.
template <class Iterator, class Merit>
void sort_by(Iterator first, Iterator last, Merit merit) {
  for (Iterator i = first; i != last; ++i) {
    for (Iterator k = i; k != first && merit(*k) < merit(*std::prev(k)); --k) std::iter_swap(k, std::prev(k));
  }
}

/// A simplex that moves; its best corner stands first.
struct Start {
  std::array<Point, LatticeSearch::most_variables + 1> corners{};
  double size = 0.0;      ///< of the box, when it was last built
  std::size_t known = 0;  ///< corners known beyond the first
  unsigned turn = 0;      ///< how often it was built anew
  Point& best() { return corners[0]; }
  const Point& best() const { return corners[0]; }
};

double far(const Point& a, const Point& b, std::size_t n) {
  double most = 0.0;
  for (std::size_t i = 0; i < n; ++i) most = std::max(most, std::abs(a.u[i] - b.u[i]));
  return most;
}

/// One run: everything that changes while searching.
class Run final : public ResumableSearch {
 public:
  Run(const SearchSpace& space, const SearchOptions& options, const LatticeSearchOptions& tuning)
      : space_{space}, n_{space.dimension()}, tuning_{tuning} {
    double root = 2.0;  // φ_d: Newton on x^(d+1) − x − 1 from above
    for (int i = 0; i < 64; ++i) {
      double power = 1.0;
      for (std::size_t k = 0; k < n_; ++k) power *= root;
      root -= (power * root - root - 1.0) / (static_cast<double>(n_ + 1) * power - 1.0);
    }
    double power = 1.0;
    for (std::size_t i = 0; i < n_; ++i) alpha_[i] = power /= root;
    starts_.reserve(static_cast<std::size_t>(tuning.starts));
    result_.best.reserve(n_);
    start_over(options);
  }

  void extend(std::int64_t evaluations) override {
    all_ = evaluations;
    seen_.reserve(static_cast<std::size_t>(std::clamp<std::int64_t>(all_, 0, most_seen)));
  }

  void start_over(const SearchOptions& options) override {
    all_ = options.evaluations;
    cliff_ = tuning_.cliff;
    price_ = tuning_.price;
    best_objective_ = infinity;
    index_ = work_end_ = before_ = 0;
    seen_.clear();
    seen_.reserve(static_cast<std::size_t>(std::clamp<std::int64_t>(all_, 0, most_seen)));
    starts_.clear();
    champion_ = {};
    result_.best.clear();
    result_.cost = 0.0;
    result_.evaluations = 0;
  }

  const SearchResult& result() const override { return result_; }

  void advance(const CostFunction& cost, std::int64_t evaluations, Budget& budget) override {
    cost_ = &cost;
    budget_ = &budget;
    const std::int64_t halt = std::min(evaluations, all_);
    const std::int64_t polishing = all_ - share_of(all_, tuning_.polish_share);
    limit_ = std::min(halt, std::min(most_seen / 2, share_of(all_, tuning_.lattice_share)));
    if (index_ < limit_) add_lattice(limit_ - index_);
    limit_ = std::min(halt, polishing);
    while (may_go_on()) {
      if (starts_.empty()) {
        choose_starts();
        before_ = result_.evaluations;
      }
      if (!starts_.empty() && !round()) break;  // halted: the round is begun anew when it goes on
      if (starts_.empty() && may_go_on()) {
        add_lattice(std::max<std::int64_t>(8, share_of(result_.evaluations - before_, tuning_.more_lattice)));
      }
    }
    limit_ = halt;
    if (halt <= polishing) return;
    if (champion_.size > 0.0) simplex(champion_, limit_);
    while (may_go_on()) {
      Point p = next_lattice_point();
      evaluate(p, best_objective_);
    }
  }

 private:
  static std::int64_t share_of(std::int64_t count, double share) { return static_cast<std::int64_t>(std::ceil(share * static_cast<double>(count))); }
  bool may_go_on() { return result_.evaluations < limit_ && !budget_->exhausted(); }

  double merit_of(const Point& p) const { return p.violation > 0.0 ? p.objective + cliff_ + price_ * p.violation : p.objective; }

  /// Fills what is known of a point. Where its objective alone is not under `enough`, its merit is something not under it.
  void evaluate(Point& p, double enough) {
    for (std::size_t i = 0; i < n_; ++i) x_[i] = space_.low[i] + p.u[i] * (space_.high[i] - space_.low[i]);
    Evaluation e = (*cost_)({x_.data(), n_}, enough);
    if (!(std::isfinite(e.objective) && std::isfinite(e.violation) && std::isfinite(e.graded))) {
      e = {1e30, 1e30, std::numeric_limits<double>::max()};
    }
    ++result_.evaluations;
    budget_->count_evaluations();
    p.objective = e.objective;
    p.violation = e.violation;
    p.merit = merit_of(p);
    if (e.objective >= enough) return;
    if (result_.best.empty() || e.graded < result_.cost) {
      result_.best.assign(x_.begin(), x_.begin() + static_cast<std::ptrdiff_t>(n_));
      result_.cost = e.graded;
      if (e.violation == 0.0) best_objective_ = e.objective;
    }
  }

  Point next_lattice_point() {
    Point p;
    for (std::size_t i = 0; i < n_; ++i) {
      const double v = 0.5 + alpha_[i] * static_cast<double>(index_);
      p.u[i] = v - std::floor(v);
    }
    ++index_;
    return p;
  }

  void add_lattice(std::int64_t count) {
    for (std::int64_t k = 0; k < count && may_go_on() && std::ssize(seen_) < most_seen; ++k) {
      Point p = next_lattice_point();
      const double best = best_objective_;
      evaluate(p, best);
      // One whose objective alone is no better than the best known leads nowhere.
      if (p.objective >= best) continue;
      p.order = index_;
      seen_.push_back(p);
    }
  }

  /// Distance of neighbours among the lattice's points so far, of the box: index^(−1/n) by halving, from plain arithmetic.
  double spacing() const {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      double volume = static_cast<double>(std::max<std::int64_t>(index_, 1));
      for (std::size_t k = 0; k < n_; ++k) volume *= middle;
      (volume < 1.0 ? low : high) = middle;
    }
    return high;
  }

  /// The best points seen that are neither near a better one already chosen nor near where a search has been.
  void choose_starts() {
    std::erase_if(seen_, [](const Point& p) { return p.used; });
    std::sort(seen_.begin(), seen_.end(),
              [](const Point& a, const Point& b) { return a.merit < b.merit || (a.merit == b.merit && a.order < b.order); });
    if (std::ssize(seen_) > most_seen / 2) seen_.resize(most_seen / 2);
    starts_.clear();
    const double step = spacing();
    const double apart = tuning_.apart * step;
    for (Point& p : seen_) {
      if (starts_.size() >= static_cast<std::size_t>(tuning_.starts)) break;
      const auto near = [&](const Start& other) { return far(p, other.best(), n_) < apart; };
      if (std::any_of(starts_.begin(), starts_.end(), near)) continue;
      Start start;
      start.best() = p;
      start.size = step;
      starts_.push_back(start);
      p.used = true;
    }
  }

  /// One round of simplex searches from the starts, of equal work for each; the worse half is given up, and with the last of them the
  /// starts are done. False where it was halted.
  bool round() {
    const std::int64_t each = static_cast<std::int64_t>(tuning_.work) * static_cast<std::int64_t>(n_);
    for (Start& start : starts_) simplex(start, each);
    sort_by(starts_.begin(), starts_.end(), [](const Start& s) { return s.best().merit; });
    if (champion_.size == 0.0 || starts_.front().best().merit <= champion_.best().merit) champion_ = starts_.front();
    if (!may_go_on()) return false;
    if (starts_.size() > 1) {
      starts_.resize((starts_.size() + 1) / 2);
      return true;
    }
    starts_.clear();
    if (champion_.best().violation > 0.0) raise_price();
    return true;
  }

  /// Searches settle where something is violated: it is too cheap.
  void raise_price() {
    cliff_ *= tuning_.raise;
    price_ *= tuning_.raise;
    for (Point& p : seen_) p.merit = merit_of(p);
    for (Point& p : champion_.corners) p.merit = merit_of(p);
  }

  /// a + f·(b − a), kept in the box.
  Point between(const Point& a, const Point& b, double f) const {
    Point p;
    for (std::size_t i = 0; i < n_; ++i) p.u[i] = std::clamp(a.u[i] + f * (b.u[i] - a.u[i]), 0.0, 1.0);
    return p;
  }

  void sort_corners(Start& s) {
    sort_by(s.corners.begin(), s.corners.begin() + static_cast<std::ptrdiff_t>(n_ + 1), [](const Point& p) { return p.merit; });
  }

  void simplex(Start& s, std::int64_t work) {
    work_end_ = result_.evaluations + work;
    while (works_on() && s.size >= tuning_.finest) {
      if (s.known < n_) {
        add_corner(s);
      } else if (extent(s) < collapsed * s.size) {
        s.size *= tuning_.rebuilt;
        s.known = 0;
        ++s.turn;
      } else {
        move(s);
        sort_corners(s);
      }
    }
  }
  bool works_on() { return result_.evaluations < work_end_ && may_go_on(); }

  double extent(const Start& s) const {
    double most = 0.0;
    for (std::size_t k = 1; k <= n_; ++k) most = std::max(most, far(s.corners[k], s.corners[0], n_));
    return most;
  }

  /// One more corner along an axis, to the other side each time a simplex is built anew.
  void add_corner(Start& s) {
    Point p = s.corners[0];
    double& u = p.u[s.known];
    const double side = ((s.turn >> (s.known % 3)) & 1U) == 0 ? s.size : -s.size;
    u = std::clamp(u + side > 1.0 || u + side < 0.0 ? u - side : u + side, 0.0, 1.0);
    evaluate(p, infinity);
    s.corners[++s.known] = p;
    if (s.known == n_) sort_corners(s);
  }

  /// Reflects the worst corner in the middle of the others, farther where that pays, less far where it does not, or shrinks.
  void move(Start& s) {
    Point& worst = s.corners[n_];
    Point middle;
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < n_; ++k) middle.u[i] += s.corners[k].u[i] / static_cast<double>(n_);
    }
    Point reflected = between(worst, middle, 2.0);
    evaluate(reflected, worst.merit);
    if (reflected.merit < s.corners[n_ - 1].merit || (n_ == 1 && reflected.merit < s.corners[0].merit)) {
      if (reflected.merit < s.corners[0].merit && works_on()) {
        Point expanded = between(worst, middle, 3.0);
        evaluate(expanded, reflected.merit);
        if (expanded.merit < reflected.merit) reflected = expanded;
      }
      worst = reflected;
      return;
    }
    if (reflected.merit < worst.merit) worst = reflected;
    if (!works_on()) return;
    Point contracted = between(worst, middle, 0.5);
    evaluate(contracted, worst.merit);
    if (contracted.merit < worst.merit) {
      worst = contracted;
      return;
    }
    for (std::size_t k = 1; k <= n_ && works_on(); ++k) {
      s.corners[k] = between(s.corners[0], s.corners[k], 0.5);
      evaluate(s.corners[k], infinity);
    }
  }

  const CostFunction* cost_ = nullptr;
  SearchSpace space_;
  std::size_t n_;
  std::int64_t all_ = 0, limit_ = 0;
  Budget* budget_ = nullptr;
  LatticeSearchOptions tuning_;
  double cliff_ = 0.0, price_ = 0.0;
  std::array<double, LatticeSearch::most_variables> x_{}, alpha_{};
  double best_objective_ = infinity;  ///< of the feasible
  std::int64_t index_ = 0, work_end_ = 0, before_ = 0;
  std::vector<Point> seen_;
  std::vector<Start> starts_;
  Start champion_;
  SearchResult result_;
};

}  // namespace

SearchResult LatticeSearch::minimise(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options,
                                     Budget& budget) const {
  if (space.dimension() == 0 || space.dimension() > most_variables || options.evaluations < 1) return {};
  Run run{space, options, options_};
  run.advance(cost, options.evaluations, budget);
  return run.result();
}

std::unique_ptr<ResumableSearch> LatticeSearch::begin(const SearchSpace& space, const SearchOptions& options) const {
  if (space.dimension() == 0 || space.dimension() > most_variables || options.evaluations < 1) return nullptr;
  return std::make_unique<Run>(space, options, options_);
}

OptimizerDescription lattice_search_description() {
  return {"lattice_search", "deterministic: low-discrepancy lattice, then compass searches from its best points (default)",
          [] { return std::make_unique<LatticeSearch>(); }};
}

}  // namespace waywright
