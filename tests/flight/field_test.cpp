// Wind and force by functions of one's own, in flights: against wind that is no function, closed forms, and batches.
#include <array>

#include "random_shots.hpp"
#include "support.hpp"

namespace physim::flight_field_test {

using namespace test;

/// A function of each place by itself.
template <class F>
WindFunction wind_by(F at) {
  return [at](const WindBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i) b.velocity[i] = at(b.time[i], b.position[i]);
  };
}
template <class F>
ForceFunction force_by(F on) {
  return [on](const FieldForceBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i) b.force[i] = on(b.time[i], b.position[i], b.velocity[i], b.mass[i]);
  };
}

Environment nothing() { return {.gravity = {.model = GravityModel::off}, .atmosphere = {.model = AirModel::vacuum}}; }

/// Wind that changes with place and time, smoothly and without elementary functions of the library.
Vec3d swirl(double t, const Vec3d& x) {
  const double u = 1e-3 * x.x, s = u / (1 + u * u), g = t / (1 + t * t);
  return {3 * s, 1 - 2 * g, 5 * g - 0.01 * x.y};
}
Vec3d tug(double t, const Vec3d& x, const Vec3d& v, double m) {
  return (Vec3d{0.1 * v.z, 0, -0.1 * v.x} - x * 1e-4 + Vec3d{0, 0, t}) * (0.3 * m);
}

// ------------------------------------------------------------------------------------------------ against other wind
TEST(Field, a_uniform_one_is_the_wind_bit_for_bit) {
  const Vec3d w{2, 0.5, -4};
  Environment same, field;
  same.wind.velocity = w;
  field.wind.field = wind_by([w](double, const Vec3d&) { return w; });
  for (const Integrator integrator : kIntegrators)
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      Fidelity f = Fidelity::simulation();
      f.integrator = integrator;
      f.precision = precision;
      const Launch launch{.speed = 800, .elevation = 0.02};
      const Until until{.range = 700};
      const Flight a = fly(bullet_308(), launch, same, f, {.step = 0.004}, until);
      const Flight b = fly(bullet_308(), launch, field, f, {.step = 0.004}, until);
      ASSERT_EQ(a.outcome(), Outcome::reached_range) << text(integrator);
      EXPECT_TRUE(same_bits(a.end().position, b.end().position)) << text(integrator);
      EXPECT_TRUE(same_bits(a.at(0.4).mach, b.at(0.4).mach)) << text(integrator);
      EXPECT_TRUE(same_bits(a.accelerations(0.4).drag, b.accelerations(0.4).drag)) << text(integrator);
      EXPECT_EQ(a.cost().steps, b.cost().steps) << text(integrator);
    }
}

TEST(Field, one_of_straight_lines_is_the_profile) {
  Environment profile, field;
  profile.wind.profile = {{0, {0, 0, -2}}, {4000, {20, 0, -10}}};
  field.wind.field = wind_by([](double, const Vec3d& x) {
    const double part = std::min(std::max(x.y / 4000, 0.0), 1.0);
    return Vec3d{20 * part, 0, -2 - 8 * part};
  });
  const Launch launch{.speed = 800, .elevation = 0.6};
  const Tolerance tight{.relative = 1e-12, .absolute = 1e-10};
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  const Flight a = fly(bullet_308(), launch, profile, f, tight);
  const Flight b = fly(bullet_308(), launch, field, f, tight);
  EXPECT_GT(std::abs(a.end().windage), 50);
  EXPECT_TRUE(near(a.end().position, b.end().position, 0, 2e-6));
}

TEST(Field, wind_of_any_time_moves_a_linear_drag) {
  // v' = -k (v - w0 t): v = w0 (t - 1/k + exp(-k t)/k).
  const double k = 0.7, w0 = 3;
  ProjectileDef p{.mass = 2, .drag = {.k1 = 2 * k}};
  Environment e = nothing();
  e.wind.field = wind_by([=](double t, const Vec3d&) { return Vec3d{0, 0, w0 * t}; });
  Fidelity f = vacuum();
  f.drag = DragModel::linear_quadratic;
  f.wind = WindModel::profile;
  const Flight flight = fly(p, {}, e, f, {.relative = 1e-12, .absolute = 1e-12}, {.ground = {}, .time = 5});
  for (const double t : {0.5, 2.0, 5.0})
    EXPECT_TRUE(near(flight.at(t).velocity, {0, 0, w0 * (t - 1 / k + std::exp(-k * t) / k)}, 1e-9)) << t;
}

TEST(Field, over_a_round_earth_it_is_as_it_is_there) {
  Environment e;
  e.wind.field = wind_by([](double, const Vec3d&) { return Vec3d{7, 0, -3}; });
  Fidelity f = Fidelity::reference();
  const Conditions<double> c = prepare_conditions(e, grant(f, bullet_308(), e).fidelity);
  EXPECT_EQ(wind(c, Body<double>{}, 0.0, Vec3d{400e3, -12e3, 9e3}), (Vec3d{7, 0, -3}));
}

// ------------------------------------------------------------------------------------------------ forces, closed forms
TEST(Field, a_spring_oscillates_with_every_integrators_order) {
  const double k = 50, m = 2, omega = 5, end = 2;
  const ProjectileDef p{.mass = m};
  Environment e = nothing();
  e.force = force_by([=](double, const Vec3d& x, const Vec3d&, double) { return x * -k; });
  const Launch launch{.position = {1, 0, 0}, .velocity = Vec3d{0, 2, 0}};
  const Vec3d exact{std::cos(omega * end), 2 / omega * std::sin(omega * end), 0};
  const Until until{.ground = {}, .time = end};
  for (const Integrator integrator : kIntegrators) {
    const auto error = [&](double step) {
      return length(fly(p, launch, e, vacuum(integrator), {.step = step}, until).end().position - exact);
    };
    if (std::find(std::begin(kAdaptive), std::end(kAdaptive), integrator) != std::end(kAdaptive)) {
      EXPECT_LT(length(fly(p, launch, e, vacuum(integrator), {1e-11, 1e-11}, until).end().position - exact), 1e-8)
          << text(integrator);
      continue;
    }
    const double order = std::log2(error(1.0 / 256) / error(1.0 / 512));
    const double expected = integrator == Integrator::rk4 ? 4 : integrator == Integrator::heun ? 2 : 1;
    EXPECT_NEAR(order, expected, 0.25) << text(integrator);
  }
}

TEST(Field, a_force_that_grows_gives_a_cubic) {
  const Vec3d a0{0.3, -2, 5};
  Environment e = nothing();
  e.force = force_by([a0](double t, const Vec3d&, const Vec3d&, double m) { return a0 * (m * t); });
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    Fidelity f = vacuum(Integrator::rk4);
    f.precision = precision;
    const Flight flight = fly({.mass = 0.3}, {}, e, f, {.step = 1.0 / 64}, {.ground = {}, .time = 6});
    EXPECT_TRUE(near(flight.end().position, a0 * 36, precision == Precision::float64 ? 1e-13 : 1e-5));
    EXPECT_TRUE(near(flight.accelerations(2).applied, a0 * 2, 1e-6));
  }
}

TEST(Field, a_force_is_over_the_mass_that_is_left) {
  ProjectileDef rocket{
      .mass = 2, .diameter = 0.1, .length = 1, .motor = {.thrust = {{0, 100}, {2, 100}}, .propellant_mass = 1}};
  Environment e = nothing();
  e.force = [](const FieldForceBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i) b.force[i] = {0, 0, b.mass[i] * b.mass[i]};
  };
  const Flight flight = fly(rocket, {.speed = 10}, e, vacuum(), {}, {.ground = {}, .time = 4});
  for (const double t : {0.5, 1.5, 3.0})
    EXPECT_TRUE(near(flight.accelerations(t).applied, {0, 0, t < 2 ? 2 - 0.5 * t : 1}, 1e-12)) << t;
}

TEST(Field, it_adds_to_a_force_of_the_projectile) {
  ProjectileDef p{.mass = 4, .force = {8, 0, 0}};
  Environment e = nothing();
  e.force = force_by([](double, const Vec3d&, const Vec3d&, double) { return Vec3d{0, 4, 0}; });
  const Flight flight = fly(p, {}, e, vacuum(), {}, {.ground = {}, .time = 2});
  EXPECT_TRUE(near(flight.end().position, {4, 2, 0}, 1e-12));
  EXPECT_EQ(flight.accelerations(1).applied, (Vec3d{2, 1, 0}));
}

TEST(Field, planar_flight_takes_up_what_leads_out_of_it) {
  Fidelity f = vacuum();
  f.planar = true;
  Environment e = nothing();
  e.force = force_by([](double, const Vec3d&, const Vec3d&, double m) { return Vec3d{m, 0, m}; });
  const Flight flight = fly({}, {.speed = 1}, e, f, {}, {.ground = {}, .time = 2});
  EXPECT_TRUE(near(flight.end().position, {4, 0, 0}, 1e-12));
  EXPECT_TRUE(near(flight.accelerations(1).constraint, {0, 0, -1}, 1e-12));
}

// ------------------------------------------------------------------------------------------------ rungs
TEST(Field, what_a_rung_does_not_know_is_told) {
  Environment e{.wind = {.field = wind_by(swirl)}, .force = force_by(tug)};
  const auto noted = [&](const Fidelity& f, const char* effect, const char* reason) {
    bool found = false;
    for (const FidelityNote& note : grant(f, bullet_308(), e).notes)
      found = found || (note.effect == effect && note.reason.find(reason) != std::string::npos);
    return found;
  };
  EXPECT_FALSE(noted(Fidelity::simulation(), "wind", "function"));
  EXPECT_FALSE(noted(Fidelity::simulation(), "motion", "force"));
  EXPECT_EQ(grant(Fidelity::simulation(), bullet_308(), e).fidelity.wind, WindModel::profile);
  EXPECT_TRUE(noted(Fidelity::game(), "wind", "no other wind"));
  EXPECT_EQ(grant(Fidelity::game(), bullet_308(), e).fidelity.wind, WindModel::off);
  e.wind.velocity = {0, 0, 1};
  EXPECT_TRUE(noted(Fidelity::game(), "wind", "the environment's other wind"));
  EXPECT_EQ(grant(Fidelity::game(), bullet_308(), e).fidelity.wind, WindModel::constant);
  Fidelity closed = Fidelity::reference();
  closed.motion = Motion::closed_form;
  EXPECT_TRUE(noted(closed, "motion", "environment's force is left out"));
  EXPECT_TRUE(noted(closed, "wind", "closed form"));
  EXPECT_EQ(grant(closed, bullet_308(), e).fidelity.wind, WindModel::constant);
  closed.motion = Motion::velocity;
  EXPECT_TRUE(noted(closed, "motion", "environment's force is left out"));
}

TEST(Field, motions_without_forces_fly_as_without_one) {
  Environment e = constant_gravity(), pushed = e;
  pushed.force = force_by(tug);
  for (const Motion motion : {Motion::closed_form, Motion::velocity}) {
    Fidelity f = vacuum(Integrator::rk4);
    f.motion = motion;
    const Launch launch{.speed = 30, .elevation = 0.5};
    EXPECT_EQ(fly({}, launch, e, f, {.step = 0.01}).end().position,
              fly({}, launch, pushed, f, {.step = 0.01}).end().position);
  }
}

TEST(Field, one_shot_forces_of_the_original_are_those_at_the_launch) {
  Fidelity f = Fidelity::classic();
  f.motion = Motion::force;
  f.original_one_shot_forces = true;
  Environment field = nothing(), none = nothing();
  field.force = force_by([](double t, const Vec3d& x, const Vec3d&, double) { return Vec3d{3 + t, x.x, 0}; });
  ProjectileDef p{.mass = 1.5}, pushed = p;
  pushed.force = {3, 0, 0};
  const Until until{.ground = {}, .time = 1};
  const Vec3d by_field = fly(p, {}, field, f, {.step = 0.01}, until).end().position;
  EXPECT_GT(by_field.x, 0.5);
  EXPECT_TRUE(near(by_field, fly(pushed, {}, none, f, {.step = 0.01}, until).end().position, 1e-12));
}

TEST(Field, functions_are_equal_where_they_are_shared) {
  Environment a, b;
  EXPECT_EQ(a, b);
  a.wind.field = wind_by(swirl);
  b.wind.field = wind_by(swirl);
  EXPECT_FALSE(a == b) << "nobody knows what they do";
  b = a;
  EXPECT_EQ(a, b);
  b.force = force_by(tug);
  EXPECT_FALSE(a == b);
  EXPECT_FALSE(WindFunction(std::function<void(const WindBatch&)>()));
  EXPECT_FALSE(ForceFunction(static_cast<void (*)(const FieldForceBatch&)>(nullptr)));
}

TEST(Field, a_flight_keeps_its_functions) {
  Flight flight = [] {
    Environment e{.wind = {.field = wind_by(swirl)}, .force = force_by(tug)};
    Fidelity f = Fidelity::simulation();
    f.rotation = RotationModel::none;
    return fly(bullet_308(), {.speed = 800}, e, f, {}, {.ground = {}, .time = 1});
  }();
  const Vec3d v = flight.at(0.7).velocity, x = flight.at(0.7).position;
  EXPECT_TRUE(near(flight.accelerations(0.7).applied, tug(0.7, x, v, 1), 1e-12));
  const double mach = length(v - swirl(0.7, x)) / air_at(Environment{}, x.y)->sound_speed;
  EXPECT_TRUE(near(flight.at(0.7).mach, mach, 1e-9));
}

// ------------------------------------------------------------------------------------------------ batches
class FieldBatch : public testing::Test {
 protected:
  ~FieldBatch() override { use_kernel(""); }
};

std::vector<Shot> some_shots(unsigned count) {
  Random r(7);
  std::vector<Shot> shots;
  for (unsigned i = 0; i < count; ++i) {
    Shot shot{bullet_308(), {.position = r.vector(50), .speed = r.in(100, 900), .elevation = r.in(-0.1, 0.8)}};
    shot.projectile.mass *= r.in(0.5, 2);
    shots.push_back(shot);
  }
  return shots;
}

TEST_F(FieldBatch, gives_the_numbers_of_flights) {
  Environment e{.wind = {.field = wind_by(swirl)}, .force = force_by(tug)};
  const Until until{.ground = -100.0, .time = 8, .events = {{.kind = EventKind::mach, .value = 1}}};
  const auto shots = some_shots(37);
  for (const std::string& kernel : kernels())
    for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5, Integrator::dop853})
      for (const Precision precision : {Precision::float64, Precision::float32}) {
        ASSERT_TRUE(use_kernel(kernel));
        Fidelity f = Fidelity::simulation();
        f.integrator = integrator;
        f.precision = precision;
        const Tolerance tolerance{.step = 0.02};
        const BatchResult batch = fly_batch(shots, e, f, tolerance, until);
        std::size_t events = 0;
        for (unsigned i = 0; i < shots.size(); ++i) {
          const Flight flight = fly(shots[i].projectile, shots[i].launch, e, f, tolerance, until);
          ASSERT_EQ(flight.outcome(), batch.shots[i].outcome) << kernel << text(integrator) << i;
          ASSERT_TRUE(same_bits(flight.end().position, batch.shots[i].position)) << kernel << text(integrator) << i;
          ASSERT_TRUE(same_bits(flight.end().velocity, batch.shots[i].velocity)) << kernel << text(integrator) << i;
          for (const Event& event : flight.events()) events += event.kind == EventKind::mach ? 1 : 0;
        }
        std::size_t told = 0;
        for (const ShotEvent& event : batch.events) told += event.event.kind == EventKind::mach ? 1 : 0;
        EXPECT_EQ(told, events);
        EXPECT_GT(told, 10u);
      }
}

TEST_F(FieldBatch, a_mach_number_is_that_in_the_wind_of_the_moment) {
  Environment e{.wind = {.field = wind_by(swirl)}};
  const Until until{.ground = {}, .time = 6, .events = {{.kind = EventKind::mach, .value = 1, .terminal = true}}};
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;  // a drift that is added to the path has a speed of its own
  const Flight flight = fly(bullet_308(), {.speed = 600}, e, f, {}, until);
  ASSERT_EQ(flight.outcome(), Outcome::event);
  EXPECT_TRUE(near(flight.end().mach, 1, 1e-12));
}

// ------------------------------------------------------------------------------------------------ bad functions
TEST_F(FieldBatch, throwing_and_nan_end_the_flight_they_belong_to) {
  const auto wrong = [](double t, const Vec3d& x) { return t > 0.5 && x.z > 0; };
  Environment nan_wind, throwing_wind, nan_force, throwing_force, infinite_force, sound;
  nan_wind.wind.field = wind_by([=](double t, const Vec3d& x) {
    return wrong(t, x) ? Vec3d{kNan, 0, 0} : swirl(t, x);
  });
  throwing_wind.wind.field =
      wind_by([=](double t, const Vec3d& x) { return wrong(t, x) ? throw std::runtime_error("gust") : swirl(t, x); });
  sound.wind.field = wind_by(swirl);
  const auto on = [&](auto what) {
    return force_by([=](double t, const Vec3d& x, const Vec3d&, double) { return wrong(t, x) ? what() : Vec3d{}; });
  };
  nan_force.force = on([] { return Vec3d{0, kNan, 0}; });
  infinite_force.force = on([] { return Vec3d{0, kInfinity, 0}; });
  throwing_force.force = on([]() -> Vec3d { throw 7; });
  auto shots = some_shots(24);
  for (unsigned i = 0; i < shots.size(); ++i) shots[i].launch.position.z = i % 3 == 0 ? 500 : -500;
  const Until until{.ground = {}, .time = 2};
  for (const Environment* e : {&nan_wind, &throwing_wind, &nan_force, &infinite_force, &throwing_force})
    for (const Integrator integrator : kIntegrators)
      for (const Precision precision : {Precision::float64, Precision::float32}) {
        Fidelity f = integrator == Integrator::classic ? Fidelity::classic() : Fidelity::simulation();
        f.motion = Motion::force;
        f.drag = DragModel::equation;
        f.air = AirModel::isa;
        f.wind = WindModel::profile;
        f.integrator = integrator;
        f.precision = precision;
        const BatchResult batch = fly_batch(shots, *e, f, {.step = 0.01}, until);
        Environment fine = *e;
        fine.force = {};
        if (fine.wind.field) fine.wind = sound.wind;
        for (unsigned i = 0; i < shots.size(); ++i) {
          const Outcome outcome = batch.shots[i].outcome;
          const bool halts = is_adaptive(integrator) && outcome == Outcome::stalled;
          const Outcome expected = i % 3 != 0 ? Outcome::time_limit : halts ? Outcome::stalled : Outcome::non_finite;
          ASSERT_EQ(outcome, expected) << text(integrator) << ' ' << i;
          if (i > 4) continue;
          const auto alone = [&](const Environment& there) {
            return fly(shots[i].projectile, shots[i].launch, there, f, {.step = 0.01}, until);
          };
          ASSERT_EQ(alone(*e).outcome(), expected);
          if (i % 3 == 0) continue;
          ASSERT_TRUE(same_bits(batch.shots[i].position, alone(fine).end().position))
              << "its neighbours in a pack change nothing";
        }
      }
}

TEST(Field, wrong_from_the_start_ends_every_kind_of_body) {
  Environment nan;
  nan.wind.field = wind_by([](double, const Vec3d&) { return Vec3d{kNan, kNan, kNan}; });
  for (const RotationModel rotation :
       {RotationModel::none, RotationModel::magnus, RotationModel::modified_point_mass, RotationModel::rigid_body}) {
    ProjectileDef p = bullet_308();
    p.magnus.lift = 1;
    p.inertia.moments = {1e-7, 1e-6, 1e-6};
    p.aero.pitching = {{.value = 2.5}};
    Fidelity f = Fidelity::simulation();
    f.rotation = rotation;
    const Flight flight = fly(p, {.speed = 700}, nan, f, {}, {.ground = {}, .time = 1});
    EXPECT_EQ(flight.fidelity_in_use().fidelity.rotation, rotation);
    EXPECT_EQ(flight.outcome(), Outcome::non_finite) << name(rotation);
  }
}

// ------------------------------------------------------------------------------------------------ who flies many times
TEST(Field, a_pilots_step_keeps_the_error) {
  Environment e{.wind = {.field = wind_by(swirl)}, .force = force_by(tug)};
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  const Launch launch{.speed = 600, .elevation = 0.3};
  const Until until{.ground = {}, .time = 4};
  const Vec3d exact = fly(bullet_308(), launch, e, f, {1e-13, 1e-12}, until).end().position;
  for (const Integrator integrator : {Integrator::heun, Integrator::rk4}) {
    f.integrator = integrator;
    const Flight flight = fly(bullet_308(), launch, e, f, {.position_error = 1e-3}, until);
    EXPECT_LT(length(flight.end().position - exact), 1e-3) << text(integrator);
    EXPECT_LT(flight.cost().steps, 5000) << text(integrator);
  }
}

TEST(Field, a_zero_and_an_aim_hit_in_it) {
  Environment e;
  e.wind.field = wind_by([](double t, const Vec3d& x) { return Vec3d{0, 0, 6 * t + 0.01 * x.x}; });
  e.force = force_by([](double t, const Vec3d&, const Vec3d&, double m) { return Vec3d{0, 5 * t * m, 0}; });
  const Fidelity f = Fidelity::simulation();
  const auto elevation = must(zero_elevation(bullet_308(), {.speed = 800}, e, f, 400));
  const Flight zeroed =
      fly(bullet_308(), {.speed = 800, .elevation = elevation}, e, f, {}, {.ground = {}, .range = 400});
  EXPECT_LT(std::abs(zeroed.end().position.y), 1e-6);
  const Vec3d target{700, 20, 5};
  const auto aimed = must(aim(bullet_308(), {.speed = 800}, e, f, {.position = target}));
  ASSERT_TRUE(aimed.low.has_value());
  EXPECT_LT(aimed.low->miss, 1e-3);
  const Flight again = fly(bullet_308(), aimed.low->launch, e, f, {}, {.ground = {}, .time = aimed.low->time});
  EXPECT_LT(length(again.end().position - target), 2e-3);
}

TEST(Field, auto_fidelity_measures_against_it) {
  Environment calm, e;
  e.force = force_by([](double, const Vec3d&, const Vec3d&, double m) { return Vec3d{0, 0, 40 * m}; });
  const Launch launch{.position = {0, 50, 0}, .speed = 20};
  const Purpose purpose{.error = 0.05, .time = 1};
  const ProjectileDef p{.mass = 5, .diameter = 0.05};
  AutoFidelityCache cache;
  const auto without = must(cache.cheapest_within(p, launch, calm, purpose));
  EXPECT_EQ(without->fidelity.motion, Motion::closed_form);
  const auto with = must(cache.cheapest_within(p, launch, e, purpose));
  EXPECT_EQ(with->fidelity.motion, Motion::force) << "only it knows forces";
  EXPECT_EQ(cache.computed(), 2u);
  EXPECT_EQ(cache.cheapest_within(p, launch, e, purpose)->get(), with.get()) << "the same function, the same launch";
  EXPECT_EQ(cache.computed(), 2u);
  e.force = force_by([](double, const Vec3d&, const Vec3d&, double) { return Vec3d{}; });
  const auto another = must(cache.cheapest_within(p, launch, e, purpose));
  EXPECT_EQ(cache.computed(), 3u);
  EXPECT_EQ(another->fidelity.motion, Motion::closed_form);
}

}  // namespace physim::flight_field_test
