// What a check found, as one table: in a terminal, as CSV, as a page.
#pragma once

#include <string>
#include <vector>

#include "waywright/study/check.hpp"

namespace waywright {

/// What did not solve first, in the site's order; then by the least proven clearance as it is shown, then by the tightest spot on the way.
std::vector<Checked> by_tightness(std::vector<Checked> checked);

CheckCounts counts_of(const std::vector<Checked>& checked, std::size_t places);

/// "200 places: 198 solved and proven, 2 not; 198 taken over, 2 planned".
std::string check_headline(const CheckCounts& counts);

/// All that did not solve with their reasons, and the tightest `most` of the others. `checked` in the order of by_tightness().
std::string check_text(const std::vector<Checked>& checked, const std::vector<Place>& places, const CheckCounts& counts, std::size_t most);
/// One line a place.
std::string check_csv(const std::vector<Checked>& checked, const std::vector<Place>& places);
/// A page with a small picture of each place (its small.svg), linked to its report and its plan.
std::string check_html(const std::vector<Checked>& checked, const std::vector<Place>& places, const CheckCounts& counts, const std::string& title);

}  // namespace waywright
