// Continuous collision proof of a path, and the checks of its limits and continuity. Shares nothing with planners.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// What was proven of the motion of the whole footprint along the exact curves.
struct Certificate {
  bool collision_free = false;    ///< every pose within the pose error touches nothing; never set by samples alone
  double clearance = 0.0;         ///< m, proven lower bound over the continuous motion and the pose error
  double tolerance = 0.0005;      ///< m, the bound is at most this under the truth (at nominal poses)
  double checked_length = 0.0;    ///< m of path that the proof covered
  /// m, proven lower bound between the forks and the shelf beside its pockets, pose error taken off; only with an insertion. On that
  /// stretch `clearance` is that of everything else.
  std::optional<double> pocket_clearance;
  std::optional<Pose> tightest;  ///< the pose with the least clearance found
  Vec2 tightest_point{};         ///< the obstacle's point there
  std::size_t tightest_source = World::nothing;  ///< its index in the problem's world
};

struct ProofOptions {
  double tolerance = 0.0005;          ///< m
  double position_tolerance = 1e-6;   ///< m, for end poses and joints
  double heading_tolerance = 1e-6;    ///< rad
  const std::atomic<bool>* cancel = nullptr;  ///< once raised, the proof ends undecided
};

struct Violation {
  std::string sentence;       ///< what is wrong, by how much, where
  std::optional<Pose> where;
};

struct Proof {
  Certificate certificate;
  bool measurable = false;            ///< well formed and not too long: samples and metrics can be made of the path
  std::vector<Violation> violations;  ///< of ends, continuity, limits, clearance; empty: the plan stands
  bool holds() const { return violations.empty() && certificate.collision_free; }
};

/// What proofs of one problem's paths share: its bodies made ready, and memory that is reused. For one thread at a time.
class ProofWorkspace {
 public:
  explicit ProofWorkspace(const Problem& problem);
  ProofWorkspace(ProofWorkspace&&) noexcept;
  ProofWorkspace& operator=(ProofWorkspace&&) noexcept;
  ~ProofWorkspace();

 private:
  friend Proof prove(const Problem& problem, const Path& path, const ProofOptions& options, ProofWorkspace& workspace);
  struct State;
  std::unique_ptr<State> state_;
};

/// Proves or refutes. Never throws on data; work is bounded.
Proof prove(const Problem& problem, const Path& path, const ProofOptions& options = {});
/// The same with a workspace made for the problem: where the path holds and is no longer than a docking path (or one proven before),
/// nothing is allocated; poses from outside excepted.
Proof prove(const Problem& problem, const Path& path, const ProofOptions& options, ProofWorkspace& workspace);

}  // namespace waywright
