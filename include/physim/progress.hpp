// Progress: how far a long call has come.
#pragma once

#include <cstddef>
#include <functional>

namespace physim {

/// Called after each part of the work with the number of parts done and of all; may be empty.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace physim
