#include "analytic/batch/kernel.hpp"
#include "analytic/batch/step_rows.hpp"

namespace rockstack {

constinit const StepKernels avx2_kernels{&StepKernel<Pack<xsimd::avx2>, 1>::make_steps,
                                         &StepKernel<Pack<xsimd::avx2>, 2>::make_steps,
                                         &StepKernel<Pack<xsimd::avx2>, 3>::make_steps};

}  // namespace rockstack
