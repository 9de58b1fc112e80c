#include "waywright/dxf/chains.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace waywright::dxf {
namespace {

constexpr double rounding = 1e-8;  // m: corners so near are one, or the edge between them may point anywhere
constexpr double meeting = 1e-6;  // m: ends so near are one point but for rounding

/// Ends of lines by the cell of a grid as wide as the gap.
class Ends {
 public:
  Ends(const std::vector<Chain>& lines, double gap) : lines_{lines}, cell_{std::max(gap, 1e-9)} {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) cells_[key(at(2 * i + end))].push_back(2 * i + end);
    }
  }

  /// End 2i is the first point of line i, 2i + 1 the last.
  Vec2 at(std::size_t end) const { return end % 2 == 0 ? lines_[end / 2].front().at : lines_[end / 2].back().at; }

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
  const std::vector<Chain>& lines_;
  double cell_;
  std::map<Key, std::vector<std::size_t>> cells_;
};

}  // namespace

Joined joined(std::vector<Chain> lines, double gap) {
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
    Chain chain;
    const std::size_t first = enter;
    for (;;) {
      const std::size_t i = enter / 2;
      used[i] = 1;
      Chain line = lines[i];
      if (enter % 2 == 1) std::reverse(line.begin(), line.end());
      const bool meets = !chain.empty() && distance(chain.back().at, line.front().at) <= rounding;
      chain.insert(chain.end(), line.begin() + (meets ? 1 : 0), line.end());
      const std::size_t leave = enter ^ 1U;
      const std::size_t next = partner[leave];
      if (next == Ends::none) return result.open.push_back(std::move(chain));
      result.widest_gap = std::max(result.widest_gap, distance(ends.at(leave), ends.at(next)));
      if (next == first) {
        if (distance(chain.front().at, chain.back().at) <= rounding) chain.pop_back();
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
