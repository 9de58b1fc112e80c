// Lines and arcs in closed form.
#pragma once

#include "waywright/curve/curve.hpp"

namespace waywright {

/// sin(x)/x, 1 at 0; accurate for small x.
double sinc(double x);

/// The arc after `s` metres. Law: the end of an arc split anywhere is the end of the whole, up to rounding.
CurvePoint evaluate(const Arc& arc, double s);
CurvePoint evaluate(const Line& line, double s);

double arc_length(const Line& line);

}  // namespace waywright
