// Is the footprint free along a whole line, arc or turn on the spot? Continuous, by bounds on its motion.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "waywright/core/budget.hpp"
#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct MotionTestLimits {
  std::int64_t placements = 0;  ///< of the footprint
  std::int64_t motions = 0;     ///< candidate motions
  double resolution =
      0.001;  ///< m: a placement that shows less than this length of motion to be free blocks it
};

/// Which obstacle blocked most.
struct Blocker {
  std::string name;    ///< empty where nothing was blocked
  double share = 0.0;  ///< of the blocked placements
  Vec2 point{};        ///< on it, nearest to the first placement that it blocked
};

/// Tests placements and motions of the problem's footprint, and counts what stood in the way. One object, one
/// thread.
///
/// Law: a motion that is called free keeps the required clearance everywhere, but for at most two resolutions
/// of way about the problem's start and goal, where the clearance may be just what is required; there it is
/// tested at points alone. (Sampling would let through what a finer look finds blocked; this test is at home
/// with the proof, and shares nothing with it.)
class MotionTest {
 public:
  MotionTest(const Problem& problem, const MotionTestLimits& limits, Budget& budget)
      : MotionTest{problem, limits, budget, problem.footprint()} {}
  /// Of another footprint, for example the disc around the vehicle's.
  MotionTest(const Problem& problem, const MotionTestLimits& limits, Budget& budget, Footprint footprint);

  /// The pose keeps the required clearance; false also where the limits are spent.
  bool pose_free(const Pose& pose);
  /// It does by more than `beyond` metres.
  bool pose_free_by(const Pose& pose, double beyond);
  /// The whole motion does; false also where the limits or the budget end in the middle of it. Lines, arcs and
  /// turns on the spot alone.
  ///
  /// No footprint point moves farther than rate · way, so that the clearance at a placement in the middle
  /// shows a stretch to both sides to be free; what is left before and behind it is tested in the same way,
  /// until a placement shows less than the resolution: then the motion counts as blocked.
  bool motion_free(std::span<const Piece> pieces);
  bool motion_free(const Pieces& pieces) { return motion_free(std::span{pieces.data(), pieces.size()}); }

  /// Where the last motion that was not free stops being so: what lies before is free.
  struct Stop {
    std::size_t piece = 0;
    double share = 0.0;  ///< of that piece, in [0, 1]
  };
  const Stop& stop() const { return stop_; }

  std::int64_t placements() const { return placements_; }
  std::int64_t motions() const { return motions_; }
  /// The limits are reached, or the budget's clock or flag ends the run.
  bool spent();
  const MotionTestLimits& limits() const { return limits_; }
  Blocker worst_blocker() const;

 private:
  struct Blocked {
    std::int64_t count = 0;
    Vec2 point{};
  };
  /// One piece as it is driven, over the way in metres: of a turn on the spot that of the outermost point.
  struct Driven;
  /// Contact at the pose; exact where its clearance exceeds what is required by less than `wanted`.
  Contact place(const Pose& pose, double wanted);
  void note_blocked(const Contact& contact);
  double rate(const Arc& arc, int direction) const;
  Driven driven(const Piece& piece) const;
  bool interval_free(const Driven& driven, double begin, double end);
  bool near_an_end(const Driven& driven, const Pose& pose) const;

  const Problem& problem_;
  MotionTestLimits limits_;
  Budget& budget_;
  Footprint footprint_;
  double required_;
  Stop stop_;
  std::int64_t placements_ = 0;
  std::int64_t motions_ = 0;
  std::map<std::size_t, Blocked> blocked_;
};

}  // namespace waywright
