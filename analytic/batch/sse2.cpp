#include "analytic/batch/kernel_angles.hpp"
#include "analytic/batch/kernel_forces.hpp"

namespace rockstack {

constinit const StepKernels sse2_kernels = step_kernels<xsimd::sse2>;

}  // namespace rockstack
