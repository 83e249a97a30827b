// fly_batch() gives the numbers of fly(), bit for bit: every integrator, precision and instruction set.
#include "flight/batch_support.hpp"

namespace physim::flight_batch_test {

using namespace test;

/// Lets a test choose kernels and puts the best one back.
class BatchTest : public testing::Test {
 protected:
  ~BatchTest() override { use_kernel(""); }
};

/// The events that a batch reports too: fly() also reports every apex, which nobody asked for.
std::vector<Event> asked_for(const Flight& flight, const Until& until) {
  bool apex = false;
  for (const EventSpec& e : until.events) apex = apex || e.kind == EventKind::apex;
  std::vector<Event> events;
  for (const Event& e : flight.events())
    if (apex || e.kind != EventKind::apex) events.push_back(e);
  return events;
}

void expect_flown(const Flight& flight, const BatchResult& batch, std::uint32_t i, const Until& until,
                  const std::string& what) {
  const ShotResult& shot = batch.shots[i];
  const Sample end = flight.end();
  EXPECT_EQ(shot.outcome, flight.outcome()) << what;
  EXPECT_TRUE(same_bits(shot.time, flight.duration())) << what << ": " << shot.time << ' ' << flight.duration();
  EXPECT_TRUE(same_bits(shot.position, end.position))
      << what << ": " << shot.position.x << ' ' << end.position.x << " after " << flight.cost().steps;
  EXPECT_TRUE(same_bits(shot.velocity, end.velocity)) << what;
  EXPECT_EQ(shot.cost.steps, flight.cost().steps) << what;
  EXPECT_EQ(shot.cost.rejected, flight.cost().rejected) << what;
  EXPECT_EQ(shot.cost.evaluations, flight.cost().evaluations) << what;
  bool apex_asked = false;
  for (const EventSpec& e : until.events) apex_asked = apex_asked || e.kind == EventKind::apex;
  if (apex_asked) return;  // fly() then has its own apex beside those asked for; the next test looks at them
  std::vector<Event> events;
  for (const ShotEvent& e : batch.events)
    if (e.shot == i) events.push_back(e.event);
  const std::vector<Event> expected = asked_for(flight, until);
  ASSERT_EQ(events.size(), expected.size()) << what;
  for (std::size_t k = 0; k < events.size(); ++k)
    EXPECT_TRUE(same_event(events[k], expected[k])) << what << " event " << k;
}

using Combination = std::tuple<Integrator, Precision>;
class BatchEquality : public testing::TestWithParam<Combination> {
 protected:
  ~BatchEquality() override { use_kernel(""); }
};

TEST_P(BatchEquality, random_shots_fly_as_one_by_one) {
  const auto [integrator, precision] = GetParam();
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const RandomBatch c = random_batch(seed, integrator, precision, 30);
    std::vector<Flight> flights;
    for (const Shot& shot : c.shots)
      flights.push_back(fly(shot.projectile, shot.launch, c.environment, c.fidelity, c.tolerance, c.until));
    for (const std::string& kernel : kernels()) {
      ASSERT_TRUE(use_kernel(kernel));
      const BatchResult batch = fly_batch(c.shots, c.environment, c.fidelity, c.tolerance, c.until);
      ASSERT_EQ(batch.kernel, kernel);
      ASSERT_FALSE(batch.error) << batch.error->text();
      ASSERT_EQ(batch.shots.size(), c.shots.size());
      for (std::uint32_t i = 0; i < c.shots.size(); ++i) {
        expect_flown(flights[i], batch, i, c.until,
                     kernel + " seed " + std::to_string(seed) + " shot " + std::to_string(i));
        if (HasFailure()) return;
      }
    }
  }
}

/// Flies a projectile's launches as such, and as shots of it.
void expect_launches_fly_as_shots(const ProjectileDef& projectile, const RandomBatch& c, const std::string& what) {
  std::vector<Launch> launches;
  std::vector<Shot> shots;
  for (const Shot& shot : c.shots) {
    launches.push_back(shot.launch);
    shots.push_back({projectile, shot.launch});
  }
  expect_same(fly_batch(projectile, launches, c.environment, c.fidelity, c.tolerance, c.until),
              fly_batch(shots, c.environment, c.fidelity, c.tolerance, c.until), what);
}

TEST_P(BatchEquality, launches_of_one_projectile_fly_as_shots_of_it) {
  const auto [integrator, precision] = GetParam();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const RandomBatch c = random_batch(seed, integrator, precision, 40);
    for (const std::string& kernel : kernels()) {
      ASSERT_TRUE(use_kernel(kernel));
      for (const std::size_t i : {0, 1, 2})
        expect_launches_fly_as_shots(c.shots[i].projectile, c, kernel + " seed " + std::to_string(seed));
    }
    if (HasFailure()) return;
  }
}

std::string name_of(const testing::TestParamInfo<Combination>& c) {
  return text(std::get<0>(c.param)) + "_" + std::string(name(std::get<1>(c.param)));
}

INSTANTIATE_TEST_SUITE_P(All, BatchEquality,
                         testing::Combine(testing::Values(Integrator::classic, Integrator::explicit_euler,
                                                          Integrator::semi_implicit_euler, Integrator::heun,
                                                          Integrator::rk4, Integrator::rk43, Integrator::tsit5,
                                                          Integrator::dop853),
                                          testing::Values(Precision::float32, Precision::float64)),
                         name_of);

TEST_F(BatchTest, launches_that_differ_in_spin_and_rail_fly_as_shots) {
  RandomBatch c{{}, Fidelity::simulation(), {}, {}, {}};
  Random r(3);
  for (int i = 0; i < 70; ++i) {
    Launch launch{.position = {0, 2, 0}, .speed = r.in(20, 60), .elevation = r.in(0.1, 0.6)};
    launch.spin = {.backspin = r.in(0, 300), .sidespin = r.in(-50, 50)};
    c.shots.push_back({{}, launch});
  }
  expect_launches_fly_as_shots(presets::golf_ball().projectile, c, "golf ball");
  for (std::size_t i = 60; i < 70; ++i) c.shots[i].launch.rail_length = 2;
  ProjectileDef rocket = bullet_308();
  expect_launches_fly_as_shots(rocket, c, "rail");
  rocket.motor = {.thrust = {{0, 5}, {0.3, 0}}, .propellant_mass = 0.001};
  expect_launches_fly_as_shots(rocket, c, "motor");
  for (std::size_t i = 60; i < 70; ++i) c.shots[i].launch.rail_length = 0;
  rocket = {.mass = 0.2, .diameter = 0.05};
  c.fidelity.drag = DragModel::linear_quadratic;  // k2 from the drag equation at launch
  expect_launches_fly_as_shots(rocket, c, "equivalent drag");
}

TEST_F(BatchTest, launches_of_what_turns_end_in_the_attitude_of_a_flight) {
  ProjectileDef shell{.mass = 15,
                      .diameter = 0.105,
                      .twist = 2,
                      .drag = {.table = DragTable::g1},
                      .inertia = {.moments = {0.023, 0.23, 0.23}},
                      .aero = {.lift = {{0, 0, 2}}, .pitching = {{0, 0, 3.8}}, .roll_damping = {{0, 0, -0.01}}}};
  std::vector<Launch> launches;
  for (int i = 0; i < 40; ++i) launches.push_back({.position = {0, 1, 0}, .speed = 90.0 + i, .elevation = 0.3});
  launches[7].position.y = -1;  // ends at once
  Fidelity f = Fidelity::simulation();
  f.integrator = Integrator::rk4;
  for (const RotationModel rotation : {RotationModel::modified_point_mass, RotationModel::rigid_body}) {
    f.rotation = rotation;
    const BatchResult batch = fly_batch(shell, launches, {}, f, {.step = 2e-3});
    ASSERT_FALSE(batch.error);
    for (std::size_t i = 0; i < launches.size(); ++i) {
      const Sample end = fly(shell, launches[i], {}, f, {.step = 2e-3}).end();
      EXPECT_TRUE(same_bits(batch.shots[i].position, end.position)) << name(rotation) << i;
      EXPECT_EQ(batch.attitudes[i].orientation, end.orientation) << name(rotation) << i;
      EXPECT_TRUE(same_bits(batch.attitudes[i].angular_velocity, end.angular_velocity)) << name(rotation) << i;
    }
  }
}

TEST_F(BatchTest, thousands_of_launches_fly_as_shots_chunk_after_chunk) {
  RandomBatch c{{}, Fidelity::artillery(), {}, {}, {}};
  Random r(5);
  for (int i = 0; i < 5000; ++i) {
    Launch launch{.position = {0, 1, 0}, .speed = r.in(50, 400), .elevation = r.in(-0.1, 0.8)};
    if (r.one_in(50)) launch.speed = kNan;
    if (r.one_in(50)) launch.position.y = -1;
    c.shots.push_back({{}, launch});
  }
  c.until.events = {{EventKind::height, 20}, {EventKind::apex}};
  expect_launches_fly_as_shots(bullet_308(), c, "plain");
  c.fidelity.integrator = Integrator::rk4;
  c.tolerance.position_error = 0.1;
  expect_launches_fly_as_shots(bullet_308(), c, "step by pilots");
  c.shots.back().launch.rail_length = 3;  // one of the last chunk
  expect_launches_fly_as_shots(bullet_308(), c, "rail");
}

TEST_F(BatchTest, what_cannot_happen_ends_no_flight) {
  ProjectileDef rocket = bullet_308();
  rocket.motor = {.thrust = {{0, 5}, {0.3, 0}}, .propellant_mass = 0.001};
  const Launch launch{.position = {0, 2, 0}, .speed = 200, .elevation = 0.2, .rail_length = 1};
  const std::vector<Shot> rockets(40, Shot{rocket, launch});
  const std::vector<Shot> bullets(40, Shot{bullet_308(), {.position = {0, 2, 0}, .speed = 200, .elevation = 0.2}});
  for (const EventKind kind : {EventKind::ignition, EventKind::burnout, EventKind::rail_exit}) {
    Until until{.events = {{.kind = kind, .terminal = true}}};
    for (const std::string& kernel : kernels()) {
      ASSERT_TRUE(use_kernel(kernel));
      EXPECT_FALSE(fly_batch(rockets, {}, Fidelity::simulation(), {}, until).error);
      const BatchResult batch = fly_batch(bullets, {}, Fidelity::simulation(), {}, until);
      for (const ShotResult& shot : batch.shots) {
        EXPECT_EQ(shot.outcome, Outcome::landed) << kernel;
        EXPECT_GT(shot.time, 1) << kernel;
      }
    }
  }
}

TEST_F(BatchTest, what_was_granted_is_that_of_the_first_shot_accepted) {
  std::vector<Shot> shots(3, Shot{bullet_308(), {.position = {0, 1, 0}, .speed = 300}});
  for (Shot& shot : shots) shot.projectile.twist = 0;
  shots[0].projectile.twist = 0.3;
  shots[0].projectile.length = 0.03;
  Fidelity f{.rotation = RotationModel::spin_drift};
  EXPECT_EQ(fly_batch(shots, {}, f).fidelity_in_use.fidelity.rotation, RotationModel::spin_drift);
  shots[0].launch.speed = kNan;
  EXPECT_EQ(fly_batch(shots, {}, f).fidelity_in_use.fidelity.rotation, RotationModel::none);
}

TEST_F(BatchTest, bad_launches_and_projectiles_are_refused_as_in_shots) {
  RandomBatch c{{}, {}, {}, {}, std::vector<Shot>(50, Shot{{}, {.position = {0, 1, 0}, .speed = 300}})};
  for (const std::size_t i : {0, 7, 49}) c.shots[i].launch.speed = kNan;
  c.shots[9].launch.position.y = -1;  // lands at once
  expect_launches_fly_as_shots(bullet_308(), c, "launches");
  expect_launches_fly_as_shots({.mass = -1}, c, "projectile");
  EXPECT_TRUE(fly_batch(bullet_308(), std::span<const Launch>{}, {}, {}).shots.empty());
  EXPECT_TRUE(fly_batch({.mass = -1}, std::span<const Launch>{}, {}, {}).error);
}

TEST_F(BatchTest, a_result_is_used_again) {
  std::vector<Launch> launches;
  for (int i = 0; i < 3000; ++i) launches.push_back({.position = {0, 1, 0}, .speed = 300.0 + i});
  BatchResult result;
  fly_batch(bullet_308(), launches, {}, {}, {}, {}, result);
  const ShotResult* memory = result.shots.data();
  const BatchResult first = result;
  launches[5].speed = kNan;
  fly_batch(bullet_308(), std::span(launches).first(100), {}, {}, {}, {}, result);
  EXPECT_EQ(result.shots.size(), 100u);
  EXPECT_EQ(result.shots.data(), memory);
  EXPECT_TRUE(result.error);
  EXPECT_EQ(result.shots[5].outcome, Outcome::refused);
  launches[5].speed = 305;
  fly_batch(bullet_308(), launches, {}, {}, {}, {}, result);
  EXPECT_EQ(result.shots.data(), memory);
  expect_same(result, first, "again");
}

TEST_F(BatchTest, a_result_used_again_holds_nothing_of_before) {
  std::vector<Launch> launches;
  for (int i = 0; i < 50; ++i) launches.push_back({.position = {0, 2, 0}, .speed = 100.0 + i, .elevation = 0.1});
  std::vector<Launch> some_bad = launches;
  some_bad[3].speed = kNan;
  ProjectileDef brick{.mass = 2, .inertia = {.moments = {0.002, 0.006, 0.007}}};
  Fidelity turning = Fidelity::simulation();
  turning.rotation = RotationModel::rigid_body;
  Fidelity fixed = Fidelity::simulation();
  fixed.integrator = Integrator::rk4;
  Environment bad{.altitude = kNan};
  BatchResult result;
  const auto flies_as_anew = [&](const char* what, const ProjectileDef& p, const std::vector<Launch>& list,
                                 const Environment& e, const Fidelity& f, const Tolerance& t = {}) {
    fly_batch(brick, launches, {}, turning, {}, {}, result);
    ASSERT_NE(result.attitudes.at(3).orientation, Quatd{}) << what;
    fly_batch(p, list, e, f, t, {}, result);
    const BatchResult anew = fly_batch(p, list, e, f, t, {});
    expect_same(result, anew, what);
    EXPECT_TRUE(result.attitudes.empty()) << what;
    EXPECT_EQ(result.error.has_value(), anew.error.has_value()) << what;
  };
  flies_as_anew("points", bullet_308(), launches, {}, Fidelity::simulation());
  flies_as_anew("one refused", bullet_308(), some_bad, {}, Fidelity::simulation());
  flies_as_anew("no step found", bullet_308(), launches, {}, fixed, {.position_error = 1e-300});
  flies_as_anew("a bad environment", bullet_308(), launches, bad, Fidelity::simulation());
  flies_as_anew("a bad projectile", {.mass = -1}, launches, {}, Fidelity::simulation());

  fly_batch(bullet_308(), launches, {}, fixed, {}, {}, result);
  const BatchResult first = result;
  fly_batch(bullet_308(), launches, {}, result.fidelity_in_use.fidelity, {}, {}, result);
  expect_same(result, first, "with the fidelity of the result itself");
}

TEST_F(BatchTest, kernels_are_listed_best_first_and_can_be_chosen) {
  const auto list = kernels();
  ASSERT_GE(list.size(), 2u);
  EXPECT_EQ(list[list.size() - 2], "base");
  EXPECT_EQ(list.back(), "scalar");
  for (const std::string& kernel : list) {
    EXPECT_TRUE(use_kernel(kernel));
    EXPECT_EQ(fly_batch({}, {}, {}).kernel, kernel);
  }
  EXPECT_FALSE(use_kernel("sse9"));
  EXPECT_EQ(fly_batch({}, {}, {}).kernel, list.back()) << "a wrong name changes nothing";
  EXPECT_TRUE(use_kernel(""));
  EXPECT_EQ(fly_batch({}, {}, {}).kernel, list.front());
}

TEST_F(BatchTest, empty_batch) {
  const BatchResult batch = fly_batch({}, {}, Fidelity::simulation());
  EXPECT_TRUE(batch.shots.empty());
  EXPECT_TRUE(batch.events.empty());
  EXPECT_FALSE(batch.error);
}

TEST_F(BatchTest, lanes_are_refilled_whatever_the_durations) {
  // Flights of 0.01 s to 40 s, in an order that leaves long ones in lanes between short ones, and none of a pack's
  // size.
  for (const int count : {1, 2, 7, 33, 101}) {
    std::vector<Shot> shots;
    for (int i = 0; i < count; ++i) {
      Shot shot{bullet_308(), {.position = {0, 0.001 * (i + 1), 0}, .speed = 400}};
      if (i % 5 == 3) shot.launch.elevation = 1.2;
      if (i % 17 == 16) shot.launch.position.y = 3000;
      shots.push_back(shot);
    }
    for (const Integrator integrator : {Integrator::tsit5, Integrator::rk4})
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        Fidelity f{.integrator = integrator, .precision = precision};
        const Tolerance tolerance{1e-6, 1e-6, 0.01};
        for (const std::string& kernel : kernels()) {
          use_kernel(kernel);
          const BatchResult batch = fly_batch(shots, {}, f, tolerance);
          for (std::uint32_t i = 0; i < shots.size(); i += 1 + i / 7)
            expect_flown(fly(shots[i].projectile, shots[i].launch, {}, f, tolerance), batch, i, {},
                         kernel + std::to_string(i));
        }
      }
  }
}

TEST_F(BatchTest, refused_shots_are_left_out_and_the_others_fly) {
  std::vector<Shot> shots(20, Shot{bullet_308(), {.speed = 300, .elevation = 0.1}});
  shots[3].projectile.mass = -1;
  shots[9].launch.speed = kNan;
  shots[19].launch.sight.zero_range = 1e6;
  shots[19].launch.elevation = 0;
  const BatchResult batch = fly_batch(shots, {}, {});
  ASSERT_TRUE(batch.error);
  EXPECT_EQ(batch.error->place, "projectile.mass") << "the first one";
  for (std::size_t i = 0; i < shots.size(); ++i)
    EXPECT_EQ(batch.shots[i].outcome, i == 3 || i == 9 || i == 19 ? Outcome::refused : Outcome::landed) << i;
  EXPECT_TRUE(same_bits(batch.shots[0].position, fly(shots[0].projectile, shots[0].launch, {}, {}).end().position));
}

/// Batches look at equal curves once; what differs in one point, or is wrong beside its curve, is seen all the same.
TEST_F(BatchTest, own_drag_curves_are_checked_and_granted_as_in_single_flights) {
  const std::vector<DragPoint> smooth = {{0, .2}, {1, .3}, {2, .25}, {3, .2}};
  const std::vector<DragPoint> overshooting = {{0, .12}, {.8, .12}, {1, .4}, {1.2, .35}, {2, .25}, {3, .2}};
  std::vector<Shot> shots(200, Shot{bullet_308(), {.speed = 700, .elevation = 0.02}});
  for (std::size_t i = 0; i < shots.size(); ++i) {
    ProjectileDef& p = shots[i].projectile;
    p.drag.table = DragTable::custom;
    p.drag.curve = i % 3 == 0 ? overshooting : smooth;
    if (i >= 100) p.drag.curve[0].coefficient += 1e-3 * static_cast<double>(i);  // more curves than are remembered
  }
  shots[50].projectile.drag.curve[2].coefficient = kNan;
  shots[51].projectile.drag.curve[1].mach = 0;
  shots[52].projectile.drag.curve.clear();
  shots[53].projectile.mass = -1;
  shots[54].projectile.drag.curve[0].mach = -0.0;
  const Fidelity asked = Fidelity::simulation();
  for (const std::size_t first : {std::size_t(0), std::size_t(51), std::size_t(52), std::size_t(53)}) {
    const std::span<const Shot> from = std::span(shots).subspan(first);
    const BatchResult batch = fly_batch(from, {}, asked);
    bool told = false;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Flight flight = fly(from[i].projectile, from[i].launch, {}, asked);
      EXPECT_EQ(batch.shots[i].outcome, flight.outcome()) << first + i;
      if (!flight.error()) {
        EXPECT_TRUE(same_bits(batch.shots[i].position, flight.end().position)) << first + i;
      } else if (!std::exchange(told, true)) {
        ASSERT_TRUE(batch.error);
        EXPECT_EQ(batch.error->text(), flight.error()->text());
      }
    }
  }
}

TEST_F(BatchTest, bad_common_input_refuses_all) {
  const std::vector<Shot> shots(3, Shot{bullet_308(), {.speed = 300}});
  Environment bad{.atmosphere = {.humidity = 7}};
  for (const BatchResult& batch : {fly_batch(shots, bad, {}), fly_batch(shots, {}, {}, {.relative = 1e-20}),
                                   fly_batch(shots, {}, {}, {}, {.time = kNan})}) {
    ASSERT_TRUE(batch.error);
    EXPECT_FALSE(batch.error->place.empty());
    ASSERT_EQ(batch.shots.size(), 3u);
    for (const ShotResult& shot : batch.shots) EXPECT_EQ(shot.outcome, Outcome::refused);
  }
}

TEST_F(BatchTest, shots_below_the_ground_land_at_once) {
  std::vector<Shot> shots(9, Shot{bullet_308(), {.position = {0, 1, 0}, .speed = 300}});
  shots[4].launch = {.position = {1, -2, 3}, .speed = 300, .elevation = -0.5};
  const BatchResult batch = fly_batch(shots, {}, {});
  EXPECT_EQ(batch.shots[4].outcome, Outcome::landed);
  EXPECT_EQ(batch.shots[4].time, 0);
  EXPECT_EQ(batch.shots[4].position, (Vec3d{1, -2, 3}));
  expect_flown(fly(shots[4].projectile, shots[4].launch, {}, {}), batch, 4, {}, "landed");
  EXPECT_GT(batch.shots[5].time, 0.1);
}

TEST_F(BatchTest, events_come_by_shot_then_by_time) {
  std::vector<Shot> shots;
  for (int i = 0; i < 40; ++i) shots.push_back({bullet_308(), {.speed = 100.0 + 7 * (i * 13 % 40), .elevation = 0.8}});
  Until until;
  for (const double h : {10.0, 50.0, 100.0}) until.events.push_back({EventKind::height, h});
  until.events.push_back({EventKind::apex, 0});
  const BatchResult batch = fly_batch(shots, {}, {}, {}, until);
  ASSERT_EQ(batch.events.size(), 40u * 8);
  for (std::size_t i = 1; i < batch.events.size(); ++i) {
    const ShotEvent& a = batch.events[i - 1];
    const ShotEvent& b = batch.events[i];
    EXPECT_TRUE(a.shot < b.shot || (a.shot == b.shot && a.event.time <= b.event.time)) << i;
  }
}

TEST_F(BatchTest, features_that_come_with_later_shots_change_no_earlier_one) {
  const auto change = [](std::size_t i, Shot& shot) {
    shot.launch.speed = 500 + static_cast<double>(i);
    ProjectileDef& p = shot.projectile;
    if (i > 20 && i % 7 == 0) p.drag.bands = {{0, 150}, {400, 250}};
    if (i > 30 && i % 11 == 0) p.drag = {.table = DragTable::sphere};
    if (i > 40 && i % 5 == 0) {
      p.motor.thrust = {{0, 4}, {0.2, 6}, {0.5, 0}};
      p.motor.propellant_mass = 0.2 * p.mass;
    }
    if (i > 50 && i % 6 == 0) p.force = {0, 0.01, 0};
    if (i == 69) shot.launch.rail_length = 1.5, shot.launch.position.x = 1e300;  // refused when the rail is known
  };
  std::vector<Shot> shots(70, Shot{bullet_308(), {.elevation = 0.01}});
  for (std::size_t i = 0; i < shots.size(); ++i) change(i, shots[i]);
  const Environment environment;
  Fidelity fidelity{.precision = Precision::float32};
  Until until{.range = 400};
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    const BatchResult batch = fly_batch(shots, environment, fidelity, {}, until);
    for (std::uint32_t i = 0; i + 1 < shots.size(); ++i) {
      const Flight flight = fly(shots[i].projectile, shots[i].launch, environment, fidelity, {}, until);
      ASSERT_FALSE(flight.error()) << i << flight.error()->text();
      EXPECT_EQ(batch.shots[i].outcome, flight.outcome()) << kernel << i;
      EXPECT_EQ(batch.shots[i].cost.evaluations, flight.cost().evaluations) << kernel << i;
      EXPECT_TRUE(same_bits(batch.shots[i].time, flight.duration())) << kernel << i;
      EXPECT_TRUE(same_bits(batch.shots[i].position, flight.end().position)) << kernel << i;
    }
    EXPECT_EQ(batch.shots.back().outcome, Outcome::refused);
  }
}

TEST_F(BatchTest, an_automatic_step_is_small_enough_for_all_shots) {
  std::vector<Shot> shots;
  for (int i = 0; i < 15; ++i) shots.push_back({bullet_308(), {.speed = 800.0 - 10 * i, .elevation = 0.01}});
  Fidelity f{.integrator = Integrator::rk4};
  const Until until{.ground = {}, .range = 800};
  const BatchResult batch = fly_batch(shots, {}, f, {.position_error = 1e-3}, until);
  f.integrator = Integrator::dop853;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Flight exact = fly(shots[i].projectile, shots[i].launch, {}, f, {1e-12, 1e-12}, until);
    EXPECT_LT(length(batch.shots[i].position - exact.end().position), 2e-3) << i;
  }
}

TEST_F(BatchTest, what_was_granted_is_told) {
  const std::vector<Shot> shots(3, Shot{bullet_308(), {.speed = 300}});
  Fidelity f{.motion = Motion::velocity};
  const BatchResult batch = fly_batch(shots, {}, f);
  EXPECT_EQ(batch.fidelity_in_use.fidelity.drag, DragModel::damping);
  EXPECT_FALSE(batch.fidelity_in_use.notes.empty());
}

}  // namespace physim::flight_batch_test
