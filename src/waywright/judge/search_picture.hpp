// How a search went, for pictures alone: no plan file holds it.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "waywright/core/pose.hpp"

namespace waywright {

/// Time is counted in steps of the search: samples, iterations.
struct SearchPicture {
  static constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();
  struct Line {
    Vec2 from{}, to{};
    std::uint32_t born = 0;      ///< there from this step on
    std::uint32_t gone = never;  ///< and not any more from this one on
    std::vector<Vec2> bend{};    ///< places between both ends, in order, where it is not straight
  };
  struct Way {
    std::vector<Vec2> points;
    std::uint32_t born = 0;  ///< the best one from this step on, until the next
  };
  struct Swarm {
    std::vector<std::vector<Vec2>> agents;
    std::uint32_t born = 0;  ///< where they are from this step on, until the next
  };
  std::string name;         ///< of the lines: "tree of RRT*", "roadmap"
  std::uint32_t steps = 0;  ///< in all
  std::vector<Line> lines;
  std::vector<Way> ways;
  std::vector<Swarm> swarms;
};

}  // namespace waywright
