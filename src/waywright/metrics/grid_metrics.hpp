// The figures of merit of the safe-A* publication, of a way told as points. They stand beside those of metrics.hpp, which are of exact curves.
#pragma once

#include <span>
#include <vector>

#include "waywright/core/pose.hpp"

namespace waywright {

/// Σ of the distances, m. Formula (16).
double way_length(std::span<const Vec2> points);

/// Σ of the angles between one leg and the next, rad, each in [0, π]. Formula (19). Legs without length are left out.
double way_turning(std::span<const Vec2> points);

/// How the publication counts nearness. Distances are to the middles of blocked cells.
struct CellRisk {
  double reach = 1.5;     ///< m, R₁: what is farther does not count
  double scale = 2.0;     ///< m, q
  int exponent = 1;       ///< C: 1 as published, 2 the Gaussian that it is named after
};
/// exp(−½ (d/q)^C), of one blocked cell whose middle is d m away; 0 beyond the reach.
double risk_of(double d, const CellRisk& rule);
/// The sum over all points and all blocked cells within reach of each. Formula (17). It grows with the number of points: ways are compared with points about a metre apart.
/// `blocked`: columns × rows, row by row, not 0: blocked; the middle of a column's and row's cell is (column, row)·cell.
double way_risk(std::span<const Vec2> points, std::span<const unsigned char> blocked, int columns, int rows, double cell, const CellRisk& rule = {});

/// s at so many m/s all the way. Formula (18), corrected: distance over speed.
double way_time(double length, double speed);

/// What is left in the battery, %: 1000 m straight, 500 changes of speed or 200π rad of turning empty it. Formula (20).
double residual_power(double length, double turning, double speed_changes = 0.0);

/// How much less than the reference, %. Formulas (21) to (25). 0 where both are 0, −∞ where the reference alone is.
double reduction(double reference, double proposed);
/// How much less power is used, %, from what is left of both. Formula (26).
double power_reduction(double reference_left, double proposed_left);

/// The points and more between them, so that no two are farther apart than `step`.
std::vector<Vec2> with_points_between(std::span<const Vec2> points, double step);

}  // namespace waywright
