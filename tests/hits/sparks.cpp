// Hits of a wall, each of which sets off one spark, whatever the frame rate.
#include <cinttypes>
#include <cstdio>

#include "hits/hits.hpp"
#include "physim/body.hpp"
#include "physim/world.hpp"

namespace physim::test {
namespace {

struct Counted {
  std::uint64_t hits = 0, sparks = 0, landed = 0;
};

/// A gun fires at a wall until so many are on their way, and then until all have come.
Counted fire(long count, double frame) {
  WorldDef def{.ground = {.mode = GroundMode::none}};
  World world = std::move(World::create(def).value());
  Scene scene;
  const bool stands = static_cast<bool>(
      scene.add({.shape = scene.add_shape(BoxShape{{0.001, 50, 50}}).value(), .transform = {.position = {5, 0, 0}}}));
  if (!stands || !world.set_scene(scene)) return {};
  ProjectileDef ball;
  ball.fidelity = Fidelity::game();
  ball.fidelity.motion = Motion::closed_form;
  ball.fidelity.drag = DragModel::off;
  ball.fidelity.precision = Precision::float64;
  EmitterDef emitter{.kind = world.add_kind(ball).value(),
                     .cycle = {.plays = false},
                     .start = {.lifetime = {0.01}},
                     .maximum = 1u << 30};
  const EmitterId sparks = world.add_emitter(emitter).value();
  emitter.kind = world.add_kind(ball, {.collision = {.on_hit = OnHit::stop}}).value();
  emitter.cycle = {.duration = 1, .looping = false};
  emitter.per_second = {static_cast<double>(count)};
  emitter.start = {.lifetime = {10}, .speed = {100, 900}};
  emitter.subs = {{.on = SubEvent::hit, .emitter = sparks, .count = {1}, .axis = SubAxis::normal}};
  const EmitterId gun = world.add_emitter(emitter).value();
  Counted counted;
  while (world.time() < 1.2) {
    static_cast<void>(world.step(frame));
    for (const Event& e : world.events()) counted.hits += e.kind == EventKind::hit;
  }
  counted.sparks = world.emitter_counts(sparks).born;
  counted.landed = world.emitter_counts(gun).landed;
  return counted;
}

}  // namespace

long wrong_sparks(long count) {
  long wrong = 0;
  for (const double frame : {1.0 / 10, 1.0 / 24, 1.0 / 60, 1.0 / 144, 1.0 / 1000}) {
    const Counted c = fire(count, frame);
    const bool is_right = c.hits == static_cast<std::uint64_t>(count) && c.sparks == c.hits && c.landed == c.hits;
    std::printf("%4.0f frames a second: %" PRIu64 " hits, %" PRIu64 " sparks%s\n", 1 / frame, c.hits, c.sparks,
                is_right ? "" : ": wrong");
    wrong += is_right ? 0 : 1;
  }
  return wrong;
}

}  // namespace physim::test
