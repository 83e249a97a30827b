// Fountain: an emitter fires drops into a world by itself, each at its own moment, whatever the frame rate is.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  World world;  // ground at height 0, where flights end
  EmitterDef def;
  def.kind = world.add_kind({.mass = 0.034_g, .diameter = 4_mm, .fidelity = Fidelity::game()}).value();
  def.position = {0, 0.5, 0};
  def.rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, 90_deg);  // forwards is up
  def.per_second = {400};
  def.from = {.shape = EmitShape::cone, .radius = 1_cm, .angle = 12_deg};
  def.start.speed = {6, 8};  // evenly between
  const EmitterId fountain = world.add_emitter(def).value();

  for (int frame = 0; frame < 180; ++frame) world.single_step();  // three seconds
  const EmitterCounts counts = world.emitter_counts(fountain);
  std::printf("%llu drops in %.0f s: %llu landed, %u in the air\n", static_cast<unsigned long long>(counts.born),
              world.time(), static_cast<unsigned long long>(counts.landed), counts.alive);
  return counts.born == 1200 && counts.landed + counts.alive == counts.born ? 0 : 1;
}
