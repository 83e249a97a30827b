// A user's program: prints a hash of the bits of what the library answers, and of what its headers compute. Compiled as
// it is and with -ffast-math, linked as it is and with -ffast-math, it prints the same (cmake/tests.cmake).
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "physim/physim.hpp"

using namespace physim;
using namespace physim::units;

namespace {

std::uint64_t value = 1;

/// Bits alone: this program computes nothing itself.
void add(std::uint64_t bits) {
  value = (value ^ bits) * 0x9e3779b97f4a7c15u;
  value ^= value >> 29;
}
void add(const double& x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  add(bits);
}
void add(const Vec3d& v) { add(v.x), add(v.y), add(v.z); }
void add(const Quatd& q) { add(q.w), add(q.x), add(q.y), add(q.z); }
void add(const Flight& flight) {
  for (const Event& e : flight.events()) add(e.time), add(e.position), add(e.velocity);
  const Sample s = flight.at(0.7);
  add(flight.duration()), add(flight.end().position), add(s.position), add(s.acceleration), add(s.mach);
}

void add_headers() {
  const double literals[] = {168_gr, 175.3_gr, 2.7_lb,  3.1_oz,    0.243_lb_in2, 17_kmh,    2600_fps, 77.7_mph,
                             13_kn,  2.3_deg,  7.7_moa, 29.9_inHg, 21.3_degC,    61.7_degF, 59_degF,  3.3_yd};
  for (const double& x : literals) add(x);
  for (const double& x : {wgs84::kPolarRadius, wgs84::kEccentricitySquared, wgs84::kMeanRadius, kInfinity}) add(x);
  const ProjectileDef plain;
  const Tolerance tolerance;
  const DespawnRules rules;
  for (const double& x : {plain.force_duration, plain.magnus.decay_time, tolerance.max_step, rules.below, rules.older})
    add(x);
  volatile double unknown = 0.1;  // to the compiler
  const double tenth = unknown;
  const Vec3d a{tenth, 0.7, -1.3}, b{1.7, tenth, 0.9};
  add(dot(a, b)), add(cross(a, b)), add(length(a)), add(length_squared(b)), add(normalized(a));
  Vec3d moved = a;
  moved.add_scaled(b, tenth);
  add(moved), add(a * 3), add(2 * b), add(a[1]);
  const Quatd q = quat_from_axis_angle(a, 0.7), p = quat_from_yaw_pitch_roll(0.1, 0.2, 0.3);
  add(q), add(p * q), add(rotate(q, b)), add(norm(p)), add(normalized(q));
  const Target target{.position = a, .velocity = b, .acceleration = a};
  add(target.at(0.37)), add(target.velocity_at(0.37));
}

void add_flights() {
  const ProjectileDef bullet{
      .mass = 168_gr, .diameter = 7.82_mm, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  Launch launch{.position = {0, 1.5, 1e-310}, .speed = 800_mps, .elevation = 0.3_deg};
  const Environment windy{.wind = {.velocity = {0.3, 0, -4}}};
  for (const Fidelity& f : {Fidelity::arcade(), Fidelity::game(), Fidelity::constant_air(), Fidelity::small_arms(),
                            Fidelity::simulation(), Fidelity::classic()}) {
    add(fly(bullet, launch, windy, f));
    for (const ShotResult& shot : fly_batch(bullet, std::span(&launch, 1), windy, f).shots) add(shot.position);
  }
  const auto hit = aim(bullet, launch, windy, Fidelity::small_arms(), {.position = {500, 20, 3}});
  add(hit->low->launch.elevation), add(hit->low->launch.azimuth);

  World world;
  ProjectileDef ball{.mass = 0.5, .diameter = 0.1, .fidelity = Fidelity::game()};
  const ProjectileId id = *world.spawn(ball, {.position = {0, 20, 1e-310}, .speed = 40});
  world[id].add_force(ConstantForce{{0.01, 0, 0}});
  for (int i = 0; i < 60 && world[id].is_alive(); ++i) world.step(1.0 / 60), add(world[id].position());
  add(world.hash()), add(world.time());

  launch.position.x = std::bit_cast<double>(0x7ff8000000000000u);  // NaN is refused
  add(static_cast<std::uint64_t>(fly(bullet, launch).outcome()));
}

}  // namespace

int main() {
  add_headers();
  std::printf("headers %016" PRIx64 "\n", value);
  add_flights();
  std::printf("flights %016" PRIx64 "\n", value);
  return 0;
}
