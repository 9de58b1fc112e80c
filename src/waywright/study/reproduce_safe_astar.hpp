// The experiments of the safe-A* publication run again on its reconstructed maps: what it prints, what the same rules give here, and what the corrected forms give.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "waywright/map/map.hpp"
#include "waywright/map/published_maps.hpp"

namespace waywright::reproduction {

/// In the publication's order of columns: 8-neighbour A*, the same with its danger coefficient, the straight line with searches around obstacles, and its own.
inline constexpr std::array<const char*, 4> methods{"T_A*", "S_A*", "R_[17]", "SHA*"};
inline constexpr std::size_t own = 3;

inline constexpr std::array<const char*, 6> metrics{"length m", "risk", "search s", "run s", "turning rad", "power %"};
/// By the index of `metrics`.
using Figures = std::array<double, 6>;
inline constexpr std::size_t length = 0, risk = 1, search = 2, run = 3, turning = 4, power = 5;

struct Way {
  bool is_found = false;
  bool is_proven = false;                 ///< of corrected forms
  std::string reason;                     ///< where there is none, or it is not proven
  Figures figures{};
  std::vector<std::vector<Vec2>> legs;    ///< points of the metrics, m
  std::vector<Vec2> boundary;             ///< boundary points, shifted, m
};

struct Experiment {
  std::string name, label, map;           ///< label: short, for the picture
  CellGrid grid;                          ///< that the first three methods search
  CellGrid own_grid;                      ///< that the publication's own searches: where it differs, with regular obstacles
  std::vector<PublishedTask> legs;        ///< planned one after the other
  std::array<std::array<std::optional<double>, 6>, 4> published{};  ///< by method and metric
  std::string derived;                    ///< of figures that the publication does not print: how they follow from what it does; else empty
  std::array<Way, 4> ours;                ///< the published forms
  std::array<Way, 4> corrected;           ///< `astar`, `danger_astar`, `block_astar`, `safe_astar` for a point, proven
};

/// All of them, 9.1 to 9.4 of the reconstruction. Searches are timed alike, whatever the form: everything that can be prepared is, one search warms up and is not
/// counted, then so many are, and the median is taken. Fewer experiments where `cancel` was raised.
std::vector<Experiment> safe_astar(int repetitions, const std::atomic<bool>* cancel);

/// How much less than another method the publication's own has of something, %; of power: how much less is used. Formulas (21) to (26).
double reduction_of(std::size_t metric, double other, double own_figure);

std::string text(const std::vector<Experiment>& experiments);
std::string csv(const std::vector<Experiment>& experiments);
/// A sentence for each published trend (the sign of a reduction) that the same rules do not show on the reconstructed maps.
std::vector<std::string> broken_trends(const std::vector<Experiment>& experiments);
std::string svg(const std::vector<Experiment>& experiments, double width);

}  // namespace waywright::reproduction
