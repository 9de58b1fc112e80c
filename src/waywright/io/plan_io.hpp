// plan.json and CSV of poses.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/judge/plan.hpp"
#include "waywright/judge/zone_speeds.hpp"

namespace waywright {

/// The plan file's text; numbers are written so that they read back to the same bits.
std::string plan_json(const Plan& plan);

/// A plan file read back: scenario, path pieces, samples, metrics, certificate, explanation.
Parsed<Plan> read_plan(const std::filesystem::path& file);
Parsed<Plan> parse_plan(const std::string& text, const std::string& name);

/// Poses from a CSV file with a header that names x, y, heading and optionally direction (m, m, rad, ±1; any order, comma,
/// semicolon or tab; lines that begin with # skipped), as pieces of straight-interpolated poses, one per run of equal
/// direction. A missing direction is found from the motion. A heading column whose name ends in _deg is in degrees. `notes`, where given, gets a
/// sentence where headings in radians look like degrees. `speeds`, where given, gets the rows that tell one in a column `speed` (m/s).
Parsed<Path> read_poses_csv(const std::filesystem::path& file, std::vector<std::string>* notes = nullptr, std::vector<PoseSpeed>* speeds = nullptr);
Parsed<Path> parse_poses_csv(const std::string& text, const std::string& name, std::vector<std::string>* notes = nullptr, std::vector<PoseSpeed>* speeds = nullptr);

}  // namespace waywright
