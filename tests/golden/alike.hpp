// One result from every kernel and number of threads.
#pragma once

#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>

#include "physim/flight.hpp"

namespace physim::test {

/// Whether run(threads) gives `expected` for every kernel and each number of threads; says where it does not.
template <class Run>
bool gives_alike(const char* what, std::uint64_t expected, std::initializer_list<unsigned> numbers, const Run& run) {
  bool same = true;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    for (const unsigned threads : numbers) {
      if (run(threads) == expected) continue;
      std::fprintf(stderr, "golden: %s differ with kernel %s on %u threads\n", what, kernel.c_str(), threads);
      same = false;
    }
  }
  use_kernel("");
  return same;
}

}  // namespace physim::test
