// The exponential function of many numbers at once.
#pragma once

#include <span>

namespace waywright {

/// e^x of each, in its place: the same bits as `exponential` (core/elementary) has, several times faster, as divisions are done side by side.
void exponential_each(std::span<double> values);

}  // namespace waywright
