// A planner that is another program.
#pragma once

#include <atomic>
#include <string>

#include "waywright/judge/judge.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Runs `command` by /bin/sh with the scenario's JSON on its standard input and reads a CSV of poses from its standard output,
/// judged as imported. It has the budget's seconds, or 60; then its whole process group is killed.
Plan run_outside(const Problem& problem, const std::string& command, const std::atomic<bool>* cancel);

}  // namespace waywright
