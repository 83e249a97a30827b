// Steps of a given length: drag slows, and turns no velocity around. Of order one: what bounces keeps its energy.
#include "world/world_support.hpp"

namespace physim::world_first_order_test {

constexpr double kG = 9.80665, kStep = 1.0 / 64, kPi = 3.14159265358979324;

constexpr std::initializer_list<Integrator> kFirstOrder{Integrator::semi_implicit_euler, Integrator::explicit_euler};
constexpr std::initializer_list<Integrator> kFixed{Integrator::semi_implicit_euler, Integrator::explicit_euler,
                                                   Integrator::heun, Integrator::rk4};

std::vector<Fidelity> rungs(const Fidelity& like, std::initializer_list<Integrator> integrators = kFirstOrder) {
  std::vector<Fidelity> all;
  for (const Integrator integrator : integrators)
    for (const Precision precision : {Precision::float32, Precision::float64})
      all.push_back(like), all.back().integrator = integrator, all.back().precision = precision;
  return all;
}

WorldDef open_world() { return {.ground = {.mode = GroundMode::none}}; }

/// Paper: 0.1 g, 10 cm. In the first step of 15 m/s its drag would take 24 times its speed.
ProjectileDef confetti(DragModel drag, const Fidelity& rung) {
  ProjectileDef p{.mass = 1e-4, .diameter = 0.1, .drag = {.coefficient = 1}};
  p.drag.damping = 1e-40;  // a rate of 92 1/s
  p.drag.k1 = 0.02, p.drag.k2 = 0.004;
  p.fidelity = rung;
  p.fidelity.drag = drag;
  return p;
}

TEST(FixedSteps, drag_never_turns_a_velocity_around) {
  for (const DragModel drag : {DragModel::equation, DragModel::damping, DragModel::linear_quadratic}) {
    for (const Fidelity& rung : rungs(Fidelity::game(), kFixed)) {
      const ProjectileDef p = confetti(drag, rung);
      const WorldDef def = open_world();
      World world = make_world(def);
      const Launch launch{.speed = 15, .elevation = 0.5};
      const ProjectileId id = *world.spawn(p, launch, {.can_sleep = false});
      Tolerance tolerance{.step = kStep};
      Until until;
      until.ground.reset();
      until.time = 2;
      const Flight flight = fly(p, launch, def.environment, p.fidelity, tolerance, until);
      double before = 15 * std::cos(0.5);
      for (int i = 1; i <= 120; ++i) {
        world.step(kStep);
        const Vec3d v = world[id].velocity();
        ASSERT_GE(v.x, 0) << name(drag) << " " << name(rung.integrator) << " " << i;
        ASSERT_LE(v.x, before);
        before = v.x;
        ASSERT_LE(length(v), 15);
        ASSERT_EQ(flight.at(i * kStep).velocity, v) << name(drag) << " " << name(rung.integrator) << " " << i;
      }
      // And it falls as fast as drag and weight are in balance.
      const double k = 92.103403719761836, k1 = 0.02 / 1e-4, k2 = 0.004 / 1e-4;
      const double by_equation = std::sqrt(2 * 1e-4 * kG / (1.225 * kPi / 4 * 0.01));
      const double by_k1_k2 = (-k1 + std::sqrt(k1 * k1 + 4 * k2 * kG)) / (2 * k2);
      const double falls = drag == DragModel::equation ? by_equation : drag == DragModel::damping ? kG / k : by_k1_k2;
      EXPECT_NEAR(world[id].velocity().y, -falls, 2e-3 * falls) << name(drag) << " " << name(rung.integrator);
    }
  }
}

TEST(FixedSteps, drag_of_generators_and_emitters_never_turns_a_velocity_around) {
  for (const DragModel drag : {DragModel::off, DragModel::equation}) {
    for (const Fidelity& rung : rungs(Fidelity::game(), kFixed)) {
      World world = make_world(open_world());
      ProjectileDef p{.mass = 2, .diameter = 0.01};
      p.fidelity = rung;
      p.fidelity.drag = drag;
      const ProjectileId id =
          *world.spawn(p, {.position = {0, 500, 0}, .velocity = Vec3d{20, 0, 0}}, {.can_sleep = false});
      ASSERT_TRUE(world[id].add_force(LinearQuadraticDragForce{.k1 = 2000, .wind = {3, 0, 0}}));
      EmitterDef puffs{.kind = *world.add_kind(p, {.can_sleep = false}),
                       .cycle = {.plays = false},
                       .position = {0, 400, 0},
                       .start = {.lifetime = {kInfinity}, .speed = {20}},
                       .flight = {.drag = {500}}};
      ASSERT_TRUE(world.emit(*world.add_emitter(puffs), 1));
      world.step(kStep);
      ASSERT_EQ(world.ids().size(), 2u);
      const ProjectileId puff = world.ids().back();
      double fast = 20;
      for (int i = 0; i < 120; ++i) {
        world.step(kStep);
        const Vec3d v = world[id].velocity();
        ASSERT_GE(v.x, 2.999999) << name(drag) << " " << name(rung.integrator) << " " << i;
        ASSERT_LE(v.x, fast + 1e-6);
        fast = v.x;
        ASSERT_LE(length(world[puff].velocity()), 20.001) << name(drag) << " " << i;
      }
      EXPECT_NEAR(world[id].velocity().y, -kG / 1000, 1e-6);
      EXPECT_NEAR(world[puff].velocity().y, -kG / 500, 1e-3);
    }
  }
}

/// Falls from 2 m without loss: the highest point after each of some bounces.
std::vector<double> apexes(World& world, ProjectileId id, double floor, int bounces) {
  std::vector<double> tops;
  double top = 0, rises = 0;
  for (int i = 0; i < 100'000 && std::ssize(tops) < bounces; ++i) {
    world.step(kStep);
    const double y = world[id].position().y - floor, vy = world[id].velocity().y;
    if (vy > 0 && rises <= 0 && top > 0) tops.push_back(top), top = 0;
    rises = vy;
    // Of the parabola through this place and the next ones.
    top = std::max(top, y);
  }
  return tops;
}

TEST(FirstOrder, what_bounces_without_loss_rises_as_high_as_before) {
  Fidelity falls = Fidelity::game();
  falls.drag = DragModel::off;
  for (const bool on_thing : {false, true}) {
    for (const Fidelity& rung : rungs(falls)) {
      WorldDef def = open_world();
      if (!on_thing) def.ground = {.mode = GroundMode::bounce, .restitution = 1};
      World world = make_world(def);
      Scene scene;
      const MaterialId hard = *scene.add_material({.restitution = 1, .friction = 0});
      add_thing(scene, PlaneShape{}, {.material = hard});
      if (on_thing) {
        ASSERT_TRUE(world.set_scene(scene));
      }
      BodyDef body{.can_sleep = false, .restitution = 1, .friction = 0, .collision = {.on_hit = OnHit::bounce}};
      if (on_thing) body.collision.radius = 0.1;
      const ProjectileId id =
          *world.spawn({.mass = 1, .diameter = 0.2, .fidelity = rung}, {.position = {0, 2, 0}}, body);
      const double floor = on_thing ? 0.1 : 0, high = 2 - floor;
      const std::vector<double> tops = apexes(world, id, floor, 60);
      ASSERT_EQ(tops.size(), 60u) << name(rung.integrator) << " " << name(rung.precision) << " " << on_thing;
      // Places are looked at once in a step: at the highest one it is at most g h^2 / 8 below the apex, and the rung's
      // first step is half a step too fast or too slow.
      const double seen = kG * kStep * kStep;
      for (const double top : tops)
        ASSERT_NEAR(top, high, seen + (rung.precision == Precision::float32 ? 2e-4 : 1e-9) * high)
            << name(rung.integrator) << " " << name(rung.precision) << " " << on_thing;
    }
  }
}

TEST(FirstOrder, what_skims_a_round_thing_gains_no_energy) {
  Scene scene;
  const MaterialId smooth = *scene.add_material({.restitution = 0, .friction = 0});
  add_thing(scene, SphereShape{2}, {.material = smooth});
  constexpr double kRadius = 0.07, kSpeed = 3.3, kShort = 0.0122;
  for (const Fidelity& rung : rungs(Fidelity::game(), {Integrator::semi_implicit_euler})) {
    for (const double angle : {0.2, 0.5, 0.8}) {  // from the horizontal [rad]
      ProjectileDef p{.mass = 0.7, .diameter = 2 * kRadius};
      p.fidelity = rung;
      p.fidelity.drag = DragModel::off;
      World world = make_world(open_world(), scene);
      BodyDef body{.restitution = 0, .friction = 0, .collision = {.on_hit = OnHit::bounce, .radius = kRadius}};
      const Vec3d out{std::cos(angle), std::sin(angle), 0}, up{-out.y, out.x, 0};
      const ProjectileId id =
          *world.spawn(p, {.position = out * (2 + kRadius + 1e-3), .velocity = up * kSpeed - out * 0.2}, body);
      const auto energy = [&] {
        const Vec3d v = world[id].velocity();
        return 0.5 * dot(v, v) + kG * world[id].position().y;
      };
      const double first = energy(), may = kG * kShort * (kSpeed + kG * kShort);
      for (int i = 0; i < 60; ++i) {
        world.step(kShort);
        ASSERT_LE(energy(), first + may) << name(rung.integrator) << " " << name(rung.precision) << " " << angle;
      }
    }
  }
}

TEST(FirstOrder, balls_that_meet_without_loss_keep_their_energy) {
  Fidelity falls = Fidelity::game();
  falls.drag = DragModel::off;
  for (const Fidelity& rung : rungs(falls)) {
    World world = make_world(open_world());
    BodyDef body{.can_sleep = false,
                 .restitution = 1,
                 .friction = 0,
                 .collision = {.on_hit = OnHit::bounce, .radius = 0.1, .others = 1}};
    const ProjectileId upper =
        *world.spawn({.mass = 1, .diameter = 0.2, .fidelity = rung}, {.position = {0, 2.1, 0}}, body);
    body.infinite_mass = true;
    ASSERT_TRUE(world.spawn({.mass = 1, .diameter = 0.2, .fidelity = rung}, {}, body));
    const std::vector<double> tops = apexes(world, upper, 0.2, 60);
    ASSERT_EQ(tops.size(), 60u) << name(rung.integrator) << " " << name(rung.precision);
    for (const double top : tops)
      ASSERT_NEAR(top, 1.9, kG * kStep * kStep + (rung.precision == Precision::float32 ? 4e-4 : 1e-7))
          << name(rung.integrator) << " " << name(rung.precision);
  }
}

}  // namespace physim::world_first_order_test
