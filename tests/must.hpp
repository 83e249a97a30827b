// Takes the value out of a result that must have one.
#pragma once

#include <gtest/gtest.h>

#include <source_location>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace physim {

/// The value of a Result or an optional. Where there is none, the test fails and ends, with the place of the call, what
/// it is `about`, and the error.
template <class R, class A = std::string>
auto must(R result, const A& about = {}, std::source_location at = std::source_location::current()) {
  static_assert(
      !std::is_pointer_v<R> && !requires { result.get(); }, "what a pointer owns is not copied");
  if (result) return *std::move(result);
  testing::Message why;
  why << at.file_name() << ":" << at.line() << ": " << about;
  if constexpr (requires { result.error().text(); })
    why << " " << result.error().text();
  else
    why << " there is no value";
  throw std::runtime_error(why.GetString());
}

}  // namespace physim
