// A mortar over a hill: the low arc is blocked, the high one clears it; and a flight that meets the hill and bounces
// off.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Scene scene;
  const MaterialId soil = scene.add_material({.name = "soil", .restitution = 0.3, .friction = 0.6}).value();
  if (!scene.add({scene.add_shape(PlaneShape{}).value(), {}, soil})) return 1;
  // A hill 300 m high: a ball that lies deep in the plain.
  if (!scene.add({scene.add_shape(SphereShape{500}).value(), {.position = {800, -200, 0}}, soil})) return 1;

  const ProjectileDef bomb{.mass = 4.1_kg, .diameter = 81_mm, .drag = {.table = DragTable::g1, .form_factor = 1}};
  const Launch mortar{.position = {0, 1, 0}, .speed = 150};
  const Target bunker{.position = {1600, 1, 0}};
  const auto answer = aim(bomb, mortar, {}, Fidelity::simulation(), bunker, {.scene = &scene});
  if (!answer) return std::puts(answer.error().text().c_str()), 1;
  std::puts(answer->explanation().c_str());
  if (answer->low || !answer->high || answer->blocked.size() != 1) return 1;
  std::printf("%s\n", answer->sight_ends ? "the hill hides the bunker" : "the bunker is in sight");

  Until until{.ground = {}, .time = 60};
  until.scene = &scene;
  until.contact = {.collision = {.on_hit = OnHit::bounce}, .restitution = 1, .friction = 1};
  const Flight low = fly(bomb, answer->blocked[0].solution.launch, {}, Fidelity::simulation(), {}, until);
  for (const Event& e : low.events())
    if (e.kind == EventKind::hit && e.time < 10)
      std::printf("%.2f s: hits at (%.0f, %.0f) m with %.0f m/s\n", e.time, e.position.x, e.position.y,
                  length(e.velocity));
  return low.error() ? 1 : 0;
}
