#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

constexpr int first_parts = 16;
constexpr int deepest = 50;              // halvings
constexpr std::int64_t most_looks = 2'000'000;  // only a point from which much of the curve is as far to the tolerance gets there
constexpr int newton_steps = 60;

class Search {
 public:
  Search(const Clothoid& clothoid, Vec2 point, double tolerance)
      : clothoid_{clothoid}, panels_{clothoid}, point_{point}, tolerance_{std::max(tolerance, 1e-12)} {}

  NearestPoint run() {
    look(0.0);
    look(clothoid_.length);
    const auto at = [&](int i) { return clothoid_.length * static_cast<double>(i) / first_parts; };
    for (int i = 0; i < first_parts; ++i) look(0.5 * (at(i) + at(i + 1)));
    for (int i = 0; i < first_parts; ++i) narrow(at(i), at(i + 1), 0);
    return best_;
  }

 private:
  struct Look {
    double distance, slope;  // of the distance by s
    double curvature;
  };

  Look look(double s) {
    ++looks_;
    const CurvePoint p = panels_.at(s);
    const Vec2 away = p.position - point_;
    const double d = norm(away);
    if (best_.distance < 0.0 || d < best_.distance) best_ = {s, d};
    return {d, d > 0.0 ? dot(away, unit(p.course)) / d : 0.0, p.curvature};
  }

  void narrow(double low, double high, int depth) {
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    const Look here = look(middle);
    const double bend = std::max(std::abs(clothoid_.curvature + clothoid_.curvature_rate * low), std::abs(clothoid_.curvature + clothoid_.curvature_rate * high));
    // The distance changes by no more than s does, and its second derivative is no less than −|κ|.
    const double bound = std::max(here.distance - half, here.distance - std::abs(here.slope) * half - 0.5 * bend * half * half);
    if (bound >= best_.distance - tolerance_ || depth >= deepest || looks_ > most_looks) return;
    if (bend * (here.distance + half) < 1.0) return descend(low, high);
    narrow(low, middle, depth + 1);
    narrow(middle, high, depth + 1);
  }

  /// Half the squared distance is convex here: 1 + κ (p − q)·n > 0.
  void descend(double low, double high) {
    double s = 0.5 * (low + high);
    for (int i = 0; i < newton_steps && high - low > 0.25 * tolerance_; ++i) {
      const Look here = look(s);
      const double slope = here.distance * here.slope;
      if (slope == 0.0) return;
      (slope > 0.0 ? high : low) = s;
      const CurvePoint p = panels_.at(s);
      const double bend = 1.0 + p.curvature * dot(p.position - point_, left_of(unit(p.course)));
      double next = s - slope / bend;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (std::abs(next - s) <= 0.25 * tolerance_) {
        look(next);
        return;
      }
      s = next;
    }
  }

  const Clothoid& clothoid_;
  ClothoidPanels panels_;
  Vec2 point_;
  double tolerance_;
  std::int64_t looks_ = 0;
  NearestPoint best_{0.0, -1.0};
};

}  // namespace

NearestPoint nearest_point(const Clothoid& clothoid, Vec2 point, double tolerance) { return Search{clothoid, point, tolerance}.run(); }

CurvePoint offset_point(const Clothoid& clothoid, double s, double left) {
  CurvePoint p = evaluate(clothoid, s);
  p.position = p.position + left * left_of(unit(p.course));
  const double shrink = 1.0 - left * p.curvature;
  if (!(shrink > 0.0)) {
    p.curvature = p.curvature_rate = 0.0;
    return p;
  }
  // By its own arc length, ds′ = (1 − left κ) ds.
  p.curvature_rate = p.curvature_rate / (shrink * shrink * shrink);
  p.curvature = p.curvature / shrink;
  return p;
}

}  // namespace waywright
