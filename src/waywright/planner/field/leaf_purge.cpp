#include "waywright/planner/field/leaf_purge.hpp"

#include <algorithm>
#include <limits>

#include "waywright/planner/field/star.hpp"

namespace waywright {
namespace {

constexpr double least_spread = 1e-9;  // of s, between two corners of the rim
constexpr double beside = 1e-6;        // of the cut's length, from the rim, where shear is looked at
constexpr int divisions = 8;           // of what is between two corners
constexpr double touch = 1e-9;         // m: a shorter piece of a segment does but touch

}  // namespace

std::optional<LeafPurge> LeafPurge::of(const Ring& leaf, double slope_a, double slope_b) {
  LeafPurge purge;
  purge.leaf_ = leaf;
  purge.length_ = distance(leaf[0], leaf[1]);
  if (!(purge.length_ > 0.0)) return std::nullopt;
  purge.along_ = (1.0 / purge.length_) * (leaf[1] - leaf[0]);
  purge.slope_ = slope_a;
  purge.spread_ = slope_b - slope_a;
  purge.s_ = {0.0};
  purge.rim_ = {0.0};
  for (std::size_t i = leaf.size(); i-- > 2;) {
    const Local p = purge.local(leaf[i]);
    const double wide = purge.length_ + p.h * purge.spread_;
    if (!(wide > 1e-6 * purge.length_) || !(p.h > 0.0)) return std::nullopt;
    const double s = (p.x - p.h * slope_a) / wide;
    if (!(s > purge.s_.back() + least_spread)) return std::nullopt;
    purge.s_.push_back(s);
    purge.rim_.push_back(p.h * purge.length_ / wide);
  }
  if (!(purge.s_.back() < 1.0 - least_spread)) return std::nullopt;
  purge.s_.push_back(1.0);
  purge.rim_.push_back(0.0);
  return purge;
}

double LeafPurge::reach() const {
  if (spread_ >= 0.0) return std::numeric_limits<double>::infinity();
  double highest = 0.0;
  for (const double rim : rim_) highest = std::max(highest, height(rim));
  return length_ / -spread_ / highest;
}

double LeafPurge::shear() const {
  double most = 2.0;
  for (std::size_t i = 1; i < leaf_.size(); ++i) {
    const Vec2 a = leaf_[i], b = leaf_[(i + 1) % leaf_.size()], out = (-beside / distance(a, b)) * left_of(b - a);
    for (const double share : {0.1, 0.5, 0.9}) {
      const PlaneImage j = at(a + share * (b - a) + length_ * out);
      most = std::max(most, (j.xx * j.xx + j.xy * j.xy + j.yx * j.yx + j.yy * j.yy) / j.determinant());
    }
  }
  return most;
}

std::size_t LeafPurge::edge_at(double s) const {
  const auto after = std::upper_bound(s_.begin() + 1, s_.end() - 1, s);
  return static_cast<std::size_t>(after - s_.begin()) - 1;
}

double LeafPurge::rim_at(double s) const {
  const std::size_t i = edge_at(s);
  return rim_[i] + (rim_[i + 1] - rim_[i]) * (s - s_[i]) / (s_[i + 1] - s_[i]);
}

double LeafPurge::nearest(Vec2 from, Vec2 to) const {
  const Local a = local(from), b = local(to);
  const double long_ = distance(from, to);
  double low = 0.0, high = 1.0;
  const auto clip = [&](double at_a, double at_b) {  // to where a linear function is not negative
    if (at_a < 0.0 && at_b < 0.0) high = -1.0;
    else if (at_a < 0.0) low = std::max(low, at_a / (at_a - at_b));
    else if (at_b < 0.0) high = std::min(high, at_a / (at_a - at_b));
  };
  const auto wide = [&](Local p) { return length_ + p.h * spread_; };
  clip(a.h, b.h);
  clip(wide(a) - 1e-9 * length_, wide(b) - 1e-9 * length_);
  clip(a.x - a.h * slope_, b.x - b.h * slope_);
  clip(length_ - a.x + a.h * (slope_ + spread_), length_ - b.x + b.h * (slope_ + spread_));
  if (high - low <= 0.0 || (high - low) * long_ < touch) return std::numeric_limits<double>::infinity();
  // Corners of the rim and the segment's ends: between them η and ρ are linear in s, and both parts of h/H = (η/ρ)·((ℓ − ρΔ)/(ℓ − ηΔ)) rise or fall evenly, so that the
  // product of their least is no more than the least of the product; finely divided it is hardly less.
  const double inside = 1e-6 * (high - low);  // at the very ends of the rim both are nought
  std::vector<double> places{low + inside, high - inside};
  for (std::size_t k = 1; k + 1 < s_.size(); ++k) {
    const auto off = [&](Local p) { return p.x - p.h * slope_ - s_[k] * wide(p); };
    const double at_a = off(a), at_b = off(b);
    if ((at_a < 0.0) == (at_b < 0.0)) continue;
    if (const double t = at_a / (at_a - at_b); t > places[0] && t < places[1]) places.push_back(t);
  }
  std::sort(places.begin(), places.end());
  struct Parts {
    double first = 0.0, second = 0.0;
  };
  const auto look = [&](double t) {
    const Local p{a.x + t * (b.x - a.x), std::max(0.0, a.h + t * (b.h - a.h))};
    const double s = std::clamp((p.x - p.h * slope_) / wide(p), 0.0, 1.0), rim = rim_at(s), eta = p.h * length_ / wide(p);
    return rim > 0.0 ? Parts{eta / rim, (length_ - rim * spread_) / (length_ - eta * spread_)} : Parts{std::numeric_limits<double>::infinity(), 1.0};
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    Parts last = look(places[i]);
    for (int k = 1; k <= divisions; ++k) {
      const Parts next = look(places[i] + (places[i + 1] - places[i]) * k / divisions);
      least = std::min(least, std::min(last.first, next.first) * std::min(last.second, next.second));
      last = next;
    }
  }
  return least;
}

PlaneImage LeafPurge::at(Vec2 q) const {
  const Local p = local(q);
  const double wide = length_ + p.h * spread_;
  if (!(p.h > 0.0) || !(wide > 0.0)) return {q};
  const double line = (p.x - p.h * slope_) / wide;
  if (!(line > 0.0) || !(line < 1.0)) return {q};
  if (p.h >= (1.0 + collar_) * height(rim_at(line))) return {q};
  const Dual x{p.x, 1.0, 0.0}, h{p.h, 0.0, 1.0};
  const Dual s = (x - h * constant(slope_)) / (constant(length_) + h * constant(spread_));
  const std::size_t i = edge_at(line);
  const Dual rim = constant(rim_[i]) + constant((rim_[i + 1] - rim_[i]) / (s_[i + 1] - s_[i])) * (s - constant(s_[i]));
  const Dual leaves_at = rim * constant(length_) / (constant(length_) - rim * constant(spread_));
  const Dual to_h = (h - leaves_at) * constant((1.0 + collar_) / collar_);
  const Dual to_x = s * constant(length_) + to_h * (constant(slope_) + s * constant(spread_));
  // From the frame of the cut: M J Mᵀ with M = (along, left of it).
  const Vec2 e = along_, n = left_of(along_);
  const Vec2 by_e = to_x.dx * e + to_h.dx * n, by_n = to_x.dy * e + to_h.dy * n;  // images of e and n
  const Vec2 by_x = e.x * by_e + n.x * by_n, by_y = e.y * by_e + n.y * by_n;
  return {leaf_[0] + to_x.value * e + to_h.value * n, by_x.x, by_y.x, by_x.y, by_y.y};
}

Vec2 LeafPurge::back(Vec2 q) const {
  const Local p = local(q);
  const double wide = length_ + p.h * spread_;
  if (!(p.h > 0.0) || !(wide > 0.0)) return q;
  const double s = (p.x - p.h * slope_) / wide;
  if (!(s > 0.0) || !(s < 1.0)) return q;
  const double leaves_at = height(rim_at(s));
  if (p.h >= (1.0 + collar_) * leaves_at) return q;
  const double h = leaves_at + p.h * collar_ / (1.0 + collar_);
  return leaf_[0] + (s * length_ + h * (slope_ + s * spread_)) * along_ + h * left_of(along_);
}

}  // namespace waywright
