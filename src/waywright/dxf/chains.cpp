#include "waywright/dxf/chains.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace waywright::dxf {
namespace {

double distance_to_chord(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length = squared_norm(d);
  const double t = length > 0.0 ? std::clamp(dot(p - a, d) / length, 0.0, 1.0) : 0.0;
  return distance(p, a + t * d);
}

constexpr std::size_t longest_stretch = 2048;  // points
constexpr double meeting = 1e-6;  // m: ends so near are one point but for rounding

/// Ends of lines by the cell of a grid as wide as the gap.
class Ends {
 public:
  Ends(const std::vector<Polyline>& lines, double gap) : lines_{lines}, cell_{std::max(gap, 1e-9)} {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) cells_[key(at(2 * i + end))].push_back(2 * i + end);
    }
  }

  /// End 2i is the first point of line i, 2i + 1 the last.
  Vec2 at(std::size_t end) const { return end % 2 == 0 ? lines_[end / 2].front() : lines_[end / 2].back(); }

  /// The one other end within a distance, at most the gap, that is not taken, if there is exactly one.
  std::size_t partner(std::size_t end, double within, const std::vector<char>& taken) const {
    std::size_t found = none;
    const auto [x, y] = key(at(end));
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto cell = cells_.find({x + dx, y + dy});
        if (cell == cells_.end()) continue;
        for (const std::size_t other : cell->second) {
          if (other == end || taken[other] != 0 || !(distance(at(other), at(end)) <= within)) continue;
          if (found != none) return none;
          found = other;
        }
      }
    }
    return found;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;
  Key key(Vec2 p) const {
    constexpr double most = 4e18;
    const auto whole = [&](double v) { return static_cast<std::int64_t>(std::clamp(std::floor(v / cell_), -most, most)); };
    return {whole(p.x), whole(p.y)};
  }
  const std::vector<Polyline>& lines_;
  double cell_;
  std::map<Key, std::vector<std::size_t>> cells_;
};

}  // namespace

Polyline simplified(const Polyline& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<char> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  // Stretch by stretch: what is looked at grows with the square of a stretch where the farthest point is always one of the first.
  std::vector<std::pair<std::size_t, std::size_t>> open;
  for (std::size_t a = 0; a + 1 < line.size(); a += longest_stretch) {
    const std::size_t b = std::min(a + longest_stretch, line.size() - 1);
    kept[b] = 1;
    open.emplace_back(a, b);
  }
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t far = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double d = distance_to_chord(line[i], line[a], line[b]);
      if (!(d > most)) continue;
      most = d;
      far = i;
    }
    if (far == a) continue;
    kept[far] = 1;
    open.emplace_back(a, far);
    open.emplace_back(far, b);
  }
  Polyline out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i] != 0) out.push_back(line[i]);
  }
  return out;
}

Joined joined(std::vector<Polyline> lines, double gap) {
  Joined result;
  const Ends ends{lines, gap};
  std::vector<std::size_t> partner(2 * lines.size(), Ends::none), found(2 * lines.size());
  std::vector<char> taken(2 * lines.size(), 0);
  // Ends that meet come first: of a line that is shorter than the gap, both ends are near to those of its neighbours.
  for (const double within : {std::min(gap, meeting), gap}) {
    for (std::size_t e = 0; e < partner.size(); ++e) found[e] = taken[e] != 0 ? Ends::none : ends.partner(e, within, taken);
    for (std::size_t e = 0; e < partner.size(); ++e) {
      if (found[e] != Ends::none && found[found[e]] == e) partner[e] = found[e];
    }
    for (std::size_t e = 0; e < partner.size(); ++e) taken[e] = partner[e] != Ends::none ? 1 : 0;
  }
  std::vector<char> used(lines.size(), 0);
  /// Follows the chain that is entered at this end of a line.
  const auto follow = [&](std::size_t enter) {
    Polyline chain;
    const std::size_t first = enter;
    for (;;) {
      const std::size_t i = enter / 2;
      used[i] = 1;
      Polyline line = lines[i];
      if (enter % 2 == 1) std::reverse(line.begin(), line.end());
      const bool meets = !chain.empty() && chain.back() == line.front();
      chain.insert(chain.end(), line.begin() + (meets ? 1 : 0), line.end());
      const std::size_t leave = enter ^ 1U;
      const std::size_t next = partner[leave];
      if (next == Ends::none) return result.open.push_back(std::move(chain));
      result.widest_gap = std::max(result.widest_gap, distance(ends.at(leave), ends.at(next)));
      if (next == first) {
        if (chain.front() == chain.back()) chain.pop_back();
        return result.closed.push_back(std::move(chain));
      }
      enter = next;
    }
  };
  for (std::size_t e = 0; e < partner.size(); ++e) {
    if (used[e / 2] == 0 && partner[e] == Ends::none) follow(e);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i] == 0) follow(2 * i);
  }
  return result;
}

}  // namespace waywright::dxf
