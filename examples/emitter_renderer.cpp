// For a renderer: the particles of an emitter into vertices of one's own, from far to near.
#include <algorithm>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;
using namespace physim::units;

// Vertices as a renderer has them.
struct Sprite {
  Vec3d position, size, rotation;
  std::uint32_t colour;
};

int main() {
  World world;
  EmitterDef smoke;
  smoke.kind = world.add_kind({.mass = 0.001_g, .diameter = 5_mm, .fidelity = Fidelity::game()}).value();
  smoke.position = {0, 1, 0};
  smoke.rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, 90_deg);
  smoke.per_second = {200};
  smoke.from = {.shape = EmitShape::cone, .radius = 0.1, .angle = 20_deg};
  smoke.start = {.lifetime = {1, 2}, .speed = {1, 2}, .rotation = {0, 360_deg}, .flipped = 0.5, .gravity = {-0.05}};
  smoke.life.size = {0.3, {}, {{0, 0.2}, {1, 1}}};                       // it grows to 30 cm
  smoke.life.colour = {.gradient = {{0, 0x404040ff}, {1, 0xa0a0a000}}};  // and fades
  smoke.life.turn = {30_deg, 90_deg};                                    // a second
  const EmitterId chimney = world.add_emitter(smoke).value();
  for (int frame = 0; frame < 240; ++frame) world.single_step();

  const std::size_t count = world.particles(chimney, {});  // how many there are
  std::vector<Sprite> sprites(count);
  std::vector<double> age(count);
  const Vec3d eye{10, 2, 0};
  world.particles(chimney, {.position = {sprites, &Sprite::position},
                            .size = {sprites, &Sprite::size},
                            .rotation = {sprites, &Sprite::rotation},
                            .colour = {sprites, &Sprite::colour},
                            .age = age,
                            .eye = eye});

  std::printf("%zu puffs, the farthest first\n  away [m]  age [s]  size [m]  turned [deg]  RGBA\n", count);
  for (std::size_t i = 0; i < count; i += count / 5) {
    const Sprite& each = sprites[i];
    std::printf("  %8.2f  %7.2f  %8.3f  %12.0f  %08x\n", length(each.position - eye), age[i], each.size.x,
                each.rotation.x / 1_deg, each.colour);
  }
  const bool in_order = std::is_sorted(sprites.begin(), sprites.end(), [&](const Sprite& a, const Sprite& b) {
    return length(a.position - eye) > length(b.position - eye);
  });
  return in_order && count == world.emitter_counts(chimney).alive ? 0 : 1;
}
