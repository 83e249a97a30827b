// Hits by the million: does anything that should be met go through, and is anything met that is not there?
//
//   physim_hits [COUNT [SEED]]
//
// The exit status is 1 where anything was wrong. ./dev hits 1000000 takes a quarter of an hour.
#include "hits/hits.hpp"

#include "fuzz/arguments.hpp"

int main(int argc, char** argv) {
  using namespace physim::test;
  const auto asked = read_arguments("physim_hits", argc, argv);
  if (!asked) return 2;
  long wrong = wrong_casts(asked->count, asked->seed);
  wrong += wrong_impacts(asked->count, asked->seed);
  wrong += wrong_sparks(asked->count);
  wrong += wrong_seams(asked->count, asked->seed);
  std::printf("%ld wrong\n", wrong);
  return wrong == 0 ? 0 : 1;
}
