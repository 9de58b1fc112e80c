// A world of discs, and the navigation function on it.
//
// Source: the navigation-field publication, (4.1)–(4.9) with its gradient corrected; E. Rimon, D. E. Koditschek: Exact robot navigation using artificial potential
// functions, IEEE T-RA 8 (1992).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "waywright/core/pose.hpp"

namespace waywright {

struct Disc {
  Vec2 centre{};
  double radius = 0.0;  ///< m, > 0
};

struct SphereWorld {
  Disc outside;                ///< what is free lies within
  std::vector<Disc> obstacles; ///< apart from each other and from the outer disc's rim
};

struct SymmetricMatrix {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  double determinant() const { return xx * yy - xy * xy; }
};

/// φ = d² / (d^2κ + β)^(1/κ) with d the distance to the goal and β = β₀·β₁ … βₙ, in the unit of the outer disc's radius. All is found from its logarithm
/// f = κ·ln d² − ln β, of which φ^κ = 1/(1 + e^−f) rises evenly: no product is formed, nothing over- or underflows whatever κ and however many obstacles.
///
/// Laws: φ is 0 at the goal, 1 on every rim and between in the free space; its critical points but the goal are those of f, with the same sign of curvature.
class NavigationFunction {
 public:
  /// @pre κ > 0; the goal is free
  NavigationFunction(const SphereWorld& world, Vec2 goal, double kappa) : world_{world}, goal_{goal}, kappa_{kappa} {}

  double kappa() const { return kappa_; }
  const SphereWorld& world() const { return world_; }
  Vec2 goal() const { return goal_; }

  /// Inside the outer disc and outside of all others.
  bool is_free(Vec2 q) const;
  /// m, to the nearest rim; negative beyond it.
  double distance_to_rim(Vec2 q) const;

  /// Of f, at a free place that is not the goal. 1/m; 1/m².
  Vec2 slope(Vec2 q) const;
  SymmetricMatrix curvature(Vec2 q) const;
  /// φ in [0, 1]; 1 where it is not free.
  double value(Vec2 q) const;
  /// ∇φ, 1/m; 0 at the goal and where it is not free.
  Vec2 gradient(Vec2 q) const;
  /// f, at a free place that is not the goal: it tells apart what φ rounds to 1.
  double logarithm(Vec2 q) const;

 private:
  SphereWorld world_;
  Vec2 goal_;
  double kappa_;
};

struct CriticalPoint {
  Vec2 at{};
  bool is_minimum = false;  ///< else a saddle or a maximum
};

/// All critical points of a navigation function but the goal that Newton's method finds, in the order of x: from `side` × `side` starts, and from one behind each disc as it
/// is seen from the goal, where the slope along that ray changes its sign. (The greater κ, the nearer to that place is the disc's saddle, and to its rim, d/2κ off.)
/// `stops`, asked for each start, ends it early.
std::vector<CriticalPoint> critical_points(const NavigationFunction& function, int side = 48, const std::function<bool()>& stops = {});

/// Are there as many saddles as obstacles, and no minimum but the goal? (A disc with n holes has n more saddles than spurious minima: the indices of all
/// critical points, the goal's among them, add up to its Euler characteristic 1 − n.)
bool leads_to_goal(const std::vector<CriticalPoint>& points, const SphereWorld& world);

/// How many times the slope turns around as a circle is gone around once, counter-clockwise: the sum of the indices (minimum 1, saddle −1) of the critical points in it, the
/// goal's 1 among them, and 1 for each disc in it. Empty where the circle leaves the free space or runs into a critical point.
std::optional<int> turns_around(const NavigationFunction& function, Vec2 centre, double radius);

/// Those of 2, 3 … 20 for which that is shown, the first `most` of them. (They are no range: 4 may do and 5 not.) Where none is, the first two of 24, 32, 48, 64 … 4096 for
/// which it is.
std::vector<double> kappas_that_lead_to_goal(const SphereWorld& world, Vec2 goal, const std::function<bool()>& stops = {}, std::size_t most = 64);

/// The direction in which the field leaves a saddle: that of least curvature, a unit vector, one of the two. Empty where the place is no saddle: no direction leads down.
std::optional<Vec2> way_off(const SymmetricMatrix& curvature);

/// Newton's method from a place, by gradient and Hessian: the minimum that it comes to no farther off than `within` (m), at a place of positive `rim`, where the next step
/// is shorter than 10⁻⁶ of that and the curvature positive in every direction. Empty: there is none that it finds.
std::optional<Vec2> minimum_near(const std::function<Vec2(Vec2)>& slope, const std::function<SymmetricMatrix(Vec2)>& curvature, const std::function<double(Vec2)>& rim, Vec2 from, double within);

}  // namespace waywright
