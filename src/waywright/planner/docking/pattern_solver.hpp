// The docking pattern that stands: searched on both sides, proven, searched harder where nothing fits; from a vehicle that moves already
// without stopping where that goes. One run at a time, in memory that is kept: nothing is allocated while solving.
#pragma once

#include <vector>

#include "waywright/planner/docking/nearby.hpp"
#include "waywright/planner/docking/pattern_search.hpp"
#include "waywright/proof/proof.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {

class PatternSolver {
 public:
  /// @pre prepared and optimizer outlive this
  PatternSolver(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer, std::uint64_t seed);

  /// Room for paths of so many samples, so that no plan has to ask for it.
  void reserve(std::size_t samples);
  /// The side whose pattern stands; nullptr where none does. `second_choice`: a part of the budget's evaluations is kept for one.
  const SideFound* solve(bool second_choice, Budget& budget);
  /// What is left of a path that is being driven, after so many metres: carried along with its ends, or bent a little beside, where that
  /// stands. Then path, proof and samples are its own.
  std::optional<Continuation> carry_on(const Path& old, double driven, Budget& budget);
  /// Does this whole path stand, the vehicle's motion at its beginning included? Then path, proof and samples are its own.
  bool stands(const Path& whole);

  /// Of the last run or path:
  const std::vector<SideFound>& sides() const { return *sides_; }  ///< what came of each, in the order of the task's zones
  bool in_motion() const { return in_motion_; }         ///< the pattern begins while the vehicle moves
  bool tried_in_motion() const { return tried_in_motion_; }
  bool can_stop() const { return can_stop_; }           ///< false: the vehicle moves and is too near to something before it comes to rest
  const Path& path() const { return path_; }            ///< the whole mission's, where one stands
  const Proof& proof() const { return proof_; }         ///< its proof
  std::vector<Sample>& samples();                       ///< its samples, without t and speed

 private:
  /// What is ready to be offered.
  struct Offer {
    std::size_t side = 0;
    SideFound found;
    Path path;
    Proof proof;
    std::vector<Sample> samples;
  };
  const SideFound* solve_watched(bool second_choice, Budget& budget);
  /// Where a run may be ended at any time, the best so far is proven and sampled while the search goes on.
  void prove_ahead(Budget& budget);
  bool take_ahead(std::size_t side, SideFound& best, bool is_cut_short);
  SideFound* best_standing(std::vector<SideFound>& sides, const Budget& budget);

  const PreparedDocking& prepared_;
  PatternDockingOptions options_;  ///< those of both searches
  std::uint64_t seed_;
  PatternSearch search_;
  NearbySearch nearby_;
  std::vector<SideFound>* sides_ = nullptr;
  std::vector<SideFound> none_;
  bool in_motion_ = false, tried_in_motion_ = false;
  bool can_stop_ = true;
  ProofWorkspace proving_;
  SpeedWorkspace timing_;
  Path path_;
  Proof proof_;
  std::vector<Sample> samples_;
  bool is_sampled_ = false;
  Offer ahead_, next_;
  bool has_ahead_ = false;
};

/// The path that a planner offers for a side: back, then forth.
Path path_of(const SideFound& side);

}  // namespace waywright
