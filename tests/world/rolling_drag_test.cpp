// Drag on what slides or rolls: it slows, and never turns a motion around, however strong it is and however long steps
// are. The air lets a slide without friction follow a closed form.
#include <gtest/gtest.h>

#include "math/vec3.hpp"
#include "physim/names.hpp"
#include "physim/world.hpp"
#include "support.hpp"

namespace physim {
namespace world_rolling_drag_test {

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

/// Of a mass of 2 kg, that lies on something plane at y = 0.
World world_of(const Slide& slide, double k1, double k2, double friction, const Vec3d& velocity, ProjectileId& id) {
  World world =
      std::move(World::create({.ground = {.mode = GroundMode::bounce, .height = slide.on_thing ? -5.0 : 0}}).value());
  if (slide.on_thing) {
    Scene scene;
    const ShapeId box = scene.add_shape(BoxShape{{500, 1, 500}}).value();
    EXPECT_TRUE(scene.add({.shape = box, .transform = {.position = {0, -1, 0}}}));
    EXPECT_TRUE(world.set_scene(scene));
  }
  ProjectileDef p;
  p.mass = 2;
  p.drag.k1 = k1 * p.mass, p.drag.k2 = k2 * p.mass;
  p.fidelity = Fidelity::game();
  p.fidelity.integrator = slide.integrator;
  p.fidelity.precision = slide.precision;
  BodyDef body;
  body.collision.on_hit = OnHit::bounce;
  body.collision.radius = slide.on_thing ? slide.radius : 0;
  body.friction = friction;
  body.restitution = 0;
  body.rolling_resistance = 0;
  body.can_sleep = false;
  const Launch launch{.position = {0, slide.on_thing ? slide.radius : 0, 0}, .velocity = velocity};
  id = world.spawn(world.add_kind(p, body).value(), launch).value();
  return world;
}

TEST(RollingDrag, strong_drag_slows_what_lies_and_never_turns_it_around) {
  for (const Slide& slide : slides())
    for (const double friction : {0.0, 0.4}) {
      ProjectileId id;
      World world = world_of(slide, 98, 18, friction, {40, 0, -20}, id);
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
    ProjectileId id;
    const double k = 0.02, v0 = 50;
    World world = world_of(slide, 0, k, 0, {v0, 0, 0}, id);
    for (int i = 1; i <= 100; ++i) {
      ASSERT_TRUE(world.step(0.02));
      const double expected = v0 / (1 + k * v0 * 0.02 * i);
      const bool is_first_order =
          slide.integrator == Integrator::explicit_euler || slide.integrator == Integrator::semi_implicit_euler;
      const double exact = is_first_order && slide.on_thing ? 1e-6 : 1e-9;  // it flies a moment to the box
      const double bound = slide.precision == Precision::float64 ? exact : 2e-4;
      ASSERT_NEAR(world[id].velocity().x, expected, bound * v0) << slide.what() << ", step " << i;
    }
  }
}

}  // namespace world_rolling_drag_test
}  // namespace physim
