// Which copy of the kernels is in use (base/kernel_copies.hpp): that of the best instruction set which the machine
// runs, unless told otherwise.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace physim {

/// The copies that this build has and this machine runs, the best first; "scalar", a loop over plain numbers, is last.
[[nodiscard]] const std::vector<std::string_view>& kernel_names();
/// The one in use; PHYSIM_KERNEL names another one at start.
[[nodiscard]] std::string_view kernel_in_use();
/// Takes another one from now on, "" the best; false where there is none of that name.
bool choose_kernel(std::string_view name);

/// The copy in use of `copies` with a name each; the last one where none has that name, as of those without "scalar".
template <class Kernel, std::size_t N>
[[nodiscard]] const Kernel& copy_in_use(const Kernel (&copies)[N]) {
  const std::string_view wanted = kernel_in_use();
  for (const Kernel& copy : copies)
    if (copy.name == wanted) return copy;
  return copies[N - 1];
}

}  // namespace physim
