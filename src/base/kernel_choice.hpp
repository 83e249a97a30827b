// Which copy of the kernels is in use (base/kernel_copies.hpp): that of the best instruction set which the machine
// runs, unless set otherwise.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "base/assert.hpp"

namespace physim {

/// The copies that this build has and this machine runs, the best first; "scalar", a loop over plain numbers, is last.
[[nodiscard]] const std::vector<std::string_view>& kernel_names();
/// The one in use; PHYSIM_KERNEL names another one at start.
[[nodiscard]] std::string_view kernel_in_use();
/// Uses another one from now on, "" the best; false if no copy has that name.
bool choose_kernel(std::string_view name);

/// How many copies of this build come before the one in use, the best of them first, whatever this machine runs.
[[nodiscard]] std::size_t number_in_use();

/// The copy in use of all that this build has, with a name each, the best first; the last one if no copy has that name,
/// as in lists without "scalar".
template <class Kernel, std::size_t N>
[[nodiscard]] const Kernel& copy_in_use(const Kernel (&copies)[N]) {
  const std::size_t number = number_in_use();
  PHYSIM_ASSERT(number >= N || copies[number].name == kernel_in_use());
  return copies[number < N ? number : N - 1];
}

}  // namespace physim
