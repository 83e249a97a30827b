// Steam off a mesh and dust off a slope, which the scene and the emitters share; trails, and a show that is under way.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;
using namespace physim::units;

namespace {

/// A pyramid, two by two metres and one high.
MeshShape pyramid() {
  return {{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 1, 0}},
          {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}, {0, 1, 2}, {0, 2, 3}},
          {}};
}
/// 40 by 40 m, with a ridge along z.
HeightFieldShape ridge() {
  HeightFieldShape field{21, 21, 2, 2, {}};
  for (int row = 0; row < 21; ++row)
    for (int column = 0; column < 21; ++column) field.heights.push_back(10 - std::abs(column - 10));
  return field;
}

}  // namespace

int main() {
  World world = World::create({.ground = {.mode = GroundMode::none}}).value();
  const KindId puff = world.add_kind({.mass = 0.001_g, .fidelity = Fidelity::arcade()}, {.use_gravity = false}).value();
  Scene scene;
  const ShapeId stone = scene.add_shape(pyramid()).value(), hill = scene.add_shape(ridge()).value();
  const Transform at{.position = {5, 10, 5}};
  if (!scene.add({.shape = stone, .transform = at}) || !scene.add({.shape = hill})) return 1;

  EmitterDef steam;
  steam.kind = puff;
  steam.position = at.position;  // as the thing stands
  steam.per_second = {500};
  steam.from = {.shape = EmitShape::mesh, .surface = {.shape = SharedShape::of(scene, stone).value()}};
  steam.start = {.lifetime = {2}, .speed = {0.5}};
  steam.trail = {.points = 20, .time = 0.5, .distance = 5_cm};
  const EmitterId steaming = world.add_emitter(steam).value();

  EmitterDef dust = steam;
  dust.position = {};
  dust.from.shape = EmitShape::terrain;
  dust.from.surface = {.shape = SharedShape::of(scene, hill).value(), .high_x = 20};  // the side towards -x
  const EmitterId dusty = world.add_emitter(dust).value();

  if (!world.seek_emitter(steaming, 60) || !world.seek_emitter(dusty, 60)) return 1;  // for a minute already
  for (int frame = 0; frame < 60; ++frame) world.single_step();

  const TrailCounts counts = world.trails(steaming, {});
  std::vector<std::uint32_t> first(counts.particles), count(counts.particles);
  std::vector<Vec3d> place(counts.places);
  world.trails(steaming, {.first = first, .count = count, .position = place});
  double longest = 0;  // [m]
  for (std::size_t i = 0; i < first.size(); ++i)
    longest = std::max(longest, length(place[first[i] + count[i] - 1] - place[first[i]]));

  std::size_t sides = 0;  // of the pyramid's puffs, those that do not come out of its floor
  std::vector<Vec3d> velocity(counts.particles), down_hill(world.particles(dusty, {}));
  world.particles(steaming, {.velocity = velocity});
  for (const Vec3d& v : velocity) sides += v.y > 0;
  world.particles(dusty, {.velocity = down_hill});
  bool is_left = true;
  for (const Vec3d& v : down_hill) is_left = is_left && v.x < 0 && v.y > 0;

  const double expected = 4 * std::sqrt(2.0) / (4 * std::sqrt(2.0) + 4);  // by area
  const double part = static_cast<double>(sides) / static_cast<double>(velocity.size());
  std::printf("%zu puffs off the pyramid, %.2f of them off its sides (%.2f by area)\n", velocity.size(), part,
              expected);
  std::printf("%zu off the slope; trails of %zu places, up to %.2f m long\n", down_hill.size(), counts.places, longest);
  return std::abs(part - expected) < 0.06 && is_left && longest > 0.2 && longest < 0.3 ? 0 : 1;
}
