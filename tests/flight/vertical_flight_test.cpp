// Flights straight up, straight down, from rest and nearly vertical, compared along the whole path with a flight that
// is close to exact. The first users' case: a shuttlecock dropped from 30 m landed with 2.7 m/s, silently.
#include <array>
#include <cstdlib>
#include <random>

#include "support.hpp"

namespace physim::test::flight_vertical_flight_test {

/// Of each kind of flight; PHYSIM_BODIES=1000 takes some minutes.
const int kBodies = std::getenv("PHYSIM_BODIES") != nullptr ? std::atoi(std::getenv("PHYSIM_BODIES")) : 40;

ProjectileDef shuttlecock() {
  ProjectileDef p;  // terminal speed 6.8 m/s in air of 1.225 kg/m^3
  p.mass = 0.0052;
  p.diameter = 0.068;
  p.drag = {.table = DragTable::constant, .coefficient = 2 * 0.0052 * 9.80665 / (1.225 * 0.00363168 * 6.8 * 6.8)};
  return p;
}

struct Shot {
  ProjectileDef projectile;
  Launch launch;
};

/// A body of any size and weight, as users ask for; `way` counts through up, down, rest and 89.9 degrees.
Shot random_shot(std::mt19937_64& random, int way) {
  const auto between = [&](double low, double high) {  // evenly in the logarithm
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
  };
  Shot shot{.projectile = {.diameter = between(0.003, 0.2)}};
  shot.projectile.mass = std::pow(shot.projectile.diameter, 3) * between(20, 6000);
  constexpr std::array tables{DragTable::constant, DragTable::g1, DragTable::g7, DragTable::sphere};
  shot.projectile.drag.table = tables[random() % tables.size()];
  if (shot.projectile.drag.table == DragTable::constant) shot.projectile.drag.coefficient = between(0.1, 1.5);
  const double speed = between(5, 1200);
  shot.launch.position.y = way == 0 || way == 3 ? 1 : between(10, 3000);
  shot.launch.velocity = Vec3d{0, way == 1 ? -speed : speed, 0};
  if (way == 2) shot.launch.velocity = Vec3d{};
  if (way == 3) shot.launch.velocity = Vec3d{speed * std::cos(89.9 * kDegree), speed * std::sin(89.9 * kDegree), 0};
  return shot;
}

/// How a flight differs from another along its whole path.
struct Difference {
  double place = 0;    // largest at equal times [m]
  double time = 0;     // of flight [s]
  double fastest = 0;  // speed of the reference [m/s]
  double path = 0;     // length of the reference [m]
};
Difference between(const Flight& flight, const Flight& reference) {
  Difference d;
  d.time = std::abs(flight.duration() - reference.duration());
  const double common = std::min(flight.duration(), reference.duration());
  constexpr int kTimes = 500;
  Vec3d before = reference.at(0).position;
  for (int i = 0; i <= kTimes; ++i) {
    const double part = static_cast<double>(i) / kTimes;
    for (const double time : {common * part, common * part * part * part}) {  // closest at the start, too
      const double apart = length(flight.at(time).position - reference.at(time).position);
      d.place = apart >= d.place ? apart : (apart == apart ? d.place : kInfinity);
    }
    const Sample there = reference.at(common * part);
    d.fastest = std::max(d.fastest, length(there.velocity));
    d.path += length(there.position - before);
    before = there.position;
  }
  return d;
}

/// A flight close to exact on the models that another was granted.
Flight exact_for(const Shot& shot, const Flight& flight) {
  Fidelity f = flight.fidelity_in_use().fidelity;
  f.integrator = Integrator::dop853;
  f.precision = Precision::float64;
  return fly(shot.projectile, shot.launch, {}, f, {1e-13, 1e-13});
}

/// Whether it says itself how near it came.
bool tells_its_error(const Flight& flight) {
  return std::ranges::any_of(flight.fidelity_in_use().notes,
                             [](const FidelityNote& note) { return note.effect == "tolerance.position_error"; });
}

Flight fly_as(const Shot& shot, Integrator integrator, Precision precision, const Tolerance& tolerance) {
  Fidelity f = Fidelity::simulation();
  f.integrator = integrator;
  f.precision = precision;
  return fly(shot.projectile, shot.launch, {}, f, tolerance);
}

TEST(VerticalFlight, a_dropped_shuttlecock_lands_at_its_terminal_speed) {
  const Shot drop{shuttlecock(), {.position = {0, 30, 0}, .velocity = Vec3d{}}};
  for (const Integrator integrator : {Integrator::heun, Integrator::rk4}) {
    Fidelity f = Fidelity::simulation();
    f.integrator = integrator;
    f.air = AirModel::constant;
    const Flight flight = fly(drop.projectile, drop.launch, {}, f);
    ASSERT_FALSE(flight.error()) << flight.error()->text();
    // v = vt tanh(g t / vt), y = vt^2 / g ln cosh(g t / vt)
    const double vt = 6.8, g = 9.80665, t = std::acosh(std::exp(30 * g / (vt * vt))) * vt / g;
    EXPECT_NEAR(flight.duration(), t, 0.001 / vt) << text(integrator);
    EXPECT_NEAR(-flight.end().velocity.y, vt * std::tanh(g * t / vt), 1e-3) << text(integrator);
  }
}

TEST(VerticalFlight, fixed_steps_keep_the_error_along_the_whole_path) {
  std::mt19937_64 random(20260101);
  int told = 0;
  for (int i = 0; i < kBodies; ++i) {
    const Shot shot = random_shot(random, i % 4);
    for (const Integrator integrator : {Integrator::heun, Integrator::rk4}) {
      const Flight flight = fly_as(shot, integrator, Precision::float64, {});
      ASSERT_FALSE(flight.error()) << i << ' ' << flight.error()->text();
      if (tells_its_error(flight)) {
        ++told;
        continue;
      }
      const Flight exact = exact_for(shot, flight);
      ASSERT_EQ(flight.outcome(), exact.outcome()) << i;
      const Difference d = between(flight, exact);
      EXPECT_LE(d.place, 1e-3) << i << ' ' << text(integrator) << " step " << flight.step();
      EXPECT_LE(d.time, 1e-3 / d.fastest) << i << ' ' << text(integrator) << " step " << flight.step();
    }
  }
  EXPECT_LE(told, kBodies / 20) << "of two flights each: light things thrown so fast that a million steps are too few";
}

TEST(VerticalFlight, adaptive_steps_at_the_default_tolerance_stay_near) {
  std::mt19937_64 random(20260102);
  for (int i = 0; i < kBodies; ++i) {
    const Shot shot = random_shot(random, i % 4);
    const Flight exact = fly_as(shot, Integrator::dop853, Precision::float64, {1e-13, 1e-13});
    for (const Integrator integrator : {Integrator::rk43, Integrator::tsit5, Integrator::dop853})
      for (const auto& [precision, part] : {std::pair{Precision::float64, 1e-5}, {Precision::float32, 3e-5}}) {
        const Flight flight = fly_as(shot, integrator, precision, {});
        ASSERT_FALSE(flight.error()) << i << ' ' << flight.error()->text();
        ASSERT_EQ(flight.outcome(), exact.outcome()) << i;
        const Difference d = between(flight, exact);
        EXPECT_LE(d.place, part * d.path) << i << ' ' << text(integrator) << ' ' << name(precision);
      }
  }
}

TEST(VerticalFlight, frames_stay_bounded_and_halve_their_error_with_the_step) {
  std::mt19937_64 random(20260103);
  for (int i = 0; i < kBodies; ++i) {
    const Shot shot = random_shot(random, i % 4);
    for (const Integrator integrator :
         {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::classic}) {
      const Flight flight = fly_as(shot, integrator, Precision::float64, {});
      const Flight exact = exact_for(shot, flight);
      const double fastest = between(exact, exact).fastest;
      ASSERT_EQ(flight.outcome(), exact.outcome()) << i << ' ' << text(integrator) << " step " << flight.step();
      const Difference whole = between(flight, exact);
      for (int k = 0; k <= 200; ++k)
        ASSERT_LE(length(flight.at(flight.duration() * k / 200).velocity), 1.05 * fastest + 1)
            << i << ' ' << text(integrator) << " step " << flight.step();
      const auto error_at = [&](double step) {
        return between(fly_as(shot, integrator, Precision::float64, {.step = step}), exact).place;
      };
      const double step = std::min(flight.step() / 16, flight.duration() / 200);
      const double ratio = error_at(step) / error_at(step / 2);
      EXPECT_GT(ratio, 1.7) << i << ' ' << text(integrator) << " step " << step << " auto " << whole.place;
      EXPECT_LT(ratio, 2.3) << i << ' ' << text(integrator) << " step " << step;
    }
  }
}

}  // namespace physim::test::flight_vertical_flight_test
