// One tree for one plan after another: a robot's own program keeps it while the map changes and the robot drives.
#pragma once

#include <optional>

#include "waywright/planner/tree/kept_tree.hpp"

namespace waywright {

/// For vehicles that can turn on the spot, and the disc around their footprint, as the planner `rrt_star`. One object, one thread.
///
/// Laws: a path that is returned leads from the problem's start to its goal and is as free as PlaneSpace says (`judge` proves it); same calls, same bits.
class TreeSession {
 public:
  TreeSession(const PlaneTreeOptions& options, std::uint64_t seed) : options_{options}, seed_{seed} {}

  /// Grows a new tree. Empty: none was found, or start or goal leave the disc no room.
  std::optional<Path> plan(const Problem& problem, Budget& budget);

  /// On the tree that is there. `problem`: as the last one, its start where the robot is now, `appeared` added to its map (and nothing taken from it); its goal may be another.
  /// `more`: samples that are added, at most. Empty as above, and where the robot sees nothing of the tree. @pre plan() was called
  std::optional<Path> replan(const Problem& problem, const Map& appeared, std::int64_t more, Budget& budget);

  double length() const { return tree_.length(); }                            ///< m, of the tree's way, before corners are left out
  const KeptTreeStatistics& upkeep() const { return kept_.statistics(); }     ///< of the last replan()
  const PlaneTreeStatistics& growth() const { return tree_.statistics(); }    ///< of what was added last
  const PlaneTree& tree() const { return tree_; }

 private:
  PlaneTreeOptions options_;
  std::uint64_t seed_;
  std::uint64_t calls_ = 0;
  PlaneTree tree_;
  KeptTree kept_;
};

}  // namespace waywright
