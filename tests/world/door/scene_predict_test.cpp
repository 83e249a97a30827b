// Predictions see the scene of their world: bit for bit what the world then does, with things that move too.
#include <map>

#include "random_shots.hpp"
#include "world/world_support.hpp"

namespace physim::world_scene_predict_test {

using test::Random;

constexpr double kStep = 1.0 / 60;

/// A floor, a slope, a wall that comes nearer, a turning paddle, a plank and a sensor.
Scene playground() {
  Scene scene;
  const MaterialId hard = *scene.add_material({.restitution = 0.9, .friction = 0.4});
  const MaterialId fir = *scene.add_material(materials::fir());
  const auto put = [&](const ShapeDef& shape, const Vec3d& place, MaterialId material, const SceneMotion& motion = {},
                       bool sensor = false) {
    add_thing(scene, shape,
              {.transform = {.position = place}, .material = material, .sensor = sensor, .motion = motion});
  };
  put(PlaneShape{}, {}, hard);
  put(SphereShape{3}, {12, -1, 0}, hard);
  put(BoxShape{{0.2, 5, 20}}, {30, 5, 0}, hard, SteadyMotion{.velocity = {-6, 0, 0}});
  put(BoxShape{{0.1, 2, 2}}, {8, 2, 0}, hard, SteadyMotion{.angular_velocity = {0, 3, 0}});
  put(BoxShape{{0.009, 2, 20}}, {20, 2, 0}, fir);
  put(BoxShape{{1, 2, 20}}, {5, 2, 0}, hard, {}, true);
  return scene;
}

TEST(ScenePredict, predictions_meet_things_as_the_world_then_does_to_the_bit) {
  Random r(17);
  int compared = 0, bounced = 0, ended = 0;
  for (const bool pushed : {false, true}) {
    World world = make_world({.ground = {.mode = GroundMode::none}}, playground());
    if (pushed) {
      ASSERT_TRUE(world.add_force({.law = ConstantForce{{0, 0.02, 0.01}}, .target = ForceTarget::everything()}));
    }
    for (int i = 0; i < 37; ++i) world.step(kStep);  // the scene's time is not that of predictions
    std::vector<ProjectileId> ids;
    for (int i = 0; i < 80; ++i) {
      ProjectileDef p = i % 2 ? bullet() : presets::tennis_ball().projectile;
      const Fidelity rungs[] = {Fidelity::game(), Fidelity::classic(), Fidelity::constant_air(),
                                Fidelity::small_arms()};
      p.fidelity = rungs[i % 4];
      if (i % 4 == 2) p.fidelity.rotation = RotationModel::magnus;
      if (i % 8 == 0 && !pushed) p.fidelity.motion = Motion::closed_form;
      p.fidelity.precision = r.one_in(2) ? Precision::float32 : Precision::float64;
      BodyDef body{.can_sleep = false};
      const OnHit acts[] = {OnHit::bounce, OnHit::impact, OnHit::bounce, OnHit::pass, OnHit::stick, OnHit::stop};
      body.collision = {.on_hit = acts[i % 6], .radius = i % 3 == 0 ? 0.05 : 0.0};
      Launch launch{.position = {r.in(-2, 2), r.in(1, 3), r.in(-3, 3)},
                    .speed = r.in(5, 60),
                    .elevation = r.in(-0.5, 0.8),
                    .azimuth = r.in(-0.4, 0.4)};
      if (i % 4 == 2) launch.spin = {.backspin = 100, .sidespin = 40};
      const auto id = must(world.spawn(p, launch, body));
      ids.push_back(id);
    }
    for (int part = 0; part < 4; ++part) {
      std::map<ProjectileId, Flight> flights;
      Until until{.ground = std::nullopt, .time = 40 * kStep};
      for (const ProjectileId id : ids)
        if (world[id].is_alive() && world[id].status() == LifeStatus::in_flight)
          flights.emplace(id, world.predict(id, until, kStep));
      std::map<ProjectileId, std::vector<Event>> events;
      const double begins = world.time();
      for (int i = 1; i <= 40; ++i) {
        world.step(kStep);
        for (const Event& e : world.events()) events[e.id].push_back(e);
        for (const auto& [id, flight] : flights) {
          ASSERT_FALSE(flight.error()) << flight.error()->text();
          const double time = i * kStep;
          if (flight.outcome() == Outcome::hit && flight.duration() < time) {
            EXPECT_EQ(world[id].status(), LifeStatus::landed);
            if (!world[id].is_alive()) continue;
            EXPECT_EQ(flight.end().position, world[id].position());
            ++ended;
            continue;
          }
          if (!world[id].is_alive()) continue;
          ASSERT_EQ(flight.at(time).position, world[id].position())
              << "step " << i << ", " << id.index << " part " << part << " pushed " << pushed;
          ASSERT_EQ(flight.at(time).velocity, world[id].velocity()) << "step " << i << ", " << id.index;
          ++compared;
        }
      }
      for (const auto& [id, flight] : flights)
        for (const Event& told : flight.events()) {
          if (!told.instance) continue;
          bounced += told.kind == EventKind::bounced;
          const auto same = std::ranges::any_of(events[id], [&](const Event& e) {
            return e.kind == told.kind && e.position == told.position && e.velocity == told.velocity &&
                   e.instance == told.instance && std::abs(e.time - begins - told.time) < 1e-9;
          });
          EXPECT_TRUE(same) << name(told.kind) << " " << told.time << " " << id.index;
        }
    }
  }
  EXPECT_GT(compared, 5000);
  EXPECT_GT(bounced, 100);
  EXPECT_GT(ended, 5);
}

TEST(ScenePredict, another_scene_is_refused) {
  World world = make_world({});
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 5, 0}});
  const Scene scene = playground();
  const Flight flight = world.predict(id, {.scene = &scene});
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.error()->place, "until.scene");
}

}  // namespace physim::world_scene_predict_test
