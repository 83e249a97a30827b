// What a world refuses: definitions that make no sense.
#pragma once

#include "physim/body.hpp"
#include "physim/result.hpp"

namespace physim {

[[nodiscard]] Status check(const WorldDef& def);
[[nodiscard]] Status check(const BodyDef& body, const WorldDef& def, std::size_t environments);
[[nodiscard]] Status check(const Ground& ground);
[[nodiscard]] Status check(const DetailRule& rule);
[[nodiscard]] Status check(Axes axes, const char* place);
[[nodiscard]] Status check(Smoothing smoothing, const char* place);

}  // namespace physim
