// What a plan file says of its path, held against the same made anew.
#pragma once

#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"

namespace waywright {

/// All nine columns of the samples. Other programs may place their samples elsewhere on the curves and drive
/// slower; so samples are found on the fresh ones by their order and by s, and the fresh speed profile, which
/// is the fastest, bounds theirs. Appends what does not hold, at most one sentence.
/// @pre fresh samples carry t and speed
void check_claimed_samples(const std::vector<Sample>& claimed, const std::vector<Sample>& fresh,
                           const Vehicle& vehicle, double radius, double tolerance,
                           std::vector<std::string>& findings);

/// Every figure of merit; the travel time is that of the file's own samples.
void check_claimed_metrics(const Plan& claimed, const Plan& fresh, std::vector<std::string>& findings);

/// The certificate claims no more than what could be proven.
void check_claimed_certificate(const Certificate& claimed, const Certificate& fresh,
                               std::vector<std::string>& findings);

}  // namespace waywright
