// Embers: drag, buoyancy and swirls over the life of particles, at two frame rates.
#include <algorithm>
#include <cstdio>
#include <map>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

namespace {

/// Where the smoke of a fire is after three seconds, by the numbers of its particles.
std::map<std::uint64_t, Vec3d> smoke_at(int frames_per_second) {
  World world;
  ProjectileDef mote{.mass = 0.001_g, .diameter = 1_mm, .fidelity = Fidelity::constant_air()};
  mote.fidelity.drag = DragModel::off;  // the emitter says what the air does
  EmitterDef fire;
  fire.kind = world.add_kind(mote).value();
  fire.seed = 1;
  fire.position = {0, 1, 0};
  fire.rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, 90_deg);
  fire.per_second = {80};
  fire.from = {.shape = EmitShape::cone, .radius = 30_cm, .angle = 10_deg};
  fire.start = {.lifetime = {4, 6}, .speed = {1, 3}};
  fire.flight.drag = {4, {}, {{0, 0.5}, {1, 1}}};      // 2 a second at birth, 4 at the end
  fire.flight.gravity = {-0.6};                        // warm air lifts it
  fire.flight.force_x = {5e-6, {}, {{0, 0}, {1, 1}}};  // and wind takes it along [N]
  fire.flight.noise = {6};                             // swirls push it to and fro [m/s^2]
  fire.flight.noise_size = 1.6_m;
  fire.flight.noise_octaves = 3;
  const EmitterId smoke = world.add_emitter(fire).value();
  for (int frame = 0; frame < 3 * frames_per_second; ++frame)
    if (!world.step(1.0 / frames_per_second)) return {};

  const std::size_t count = world.particles(smoke, {});
  std::vector<Vec3d> position(count);
  std::vector<std::uint64_t> number(count);
  world.particles(smoke, {.position = position, .number = number});
  std::map<std::uint64_t, Vec3d> places;
  for (std::size_t i = 0; i < count; ++i) places[number[i]] = position[i];
  return places;
}

}  // namespace

int main() {
  const auto coarse = smoke_at(60), fine = smoke_at(240);
  if (coarse.size() != fine.size()) return 1;
  double apart = 0, top = 0;
  for (const auto& [number, place] : coarse) {
    apart = std::max(apart, length(place - fine.at(number)));
    top = std::max(top, place.y);
  }
  std::printf("%zu motes up to %.1f m high; at 60 and at 240 frames a second they are %.1g m apart at most\n",
              coarse.size(), top, apart);
  return coarse.size() == 240 && apart < 2e-3 ? 0 : 1;
}
