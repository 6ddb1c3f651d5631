#include "analytic/batch/kernel_angles.hpp"
#include "analytic/batch/kernel_forces.hpp"

namespace rockstack {

constinit const StepKernels avx512_kernels = step_kernels<xsimd::avx512f>;

}  // namespace rockstack
