// Drag on what slides or rolls: it slows, and never turns a motion around, however strong it is and however long steps
// are. The air lets a slide without friction follow a closed form.
#include "math/vec3.hpp"
#include "support.hpp"

namespace physim::world_rolling_drag_test {

struct Slide {
  Integrator integrator;
  double radius;
  bool on_thing;
  Precision precision = Precision::float64;

  [[nodiscard]] std::string what() const {
    return std::string(name(integrator)) + (on_thing ? " on a box" : " on the ground") +
           (radius > 0 ? ", a ball, " : ", a point, ") + std::string(name(precision));
  }
};

std::vector<Slide> slides() {
  std::vector<Slide> all;
  for (const Integrator integrator : {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun,
                                      Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853})
    for (const double radius : {0.0, 0.1})
      for (const bool on_thing : {false, true})
        for (const Precision precision : {Precision::float64, Precision::float32})
          all.push_back({integrator, radius, on_thing, precision});
  return all;
}

struct Laid {
  World world;
  ProjectileId id{};
  InstanceId thing{};  // none: it lies on the ground
};

/// A mass of 2 kg on something plane at y = 0.
Laid laid(const Slide& slide, double k1, double k2, double friction, const Vec3d& velocity) {
  Laid made{
      std::move(World::create({.ground = {.mode = GroundMode::bounce, .height = slide.on_thing ? -5.0 : 0}}).value())};
  World& world = made.world;
  if (slide.on_thing) {
    Scene scene;
    const ShapeId box = scene.add_shape(BoxShape{{500, 1, 500}}).value();
    const MaterialId rough = scene.add_material({.friction = 1}).value();
    made.thing = scene.add({.shape = box, .transform = {.position = {0, -1, 0}}, .material = rough}).value();
    EXPECT_TRUE(world.set_scene(scene));
  }
  ProjectileDef p{.mass = 2};
  p.drag.k1 = k1 * p.mass, p.drag.k2 = k2 * p.mass;
  p.fidelity = Fidelity::game();
  p.fidelity.integrator = slide.integrator;
  p.fidelity.precision = slide.precision;
  BodyDef body{.can_sleep = false,
               .restitution = 0,
               .friction = friction,
               .rolling_resistance = 0,
               .collision = {.on_hit = OnHit::bounce, .radius = slide.on_thing ? slide.radius : 0}};
  const Launch launch{.position = {0, slide.on_thing ? slide.radius : 0, 0}, .velocity = velocity};
  made.id = world.spawn(world.add_kind(p, body).value(), launch).value();
  return made;
}

TEST(RollingDrag, strong_drag_slows_what_lies_and_never_turns_it_around) {
  for (const Slide& slide : slides())
    for (const double friction : {0.0, 0.05, 0.126, 0.4, 0.6}) {  // a ball begins to roll within a step, or before it
      auto [world, id, thing] = laid(slide, 98, 18, friction, {40, 0, -20});
      double before = length(world[id].velocity());
      for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(world.step(0.03));
        const Vec3d v = world[id].velocity();
        const Vec3d along{v.x, 0, v.z};
        ASSERT_LE(length(along), before * (1 + 1e-6) + 1e-9) << slide.what() << ", step " << i;
        ASSERT_GE(dot(along, Vec3d{40, 0, -20}), -1e-6) << slide.what() << ", step " << i;
        before = length(along);
      }
      EXPECT_LT(before, 1) << slide.what();
      EXPECT_LT(length(world[id].position()), 10) << slide.what();
    }
}

// dv/dt = -k v^2: v = v0 / (1 + k v0 t).
TEST(RollingDrag, a_slide_through_air_alone_follows_its_closed_form) {
  for (const Slide& slide : slides()) {
    const double k = 0.02, v0 = 50;
    auto [world, id, thing] = laid(slide, 0, k, 0, {v0, 0, 0});
    for (int i = 1; i <= 100; ++i) {
      ASSERT_TRUE(world.step(0.02));
      const double expected = v0 / (1 + k * v0 * 0.02 * i);
      // Explicit Euler's point does not sink in its first step: it flies that, and comes to the box at its end.
      const bool flies = slide.integrator == Integrator::explicit_euler && slide.on_thing && slide.radius == 0;
      const double exact = flies ? 1e-6 : 1e-9;
      const double bound = slide.precision == Precision::float64 ? exact : 2e-4;
      ASSERT_NEAR(world[id].velocity().x, expected, bound * v0) << slide.what() << ", step " << i;
    }
  }
}

// Without friction what lies on a train that speeds up backwards keeps its own velocity, but for the air: dv/dt = -k1
// v, of which a step of length h leaves 1 / (1 + k1 h).
TEST(RollingDrag, a_train_without_friction_speeds_up_below_what_lies_on_it) {
  for (const Slide& slide : slides()) {
    if (!slide.on_thing || slide.precision == Precision::float32) continue;
    if (slide.integrator == Integrator::explicit_euler && slide.radius == 0) continue;  // it flies its first step
    const double k1 = 3, h = 0.02;
    auto [world, id, train] = laid(slide, k1, 0, 0, {8, 0, 0});
    KeyedMotion motion{.keys = {}, .curve = MotionCurve::smooth};
    for (const double t : {0.0, 10.0})  // x = -t^2: a cubic with these ends is a parabola
      motion.keys.push_back({t, {-t * t, -1, 0}, {}, Vec3d{-2 * t, 0, 0}});
    ASSERT_TRUE(world.set_instance_motion(train, motion));
    double expected = 8;
    for (int i = 1; i <= 100; ++i) {
      ASSERT_TRUE(world.step(h));
      expected /= 1 + k1 * h;
      ASSERT_NEAR(world[id].velocity().x, expected, 1e-6) << slide.what() << ", step " << i;
    }
  }
}

// The same by fly(), whose contacts are those of worlds.
TEST(RollingDrag, a_flight_slides_through_air_as_its_closed_form) {
  for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5})
    for (const double radius : {0.0, 0.1}) {
      Scene scene;
      const ShapeId box = scene.add_shape(BoxShape{{500, 1, 500}}).value();
      ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = {0, -1, 0}}}));
      ProjectileDef p{.mass = 2};
      const double k = 0.02, v0 = 50;
      p.drag.k2 = k * p.mass;
      Fidelity fidelity = Fidelity::game();
      fidelity.integrator = integrator;
      fidelity.precision = Precision::float64;
      Until until{.ground = {},
                  .time = 2,
                  .scene = &scene,
                  .contact = {.collision = {.on_hit = OnHit::bounce, .radius = radius}}};
      until.contact.friction = until.contact.restitution = until.contact.rolling_resistance = 0;
      const Launch launch{.position = {0, radius, 0}, .velocity = Vec3d{v0, 0, 0}};
      const Flight flight = fly(p, launch, {}, fidelity, {.step = 0.02}, until);
      ASSERT_FALSE(flight.error()) << flight.error()->text();
      EXPECT_NEAR(flight.end().velocity.x, v0 / (1 + k * v0 * 2), 1e-6);
      EXPECT_NEAR(flight.end().position.y, radius, 1e-6);
    }
}

}  // namespace physim::world_rolling_drag_test
