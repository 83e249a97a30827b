// What of an asked fidelity is granted, and that it is told why where it is less.
#include "model/ladder.hpp"
#include "support.hpp"

namespace physim::prepare_grant_test {

using namespace test;

struct Asked {
  Fidelity fidelity = Fidelity::simulation();
  ProjectileDef projectile = bullet_308();
  Environment environment;
  Asked() {
    fidelity.rotation = RotationModel::spin_drift;
    environment.wind.profile = {{0, {1, 0, 0}}, {100, {2, 0, 0}}};
  }
};

/// Grants, and checks that every field that changed has exactly one note saying from what to what, and why.
FidelityInUse granted(const Asked& asked) {
  const FidelityInUse in_use = grant(by_steps(asked.fidelity, true), asked.projectile, asked.environment);
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
  Asked asked;
  asked.fidelity.integrator = Integrator::rk43;
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
  asked.fidelity.integrator = Integrator::rk43;
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
    const Integrator i = asked.fidelity.integrator;
    EXPECT_EQ(f.integrator, i == Integrator::automatic  ? Integrator::semi_implicit_euler
                            : i == Integrator::adaptive ? Integrator::rk43
                                                        : i)
        << preset;
    EXPECT_EQ(f.precision, asked.fidelity.precision) << preset;
  }
}

/// A spinning bullet with the coefficients that a yaw of repose needs.
ProjectileDef shell() {
  ProjectileDef p = bullet_308();
  p.inertia.moments = {7e-8, 6e-7, 6e-7};
  p.aero.lift = {{0, 0, 1.6}, {2.5, 0, 2.5}};
  p.aero.pitching = {{0, 0, 3.5}, {2.5, 0, 3.7}};
  return p;
}

TEST(Grant, an_automatic_rotation_is_the_truest_that_the_data_allow) {
  struct Case {
    const char* what;
    ProjectileDef projectile;
    RotationModel of_points, of_all;
  };
  ProjectileDef smooth = bullet_308();
  smooth.twist = 0;
  ProjectileDef short_of_length = bullet_308();
  short_of_length.length = 0;
  ProjectileDef brick = smooth;  // turns, but the air does nothing to it
  brick.inertia.moments = {2e-7, 3e-7, 4e-7};
  ProjectileDef finned = shell();  // no twist: a point of it has no yaw of repose
  finned.twist = 0;
  ProjectileDef spun = shell();
  spun.magnus.lift = 0.3;
  using enum RotationModel;
  const Case cases[] = {{"ball with lift", presets::golf_ball().projectile, magnus, magnus},
                        {"bullet with a twist", bullet_308(), spin_drift, spin_drift},
                        {"bullet without length", short_of_length, none, none},
                        {"bullet without twist", smooth, none, none},
                        {"shell with coefficients", shell(), modified_point_mass, rigid_body},
                        {"shell with lift by spin, too", spun, modified_point_mass, rigid_body},
                        {"finned body with coefficients", finned, none, rigid_body},
                        {"body without coefficients", brick, none, none}};
  for (const Case& each : cases) {
    Asked asked;
    asked.projectile = each.projectile;
    for (const RotationModel choice : {automatic_point, automatic}) {
      asked.fidelity.rotation = choice;
      const RotationModel expected = choice == automatic ? each.of_all : each.of_points;
      const FidelityInUse in_use = granted(asked);
      EXPECT_EQ(in_use.fidelity.rotation, expected) << each.what << ", " << name(choice);
      const FidelityNote note = note_of(in_use, "rotation");
      if (expected != none) {
        EXPECT_EQ(note.asked + " " + note.granted, std::string(name(choice)) + " " + std::string(name(expected)));
      }
      // What is chosen is granted without a word where it is asked for by name.
      asked.fidelity.rotation = expected;
      EXPECT_EQ(granted(asked).fidelity.rotation, expected) << each.what;
    }
  }
}

TEST(Grant, an_automatic_rotation_of_what_knows_no_lift_is_none) {
  Asked asked;
  asked.projectile = presets::golf_ball().projectile;
  asked.fidelity.rotation = RotationModel::automatic;
  asked.fidelity.drag = DragModel::linear_quadratic;
  EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::magnus) << "a drag force by k1 and k2";
  for (const DragModel drag : {DragModel::off, DragModel::damping}) {
    asked.fidelity.drag = drag;
    EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::none);
  }
  asked.fidelity = Fidelity::simulation();
  asked.fidelity.motion = Motion::velocity;
  EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::none);
  asked.fidelity = Fidelity::simulation();
  asked.environment.atmosphere.model = AirModel::vacuum;
  EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::none);
  asked = {};
  asked.projectile = shell();
  asked.fidelity = Fidelity::simulation();
  asked.fidelity.planar = true;
  EXPECT_EQ(granted(asked).fidelity.rotation, RotationModel::none);
}

TEST(Grant, an_automatic_integrator_chooses_its_steps_in_flights_and_takes_frames_in_worlds) {
  const ProjectileDef bullet = bullet_308();
  const Launch launch{.position = {0, 1.5, 0}, .speed = 800, .elevation = 0.01};
  Fidelity by_name = Fidelity::game();
  by_name.integrator = Integrator::rk43;
  const Flight automatic = fly(bullet, launch, {}, Fidelity::game()), named = fly(bullet, launch, {}, by_name);
  EXPECT_EQ(automatic.fidelity_in_use().fidelity.integrator, Integrator::rk43);
  EXPECT_EQ(automatic.end().position, named.end().position);
  const Flight framed = fly(bullet, launch, {}, Fidelity::game(), {.step = 1.0 / 60});
  EXPECT_EQ(framed.fidelity_in_use().fidelity.integrator, Integrator::semi_implicit_euler) << "a step is given";

  World world;
  ProjectileDef kind = bullet;
  kind.fidelity = Fidelity::game();
  const auto first = world.spawn(kind, launch);
  kind.fidelity.integrator = Integrator::semi_implicit_euler;
  const auto second = world.spawn(kind, launch);
  ASSERT_TRUE(first && second);
  for (int i = 0; i < 20; ++i) world.step(1.0 / 60);
  EXPECT_EQ(world[*first].fidelity_in_use().fidelity.integrator, Integrator::semi_implicit_euler);
  EXPECT_EQ(world[*first].position(), world[*second].position());
}

TEST(Grant, an_adaptive_integrator_is_chosen_by_what_turns) {
  Asked asked;
  asked.projectile = shell();
  for (const Integrator integrator : {Integrator::automatic, Integrator::adaptive}) {
    asked.fidelity = Fidelity::simulation();
    asked.fidelity.integrator = integrator;
    EXPECT_EQ(grant(asked.fidelity, asked.projectile, {}).fidelity.integrator, Integrator::tsit5) << "a body";
    asked.fidelity.rotation = RotationModel::modified_point_mass;
    EXPECT_EQ(grant(asked.fidelity, asked.projectile, {}).fidelity.integrator, Integrator::rk43) << "its mean attitude";
    asked.fidelity.rotation = RotationModel::none;
    EXPECT_EQ(grant(asked.fidelity, asked.projectile, {}).fidelity.integrator, Integrator::rk43) << "a point";
  }
}

// At the same tolerance the order that a body gets takes fewer evaluations than that of points.
TEST(Grant, the_integrator_of_bodies_pays) {
  ProjectileDef body = shell();
  body.inertia.moments = {7e-8, 6e-7, 6e-7};
  const Launch launch{.speed = 800, .elevation = 0.05, .attitude = {.rates = {0, 0, 0.5}}};
  struct End {
    Vec3d position;
    std::int64_t evaluations;
  };
  const auto fly_by = [&](Integrator integrator, std::optional<double> tolerance) {
    Fidelity fidelity = Fidelity::simulation();
    fidelity.integrator = integrator;
    const Flight flight =
        fly(body, launch, {}, fidelity, {.relative = tolerance, .absolute = tolerance}, {.time = 0.5});
    EXPECT_FALSE(flight.error());
    EXPECT_EQ(flight.fidelity_in_use().fidelity.rotation, RotationModel::rigid_body);
    return End{flight.end().position, flight.cost().evaluations};
  };
  const End best = fly_by(Integrator::dop853, 1e-14), chosen = fly_by(Integrator::adaptive, {}),
            of_points = fly_by(Integrator::rk43, {});
  EXPECT_LT(static_cast<double>(chosen.evaluations), 0.8 * static_cast<double>(of_points.evaluations));
  EXPECT_LT(length(chosen.position - best.position), 1e-6);
}

TEST(Grant, a_tolerance_of_a_fidelity_stands_in_where_none_is_given) {
  const ProjectileDef bullet = bullet_308();
  const Launch launch{.speed = 800, .elevation = 0.1};
  Fidelity fidelity = Fidelity::simulation();
  fidelity.tolerance = 1e-5;
  Fidelity usual = fidelity;
  usual.tolerance = 0;
  const auto end = [&](const Fidelity& f, const Tolerance& tolerance) {
    return fly(bullet, launch, {}, f, tolerance).end().position;
  };
  EXPECT_EQ(end(fidelity, {}), end(usual, {.relative = 1e-5}));
  EXPECT_EQ(end(fidelity, {.relative = 1e-7}), end(usual, {.relative = 1e-7})) << "the call's own comes first";
  EXPECT_EQ(end(usual, {}), end(usual, {.relative = 1e-9}));
  EXPECT_NE(end(fidelity, {}), end(usual, {}));
  fidelity.precision = usual.precision = Precision::float32;
  fidelity.tolerance = 1e-12;
  EXPECT_EQ(end(fidelity, {}), end(usual, {})) << "what float32 can keep";
  for (const double bad : {-1.0, kNan}) {
    fidelity.tolerance = bad;
    const Flight flight = fly(bullet, launch, {}, fidelity);
    ASSERT_TRUE(flight.error()) << bad;
    EXPECT_EQ(flight.error()->place, "fidelity.tolerance");
  }
}

TEST(Grant, what_starts_at_rest_in_the_air_has_drag_by_k2_too) {
  ProjectileDef ball = presets::baseball().projectile;
  const Launch drop{.position = {0, 100, 0}};
  Environment air{.atmosphere = {.model = AirModel::constant}};
  const double in_vacuum = fly(ball, drop, air, Fidelity::arcade()).duration();
  const double in_air = fly(ball, drop, air, Fidelity::constant_air()).duration();
  const double in_game = fly(ball, drop, air, Fidelity::game()).duration();
  EXPECT_GT(in_air - in_vacuum, 0.1);
  EXPECT_NEAR(in_game, in_air, 0.2 * (in_air - in_vacuum));
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

}  // namespace physim::prepare_grant_test
