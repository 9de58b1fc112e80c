// controls.json and controls.csv.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "waywright/drive/controls.hpp"
#include "waywright/drive/whale_controls.hpp"
#include "waywright/drive/wheel_torques.hpp"

namespace waywright {

/// The files' texts ("waywright-controls/1", docs/controls.md); numbers read back to the same bits.
/// `torques`: of the motors, where they are known; `slowing`: how many times slower than the plan it is driven for their sake.
std::string controls_json(const Plan& plan, const ExactControls& controls, const WheelTorques* torques = nullptr, double slowing = 1.0);
/// `parameters`: all that the search was asked with.
std::string controls_json(const Plan& plan, const WhaleControls& controls, const Parameters& parameters, std::uint64_t seed);
/// t, v, [left,] w, what the wheels are told, and the pose x, y, heading that the commands lead to; a line a command.
std::string controls_csv(const Vehicle& vehicle, std::span<const ControlRow> rows, const WheelTorques* torques = nullptr);

}  // namespace waywright
