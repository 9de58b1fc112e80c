// What the pages of all missions have in common.
#pragma once

#include <string>

#include "waywright/judge/plan.hpp"

namespace waywright {

inline constexpr double picture_width = 860.0;  ///< px

/// The parts that differ by kind of mission, as HTML.
struct PageParts {
  std::string picture;
  std::string charts;    ///< may be empty
  std::string side;      ///< beside the picture
  std::string below;     ///< may be empty
  std::string scenario;  ///< its table
};

/// The whole page: verdict, warnings, the parts, times.
std::string page_html(const Plan& plan, const PageParts& parts);

/// What is proven, in plain words; with its heading. Empty where nothing was looked at.
std::string proof_html(const Plan& plan);

}  // namespace waywright
