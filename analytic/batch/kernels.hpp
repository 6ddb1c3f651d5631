#pragma once

#include "analytic/batch/step_rows.hpp"

namespace rockstack {

/// The steps of one to three blocks by one instruction set.
struct StepKernels {
  void (*one_block)(StepRows<1>&);
  void (*two_blocks)(StepRows<2>&);
  void (*three_blocks)(StepRows<3>&);
};

extern const StepKernels sse2_kernels, avx2_kernels, avx512_kernels;

}  // namespace rockstack
