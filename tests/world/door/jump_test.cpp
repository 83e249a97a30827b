// Changes of one that flies: what is drawn goes on behind a jump, and the place of its launch stays where it was.
#include <functional>

#include "world/world_support.hpp"

namespace physim::world_jump_test {

struct Rung {
  const char* name;
  Fidelity fidelity;
};

/// Closed forms, steps and columns of both precisions.
std::vector<Rung> rungs() {
  std::vector<Rung> list{{"arcade", Fidelity::arcade()},
                         {"game", Fidelity::game()},
                         {"classic", Fidelity::classic()},
                         {"simulation", Fidelity::simulation()}};
  Fidelity exact = Fidelity::arcade();
  exact.precision = Precision::float64;
  list.push_back({"arcade in double", exact});
  return list;
}

/// Nothing acts: all fly straight on every rung.
WorldDef empty_space() {
  return {.environment = {.gravity = {.model = GravityModel::off}, .atmosphere = {.model = AirModel::vacuum}},
          .ground = {.mode = GroundMode::none},
          .step = 1.0 / 64};
}

ProjectileDef thing(const Fidelity& fidelity) { return {.mass = 1, .fidelity = fidelity}; }

TEST(Jump, what_is_drawn_goes_on_behind_it) {
  for (const Rung& rung : rungs())
    for (const Smoothing smoothing : {Smoothing::none, Smoothing::interpolate, Smoothing::extrapolate}) {
      SCOPED_TRACE(std::string(rung.name) + ", smoothing " + std::to_string(static_cast<int>(smoothing)));
      World world = make_world(empty_space()), still = make_world(empty_space());
      const Vec3d v{16, -8, 4}, jump{-100, 60, 0};
      const BodyDef body{.smoothing = smoothing};
      const ProjectileId id = *world.spawn(thing(rung.fidelity), {.velocity = v}, body);
      const ProjectileId same = *still.spawn(thing(rung.fidelity), {.velocity = v}, body);
      for (int frame = 0; frame < 12; ++frame) {  // 2.5 frames a step
        world.advance(0.4 / 64), still.advance(0.4 / 64);
        if (frame == 5) {
          ASSERT_TRUE(world[id].set_position(world[id].position() + jump));
        }
        const Vec3d expected = still[same].render_position() + (frame < 5 ? Vec3d{} : jump);
        EXPECT_LT(length(world[id].render_position() - expected), 2e-5) << "frame " << frame;
      }
    }
}

TEST(Jump, a_change_of_velocity_moves_nothing_that_is_drawn) {
  for (const Rung& rung : rungs()) {
    SCOPED_TRACE(rung.name);
    World world = make_world(empty_space());
    const ProjectileId id = *world.spawn(thing(rung.fidelity), {.velocity = Vec3d{16, 0, 0}});
    world.advance(2.25 / 64);
    const Vec3d before = world[id].render_position();
    EXPECT_NEAR(before.x, 16 * 1.25 / 64, 1e-6);
    EXPECT_TRUE(world[id].set_velocity({0, 16, 0}));
    EXPECT_EQ(world[id].render_position(), before);
    EXPECT_TRUE(world[id].apply_impulse({3, 0, 0}));
    EXPECT_EQ(world[id].render_position(), before);
  }
}

TEST(Jump, a_way_that_no_number_holds_is_cut) {
  Fidelity exact = Fidelity::arcade();
  exact.precision = Precision::float64;
  struct Case {
    Fidelity fidelity;
    double speed, to;  // to + speed / 64 is beyond the numbers of the row
  };
  for (const Case& c : {Case{Fidelity::arcade(), 1e38, 3.4e38}, Case{exact, 1.7e308, 1.797e308}}) {
    World world = make_world(empty_space());
    const auto id = world.spawn(thing(c.fidelity), {.velocity = Vec3d{-c.speed, 0, 0}});
    ASSERT_TRUE(id.ok()) << id.error().text();
    world.advance(1.5 / 64);
    ASSERT_TRUE(world[*id].set_position({c.to, 0, 0}));
    EXPECT_TRUE(std::isfinite(world[*id].previous_position().x));
    EXPECT_TRUE(std::isfinite(world[*id].render_position().x));
  }
}

// Rules count from the launch, whatever was changed since.
TEST(Jump, farther_counts_from_the_launch) {
  const std::vector<std::pair<const char*, std::function<void(Projectile)>>> changes{
      {"velocity", [](Projectile p) { p.set_velocity(p.velocity()); }},
      {"position",
       [](Projectile p) {
         p.set_position(p.position() + Vec3d{0.25, 0, 0});
       }},
      {"impulse",
       [](Projectile p) {
         p.apply_impulse({0, 0, 1e-3});
       }},
      {"gravity scale", [](Projectile p) { p.set_gravity_scale(p.body().gravity_scale / 2); }},
      {"frozen axes",
       [](Projectile p) { p.set_frozen(p.body().frozen == Axes::y ? Axes::none : Axes::y, Axes::none); }},
      {"sleep", [](Projectile p) {
         const Vec3d v = p.velocity();
         p.sleep(), p.wake(), p.set_velocity(v);
       }}};
  for (const Rung& rung : rungs())
    for (const auto& [name, change] : changes) {
      SCOPED_TRACE(std::string(rung.name) + ": " + name);
      World world = make_world(empty_space());
      const ProjectileId id = *world.spawn(thing(rung.fidelity), {.position = {7, 0, 0}, .velocity = Vec3d{16, 0, 0}},
                                           {.despawn = {.farther = 20}});
      double left_at = 0;
      for (int step = 0; step < 256; ++step) {
        world.single_step();
        for (const Event& event : world.events())
          if (event.kind == EventKind::expired) left_at = event.position.x;
        if (world[id].is_alive() && step % 32 == 31) change(world[id]);
      }
      EXPECT_FALSE(world[id].is_alive());
      EXPECT_NEAR(left_at, 27, 0.26);  // one step is 0.25 m
    }
}

}  // namespace physim::world_jump_test
