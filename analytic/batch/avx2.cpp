#include "analytic/batch/kernel_angles.hpp"
#include "analytic/batch/kernel_forces.hpp"

namespace rockstack {

constinit const StepKernels avx2_kernels = step_kernels<xsimd::avx2>;

}  // namespace rockstack
