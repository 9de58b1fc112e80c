// The files of a front of trade-offs.
#pragma once

#include <filesystem>
#include <string>

#include "waywright/core/result.hpp"

namespace waywright {

/// Of the plan with this index, from 0: "01", "02", …
std::string front_plan_folder(std::size_t index);

/// Removes the plans, from that with index `kept` on, that the folder's own front.csv lists, which an earlier run wrote: plan.json, plan.svg and report.html
/// of each, and its folder where nothing else is in it. Without such a file nothing is touched.
Parsed<void> remove_earlier_plans(const std::filesystem::path& folder, std::size_t kept);

}  // namespace waywright
