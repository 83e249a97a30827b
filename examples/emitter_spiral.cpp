// Spiral: a bullet pattern that turns. Each one leaves where the arc stands at its own moment, not at a frame's.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;

int main() {
  World world = World::create({.ground = {.mode = GroundMode::none}}).value();
  EmitterDef def;
  def.kind = world.add_kind({.fidelity = Fidelity::arcade()}, {.use_gravity = false}).value();
  def.per_second = {90};
  def.from = {.shape = EmitShape::circle, .radius = 0.5, .thickness = 0, .arc_mode = ArcMode::loop, .arc_speed = 0.31};
  def.start = {.lifetime = {4}, .speed = {3}};
  const EmitterId spiral = world.add_emitter(def).value();
  for (int frame = 0; frame < 100; ++frame)  // at ten frames a second, nine bullets are born in each
    if (!world.step(0.1)) return 1;

  const std::size_t count = world.particles(spiral, {});
  std::vector<Vec3d> position(count);
  std::vector<std::uint64_t> number(count);
  world.particles(spiral, {.position = position, .number = number});
  double off = 0;  // from the closed form [m]
  for (std::size_t i = 0; i < count; ++i) {
    const double birth = static_cast<double>(number[i] + 1) / 90, turn = 6.283185307179586 * 0.31 * birth;
    const double away = 0.5 + 3 * (world.time() - birth);
    off = std::max(off, length(position[i] - Vec3d{0, away * std::cos(turn), away * std::sin(turn)}));
  }
  std::printf("%zu bullets, on their spiral within %.0e m\n", count, off);
  return count == 360 && off < 1e-5 ? 0 : 1;
}
