// Fireworks: shells that burst into stars where their lives end, and stars that crackle: the same at any frame rate.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;
using namespace physim::units;

namespace {

/// Where and when every particle is born.
std::vector<Event> show(int frame_rate) {
  World world = World::create({.ground = {.mode = GroundMode::none}}).value();
  const auto kind = [&world](double mass, double diameter) {
    // Adaptive steps: places are within their tolerance at any frame rate, too.
    return world.add_kind({.mass = mass, .diameter = diameter, .fidelity = Fidelity::small_arms()}).value();
  };

  EmitterDef crackle;
  crackle.kind = kind(0.02_g, 2_mm);
  crackle.cycle.plays = false;  // it fires for others alone
  crackle.maximum = 10'000;
  crackle.from = {.shape = EmitShape::sphere, .radius = 0};
  crackle.start = {.lifetime = {0.3, 0.6}, .speed = {3, 6}};

  EmitterDef star = crackle;
  star.kind = kind(1_g, 1_cm);
  star.start = {.lifetime = {1.2, 1.6}, .speed = {38, 42}};
  star.subs = {{.on = SubEvent::death, .emitter = world.add_emitter(crackle).value(), .count = {5}}};

  EmitterDef mortar;
  mortar.kind = kind(300_g, 7_cm);
  mortar.rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, 90_deg);
  mortar.per_second = {2.5};
  mortar.from = {.shape = EmitShape::cone, .radius = 0.1, .angle = 8_deg};
  mortar.start = {.lifetime = {2.4, 2.7}, .speed = {55, 60}};
  mortar.subs = {
      {.on = SubEvent::death, .emitter = world.add_emitter(star).value(), .count = {60, 80}, .inherit_velocity = 1}};
  if (!world.add_emitter(mortar)) return {};

  std::vector<Event> born;
  for (int frame = 0; frame < 6 * frame_rate; ++frame) {
    if (!world.step(1.0 / frame_rate)) return {};
    for (const Event& event : world.events())
      if (event.kind == EventKind::spawned) born.push_back(event);
  }
  return born;
}

}  // namespace

int main() {
  const std::vector<Event> film = show(24), screen = show(144);
  double farthest = 0, latest = 0;
  for (std::size_t i = 0; i < std::min(film.size(), screen.size()); ++i) {
    farthest = std::max(farthest, length(film[i].position - screen[i].position));
    latest = std::max(latest, std::abs(film[i].time - screen[i].time));
  }
  std::printf("%zu particles at 24 frames a second, %zu at 144\n", film.size(), screen.size());
  std::printf("births are %.0e s and %.0e m apart at most\n", latest, farthest);
  return film.size() == screen.size() && film.size() > 1000 && latest < 1e-9 && farthest < 1e-5 ? 0 : 1;
}
