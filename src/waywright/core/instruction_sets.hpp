// Kernels that are compiled once for each instruction set: those that this processor can run.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace waywright {

/// Kernels: a value type of function pointers. For the file that chooses among them, which is compiled for every processor: no file of
/// kernels includes this.
template <class Kernels>
class RunnableKernels {
 public:
  explicit RunnableKernels(const Kernels& baseline) { kernels_[count_++] = baseline; }
#if defined(__x86_64__)
  RunnableKernels(const Kernels& baseline, const Kernels& avx2, const Kernels& avx512) : RunnableKernels{baseline} {
    if (__builtin_cpu_supports("avx2")) kernels_[count_++] = avx2;
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) kernels_[count_++] = avx512;
  }
#endif
  std::span<const Kernels> all() const { return {kernels_.data(), count_}; }  ///< the plainest first
  const Kernels& best() const { return kernels_[count_ - 1]; }                ///< the widest

 private:
  std::array<Kernels, 3> kernels_{};
  std::size_t count_ = 0;
};

}  // namespace waywright
