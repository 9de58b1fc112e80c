// What a person sees of a plan: a picture, a page, a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// plan.svg: map, station, both sides' transition zones, alternatives, swept footprint, path coloured by
/// direction, tightest spot, scale bar, legend. Stands alone.
std::string plan_svg(const Problem& problem, const Plan& plan);

/// search.svg: how the search went, moving. Empty where the planner tells nothing of it.
std::string search_picture_svg(const Problem& problem, const Plan& plan);

/// report.html: one self-contained file.
std::string report_html(const Problem& problem, const Plan& plan);

/// The same of a mission in legs, whose problems are made here. @pre plan.scenario has legs
std::string plan_svg(const Plan& plan);
std::string report_html(const Plan& plan);
SmallPicture small_picture(const Plan& plan);

/// The styles of all pages: columns, tables, verdicts, light and dark.
std::string_view page_styles();

/// The short table that `plan` prints.
std::string plan_text(const Plan& plan);

}  // namespace waywright
