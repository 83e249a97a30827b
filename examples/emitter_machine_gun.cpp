// Machine gun: bursts by rounds per minute, every fifth round a tracer, and sparks off the wall where a round hits.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Scene scene;
  const ShapeId wall = scene.add_shape(BoxShape{{0.2, 3, 5}}).value();
  if (!scene.add({.shape = wall, .transform = {.position = {100, 2, 0}}})) return 1;
  World world;
  if (!world.set_scene(scene)) return 1;

  EmitterDef sparks;
  sparks.kind = world.add_kind({.mass = 0.001_g, .diameter = 0.5_mm, .fidelity = Fidelity::game()}).value();
  sparks.cycle.plays = false;  // it fires for others alone
  sparks.from = {.shape = EmitShape::cone, .radius = 0, .angle = 60_deg};
  sparks.start = {.lifetime = {0.2, 0.5}, .speed = {5, 20}, .colour = {.colour = 0xffc040ff}};
  sparks.life.colour = {.gradient = {{0, 0xffffffff}, {1, 0xff400000}}};  // they redden and fade
  const EmitterId flash = world.add_emitter(sparks).value();

  ProjectileDef ball = presets::rifle_bullet().projectile;
  ball.fidelity = Fidelity::small_arms();
  EmitterDef gun;
  gun.kind = world.add_kind(ball).value();
  gun.position = {0, 1.5, 0};
  gun.per_second = {0};
  gun.gun = {.rounds_per_minute = 900, .burst_rounds = 5, .burst_pause = 0.4, .dispersion = 2_mrad, .tracer_every = 5};
  gun.gun.tracer = world.add_kind(ball, {.label = "tracer"}).value();
  gun.start = {.lifetime = {5}, .speed = {820}};
  gun.subs = {{.on = SubEvent::hit, .emitter = flash, .count = {12}, .axis = SubAxis::normal}};
  const EmitterId mounted = world.add_emitter(gun).value();

  unsigned long long tracers = 0, hits = 0;
  while (world.time() < 10.5) {
    if (world.time() >= 10 && world.is_playing(mounted) && !world.stop_emitter(mounted)) return 1;
    world.single_step();
    for (const Event& event : world.events()) {
      tracers += event.kind == EventKind::spawned && world[event.id].label() == "tracer";
      hits += event.kind == EventKind::hit;
    }
  }
  const unsigned long long rounds = world.emitter_counts(mounted).born, lit = world.emitter_counts(flash).born;
  std::printf("%llu rounds, %llu of them tracers: %llu hits, %llu sparks\n", rounds, tracers, hits, lit);
  // A burst and its pause take 5 / (900 / 60) + 0.4 s, and the 14th burst is over after 9.8 s.
  return rounds == 14 * 5 && tracers == 14 && hits == rounds && lit == 12 * hits ? 0 : 1;
}
