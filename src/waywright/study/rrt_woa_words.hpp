// How variants and parameters of the whales' tables are called.
#pragma once

#include <string>

#include "waywright/study/reproduce_rrt_woa.hpp"

namespace waywright::rrt_woa {

/// "local variant"
const char* variant_name(Variant variant);
/// "threshold mu"
const char* parameter_name(const std::string& parameter);
/// "between -1.2 and +0.4 %"; "nothing more is known of one run" where the interval is infinite
std::string between(double low, double high, int digits, const char* unit);

}  // namespace waywright::rrt_woa
