#include "analytic/batch/kernel.hpp"
#include "analytic/batch/step_rows.hpp"

namespace rockstack {

constinit const StepKernels avx512_kernels{&StepKernel<Pack<xsimd::avx512f>, 1>::make_steps,
                                           &StepKernel<Pack<xsimd::avx512f>, 2>::make_steps,
                                           &StepKernel<Pack<xsimd::avx512f>, 3>::make_steps};

}  // namespace rockstack
