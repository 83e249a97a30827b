// What steps cost, counted by hand from the formulas in src/model: additions and multiplications are 1, the rest stands
// in model/ladder.hpp.
#include "prepare/fidelity_cost.hpp"

#include <gtest/gtest.h>

namespace physim::prepare_fidelity_cost_test {

double cost_of(const Fidelity& f, const ProjectileDef& p = {}, const Environment& e = {}) { return step_cost(f, p, e); }

/// The least there is: constant gravity, one number at a time.
Fidelity plain(Integrator integrator) {
  return {.integrator = integrator,
          .gravity = GravityModel::constant,
          .drag = DragModel::off,
          .air = AirModel::vacuum,
          .wind = WindModel::off,
          .earth = EarthModel::flat,
          .precision = Precision::float32};
}

TEST(FidelityCost, closed_forms) {
  Fidelity f = plain(Integrator::rk4);
  f.motion = Motion::closed_form;
  EXPECT_EQ(cost_of(f), 12) << "y + h y' of six numbers";
  f.drag = DragModel::damping;
  EXPECT_EQ(cost_of(f), 12 + (2 * 17 + 10) + 2 * 20) << "17 terms of a series, ten more, two exponentials";
  f.precision = Precision::float64;
  EXPECT_EQ(cost_of(f), 2 * 96);
}

TEST(FidelityCost, steps_of_integrators) {
  EXPECT_EQ(cost_of(plain(Integrator::semi_implicit_euler)), 1 + 12);
  // Four stages, three entries below the diagonal and four weights, of twelve operations each.
  EXPECT_EQ(cost_of(plain(Integrator::rk4)), 4 * 1 + 4 * 12 + (3 + 4) * 12);
  Fidelity turning = plain(Integrator::rk4);
  turning.rotation = RotationModel::rigid_body;
  EXPECT_NEAR(cost_of(turning), 4 * (1 + 110) + 13.0 / 6 * (4 * 12 + 7 * 12), 1e-12) << "13 numbers instead of 6";
}

TEST(FidelityCost, each_effect_adds_its_own_in_every_evaluation) {
  const Fidelity base = plain(Integrator::rk4);
  const auto adds = [&](const Fidelity& f, const ProjectileDef& p = {}, const Environment& e = {}) {
    return (cost_of(f, p, e) - cost_of(base)) / 4;
  };
  Fidelity f = base;
  f.planar = true;
  EXPECT_EQ(adds(f), 11);
  f = base, f.earth = EarthModel::flat_coriolis;
  EXPECT_EQ(adds(f), 15);
  f = base, f.earth = EarthModel::sphere;
  EXPECT_EQ(adds(f), 30 - 1) << "gravity to the centre of a sphere";
  f = base, f.earth = EarthModel::ellipsoid;
  EXPECT_EQ(adds(f), 3 - 1 + 170 + 15) << "down the vertical of the ellipsoid, which turns";
  f = base, f.drag = DragModel::damping;
  EXPECT_EQ(adds(f), 6);
  f.wind = WindModel::constant;
  EXPECT_EQ(adds(f), 6 + 3);
  f.earth = EarthModel::sphere;
  EXPECT_EQ(adds(f), 29 + 6 + 3 + 25 + 24) << "wind that turns with the vertical";
  f = base, f.drag = DragModel::damping, f.wind = WindModel::profile;
  Environment windy{.wind = {.profile = {{0, {}}, {10, {}}, {20, {}}}}};
  EXPECT_EQ(adds(f, {}, windy), 6 + 3 + 3 * 9);

  ProjectileDef pushed{.force = {1, 0, 0}};
  EXPECT_EQ(adds(base, pushed), 7);
  f = base, f.drag = DragModel::equation, f.air = AirModel::constant;
  const double by_curve = adds(f);
  ProjectileDef ball, banded;
  ball.drag.table = DragTable::sphere;
  banded.drag.bands = {{0, 300}, {500, 290}};
  EXPECT_EQ(adds(f, ball) - by_curve, 40 + 2 * 60) << "two powers";
  EXPECT_EQ(adds(f, banded) - by_curve, 2 * 2);
  f.air = AirModel::exponential;
  EXPECT_EQ(adds(f) - by_curve, 4 + 20);
  f.air = AirModel::isa;
  EXPECT_EQ(adds(f) - by_curve, 40);
  f.precision = Precision::float64;
  EXPECT_EQ((cost_of(f) / 2 - cost_of(base)) / 4 - by_curve, 50);
}

TEST(FidelityCost, motors_cost_where_they_fly) {
  ProjectileDef rocket{.motor = {.thrust = {{0, 10}, {1, 0}}, .propellant_mass = 0.01}};
  Fidelity f = plain(Integrator::rk4);
  EXPECT_EQ((cost_of(f, rocket) - cost_of(f)) / 4, 24 + 2 * 4);
}

}  // namespace physim::prepare_fidelity_cost_test
