#include <array>

#include "waywright/geometry/lanes/kernels.hpp"

namespace waywright::segment_lanes {

extern const Kernels baseline_kernels;
#if defined(__x86_64__)
extern const Kernels avx2_kernels;
extern const Kernels avx512_kernels;
#endif

namespace {

struct Runnable {
  std::array<Kernels, 3> kernels{};
  std::size_t count = 0;
  Runnable() {
    kernels[count++] = baseline_kernels;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) kernels[count++] = avx2_kernels;
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) kernels[count++] = avx512_kernels;
#endif
  }
};

const Runnable& runnable() {
  static const Runnable all;
  return all;
}

}  // namespace

std::span<const Kernels> available() { return {runnable().kernels.data(), runnable().count}; }
const Kernels& best() { return runnable().kernels[runnable().count - 1]; }

}  // namespace waywright::segment_lanes
