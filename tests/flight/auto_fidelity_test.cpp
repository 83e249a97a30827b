// Auto fidelity: what is chosen keeps its word when it is measured here, by other means than it was chosen with.
#include <set>

#include "model/ladder.hpp"
#include "support.hpp"

namespace physim::flight_auto_fidelity_test {

using namespace test;

struct Case {
  std::string what;
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  double time;
  std::optional<double> ground;
};

Environment windy() {
  return {.wind = {.velocity = {1, 0, -3}}, .earth = {.latitude = 45 * test::kDegree, .azimuth = 90 * test::kDegree}};
}

Environment nothing_but_weight() {
  Environment environment = constant_gravity();
  environment.atmosphere.model = AirModel::vacuum;
  environment.earth.rotation_rate = 0;
  return environment;
}

ProjectileDef shell() {
  return {.mass = 43, .diameter = 0.155, .length = 0.8, .twist = 3.1, .drag = {.table = DragTable::g7}};
}

/// Creeps through air, with drag linear in the velocity and a truth that says so.
ProjectileDef grain() { return {.mass = 1e-6, .diameter = 1e-4, .drag = {.k1 = 2e-6}}; }

std::vector<Case> cases() {
  ProjectileDef ball{.mass = 0.057, .diameter = 0.067};
  ProjectileDef rocket{.mass = 5, .diameter = 0.05, .force = {200, 30, 0}, .force_duration = 0.7};
  return {{"bullet", bullet_308(), {.speed = 800, .elevation = 0.01}, windy(), 1, {}},
          {"bullet in a vacuum", bullet_308(), {.speed = 800, .elevation = 0.01}, nothing_but_weight(), 2, {}},
          {"ball", ball, {.position = {0, 1, 0}, .speed = 50, .elevation = 0.1}, windy(), 10, 0.0},
          {"shell", shell(), {.speed = 300, .elevation = 0.8}, windy(), 100, 0.0},
          {"rocket", rocket, {.speed = 20, .elevation = 0.5}, windy(), 2, {}}};
}

Result<AutoFidelity> chosen(const Case& c, double error, double step = 1.0 / 60) {
  return cheapest_within(c.projectile, c.launch, c.environment,
                         {.error = error, .time = c.time, .step = step, .ground = c.ground});
}

/// Largest distance from the reference, with other tolerances and samples than the search's: a flight that has ended
/// stays at its end.
double measured_again(const Case& c, const AutoFidelity& choice) {
  const Until until{.ground = c.ground, .time = c.time};
  const Flight truth =
      fly(c.projectile, c.launch, c.environment, Fidelity::reference(), {.relative = 3e-14, .absolute = 1e-13}, until);
  const Flight flight = fly(c.projectile, c.launch, c.environment, choice.fidelity, choice.tolerance(), until);
  const double end = std::max(truth.duration(), flight.duration());
  double error = 0;
  for (int i = 0; i <= 1777; ++i)
    error = std::max(error, length(flight.at(end * i / 1777).position - truth.at(end * i / 1777).position));
  return error;
}

const FidelityTrial* trial_of(const AutoFidelity& choice, const std::string& lowered, DragModel drag) {
  for (const FidelityTrial& trial : choice.trials)
    if (trial.lowered == lowered && trial.fidelity.drag == drag) return &trial;
  return nullptr;
}

TEST(AutoFidelity, KeepsItsWord) {
  for (const Case& c : cases())
    for (const double step : {1.0 / 60, 0.0})
      for (const double error : {10.0, 1.0, 0.1, 0.01, 1e-3, 1e-4}) {
        const auto choice = chosen(c, error, step);
        ASSERT_TRUE(choice.ok()) << c.what << " " << error << ": " << choice.error().text();
        EXPECT_LE(choice->error, error) << c.what;
        const double again = measured_again(c, *choice);
        EXPECT_LE(again, 1.02 * error) << c.what << " within " << error << ", step " << step;
        EXPECT_TRUE(near(again, choice->error, 0.05, 2 * choice->truth_error)) << c.what << " within " << error;
      }
}

TEST(AutoFidelity, ASmallerErrorIsNeverCheaper) {
  for (const Case& c : cases())
    for (const double step : {1.0 / 60, 0.0}) {
      double dearest = 0;
      for (double error = 100; error > 1e-5; error /= 3) {
        const auto choice = chosen(c, error, step);
        ASSERT_TRUE(choice.ok()) << c.what << " " << error << ": " << choice.error().text();
        EXPECT_GE(choice->cost, dearest) << c.what << " within " << error;
        dearest = choice->cost;
      }
    }
}

TEST(AutoFidelity, NoCheaperCandidateWouldHaveDone) {
  for (const Case& c : cases()) {
    const auto choice = must(chosen(c, 0.01), c.what);
    for (const FidelityTrial& trial : choice.trials) {
      EXPECT_EQ(trial.within, trial.error + choice.truth_error <= 0.01) << c.what;
      EXPECT_TRUE(!trial.lowered.empty() || !trial.within || trial.cost >= choice.cost) << c.what;
    }
  }
}

TEST(AutoFidelity, AVacuumGetsTheClosedForm) {
  const Case c = cases()[1];
  for (const double error : {1.0, 1e-3, 1e-6, 1e-10}) {
    const auto choice = must(chosen(c, error));
    EXPECT_EQ(choice.fidelity.motion, Motion::closed_form);
    EXPECT_EQ(choice.fidelity.precision, error > 2e-4 ? Precision::float32 : Precision::float64) << error;
  }
}

TEST(AutoFidelity, AProjectileWithoutDragGetsTheClosedForm) {
  Case c = cases()[2];
  c.projectile.drag.coefficient = 0;
  const auto choice = must(chosen(c, 0.1));
  EXPECT_EQ(choice.fidelity.motion, Motion::closed_form);
  EXPECT_EQ(choice.fidelity.drag, DragModel::off);
}

TEST(AutoFidelity, LinearDragGetsTheClosedForm) {
  Purpose purpose{.error = 1e-4, .time = 2};
  purpose.truth.drag = DragModel::linear_quadratic;
  Environment environment = windy();
  environment.earth.rotation_rate = 0;
  const auto choice = must(cheapest_within(grain(), Launch{.speed = 5, .elevation = 0.5}, environment, purpose));
  EXPECT_EQ(choice.fidelity.motion, Motion::closed_form);
  EXPECT_EQ(choice.fidelity.drag, DragModel::linear_quadratic);
  EXPECT_EQ(choice.fidelity.wind, WindModel::constant);
}

TEST(AutoFidelity, ABulletInAGameGetsSomethingCheap) {
  Case c = cases()[0];
  c.time = 0.1;
  const auto choice = must(chosen(c, 1));
  EXPECT_EQ(choice.fidelity.integrator, Integrator::semi_implicit_euler);
  EXPECT_LT(level(choice.fidelity.drag), level(DragModel::equation));
  EXPECT_EQ(choice.fidelity.precision, Precision::float32);
  EXPECT_GT(choice.truth_cost, 50 * choice.cost);
}

TEST(AutoFidelity, ABulletAtATenthOfAMillimetreGetsTheStandardAir) {
  const auto choice = must(chosen(cases()[0], 1e-4));
  EXPECT_EQ(choice.fidelity.drag, DragModel::equation);
  EXPECT_EQ(choice.fidelity.air, AirModel::isa);
  EXPECT_EQ(choice.fidelity.integrator, Integrator::rk4);
  EXPECT_EQ(choice.fidelity.earth, EarthModel::flat_coriolis);
  EXPECT_EQ(choice.fidelity.rotation, RotationModel::spin_drift);
}

TEST(AutoFidelity, SaysWhatEachEffectIsWorth) {
  const auto choice = must(chosen(cases()[0], 0.01));
  const FidelityTrial* off = trial_of(choice, "drag", DragModel::off);
  const FidelityTrial* constants = trial_of(choice, "drag", DragModel::linear_quadratic);
  ASSERT_TRUE(off && constants);
  EXPECT_GT(off->error, 100);
  EXPECT_GT(off->error, 5 * constants->error);
  EXPECT_FALSE(off->within);
  std::set<std::string> effects;
  for (const FidelityTrial& trial : choice.trials) effects.insert(trial.lowered);
  for (const char* effect : {"air", "wind", "gravity", "earth", "rotation", "integrator"})
    EXPECT_TRUE(effects.contains(effect)) << effect;
}

TEST(AutoFidelity, NeverLessThanWasAllowed) {
  const Case c = cases()[1];
  const Purpose purpose{.error = 1, .time = 1, .least_motion = Motion::force, .least_precision = Precision::float64};
  const auto choice = must(cheapest_within(c.projectile, c.launch, c.environment, purpose));
  EXPECT_EQ(choice.fidelity.motion, Motion::force);
  EXPECT_EQ(choice.fidelity.precision, Precision::float64);
}

TEST(AutoFidelity, AThrustThatMattersIsKept) {
  const auto choice = must(chosen(cases()[4], 0.1));
  EXPECT_EQ(choice.fidelity.motion, Motion::force) << "the other motions know no forces";
}

/// What a bullet gets that is fired in a crosswind.
Result<AutoFidelity> bullet_in_wind(double speed, const Purpose& purpose) {
  using namespace units;
  const ProjectileDef bullet{.mass = 168_gr,
                             .diameter = 0.308_in,
                             .length = 1.226_in,
                             .twist = 12_in,
                             .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  return cheapest_within(bullet, {.speed = speed, .elevation = 0.2_deg}, {.wind = {.velocity = {0, 0, -2}}}, purpose);
}

// The table of docs/auto_fidelity.md, and the sentence quoted there.
TEST(AutoFidelity, ItsPageTellsTheTruth) {
  using namespace units;
  const auto at = [](double error) { return bullet_in_wind(2700_fps, {.error = error, .time = 1}); };
  const auto words = [&](double error) {
    const auto choice = at(error);
    if (!choice) return choice.error().message;
    const Fidelity& f = choice->fidelity;
    std::string text(f.motion == Motion::closed_form ? name(f.motion) : name(f.integrator));
    for (const std::string_view rung : {name(f.drag), name(f.air), name(f.wind), name(f.rotation), name(f.precision)})
      text += " " + std::string(rung);
    return text;
  };
  EXPECT_EQ(words(300), "closed_form off vacuum off none float32");
  EXPECT_EQ(words(100), "semi_implicit_euler linear_quadratic constant off none float32");
  EXPECT_EQ(words(10), "semi_implicit_euler equation constant off none float32");
  EXPECT_EQ(words(1), "heun equation constant off none float32");
  EXPECT_EQ(words(1e-2), "rk4 equation constant constant spin_drift float32");
  EXPECT_EQ(words(1e-4), "rk4 equation isa constant spin_drift float32");
  EXPECT_EQ(words(1e-5), "rk4 equation isa constant spin_drift float64");
  EXPECT_EQ(words(2e-7), "rk43 equation isa constant spin_drift float64");
  EXPECT_EQ(words(2e-8), "rk43 equation isa constant spin_drift float64");
  EXPECT_EQ(words(1e-9).find("the truth itself is known to"), 0U) << words(1e-9);
  EXPECT_EQ(at(1e-2)->explanation(),
            "the cheapest within 1 cm over 1 s: measured 2.4 mm, 16 times cheaper than the reference");
}

TEST(AutoFidelity, TheTruthItselfIsToldWhereNothingCheaperStaysWithin) {
  const auto choice = must(bullet_in_wind(600, {.error = 1e-8, .time = 0.5}));
  EXPECT_EQ(choice.fidelity.integrator, Integrator::dop853);
  EXPECT_EQ(choice.explanation().find("nothing cheaper than the reference stays within 10 nm over 0.5 s: measured "),
            0U)
      << choice.explanation();
}

TEST(AutoFidelity, SeveralLaunchesCountByTheirWorst) {
  const Case c = cases()[0];
  const Launch launches[] = {{.speed = 100, .elevation = 0.1}, {.speed = 800, .elevation = 0.1}};
  const Purpose purpose{.error = 0.5, .time = 1};
  const auto both = cheapest_within(c.projectile, launches, c.environment, purpose);
  const auto slow = cheapest_within(c.projectile, launches[0], c.environment, purpose);
  ASSERT_TRUE(both.ok() && slow.ok());
  EXPECT_GT(both->cost, slow->cost);
  for (const Launch& launch : launches)
    EXPECT_LE(measured_again({"", c.projectile, launch, c.environment, 1, {}}, *both), 0.51);
}

TEST(AutoFidelity, IsDeterministic) {
  const auto first = chosen(cases()[3], 0.1), second = chosen(cases()[3], 0.1);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(first->fidelity, second->fidelity);
  EXPECT_TRUE(same_bits(first->error, second->error));
  EXPECT_TRUE(same_bits(first->cost, second->cost));
  EXPECT_EQ(first->trials.size(), second->trials.size());
}

TEST(AutoFidelity, ExplainsItself) {
  const Case c = cases()[1];
  const auto choice = must(chosen(c, 0.01));
  EXPECT_EQ(choice.explanation().find("the cheapest within 1 cm over 2 s: measured "), 0U) << choice.explanation();
  const Flight flight = fly_chosen(c.projectile, c.launch, c.environment, choice, {.time = 2});
  ASSERT_FALSE(flight.error());
  const FidelityNote note = flight.fidelity_in_use().notes.back();
  EXPECT_EQ(note.effect, "fidelity");
  EXPECT_EQ(note.asked, "cheapest_within 1 cm");
  EXPECT_EQ(note.granted, "closed_form, drag off");
  EXPECT_EQ(note.reason, choice.explanation());
}

TEST(AutoFidelity, AnErrorBelowTheTruthsOwnIsRefused) {
  const auto choice = chosen(cases()[0], 1e-12);
  ASSERT_FALSE(choice.ok());
  EXPECT_EQ(choice.error().place, "purpose.error");
  EXPECT_NE(choice.error().message.find("the truth itself is known to"), std::string::npos);
  EXPECT_FALSE(choice.error().hint.empty());
}

TEST(AutoFidelity, WhatNoToleranceReachesIsRefused) {
  const Case c = cases()[0];
  Purpose purpose{.error = 1e-5, .time = 1, .step = 0.5};
  purpose.tolerance.relative = purpose.tolerance.absolute = 1e-2;
  const auto choice = cheapest_within(c.projectile, c.launch, c.environment, purpose);
  ASSERT_FALSE(choice.ok());
  EXPECT_NE(choice.error().hint.find("the nearest is"), std::string::npos) << choice.error().text();
}

TEST(AutoFidelity, BadInputIsRefusedWithItsPlace) {
  const Case c = cases()[0];
  const auto place = [&](const Purpose& purpose) {
    const auto choice = cheapest_within(c.projectile, c.launch, c.environment, purpose);
    return choice.ok() ? "accepted" : choice.error().hint.empty() ? "no hint" : choice.error().place;
  };
  for (const double bad : {kNan, kInfinity, -kInfinity, 0.0, -1.0}) {
    EXPECT_EQ(place({.error = bad}), "purpose.error") << bad;
    EXPECT_EQ(place({.time = bad}), "purpose.time") << bad;
    EXPECT_EQ(place({.step = bad == 0 ? -0.1 : bad}), "purpose.step") << bad << ": 0 leaves steps free";
  }
  EXPECT_EQ(place({.time = 10, .step = 1e-6}), "purpose.step");
  EXPECT_EQ(place({.ground = kNan}), "purpose.ground");
  EXPECT_EQ(place({.least_motion = Motion::force, .truth = Fidelity::arcade()}), "purpose.least_motion");
  EXPECT_EQ(place({.tolerance = {.relative = 1e-17}}), "tolerance.relative");
  EXPECT_FALSE(cheapest_within(c.projectile, std::span<const Launch>(), c.environment, {}).ok());
  ProjectileDef weightless = c.projectile;
  weightless.mass = 0;
  EXPECT_EQ(cheapest_within(weightless, c.launch, c.environment, {}).error().place, "projectile.mass");
  EXPECT_EQ(cheapest_within(c.projectile, {.speed = kNan}, c.environment, {}).error().place, "launch.speed");
}

TEST(AutoFidelity, AStepThatIsTooShortForAllLaunchesIsToldByTheTruth) {
  // Each takes few enough steps by itself, and all of them more than a search may.
  const Case c = cases()[1];
  const std::vector<Launch> launches(501, c.launch);
  const Purpose purpose{.error = 1, .time = 0.1, .step = 1e-5};
  const auto choice = cheapest_within(c.projectile, launches, c.environment, purpose);
  ASSERT_FALSE(choice.ok());
  EXPECT_EQ(choice.error().place, "purpose.time") << choice.error().text();
  EXPECT_NE(choice.error().message.find("takes more than 5 million steps"), std::string::npos);
}

TEST(AutoFidelity, AShotAlongTheGroundDoesNotFly) {
  const auto choice = cheapest_within(bullet_308(), Launch{.speed = 800}, {}, {.ground = 0.0});
  ASSERT_FALSE(choice.ok());
  EXPECT_EQ(choice.error().place, "launch");
}

TEST(AutoFidelity, LandingCountsWhereItHappens) {
  // In a shallow descent a small error of height is a large one of the place where it lands.
  Case c = cases()[0];
  c.launch = {.position = {0, 1, 0}, .speed = 800};
  c.ground = 0.0;
  const auto choice = must(chosen(c, 0.05));
  EXPECT_LE(measured_again(c, choice), 0.0505);
  EXPECT_LT(choice.time, 0.6);
}

}  // namespace physim::flight_auto_fidelity_test
