// The acceleration of what rests, rolls or slides on a surface, by closed forms.
#include "math/quat.hpp"
#include "scene_support.hpp"

namespace physim::world_surface_motion_test {

using namespace test_scene;

constexpr double kRadius = 0.1;
enum class On { ground, box, plane, mesh, field };
constexpr const char* kNames[] = {"ground", "box", "plane", "mesh", "height field"};

struct Case {
  On on;
  Integrator integrator;
  Precision precision;
  bool is_ball;
  double slope = 0;  // [rad]

  [[nodiscard]] std::string what() const {
    return std::string(kNames[static_cast<int>(on)]) + ", " + std::string(name(integrator)) + ", " +
           std::string(name(precision)) + (is_ball ? ", a ball" : ", a point");
  }
  [[nodiscard]] Vec3d up() const { return {-std::sin(slope), std::cos(slope), 0}; }
  [[nodiscard]] Vec3d along() const { return {std::cos(slope), std::sin(slope), 0}; }
};

ShapeDef shape_of(On on) {
  if (on == On::plane) return PlaneShape{};
  if (on == On::mesh)
    return MeshShape{.vertices = {{-60, 0, -60}, {60, 0, -60}, {60, 0, 60}, {-60, 0, 60}},
                     .triangles = {{0, 2, 1}, {0, 3, 2}}};
  if (on == On::field) {
    HeightFieldShape field{.columns = 3, .rows = 3, .spacing_x = 60, .spacing_z = 60};
    field.heights.assign(9, 0);
    return field;
  }
  return BoxShape{{60, 1, 60}};
}

struct Laid {
  World world;
  ProjectileId id;
};

Laid laid(const Case& c, double speed, double friction, double resistance) {
  WorldDef def{
      .environment = vacuum_of(kG),
      .ground = {.mode = c.on == On::ground ? GroundMode::bounce : GroundMode::none, .restitution = 0, .friction = 1}};
  Laid made{make_world(def), {}};
  if (c.on != On::ground) {
    Scene scene;
    const Quatd turn{std::cos(c.slope / 2), 0, 0, std::sin(c.slope / 2)};
    const Vec3d middle = c.on == On::box ? Vec3d{0, -1, 0} : c.on == On::field ? Vec3d{-60, 0, -60} : Vec3d{};
    add_thing(scene, shape_of(c.on),
              {.transform = {.position = rotate(turn, middle), .rotation = turn},
               .material = *scene.add_material({.restitution = 0, .friction = 1})});
    EXPECT_TRUE(made.world.set_scene(scene));
  }
  ProjectileDef p{.mass = 2, .diameter = 2 * kRadius, .fidelity = rung(c.integrator, c.precision)};
  BodyDef body = bouncing(c.is_ball ? kRadius : 0, 0, friction);
  body.rolling_resistance = resistance;
  made.id = *made.world.spawn(
      p, {.position = c.up() * ((c.is_ball ? kRadius : 0) + 1e-7), .velocity = c.along() * speed}, body);
  return made;
}

std::vector<Case> cases(double slope = 0) {
  std::vector<Case> all;
  for (const On on : {On::ground, On::box, On::plane, On::mesh, On::field})
    for (const Integrator integrator : {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::rk4})
      for (const Precision precision : {Precision::float32, Precision::float64})
        for (const bool is_ball : {false, true})
          if ((on != On::ground || (!is_ball && slope == 0)))
            all.push_back({on, integrator, precision, is_ball, slope});
  return all;
}

/// Steps until it lies, as it was put a little above the surface.
void lay(Laid& laid) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(laid.world.step(1.0 / 60));
}

/// The effects add up to the total, which is the wanted one and that of the resultant.
void expect_acceleration(const Laid& laid, const Vec3d& wanted, const std::string& what) {
  const ProjectileView seen = laid.world[laid.id];
  const Accelerations a = seen.accelerations();
  const bool is_float32 = seen.definition()->fidelity.precision == Precision::float32;
  EXPECT_TRUE(test::near(a.total, wanted, 0, is_float32 ? 1e-4 : 1e-6)) << what;
  EXPECT_TRUE(test::near(a.gravity, {0, -kG, 0}, 1e-6)) << what;
  EXPECT_TRUE(test::near(a.gravity + a.drag + a.constraint, a.total, 1e-9, 1e-9)) << what;
  EXPECT_TRUE(test::near(seen.resultant_force(), a.total * seen.mass(), 1e-12)) << what;
}

TEST(SurfaceMotion, what_rests_has_no_acceleration) {
  for (const Case& c : cases()) {
    Laid it = laid(c, 0, 1, 0.1);
    lay(it);
    for (int i = 0; i < 30; ++i) {
      ASSERT_TRUE(it.world.step(1.0 / 60));
      expect_acceleration(it, {}, c.what());
    }
    ASSERT_TRUE(it.world[it.id].sleep());
    expect_acceleration(it, {}, c.what() + ", asleep");
  }
}

TEST(SurfaceMotion, what_flies_has_that_of_its_models) {
  for (const Case& c : cases()) {
    Laid it = laid(c, 1, 1, 0.1);
    ASSERT_TRUE(it.world[it.id].set_position({0, 1, 0}));
    for (int i = 0; i < 20; ++i) {
      expect_acceleration(it, {0, -kG, 0}, c.what());
      ASSERT_TRUE(it.world.step(1.0 / 60));
    }
  }
}

/// Friction takes mu g from what slips, and rolling resistance c g from a point, c g 5/7 from a solid ball.
TEST(SurfaceMotion, what_slides_or_rolls_is_slowed_by_its_friction) {
  const double friction = 0.2, resistance = 0.05;
  for (const Case& c : cases()) {
    Laid slides = laid(c, 5, friction, 0);
    lay(slides);
    for (int i = 0; i < 6; ++i) {
      ASSERT_TRUE(slides.world.step(1.0 / 60));
      expect_acceleration(slides, {-friction * kG, 0, 0}, c.what() + " that slides");
    }
    Laid rolls = laid(c, 5, 1, resistance);
    if (c.is_ball) {
      ASSERT_TRUE(rolls.world[rolls.id].set_angular_velocity({0, 0, -5 / kRadius}));
    }
    lay(rolls);
    for (int i = 0; i < 6; ++i) {
      ASSERT_TRUE(rolls.world.step(1.0 / 60));
      expect_acceleration(rolls, {-resistance * kG * (c.is_ball ? 5.0 / 7 : 1), 0, 0}, c.what() + " that rolls");
    }
  }
}

TEST(SurfaceMotion, on_a_slope_it_is_that_of_what_slides_or_rolls_down) {
  const double slope = 20 * test::kDegree, pull = kG * std::sin(slope), friction = 0.1;
  for (const Case& c : cases(slope)) {
    Laid held = laid(c, 0, 1, c.is_ball ? 0 : 1);
    Laid slides = laid(c, -1, friction, 0);
    lay(held);
    lay(slides);
    for (int i = 0; i < 6; ++i) {
      ASSERT_TRUE(held.world.step(1.0 / 60));
      ASSERT_TRUE(slides.world.step(1.0 / 60));
      expect_acceleration(held, c.along() * (c.is_ball ? -pull * 5 / 7 : 0), c.what());
      expect_acceleration(slides, c.along() * (friction * kG * std::cos(slope) - pull), c.what() + " that slides");
    }
  }
}

/// On a round body it turns with its way: v^2 / (R + r) towards the middle, beside g sin(a) 5/7 along it.
TEST(SurfaceMotion, on_a_round_body_it_has_what_turns_its_way) {
  const double large = 5;
  World world = make_world({.environment = vacuum_of(kG), .ground = {.mode = GroundMode::none}});
  Scene scene;
  put(scene, SphereShape{large}, {0, 0, 0}, *scene.add_material({.restitution = 0, .friction = 1000}));
  ASSERT_TRUE(world.set_scene(scene));
  const ProjectileId id =
      *world.spawn({.mass = 1, .diameter = 2 * kRadius, .fidelity = rung(Integrator::rk4)},
                   {.position = {0, large + kRadius, 0}, .velocity = Vec3d{1.4, 0, 0}}, bouncing(kRadius, 0));
  for (int i = 0; i < 60; ++i) {
    ASSERT_TRUE(world.step(1.0 / 240));
    const Vec3d up = normalized(world[id].position()), along{up.y, -up.x, 0};
    const double v = length(world[id].velocity());
    const Vec3d wanted = up * (-v * v / (large + kRadius)) + along * (kG * up.x * 5 / 7);
    EXPECT_TRUE(i == 0 || test::near(world[id].accelerations().total, wanted, 0, 2e-3)) << i;
  }
}

/// What a turntable takes along goes round with it, and what stands on a belt is brought to its speed by friction.
TEST(SurfaceMotion, on_what_moves_it_has_what_takes_it_along) {
  const double turns = 0.7;
  for (const bool is_table : {true, false}) {
    World world = make_world({.environment = vacuum_of(kG), .ground = {.mode = GroundMode::none}});
    Scene scene;
    InstanceDef thing{.shape = *scene.add_shape(CylinderShape{9, 0.5}),
                      .transform = {.position = {0, -0.5, 0}},
                      .material = *scene.add_material({.restitution = 0, .friction = 1})};
    if (is_table)
      thing.motion = SteadyMotion{.angular_velocity = {0, turns, 0}};
    else
      thing.conveyor = {.velocity = {3, 0, 0}};
    ASSERT_TRUE(scene.add(thing));
    ASSERT_TRUE(world.set_scene(scene));
    const Vec3d from{2, 0, 0};
    const ProjectileId id = *world.spawn(
        {.mass = 1, .fidelity = rung(Integrator::rk4)},
        {.position = from, .velocity = is_table ? Vec3d{0, 0, -turns * from.x} : Vec3d{}}, bouncing(0, 0, 0.3));
    for (int i = 0; i < 12; ++i) {
      ASSERT_TRUE(world.step(1.0 / 60));
      const Vec3d x = world[id].position();
      const Vec3d wanted = is_table ? Vec3d{x.x, 0, x.z} * (-turns * turns) : Vec3d{0.3 * kG, 0, 0};
      EXPECT_TRUE(test::near(world[id].accelerations().total, wanted, 1e-3)) << is_table << " " << i;
    }
  }
}

}  // namespace physim::world_surface_motion_test
