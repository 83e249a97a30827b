// What slides or rolls on things that move: turntables, planks that tilt, trains that start and stop at once, lifts
// before walls; and what drag does to slides. All beside closed forms.
#include "math/quat.hpp"
#include "scene_support.hpp"

namespace physim::world_carried_test {

using namespace test_scene;

constexpr double kRates[] = {24, 60, 250};
constexpr double kRadius = 0.1;  // of balls [m]

struct OnDisc {
  Vec3d place, velocity;
};
/// Where something is after a time on a disc that turns about y at the origin; `body` says with which friction.
OnDisc on_disc(double turns, double friction, const BodyDef& body, const Vec3d& velocity, double seconds, double rate) {
  Scene scene;
  const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = friction});
  add_thing(scene, CylinderShape{40, 0.25},
            {.transform = {.position = {0, -0.25, 0}},
             .material = made_of,
             .motion = SteadyMotion{.angular_velocity = {0, turns, 0}}});
  World world = make_world(space(), scene);
  const ProjectileId id =
      *world.spawn(puck(), {.position = {0.5, body.collision.radius + 1e-10, 0}, .velocity = velocity}, body);
  run_for(world, seconds, 1 / rate);
  return {world[id].position(), world[id].velocity()};
}

/// Without friction nothing turns it. It gained energy: what turned with the disc had no Coriolis acceleration.
TEST(Carried, what_slides_without_friction_on_a_turntable_goes_straight) {
  const Vec3d v{0.7, 0, 0.4};
  for (const double radius : {0.0, kRadius})
    for (const double rate : kRates) {
      const OnDisc at = on_disc(2, 0, bouncing(radius, 0, 0), v, 4, rate);
      EXPECT_LT(length(at.velocity - v), 1e-9) << radius << ' ' << rate;
      EXPECT_LT(length(at.place - Vec3d{0.5 + 4 * v.x, radius, 4 * v.z}), 50 / (rate * rate)) << radius << ' ' << rate;
    }
}

/// A ball that rolls on a turntable goes in a circle, at k / (1 + k) = 2/7 of its rate (K. Weltner, Am. J. Phys. 47,
/// 984 (1979)).
TEST(Carried, a_ball_that_rolls_on_a_turntable_goes_in_circles_at_two_sevenths_of_its_rate) {
  const double turns = 2, speed = 0.3, seconds = 5, rate_of_circle = 2.0 / 7 * turns;
  for (const double rate : kRates) {
    BodyDef ball = bouncing(kRadius, 0, 1);
    ball.angular_velocity = {0.5 * turns / kRadius, 0, -speed / kRadius};
    const OnDisc at = on_disc(turns, 10, ball, {speed, 0, 0}, seconds, rate);
    const double angle = rate_of_circle * seconds, radius = speed / rate_of_circle;
    const Vec3d right{0.5 + radius * std::sin(angle), kRadius, -radius * (1 - std::cos(angle))};
    EXPECT_LT(length(at.place - right), 3 / (rate * rate)) << rate;
    EXPECT_NEAR(length(at.velocity), speed, 3 / (rate * rate)) << rate;
  }
}

/// A plank turns steadily about an axis in its surface: (1 + k) s'' = w^2 s - g sin(w t), by Lagrange's equation; s is
/// the place along it, from the axis. A point without friction has k = 0.
TEST(Carried, what_slides_or_rolls_on_a_plank_that_tilts_follows_the_equation_of_its_motion) {
  const double w = 0.4, start = -0.5, speed = 0.2, seconds = 1.5;
  for (const double k : {0.0, 0.4})
    for (const double rate : kRates) {
      const double radius = k > 0 ? kRadius : 0, grows = w / std::sqrt(1 + k), a = kG / (w * w * (2 + k));
      Scene scene;
      const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = k > 0 ? 1.0 : 0.0});
      // Its surface goes through the origin, about which it turns.
      ConvexHullShape plank;
      for (const double x : {-9.0, 9.0})
        for (const double y : {-0.3, 0.0})
          for (const double z : {-3.0, 3.0}) plank.points.push_back({x, y, z});
      add_thing(scene, plank, {.material = made_of, .motion = SteadyMotion{.angular_velocity = {0, 0, w}}});
      World world = make_world(space(), scene);
      BodyDef body = bouncing(radius, 0, 1);
      if (k > 0) body.angular_velocity = {0, 0, w - speed / radius};
      const ProjectileId id = *world.spawn(
          puck(), {.position = {start, radius + 1e-10, 0}, .velocity = Vec3d{speed - w * radius, w * start, 0}}, body);
      run_for(world, seconds, 1 / rate);
      const double t = world.time(), c = (speed - a * w) / grows;
      const double s = a * std::sin(w * t) + c * std::sinh(grows * t) + start * std::cosh(grows * t);
      const Vec3d along{std::cos(w * t), std::sin(w * t), 0}, up{-std::sin(w * t), std::cos(w * t), 0};
      EXPECT_NEAR(dot(world[id].position(), along), s, 1 / (rate * rate)) << k << ' ' << rate;
      EXPECT_NEAR(dot(world[id].position(), up), radius, 1e-6) << k << ' ' << rate;
    }
}

/// Keys may change a velocity at once: what lies on a train slides from that moment on, whatever the step. The mean
/// acceleration of such a step moved it by half a step's way (25 mm at 60 Hz).
TEST(Carried, what_lies_on_a_train_slides_from_the_moment_at_which_it_stops_or_starts) {
  const double speed = 3, friction = 0.5, slides = speed * speed / (2 * friction * kG);
  for (const double when : {1.0, 0.987654321})
    for (const bool stops : {true, false})
      for (const double rate : kRates) {
        Scene scene;
        const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = 1});
        const double from = stops ? 0 : when, to = stops ? when : when + 9;
        KeyedMotion train{.keys = {{.time = from, .position = {0, -0.5, 0}},
                                   {.time = to, .position = {speed * (to - from), -0.5, 0}}}};
        ASSERT_TRUE(
            scene.add({.shape = *scene.add_shape(BoxShape{{80, 0.5, 5}}), .material = made_of, .motion = train}));
        World world = make_world(space(), scene);
        const ProjectileId id = *world.spawn(
            puck(), {.position = {0, 1e-10, 0}, .velocity = Vec3d{stops ? speed : 0, 0, 0}}, bouncing(0, 0, friction));
        run_for(world, 2.5, 1 / rate);
        const double right = stops ? speed * when + slides : speed * (world.time() - when) - slides;
        EXPECT_NEAR(world[id].position().x, right, 1e-7) << when << ' ' << stops << ' ' << rate;
        EXPECT_NEAR(world[id].velocity().x, stops ? 0 : speed, 1e-9) << when << ' ' << stops << ' ' << rate;
      }
}

/// The same in a flight.
TEST(Carried, a_flight_on_a_train_that_stops_slides_from_that_moment_on) {
  const double speed = 3, when = 0.7654321;
  for (const double rate : kRates) {
    Scene scene;
    const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = 1});
    add_thing(scene, BoxShape{{80, 0.5, 5}},
              {.material = made_of,
               .motion = KeyedMotion{.keys = {{.time = 0, .position = {0, -0.5, 0}},
                                              {.time = when, .position = {speed * when, -0.5, 0}}}}});
    Until until = meeting(scene, OnHit::bounce);
    until.contact.restitution = 0, until.contact.friction = 0.5, until.contact.rolling_resistance = 0;
    const ProjectileDef p = puck();
    const Flight flight = fly(p, {.position = {0, 1e-10, 0}, .velocity = Vec3d{speed, 0, 0}}, vacuum_of(kG), p.fidelity,
                              Tolerance{.step = 1 / rate}, until);
    EXPECT_NEAR(flight.end().position.x, speed * when + speed * speed / kG, 1e-7) << rate;
  }
}

/// A point leaves a thing at its edge, with the velocity that it has there: it went on beyond the edge to the end of
/// the step, or for 1/30 s.
TEST(Carried, a_point_that_slides_over_an_edge_falls_from_there) {
  const double speed = 2, edge = 1;
  for (const double rises : {0.0, 1.0})
    for (const bool rough : {false, true})
      for (const double rate : kRates) {
        Scene scene;
        const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = 1});
        add_thing(scene, BoxShape{{5, 0.5, 5}},
                  {.transform = {.position = {edge - 5, -0.5, 0}},
                   .material = made_of,
                   .motion = SteadyMotion{.velocity = {0, rises, 0}}});
        World world = make_world(space(), scene);
        const double friction = rough ? 0.1 : 0, slows = friction * kG;
        const ProjectileId id = *world.spawn(puck(), {.position = {0, 1e-10, 0}, .velocity = Vec3d{speed, rises, 0}},
                                             bouncing(0, 0, friction));
        run_for(world, 1, 1 / rate);
        const double v = std::sqrt(speed * speed - 2 * slows * edge), falls = world.time() - 2 * edge / (speed + v);
        EXPECT_NEAR(world[id].position().x, edge + v * falls, 1e-6) << rises << ' ' << rough << ' ' << rate;
        EXPECT_NEAR(world[id].position().y, rises * world.time() - 0.5 * kG * falls * falls, 1e-6)
            << rises << ' ' << rough << ' ' << rate;
      }
}

struct Puck {
  double x, speed, time;
};
/// A puck that slides against friction, with a wall without friction that comes to meet it and takes no energy, until a
/// time; event by event.
double struck_by_wall(Puck puck, double slows, double wall, double wall_speed, double until) {
  for (int hit = 0; hit < 100; ++hit) {
    const double sign = puck.speed < 0 ? -1 : 1, left = until - puck.time, rests = std::abs(puck.speed) / slows;
    const auto place = [&](double t) {
      const double moves = std::min(t, rests);
      return puck.x + puck.speed * moves - 0.5 * sign * slows * moves * moves;
    };
    double clear = 0, struck = left;
    const auto gap = [&](double t) { return wall + wall_speed * (puck.time + t) - place(t); };
    constexpr int kLooks = 20000;
    int look = 1;
    while (look <= kLooks && gap(left * look / kLooks) > 0) ++look;
    if (look > kLooks) return place(left);
    clear = left * (look - 1) / kLooks, struck = left * look / kLooks;
    for (int half = 0; half < 60; ++half) (gap(0.5 * (clear + struck)) > 0 ? clear : struck) = 0.5 * (clear + struck);
    puck.x = place(struck);
    puck.speed -= sign * slows * std::min(struck, rests);
    puck.time += struck, puck.speed = 2 * wall_speed - puck.speed;
  }
  return puck.x;
}

/// A wall that comes meets what slides on ground, on a floor and on a lift at the moment at which both are there.
TEST(Carried, a_wall_in_motion_or_before_a_lift_is_met_when_both_are_there) {
  const double speed = 4, friction = 0.5, slows = friction * kG;
  for (const double wall_speed : {0.0, -2.0})
    for (const int surface : {0, 1, 2})
      for (const double rate : kRates) {
        const double rises = surface == 2 ? 0.7 : 0;
        WorldDef def = space();
        if (surface == 0) def.ground = {.mode = GroundMode::bounce, .restitution = 0, .friction = 1};
        World world = make_world(def);
        Scene scene;
        const MaterialId rough = *scene.add_material({.restitution = 0, .friction = 1});
        const MaterialId smooth = *scene.add_material({.restitution = 1, .friction = 0});
        if (surface > 0) {
          add_thing(scene, BoxShape{{40, 0.5, 5}},
                    {.transform = {.position = {0, -0.5, 0}},
                     .material = rough,
                     .motion = SteadyMotion{.velocity = {0, rises, 0}}});
        }
        SceneMotion motion = AtRest{};
        if (wall_speed != 0) motion = SteadyMotion{.velocity = {wall_speed, 0, 0}};
        add_thing(scene, BoxShape{{0.5, 9, 5}},
                  {.transform = {.position = {1.5, 0, 0}}, .material = smooth, .motion = motion});
        ASSERT_TRUE(world.set_scene(scene));
        const ProjectileId id =
            *world.spawn(puck(), {.position = {0, surface > 0 ? 1e-10 : 0, 0}, .velocity = Vec3d{speed, rises, 0}},
                         bouncing(0, 1, friction));
        run_for(world, 0.5, 1 / rate);
        const double right = struck_by_wall({0, speed, 0}, slows, 1, wall_speed, world.time());
        EXPECT_NEAR(world[id].position().x, right, 1e-7) << wall_speed << ' ' << surface << ' ' << rate;
      }
}

/// A sensor reports what a lift carries through it when it is there.
TEST(Carried, a_sensor_reports_what_slides_on_a_lift_in_its_time) {
  const double speed = 5, slows = 0.5 * kG;
  for (const double rate : kRates) {
    Scene scene;
    add_thing(scene, BoxShape{{40, 0.5, 5}},
              {.transform = {.position = {0, -0.5, 0}},
               .material = *scene.add_material({.restitution = 0, .friction = 1}),
               .motion = SteadyMotion{.velocity = {0, 1, 0}}});
    add_thing(scene, BoxShape{{0.5, 9, 9}}, {.transform = {.position = {1.5, 0, 0}}, .sensor = true});
    World world = make_world(space(), scene);
    ASSERT_TRUE(world.spawn(puck(), {.position = {0, 1e-10, 0}, .velocity = Vec3d{speed, 1, 0}}, bouncing(0, 0, 0.5)));
    const std::vector<Event> all = run_for(world, 1, 1 / rate);
    const auto when = [&](double x) { return (speed - std::sqrt(speed * speed - 2 * slows * x)) / slows; };
    const auto in = test::of_kind(all, EventKind::sensed), out = test::of_kind(all, EventKind::left);
    ASSERT_EQ(in.size(), 1u) << rate;
    ASSERT_EQ(out.size(), 1u) << rate;
    EXPECT_NEAR(in[0].time, when(1), 1e-6) << rate;
    EXPECT_NEAR(out[0].time, when(2), 1e-6) << rate;
  }
}

/// Against friction and drag by the square of the speed it comes ln(1 + k v^2 / (mu g)) / (2 k) far; the error falls
/// with the square of the step.
TEST(Carried, what_slides_through_thick_air_stops_where_the_closed_form_says) {
  const double k = 0.2, speed = 8, friction = 0.3;
  const double right = std::log(1 + k * speed * speed / (friction * kG)) / (2 * k);
  for (const bool on_ground : {true, false})
    for (const double rate : kRates) {
      WorldDef def = space();
      if (on_ground) def.ground = {.mode = GroundMode::bounce, .restitution = 0, .friction = 1};
      World world = make_world(def);
      Scene scene;
      put(scene, BoxShape{{40, 0.5, 5}}, {0, -0.5, 0}, *scene.add_material({.restitution = 0, .friction = 1}));
      if (!on_ground) {
        ASSERT_TRUE(world.set_scene(scene));
      }
      ProjectileDef thrown = puck();
      thrown.fidelity.drag = DragModel::linear_quadratic;
      thrown.drag.k1 = 1e-12, thrown.drag.k2 = k * thrown.mass;
      const ProjectileId id =
          *world.spawn(thrown, {.position = {0, on_ground ? 0 : 1e-10, 0}, .velocity = Vec3d{speed, 0, 0}},
                       bouncing(0, 0, friction));
      run_for(world, 4, 1 / rate);
      EXPECT_NEAR(world[id].position().x, right, 3 / (rate * rate)) << on_ground << ' ' << rate;
    }
}

/// A wedge comes along x below a ball that does not move along x: n (x - U t) = 0 lifts it by U t tan(slope). Its way
/// had parts of 1e-14 s, as the wedge's velocity was compared with what the constraint leaves of it.
TEST(Carried, a_wedge_lifts_what_does_not_move_along_its_way) {
  const double slope = 0.2, speed = 1, half = 0.5;
  const Vec3d normal{std::sin(slope), std::cos(slope), 0};
  for (const double radius : {0.0, kRadius})
    for (const double rate : kRates) {
      Scene scene;
      const MaterialId smooth = *scene.add_material({.restitution = 0, .friction = 0});
      add_thing(scene, BoxShape{{20, half, 5}},
                {.transform = {.position = normal * -half, .rotation = quat_from_axis_angle(Vec3d{0, 0, -1}, slope)},
                 .material = smooth,
                 .motion = SteadyMotion{.velocity = {speed, 0, 0}}});
      World world = make_world(space(), scene);
      BodyDef body = bouncing(radius, 0, 0);
      body.frozen = Axes::x;
      const Vec3d place{0, radius / std::cos(slope) + 1e-10, 0}, rises{0, speed * std::tan(slope), 0};
      const ProjectileId id = *world.spawn(puck(), {.position = place, .velocity = rises}, body);
      run_for(world, 2, 1 / rate);
      EXPECT_LT(length(world[id].position() - place - rises * 2), 1e-8) << radius << ' ' << rate;
      EXPECT_LT(length(world[id].velocity() - rises), 1e-8) << radius << ' ' << rate;
    }
}

/// A plate turns by a radian in a step: s'' = w^2 s - g sin(w t) along it without friction. Its way was one way of the
/// whole step, and where weight pressed no more the Coriolis acceleration did not either: points went through.
TEST(Carried, a_plate_that_turns_fast_presses_and_is_followed_in_parts_of_its_turn) {
  const double w = 60, start = 0.3, speed = 8, seconds = 0.05, a = kG / (2 * w * w), c = speed / w - a;
  for (const double radius : {0.0, 0.001, kRadius}) {
    Scene scene;
    const MaterialId smooth = *scene.add_material({.restitution = 0, .friction = 0});
    ConvexHullShape plate;
    for (const double x : {-9.0, 9.0})
      for (const double y : {-0.3, 0.0})
        for (const double z : {-9.0, 9.0}) plate.points.push_back({x, y, z});
    add_thing(scene, plate, {.material = smooth, .motion = SteadyMotion{.angular_velocity = {0, 0, w}}});
    World world = make_world(in_the_open(), scene);
    const ProjectileId id = *world.spawn(
        puck(), {.position = {start, radius + 1e-10, 0}, .velocity = Vec3d{speed - w * radius, w * start, 0}},
        bouncing(radius, 0, 0));
    run_for(world, seconds, 1.0 / 60);
    const double t = world.time(), s = a * std::sin(w * t) + c * std::sinh(w * t) + start * std::cosh(w * t);
    const Vec3d along{std::cos(w * t), std::sin(w * t), 0}, up{-std::sin(w * t), std::cos(w * t), 0};
    EXPECT_NEAR(dot(world[id].position(), along), s, 0.01 * s) << radius;
    EXPECT_NEAR(dot(world[id].position(), up), radius, 1e-6) << radius;
  }
}

/// In float32 the slip of a ball is rounded anew where each way begins. Each such slip began a way of a nanosecond, so
/// that a second took minutes.
TEST(Carried, a_ball_of_float32_on_what_turns_goes_as_one_of_float64) {
  const auto after = [](Precision precision, double friction, double rate) {
    Scene scene;
    const MaterialId made_of = *scene.add_material({.restitution = 0, .friction = 1});
    add_thing(scene, SphereShape{1}, {.material = made_of, .motion = SteadyMotion{.angular_velocity = {0.5, 0, 0}}});
    World world = make_world(space(), scene);
    ProjectileDef ball = puck();
    ball.fidelity.precision = precision;
    const Launch launch{.position = {0, 1.35, 0.02}, .velocity = Vec3d{0, 0, 0.1}};
    const ProjectileId id = *world.spawn(ball, launch, bouncing(0.05, 0, friction));
    run_for(world, 0.8, 1 / rate);
    return world[id].position();
  };
  for (const double friction : {0.0, 0.3})
    for (const double rate : {60.0, 1000.0}) {
      const Vec3d one = after(Precision::float32, friction, rate), other = after(Precision::float64, friction, rate);
      EXPECT_LT(length(one - other), 2e-3) << friction << ' ' << rate;
    }
}

}  // namespace physim::world_carried_test
