#include "waywright/map/outward_outline.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr std::size_t farthest_ahead = 1024;  // corners that one chord may take the place of: bounds the work
constexpr double safe = 1.0 - 1e-9;           // of the tolerance: what rounding may take

struct Way {
  std::int64_t x = 0, y = 0;
};
Way operator-(HalfCell a, HalfCell b) { return {static_cast<std::int64_t>(a.x) - b.x, static_cast<std::int64_t>(a.y) - b.y}; }
std::int64_t cross(Way a, Way b) { return a.x * b.y - a.y * b.x; }
std::int64_t dot(Way a, Way b) { return a.x * b.x + a.y * b.y; }
double length(Way a) { return std::sqrt(static_cast<double>(dot(a, a))); }
int sign(std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// Do two segments have a point in common?
bool meet(HalfCell a, HalfCell b, HalfCell c, HalfCell d) {
  const int sc = sign(cross(b - a, c - a)), sd = sign(cross(b - a, d - a)), sa = sign(cross(d - c, a - c)), sb = sign(cross(d - c, b - c));
  if (sc == 0 && sd == 0) {  // on one line
    return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <= std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
           std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <= std::min(std::max(a.y, b.y), std::max(c.y, d.y));
  }
  return sc * sd <= 0 && sa * sb <= 0;
}

/// The outline's edges by the squares of a coarse grid that they pass through.
class EdgeBins {
 public:
  explicit EdgeBins(const std::vector<HalfCell>& outline) : outline_{outline} {
    low_ = outline.front();
    HalfCell high = low_;
    for (const HalfCell p : outline) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    // About as many squares as edges.
    const double area = (high.x - low_.x + 1.0) * (high.y - low_.y + 1.0);
    side_ = std::max(2, static_cast<int>(std::ceil(std::sqrt(area / static_cast<double>(outline.size())))));
    columns_ = (high.x - low_.x) / side_ + 1;
    rows_ = (high.y - low_.y) / side_ + 1;
    // Counted first, then placed: two passes over the same squares.
    begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (std::size_t e = 0; e < outline.size(); ++e) along(e, [&](std::size_t bin) { ++begin_[bin + 1]; });
    for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    edges_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t e = 0; e < outline.size(); ++e) along(e, [&](std::size_t bin) { edges_[next[bin]++] = e; });
  }

  /// Does the segment from corner i to corner j meet an edge that is none of i, i + 1 … j − 1 (the chain), but for the ends that it shares with its neighbours?
  bool meets_another(std::size_t i, std::size_t j) const {
    const std::size_t n = outline_.size();
    const HalfCell a = outline_[i], b = outline_[j % n];
    const std::size_t before = (i + n - 1) % n, after = j % n;
    bool found = false;
    over(a, b, [&](std::size_t bin) {
      for (std::size_t k = begin_[bin]; k < begin_[bin + 1] && !found; ++k) {
        const std::size_t e = edges_[k];
        if (e >= i && e < j) continue;
        const HalfCell c = outline_[e], d = outline_[(e + 1) % n];
        if (e == before || e == after) {
          // They share an end; they have more in common where they run back along the chord, or where the chain is all but one edge.
          if (e == before && e == after) found = true;
          else if (e == before) found = runs_along(a, b, c);
          else found = runs_along(b, a, d);
        } else {
          found = meet(a, b, c, d);
        }
      }
    });
    return found;
  }

 private:
  /// From p, do the ways to q and r go in the same direction?
  static bool runs_along(HalfCell p, HalfCell q, HalfCell r) { return cross(q - p, r - p) == 0 && dot(q - p, r - p) > 0; }

  template <class Take>
  void along(std::size_t edge, Take&& take) const {
    over(outline_[edge], outline_[(edge + 1) % outline_.size()], take);
  }

  /// The squares that a segment within the outline's box touches, and some beside them: column by column, from the rows at its one side to those at its other.
  template <class Take>
  void over(HalfCell a, HalfCell b, Take&& take) const {
    if (a.x > b.x) std::swap(a, b);
    const int first = (a.x - low_.x) / side_, last = (b.x - low_.x) / side_;
    const std::int64_t width = b.x - a.x, height = static_cast<std::int64_t>(b.y) - a.y;
    for (int column = first; column <= last; ++column) {
      // Heights at the column's sides, rounded outwards.
      const std::int64_t left = std::max<std::int64_t>(a.x, low_.x + static_cast<std::int64_t>(column) * side_), right = std::min<std::int64_t>(b.x, low_.x + static_cast<std::int64_t>(column + 1) * side_);
      std::int64_t from = a.y, to = b.y;
      if (width > 0) {
        from = a.y + floor_of(height * (left - a.x), width);
        to = a.y + floor_of(height * (right - a.x), width);
      }
      if (from > to) std::swap(from, to);
      const int low_row = static_cast<int>(std::max<std::int64_t>(0, from - 1 - low_.y)) / side_, high_row = std::min(rows_ - 1, static_cast<int>(std::max<std::int64_t>(0, to + 1 - low_.y)) / side_);
      for (int row = low_row; row <= high_row; ++row) take(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column));
    }
  }
  static std::int64_t floor_of(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

  const std::vector<HalfCell>& outline_;
  HalfCell low_;
  int side_ = 1, columns_ = 1, rows_ = 1;
  std::vector<std::size_t> begin_, edges_;
};

class Simplifier {
 public:
  Simplifier(const std::vector<HalfCell>& outline, double tolerance) : outline_{outline}, tolerance_{tolerance * safe}, bins_{outline} {}

  OutwardOutline run() {
    OutwardOutline answer;
    for (std::size_t i = 0; i < outline_.size();) {
      answer.corners.push_back(outline_[i]);
      const std::size_t next = farthest_from(i);
      for (std::size_t k = i + 1; k < next; ++k) answer.reached = std::max(answer.reached, depth(i, next, k));
      i = next;
    }
    return answer;
  }

 private:
  HalfCell at(std::size_t i) const { return outline_[i % outline_.size()]; }
  double depth(std::size_t i, std::size_t j, std::size_t k) const {
    const Way chord = at(j) - at(i);
    return static_cast<double>(cross(chord, at(k) - at(i))) / length(chord);
  }

  /// Directions that are left for a chord from a corner: not left of what it passed, and not so far right that it would be too far away.
  struct Wedge {
    bool has_left = false, has_right = false;
    Way left{};                            ///< clockwise-most of the ways to corners that were passed
    double right_x = 0.0, right_y = 0.0;  ///< as near to them as is allowed

    bool is_empty() const { return has_left && has_right && right_x * static_cast<double>(left.y) - right_y * static_cast<double>(left.x) < 0.0; }
    bool holds(Way way) const {
      if (has_left && cross(way, left) < 0) return false;
      return !has_right || right_x * static_cast<double>(way.y) - right_y * static_cast<double>(way.x) >= 0.0;
    }
    void narrow(Way passed, double tolerance) {
      if (!has_left || cross(left, passed) < 0) left = passed;
      has_left = true;
      const double squared = static_cast<double>(dot(passed, passed));
      if (squared <= tolerance * tolerance) return;
      // The way to the corner, turned clockwise until it passes by at the tolerance.
      const double along = std::sqrt(squared - tolerance * tolerance), px = static_cast<double>(passed.x), py = static_cast<double>(passed.y);
      const double x = px * along + py * tolerance, y = py * along - px * tolerance;
      if (has_right && right_x * y - right_y * x <= 0.0) return;
      has_right = true;
      right_x = x;
      right_y = y;
    }
  };

  std::size_t farthest_from(std::size_t i) const {
    const std::size_t n = outline_.size(), last = std::min(n, i + farthest_ahead);
    candidates_.clear();
    Wedge wedge;
    for (std::size_t j = i + 1; j <= last; ++j) {
      const Way way = at(j) - at(i);
      if (way.x == 0 && way.y == 0) break;  // around once
      if (j > i + 1 && wedge.holds(way)) candidates_.push_back(j);
      wedge.narrow(way, tolerance_);
      if (wedge.is_empty()) break;
    }
    // The farthest, or where that does not do one half as far: a few trials are enough, and their number is bounded.
    for (std::size_t left = candidates_.size(); left > 0; left /= 2) {
      if (is_right(i, candidates_[left - 1])) return candidates_[left - 1];
    }
    return i + 1;
  }

  /// The wedge is a sieve; this decides.
  bool is_right(std::size_t i, std::size_t j) const {
    if (j - i >= outline_.size() - 1) return false;  // at least three corners are left
    const Way chord = at(j) - at(i);
    const double most = tolerance_ * length(chord);
    for (std::size_t k = i + 1; k < j; ++k) {
      const std::int64_t beside = cross(chord, at(k) - at(i));
      if (beside < 0 || static_cast<double>(beside) > most) return false;
    }
    return !bins_.meets_another(i, j);
  }

  const std::vector<HalfCell>& outline_;
  double tolerance_;
  EdgeBins bins_;
  mutable std::vector<std::size_t> candidates_;
};

}  // namespace

OutwardOutline outward_outline(const std::vector<HalfCell>& outline, double tolerance) { return Simplifier{outline, tolerance}.run(); }

std::int64_t doubled_area(const std::vector<HalfCell>& outline) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) area += cross(outline[i] - HalfCell{}, outline[(i + 1) % outline.size()] - HalfCell{});
  return area;
}

}  // namespace waywright
