// A drive down the local field, motion by motion, with what hinders it found and what was tried about it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/field/local_field.hpp"

namespace waywright {

enum class LocalEnd { goal, met, taken, stuck, thrown_about, steps, canceled, timed_out };

/// One motion of the drive, with where it was along which way.
struct LocalDriven {
  FreeState before{};
  FreeStep step;
  std::size_t way = 0;    ///< index into LocalDrive::ways
  double s = 0.0;         ///< m along it
  double off = 0.0;       ///< m from it
  std::size_t pushed_by = LocalField::nobody, kept_by = LocalField::nobody;
  double best = 0.0, since = 0.0;  ///< m, the farthest along this way, and s, since when: of the state before
  LocalField::Sides sides;         ///< after it
};

/// A way planned anew: when, where, why.
struct LocalReplan {
  double t = 0.0;
  Vec2 at{};
  std::size_t blocked_by = LocalField::nobody;  ///< of what moves: it stands in the way; nobody: the way was out of sight
};

struct LocalDrive {
  LocalEnd ended = LocalEnd::steps;
  std::vector<LocalDriven> driven;
  std::vector<WayAhead> ways;     ///< the global one, and those planned anew
  std::vector<LocalReplan> replans;
  FreeState last{};
  std::size_t obstacle = LocalField::nobody;  ///< who was met, or stands in the way
  std::int64_t steps = 0;  ///< in all tries
  int holds = 0, sides = 0;  ///< orders that the drive had in the end
  int tries = 0;           ///< begun again from an earlier moment, in all
};

struct LocalDriveOptions {
  int tries = 40;                 ///< at most
  int replans = 6;                ///< at most
  std::int64_t steps = 50'000;    ///< in all
  double patience = 10.0;         ///< s without getting on, where nothing that moves is the cause
  double longest_wait = 120.0;    ///< s without getting on, whatever the cause
};

/// Drives from a state to the way's end.
///
/// What is met in spite of the field is found out at its time; the drive then begins again from some seconds before, held back till it has passed, or on its other side, farther
/// and farther back, and from the meeting before it where nothing serves: depth first, in a fixed order, a bounded number of times. Who gets no farther along the way for an
/// obstacle's patience, because of one that stands, or out of sight of the way, plans anew from there (`plan_anew`: with what stands as obstacles; empty: there is no way).
class LocalDriver {
 public:
  using PlanAnew = std::function<std::optional<std::vector<Vec2>>(const FreeState&, const std::vector<std::size_t>& standing)>;
  using TopSpeed = std::function<double(const FreeState&)>;
  LocalDriver(const PlaneSpace& space, const Movers& movers, const FreeMotion& motion, const LocalFieldOptions& field, const LocalDriveOptions& options, PlanAnew plan_anew, TopSpeed top)
      : space_{space}, movers_{movers}, motion_{motion}, field_options_{field}, options_{options}, field_{space, movers, motion, field}, plan_anew_{std::move(plan_anew)}, top_{std::move(top)} {}

  /// `proves`: asked of a drive that reached the goal; a time from which on it could not be shown to be clear, and of whom, makes that another meeting.
  struct Meeting {
    double t = 0.0;
    std::size_t obstacle = LocalField::nobody;
  };
  using Proves = std::function<std::optional<Meeting>(const LocalDrive&)>;
  LocalDrive run(const FreeState& start, const std::vector<Vec2>& way, const Proves& proves, Budget& budget) const;

 private:
  struct Branch {
    Meeting meeting;
    std::size_t option = 0;
  };
  Meeting drive(LocalDrive& all, FreeState at, const std::vector<LocalOrder>& orders, Budget& budget) const;
  /// Who stands at the goal for good, and from when on.
  std::optional<Meeting> taken(Vec2 goal) const;
  bool plan_anew(LocalDrive& all, const FreeState& at, std::size_t blocker) const;
  std::vector<LocalOrder> orders_of(const std::vector<Branch>& branches) const;

  const PlaneSpace& space_;
  const Movers& movers_;
  const FreeMotion& motion_;
  LocalFieldOptions field_options_;
  LocalDriveOptions options_;
  LocalField field_;
  PlanAnew plan_anew_;
  TopSpeed top_;
};

}  // namespace waywright
