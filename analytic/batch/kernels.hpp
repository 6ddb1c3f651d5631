#pragma once

#include "analytic/batch/step_rows.hpp"

namespace rockstack {

/// The steps of one and of two blocks by one instruction set.
struct StepKernels {
  void (*one_block)(StepRows<1>&);
  void (*two_blocks)(StepRows<2>&);
};

extern const StepKernels sse2_kernels, avx2_kernels, avx512_kernels;

}  // namespace rockstack
