// Down a field from a start to a goal, step by step, with what can go wrong named: a local minimum, going to and fro, an obstacle.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/core/pose.hpp"

namespace waywright {

/// What a field asks for at a place.
struct FieldStep {
  Vec2 velocity{};         ///< m/s, or of any unit: where to and how fast
  double potential = 0.0;  ///< falls along the way of a field without noise
};

struct DescentOptions {
  double speed = 0.5;            ///< m/s, at most
  double period = 0.02;          ///< s between looks at the field
  double goal_tolerance = 0.05;  ///< m
  int window = 250;              ///< looks: who stays within `trapped_within` for so long is trapped
  double trapped_within = 0.02;  ///< of how far it would come in that time at full speed
  int patience = 5000;           ///< looks without a lower potential than ever before: it goes to and fro
  bool may_creep = false;        ///< who stays within `trapped_within`, but on a straight way, is not trapped: steps are short by intent
};

/// stalled: it comes no farther, though it is at no minimum.
enum class DescentEnd { goal, local_minimum, oscillation, stalled, blocked, steps, canceled, timed_out };

struct Descent {
  DescentEnd ended = DescentEnd::steps;
  std::vector<Vec2> points;  ///< from the start on; of more than `most_descent_points` steps not all
  Vec2 last{};               ///< where it ended
  std::int64_t steps = 0;
  std::optional<Vec2> minimum;  ///< the field's, where it was looked for about `last` and found
};

/// Points are kept up to this; past it every second of all but the latest quarter is left out, so that no run fills the memory however many steps it takes.
inline constexpr std::size_t most_descent_points = std::size_t{1} << 18;
void keep_bounded(std::vector<Vec2>& points);

/// Euler's method, as the publication has it: the velocity at each look is kept for a period. `field` is empty where the vehicle cannot stand.
/// Laws: no step is longer than speed × period; ends after `most_steps` at most. @pre window ≤ most_descent_points / 4
Descent descend(const std::function<std::optional<FieldStep>(Vec2)>& field, Vec2 start, Vec2 goal, const DescentOptions& options, std::int64_t most_steps, Budget& budget);

}  // namespace waywright
