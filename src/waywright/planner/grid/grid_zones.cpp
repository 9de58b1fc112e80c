#include "waywright/planner/grid/grid_zones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace waywright {
namespace {

constexpr double most_work = 4e9;  // edges looked at: some ten seconds
constexpr double beyond = 1e-6;    // cells, for rounding

/// A zone of either kind.
struct Outlined {
  const Ring* area;
  const Box* box;
};

std::vector<Outlined> outlined(const ZoneRules& rules) {
  std::vector<Outlined> all;
  for (const auto& zone : rules.directed()) all.push_back({&zone.area, &zone.box});
  for (const auto& zone : rules.weighed()) all.push_back({&zone.area, &zone.box});
  return all;
}

/// Every cell whose middle may be within `reach` cells of a segment, row by row.
template <class Mark>
void mark_near(const GridFrame& frame, Vec2 a, Vec2 b, double reach, Mark&& mark) {
  a = frame.in_cells(a) - Vec2{0.5, 0.5};  // middles have whole numbers
  b = frame.in_cells(b) - Vec2{0.5, 0.5};
  if (a.y > b.y) std::swap(a, b);
  const int first = static_cast<int>(std::clamp(std::ceil(a.y - reach), 0.0, static_cast<double>(frame.rows)));
  const int last = static_cast<int>(std::clamp(std::floor(b.y + reach), -1.0, frame.rows - 1.0));
  for (int row = first; row <= last; ++row) {
    double from = std::min(a.x, b.x), to = std::max(a.x, b.x);
    if (b.y > a.y) {
      // Of the segment only what is within reach of the row counts.
      const auto x_at = [&](double y) { return a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0); };
      const double one = x_at(row - reach), other = x_at(row + reach);
      from = std::min(one, other);
      to = std::max(one, other);
    }
    const int begin = static_cast<int>(std::clamp(std::ceil(from - reach), 0.0, static_cast<double>(frame.columns)));
    const int end = static_cast<int>(std::clamp(std::floor(to + reach), -1.0, frame.columns - 1.0));
    for (int column = begin; column <= end; ++column) mark(column, row);
  }
}

}  // namespace

/// What is needed while it is made.
struct GridZones::Work {
  const ZoneRules& rules;
  const GridFrame& frame;
  GridZones& zones;
  std::vector<Move> used;       ///< the neighbourhood's moves
  std::vector<int> numbers;     ///< which of the sixteen they are
  std::map<std::pair<std::uint16_t, double>, std::uint32_t> shared{};

  std::uint32_t add(std::uint16_t against, std::span<const double> factors) {
    const auto number = static_cast<std::uint32_t>(zones.against_.size());
    zones.against_.push_back(against);
    zones.factors_.insert(zones.factors_.end(), factors.begin(), factors.end());
    return number;
  }
  /// Of cells that no outline is near.
  std::uint32_t add_shared(Vec2 middle) {
    std::uint16_t against = 0;
    for (const auto& zone : rules.directed()) {
      if (!zone.box.contains(middle) || !contains(zone.area, middle)) continue;
      for (std::size_t k = 0; k < used.size(); ++k) {
        if (!rules_allow(zone, way(k))) against = static_cast<std::uint16_t>(against | 1U << numbers[k]);
      }
    }
    const double factor = rules.factor_at(middle);
    const auto [found, is_new] = shared.try_emplace({against, factor}, 0);
    if (is_new) found->second = against == 0 && factor == 1.0 ? 0 : add(against, std::vector<double>(used.size(), factor));
    return found->second;
  }
  std::uint32_t add_own(Cell cell) {
    std::uint16_t against = 0;
    std::vector<double> factors(used.size(), 1.0);
    bool is_plain = true;
    const Vec2 from = frame.centre(cell);
    for (std::size_t k = 0; k < used.size(); ++k) {
      const Cell there{cell.column + used[k].column, cell.row + used[k].row};
      if (!frame.contains(there)) continue;
      const Vec2 to = frame.centre(there);
      if (!rules.may_be_driven(from, to)) against = static_cast<std::uint16_t>(against | 1U << numbers[k]);
      if (rules.weighs()) factors[k] = rules.cost(from, to) / distance(from, to);
      is_plain = is_plain && factors[k] == 1.0;
    }
    return is_plain && against == 0 ? 0 : add(against, factors);
  }

 private:
  Vec2 way(std::size_t k) const { return frame.frame.rotate(Vec2{static_cast<double>(used[k].column), -static_cast<double>(used[k].row)}); }
  /// Deep inside, a move breaks the rule by its course alone: as a short way about a point that is surely inside.
  static bool rules_allow(const ZoneRules::Directed& zone, Vec2 course) { return !zone.is_against(course, ZoneRules::planned_course); }
};

tl::expected<GridZones, std::string> GridZones::make(const ZoneRules& rules, const GridFrame& frame, Neighbours neighbours) {
  GridZones zones;
  if (!rules.directs() && !rules.weighs()) return zones;
  zones.weighs_ = rules.weighs();
  zones.least_factor_ = rules.least_factor();
  zones.most_factor_ = rules.most_factor();
  zones.stride_ = steps_of(neighbours);
  zones.per_cell_ = static_cast<int>(neighbours);
  Work work{rules, frame, zones, {}, {}};
  double longest = 0.0;  // cells
  for (int i = 0; i < all_moves; i += zones.stride_) {
    const Move m = moves[static_cast<std::size_t>(i)];
    work.used.push_back(m);
    work.numbers.push_back(i);
    longest = std::max(longest, std::sqrt(static_cast<double>(m.column * m.column + m.row * m.row)));
  }

  const std::vector<Outlined> all = outlined(rules);
  const double reach = longest + (zone_depth / frame.cell) + beyond;
  double effort = 0.0;
  std::vector<std::uint8_t> near(static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows), 0);
  for (const Outlined& zone : all) {
    double corners = 0.0, cells = 0.0;
    for (const Outlined& other : all) {
      if (meet(*zone.box, *other.box, 2.0 * reach * frame.cell)) corners += static_cast<double>(other.area->size());
    }
    const Ring& ring = *zone.area;
    for (std::size_t i = 0; i < ring.size() && effort <= most_work; ++i) {
      mark_near(frame, ring[i], ring[(i + 1) % ring.size()], reach, [&](int column, int row) {
        std::uint8_t& n = near[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) + static_cast<std::size_t>(column)];
        cells += n == 0 ? 1.0 : 0.0;
        n = 1;
      });
    }
    effort += cells * corners * zones.per_cell_;
  }
  if (effort > most_work) {
    return tl::unexpected{fmt::format("the outlines of the zones come near so many cells of {:g} m, with so many corners, that weighing each move would take too long: give a coarser resolution, or zones with fewer corners",
                                      frame.cell)};
  }

  zones.against_.push_back(0);
  zones.factors_.assign(static_cast<std::size_t>(zones.per_cell_), 1.0);
  zones.index_.assign(near.size(), 0);
  for (int row = 0; row < frame.rows; ++row) {
    bool is_known = false;  // of the cell to the left, which no outline is near either: no outline is between
    std::uint32_t known = 0;
    for (int column = 0; column < frame.columns; ++column) {
      const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) + static_cast<std::size_t>(column);
      if (near[at] != 0) {
        is_known = false;
        zones.index_[at] = work.add_own({column, row});
        continue;
      }
      if (!is_known) known = work.add_shared(frame.centre({column, row}));
      is_known = true;
      zones.index_[at] = known;
    }
  }
  return zones;
}

}  // namespace waywright
