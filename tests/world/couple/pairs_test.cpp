// Projectiles that meet each other: where and when, what follows, and that nothing else matters.
#include <map>
#include <random>

#include "world/pairs_support.hpp"

namespace physim::world_pairs_test {

using namespace test_pairs;

TEST(Pairs, two_balls_part_as_the_closed_form_says) {
  for (const double restitution : {1.0, 0.5, 0.0}) {
    World world = make_world(space());
    const double m = 2, n = 3, v = 40, w = -25;
    const ProjectileId a = put(world, mass_of(m), ball(0.2, restitution), {0, 0, 0}, {v, 0, 0});
    const ProjectileId b = put(world, mass_of(n), ball(0.3), {10, 0, 0}, {w, 0, 0});
    const auto events = run_for(world, 0.25);
    const auto hits = of_kind(events, EventKind::hit);
    ASSERT_EQ(hits.size(), 2u);
    const double t = (10 - 0.5) / (v - w);
    EXPECT_NEAR(hits[0].time, t, 1e-12);
    EXPECT_EQ(hits[0].id, a);
    EXPECT_EQ(hits[0].other, b);
    EXPECT_EQ(hits[1].id, b);
    EXPECT_EQ(hits[1].other, a);
    EXPECT_NEAR(hits[0].position.x, v * t, 1e-10);
    EXPECT_NEAR(hits[1].position.x - hits[0].position.x, 0.5, 1e-12);
    EXPECT_NEAR(hits[0].normal.x, -1, 1e-12);
    EXPECT_NEAR(hits[1].normal.x, 1, 1e-12);
    EXPECT_EQ(hits[0].velocity.x, v);
    const double middle = (m * v + n * w) / (m + n);
    const double after_a = middle - restitution * n / (m + n) * (v - w);
    const double after_b = middle + restitution * m / (m + n) * (v - w);
    EXPECT_NEAR(world[a].velocity().x, after_a, 1e-12 * v);
    EXPECT_NEAR(world[b].velocity().x, after_b, 1e-12 * v);
    EXPECT_NEAR(world[a].position().x, v * t + after_a * (0.25 - t), 1e-10);
    EXPECT_EQ(of_kind(events, EventKind::bounced).size(), 2u);
  }
}

/// A ball between two equal ones that touch: J along both normals at once leaves -v / 5, and 2 sqrt(3) v / 5 at 30
/// degrees to either side, whoever was there first.
TEST(Pairs, two_that_are_met_at_once_part_alike) {
  constexpr double kSpeed = 10;
  for (const int first : {0, 1, 2})
    for (const double friction : {0.0, 0.2}) {
      World world = make_world(space());
      const Vec3d at[] = {{-2, 0, 0}, {0, 0, -0.5}, {0, 0, 0.5}};
      BodyDef body = ball(0.5);
      body.friction = friction;
      std::map<int, ProjectileId> ids;
      for (int k = 0; k < 3; ++k) {
        const int i = (first + k) % 3;
        ids[i] = put(world, mass_of(1), body, at[i], {i == 0 ? kSpeed : 0.0, 0, 0});
      }
      const auto events = run_for(world, 0.5);
      EXPECT_EQ(of_kind(events, EventKind::hit).size(), 4u);
      const Vec3d cue = world[ids[0]].velocity(), left = world[ids[1]].velocity(), right = world[ids[2]].velocity();
      EXPECT_NEAR(cue.z, 0, 1e-12);
      EXPECT_NEAR(left.x, right.x, 1e-12);
      EXPECT_NEAR(left.z, -right.z, 1e-12);
      EXPECT_NEAR(cue.x + left.x + right.x, kSpeed, 1e-12);
      if (friction > 0) continue;
      EXPECT_NEAR(cue.x, -kSpeed / 5, 1e-12);
      EXPECT_NEAR(right.x, 0.6 * kSpeed, 1e-12);
      EXPECT_NEAR(right.z, 0.2 * std::sqrt(3.0) * kSpeed, 1e-12);
    }
}

/// A rack of fifteen is mirror-symmetric after the break, in whichever order it was set up.
TEST(Pairs, a_rack_stays_symmetric) {
  for (const bool backwards : {false, true}) {
    World world = make_world(space());
    std::vector<Vec3d> places;
    for (int row = 0; row < 5; ++row)
      for (int k = 0; k <= row; ++k) places.push_back({row * std::sqrt(3.0) / 2 * 1.0001, 0, (k - 0.5 * row) * 1.0001});
    std::vector<ProjectileId> ids(places.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const std::size_t i = backwards ? ids.size() - 1 - k : k;
      ids[i] = put(world, mass_of(1), ball(0.5, 0.95), places[i], {});
    }
    put(world, mass_of(1), ball(0.5, 0.95), {-3, 0, 0}, {9, 0, 0});
    run_for(world, 1);
    for (int row = 0, at = 0; row < 5; at += ++row)
      for (int k = 0; k <= row; ++k) {
        const Vec3d one = world[ids[static_cast<std::size_t>(at + k)]].position();
        const Vec3d mirrored = world[ids[static_cast<std::size_t>(at + row - k)]].position();
        EXPECT_NEAR(one.x, mirrored.x, 1e-9) << row << " " << k;
        EXPECT_NEAR(one.z, -mirrored.z, 1e-9) << row << " " << k;
      }
  }
}

/// Of balls in a row of equal ones, that touch or nearly do, the last one leaves with the speed of the first.
TEST(Pairs, newtons_cradle_passes_the_speed_on) {
  for (const double gap : {0.0, 1e-3})
    for (const bool backwards : {false, true})
      for (const Precision precision : {Precision::float64, Precision::float32}) {
        World world = make_world(space());
        std::vector<ProjectileId> row(5);
        for (int k = 0; k < 5; ++k) {
          const int i = backwards ? 4 - k : k;
          row[static_cast<std::size_t>(i)] =
              put(world, mass_of(1, precision), ball(0.5), {i * (1 + gap) + (i == 0 ? -2.0 : 0.0), 0, 0},
                  {i == 0 ? 8.0 : 0.0, 0, 0});
        }
        const auto events = run_for(world, 1);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(world[row[i]].velocity(), Vec3d{}) << i << " " << gap;
        EXPECT_DOUBLE_EQ(world[row[4]].velocity().x, 8);
        const auto hits = of_kind(events, EventKind::hit);
        ASSERT_EQ(hits.size(), 8u);
        EXPECT_NEAR(hits.back().time, (2 + 4 * gap) / 8, precision == Precision::float64 ? 1e-9 : 1e-6);
        EXPECT_NEAR(world[row[4]].position().x, 4 * (1 + gap) + 8 * (1 - (2 + 4 * gap) / 8), 1e-5);
      }
}

/// Two that fly in the same gravity and no air move along a line as one sees the other: hit or miss, and when, is
/// known.
TEST(Pairs, nothing_tunnels_and_nothing_is_made_up) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
  int met = 0, missed = 0;
  for (const Fidelity& fidelity : {Fidelity::small_arms(), Fidelity::game(), Fidelity::simulation()})
    for (const Precision precision : {Precision::float64, Precision::float32})
      for (const double speed : {5.0, 300.0, 8000.0})
        for (int shot = 0; shot < 40; ++shot) {
          World world = make_world(space());
          ProjectileDef p = mass_of(0.01, precision);
          p.fidelity = fidelity;
          p.fidelity.precision = precision;
          p.fidelity.drag = DragModel::off;
          p.fidelity.gravity = GravityModel::constant;
          p.fidelity.earth = EarthModel::flat;
          p.fidelity.rotation = RotationModel::none;
          BodyDef body = ball(0.005 + 0.1 * std::abs(unit(random)));
          body.gravity_scale = 1;
          const double radius = 2 * body.collision.radius;
          const double dt = 1.0 / (30 << shot % 4);
          const Vec3d x = any() * 3, v = any() * speed, w = any() * speed;
          const double at = dt * (1.5 + unit(random));  // nearest to each other then
          const Vec3d relative = v - w;
          Vec3d beside = any();
          beside -= relative * (dot(beside, relative) / length_squared(relative));
          const double miss = radius * (1 + unit(random));
          const Vec3d y = x + relative * at + normalized(beside) * miss;
          if (std::abs(miss - radius) < 1e-4 * radius + 1e-5) continue;
          if (length(y - x) < radius * 1.01) continue;
          const ProjectileId a = put(world, p, body, x, v);
          put(world, p, body, y, w);
          std::vector<Event> hits;
          for (int i = 0; i < 4; ++i) {
            world.step(dt);
            for (const Event& e : events_of(world, EventKind::hit)) hits.push_back(e);
          }
          const double square = length_squared(relative);
          const double time = at - std::sqrt(std::max(radius * radius - miss * miss, 0.0) / square);
          if (miss > radius || time < 0 || time > 4 * dt) {
            EXPECT_TRUE(hits.empty()) << speed << " " << miss / radius;
            ++missed;
            continue;
          }
          ++met;
          ASSERT_EQ(hits.size(), 2u) << speed << " " << miss / radius << " " << time / dt;
          EXPECT_EQ(hits[0].id, a);
          const double grazing = std::sqrt(1 - miss * miss / (radius * radius));
          const double exact = precision == Precision::float64 ? 1e-9 : 5e-7 * (5 + 4 * dt * speed);
          EXPECT_NEAR(hits[0].time, time, exact / std::sqrt(square) / grazing + 1e-12)
              << speed << " m/s, " << miss / radius << ", radius " << radius;
          EXPECT_NEAR(length(hits[0].position - hits[1].position), radius, exact);
        }
  EXPECT_GT(met, 200);
  EXPECT_GT(missed, 200);
}

struct Sums {
  Vec3d momentum;
  double energy = 0;
};
/// Of each in a gas().
double mass_in_gas(std::size_t i) { return 1 + static_cast<double>(i % 5); }

Sums sums_of(const World& world, const std::vector<ProjectileId>& ids) {
  Sums sums;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Vec3d v = world[ids[i]].velocity();
    const double m = mass_in_gas(i);
    sums.momentum += v * m;
    sums.energy += 0.5 * m * dot(v, v);
  }
  return sums;
}

std::vector<ProjectileId> gas(World& world, int count, double friction = 0, Precision precision = Precision::float64) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<ProjectileId> ids;
  for (int i = 0; i < count; ++i) {
    const Vec3d x{1.3 * (i % 6), 1.3 * (i / 6 % 6), 1.3 * (i / 36)};
    const Vec3d v{-(x.x - 3) * 5 + 5 * unit(random), -(x.y - 3) * 5 + 5 * unit(random),
                  -(x.z - 3) * 5 + 5 * unit(random)};
    ids.push_back(put(world, mass_of(mass_in_gas(static_cast<std::size_t>(i)), precision),
                      ball(0.3 + 0.05 * (i % 4), 1, friction), x, v));
  }
  return ids;
}

TEST(Pairs, a_cloud_keeps_momentum_and_energy) {
  World world = make_world(space());
  const auto ids = gas(world, 216);
  const Sums before = sums_of(world, ids);
  const auto events = run_for(world, 2, 1.0 / 60);
  const Sums after = sums_of(world, ids);
  EXPECT_GT(of_kind(events, EventKind::hit).size(), 600u);
  const double scale = std::sqrt(2 * before.energy * 600);
  EXPECT_LT(length(after.momentum - before.momentum), 1e-13 * scale);
  EXPECT_NEAR(after.energy / before.energy, 1, 1e-12);
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double radius = 0.6 + 0.05 * static_cast<double>(i % 4 + j % 4);
      ASSERT_GT(length(world[ids[i]].position() - world[ids[j]].position()), radius * (1 - 1e-8));
    }
}

TEST(Pairs, friction_gains_no_energy_and_keeps_momentum) {
  World world = make_world(space());
  const auto ids = gas(world, 216, 0.7);
  const auto total = [&](Vec3d& momentum, Vec3d& turning) {
    double energy = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const ProjectileId id = ids[i];
      const double m = mass_in_gas(i), r = world[id].body().collision.radius;
      const Vec3d v = world[id].velocity(), w = world[id].angular_velocity();
      energy += 0.5 * m * dot(v, v) + 0.5 * 0.4 * m * r * r * dot(w, w);
      momentum += v * m;
      turning += cross(world[id].position(), v) * m + w * (0.4 * m * r * r);
    }
    return energy;
  };
  Vec3d p, l, p_after, l_after;
  double energy = total(p, l);
  const double first = energy;
  for (int i = 0; i < 60; ++i) {
    world.step(1.0 / 60);
    Vec3d unused;
    const double now = total(unused, unused);
    ASSERT_LE(now, energy * (1 + 1e-12));
    energy = now;
  }
  EXPECT_LT(total(p_after, l_after), 0.98 * first);
  EXPECT_LT(length(p_after - p), 1e-10);
  EXPECT_LT(length(l_after - l), 1e-6) << "touches are exact to 1e-9 of the radii, and so is the moment of an impulse";
}

TEST(Pairs, neither_threads_nor_kernels_nor_order_of_spawning_matter) {
  const auto states = [](unsigned threads, const char* kernel, bool backwards) {
    EXPECT_TRUE(use_kernel(kernel));
    WorldDef def = space();
    def.threading = {.threads = threads, .rows_per_thread = 1};
    World world = make_world(def);
    std::vector<BodyState> at;
    std::vector<ProjectileId> ids(64);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<std::pair<Vec3d, Vec3d>> launches;
    for (int i = 0; i < 64; ++i) {
      const Vec3d x{2.0 * (i % 4) + 0.1 * unit(random), 2.0 * (i / 4 % 4) + 0.1 * unit(random),
                    2.0 * (i / 16) + 0.1 * unit(random)};
      launches.push_back({x, (Vec3d{3, 3, 3} - x) * 4.0});
    }
    for (std::size_t k = 0; k < 64; ++k) {
      const std::size_t i = backwards ? 63 - k : k;
      ids[i] = put(world, mass_of(1, Precision::float32), ball(0.4, 0.9, 0.3), launches[i].first, launches[i].second);
    }
    for (int i = 0; i < 30; ++i) world.step(1.0 / 60);
    for (const ProjectileId id : ids) at.push_back(world[id].state());
    use_kernel("");
    return at;
  };
  const auto expected = states(1, "", false);
  for (const auto& other : {states(4, "", false), states(1, "scalar", false), states(2, "base", true)})
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(other[i].position, expected[i].position) << i;
      ASSERT_EQ(other[i].velocity, expected[i].velocity) << i;
    }
}

/// A small ball on a large one, dropped together: it is thrown up with (3M - m)/(M + m) of the speed that they fall
/// with.
TEST(Pairs, a_ball_on_a_ball_that_bounces_off_the_ground) {
  WorldDef def = space(GroundMode::bounce);
  World world = make_world(def);
  const double m = 0.1, M = 0.9, gap = 1e-4, drop = 2, g = 9.80665;
  BodyDef large = ball(0.2), small = ball(0.05);
  large.gravity_scale = small.gravity_scale = 1;
  ProjectileDef heavy = mass_of(M), light = mass_of(m);
  heavy.fidelity.integrator = light.fidelity.integrator = Integrator::rk4;
  put(world, heavy, large, {0, drop, 0});
  const ProjectileId top = put(world, light, small, {0, drop + 0.25 + gap, 0});
  std::vector<Event> events;
  for (int i = 0; i < 64 && of_kind(events, EventKind::hit).empty(); ++i) {
    world.step(1.0 / 60);
    for (const Event& e : world.events()) events.push_back(e);
  }
  const auto bounces = of_kind(events, EventKind::bounced);
  ASSERT_EQ(bounces.size(), 3u);  // of the large one off the ground, then of both
  const double fall = std::sqrt(2 * drop / g), v = g * fall;
  const double later = gap / (2 * v);  // it comes up as the small one comes down
  EXPECT_NEAR(bounces[0].time, fall, 1e-9);
  EXPECT_NEAR(bounces[1].time, fall + later, 1e-8);
  const double up = v - g * later, down = -(v + g * later);
  EXPECT_NEAR(bounces[2].velocity.y, ((m - M) * down + 2 * M * up) / (m + M), 1e-7);
  EXPECT_EQ(bounces[2].id, top);
  const double left = world.time() - bounces[2].time;
  EXPECT_NEAR(world[top].velocity().y, bounces[2].velocity.y - g * left, 1e-9);
}

/// A ball thrown up meets another one near its apex, in a step that goes on until it is far below where it began.
TEST(Pairs, a_path_that_turns_back_within_a_step_is_met_where_it_turns) {
  const double up = 1, radius = 0.01, above = 0.055;
  World world = make_world(space());
  BodyDef thrown = ball(radius), still = ball(radius);
  thrown.gravity_scale = 1;
  still.kinematic = true;
  ProjectileDef p = mass_of(1);
  p.fidelity.integrator = Integrator::rk4;
  put(world, p, thrown, {0, 0, 0}, {0, up, 0});
  put(world, mass_of(1), still, {0, above, 0});
  world.step(0.4);
  const auto hits = events_of(world, EventKind::hit);
  ASSERT_EQ(hits.size(), 2u);
  const double g = 9.80665, way = above - 2 * radius;
  EXPECT_NEAR(hits[0].time, (up - std::sqrt(up * up - 2 * g * way)) / g, 1e-9);
  EXPECT_NEAR(hits[0].position.y, way, 1e-9);
}

/// What is left of the step is flown with drag, as a step that begins at the hit.
TEST(Pairs, the_rest_of_the_step_is_flown_with_the_models) {
  WorldDef def{.ground = {.mode = GroundMode::none}};
  for (const RotationModel rotation : {RotationModel::none, RotationModel::magnus, RotationModel::rigid_body}) {
    ProjectileDef p = bullet();
    p.fidelity = Fidelity::simulation();
    p.fidelity.earth = EarthModel::flat;
    p.fidelity.rotation = rotation;
    p.inertia.moments = {6e-8, 5e-7, 5e-7};
    BodyDef body = ball(0.004);
    body.gravity_scale = 1;
    BodyDef wall = body;
    wall.kinematic = true;
    World world = make_world(def);
    const ProjectileId id = put(world, p, body, {0, 0, 0}, {800, 0, 0});
    put(world, p, wall, {5, 0, 0});
    world.step(1.0 / 60);
    const auto bounces = events_of(world, EventKind::bounced);
    ASSERT_EQ(bounces.size(), 1u);
    World after = make_world(def);
    const ProjectileId same = put(after, p, body, bounces[0].position, bounces[0].velocity);
    after.step(1.0 / 60 - bounces[0].time);
    const double exact = rotation == RotationModel::rigid_body ? 1e-3 : 1e-9;  // of which the attitude is another one
    EXPECT_NEAR(length(world[id].position() - after[same].position()), 0, exact);
    EXPECT_NEAR(length(world[id].velocity() - after[same].velocity()), 0, 100 * exact);
  }
}

TEST(Pairs, every_rung_keeps_momentum_and_parts) {
  WorldDef def{.ground = {.mode = GroundMode::none}};
  for (const Fidelity& fidelity :
       {Fidelity::arcade(), Fidelity::game(), Fidelity::constant_air(), Fidelity::small_arms(), Fidelity::artillery(),
        Fidelity::simulation(), Fidelity::classic()})
    for (const bool forced : {false, true}) {
      World world = make_world(def);
      ProjectileDef p = bullet();
      p.fidelity = fidelity;
      p.inertia.moments = {6e-8, 5e-7, 5e-7};
      BodyDef body = ball(0.05, 1, 0.2);
      const ProjectileId a = put(world, p, body, {0, 0.02, 0}, {90, 0, 0});
      const ProjectileId b = put(world, p, body, {1, 0, 0}, {-90, 0, 0});
      for (const ProjectileId id : {a, b})
        if (forced) {
          ASSERT_TRUE(world[id].add_force(ConstantForce{{0, 0.001, 0}}));
        }
      world.step(1.0 / 60);
      const auto hits = events_of(world, EventKind::hit), bounces = events_of(world, EventKind::bounced);
      ASSERT_EQ(hits.size(), 2u);
      ASSERT_EQ(bounces.size(), 2u);
      const double exact = fidelity.precision == Precision::float32 ? 1e-4 : 1e-10;
      EXPECT_LT(length(hits[0].velocity + hits[1].velocity - bounces[0].velocity - bounces[1].velocity), exact);
      EXPECT_LT(world[a].velocity().x, -50);
      EXPECT_GT(world[b].velocity().x, 50);
      EXPECT_NEAR(world[a].position().x, hits[0].position.x + bounces[0].velocity.x * (1.0 / 60 - hits[0].time), 0.05);
      EXPECT_GT(length(world[a].angular_velocity()), 1) << "friction turns it";
    }
}

}  // namespace physim::world_pairs_test
