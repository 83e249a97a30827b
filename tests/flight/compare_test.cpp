// compare(): flights of one shot beside a reference.
#include "must.hpp"
#include "physim/solve.hpp"

#include <cmath>

namespace physim::flight_compare_test {

const ProjectileDef kBall{
    .mass = 0.145, .diameter = 0.074, .drag = {.table = DragTable::constant, .coefficient = 0.35}};
const Launch kThrow{.position = {0, 2, 0}, .speed = 40, .elevation = 0.5};

FlightSetting setting(Integrator integrator, double step) {
  FlightSetting out{Fidelity::simulation(), {}};
  out.fidelity.integrator = integrator;
  out.tolerance.step = step;
  return out;
}

TEST(Compare, MeasuresTheDistancesOfTheFlights) {
  const FlightSetting settings[] = {setting(Integrator::explicit_euler, 0.02), setting(Integrator::rk4, 0.001)};
  std::size_t calls = 0;
  const auto compared = must(compare(kBall, kThrow, {}, settings, {Fidelity::reference(), kReferenceTolerance}, {},
                                     [&](std::size_t done, std::size_t total) {
                                       EXPECT_EQ(done, ++calls);
                                       EXPECT_EQ(total, 2U);
                                     }));
  EXPECT_EQ(calls, 2U);
  ASSERT_EQ(compared.flights.size(), 2U);
  const Flight alone = fly(kBall, compared.launch, {}, settings[0].fidelity, settings[0].tolerance);
  const ComparedFlight& coarse = compared.flights[0];
  EXPECT_EQ(coarse.flight.end().position, alone.end().position);
  EXPECT_EQ(coarse.end_distance, length(alone.end().position - compared.reference.end().position));
  EXPECT_EQ(coarse.end_delay, alone.duration() - compared.reference.duration());
  EXPECT_GT(coarse.end_distance, 0.1);
  EXPECT_GE(coarse.largest_distance, coarse.end_distance);
  EXPECT_LT(compared.flights[1].largest_distance, 1e-5);
}

TEST(Compare, TheReferenceIsNotOffFromItself) {
  const FlightSetting reference{Fidelity::reference(), kReferenceTolerance};
  const auto compared = must(compare(kBall, kThrow, {}, {&reference, 1}, reference));
  EXPECT_EQ(compared.flights[0].end_distance, 0);
  EXPECT_EQ(compared.flights[0].largest_distance, 0);
  EXPECT_EQ(compared.flights[0].end_delay, 0);
}

TEST(Compare, AllStartAlongTheBoreOfTheReference) {
  Launch zeroed{.speed = 800, .sight = {.height = 0.05, .zero_range = 100}};
  FlightSetting no_drag{Fidelity::simulation(), {}};
  no_drag.fidelity.drag = DragModel::off;  // would find another zero
  const auto compared = must(compare(kBall, zeroed, {}, {&no_drag, 1}));
  EXPECT_EQ(compared.flights[0].flight.at(0).velocity, compared.reference.at(0).velocity);
  EXPECT_GT(compared.reference.at(0).velocity.y, 0);
}

TEST(Compare, WhatHasLandedStaysWhereItLanded) {
  FlightSetting short_one{Fidelity::simulation(), {}}, long_one = short_one;
  long_one.fidelity.drag = DragModel::off;
  const auto compared = must(compare(kBall, kThrow, {}, {&long_one, 1}, short_one));
  const ComparedFlight& far = compared.flights[0];
  EXPECT_GT(far.end_delay, 0);
  EXPECT_NEAR(far.largest_distance, far.end_distance, 1e-9) << "the last of the samples is the later landing";
}

TEST(Compare, SaysWhatCannotBeMeasured) {
  FlightSetting stuck = setting(Integrator::rk4, 0.001);
  stuck.tolerance.max_steps = 3;
  FlightSetting bad = stuck;
  bad.tolerance.step = NAN;
  const FlightSetting settings[] = {stuck, bad};
  const auto compared = must(compare(kBall, kThrow, {}, settings));
  EXPECT_EQ(compared.flights[0].problem, "its flight ended with step_limit");
  EXPECT_FALSE(compared.flights[1].problem.empty());

  const auto endless = compare(kBall, kThrow, {}, {}, stuck);
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().message, "the reference flight ended with step_limit");
  const auto refused = compare({.mass = -1}, kThrow, {}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "projectile.mass");
}

}  // namespace physim::flight_compare_test
