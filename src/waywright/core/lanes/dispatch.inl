// The choice among a folder's kernels; included by its dispatch.cpp, in the kernels' namespace.
extern const Kernels baseline_kernels;
#if defined(__x86_64__)
extern const Kernels avx2_kernels;
extern const Kernels avx512_kernels;
#endif

namespace {

const RunnableKernels<Kernels>& runnable() {
#if defined(__x86_64__)
  static const RunnableKernels<Kernels> kernels{baseline_kernels, avx2_kernels, avx512_kernels};
#else
  static const RunnableKernels<Kernels> kernels{baseline_kernels};
#endif
  return kernels;
}

}  // namespace

std::span<const Kernels> available() { return runnable().all(); }
const Kernels& best() { return runnable().best(); }
