// PHYSIM_ASSERT(condition): states what must be true of our own code; what users give is checked and answered instead.
//
// On where PHYSIM_ASSERTS is 1: in debug and sanitizer builds and in the builds that tests run in. Elsewhere it costs
// nothing, and its condition is not evaluated. Kernels may use it: once per pack, not once per lane.
#pragma once

#include "physim/math.hpp"

#ifndef PHYSIM_ASSERTS
#define PHYSIM_ASSERTS 0
#endif

namespace physim {

/// Gives the condition and its place to the handler (set_failure_handler()), or prints them to stderr, and aborts.
[[noreturn, gnu::cold, gnu::noinline]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace physim

#if PHYSIM_ASSERTS
#define PHYSIM_ASSERT(...) \
  (static_cast<bool>(__VA_ARGS__) ? void(0) : ::physim::assertion_failed(#__VA_ARGS__, __FILE__, __LINE__))
/// Behind a switch that names every enumerator.
#define PHYSIM_UNREACHABLE() ::physim::assertion_failed("an enumerator has a name", __FILE__, __LINE__)
#else
#define PHYSIM_ASSERT(...) void(sizeof(static_cast<bool>(__VA_ARGS__)))
#define PHYSIM_UNREACHABLE() __builtin_unreachable()
#endif
