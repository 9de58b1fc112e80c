// What the publication on RRT* with the whale optimisation algorithm prints.
#pragma once

#include "waywright/study/reproduce_rrt_woa.hpp"

namespace waywright::rrt_woa {

/// Table 3.1, by Variant.
std::array<Row, 3> published_comparison();
/// Tables 3.2 to 3.13.
std::vector<Table> published_tables();

}  // namespace waywright::rrt_woa
