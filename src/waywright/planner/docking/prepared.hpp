// What a docking search needs to know of a problem, made once: sides, clearance field, covers of the footprint. Immutable; any number
// of searches may share it.
#pragma once

#include <vector>

#include "waywright/map/clearance_field.hpp"
#include "waywright/planner/docking/lanes/kernels.hpp"
#include "waywright/planner/docking/partition.hpp"

namespace waywright {

class PreparedDocking {
 public:
  /// @pre the problem outlives this
  explicit PreparedDocking(const Problem& problem);

  const Problem& problem() const { return *problem_; }
  const DockingTask& task() const { return task_; }
  const ClearanceField& field() const { return field_; }

  /// Clearance that the search asks for between the ends: what is required, and a little for the proof not to end on a knife's edge.
  double wanted_clearance() const { return wanted_; }
  double radius() const { return radius_; }          ///< m, of the footprint about its origin; 0 for a disc
  double disc() const { return disc_; }              ///< m, of a disc footprint; 0 for a polygon
  const std::vector<Ring>& parts() const { return parts_; }  ///< convex, body frame; a disc is its centre

  /// Where the field alone shows that the footprint keeps the wanted clearance.
  bool is_surely_clear(const Pose& pose) const;
  lanes::Field lane_field() const;
  lanes::Discs coarse() const { return {coarse_.data(), static_cast<int>(coarse_.size())}; }
  lanes::Discs fine() const { return {fine_.data(), static_cast<int>(fine_.size())}; }

 private:
  const Problem* problem_;
  DockingTask task_;
  double wanted_ = 0.0;
  double radius_ = 0.0;
  double disc_ = 0.0;
  std::vector<Ring> parts_;
  std::vector<lanes::Disc> coarse_, fine_;
  ClearanceField field_;
};

}  // namespace waywright
