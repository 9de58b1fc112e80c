// Gauss–Legendre rules on [−1, 1] (Abramowitz & Stegun, table 25.4).
#pragma once

#include <cstddef>

namespace waywright {

/// Positive half of a rule with 2n points; its other half is the mirror image with the same weights.
template <std::size_t n>
struct GaussHalf {
  static constexpr std::size_t size = n;
  double node[n], weight[n];
};

inline constexpr GaussHalf<3> gauss_6{{0.2386191860831969086, 0.6612093864662645137, 0.9324695142031520278},
                                      {0.4679139345726910474, 0.3607615730481386076, 0.1713244923791703450}};

inline constexpr GaussHalf<4> gauss_8{{0.1834346424956498049, 0.5255324099163289859, 0.7966664774136267396, 0.9602898564975362317},
                                      {0.3626837833783619830, 0.3137066458778872873, 0.2223810344533744706, 0.1012285362903762592}};

inline constexpr GaussHalf<8> gauss_16{{0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863, 0.6178762444026437484,
                                        0.7554044083550030339, 0.8656312023878317439, 0.9445750230732325761, 0.9894009349916499326},
                                       {0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382, 0.1495959888165767321,
                                        0.1246289712555338720, 0.0951585116824927848, 0.0622535239386478929, 0.0271524594117540949}};

}  // namespace waywright
