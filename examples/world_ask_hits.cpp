// Panes of armoured glass: each takes so much energy, and what comes after goes through. A rule of one's own for hits.
#include <cmath>
#include <cstdio>
#include <map>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Scene scene;
  const ShapeId glass = scene.add_shape(BoxShape{{0.01, 1, 1}}).value();
  std::map<std::uint32_t, double> strength;  // of each pane, in joules
  for (int i = 0; i < 2; ++i)
    strength[scene.add({.shape = glass, .transform = {.position = {20.0 + i, 0, 0}}}).value().index] = 7000;

  World world = World::create({}).value();
  if (!world.set_scene(scene)) return 1;
  const Status answers = world.set_hit_function([&](const HitBatch& batch) {
    for (std::size_t i = 0; i < batch.questions.size(); ++i) {
      const HitQuestion& hit = batch.questions[i];
      double& left = strength[hit.instance.index];
      const double taken = std::min(left, hit.energy);
      left -= taken;
      if (taken < hit.energy)
        batch.answers[i] = {OnHit::pass, hit.velocity * std::sqrt(1 - taken / hit.energy)};
      else
        batch.answers[i] = {.then = OnHit::stick};
    }
  });
  if (!answers) return 1;

  const BodyDef body{.collision = {.on_hit = OnHit::ask}};
  const ProjectileDef bullet{.mass = 10_g, .diameter = 7.62_mm};
  for (int shot = 1; shot <= 5; ++shot) {
    if (!world.spawn(bullet, {.position = {0, 0.05 * shot, 0}, .speed = 800}, body)) return 1;
    for (int step = 0; step < 3; ++step) {
      world.single_step();
      for (const Event& e : world.events()) {
        if (e.kind == EventKind::hit)
          std::printf("shot %d at pane %u, %.0f m/s\n", shot, e.instance.index, e.velocity.x);
        if (e.kind == EventKind::penetrated)
          std::printf("  through, %.0f m/s left, %.0f J lost\n", e.velocity.x, e.energy);
      }
    }
  }
  const HitCounts counts = world.hit_counts();
  std::printf("%llu hits asked in %llu calls\n", static_cast<unsigned long long>(counts.questions),
              static_cast<unsigned long long>(counts.calls));
}
