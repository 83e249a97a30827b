// The batch kernels of this build and machine, and the one of them that is in use.
#pragma once

#include "base/kernel_choice.hpp"
#include "flight/batch_job.hpp"

namespace physim {

struct BatchKernel {
  const char* name;
  void (*fly_float)(const BatchJob<float>& job);
  void (*fly_double)(const BatchJob<double>& job);
};

/// The kernel in use.
[[nodiscard]] const BatchKernel& batch_kernel();

}  // namespace physim
