// A drive down the local field as a path with its pace, and held against what moves.
#pragma once

#include <optional>
#include <vector>

#include "waywright/judge/pace.hpp"
#include "waywright/planner/field/local_drive.hpp"
#include "waywright/planner/plane/plane_ends.hpp"

namespace waywright {

/// The runs at the ends and the stretch in which a moving vehicle stops are driven as they are, whatever moves.
class TimedDrive {
 public:
  /// `goal`: where the drive ends.
  TimedDrive(const PlaneSpace& space, const PlaneEnd& start, const PlaneEnd& goal);

  /// Where the drive begins, and when.
  FreeState begin() const { return begin_; }

  /// @pre the drive reached the goal
  Path path(const LocalDrive& drive) const;
  /// Of the whole path, as the judge has it.
  Pace pace(const LocalDrive& drive, const Movers& movers) const;

  /// The whole path's samples with their times under a pace.
  Timed timed(const Path& path, const Pace& pace) const;
  /// Which moving obstacle the times cannot be shown to be clear of first, and when.
  std::optional<LocalDriver::Meeting> meets(const std::vector<Sample>& samples) const;

 private:
  Path before() const;  ///< what is driven before the drive begins, but for the stretch in which the vehicle stops
  const PlaneSpace& space_;
  PlaneEnd start_, goal_;
  FreeState begin_{};
  double s_begin_ = 0.0;
};

}  // namespace waywright
