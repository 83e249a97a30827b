// Friction of what does not roll: points, and balls that may not turn, on grounds and on things, in worlds and flights.
#include "math/quat.hpp"
#include "scene_support.hpp"

namespace physim::world_friction_test {

using namespace test_scene;

constexpr double kRates[] = {24, 60, 1000};

BodyDef sliding(double friction, double radius = 0) {
  BodyDef body{.can_sleep = false,
               .restitution = 0,
               .friction = friction,
               .rolling_resistance = 0,
               .collision = {.on_hit = OnHit::bounce, .radius = radius}};
  if (radius > 0) body.frozen_rotation = Axes::x | Axes::y | Axes::z;
  return body;
}
/// A slab whose upper side is a slope through the origin.
Scene slope_of(double angle, double friction = 1, const Vec3d& velocity = {}) {
  Scene scene;
  const Quatd turn{std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
  InstanceDef slab{.shape = *scene.add_shape(BoxShape{{60, 0.5, 5}}),
                   .transform = {.position = rotate(turn, Vec3d{0, -0.5, 0}), .rotation = turn},
                   .material = *scene.add_material({.restitution = 0, .friction = friction})};
  if (velocity != Vec3d{}) slab.motion = SteadyMotion{.velocity = velocity};
  EXPECT_TRUE(scene.add(slab));
  return scene;
}

/// 5 m/s against friction 0.5 are 2.549 m: v^2 / (2 mu g).
TEST(Friction, a_point_slides_to_rest_on_the_ground) {
  const double right = 25 / (2 * 0.5 * kG);
  for (const double rate : kRates) {
    WorldDef def = space();
    def.ground = {.mode = GroundMode::bounce, .restitution = 1, .friction = 1};
    World world = make_world(def);
    const ProjectileId id = *world.spawn(puck(), {.velocity = Vec3d{3, 0, 4}}, sliding(0.5));
    run_for(world, 3, 1 / rate);
    EXPECT_NEAR(length(world[id].position()), right, 1e-9) << rate;
    EXPECT_EQ(length(world[id].velocity()), 0) << rate;
  }
}

TEST(Friction, points_and_balls_that_may_not_turn_slide_to_rest_on_things) {
  const double right = 25 / (2 * 0.5 * kG);
  for (const double radius : {0.0, 0.1})
    for (const double rate : kRates) {
      World world = make_world(space(), slope_of(0));
      const ProjectileId id =
          *world.spawn(puck(), {.position = {0, radius, 0}, .velocity = Vec3d{5, 0, 0}}, sliding(0.5, radius));
      run_for(world, 3, 1 / rate);
      EXPECT_NEAR(world[id].position().x, right, 1e-3) << radius << ' ' << rate;
      EXPECT_EQ(world[id].velocity().x, 0) << radius << ' ' << rate;
      EXPECT_EQ(length(world[id].angular_velocity()), 0);
    }
}

/// What holds more than the slope pulls stays; else it goes up for v / (g (sin + mu cos)), and comes back with
/// v sqrt((tan - mu) / (tan + mu)).
TEST(Friction, slopes_hold_what_friction_can_hold) {
  const double angle = 30 * test::kDegree, mu = 0.2;
  const Vec3d up{std::cos(angle), std::sin(angle), 0}, normal{-std::sin(angle), std::cos(angle), 0};
  const double rises = kG * (std::sin(angle) + mu * std::cos(angle)),
               falls = kG * (std::sin(angle) - mu * std::cos(angle));
  const double top = 25 / (2 * rises), time = 5 / rises + std::sqrt(2 * top / falls);
  for (const double radius : {0.0, 0.1}) {
    World world = make_world(space(), slope_of(angle));
    const ProjectileId held = *world.spawn(puck(), {.position = normal * radius}, sliding(1, radius));
    const ProjectileId slides =
        *world.spawn(puck(), {.position = normal * radius, .velocity = up * 5}, sliding(mu, radius));
    run_for(world, time, time / 100);
    EXPECT_LT(length(world[held].position() - normal * radius), 1e-8) << radius;
    EXPECT_NEAR(length(world[slides].velocity()), 5 * std::sqrt((std::tan(angle) - mu) / (std::tan(angle) + mu)), 1e-3);
    EXPECT_LT(length(world[slides].position() - normal * radius), 2e-3) << radius;
    EXPECT_EQ(length(world[slides].angular_velocity()), 0);
  }
}

/// A belt at u takes along what is laid on it: after u t - u^2 / (2 mu g).
TEST(Friction, a_belt_takes_points_along) {
  for (const double radius : {0.0, 0.1})
    for (const double rate : {24.0, 60.0, 240.0}) {
      World world = make_world(space(), slope_of(0, 1, {2, 0, 0}));
      const ProjectileId id = *world.spawn(puck(), {.position = {0, radius, 0}}, sliding(0.2, radius));
      run_for(world, 2, 1 / rate);
      EXPECT_NEAR(world[id].velocity().x, 2, 1e-3) << radius << ' ' << rate;
      EXPECT_NEAR(world[id].position().x, 2 * world.time() - 4 / (2 * 0.2 * kG), 2e-3) << radius << ' ' << rate;
    }
}

/// In a bounce friction takes the whole slip of what cannot turn, where a solid ball keeps 5/7; about one axis alone it
/// turns as a free one does in that plane.
TEST(Friction, a_bounce_takes_the_slip_of_what_cannot_turn) {
  struct Case {
    Axes frozen;
    Vec3d left;  // of (3, 4) along x and z
  };
  const Axes all = Axes::x | Axes::y | Axes::z;
  for (const auto& [frozen, left] :
       {Case{all, {0, 0, 0}}, Case{Axes::none, {15.0 / 7, 0, 20.0 / 7}}, Case{Axes::y, {15.0 / 7, 0, 20.0 / 7}}}) {
    World world = make_world(space(), slope_of(0, 10));
    BodyDef body = sliding(1, 0.1);
    body.frozen_rotation = frozen;
    const ProjectileId id = *world.spawn(puck(), {.position = {0, 0.2, 0}, .velocity = Vec3d{3, -5, 4}}, body);
    run_for(world, 0.1, 1.0 / 60);
    const Vec3d v = world[id].velocity();
    EXPECT_LT(length(Vec3d{v.x, 0, v.z} - left), 1e-9);
  }
}

/// The same in flights, and what a world says lies ahead is what it does.
TEST(Friction, flights_slide_as_worlds_do) {
  const Scene scene = slope_of(0);
  for (const double radius : {0.0}) {
    Until until = meeting(scene, OnHit::bounce, radius);
    until.time = 3;
    until.contact.restitution = 0;
    until.contact.friction = 0.5;
    until.contact.rolling_resistance = 0;
    const Flight flight = fly(puck(), {.position = {0, 1e-3 + radius, 0}, .velocity = Vec3d{5, 0, 0}}, vacuum_of(kG),
                              test_scene::rung(Integrator::rk4), {.step = 1.0 / 60}, until);
    // It loses 0.5 times the impulse of a fall of 1 mm at its first touch.
    const double fall = std::sqrt(2 * 1e-3 / kG), v = 5 - 0.5 * kG * fall;
    EXPECT_NEAR(flight.end().position.x, 5 * fall + v * v / kG, 1e-3);
  }
}

/// Two planes that rise by an angle to both sides of the x axis.
Scene groove(double angle, double friction) {
  Scene scene;
  const ShapeId half = *scene.add_shape(PlaneShape{});
  const MaterialId material = *scene.add_material({.restitution = 0, .friction = friction});
  for (const double side : {angle, -angle})
    EXPECT_TRUE(scene.add({.shape = half,
                           .transform = {.rotation = {std::cos(side / 2), std::sin(side / 2), 0, 0}},
                           .material = material}));
  return scene;
}

/// Both walls of a groove press with g / (2 cos b): a point stops after v^2 cos b / (2 mu g), however steep they are,
/// and without friction nothing stops it.
TEST(Friction, a_point_slides_in_a_groove) {
  for (const double angle : {0.3, 0.7, 1.0, 1.4})
    for (const double rate : kRates) {
      World world = make_world(space(), groove(angle, 1));
      const Launch launch{.position = {0, 1e-9, 0}, .velocity = Vec3d{2, 0, 0}};
      const ProjectileId id = *world.spawn(puck(), launch, sliding(0.2));
      run_for(world, 2, 1 / rate);
      EXPECT_NEAR(world[id].position().x, 4 * std::cos(angle) / (2 * 0.2 * kG), 1e-3) << angle << ' ' << rate;
      EXPECT_EQ(world[id].velocity().x, 0) << angle << ' ' << rate;
      World smooth = make_world(space(), groove(angle, 0));
      const ProjectileId free = *smooth.spawn(puck(), launch, sliding(1));
      run_for(smooth, 2, 1 / rate);
      EXPECT_NEAR(smooth[free].position().x, 4, 1e-6) << angle << ' ' << rate;
    }
}

/// A ball that rolls down a rough gutter of slope t is pulled by g sin t / (1 + 0.4 / cos^2 b).
TEST(Friction, a_ball_rolls_down_a_gutter) {
  const double angle = 0.7, slope = 0.2, radius = 0.05;
  for (const double rate : kRates) {
    WorldDef def = space();
    def.environment.gravity = {.model = GravityModel::constant};
    Scene scene = groove(angle, 1);
    World world = make_world(def, std::move(scene));
    BodyDef body = sliding(1, radius);
    body.frozen_rotation = Axes::none;
    const ProjectileId id =
        *world.spawn(puck(), {.position = {0, radius / std::cos(angle) + 1e-9, 0}, .speed = 0}, body);
    must(world.add_force(
        {.law = ConstantAcceleration{{kG * std::sin(slope), 0, 0}}, .target = ForceTarget::everything()}));
    run_for(world, 2, 1 / rate);
    const double c = std::cos(angle), right = 2 * kG * std::sin(slope) / (1 + 0.4 / (c * c));
    EXPECT_NEAR(world[id].velocity().x, right, 1e-3 * right) << rate;
    EXPECT_NEAR(world[id].angular_velocity().z, -right / (radius * c), 2e-3 * right / (radius * c)) << rate;
  }
}

/// A ball that comes to a smooth wall beside its way goes on along it as on the floor alone: it slides, then rolls with
/// 5/7 of its speed.
TEST(Friction, a_ball_that_only_grazes_a_wall_keeps_its_friction) {
  for (const double rate : kRates) {
    Scene scene;
    const MaterialId ice = *scene.add_material({.restitution = 0, .friction = 0});
    const MaterialId cloth = *scene.add_material({.restitution = 0, .friction = 0.3});
    EXPECT_TRUE(scene.add({.shape = *scene.add_shape(PlaneShape{}), .material = cloth}));
    EXPECT_TRUE(scene.add(
        {.shape = *scene.add_shape(BoxShape{{50, 1, 0.5}}), .transform = {.position = {0, 0, -0.5}}, .material = ice}));
    World world = make_world(space(), std::move(scene));
    BodyDef body = sliding(1, 0.05);
    body.frozen_rotation = Axes::none;
    const ProjectileId id = *world.spawn(puck(), {.position = {0, 0.05, 0.051}, .velocity = Vec3d{2, 0, -0.5}}, body);
    run_for(world, 3, 1 / rate);
    EXPECT_NEAR(world[id].velocity().x, 2 / 1.4, 1e-3) << rate;
    EXPECT_NEAR(world[id].position().x, 4.3412, 5e-3) << rate;  // slip and spin integrated in steps of 20 us
  }
}

/// What a force presses to a wall meets it once, whatever it lies on.
TEST(Friction, what_is_pressed_to_a_wall_has_one_hit) {
  for (const bool on_ground : {false, true}) {
    Scene scene;
    const MaterialId dull = *scene.add_material({.restitution = 0, .friction = 1});
    const ShapeId half = *scene.add_shape(PlaneShape{}), block = *scene.add_shape(BoxShape{{0.5, 1, 1}});
    EXPECT_TRUE(scene.add({.shape = block, .transform = {.position = {1.5, 0, 0}}, .material = dull}));
    EXPECT_TRUE(on_ground || scene.add({.shape = half, .material = dull}));
    WorldDef def = space();
    if (on_ground) def.ground = {.mode = GroundMode::bounce, .restitution = 0, .friction = 1};
    World world = make_world(def, std::move(scene));
    const ProjectileId id = *world.spawn(puck(), {.position = {0.8, 0, 0}}, sliding(0));
    must(world.add_force({.law = ConstantAcceleration{{3, 0, 0}}, .target = ForceTarget::everything()}));
    int hits = 0;
    for (int i = 0; i < 240; ++i) {
      world.step(1.0 / 60);
      for (const Event& event : world.events()) hits += event.kind == EventKind::hit && event.position.x > 0.99;
    }
    EXPECT_EQ(hits, 1) << on_ground;
    EXPECT_NEAR(world[id].position().x, 1, 1e-6) << on_ground;
  }
}

/// A wall of a groove that runs drives a point as fast as it runs, beside one that does not rub.
TEST(Friction, a_wall_that_runs_drives_what_lies_in_a_groove) {
  Scene scene;
  const ShapeId half = *scene.add_shape(PlaneShape{});
  for (const double side : {0.7, -0.7})
    EXPECT_TRUE(scene.add({.shape = half,
                           .transform = {.rotation = {std::cos(side / 2), std::sin(side / 2), 0, 0}},
                           .material = *scene.add_material({.restitution = 0, .friction = side > 0 ? 1.0 : 0.0}),
                           .conveyor = {.velocity = {side > 0 ? 1.0 : 0.0, 0, 0}}}));
  World world = make_world(space(), std::move(scene));
  const ProjectileId id = *world.spawn(puck(), {.position = {0, 1e-9, 0}}, sliding(0.5));
  run_for(world, 5, 1.0 / 60);
  EXPECT_NEAR(world[id].velocity().x, 1, 1e-6);
}

/// On a smooth ground along a smooth wall that leans over it nothing brakes.
TEST(Friction, the_ground_beside_a_wall_rubs_as_the_ground_does) {
  for (const double radius : {0.0, 0.05}) {
    Scene scene;
    const double lean = 2;  // of its normal, from the vertical [rad]
    EXPECT_TRUE(scene.add({.shape = *scene.add_shape(PlaneShape{}),
                           .transform = {.rotation = {std::cos(lean / 2), 0, 0, std::sin(lean / 2)}},
                           .material = *scene.add_material({.restitution = 0, .friction = 0})}));
    WorldDef def = space();
    def.ground = {.mode = GroundMode::bounce, .restitution = 0, .friction = 0};
    World world = make_world(def, std::move(scene));
    BodyDef body = sliding(0.5, radius);
    const ProjectileId id = *world.spawn(puck(), {.position = {-0.3, 0, 0}, .velocity = Vec3d{0, 0, 3}}, body);
    must(world.add_force({.law = ConstantAcceleration{{5, 0, 0}}, .target = ForceTarget::everything()}));
    run_for(world, 1, 1.0 / 60);
    EXPECT_NEAR(world[id].velocity().z, 3, 1e-6) << radius;
  }
}

}  // namespace physim::world_friction_test
