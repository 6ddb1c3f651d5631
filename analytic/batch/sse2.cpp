#include "analytic/batch/kernel.hpp"
#include "analytic/batch/step_rows.hpp"

namespace rockstack {

constinit const StepKernels sse2_kernels{&StepKernel<Pack<xsimd::sse2>, 1>::make_steps,
                                         &StepKernel<Pack<xsimd::sse2>, 2>::make_steps,
                                         &StepKernel<Pack<xsimd::sse2>, 3>::make_steps};

}  // namespace rockstack
