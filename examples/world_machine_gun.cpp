// Machine gun: a kind made once, spawned often; a pool of tracers that replaces its oldest; rules that clean up.
#include <cstdio>
#include <physim/physim.hpp>
#include <random>

using namespace physim;
using namespace physim::units;

int main() {
  WorldDef def;
  def.pools = {{.name = "tracers", .maximum = 32, .when_full = WhenFull::replace_oldest}};
  World world = World::create(def).value();

  ProjectilePreset preset = presets::rifle_bullet();
  preset.projectile.fidelity = Fidelity::game();
  preset.body.despawn = {.farther = 1500, .older = 3};  // whichever comes first
  const KindId round = *world.add_kind(preset.projectile, preset.body);
  world.reserve(round, 32);  // spawning does not allocate from here on

  std::mt19937 random(7);
  std::normal_distribution<double> spread(0, 1_mrad);
  std::size_t fired = 0, landed = 0, expired = 0, replaced = 0;
  for (int frame = 0; frame < 600; ++frame) {
    if (frame < 300 && frame % 3 == 0) {  // 1200 rounds a minute for five seconds
      const double elevation = 1_deg + spread(random), azimuth = spread(random);
      if (world.spawn(round, {.position = {0, 1.5, 0}, .speed = 820, .elevation = elevation, .azimuth = azimuth}))
        ++fired;
    }
    // What happened since the last step, spawning included: look before the next step forgets it.
    for (const Event& event : world.events())
      if (event.reason == Reason::replaced) ++replaced;
    world.single_step();
    for (const Event& event : world.events()) {
      if (event.kind == EventKind::landed) ++landed;
      if (event.kind == EventKind::expired) ++expired;
    }
  }
  std::printf("%zu fired: %zu landed, %zu expired, %zu made room, %zu in the air\n", fired, landed, expired, replaced,
              world.size());
  std::printf("%llu projectile-steps, %zu bytes\n", static_cast<unsigned long long>(world.counters().projectile_steps),
              world.memory());
  return fired == 100 && landed + expired + replaced + world.size() == fired ? 0 : 1;
}
