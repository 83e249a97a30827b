// A bullet through a plank and into a wall; round shot that skips on water; a superball.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  // What it meets, along the way: 18 mm of softwood, then concrete.
  Impact bullet{.mass = 168_gr,
                .diameter = 0.308_in,
                .nose_length = 1.8,
                .velocity = {780, 0, 0},
                .normal = {-1, 0, 0},
                .thickness = 0.018};
  const ImpactResult plank = impact(bullet, materials::fir()).value();
  std::printf("plank: %s, %.1f m/s left, %.1f J lost\n", name(plank.kind).data(), plank.velocity.x, plank.energy);
  bullet.velocity = plank.velocity;
  bullet.thickness = 0.3;
  const ImpactResult wall = impact(bullet, materials::concrete(30e6)).value();
  std::printf("wall: %s %.0f mm deep\n", name(wall.kind).data(), wall.depth * 1000);

  // A 12-pounder's shot meets the sea at 4 degrees: below 18 degrees over the root of its specific gravity.
  const Impact shot{.mass = 12_lb, .diameter = 0.1153, .velocity = {299.3, -20.9, 0}};
  const ImpactResult skip = impact(shot, materials::water()).value();
  std::printf("sea: %s with %.0f m/s\n", name(skip.kind).data(), length(skip.velocity));

  // A ball of one's own: rough and springy, it turns spin into speed.
  const Material floor{.name = "floor", .restitution = 0.9, .friction = 1.5, .grip_restitution = 0.4};
  const Impact ball{.mass = 0.046, .diameter = 0.046, .velocity = {0, -4, 0}, .spin = {0, 0, -100}};
  const ImpactResult bounce = impact(ball, floor).value();
  std::printf("ball: %s forwards with %.2f m/s\n", name(bounce.kind).data(), bounce.velocity.x);
}
