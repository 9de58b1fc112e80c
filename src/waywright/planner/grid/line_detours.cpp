#include "waywright/planner/grid/line_detours.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {

Cell cell_on(Vec2 start, Vec2 goal, double along) {
  const double whole = distance(start, goal);
  return whole == 0.0 ? cell_at(start) : cell_at(start + (along / whole) * (goal - start));
}

std::vector<Detour> detours_of(const CellMap& cells, Vec2 start, Vec2 goal, double around, const std::function<bool(Vec2, Vec2)>& is_free) {
  constexpr double step = 0.25;  // cells
  const double whole = distance(start, goal);
  const auto steps = static_cast<std::int64_t>(std::ceil(whole / step));
  const auto is_blocked = [&](double along) { return cells.is_blocked(cell_on(start, goal, std::clamp(along, 0.0, whole))); };
  std::vector<Detour> detours;
  bool goes_on = false;
  for (std::int64_t i = 0; i <= steps; ++i) {
    const double along = std::min(whole, static_cast<double>(i) * step);
    const bool blocked = is_blocked(along);
    if (blocked && !goes_on) detours.push_back({along, along});
    if (blocked) detours.back().end = along;
    goes_on = blocked;
  }
  for (Detour& d : detours) {
    d.begin -= around;
    d.end += around;
    while (d.begin > 0.0 && is_blocked(d.begin)) d.begin -= step;
    while (d.end < whole && is_blocked(d.end)) d.end += step;
    d = {std::max(0.0, d.begin), std::min(whole, d.end)};
  }
  const auto merged = [&](const std::vector<Detour>& all) {
    std::vector<Detour> apart;
    for (const Detour& d : all) {
      if (apart.empty() || d.begin > apart.back().end) apart.push_back(d);
      else apart.back().end = std::max(apart.back().end, d.end);
    }
    return apart;
  };
  detours = merged(detours);
  // Straight parts: before the first, between two, after the last. Whoever has one that is not free takes it over.
  const auto place = [&](double along) { return along <= 0.0 ? start : along >= whole ? goal : middle_of(cell_on(start, goal, along)); };
  for (std::size_t i = 0; i <= detours.size();) {
    const double from = i == 0 ? 0.0 : detours[i - 1].end, to = i == detours.size() ? whole : detours[i].begin;
    if (from >= to || is_free(place(from), place(to))) {
      ++i;
      continue;
    }
    if (detours.empty()) return {{0.0, whole}};
    if (i == 0) detours.front().begin = 0.0;
    else detours[i - 1].end = to;
    detours = merged(detours);  // those before are as they were
  }
  return detours;
}

std::optional<std::size_t> widened(std::vector<Detour>& detours, std::size_t i, double whole) {
  const auto take_away = [&](std::size_t k) { detours.erase(detours.begin() + static_cast<std::ptrdiff_t>(k)); };
  if (i + 1 < detours.size()) {
    detours[i].end = detours[i + 1].end;
    take_away(i + 1);
    return i;
  }
  if (detours[i].end < whole) {
    detours[i].end = whole;
    return i;
  }
  if (i > 0) {
    detours[i - 1].end = detours[i].end;
    take_away(i);
    return i - 1;
  }
  if (detours[i].begin <= 0.0) return std::nullopt;
  detours[i].begin = 0.0;
  return i;
}

}  // namespace waywright
