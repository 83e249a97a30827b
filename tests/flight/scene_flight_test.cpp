// Flights that meet things: against closed forms, and against worlds at the same fixed step.
#include "rigid.hpp"
#include "scene_support.hpp"

namespace physim::flight_scene_flight_test {

using test::same_bits;
using namespace test_scene;

// ------------------------------------------------------------------------------------------- closed forms
TEST(SceneFlight, a_parabola_meets_a_slope_and_a_sphere_where_the_closed_form_does) {
  const double slope = 0.3, speed = 40, elevation = 0.9;
  Scene hill;
  add_thing(hill, PlaneShape{}, {.transform = {.rotation = {std::cos(slope / 2), 0, 0, std::sin(slope / 2)}}});
  // On a slope through the muzzle: t = 2 v sin(a - s) / (g cos s). Started above it, so that it is not met at once.
  const double time = 2 * speed * std::sin(elevation - slope) / (kG * std::cos(slope));
  const double range = speed * std::cos(elevation) * time;
  Scene ball;
  const Vec3d middle{48, 40, 0};
  const InstanceId sphere = put(ball, SphereShape{5}, middle);
  const auto gap = [&](double t) {
    const Vec3d at{speed * std::cos(elevation) * t, speed * std::sin(elevation) * t - 0.5 * kG * t * t, 0};
    return length(at - middle) - 5;
  };
  double before = 1.2, after = 1.9;
  ASSERT_GT(gap(before), 0);
  ASSERT_LT(gap(after), 0);
  for (int i = 0; i < 100; ++i) (gap(0.5 * (before + after)) > 0 ? before : after) = 0.5 * (before + after);
  std::vector<Fidelity> rungs = {closed()};
  for (const Integrator integrator : {Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853})
    rungs.push_back(rung(integrator));
  for (const Fidelity& fidelity : rungs) {
    const Flight on_hill = fly(stone(), {.position = {0, 1e-9, 0}, .speed = speed, .elevation = elevation},
                               vacuum_of(kG), fidelity, {}, meeting(hill));
    ASSERT_EQ(on_hill.outcome(), Outcome::hit);
    EXPECT_NEAR(on_hill.duration(), time, 1e-8);
    EXPECT_NEAR(on_hill.end().position.x, range, 1e-7);
    EXPECT_NEAR(on_hill.end().position.y, range * std::tan(slope), 1e-7);
    const Flight on_ball =
        fly(stone(), {.speed = speed, .elevation = elevation}, vacuum_of(kG), fidelity, {}, meeting(ball));
    ASSERT_EQ(on_ball.outcome(), Outcome::hit);
    EXPECT_NEAR(on_ball.duration(), after, 1e-9);
    const auto hits = of_kind(on_ball, EventKind::hit);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].instance, sphere);
    EXPECT_LT(length(hits[0].normal - (hits[0].position - middle) * 0.2), 1e-9);
    EXPECT_TRUE(same_bits(hits[0].time, on_ball.duration()));
    EXPECT_LT(length(hits[0].position - on_ball.end().position), 1e-9);
    EXPECT_LT(length(hits[0].velocity - on_ball.end().velocity), 1e-9);
  }
}

TEST(SceneFlight, elastic_bounces_in_a_room_follow_the_closed_form_at_every_time) {
  const Vec3d half{5, 3, 4};
  const Scene scene = room(half, {.restitution = 1, .friction = 0});
  struct Rung {
    Fidelity fidelity;
    double within;
  };
  std::vector<Rung> rungs = {{closed(), 1e-9}, {rung(Integrator::tsit5, Precision::float32), 2e-5}};
  for (const Integrator integrator : test::kIntegrators)
    if (integrator != Integrator::classic) rungs.push_back({rung(integrator), 1e-9});
  const Vec3d from{0.5, -0.25, 0.125};
  for (const auto& [fidelity, within] : rungs)
    for (const double speed : {10.0, 300.0})
      for (const double radius : {0.0, 0.11}) {
        Until until = meeting(scene, OnHit::bounce, radius);
        until.time = 120 / speed;
        until.contact.restitution = 1;
        const Vec3d v0 = Vec3d{0.6, 0.48, 0.64} * speed;
        const Flight flight = fly(stone(), {.position = from, .velocity = v0}, vacuum_of(0), fidelity,
                                  {.step = fidelity.integrator == Integrator::tsit5 ? 0 : 1.0 / 60}, until);
        ASSERT_EQ(flight.outcome(), Outcome::time_limit) << name(fidelity.integrator);
        EXPECT_NEAR(flight.duration(), until.time, fidelity.precision == Precision::float32 ? 1e-6 : 1e-12);
        EXPECT_GT(of_kind(flight, EventKind::bounced).size(), 10u);
        for (int i = 0; i <= 500; ++i) {
          const double t = until.time * i / 500;
          const Vec3d free = from + v0 * t;
          const Unfolded x = unfolded(free.x, half.x - radius), y = unfolded(free.y, half.y - radius),
                         z = unfolded(free.z, half.z - radius);
          const Sample s = flight.at(t);
          ASSERT_LT(length(s.position - Vec3d{x.x, y.x, z.x}), within * speed * until.time)
              << name(fidelity.integrator) << " at " << t;
          // Next to a wall the sign of one of its parts is that of either side.
          const Vec3d wall = half - Vec3d{radius, radius, radius};
          const double gap = std::min({wall.x - std::abs(x.x), wall.y - std::abs(y.x), wall.z - std::abs(z.x)});
          if (gap < within * speed * until.time) continue;
          ASSERT_LT(length(s.velocity - Vec3d{x.sign * v0.x, y.sign * v0.y, z.sign * v0.z}), within * speed) << t;
        }
      }
}

TEST(SceneFlight, a_bounce_breaks_the_velocity_and_not_the_path) {
  Scene scene;
  put(scene, PlaneShape{}, {}, *scene.add_material({.restitution = 1, .friction = 0}));
  std::vector<Fidelity> rungs = {closed(), rung(Integrator::rk4), rung(Integrator::tsit5), rung(Integrator::dop853)};
  for (const Fidelity& fidelity : rungs) {
    Until until = meeting(scene, OnHit::bounce);
    until.contact.restitution = 0.8;
    until.time = 3;
    until.events = {{EventKind::height, 1, Crossing::any}, {EventKind::range, 7}, {EventKind::time, 2.5}};
    const Flight flight =
        fly(stone(), {.position = {0, 2, 0}, .speed = 4}, vacuum_of(kG), fidelity, {.step = 1.0 / 64}, until);
    const double fall = std::sqrt(4 / kG), v = kG * fall;
    double at = fall, up = 0.8 * v;
    const auto bounces = of_kind(flight, EventKind::bounced);
    ASSERT_GE(bounces.size(), 2u);
    std::vector<double> crossings = {std::sqrt(2 / kG)};
    for (const Event& e : bounces) {
      EXPECT_NEAR(e.time, at, 1e-8);
      EXPECT_NEAR(e.velocity.y, up, 1e-7);
      EXPECT_TRUE(same_bits(flight.at(e.time).velocity, e.velocity)) << name(fidelity.integrator);
      EXPECT_NEAR(flight.at(std::nextafter(e.time, 0)).velocity.y, -up / 0.8, 1e-6);
      EXPECT_NEAR(flight.at(e.time).position.y, 0, 1e-9);
      const double root = up * up - 2 * kG;
      for (const double side : {-1.0, 1.0})
        if (root > 0) crossings.push_back(at + (up + side * std::sqrt(root)) / kG);
      at += 2 * up / kG;
      up *= 0.8;
    }
    std::erase_if(crossings, [](double t) { return t > 3; });
    const auto heights = of_kind(flight, EventKind::height);
    ASSERT_EQ(heights.size(), crossings.size());
    for (std::size_t i = 0; i < heights.size(); ++i) EXPECT_NEAR(heights[i].time, crossings[i], 1e-7);
    ASSERT_EQ(of_kind(flight, EventKind::range).size(), 1u);
    EXPECT_NEAR(of_kind(flight, EventKind::range)[0].time, 7.0 / 4, 1e-8);
    EXPECT_EQ(of_kind(flight, EventKind::range)[0].value, 7);
    ASSERT_EQ(of_kind(flight, EventKind::time).size(), 2u);  // and the end
    EXPECT_NEAR(of_kind(flight, EventKind::time)[0].time, 2.5, 1e-12);
    EXPECT_NEAR(of_kind(flight, EventKind::time)[0].value, 2.5, 1e-12);
    const auto again = must(flight.at_height(1, Crossing::rising));
    EXPECT_NEAR(again.time, crossings[1], 1e-7);
    EXPECT_NEAR(flight.at_range(7)->time, 7.0 / 4, 1e-8);
    for (std::size_t i = 1; i < flight.events().size(); ++i)
      EXPECT_LE(flight.events()[i - 1].time, flight.events()[i].time);
    const auto times = flight.step_times();
    for (std::size_t i = 1; i < times.size(); ++i) EXPECT_LT(times[i - 1], times[i]);
    EXPECT_EQ(times.back(), flight.duration());
  }
}

// ------------------------------------------------------------------------------------------- as worlds do
struct Case {
  const char* name;
  Fidelity fidelity;
};
std::vector<Case> fixed_step_cases() {
  std::vector<Case> all;
  const auto add = [&](const char* name, Fidelity fidelity, Integrator integrator, Precision precision) {
    fidelity.integrator = integrator;
    fidelity.precision = precision;
    all.push_back({name, fidelity});
  };
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    add("classic", Fidelity::classic(), Integrator::classic, precision);
    add("game", Fidelity::game(), Integrator::semi_implicit_euler, precision);
    add("game heun", Fidelity::game(), Integrator::heun, precision);
    Fidelity spinning = Fidelity::constant_air();
    spinning.rotation = RotationModel::magnus;
    add("ball", spinning, Integrator::rk4, precision);
  }
  return all;
}

TEST(SceneFlight, a_flight_and_a_world_meet_things_alike_to_rounding) {
  const Scene scene = room({5, 3, 4}, {.restitution = 0.9, .friction = 0.3});
  for (const auto& [label, fidelity] : fixed_step_cases())
    for (const double radius : {0.0, 0.11})
      for (const double h : {1.0 / 64, 1.0 / 16}) {
        SCOPED_TRACE(std::string(label) + " radius " + std::to_string(radius) + " step " + std::to_string(h));
        ProjectileDef p = presets::tennis_ball().projectile;
        p.fidelity = fidelity;
        p.drag.damping = 0.9;
        Launch launch{.position = {0.5, 0.25, 0.125}, .speed = 35, .elevation = 0.4, .azimuth = 0.3};
        launch.spin = {.backspin = 200, .sidespin = 50, .gyrospin = 30};
        WorldDef def{.ground = {.mode = GroundMode::none}};
        World world = make_world(def, scene);
        BodyDef body{.can_sleep = false, .restitution = 0.95, .collision = {.on_hit = OnHit::bounce, .radius = radius}};
        const auto id = must(world.spawn(p, launch, body));
        Until until = meeting(scene, OnHit::bounce, radius);
        until.contact.restitution = 0.95;
        until.time = 4;
        const Flight flight = fly(p, launch, def.environment, fidelity, {.step = h}, until);
        ASSERT_FALSE(flight.error()) << flight.error()->text();
        std::vector<Event> bounced;
        while (world.time() < until.time - 0.5 * h) {
          world.step(h);
          for (const Event& e : events_of(world, EventKind::bounced)) bounced.push_back(e);
          if (world.time() > flight.duration()) break;
          const Sample s = flight.at(world.time());
          const double within = fidelity.precision == Precision::float32 ? 1e-4 : 1e-11;
          ASSERT_LE(length(world[id].position() - s.position), within) << world.time();
          ASSERT_LE(length(world[id].velocity() - s.velocity), 35 * within) << world.time();
        }
        const auto told = of_kind(flight, EventKind::bounced);
        ASSERT_GT(told.size(), 4u);
        ASSERT_EQ(told.size(), bounced.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
          EXPECT_NEAR(told[i].time, bounced[i].time, 1e-5);
          // Between steps the clock of a flight runs on, and that of most rows begins anew: a rounding beside it.
          const double rounding = fidelity.precision == Precision::float32 ? 1e-4 : 1e-12;
          EXPECT_LT(length(told[i].position - bounced[i].position), rounding);
          EXPECT_LT(length(told[i].velocity - bounced[i].velocity), rounding * 35);
          EXPECT_EQ(told[i].instance, bounced[i].instance);
        }
      }
}

TEST(SceneFlight, adaptive_and_rigid_flights_meet_things_as_fine_worlds_do) {
  const Scene scene = room({20, 12, 16}, {.restitution = 0.8, .friction = 0.3});
  ProjectileDef ball = presets::tennis_ball().projectile;
  ball.fidelity = Fidelity::constant_air();
  ProjectileDef brick = test::nasa_brick();
  for (const bool rigid : {false, true}) {
    ProjectileDef p = rigid ? brick : ball;
    if (rigid) p.fidelity = test::rigid(Integrator::rk4);
    Fidelity fixed = p.fidelity, adaptive = p.fidelity;
    fixed.integrator = Integrator::rk4;
    adaptive.integrator = Integrator::dop853;
    fixed.precision = adaptive.precision = Precision::float64;
    Launch launch{.position = {0.5, 0.25, 0.125}, .speed = 60, .elevation = 0.4, .azimuth = 0.3};
    if (rigid) launch.attitude = test::spun_launch().attitude;
    if (!rigid) launch.spin = {.backspin = 200, .sidespin = 50, .gyrospin = 30};
    Until until = meeting(scene, OnHit::bounce, 0.03);
    until.time = 2.5;
    until.contact.restitution = 1;
    const double step = rigid ? 1.0 / 2048 : 1.0 / 512;
    const Flight fine = fly(p, launch, {}, fixed, {.step = step}, until);
    const Flight free = fly(p, launch, {}, adaptive, {}, until);
    ASSERT_FALSE(fine.error()) << fine.error()->text();
    ASSERT_FALSE(free.error()) << free.error()->text();
    const auto one = of_kind(fine, EventKind::bounced), other = of_kind(free, EventKind::bounced);
    const std::size_t compared = rigid ? 1 : 2;
    ASSERT_GE(std::min(one.size(), other.size()), compared);
    // Brick walls make the brick spin so fast that only the first bounces can be compared.
    for (std::size_t i = 0; i < compared; ++i) {
      EXPECT_NEAR(one[i].time, other[i].time, 1e-6) << rigid;
      EXPECT_LT(length(one[i].position - other[i].position), 1e-4) << rigid;
      EXPECT_LT(length(one[i].velocity - other[i].velocity), 1e-3) << rigid;
      const double after = one[i].time + 0.01;
      EXPECT_LT(length(fine.at(after).angular_velocity - free.at(after).angular_velocity), 1e-2) << rigid;
    }
    if (!rigid) continue;
    EXPECT_GT(length(free.at(one[0].time + 0.01).angular_velocity), 10);  // rad/s, of 0.65 before
  }
}

TEST(SceneFlight, what_meets_nothing_flies_as_without_a_scene) {
  Scene scene;
  put(scene, BoxShape{{1, 1, 1}}, {0, -500, 0});
  std::vector<Fidelity> rungs = {closed()};
  for (const Integrator integrator : test::kIntegrators) rungs.push_back(rung(integrator));
  for (const Fidelity& fidelity : rungs) {
    const Tolerance tolerance{.step = 1.0 / 64};
    const Launch launch{.position = {0, 1.5, 0}, .speed = 60, .elevation = 0.5};
    Until until{.time = 20};
    const Flight without = fly(stone(), launch, vacuum_of(kG), fidelity, tolerance, until);
    until.scene = &scene;
    const Flight with = fly(stone(), launch, vacuum_of(kG), fidelity, tolerance, until);
    EXPECT_EQ(with.outcome(), Outcome::landed);
    EXPECT_TRUE(same_bits(with.duration(), without.duration())) << name(fidelity.integrator);
    EXPECT_TRUE(same_bits(with.end().position, without.end().position)) << name(fidelity.integrator);
    EXPECT_EQ(with.step_times(), without.step_times());
    EXPECT_EQ(with.cost().steps, without.cost().steps);
    ASSERT_EQ(with.events().size(), without.events().size());
  }
}

}  // namespace physim::flight_scene_flight_test
