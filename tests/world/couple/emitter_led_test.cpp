// Emitters that a projectile leads: along its curve, through its bounces, and up to where it turns back.
#include "world/emitter_support.hpp"

namespace physim::world_emitter_led_test {

constexpr double kG = 9.80665;

/// Marks that stay where they are born.
EmitterDef marks(World& world) {
  return {.kind = kind_of(world, spark(), {.use_gravity = false}), .per_second = {0}, .start = {.speed = {0}}};
}

/// A stone in a vacuum that is thrown up from the ground and bounces off it, by its closed form.
struct Bouncing {
  double along, up, restitution;

  [[nodiscard]] Vec3d at(double time) const {
    double v = up, since = time;
    for (; since > 2 * v / kG; v *= restitution) since -= 2 * v / kG;
    return {along * time, v * since - kG / 2 * since * since, 0};
  }
};

World bouncing_world() { return make_world({.ground = {.mode = GroundMode::bounce, .friction = 0}}); }

ProjectileId thrown(World& world, const Bouncing& stone) {
  const KindId kind = kind_of(world, spark(), {.restitution = stone.restitution, .friction = 0});
  return *world.spawn(kind, {.velocity = Vec3d{stone.along, stone.up, 0}});
}

TEST(EmitterLed, births_are_where_the_bouncing_one_was) {
  const Bouncing stone_at{6, 5, 0.8};
  for (const int rate : {7, 24, 144, 1000}) {
    World world = bouncing_world();
    EmitterDef def = marks(world);
    def.follows = thrown(world, stone_at);
    def.per_second = {50};
    const EmitterId id = added(world, def);
    step_to(world, 3, rate);
    const auto all = alive(world, id);
    ASSERT_GE(all.size(), 149u);
    for (const auto& [number, state] : all) {
      const double time = static_cast<double>(number + 1) / 50;
      EXPECT_LT(length(state.position - stone_at.at(time)), 1e-9) << rate << " frames a second, " << time << " s";
    }
  }
}

/// A spark by the closed form of linear drag.
ProjectileDef damped_spark(Precision precision) {
  ProjectileDef p = spark();
  p.drag.damping = 0.7;
  p.fidelity.drag = DragModel::damping;
  p.fidelity.precision = precision;
  return p;
}

/// Births of an emitter that follows a spark thrown half a second after the world began.
std::vector<Event> births_behind(const ProjectileDef& led, int rate, bool saved) {
  World world = make_world({.ground = {.mode = GroundMode::bounce, .height = -500}});
  EmitterDef def = spray(kind_of(world, spark()), 300, 0.3);
  def.inherit_velocity = 0.25;
  step_to(world, 0.5, rate);
  def.follows = *world.spawn(kind_of(world, led), {.position = Vec3d{1, 2, 3}, .velocity = Vec3d{40, 30, -20}});
  const EmitterId id = added(world, def);
  std::vector<Event> events;
  step_to(world, 1, rate, &events);
  if (saved) {
    auto loaded = World::load(world.save().value());
    if (!loaded) ADD_FAILURE() << loaded.error().text();
    if (loaded) world = std::move(*loaded);
  }
  step_to(world, 3, rate, &events);
  std::erase_if(events, [&](const Event& e) { return e.value != id.index; });
  return told(events, EventKind::spawned, 2.999);
}

TEST(EmitterLed, births_behind_a_closed_form_are_equal_to_the_bit) {
  const std::vector<ProjectileDef> all = {spark(), damped_spark(Precision::float64), damped_spark(Precision::float32)};
  for (const ProjectileDef& led : all) {
    const std::vector<Event> first = births_behind(led, 64, false);
    ASSERT_GT(first.size(), 700u);
    // Half a second is a whole number of these steps, so that all of them throw it at the same moment.
    for (const int rate : {10, 24, 60, 144, 1000})
      for (const bool saved : {false, true}) {
        const std::vector<Event> born = births_behind(led, rate, saved);
        ASSERT_EQ(born.size(), first.size());
        for (std::size_t i = 0; i < born.size(); ++i) {
          ASSERT_EQ(born[i].time, first[i].time) << rate;
          ASSERT_EQ(born[i].position, first[i].position) << rate << " frames a second, " << born[i].time << " s";
          ASSERT_EQ(born[i].velocity, first[i].velocity) << rate << " frames a second, " << born[i].time << " s";
        }
      }
  }
}

TEST(EmitterLed, a_ball_that_bounces_as_high_as_before_is_followed_from_its_last_bounce) {
  // Each launch has the place and the velocity of the one before; only its time is another.
  const Bouncing ball{0, 5, 1};
  for (const int rate : {7, 24, 144}) {
    World world = bouncing_world();
    EmitterDef def = marks(world);
    def.follows = thrown(world, ball);
    def.per_second = {50};
    const EmitterId id = added(world, def);
    step_to(world, 5, rate);
    const auto all = alive(world, id);
    ASSERT_GE(all.size(), 249u);
    for (const auto& [number, state] : all)
      EXPECT_LT(length(state.position - ball.at(static_cast<double>(number + 1) / 50)), 1e-8) << rate << ", " << number;
  }
}

/// The length of a stone's way: the integral of sqrt(a^2 + u^2) over each parabola, u the speed upwards [m].
double way_of(const Bouncing& stone, double time) {
  const auto part = [&](double u) {
    const double a = stone.along;
    return (u * std::sqrt(a * a + u * u) + a * a * std::asinh(u / a)) / (2 * kG);
  };
  double sum = 0, up = stone.up, since = time;
  for (; since > 2 * up / kG; up *= stone.restitution) {
    sum += part(up) - part(-up);
    since -= 2 * up / kG;
  }
  return sum + part(up) - part(up - kG * since);
}

TEST(EmitterLed, metres_are_those_of_the_curve) {
  const Bouncing stone_at{6, 5, 0.8};
  for (const int rate : {7, 24, 144}) {
    World world = bouncing_world();
    EmitterDef def = marks(world);
    def.follows = thrown(world, stone_at);
    def.per_metre = 2;
    const EmitterId id = added(world, def);
    step_to(world, 3, rate);
    const auto all = alive(world, id);
    ASSERT_GT(all.size(), 35u);
    for (const auto& [number, state] : all)
      EXPECT_NEAR(way_of(stone_at, state.position.x / stone_at.along), 0.5 * static_cast<double>(number + 1), 1e-6)
          << rate << " frames a second";
  }
}

TEST(EmitterLed, who_is_thrown_straight_up_counts_the_way_up_and_down) {
  constexpr double kUp = 10, kApex = kUp * kUp / (2 * kG);
  for (const int rate : {7, 24, 144}) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = marks(world);
    def.follows = *world.spawn(kind_of(world, spark()), {.velocity = Vec3d{0, kUp, 0}});
    def.per_metre = 4;
    const EmitterId id = added(world, def);
    step_to(world, 2, rate);
    const auto all = alive(world, id);
    ASSERT_GT(all.size(), 35u);
    for (const auto& [number, state] : all) {
      const double way = static_cast<double>(number + 1) / 4;
      // Its speed has a corner where it turns back, which a quadrature over parts of a frame rounds off.
      EXPECT_NEAR(state.position.y, way < kApex ? way : 2 * kApex - way, way < kApex - 0.3 ? 1e-9 : 2e-4) << rate;
    }
  }
}

}  // namespace physim::world_emitter_led_test
