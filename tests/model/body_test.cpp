// The parts of a body: where they lie, and that models read none but those that are named.
#include "model/body.hpp"

#include "../random_shots.hpp"
#include "../support.hpp"
#include "model/closed_form.hpp"

namespace physim::model_body_test {

using test::kNan;
using test::Random;

TEST(BodyParts, begin_with_what_a_launch_gives) {
  constexpr NumberRuns kLaunch = kLaunchParts.runs();
  EXPECT_EQ(kLaunch.count, 1u);
  EXPECT_EQ(kLaunch.run[0].first, 0);
  EXPECT_EQ(kLaunch.numbers(), 12u);
}

TEST(BodyParts, know_the_place_of_every_number) {
  Body<double> b{};
  numbers(b)[kBodyNumber.burn.end] = 1;
  numbers(b)[kBodyNumber.rail_phase] = 2;
  numbers(b)[kBodyNumber.curve_last] = 3;
  EXPECT_EQ(b.burn.end, 1);
  EXPECT_EQ(b.rail_phase, 2);
  EXPECT_EQ(b.curve_last, 3);
  EXPECT_EQ(PartSet::all().runs().numbers(), kNumbers<Body>);
  EXPECT_EQ((PartSet::all() - kLaunchParts).runs().numbers(), kNumbers<Body> - 12);
}

ProjectileDef projectile_with_everything(Random& r) {
  ProjectileDef p = test::random_projectile(r);
  if (r.one_in(2)) p.motor = {.thrust = {{0, 50}, {1, 20}, {2, 0}}, .propellant_mass = 0.1 * p.mass};
  if (r.one_in(2)) p.magnus = {.lift = 1.2, .lift_base = 0.4, .lift_saturation = 2, .drag_per_spin = 1e-4};
  return p;
}

/// Acceleration by the models, or the state of a closed form, a while after the launch.
State<double> answer(const Conditions<double>& c, const Body<double>& b) {
  const State<double> s{{300, 120, 15}, {210, 30, -12}};
  if (c.fidelity.motion == Motion::closed_form) return closed_form(c, b, 0.5);
  return {acceleration(c, b, 0.5, s), {}};
}

TEST(BodyParts, that_are_not_named_are_not_read) {
  Random r(1414);
  for (int i = 0; i < 600; ++i) {
    Fidelity asked = test::random_fidelity(r);
    if (r.one_in(4)) asked.rotation = RotationModel::magnus;
    Launch launch = test::random_launch(r);
    if (r.one_in(4)) launch.rail_length = 3;
    const test::Prepared shot(projectile_with_everything(r), launch, test::random_environment(r), asked);
    const Conditions<double>& c = shot.conditions();
    Body<double> poisoned = shot.body;
    const PartSet others = PartSet::all() - parts_read(c.fidelity, c);
    others.runs().each([&](unsigned number) { numbers(poisoned)[number] = kNan; });
    const State<double> with = answer(c, shot.body), without = answer(c, poisoned);
    ASSERT_TRUE(test::same_bits(with.x, without.x)) << i;
    ASSERT_TRUE(test::same_bits(with.v, without.v)) << i;
  }
}

/// Each part is a column of every row in memory.
TEST(BodyParts, of_other_rungs_are_not_carried) {
  Fidelity f{.motion = Motion::closed_form, .drag = DragModel::off, .planar = false};
  EXPECT_EQ(parts_read(f, {}), PartSet::of<LaunchPart>());
  f.drag = DragModel::equation;  // some closed forms have a damping that stands for it
  EXPECT_EQ(parts_read(f, {}), (PartSet::of<LaunchPart, DampingPart>()));
  f.motion = Motion::force;
  EXPECT_EQ(parts_read(f, {}), (PartSet::of<AreaPart, CurvePart>()));
  f.drag = DragModel::linear_quadratic;
  EXPECT_EQ(parts_read(f, {}), PartSet::of<QuadraticPart>());
  f.drag = DragModel::damping;
  EXPECT_EQ(parts_read(f, {}), PartSet::of<DampingPart>());
  f.drag = DragModel::off;
  EXPECT_EQ(parts_read(f, {}), PartSet());
}

}  // namespace physim::model_body_test
