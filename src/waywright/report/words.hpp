// Words that the terminal and the report have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// One line for the whole result.
std::string headline(const Plan& plan);

/// Starts with a capital, but for a planner's name, and ends with a full stop; "" stays "".
std::string as_sentence(std::string text, std::string_view planner);

/// "0.0741 m"; "more than 10 m" where nothing came near enough to be measured.
std::string clearance_words(const Certificate& certificate);
/// Nothing stood within the distance that the proof looks to: there is no tightest spot.
bool is_beyond_measure(const Certificate& certificate);

/// "640 evaluations", "1 evaluation, 1234 expansions".
std::string effort_words(const Effort& effort);

/// What a reader must know before trusting the result: the work was cut short, the map lies off the points
/// that it was aligned by.
std::vector<std::string> warnings(const Plan& plan);
/// The alignment's residuals against the clearance; empty where there is nothing to worry about.
std::optional<std::string> alignment_warning(const Scenario& scenario);
/// "0.012, 0.008 m", empty where the map was not aligned by points.
std::string residual_words(const Alignment& alignment);

/// The reason without what the explanation or, beside them, the alternatives say in the same words; empty where they say
/// all of it.
std::string reason_once(const Plan& plan, bool beside_alternatives);
/// The explanation without what the alternatives' outcomes or the reason say in the same words.
std::vector<std::string> explanation_once(const Plan& plan, bool beside_alternatives);

}  // namespace waywright
