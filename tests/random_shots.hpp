// Pseudo-random projectiles, launches and environments, the same on every machine: for the tests of fly_batch() and
// for the golden hash. No mathematical function is called and no distribution of the standard library is used; they do
// not depend on the mode of the caller's thread.
#pragma once

#include <cstdint>
#include <vector>

#include "base/ieee_mode.hpp"
#include "physim/physim.hpp"

namespace physim::test {

/// A linear congruential generator of 64 bits (Knuth's constants); its upper bits are used.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x1234567u) { bits(), bits(); }

  std::uint32_t bits() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(state_ >> 32);
  }
  /// 0 <= x < 1 in steps of 2^-32.
  double unit() { return bits() * (1.0 / 4294967296.0); }
  double in(double low, double high) {
    const IeeeMode mode;
    double sum = low + (high - low) * unit();
    asm volatile("" : "+m"(sum) : : "memory");  // compilers may move what needs no memory behind the end of the mode
    return sum;
  }
  int below(int n) { return static_cast<int>((std::uint64_t(bits()) * static_cast<std::uint64_t>(n)) >> 32); }
  bool one_in(int n) { return below(n) == 0; }
  Vec3d vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::uint64_t state_;
};

inline DragDef random_drag(Random& r) {
  const IeeeMode mode;
  DragDef d{.table = static_cast<DragTable>(r.below(12)), .coefficient = r.in(0.1, 1)};
  if (d.table == DragTable::custom) {
    const bool odd = r.one_in(2);
    double mach = r.one_in(2) ? 0 : 0.25;
    for (int i = 0, n = 1 + r.below(8); i < n; ++i) {
      d.curve.push_back({mach, r.in(0.1, 0.9)});
      mach += odd ? r.in(0.05, 0.7) : 0.125 * (1 + r.below(4));
    }
  }
  if (r.one_in(2)) d.ballistic_coefficient = r.in(30, 400);
  if (r.one_in(4))
    for (int i = 0, n = 1 + r.below(4); i < n; ++i) d.bands.push_back({150.0 * i * r.unit() + 90 * i, r.in(50, 300)});
  d.form_factor = r.in(0.7, 1.3);
  d.damping = r.one_in(4) ? 1 : r.in(0.5, 1);
  if (!r.one_in(3)) d.k1 = r.in(0, 0.02);
  if (!r.one_in(3)) d.k2 = r.in(0, 0.001);
  return d;
}

inline ProjectileDef random_projectile(Random& r) {
  const IeeeMode mode;
  ProjectileDef p{.mass = r.one_in(3) ? r.in(0.002, 0.05) : r.in(0.05, 8), .diameter = r.in(0.005, 0.15)};
  p.length = p.diameter * r.in(1, 5);
  p.twist = r.one_in(3) ? 0 : r.in(-0.5, 0.5);
  p.drag = random_drag(r);
  if (r.one_in(6)) {
    p.force = r.vector(20 * p.mass);
    if (r.one_in(2)) p.force_duration = r.in(0.01, 5);
  }
  return p;
}

inline Launch random_launch(Random& r) {
  Launch launch{.position = {r.in(-20, 20), r.in(0, 60), r.in(-20, 20)},
                .azimuth = r.in(-3, 3),
                .sight = {.height = r.in(0, 0.1), .look_angle = r.in(-0.3, 0.5), .cant = r.in(-0.3, 0.3)}};
  if (r.one_in(4)) {
    launch.velocity = r.vector(400);
  } else {
    launch.speed = r.one_in(2) ? r.in(0, 60) : r.in(60, 1100);
    launch.elevation = r.in(-0.2, 1.4);
  }
  return launch;
}

inline std::vector<Shot> random_shots(Random& r, int count) {
  std::vector<Shot> shots;
  for (int i = 0; i < count; ++i) {
    const ProjectileDef p = random_projectile(r);
    shots.push_back({p, random_launch(r)});
  }
  return shots;
}

inline Wind random_wind(Random& r) {
  const IeeeMode mode;
  Wind w;
  if (r.one_in(3)) return w;
  if (r.one_in(3)) {
    w.velocity = r.vector(8);
    return w;
  }
  w.by = r.one_in(2) ? WindAxis::height : WindAxis::range;
  w.interpolation = r.one_in(2) ? WindInterpolation::linear : WindInterpolation::step;
  double at = r.in(-10, 20);
  for (int i = 0, n = 1 + r.below(5); i < n; ++i) {
    w.profile.push_back({at, r.vector(10)});
    at += r.in(5, 300);
  }
  return w;
}

inline Environment random_environment(Random& r) {
  Environment e{.altitude = r.one_in(2) ? 0 : r.in(-100, 12000),
                .gravity = {.model = static_cast<GravityModel>(1 + r.below(2)),
                            .acceleration = r.one_in(4) ? 0.0 + r.in(1, 25) : 9.80665}};
  Atmosphere& a = e.atmosphere;
  a.model = r.one_in(2) ? AirModel::isa : static_cast<AirModel>(r.below(4));
  if (r.one_in(3)) a.temperature = r.in(250, 310);
  if (r.one_in(3)) a.pressure = r.in(60000, 104000);
  if (r.one_in(3)) a.humidity = r.unit();
  if (r.one_in(4)) a.station_altitude = r.in(0, 3000);
  if (r.one_in(5)) a.density = r.in(0.5, 2);
  if (r.one_in(5)) a.sound_speed = r.in(280, 360);
  a.scale_height = r.in(6000, 9000);
  e.wind = random_wind(r);
  e.earth = {.latitude = r.in(-1.5, 1.5), .azimuth = r.in(-3, 3)};
  return e;
}

/// Any mixture of rungs; integrator and precision are the caller's.
inline Fidelity random_fidelity(Random& r) {
  Fidelity f;
  f.motion = r.one_in(8) ? Motion::closed_form : r.one_in(8) ? Motion::velocity : Motion::force;
  f.gravity = r.one_in(10) ? GravityModel::off : static_cast<GravityModel>(1 + r.below(2));
  f.drag = r.one_in(3) ? static_cast<DragModel>(r.below(4)) : DragModel::equation;
  f.air = r.one_in(3) ? static_cast<AirModel>(r.below(4)) : AirModel::isa;
  f.wind = r.one_in(4) ? static_cast<WindModel>(r.below(3)) : WindModel::profile;
  f.earth = static_cast<EarthModel>(r.below(3));
  f.rotation = static_cast<RotationModel>(r.below(2));
  f.integrator = Integrator::tsit5, f.tolerance = 0;
  f.interpolation = static_cast<Interpolation>(r.below(3));
  f.planar = r.one_in(6);
  f.original_one_shot_forces = r.one_in(6);
  return f;
}

/// Ends by ground, range, time and events of every kind; some terminal.
inline Until random_until(Random& r) {
  const IeeeMode mode;
  Until u;
  if (r.one_in(5)) u.ground.reset();
  u.time = r.in(2, 25);
  if (r.one_in(4)) u.range = r.in(50, 3000);
  for (int i = 0, n = r.below(6); i < n; ++i) {
    EventSpec e{.kind = static_cast<EventKind>(r.below(7))};
    const double size[] = {40, 0, 500, 60, 1.5, 300, 10};  // by kind
    e.value = r.in(0, 1) * size[static_cast<int>(e.kind)];
    e.direction = static_cast<Crossing>(r.below(3));
    e.terminal = r.one_in(6);
    u.events.push_back(e);
  }
  return u;
}

}  // namespace physim::test
