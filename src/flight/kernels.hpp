// The batch kernels of this build and machine, and the choice among them.
#pragma once

#include <cstddef>
#include <string_view>

#include "flight/batch_job.hpp"

namespace physim {

struct BatchKernel {
  const char* name;
  void (*fly_float)(const BatchJob<float>& job);
  void (*fly_double)(const BatchJob<double>& job);
};

/// The kernel in use.
[[nodiscard]] const BatchKernel& batch_kernel();

/// The copy of another kernel for the instruction set in use, of `copies` with a name each; beside "scalar", the last.
template <class Kernel, std::size_t N>
[[nodiscard]] const Kernel& copy_in_use(const Kernel (&copies)[N]) {
  const std::string_view wanted = batch_kernel().name;
  for (const Kernel& copy : copies)
    if (copy.name == wanted) return copy;
  return copies[N - 1];
}

}  // namespace physim
