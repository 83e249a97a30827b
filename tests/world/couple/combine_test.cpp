// How restitution and friction of two that touch are combined: on things, on the ground, between projectiles and in
// flights.
#include "scene_support.hpp"
#include "world/pairs_support.hpp"

namespace physim::world_combine_test {

using namespace test_scene;

constexpr Combine kRules[] = {Combine::product, Combine::mean, Combine::minimum, Combine::maximum};
constexpr double kOwn = 0.75, kOther = 0.5;

/// Of kOwn and kOther, by the later of two rules.
double by_rule(Combine a, Combine b) {
  switch (std::max(a, b)) {
    case Combine::product: return kOwn * kOther;
    case Combine::mean: return (kOwn + kOther) / 2;
    case Combine::minimum: return std::min(kOwn, kOther);
    case Combine::maximum: return std::max(kOwn, kOther);
  }
  return 0;
}
std::string name_of(Combine a, Combine b) { return std::string(name(a)) + " and " + std::string(name(b)); }

BodyDef bouncy(Combine rule, double radius = 0) {
  return {.can_sleep = false,
          .restitution = kOwn,
          .friction = 0,
          .combine = {.restitution = rule},
          .collision = {.on_hit = OnHit::bounce, .radius = radius}};
}
Scene slab(const Material& material) {
  Scene scene;
  put(scene, BoxShape{{100, 0.5, 100}}, {0, -0.5, 0}, *scene.add_material(material));
  return scene;
}
WorldDef space(GroundMode mode = GroundMode::none) { return {.environment = vacuum_of(kG), .ground = {.mode = mode}}; }
/// The speed behind the first bounce over that before it, of what comes down with 10 m/s from its start.
double kept(const std::vector<Event>& events) {
  const auto bounces = of_kind(events, EventKind::bounced);
  EXPECT_FALSE(bounces.empty());
  return bounces.empty() ? 0 : bounces.front().velocity.y / std::sqrt(100 + 2 * kG * 0.05);
}

TEST(Combine, a_bounce_off_a_thing_or_the_ground_keeps_what_the_later_rule_says) {
  for (const Combine own : kRules)
    for (const Combine other : kRules) {
      for (const double radius : {0.0, 0.1}) {
        World world = make_world(space(), slab({.restitution = kOther, .combine = {.restitution = other}}));
        ASSERT_TRUE(world.spawn(puck(), {.position = {0, radius + 0.05, 0}, .velocity = Vec3d{0, -10, 0}},
                                bouncy(own, radius)));
        EXPECT_NEAR(kept(run_for(world, 0.1)), by_rule(own, other), 1e-9) << name_of(own, other);
      }
      WorldDef def = space(GroundMode::bounce);
      def.ground.restitution = kOther;
      def.ground.combine.restitution = other;
      World world = make_world(def);
      ASSERT_TRUE(world.spawn(puck(), {.position = {0, 0.05, 0}, .velocity = Vec3d{0, -10, 0}}, bouncy(own)));
      EXPECT_NEAR(kept(run_for(world, 0.1)), by_rule(own, other), 1e-9) << name_of(own, other);
    }
}

/// Many of one rung strike the ground together, in packs.
TEST(Combine, packs_bounce_as_one_does) {
  for (const Combine own : kRules) {
    WorldDef def = space(GroundMode::bounce);
    def.ground.restitution = kOther;
    def.ground.combine.restitution = Combine::mean;
    World world = make_world(def);
    for (int i = 0; i < 40; ++i)
      ASSERT_TRUE(world.spawn(stone(), {.position = {double(i), 0.05, 0}, .velocity = Vec3d{0, -10, 0}}, bouncy(own)));
    const auto bounces = of_kind(run_for(world, 0.05), EventKind::bounced);
    ASSERT_EQ(bounces.size(), 40u);
    for (const Event& e : bounces)
      EXPECT_NEAR(e.velocity.y / 10, by_rule(own, Combine::mean), 0.02 * by_rule(own, Combine::mean)) << name(own);
  }
}

/// Two of one mass that meet head on part with e times their speeds.
TEST(Combine, two_projectiles_part_by_the_later_of_their_rules) {
  for (const Combine own : kRules)
    for (const Combine other : kRules) {
      World world = make_world(test_pairs::space());
      BodyDef a = test_pairs::ball(0.5, kOwn), b = test_pairs::ball(0.5, kOther);
      a.combine.restitution = own, b.combine.restitution = other;
      const ProjectileId left = test_pairs::put(world, test_pairs::mass_of(1), a, {-1, 0, 0}, {5, 0, 0});
      const ProjectileId right = test_pairs::put(world, test_pairs::mass_of(1), b, {1, 0, 0}, {-5, 0, 0});
      run_for(world, 0.5);
      EXPECT_NEAR(world[left].velocity().x, -5 * by_rule(own, other), 1e-9) << name_of(own, other);
      EXPECT_NEAR(world[right].velocity().x, 5 * by_rule(own, other), 1e-9) << name_of(own, other);
    }
}

/// What slides with 5 m/s comes to rest after v^2 / (2 mu g).
TEST(Combine, friction_is_combined_by_its_own_rule) {
  for (const Combine own : kRules)
    for (const Combine other : kRules) {
      World world = make_world(space(), slab({.restitution = 0, .friction = kOther, .combine = {.friction = other}}));
      BodyDef body = bouncy(Combine::maximum);
      body.restitution = 0;
      body.friction = kOwn;
      body.rolling_resistance = 0;
      body.combine.friction = own;
      const ProjectileId id = *world.spawn(puck(), {.velocity = Vec3d{5, 0, 0}}, body);
      run_for(world, 3);
      EXPECT_NEAR(world[id].position().x, 25 / (2 * by_rule(own, other) * kG), 1e-6) << name_of(own, other);
    }
}

TEST(Combine, flights_and_predictions_have_the_same_rules) {
  for (const Combine own : kRules) {
    const Scene scene = slab({.restitution = kOther, .combine = {.restitution = Combine::mean}});
    Until until = meeting(scene, OnHit::bounce);
    until.time = 0.1;
    until.contact.restitution = kOwn;
    until.contact.friction = 0;
    until.contact.combine.restitution = own;
    const Launch down{.position = {0, 0.05, 0}, .velocity = Vec3d{0, -10, 0}};
    const Flight flight = fly(puck(), down, vacuum_of(kG), puck().fidelity, {}, until);
    const auto events = flight.events();
    EXPECT_NEAR(kept({events.begin(), events.end()}), by_rule(own, Combine::mean), 1e-9) << name(own);
    World world = make_world(space(), scene);
    const ProjectileId id = *world.spawn(puck(), down, bouncy(own));
    Until ahead = meeting(scene, OnHit::bounce);
    ahead.scene = nullptr;
    ahead.time = 0.125;
    const Flight predicted = world.predict(id, ahead, 1.0 / 64);
    run_for(world, 0.125);
    EXPECT_EQ(predicted.end().position, world[id].position()) << name(own);
  }
}

TEST(Combine, what_is_no_rule_is_refused_with_its_place) {
  const auto none = static_cast<Combine>(7);
  Scene scene;
  EXPECT_EQ(scene.add_material({.combine = {.restitution = none}}).error().place, "material.combine.restitution");
  EXPECT_EQ(scene.add_material({.combine = {.friction = none}}).error().place, "material.combine.friction");
  WorldDef def{.ground = {.combine = {.friction = none}}};
  EXPECT_EQ(World::create(def).error().place, "ground.combine.friction");
  World world;
  EXPECT_EQ(world.spawn(stone(), {}, bouncy(none)).error().place, "body.combine.restitution");
  Until until = meeting(scene, OnHit::bounce);
  until.contact.combine.friction = none;
  const Flight flight = fly(puck(), {.speed = 1}, {}, {}, {}, until);
  EXPECT_EQ(flight.outcome(), Outcome::refused);
}

/// Kinds that differ in a rule alone are two; saves, hashes and recordings hold it.
TEST(Combine, rules_are_kept_by_saves_and_recordings) {
  const auto played = [](Combine rule, std::vector<std::byte>& recording) {
    World world = make_world(space(GroundMode::bounce));
    EXPECT_TRUE(world.record(record_into(recording)));
    EXPECT_TRUE(world.set_scene(slab({.restitution = kOther, .combine = {.restitution = rule}})));
    EXPECT_TRUE(world.spawn(puck(), {.position = {0, 1, 0}}, bouncy(Combine::product)));
    EXPECT_TRUE(world.spawn(puck(), {.position = {2, 1, 0}}, bouncy(rule)));
    run_for(world, 1);
    EXPECT_TRUE(world.stop_recording());
    return world;
  };
  std::vector<std::byte> one, other;
  const World product = played(Combine::product, one);
  World maximum = played(Combine::maximum, other);
  EXPECT_NE(product.hash(), maximum.hash());
  const auto report = must(replay(other));
  EXPECT_FALSE(report.difference) << report.difference->what;
  World loaded = reloaded(maximum);
  run_for(loaded, 1), run_for(maximum, 1);
  EXPECT_EQ(loaded.hash(), maximum.hash());
}

}  // namespace physim::world_combine_test
