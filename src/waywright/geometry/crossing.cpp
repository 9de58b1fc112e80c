#include "waywright/geometry/crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace waywright {
namespace {

constexpr std::int64_t work_for_each = 200;  // pairs of boxes looked at, for each edge
constexpr std::int64_t work_for_all = 4'000'000;

int sign_of_turn(Vec2 a, Vec2 b, Vec2 c) {
  const double turn = cross(b - a, c - a);
  return turn > 0.0 ? 1 : turn < 0.0 ? -1 : 0;
}

bool on_segment(Vec2 p, Vec2 a, Vec2 b) { return sign_of_turn(a, b, p) == 0 && dot(p - a, p - b) <= 0.0; }

struct Meeting {
  Vec2 point{};
  bool crosses = false;  ///< through each other, rather than touching or lying on one another
};

/// A common point of two closed segments.
std::optional<Meeting> meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const int abc = sign_of_turn(a, b, c);
  const int abd = sign_of_turn(a, b, d);
  const int cda = sign_of_turn(c, d, a);
  const int cdb = sign_of_turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) {
    return Meeting{a + (cross(c - a, d - c) / cross(b - a, d - c)) * (b - a), true};
  }
  if (on_segment(c, a, b)) return Meeting{c, false};
  if (on_segment(d, a, b)) return Meeting{d, false};
  if (on_segment(a, c, d)) return Meeting{a, false};
  if (on_segment(b, c, d)) return Meeting{b, false};
  return std::nullopt;
}

/// A hierarchy of runs of edges, each half of the one above. Neighbouring runs of a simple ring hardly
/// overlap.
class Search {
 public:
  explicit Search(const Ring& ring) : ring_{ring} {
    while (leaves_ < ring.size()) leaves_ *= 2;
    boxes_.resize(2 * leaves_, Box{{1.0, 1.0}, {-1.0, -1.0}});  // nothing
    for (std::size_t i = 0; i < ring.size(); ++i) boxes_[leaves_ + i] = bounding_box({ring[i], end_of(i)});
    for (std::size_t k = leaves_; k-- > 1;) {
      const Box& a = boxes_[2 * k];
      const Box& b = boxes_[2 * k + 1];
      boxes_[k] = is_nothing(b) ? a
                                : Box{{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
                                      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
    }
    work_left_ = work_for_all + work_for_each * static_cast<std::int64_t>(ring.size());
  }

  std::optional<std::string> run() {
    within(1);
    return found_;
  }

 private:
  static bool is_nothing(const Box& b) { return b.low.x > b.high.x; }
  Vec2 end_of(std::size_t i) const { return ring_[i + 1 == ring_.size() ? 0 : i + 1]; }

  void within(std::size_t node) {
    if (node >= leaves_ || found_ || is_nothing(boxes_[2 * node + 1])) {
      if (node < leaves_ && !found_) within(2 * node);
      return;
    }
    within(2 * node);
    between(2 * node, 2 * node + 1);
    within(2 * node + 1);
  }

  /// Of two runs of one level, a before b.
  void between(std::size_t a, std::size_t b) {
    if (found_ || is_nothing(boxes_[b])) return;
    const Box& p = boxes_[a];
    const Box& q = boxes_[b];
    if (--work_left_ < 0) {
      found_ = "the outline is too entangled to be checked";
      return;
    }
    if (p.low.x > q.high.x || q.low.x > p.high.x || p.low.y > q.high.y || q.low.y > p.high.y) return;
    if (a >= leaves_) return edges(a - leaves_, b - leaves_);
    for (const std::size_t i : {2 * a, 2 * a + 1}) {
      for (const std::size_t k : {2 * b, 2 * b + 1}) between(i, k);
    }
  }

  void edges(std::size_t i, std::size_t k) {
    if (i + 1 == k || (i == 0 && k + 1 == ring_.size()))
      return;  // neighbours share a corner; spikes are looked for before
    const auto met = meeting(ring_[i], end_of(i), ring_[k], end_of(k));
    if (met)
      found_ = fmt::format("edges {} and {} {} at ({:g}, {:g})", i, k, met->crosses ? "cross" : "touch",
                           met->point.x, met->point.y);
  }

  const Ring& ring_;
  std::size_t leaves_ = 1;
  std::vector<Box> boxes_;  // of a binary tree: children of k are 2k and 2k + 1
  std::int64_t work_left_ = 0;
  std::optional<std::string> found_;
};

}  // namespace

std::optional<std::string> find_crossing(const Ring& ring) { return Search{ring}.run(); }

}  // namespace waywright
