#include "waywright/geometry/voronoi_noding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

constexpr int most_rounds = 64;

struct Cut {
  std::uint32_t segment;
  GridPoint at;
};

/// Differences have up to 2²⁹, products 2⁵⁸, their difference 2⁵⁹: exact.
std::int64_t cross(GridPoint o, GridPoint p, GridPoint q) {
  return (std::int64_t{p.x} - o.x) * (std::int64_t{q.y} - o.y) - (std::int64_t{p.y} - o.y) * (std::int64_t{q.x} - o.x);
}

std::int64_t along(const GridSegment& s, GridPoint p) {
  return (std::int64_t{p.x} - s.a.x) * (std::int64_t{s.b.x} - s.a.x) + (std::int64_t{p.y} - s.a.y) * (std::int64_t{s.b.y} - s.a.y);
}

/// On the segment, not at its ends.
bool is_within(const GridSegment& s, GridPoint p, std::int64_t side) { return side == 0 && p != s.a && p != s.b && along(s, p) > 0 && along(s, p) < along(s, s.b); }

int sign(std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

std::int32_t rounded(double v) { return static_cast<std::int32_t>(std::floor(v + 0.5)); }

class Noding {
 public:
  explicit Noding(std::vector<GridSegment> segments) : segments_{std::move(segments)} { tidy(); }

  /// Were there any cuts?
  bool cut() {
    cuts_.clear();
    std::vector<Segment> boxes;
    boxes.reserve(segments_.size());
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const GridSegment& s = segments_[i];
      boxes.push_back({Vec2{double(s.a.x), double(s.a.y)}, Vec2{double(s.b.x), double(s.b.y)}, static_cast<std::uint32_t>(i)});
    }
    const ObstacleIndex index{std::move(boxes)};
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      const GridSegment& s = segments_[i];
      const Box box{{double(s.a.x), double(std::min(s.a.y, s.b.y))}, {double(s.b.x), double(std::max(s.a.y, s.b.y))}};
      index.all_of(box, [&](const Segment& other) {
        if (other.source > i) meet(i, other.source);
        return true;
      });
    }
    if (cuts_.empty()) return false;
    apply();
    tidy();
    return true;
  }

  std::vector<GridSegment> take() { return std::move(segments_); }

 private:
  void meet(std::uint32_t i, std::uint32_t k) {
    const GridSegment &s = segments_[i], &t = segments_[k];
    const std::int64_t sa = cross(t.a, t.b, s.a), sb = cross(t.a, t.b, s.b), ta = cross(s.a, s.b, t.a), tb = cross(s.a, s.b, t.b);
    if (sign(sa) * sign(sb) < 0 && sign(ta) * sign(tb) < 0) {
      const double share = double(sa) / (double(sa) - double(sb));
      const GridPoint at{rounded(s.a.x + share * (double(s.b.x) - s.a.x)), rounded(s.a.y + share * (double(s.b.y) - s.a.y))};
      if (at != s.a && at != s.b) cuts_.push_back({i, at});
      if (at != t.a && at != t.b) cuts_.push_back({k, at});
      return;
    }
    const bool has_s = s.a != s.b, has_t = t.a != t.b;
    if (has_s && is_within(s, t.a, ta)) cuts_.push_back({i, t.a});
    if (has_s && is_within(s, t.b, tb)) cuts_.push_back({i, t.b});
    if (has_t && is_within(t, s.a, sa)) cuts_.push_back({k, s.a});
    if (has_t && is_within(t, s.b, sb)) cuts_.push_back({k, s.b});
  }

  void apply() {
    std::sort(cuts_.begin(), cuts_.end(), [this](const Cut& p, const Cut& q) {
      if (p.segment != q.segment) return p.segment < q.segment;
      const std::int64_t u = along(segments_[p.segment], p.at), v = along(segments_[q.segment], q.at);
      return u != v ? u < v : p.at < q.at;
    });
    for (std::size_t i = 0; i < cuts_.size();) {
      GridSegment& s = segments_[cuts_[i].segment];
      const GridPoint end = s.b;
      const std::uint32_t segment = cuts_[i].segment;
      GridPoint from = s.a;
      bool is_first = true;
      const auto add = [&](GridPoint to) {
        if (to == from) return;
        if (is_first) segments_[segment] = {from, to};
        else segments_.push_back({from, to});
        is_first = false;
        from = to;
      };
      for (; i < cuts_.size() && cuts_[i].segment == segment; ++i) add(cuts_[i].at);
      add(end);
    }
  }

  void tidy() {
    for (GridSegment& s : segments_) {
      if (s.b < s.a) std::swap(s.a, s.b);
    }
    std::sort(segments_.begin(), segments_.end());
    segments_.erase(std::unique(segments_.begin(), segments_.end()), segments_.end());
    // Points that are the end of a segment.
    std::vector<GridPoint> ends;
    for (const GridSegment& s : segments_) {
      if (s.a == s.b) continue;
      ends.push_back(s.a);
      ends.push_back(s.b);
    }
    std::sort(ends.begin(), ends.end());
    std::erase_if(segments_, [&](const GridSegment& s) { return s.a == s.b && std::binary_search(ends.begin(), ends.end(), s.a); });
  }

  std::vector<GridSegment> segments_;
  std::vector<Cut> cuts_;
};

}  // namespace

std::optional<Noded> noded(std::vector<GridSegment> segments) {
  Noding noding{std::move(segments)};
  for (int rounds = 0; rounds <= most_rounds; ++rounds) {
    if (!noding.cut()) return Noded{noding.take(), rounds};
  }
  return std::nullopt;
}

}  // namespace waywright
