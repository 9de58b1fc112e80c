// The Voronoi diagram of what is blocked as a roadmap of a disc: ways along it keep as far from everything as can be.
//
// Sources: C. Ó'Dúnlaing, C. K. Yap: A "retraction" method for planning the motion of a disc, J. Algorithms 6 (1985).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/geometry/voronoi.hpp"
#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/plane/plane_target.hpp"

namespace waywright {

enum class VoronoiEnd { found, no_start, no_goal, unreachable, expansions, stopped };

/// One place of a way, and how it is come to from the one before.
struct VoronoiStep {
  Vec2 at{};
  double clearance = 0.0;             ///< m, to what the diagram is made of: the least since the step before where it is on the diagram, else of the place
  bool is_on_diagram = false;         ///< the line that leads here is part of it
  std::optional<Vec2> control{};      ///< of the quadratic Bézier curve that leads here; none: a straight line does
};

struct VoronoiAnswer {
  VoronoiEnd ended = VoronoiEnd::unreachable;
  std::vector<VoronoiStep> way;  ///< the first step is the start
  std::int64_t expansions = 0;
  std::int64_t lines = 0;  ///< whose freedom was asked for
};

/// Immutable once made; queries may run on many threads. The space outlives it.
///
/// Laws: every line of the diagram that is used keeps needed() from everything that is blocked, its curve does, too. Start and goal see the diagram: whoever goes straight
/// away from the nearest obstacle comes to it, and the clearance does not fall on the way. So there is a way wherever the disc fits through with 2 `sagitta` to spare.
class VoronoiRoadmap {
 public:
  static constexpr double sagitta = 1e-3;                  ///< m, that no curved edge is farther from its places' lines
  static constexpr std::size_t most_segments = 100'000;    ///< of the map

  explicit VoronoiRoadmap(const PlaneSpace& space);

  /// Why there is no roadmap; empty where there is.
  const std::string& refusal() const { return refusal_; }
  const std::optional<VoronoiDiagram>& diagram() const { return diagram_; }
  /// What the diagram is of: what the map has, and where nothing bounds it the region's four sides.
  const ObstacleIndex& sites() const { return sites_; }
  bool has_frame() const { return has_frame_; }
  std::size_t places() const { return places_.size(); }
  std::size_t lines() const { return links_.size() / 2; }  ///< along the diagram, that the disc fits on
  std::vector<std::pair<Vec2, Vec2>> line_list() const;     ///< their ends, for pictures
  double clearance(Vec2 at) const;                          ///< m, to the nearest site

  /// A* by ∫ (1 + weight/clearance) ds, clearance the distance in m from the disc's middle to the nearest site, weight in m. @pre the start is free, of a goal that is a point
  /// that, too.
  VoronoiAnswer shortest(Vec2 start, const PlaneTarget& goal, double weight, Budget& budget, std::optional<std::int64_t> expansions = {}) const;

 private:
  friend class VoronoiSearch;
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  struct Link {
    std::uint32_t to = 0;
    std::uint32_t edge = 0;
  };
  /// How an end comes to the diagram.
  struct Join {
    std::uint32_t place = 0;
    Vec2 end{};                   // where it begins
    std::optional<Vec2> over{};   // bends here
    double length = 0.0;          // m
  };
  void lay_out();
  std::vector<Join> joins(Vec2 from, std::int64_t& lines) const;
  std::vector<Join> joins(const PlaneTarget& goal, std::int64_t& lines) const;
  Vec2 away_from_nearest(Vec2 from) const;
  double cost(Vec2 from, double clearance_from, Vec2 to, double clearance_to, double weight) const;

  const PlaneSpace& space_;
  std::string refusal_;
  bool has_frame_ = false;
  ObstacleIndex sites_;
  std::optional<VoronoiDiagram> diagram_;
  double spacing_ = 0.0;
  std::vector<VoronoiPlace> places_;     // those of no link are not there
  std::vector<std::uint32_t> edge_of_;   // of each place, one of its edges
  std::vector<std::uint32_t> first_;     // of each place, into links_; one more
  std::vector<Link> links_;
};

}  // namespace waywright
