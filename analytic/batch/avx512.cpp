#include "analytic/batch/kernel.hpp"

namespace rockstack {

constinit const StepKernels avx512_kernels = step_kernels<xsimd::avx512f>;

}  // namespace rockstack
