#include "base/assert.hpp"

#include <cstdio>
#include <cstdlib>

namespace physim {

void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: a bug in PhySim: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace physim
