// Live settings: a body as it is now, and as it becomes by one call.
#include "world/core/live.hpp"

#include <map>

#include "scenario/scenario.hpp"
#include "world/world_support.hpp"

namespace physim::world_live_test {

const Launch kHigh{.position = {0, 100, 0}, .velocity = Vec3d{10, 0, 5}};

/// Other values than those of BodyDef{} for all that is live.
BodyDef all_live() {
  return {.gravity_scale = 0.25,
          .frozen = Axes::z,
          .frozen_rotation = Axes::y,
          .can_sleep = false,
          .smoothing = Smoothing::extrapolate,
          .layers = 6,
          .colour = 0x12345678,
          .label = "changed"};
}

TEST(Live, a_body_is_that_of_its_kind_until_it_is_changed) {
  World world;
  BodyDef kind = all_live();
  kind.restitution = 0.7;
  const ProjectileId id = *world.spawn(stone(), kHigh, kind);
  EXPECT_EQ(world[id].body(), kind);
  EXPECT_TRUE(world[id].set_gravity_scale(0));
  EXPECT_FALSE(world[id].body().use_gravity);
  EXPECT_EQ(world[id].body().gravity_scale, 0.25);
  EXPECT_TRUE(world[id].set_use_gravity(true));
  EXPECT_EQ(world[id].body(), kind);
  EXPECT_EQ(world[ProjectileId{}].body(), BodyDef{});
}

TEST(Live, set_body_does_what_the_single_calls_do) {
  World by_one_call, by_many, as_spawned;
  const BodyDef to = all_live();
  const ProjectileId a = *by_one_call.spawn(stone(), kHigh);
  const ProjectileId b = *by_many.spawn(stone(), kHigh);
  const ProjectileId c = *as_spawned.spawn(stone(), kHigh, to);
  EXPECT_TRUE(by_one_call[a].set_body(to));
  EXPECT_EQ(by_one_call[a].body(), to);
  by_many[b].set_gravity_scale(to.gravity_scale);
  by_many[b].set_frozen(to.frozen, to.frozen_rotation);
  by_many[b].set_can_sleep(to.can_sleep);
  by_many[b].set_smoothing(to.smoothing);
  by_many[b].set_layers(to.layers);
  by_many[b].set_colour(to.colour);
  by_many[b].set_label(to.label);
  EXPECT_EQ(by_one_call.hash(), by_many.hash());
  for (World* world : {&by_one_call, &by_many, &as_spawned}) run_for(*world, 1);
  EXPECT_EQ(by_one_call.hash(), by_many.hash());
  EXPECT_EQ(by_one_call[a].position().y, as_spawned[c].position().y);
  EXPECT_NEAR(by_one_call[a].position().y, 100 - 0.25 * 9.80665 * (1 + 1.0 / 64) / 2, 1e-4) << "semi-implicit";
  EXPECT_EQ(by_one_call[a].position().z, 0) << "frozen";
  EXPECT_TRUE(by_one_call[a].set_body(BodyDef{})) << "and back again";
  EXPECT_EQ(by_one_call[a].body(), BodyDef{});
  BodyDef floating{.gravity_scale = 0};
  EXPECT_TRUE(by_one_call[a].set_body(floating));
  EXPECT_FALSE(by_one_call[a].body().use_gravity);
  BodyDef held{.kinematic = true};
  EXPECT_TRUE(by_one_call[a].set_body(held));
  EXPECT_TRUE(by_one_call[a].is_kinematic());
}

/// A gravity scale that is changed, and back at once, changes nothing: neither the place that it is removed by nor the
/// acceleration that the original's loop took over.
TEST(Live, a_change_keeps_where_it_was_launched_and_what_its_loop_took_over) {
  ProjectileDef shell{.fidelity = Fidelity::classic()};
  const BodyDef near{.despawn = {.farther = 20}};
  World world = make_world({.ground = {.mode = GroundMode::none}});
  World plain = make_world({.ground = {.mode = GroundMode::none}});
  const ProjectileId id = *world.spawn(shell, {.velocity = Vec3d{40, 0, 0}}, near);
  const ProjectileId same = *plain.spawn(shell, {.velocity = Vec3d{40, 0, 0}}, near);
  for (int frame = 0; plain[same].is_alive(); ++frame) {
    ASSERT_LT(frame, 200);
    if (frame == 10) {
      ASSERT_TRUE(world[id].set_gravity_scale(2));
      ASSERT_TRUE(world[id].set_gravity_scale(0.5));
      ASSERT_TRUE(world[id].set_gravity_scale(1));
    }
    EXPECT_EQ(world[id].position(), plain[same].position()) << frame;
    world.step(1.0 / 60), plain.step(1.0 / 60);
  }
  EXPECT_FALSE(world[id].is_alive());
}

TEST(Live, what_is_only_carried_along_wakes_nobody) {
  World world;
  const ProjectileId id = *world.spawn(stone(), kHigh);
  ASSERT_TRUE(world[id].sleep());
  BodyDef body = world[id].body();
  body.label = "found";
  body.colour = 7;
  ASSERT_TRUE(world[id].set_body(body));
  EXPECT_TRUE(world[id].is_asleep());
  EXPECT_EQ(world[id].label(), "found");
  body.gravity_scale = 2;
  ASSERT_TRUE(world[id].set_body(body));
  EXPECT_FALSE(world[id].is_asleep());
}

TEST(Live, the_list_of_settings_marks_what_set_body_takes) {
  const std::map<std::string, std::string> others = {{"gravity_scale", "0.5"},
                                                     {"use_gravity", "false"},
                                                     {"drag_scale", "2"},
                                                     {"angular_drag", "1 1/s"},
                                                     {"angular_velocity", "[1, 0, 0]"},
                                                     {"kinematic", "true"},
                                                     {"infinite_mass", "true"},
                                                     {"frozen", "x"},
                                                     {"frozen_rotation", "x"},
                                                     {"can_sleep", "false"},
                                                     {"sleep_speed", "1 m/s"},
                                                     {"sleep_time", "3 s"},
                                                     {"restitution", "0.3"},
                                                     {"friction", "0.3"},
                                                     {"rolling_resistance", "0.3"},
                                                     {"combine.restitution", "mean"},
                                                     {"combine.friction", "maximum"},
                                                     {"collision.on_hit", "bounce"},
                                                     {"collision.radius", "0.1 m"},
                                                     {"collision.inertia", "0.6"},
                                                     {"collision.layers", "6"},
                                                     {"collision.others", "6"},
                                                     {"despawn.below", "-9 m"},
                                                     {"despawn.farther", "9 m"},
                                                     {"despawn.older", "9 s"},
                                                     {"despawn.slower", "9 m/s"},
                                                     {"despawn.outside_box", "true"},
                                                     {"despawn.box_low", "[-9, 0, 0]"},
                                                     {"despawn.box_high", "[9, 0, 0]"},
                                                     {"smoothing", "none"},
                                                     {"within_time", "9 s"},
                                                     {"layers", "6"},
                                                     {"colour", "7"},
                                                     {"label", "other"}};
  const std::string shot =
      "physim = 1\n[[shot]]\nname = \"stone\"\n[shot.body]\n"
      "despawn = { box_low = [-1, -1, -1], box_high = [1, 1, 1] }\n[world]\nduration = \"1 s\"\n";
  for (const Setting& setting : settings()) {
    const std::string prefix = "shot.body.";
    if (!setting.path.starts_with(prefix) || setting.path == "shot.body.pool") continue;
    ASSERT_TRUE(others.contains(setting.path.substr(prefix.size()))) << setting.path << " has no other value here";
    const auto read = [&](const std::vector<std::string>& overrides) {
      const Result<Scenario> s = parse_scenario(shot, "f.toml", overrides);
      EXPECT_TRUE(s.ok()) << setting.path << (s.ok() ? "" : s.error().text());
      return s.ok() ? s->shots[0].body : BodyDef{};
    };
    World world;
    const ProjectileId id = *world.spawn(stone(), kHigh, read({}));
    const BodyDef changed = read({setting.path + "=" + others.at(setting.path.substr(prefix.size()))});
    EXPECT_NE(changed, world[id].body()) << setting.path;
    EXPECT_EQ(world[id].set_body(changed).ok(), setting.live) << setting.path;
  }
}

TEST(Live, what_is_not_live_or_makes_no_sense_is_refused_and_changes_nothing) {
  World world;
  const ProjectileId id = *world.spawn(stone(), kHigh);
  const std::uint64_t before = world.hash();
  const auto refused = [&](auto change) {
    BodyDef body = all_live();
    change(body);
    const Status status = world[id].set_body(body);
    EXPECT_FALSE(status);
    EXPECT_EQ(world.hash(), before);
    return status ? std::string() : status.error().text();
  };
  EXPECT_NE(refused([](BodyDef& b) { b.drag_scale = 2; }).find("not live"), std::string::npos);
  refused([](BodyDef& b) { b.infinite_mass = true; });
  refused([](BodyDef& b) { b.restitution = 0.1; });
  EXPECT_NE(refused([](BodyDef& b) { b.gravity_scale = NAN; }).find("gravity_scale"), std::string::npos);
  EXPECT_FALSE(world[ProjectileId{}].set_body({}));
}

TEST(Live, each_part_has_a_flag_of_its_own_and_is_off_for_a_plain_body) {
  std::uint32_t seen = 0;
  for (const OwnPart& part : kOwnParts) {
    EXPECT_EQ(part.flag & (part.flag - 1), 0u);
    EXPECT_EQ(seen & part.flag, 0u);
    EXPECT_FALSE(part.differs(own_of(BodyDef{})));
    seen |= part.flag;
  }
  EXPECT_EQ(seen, kOwn);
}

}  // namespace physim::world_live_test
