// What of an asked fidelity is granted, and that it is told why where it is less.
#include <gtest/gtest.h>

#include "model/ladder.hpp"
#include "support.hpp"

namespace physim {
namespace prepare_grant_test {

using namespace test;

struct Asked {
  Fidelity fidelity = Fidelity::simulation();
  ProjectileDef projectile = bullet_308();
  Environment environment;
  Asked() { environment.wind.profile = {{0, {1, 0, 0}}, {100, {2, 0, 0}}}; }
};

/// Grants, and checks that every field that changed has exactly one note saying from what to what, and why.
FidelityInUse granted(const Asked& asked) {
  const FidelityInUse in_use = grant(asked.fidelity, asked.projectile, asked.environment);
  const Flight flight = fly(asked.projectile, {.speed = 100, .elevation = 0.2}, asked.environment, asked.fidelity,
                            {.step = 0.01}, {.time = 1});
  EXPECT_EQ(flight.fidelity_in_use().fidelity, in_use.fidelity);
  for (const FidelityNote& note : in_use.notes) EXPECT_FALSE(note.reason.empty()) << note.effect;
  return in_use;
}

/// The last note about an effect; empty where there is none.
FidelityNote note_of(const FidelityInUse& in_use, const std::string& effect) {
  FidelityNote found;
  for (const FidelityNote& note : in_use.notes)
    if (note.effect == effect) found = note;
  return found;
}

TEST(Grant, what_can_be_honoured_is_granted_without_a_word) {
  const Asked asked;
  const FidelityInUse in_use = granted(asked);
  EXPECT_EQ(in_use.fidelity, asked.fidelity);
  EXPECT_TRUE(in_use.notes.empty());
}

TEST(Grant, the_environment_limits_gravity_and_air) {
  Asked asked;
  asked.environment.gravity.model = GravityModel::constant;
  asked.environment.atmosphere.model = AirModel::exponential;
  const FidelityInUse in_use = granted(asked);
  EXPECT_EQ(in_use.fidelity.gravity, GravityModel::constant);
  EXPECT_EQ(note_of(in_use, "gravity").asked, "inverse_square");
  EXPECT_EQ(note_of(in_use, "gravity").granted, "constant");
  EXPECT_EQ(in_use.fidelity.air, AirModel::exponential);
  EXPECT_EQ(note_of(in_use, "air").granted, "exponential");
}

TEST(Grant, where_there_is_nothing_to_model_nothing_is_lost_and_nothing_said) {
  Asked asked;
  asked.environment.wind = {.velocity = {0, 0, 3}};
  EXPECT_EQ(granted(asked).fidelity.wind, WindModel::constant);
  EXPECT_TRUE(granted(asked).notes.empty());
  asked.environment.wind = {};
  EXPECT_EQ(granted(asked).fidelity.wind, WindModel::off);
  EXPECT_TRUE(granted(asked).notes.empty());
}

TEST(Grant, spin_drift_without_a_twist_is_none_and_says_so) {
  Asked asked;
  asked.projectile.twist = 0;
  EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::none);
  ASSERT_EQ(granted(asked).notes.size(), 1U);
  EXPECT_EQ(granted(asked).notes[0].effect, "rotation");
}

TEST(Grant, the_drag_equation_needs_air) {
  Asked asked;
  asked.environment.atmosphere.model = AirModel::vacuum;
  EXPECT_EQ(granted(asked).fidelity.drag, DragModel::off);
  asked = {};
  asked.fidelity.air = AirModel::vacuum;
  EXPECT_EQ(granted(asked).fidelity.drag, DragModel::off);
  EXPECT_EQ(note_of(granted(asked), "drag").reason, "there is no air");
  asked.fidelity.drag = DragModel::linear_quadratic;
  asked.projectile.drag.k1 = 1;
  EXPECT_EQ(granted(asked).fidelity.drag, DragModel::linear_quadratic);
}

TEST(Grant, the_flattened_field_goes_with_the_ellipsoid) {
  Asked asked;
  asked.fidelity.earth = EarthModel::ellipsoid;
  for (const GravityModel gravity : {GravityModel::j2, GravityModel::wgs84}) {
    asked.fidelity.gravity = gravity;
    EXPECT_EQ(granted(asked).fidelity, asked.fidelity);
    EXPECT_TRUE(granted(asked).notes.empty());
  }
  asked.fidelity.earth = EarthModel::sphere_rotating;
  EXPECT_EQ(granted(asked).fidelity.gravity, GravityModel::inverse_square);
  EXPECT_NE(granted(asked).notes.front().reason.find("spherical"), std::string::npos);
  EXPECT_NE(granted(asked).notes.back().reason.find("centrifugal"), std::string::npos) << "the Earth's own GM";
  asked.fidelity.earth = EarthModel::flat_coriolis;
  EXPECT_EQ(granted(asked).fidelity.gravity, GravityModel::wgs84);
  EXPECT_NE(note_of(granted(asked), "gravity").reason.find("weight at the origin's latitude"), std::string::npos);
}

TEST(Grant, a_gravity_of_its_own_keeps_an_environment_from_the_earths_field) {
  Asked asked;
  asked.fidelity.earth = EarthModel::ellipsoid;
  asked.fidelity.gravity = GravityModel::wgs84;
  asked.environment.gravity.acceleration = 1.62;
  EXPECT_EQ(granted(asked).fidelity.gravity, GravityModel::inverse_square);
  EXPECT_EQ(granted(asked).notes.size(), 1U);
  asked.environment.gravity = {.radius = 1737e3};
  EXPECT_EQ(granted(asked).fidelity.gravity, GravityModel::inverse_square);
  asked.environment.gravity = {.model = GravityModel::constant};
  EXPECT_EQ(granted(asked).fidelity.gravity, GravityModel::constant);
}

TEST(Grant, closed_forms_know_constants_only) {
  Asked asked;
  asked.fidelity.motion = Motion::closed_form;
  FidelityInUse in_use = granted(asked);
  EXPECT_EQ(in_use.fidelity.motion, Motion::closed_form);
  EXPECT_EQ(in_use.fidelity.drag, DragModel::off);
  EXPECT_EQ(in_use.fidelity.gravity, GravityModel::constant);
  EXPECT_EQ(in_use.fidelity.earth, EarthModel::flat);
  EXPECT_EQ(in_use.fidelity.wind, WindModel::constant);
  for (const char* effect : {"drag", "gravity", "earth", "wind"})
    EXPECT_FALSE(note_of(in_use, effect).reason.empty()) << effect;
  asked.projectile.drag.damping = 0.9;
  EXPECT_EQ(granted(asked).fidelity.drag, DragModel::damping) << "the drag that a closed form can have";
  asked.fidelity.drag = DragModel::linear_quadratic;
  asked.projectile.drag.k1 = 0.1;
  EXPECT_EQ(granted(asked).fidelity.drag, DragModel::linear_quadratic) << "k2 is zero: drag is linear";
  asked.projectile.drag.k2 = 0.1;
  EXPECT_EQ(granted(asked).fidelity.drag, DragModel::damping);
  asked.fidelity.gravity = GravityModel::off;
  EXPECT_EQ(granted(asked).fidelity.gravity, GravityModel::off) << "lower than the limit is fine";
}

TEST(Grant, motion_velocity_knows_no_forces) {
  Asked asked;
  asked.fidelity.motion = Motion::velocity;
  const FidelityInUse in_use = granted(asked);
  EXPECT_EQ(in_use.fidelity.drag, DragModel::damping);
  EXPECT_EQ(in_use.fidelity.gravity, GravityModel::constant);
  EXPECT_EQ(in_use.fidelity.earth, EarthModel::flat);
}

TEST(Grant, the_original_loop_knows_constant_gravity_over_a_flat_earth) {
  Asked asked;
  asked.fidelity.integrator = Integrator::classic;
  const FidelityInUse in_use = granted(asked);
  EXPECT_EQ(in_use.fidelity.gravity, GravityModel::constant);
  EXPECT_EQ(in_use.fidelity.earth, EarthModel::flat);
  EXPECT_NE(note_of(in_use, "earth").reason.find("original"), std::string::npos);
}

TEST(Grant, one_shot_forces_are_the_original_loops) {
  Asked asked;
  asked.fidelity.original_one_shot_forces = true;
  EXPECT_FALSE(granted(asked).fidelity.original_one_shot_forces);
  EXPECT_EQ(note_of(granted(asked), "original_one_shot_forces").granted, "false");
  asked.fidelity.integrator = Integrator::classic;
  EXPECT_TRUE(granted(asked).fidelity.original_one_shot_forces);
}

TEST(Grant, spin_drift_needs_the_length) {
  Asked asked;
  asked.projectile.length = 0;
  EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::none);
  EXPECT_NE(note_of(granted(asked), "rotation").reason.find("length"), std::string::npos);
}

TEST(Grant, aerodynamic_jump_goes_with_spin_drift) {
  Asked asked;
  asked.fidelity.rotation = RotationModel::spin_drift;
  asked.fidelity.aerodynamic_jump = true;
  EXPECT_TRUE(granted(asked).fidelity.aerodynamic_jump);
  asked.fidelity.rotation = RotationModel::none;
  EXPECT_FALSE(granted(asked).fidelity.aerodynamic_jump);
  EXPECT_NE(note_of(granted(asked), "aerodynamic_jump").reason.find("spin drift"), std::string::npos);
  asked.projectile.twist = 0;  // without spin nothing is lost
  EXPECT_FALSE(granted(asked).fidelity.aerodynamic_jump);
  EXPECT_TRUE(note_of(granted(asked), "aerodynamic_jump").reason.empty());
}

TEST(Grant, a_planar_flight_does_not_drift_sideways) {
  Asked asked;
  asked.fidelity.planar = true;
  EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::none);
  EXPECT_NE(note_of(granted(asked), "rotation").reason.find("plane"), std::string::npos);
}

TEST(Grant, missing_k1_and_k2_are_told) {
  Asked asked;
  asked.fidelity.drag = DragModel::linear_quadratic;
  EXPECT_NE(note_of(granted(asked), "drag").reason.find("taken from the drag equation"), std::string::npos);
  asked.projectile.drag.k2 = 1e-5;
  EXPECT_TRUE(note_of(granted(asked), "drag").reason.empty());
}

TEST(Grant, never_raises_a_rung) {
  for (const std::string_view preset : fidelity_presets()) {
    Asked asked;
    asked.fidelity = *fidelity_preset(preset);
    const Fidelity f = granted(asked).fidelity;
    EXPECT_LE(level(f.gravity), level(asked.fidelity.gravity)) << preset;
    EXPECT_LE(level(f.air), level(asked.fidelity.air)) << preset;
    EXPECT_LE(level(f.wind), level(asked.fidelity.wind)) << preset;
    EXPECT_LE(level(f.earth), level(asked.fidelity.earth)) << preset;
    EXPECT_LE(level(f.rotation), level(asked.fidelity.rotation)) << preset;
    EXPECT_EQ(f.integrator, asked.fidelity.integrator) << preset;
    EXPECT_EQ(f.precision, asked.fidelity.precision) << preset;
  }
}

TEST(Grant, fidelity_changes_how_and_data_stay) {
  // Only the rung differs between these two lines; the data of the bullet are those of the first flight.
  const ProjectileDef p = bullet_308();
  const double game = fly(p, {.speed = 800, .elevation = 0.02}, {}, Fidelity::game()).end().range;
  const double simulation = fly(p, {.speed = 800, .elevation = 0.02}, {}, Fidelity::simulation()).end().range;
  EXPECT_GT(game, 500);
  EXPECT_NE(game, simulation);
  EXPECT_NEAR(game, simulation, 0.4 * simulation);
}

}  // namespace prepare_grant_test
}  // namespace physim
