// Fields: wind and force by functions of one's own.
//
// What it models: whatever they say, by place and time: a gust, a thermal, the air about a hill, a magnetic field, a
//   tether. In a world they are asked for its time, so that a gust meets all at the same moment.
// When it is wrong: where they are. Their corners are not known: adaptive steps find them by their error, fixed steps
//   go over them. In rows of float32 the world's time has the digits of a float.
// Symbols: t time since launch, t_0 that of the launch (0 in flights) [s]; x position, v velocity, w wind in W; m mass
//   that is left [kg]; F force [N].
// Equations: w = w(t_0 + t, x); a = F(t_0 + t, x, v, m) / m.
// Source: none.
#pragma once

#include "math/vec3.hpp"
#include "model/body.hpp"
#include "model/motor.hpp"

namespace physim {

/// Lanes, as functions are asked about them: plain memory, so that kernels share no code with the functions.
struct AskedLanes {
  int count;
  double* time;     // [s]
  Vec3d* position;  // [m]
  Vec3d* velocity;  // of forces [m/s]
  double* mass;     // of forces [kg]
  Vec3d* answer;
};
/// Calls the function for lanes; numbers that are not finite are passed as 0. Answers are NaN if the function throws.
void ask(const WindFunction::Function& function, const AskedLanes& lanes);
void ask(const ForceFunction::Function& function, const AskedLanes& lanes);

}  // namespace physim

PHYSIM_ISA_BEGIN

/// What a function answers to the lanes of a pack.
template <class R, class Function>
PHYSIM_INLINE Vec3<R> answer_of(const Function& function, const R& time, const State<R>& s, const R& mass) {
  using S = ScalarOf<R>;
  constexpr int kCount = kLanes<R>;
  double times[kCount], masses[kCount];
  Vec3d positions[kCount], velocities[kCount], answers[kCount];
  const auto lane = [](const R& x, int i) { return static_cast<double>(lane_of(x, i)); };
  for (int i = 0; i < kCount; ++i) {
    times[i] = lane(time, i);
    masses[i] = lane(mass, i);
    positions[i] = {lane(s.x.x, i), lane(s.x.y, i), lane(s.x.z, i)};
    velocities[i] = {lane(s.v.x, i), lane(s.v.y, i), lane(s.v.z, i)};
  }
  ask(function, {kCount, times, positions, velocities, masses, answers});
  Vec3<R> answer;
  for (int i = 0; i < kCount; ++i) {
    set_lane(answer.x, i, static_cast<S>(answers[i].x));
    set_lane(answer.y, i, static_cast<S>(answers[i].y));
    set_lane(answer.z, i, static_cast<S>(answers[i].z));
  }
  return answer;
}

/// Wind by a function. Behind a call, since it is rare.
template <class R, class S>
PHYSIM_NOINLINE void wind_by_function(const Conditions<S>& c, const Body<R>& b, const R& t, const Vec3<R>& x,
                                      Vec3<R>& w) {
  PHYSIM_ASSERT(c.has_wind_function && c.wind_function != nullptr);
  const R zero(S(0));
  w = answer_of(*c.wind_function, b.birth + t, State<R>{x, {zero, zero, zero}}, zero);
}

/// Acceleration by a force function [m/s^2].
template <class R, class S>
PHYSIM_NOINLINE void push_by_function(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                      Vec3<R>& a) {
  PHYSIM_ASSERT(c.has_force_function && c.force_function != nullptr);
  const R mass = mass_at(b, t);
  const Vec3<R> force = answer_of(*c.force_function, b.birth + t, s, mass);
  const R per_mass = S(1) / mass;
  a = force * per_mass;
}

PHYSIM_ISA_END
