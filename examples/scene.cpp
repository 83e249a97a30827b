// What stands in the way of a bullet? A plank and a wall, met along the path that was flown.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Scene scene;
  const MaterialId pine = scene.add_material({.name = "pine"}).value();
  const MaterialId brick = scene.add_material({.name = "brick"}).value();
  const ShapeId plank = scene.add_shape(BoxShape{{0.009, 1, 0.1}}).value(),
                wall = scene.add_shape(BoxShape{{0.1, 3, 5}}).value();
  if (!scene.add({.shape = plank, .transform = {.position = {50, 0, 0}}, .material = pine})) return 1;
  if (!scene.add({.shape = wall, .transform = {.position = {200, 0, 0}}, .material = brick})) return 1;

  const ProjectileDef bullet{
      .mass = 168_gr, .diameter = 0.308_in, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  const Flight flight = fly(bullet, {.position = {0, 0.2, 0}, .speed = 2650_fps}, {}, Fidelity::small_arms(), {},
                            {.ground = {}, .range = 300});
  constexpr double kStep = 0.001;  // between points of the path, which chords connect here [s]
  for (double t = 0; t < flight.duration(); t += kStep)
    for (const SceneHit& hit : scene.all_hits({flight.at(t).position, flight.at(t + kStep).position})) {
      if (hit.starts_inside) continue;  // told by the chord before
      std::printf("%s %s at %.4f m, %.1f ms after the shot\n", hit.entering ? "into" : "out of",
                  scene.material(hit.material).name.c_str(), hit.position.x, (t + hit.part * kStep) * 1000);
    }
}
