// Presets of projectiles: all can be spawned, and those of the original fly as they did.
#include "must.hpp"
#include "physim/body.hpp"

#include "physim/world.hpp"

namespace physim::prepare_presets_test {

TEST(Presets, AreNamedDescribedAndSpawn) {
  World world;
  for (const std::string_view name : projectile_presets()) {
    const auto preset = must(projectile_preset(name), name);
    EXPECT_EQ(preset.projectile.name, name);
    EXPECT_FALSE(preset.doc.empty()) << name;
    EXPECT_FALSE(preset.source.empty()) << name;
    EXPECT_GT(preset.speed, 0) << name;
    EXPECT_TRUE(world.spawn(preset.projectile, {.position = {0, 1, 0}, .speed = preset.speed}, preset.body)) << name;
  }
  EXPECT_FALSE(projectile_preset("rifle_bulet"));
}

// The published frame of test 5 of the original: the shell with (0, 2, 40) m/s; here x is downrange.
TEST(Presets, ArtilleryFliesAsTheOriginals) {
  World world = World::create({.ground = {.mode = GroundMode::none}}).value();
  const ProjectilePreset shell = presets::artillery();
  const ProjectileId id =
      *world.spawn(shell.projectile, {.position = {0, 1.5, 0}, .velocity = Vec3d{40, 4, 0}}, shell.body);
  for (int frame = 0; frame < 30; ++frame) world.single_step();
  EXPECT_NEAR(world[id].position().x, 19.499438, 5e-4);  // as scenarios/original_artillery.toml
  EXPECT_NEAR(world[id].position().y, 1.233497, 5e-4);
  while (world[id].is_alive()) world.single_step();
  EXPECT_EQ(world[id].status(), LifeStatus::expired);  // 5 m below
}

}  // namespace physim::prepare_presets_test
