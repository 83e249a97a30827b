// The smallest program with a world: what it holds of the library is held to a size.
#include <physim/world.hpp>

#include <cstdio>

int main() {
  using namespace physim;
  World world;
  const auto id =
      world.spawn({.mass = 1, .diameter = 0.1, .fidelity = Fidelity::game()}, {.speed = 10, .elevation = 0.5});
  for (int step = 0; step < 60; ++step) world.single_step();
  std::printf("%s\n", id ? "flies" : "refused");
}
