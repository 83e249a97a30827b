// Emitters in the client: how they are drawn, and their curves as a hand changes them.
#include <cmath>

#include "cli/program.hpp"
#include "client/support.hpp"
#include "simclient/core/emitter_edit.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

TEST(EmitterEdit, keys_stay_in_order) {
  Curve curve{{0, 1}, {0.5, 2}, {1, 0}};
  EXPECT_EQ(key_near(curve, 0.47, 0.05), 1u);
  EXPECT_EQ(key_near(curve, 0.3, 0.05), std::nullopt);
  move_key(curve, 1, 1.5);
  EXPECT_DOUBLE_EQ(curve[1].at, 1 - kKeysApart);
  move_key(curve, 1, -3);
  EXPECT_DOUBLE_EQ(curve[1].at, kKeysApart);
  move_key(curve, 0, -1);
  EXPECT_EQ(curve[0].at, 0);
  EXPECT_EQ(add_key(curve, {0.7, 5}), 2u);
  EXPECT_EQ(add_key(curve, {0.7, 6}), std::nullopt) << "there is one";
  EXPECT_EQ(add_key(curve, {1.2, 6}), std::nullopt);
  Gradient none;
  EXPECT_EQ(add_key(none, {0.5, 0xff0000ff}), 0u);
  EXPECT_EQ(colour_of(none, 0.9), 0xff0000ffu);
  EXPECT_EQ(value_of({}, 0.3), 1);
}

TEST(EmitterEdit, every_line_is_told_apart) {
  EmitterDef def;
  for (std::size_t i = 0; i < lines_of(def).size(); ++i) {
    EmitterDef changed = def;
    const EmitterLine line = lines_of(changed)[i];
    EXPECT_TRUE((line.curve == nullptr) != (line.gradient == nullptr));
    if (line.curve) line.curve->push_back({0.5, 2});
    if (line.gradient) line.gradient->push_back({0.5, 7});
    EXPECT_FALSE(have_same_lines(changed, def)) << line.title;
  }
  EXPECT_TRUE(have_same_lines(def, def));
}

TEST(EmitterEdit, a_change_is_flown_to_the_moment_at_hand_and_saved_as_toml) {
  Client client = client_of("emit_fountain");
  ASSERT_TRUE(run(client, "wait 60"));
  const std::uint64_t step = client.session.step();
  std::vector<ScenarioEmitter> emitters = client.session.scenario().emitters;
  emitters[0].def.life.colour.gradient = {{0, 0xff8000ff}, {1, 0x20202000}};
  emitters[0].def.life.size.curve = {{0, 1}, {1, 0.25}};
  ASSERT_TRUE(client.set_emitters(emitters));
  EXPECT_EQ(client.session.step(), step);
  EXPECT_TRUE(client.has_unsaved_settings());
  const World& world = client.session.world();
  EXPECT_EQ(world.emitter(world.emitters()[0])->life.size.curve, emitters[0].def.life.size.curve);

  const testing_cli::Folder folder;
  const std::string file = folder / "physim_emitter_edit.toml";
  ASSERT_TRUE(client.save(file));
  const Scenario read = must(load_scenario(file));
  EXPECT_TRUE(have_same_lines(read.emitters[0].def, emitters[0].def));
}

TEST(EmitterEdit, what_makes_no_sense_changes_nothing) {
  Client client = client_of("emit_fountain");
  ASSERT_TRUE(run(client, "wait 20"));
  const std::uint64_t hash = client.session.world().hash();
  std::vector<ScenarioEmitter> emitters = client.session.scenario().emitters;
  emitters[0].def.start.lifetime.curve = {{0, 1}, {1, 0}};
  EXPECT_FALSE(client.set_emitters(emitters));
  EXPECT_EQ(client.session.world().hash(), hash);
  EXPECT_FALSE(client.has_unsaved_settings());
}

TEST(EmitterShown, particles_have_their_own_colours_and_sizes) {
  Client client = client_of("emit_spiral");
  ASSERT_TRUE(run(client, "wait 90"));
  Scene scene;
  build_scene(client, 1, scene);
  const World& world = client.session.world();
  std::size_t count = 0;
  for (const EmitterId id : world.emitters()) count += world.particles(id, {});
  ASSERT_GT(count, 100u);
  EXPECT_EQ(scene.sprites.size(), count);
  EXPECT_TRUE(scene.crowd.empty()) << "none is drawn twice";
  double before = kInfinity;
  for (const SceneSprite& sprite : scene.sprites) {
    EXPECT_FLOAT_EQ(sprite.width, 0.08F);
    EXPECT_TRUE(sprite.colour == 0xd55e00ff || sprite.colour == 0x0072b2ff || sprite.colour == 0x009e73ff);
    const double away = length(client.camera.shown(sprite.at) - client.camera.eye());
    EXPECT_LE(away, before + 1e-9) << "far ones first";
    before = away;
  }
}

TEST(EmitterShown, rounds_are_streaks_and_trails_are_lines) {
  Client gun = client_of("emit_machine_gun");
  ASSERT_TRUE(run(gun, "wait 10"));
  Scene scene;
  build_scene(gun, 1, scene);
  const auto is_streak = [](const SceneLine& line) { return line.fog == 0 && std::abs(line.b.x - line.a.x) > 5; };
  EXPECT_GT(std::ranges::count_if(scene.lines, is_streak), 0);

  Client spiral = client_of("emit_spiral");
  std::vector<ScenarioEmitter> emitters = spiral.session.scenario().emitters;
  build_scene(spiral, 1, scene);
  const std::size_t without = scene.lines.size();
  for (ScenarioEmitter& emitter : emitters) emitter.def.trail = {.points = 10};
  ASSERT_TRUE(spiral.set_emitters(emitters));
  ASSERT_TRUE(run(spiral, "wait 60"));
  build_scene(spiral, 1, scene);
  EXPECT_GT(scene.lines.size(), without + 5 * scene.sprites.size());
  spiral.show.trails = false;
  build_scene(spiral, 1, scene);
  EXPECT_LT(scene.lines.size(), without + scene.sprites.size());
}

}  // namespace
}  // namespace physim::client
