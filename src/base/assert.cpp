#include "base/assert.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "physim/result.hpp"

namespace physim {
namespace {

std::atomic<FailureHandler> handler{nullptr};

[[noreturn]] void fail(const std::string& text) {
  if (const FailureHandler given = handler.load())
    given(text.c_str());
  else
    std::fprintf(stderr, "%s\n", text.c_str());
  std::abort();
}

}  // namespace

FailureHandler set_failure_handler(FailureHandler given) { return handler.exchange(given); }

void assertion_failed(const char* condition, const char* file, int line) {
  fail(std::string(file) + ":" + std::to_string(line) + ": a bug in PhySim: " + condition + " does not hold");
}

void result_detail::end(const char* what, const std::string& text) {
  fail("physim: " + std::string(what) + "\n" + text);
}

}  // namespace physim
