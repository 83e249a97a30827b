// How many cases a fuzz plays, and which.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>

namespace physim::test {

struct FuzzArguments {
  long count = 100000;
  long seed = 1;
  long first = 0;
};

/// PROGRAM [COUNT [SEED [FIRST]]]; nothing, and the usage on stderr, where they make no sense. Lines are written as
/// they end, so that a run that is stopped has told what it found.
inline std::optional<FuzzArguments> read_arguments(const char* program, int count, char** given) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  FuzzArguments a;
  if (count > 1) a.count = std::atol(given[1]);
  if (count > 2) a.seed = std::atol(given[2]);
  if (count > 3) a.first = std::atol(given[3]);
  if (a.count >= 1 && a.count <= 1'000'000'000 && a.first >= 0) return a;
  std::fprintf(stderr, "usage: %s [COUNT [SEED [FIRST]]]\n", program);
  return std::nullopt;
}

}  // namespace physim::test
