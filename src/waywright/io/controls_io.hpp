// controls.json and controls.csv.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "waywright/drive/controls.hpp"
#include "waywright/drive/whale_controls.hpp"

namespace waywright {

/// The files' texts ("waywright-controls/1", docs/controls.md); numbers read back to the same bits.
std::string controls_json(const Plan& plan, const ExactControls& controls);
/// `parameters`: all that the search was asked with.
std::string controls_json(const Plan& plan, const WhaleControls& controls, const Parameters& parameters, std::uint64_t seed);
/// t, v, [left,] w, what the wheels are told, and the pose x, y, heading that the commands lead to; a line a command.
std::string controls_csv(const Vehicle& vehicle, std::span<const ControlRow> rows);

}  // namespace waywright
