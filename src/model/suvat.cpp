// Motion in a straight line under constant acceleration, asked any way round.
//
// What it models: a body that gains equal velocity in equal times. Of its five quantities three determine the others.
// When to use it: estimates by hand, and as a check of flights in a vacuum along one axis; a flight is Motion::force.
// Symbols: s displacement [m]; u, v velocity at the start and at the end [m/s]; a acceleration [m/s^2]; t time [s].
// Equation: v = u + a t; s = u t + a t^2 / 2 = (u + v) t / 2; v^2 = u^2 + 2 a s.
// Source: G. Galilei, Discorsi (1638), third day, propositions 1 and 2 of accelerated motion.
#include "physim/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"

namespace physim {
namespace {

using Motions = Result<std::vector<Suvat>>;

struct NamedQuantity {
  const char* name;
  std::optional<double> SuvatGiven::*value;
};
constexpr NamedQuantity kNamed[] = {
    {"s", &SuvatGiven::s}, {"u", &SuvatGiven::u}, {"v", &SuvatGiven::v}, {"a", &SuvatGiven::a}, {"t", &SuvatGiven::t}};

Error no_motion(const char* message, const char* hint) { return {message, "suvat", hint}; }
Error any_motion(const char* message, const char* hint) {
  return {std::string("any number of motions has these: ") + message, "suvat", hint};
}

Status check(const SuvatGiven& given) {
  constexpr double kSmallest = 1e-50, kLargest = 1e50;
  std::string names;
  int count = 0;
  for (const auto& [name, value] : kNamed) {
    if (!(given.*value)) continue;
    const double size = std::abs(*(given.*value));
    if (size != 0 && !(size >= kSmallest && size <= kLargest))
      return Error{"must be 0, or of a size between 1e-50 and 1e50", std::string("suvat.") + name, ""};
    names += (count++ == 0 ? "" : ", ") + std::string(name);
  }
  if (count == 3) return {};
  return Error{count == 0 ? std::string("nothing is given")
                          : std::to_string(count) + (count == 1 ? " is given: " : " are given: ") + names,
               "suvat", "give exactly three of s, u, v, a and t"};
}

/// Velocities and time give s and a.
Motions between_velocities(double u, double v, double t) {
  if (t != 0) return std::vector{Suvat{.s = (u + v) / 2 * t, .u = u, .v = v, .a = (v - u) / t, .t = t}};
  if (u != v) return no_motion("no motion has these: at t = 0 the velocity is still u", "v must be u, or t not 0");
  return any_motion("at t = 0 every acceleration is possible", "give a instead of t");
}

/// The way and one velocity, at the start or at the end, give the other velocity and a.
Motions along_way(double s, std::optional<double> u, std::optional<double> v, double t) {
  PHYSIM_ASSERT(u.has_value() != v.has_value());
  if (t != 0) {
    const double mean = s / t;  // velocity
    const double first = u ? *u : 2 * mean - *v, last = v ? *v : 2 * mean - *u;
    return std::vector{Suvat{.s = s, .u = first, .v = last, .a = 2 * (u ? mean - first : last - mean) / t, .t = t}};
  }
  if (s != 0) return no_motion("no motion has these: at t = 0 nothing has moved", "s must be 0, or t not 0");
  return any_motion("at t = 0 every acceleration is possible", "give a instead of t");
}

/// A time and an acceleration, with any of the others, give the rest.
Motions after_time(const SuvatGiven& given) {
  const double a = *given.a, t = *given.t;
  if (given.s && t == 0) {
    if (*given.s != 0) return no_motion("no motion has these: at t = 0 nothing has moved", "s must be 0, or t not 0");
    return any_motion("at t = 0 every velocity is possible", "give u instead of s");
  }
  Suvat m{.a = a, .t = t};
  m.u = given.u ? *given.u : given.v ? *given.v - a * t : *given.s / t - a * t / 2;
  m.v = given.v ? *given.v : given.u ? *given.u + a * t : *given.s / t + a * t / 2;
  m.s = given.s ? *given.s : given.u ? (*given.u + a * t / 2) * t : (*given.v - a * t / 2) * t;
  return std::vector{m};
}

/// Two velocities and the acceleration give s and t.
Motions from_velocity_to_velocity(double u, double v, double a) {
  if (a != 0) return std::vector{Suvat{.s = (u + v) / 2 * ((v - u) / a), .u = u, .v = v, .a = a, .t = (v - u) / a}};
  if (u != v) return no_motion("no motion has these: without acceleration the velocity stays", "a must not be 0");
  return any_motion("without acceleration v is u at every time", "give s or t instead of v");
}

/// The way and both velocities give a and t.
Motions from_velocity_to_velocity_along(double s, double u, double v) {
  if (s != 0 && u + v != 0)
    return std::vector{Suvat{.s = s, .u = u, .v = v, .a = (v - u) * ((u + v) / (2 * s)), .t = 2 * (s / (u + v))}};
  if (s != 0) return no_motion("no motion has these: from u to v = -u the way is 0", "s must be 0, or v not -u");
  if (std::abs(u) != std::abs(v))
    return no_motion("no motion has these: where s = 0, v is u or -u", "s must not be 0, or v be of the size of u");
  return any_motion("s = 0 with v of the size of u says nothing of a and t", "give a or t instead of s");
}

/// Returns the size of the velocity at the other end of the way s; `known` is that at this end. `sign`: of s in the
/// question, against which time may run backwards here.
Result<double> speed_at_other_end(double known, double s, double a, double sign) {
  PHYSIM_ASSERT(a != 0);
  const double square = known * known + 2 * a * s;
  if (std::abs(square) <= 4 * std::numeric_limits<double>::epsilon() * (known * known)) return 0.0;  // turns there
  if (square > 0) return std::sqrt(square);
  const double limit = 0 - sign * (known * known) / (2 * a);
  return Error{"no motion has these: the square of the other velocity would be negative", "suvat",
               "s must be at " + std::string(sign * a < 0 ? "most " : "least ") + short_text(limit) + " m"};
}

/// The way, the velocity at the start and the acceleration give the ends: v and t, by rising time. `sign`: as above.
Motions to_place(double s, double u, double a, double sign = 1) {
  if (a == 0) {
    if (u != 0) return std::vector{Suvat{.s = s, .u = u, .v = u, .a = a, .t = s / u}};
    if (s != 0) return no_motion("no motion has these: nothing moves without velocity and acceleration", "s must be 0");
    return any_motion("what rests stays where it is at every time", "give t instead of s");
  }
  const Result<double> speed = speed_at_other_end(u, s, a, sign);
  if (!speed) return speed.error();
  const auto at = [&](double v) {
    const double t = u * v > 0 ? 2 * (s / (u + v)) : (v - u) / a;  // without cancellation
    return Suvat{.s = s, .u = u, .v = v, .a = a, .t = t == 0 ? 0 : t};
  };
  if (*speed == 0) return std::vector{at(0)};
  std::vector<Suvat> both = {at(-*speed), at(*speed)};
  if (both[1].t < both[0].t) std::swap(both[0], both[1]);
  return both;
}

/// The way, the velocity at the end and the acceleration give the starts: u and t, by rising time. Time runs backwards
/// in to_place() here.
Motions from_place(double s, double v, double a) {
  Motions backwards = to_place(-s, v, a, -1);
  if (!backwards) return backwards;
  for (Suvat& m : *backwards) m = {.s = s, .u = m.v, .v = v, .a = a, .t = m.t == 0 ? 0 : -m.t};
  std::ranges::reverse(*backwards);
  return backwards;
}

Motions solve(const SuvatGiven& g) {
  if (g.t) {
    if (g.a) return after_time(g);
    return g.s ? along_way(*g.s, g.u, g.v, *g.t) : between_velocities(*g.u, *g.v, *g.t);
  }
  if (!g.s) return from_velocity_to_velocity(*g.u, *g.v, *g.a);
  if (!g.a) return from_velocity_to_velocity_along(*g.s, *g.u, *g.v);
  return g.u ? to_place(*g.s, *g.u, *g.a) : from_place(*g.s, *g.v, *g.a);
}

}  // namespace

Result<std::vector<Suvat>> suvat(const SuvatGiven& given) {
  const IeeeMode mode;
  if (Status status = check(given); !status) return status.error();
  Motions found = solve(given);
  PHYSIM_ASSERT(!found || found->size() == 1 || found->size() == 2);
  if (found)
    for (Suvat& m : *found)
      for (double* number : {&m.s, &m.u, &m.v, &m.a, &m.t}) *number += 0.0;  // zero has no sign
  return found;
}

}  // namespace physim
