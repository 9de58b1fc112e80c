// What is commanded to drive a plan, as a picture.
#pragma once

#include <span>
#include <string>

#include "waywright/drive/controls.hpp"
#include "waywright/drive/wheel_torques.hpp"

namespace waywright {

/// controls.svg: v and ω over time with their limits, of a base that goes sideways that speed, too; below them what each wheel does, a chart for each. Stands alone.
/// With `torques` those of the wheels' motors, too.
std::string controls_svg(const Vehicle& vehicle, const std::string& title, std::span<const ControlRow> rows, const WheelTorques* torques = nullptr);

}  // namespace waywright
