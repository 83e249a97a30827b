// Hinges and sliders, with their stops, against closed forms.
#include <random>

#include "world/joints_support.hpp"

namespace physim::world_joints_hinge_test {

using namespace test_joints;
using test::near;

/// No gravity at all.
World empty() { return World::create(space()).value(); }

TEST(JointHinge, swings_in_its_plane_with_the_gravity_in_it) {
  // The plane is tilted by 50 degrees: g sin(50) moves it, and it starts 1 rad off.
  const double tilt = 50 * kPi / 180, in_plane = kGravity * std::sin(tilt);
  World world = World::create(falling()).value();
  const Vec3d down{0, -std::sin(tilt), std::cos(tilt)}, axis{0, std::cos(tilt), std::sin(tilt)};
  const Vec3d at = down * std::cos(1) + Vec3d{1, 0, 0} * std::sin(1);
  const ProjectileId ball = put(world, mass_of(2), bob(), at);
  const JointId hinge = join(world, {.kind = JointKind::hinge, .a = ball, .axis = axis * 4, .reference = down});
  const std::vector<ProjectileId> all{ball};
  const double begun = energy(world, all);
  EXPECT_TRUE(near(std::abs(world.joint_state(hinge).angle), 1, 1e-12));
  const auto passes = upward_passes(world, 1.0 / 480, 40, [&] {
    EXPECT_LT(std::abs(dot(axis, world[ball].position())), 1e-11);
    EXPECT_LT(std::abs(length(world[ball].position()) - 1), 1e-11);
    return world.joint_state(hinge).angle;
  });
  const double period = (passes.back() - passes.front()) / static_cast<double>(passes.size() - 1);
  EXPECT_TRUE(near(period, pendulum_period(1, 1) * std::sqrt(kGravity / in_plane), 2e-5));
  EXPECT_TRUE(near(energy(world, all), begun, 0, 1e-4 * 2 * kGravity));
  EXPECT_EQ(world.joint_counts().unsolved, 0u);
}

TEST(JointHinge, turns_about_the_point_of_its_axis_that_is_nearest) {
  // A door: its handle is 0.8 m from hinges that stand 1 m below it. It is pushed across its plane, too.
  World world = empty();
  const ProjectileId handle = put(world, mass_of(3), weightless(), {0.8, 1, 0}, {0.4, 0.5, -2});
  const JointId hinge = join(world, {.kind = JointKind::hinge, .a = handle, .axis = {0, 2, 0}});
  EXPECT_TRUE(near(world.joint(hinge)->point, {0, 1, 0}, 1e-14));
  EXPECT_TRUE(near(*world.joint(hinge)->length, 0.8, 1e-14));
  for (int i = 0; i < 480; ++i) world.step(1.0 / 480);
  const double angle = 2 / 0.8;  // about y from x to -z
  EXPECT_TRUE(near(world.joint_state(hinge).angle, angle, 1e-4));
  EXPECT_TRUE(near(world[handle].position(), {0.8 * std::cos(angle), 1, -0.8 * std::sin(angle)}, 0, 2e-4));
  EXPECT_TRUE(near(length(world[handle].velocity()), 2, 1e-9));
  EXPECT_TRUE(near(world.joint_state(hinge).tension, 3 * 4 / 0.8, 1e-4));
}

TEST(JointHinge, is_carried_with_any_point_of_its_axis) {
  // A door that turns while a caller takes it along and lifts it, by the lower end of its axis.
  World world = empty();
  const ProjectileId handle = put(world, mass_of(3), weightless(), {0.8, 1, 0}, {1, 0.5, -2});
  const JointId hinge = join(world, {.kind = JointKind::hinge, .a = handle, .axis = {0, 1, 0}});
  const double dt = 1.0 / 480;
  for (int i = 0; i < 480; ++i) {
    const Vec3d velocity{1, 0.5, 0};
    ASSERT_TRUE(world.move_joint(hinge, {velocity * world.time(), velocity}));
    world.step(dt);
    ASSERT_TRUE(near(world[handle].position().y, 1 + 0.5 * world.time(), 1e-11));
  }
  EXPECT_TRUE(near(world.joint_state(hinge).angle, 2 / 0.8, 1e-4));
  EXPECT_TRUE(near(length(world[handle].position() - Vec3d{1, 1.5, 0}), 0.8, 1e-11));
}

TEST(JointHinge, its_force_is_that_of_all_it_keeps_and_breaks_it) {
  // Round a vertical axis: m v^2 / r inwards and m g upwards.
  const double force = 2 * std::hypot(9 / 1.5, kGravity);
  for (const double part : {0.9999, 1.0001}) {
    World world = World::create(falling()).value();
    const ProjectileId ball = put(world, mass_of(2), bob(), {1.5, 0, 0}, {0, 0, 3});
    const JointId hinge =
        join(world, {.kind = JointKind::hinge, .a = ball, .break_force = part * force, .axis = {0, 1, 0}});
    std::size_t broken = 0;
    for (int i = 0; i < 2000; ++i) {
      world.step(1.0 / 1000);
      for (const JointEvent& e : world.joint_events()) broken += e.kind == JointEventKind::broke;
    }
    EXPECT_EQ(broken, part < 1 ? 1u : 0u);
    EXPECT_TRUE(near(world.joint_state(hinge).force, part < 1 ? 0 : force, 1e-5));
  }
}

TEST(JointHinge, stops_at_its_limits_and_gains_nothing) {
  for (const double high : {0.3, 1.0, 2.5, 3.0}) {
    World world = empty();
    const ProjectileId ball = put(world, mass_of(1), weightless(), {1, 0, 0}, {0, 2, 0});
    const JointId hinge =
        join(world, {.kind = JointKind::hinge, .a = ball, .axis = {0, 0, 1}, .low_angle = -high, .high_angle = high});
    double most = 0;
    while (world.time() < high / 2 + 0.2) {
      world.step(1.0 / 60);
      most = std::max(most, world.joint_state(hinge).angle);
      ASSERT_LT(length(world[ball].velocity()), 2 + 1e-9);
    }
    EXPECT_TRUE(near(most, high, 0, 1e-9)) << high;
    EXPECT_TRUE(near(world.joint_state(hinge).angle, high, 0, 1e-9)) << high;
    EXPECT_LT(length(world[ball].velocity()), 1e-9);
    // It leaves the stop freely, and comes to the other one.
    ASSERT_TRUE(world[ball].set_velocity(cross(Vec3d{0, 0, -3}, world[ball].position())));
    world.step(1.0 / 60);
    EXPECT_TRUE(near(world.joint_state(hinge).angle, high - 3.0 / 60, 0, 1e-3));
    for (int i = 0; i < 180; ++i) world.step(1.0 / 60);
    EXPECT_TRUE(near(world.joint_state(hinge).angle, -high, 0, 1e-9)) << high;
    EXPECT_EQ(world.joint_counts().unsolved, 0u);
  }
}

TEST(JointHinge, rests_on_a_stop_with_its_weight) {
  World world = World::create(falling()).value();
  const ProjectileId ball = put(world, mass_of(2), bob(), {1, 0, 0});
  const JointId hinge =
      join(world, {.kind = JointKind::hinge, .a = ball, .axis = {0, 0, 1}, .low_angle = -kPi / 6, .high_angle = 1});
  for (int i = 0; i < 240; ++i) world.step(1.0 / 60);
  EXPECT_TRUE(near(world.joint_state(hinge).angle, -kPi / 6, 0, 1e-12));
  EXPECT_TRUE(near(world.joint_state(hinge).force, 2 * kGravity, 1e-9));
  EXPECT_TRUE(near(world.joint_state(hinge).tension, 2 * kGravity * std::sin(kPi / 6), 1e-9));
  EXPECT_LT(length(world[ball].velocity()), 1e-12);
}

TEST(JointHinge, two_projectiles_turn_about_each_other_and_keep_their_momentum) {
  for (const double ratio : {1.0, 1e3, 1e6}) {
    World world = empty();
    const std::vector<ProjectileId> ends{put(world, mass_of(1), weightless(), {1, 0, 0}, {0, 2, 0.5}),
                                         put(world, mass_of(ratio), weightless(), {0, 0, 0}, {0, 0, 0.5})};
    const JointId hinge = join(world, {.kind = JointKind::hinge, .a = ends[0], .b = ends[1], .axis = {0, 0, 1}});
    const Vec3d p = momentum(world, ends);
    const double e = energy(world, ends, 0);
    for (int i = 0; i < 960; ++i) {
      world.step(1.0 / 480);
      const Vec3d between = world[ends[0]].position() - world[ends[1]].position();
      ASSERT_LT(std::abs(length(between) - 1), 1e-11);
      ASSERT_LT(std::abs(between.z), 1e-11);
    }
    EXPECT_TRUE(near(momentum(world, ends), p, 1e-11)) << ratio;
    EXPECT_TRUE(near(energy(world, ends, 0), e, 1e-9)) << ratio;
    EXPECT_TRUE(near(world.joint_state(hinge).tension, ratio / (1 + ratio) * 4, 1e-4)) << ratio;
  }
}

// ------------------------------------------------------------------------------------------------------------ sliders
TEST(JointSlider, a_bead_goes_down_its_wire) {
  const Vec3d wire = Vec3d{0.6, -0.64, 0.48};  // of length one
  for (const JointKind kind : {JointKind::slider}) {
    World world = World::create(falling()).value();
    const ProjectileId bead = put(world, mass_of(0.4), bob(), {1, 2, 3}, wire * 0.5);
    const JointId slider = join(world, {.kind = kind, .a = bead, .point = {1, 2, 3}, .axis = wire * 3});
    for (int i = 0; i < 600; ++i) {
      world.step(1.0 / 60);
      const double t = world.time(), way = 0.5 * t + kGravity * 0.64 / 2 * t * t;
      const Vec3d to = world[bead].position() - Vec3d{1, 2, 3};
      ASSERT_TRUE(near(world.joint_state(slider).way, way, 1e-12)) << i;
      ASSERT_LT(length(to - wire * way), 1e-11 * (1 + way)) << i;
    }
    EXPECT_TRUE(near(world.joint_state(slider).force, 0.4 * kGravity * std::sqrt(1 - 0.64 * 0.64), 1e-9));
    EXPECT_EQ(world.joint_state(slider).tension, 0);
    EXPECT_FALSE(world.joint(slider)->length);
  }
}

TEST(JointSlider, stops_at_its_limits_and_gains_nothing) {
  World world = World::create(falling()).value();
  const ProjectileId bead = put(world, mass_of(0.4), bob(), {0, 1, 0}, {0, 3, 0});
  const JointId slider =
      join(world, {.kind = JointKind::slider, .a = bead, .axis = {0, 1, 0}, .low = -2.0, .high = 1.25});
  const std::vector<ProjectileId> all{bead};
  double most = 0, before = energy(world, all);
  for (int i = 0; i < 120; ++i) {
    world.step(1.0 / 60);
    most = std::max(most, world.joint_state(slider).way);
    ASSERT_LT(energy(world, all), before + 1e-9);
    before = energy(world, all);
  }
  EXPECT_TRUE(near(most, 1.25, 0, 1e-12));
  EXPECT_TRUE(near(world.joint_state(slider).way, -2, 0, 1e-12));
  EXPECT_LT(length(world[bead].velocity()), 1e-12);
  EXPECT_TRUE(near(world.joint_state(slider).force, 0.4 * kGravity, 1e-9)) << "it stands on the lower one";
}

TEST(JointSlider, a_heavy_cart_and_its_pendulum) {
  // A bob of 1 kg on a cart of M on a level rail: small swings have the period 2 pi (l M / (g (M + m)))^(1/2).
  for (const double cart_mass : {1.0, 1e3, 1e-3}) {
    World world = World::create(falling()).value();
    const ProjectileId cart = put(world, mass_of(cart_mass), bob(), {0, 0, 0});
    const double angle = 0.02 * std::min(1.0, std::sqrt(cart_mass));  // small beside the mass of the cart, too
    const ProjectileId ball = put(world, mass_of(1), bob(), {std::sin(angle), -std::cos(angle), 0});
    join(world, {.kind = JointKind::slider, .a = cart, .axis = {1, 0, 0}});
    join(world, {.a = ball, .b = cart});
    const double period = 2 * kPi * std::sqrt(cart_mass / (kGravity * (cart_mass + 1)));
    const auto passes = upward_passes(world, period / 400, 12 * period,
                                      [&] { return world[ball].position().x - world[cart].position().x; });
    ASSERT_GT(passes.size(), 9u);
    const double found = (passes.back() - passes.front()) / static_cast<double>(passes.size() - 1);
    EXPECT_TRUE(near(found, period, 3e-4)) << cart_mass;
    EXPECT_TRUE(near(momentum(world, std::vector{cart, ball}).x, 0, 0, 1e-9)) << cart_mass;
    EXPECT_LT(std::abs(world[cart].position().y), 1e-11);
  }
}

// ------------------------------------------------------------------------------------------------------------- carried
/// A wire on a table that turns about the vertical, and a bead on it.
struct Whirl {
  double omega = 2;
  World world = World::create(falling()).value();
  ProjectileId bead;
  JointId slider;

  explicit Whirl(double break_force = 0) {
    Scene scene;
    const InstanceId table = scene
                                 .add({.shape = scene.add_shape(BoxShape{{0.1, 0.1, 0.1}}).value(),
                                       .motion = SteadyMotion{.angular_velocity = {0, omega, 0}}})
                                 .value();
    EXPECT_TRUE(world.set_scene(scene));
    BodyDef passes = bob();
    passes.collision.on_hit = OnHit::pass;
    bead = put(world, mass_of(0.7), passes, {0.5, 0, 0}, {0, 0, -0.5 * omega});
    Joint joint{.kind = JointKind::slider, .a = bead, .thing = table, .axis = {1, 0, 0}};
    if (break_force > 0) joint.break_force = break_force;
    slider = join(world, joint);
  }
};

TEST(JointSlider, a_bead_on_a_wire_that_turns_flies_out) {
  // r = r0 cosh(omega t); across the wire it needs 2 omega r' for Coriolis, and g upwards.
  const auto error_after = [](double dt) {
    Whirl w;
    for (int i = 0; i < static_cast<int>(std::round(1 / dt)); ++i) {
      w.world.step(dt);
      const double r = 0.5 * std::cosh(w.omega * w.world.time()), turned = w.omega * w.world.time();
      const Vec3d at = w.world[w.bead].position();
      EXPECT_TRUE(near(length(at), w.world.joint_state(w.slider).way, 1e-12));
      EXPECT_LT(length(cross(at, Vec3d{std::cos(turned), 0, -std::sin(turned)})), 1e-11 * r);
    }
    EXPECT_EQ(w.world.joint_counts().unsolved, 0u);
    const double out = 0.5 * w.omega * std::sinh(w.omega);
    EXPECT_TRUE(near(w.world.joint_state(w.slider).force, 0.7 * std::hypot(2 * w.omega * out, kGravity), 3 * dt));
    return std::abs(w.world.joint_state(w.slider).way - 0.5 * std::cosh(w.omega));
  };
  const double coarse = error_after(1.0 / 128), fine = error_after(1.0 / 256);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(coarse / fine, 3.7);
  EXPECT_LT(coarse / fine, 4.3);
}

TEST(JointSlider, breaks_where_the_wire_pushes_too_hard) {
  // 2 m omega r' and m g come to the limit where sinh(omega t) is (f^2 - (m g)^2)^(1/2) / (2 m omega^2 r0).
  const double f = 12, m = 0.7, dt = 1.0 / 2000;
  Whirl w(f);
  double broken = 0;
  while (w.world.time() < 2 && broken == 0) {
    w.world.step(dt);
    for (const JointEvent& e : w.world.joint_events())
      if (e.kind == JointEventKind::broke) broken = e.time;
  }
  const double out = std::sqrt(f * f - m * m * kGravity * kGravity) / (2 * m * w.omega * w.omega * 0.5);
  EXPECT_TRUE(near(broken, std::asinh(out) / w.omega, 0, 2 * dt));
}

TEST(JointHinge, a_governor_stands_at_the_angle_of_its_speed) {
  // A hinge whose level axis turns about the vertical with omega: cos(angle) = g / (omega^2 l).
  const double omega = 6, l = 0.4, angle = std::acos(kGravity / (omega * omega * l));
  Scene scene;
  const InstanceId shaft = scene
                               .add({.shape = scene.add_shape(BoxShape{{0.01, 0.01, 0.01}}).value(),
                                     .motion = SteadyMotion{.angular_velocity = {0, omega, 0}}})
                               .value();
  World world = make_world(falling(), scene);
  const double out = l * std::sin(angle);
  const ProjectileId ball = put(world, mass_of(2), bob(), {out, -l * std::cos(angle), 0}, {0, 0, -omega * out});
  const JointId hinge =
      join(world, {.kind = JointKind::hinge, .a = ball, .thing = shaft, .axis = {0, 0, 1}, .reference = {0, -1, 0}});
  for (int i = 0; i < 2000; ++i) {
    world.step(1.0 / 1000);
    const double turned = omega * world.time();
    ASSERT_TRUE(near(world.joint_state(hinge).angle, angle, 1e-4)) << i;
    ASSERT_TRUE(
        near(world[ball].position(), {out * std::cos(turned), -l * std::cos(angle), -out * std::sin(turned)}, 0, 1e-4))
        << i;
  }
  EXPECT_TRUE(near(world.joint_state(hinge).tension, 2 * kGravity / std::cos(angle), 1e-3));
  EXPECT_EQ(world.joint_counts().unsolved, 0u);
}

// ------------------------------------------------------------------------------------------------------------- crowds
/// 40 bodies over a ground and 100 joints of all kinds between any two of them, many of which contradict each other.
World crowd(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<double>(random() % n); };
  const auto some = [&] { return Vec3d{below(61) / 10 - 3, below(61) / 10 + 2, below(61) / 10 - 3}; };
  WorldDef def = falling();
  def.ground.mode = GroundMode::bounce;
  World world = World::create(def).value();
  std::vector<ProjectileId> all;
  for (int i = 0; i < 40; ++i)
    all.push_back(put(world, mass_of(0.2 + below(5)), bob(), some(), some() - Vec3d{0, 5, 0}));
  for (int i = 0; i < 100; ++i) {
    Joint joint{.kind = static_cast<JointKind>(random() % 5), .a = all[random() % 40]};
    if (random() % 6 != 0) joint.b = all[random() % 40];
    joint.point = some();
    if (random() % 3 == 0) joint.length = 0.5 + below(4);
    joint.stiffness = below(1000), joint.damping = below(5);
    if (joint.kind == JointKind::cable) joint.restitution = 0.5;
    if (joint.kind == JointKind::hinge) joint.low_angle = -1, joint.high_angle = 1;
    if (joint.kind == JointKind::slider) joint.length = {}, joint.low = -5, joint.high = 5;
    if (joint.kind >= JointKind::hinge) joint.axis = {1 + below(3), below(3) - 1, 0};
    if (!joint.b && random() % 2 == 0) joint.velocity = {below(3) - 1, 0, 0.5};
    static_cast<void>(world.add_joint(joint));
  }
  return world;
}

/// Steps of some milliseconds; without a bound for the search one took seconds.
TEST(JointHinge, a_crowd_that_contradicts_itself_is_told_and_not_searched_without_end) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    World world = crowd(seed);
    EXPECT_GT(world.joint_counts().joints, 80u);
    for (int i = 0; i < 10; ++i) world.step(1.0 / 60);
    EXPECT_GE(world.joint_counts().unsolved, 10u);
    EXPECT_GT(world.joint_counts().residual, 0.1);
    for (const ProjectileId id : world.ids()) EXPECT_TRUE(std::isfinite(length(world[id].position()))) << seed;
  }
}

// --------------------------------------------------------------------------------------------------------------- doors
TEST(JointHinge, it_is_kept_and_played_again_to_the_bit) {
  World world = World::create(falling()).value();
  std::vector<std::byte> recorded;
  ASSERT_TRUE(world.record(record_into(recorded)));
  const ProjectileId a = put(world, mass_of(1), bob(), {1, 0, 0}), b = put(world, mass_of(2), bob(), {1, -1, 0});
  join(world, {.kind = JointKind::slider, .a = a, .axis = {1, -1, 0.2}, .low = -1.0, .high = 2.0});
  const JointId hinge = join(
      world, {.kind = JointKind::hinge, .a = b, .b = a, .axis = {0.1, 0, 1}, .low_angle = -0.5, .high_angle = 1.5});
  for (int i = 0; i < 50; ++i) world.step(1.0 / 60);
  World loaded = reloaded(world);
  EXPECT_EQ(*loaded.joint(hinge), *world.joint(hinge));
  EXPECT_EQ(loaded.joint_state(hinge).force, world.joint_state(hinge).force);
  for (int i = 0; i < 100; ++i) world.step(1.0 / 60), loaded.step(1.0 / 60);
  EXPECT_EQ(loaded.hash(), world.hash());
  replayed(world, recorded);
}

TEST(JointHinge, bad_axes_and_limits_are_refused_with_a_place) {
  World world = World::create(falling()).value();
  const ProjectileId a = put(world, mass_of(1), bob(), {1, 0, 0}), b = put(world, mass_of(2), bob(), {1, -1, 0});
  const auto refused = [&](const Joint& joint, const std::string& place) {
    const auto id = world.add_joint(joint);
    ASSERT_FALSE(id) << place;
    EXPECT_EQ(id.error().place, place) << id.error().text();
    EXPECT_FALSE(id.error().message.empty());
  };
  const Vec3d z{0, 0, 1};
  for (const JointKind kind : {JointKind::hinge, JointKind::slider}) {
    refused({.kind = kind, .a = a}, "joint.axis");
    refused({.kind = kind, .a = a, .axis = {0, test::kNan, 0}}, "joint.axis");
    refused({.kind = kind, .a = a, .axis = {1e300, 1e300, 0}}, "joint.axis");
  }
  refused({.a = a, .axis = z}, "joint.axis");
  refused({.a = a, .reference = z}, "joint.reference");
  refused({.kind = JointKind::slider, .a = a, .axis = z, .reference = z}, "joint.reference");
  refused({.kind = JointKind::hinge, .a = a, .axis = z, .reference = z}, "joint.reference");
  refused({.kind = JointKind::hinge, .a = a, .point = {1, 0, 5}, .axis = z}, "joint.reference");
  refused({.kind = JointKind::hinge, .a = a, .axis = z, .low_angle = 1.0, .high_angle = 1.0}, "joint.high_angle");
  refused({.kind = JointKind::hinge, .a = a, .axis = z, .low_angle = 2.0, .high_angle = -1.0}, "joint.high_angle");
  refused({.kind = JointKind::hinge, .a = a, .axis = z, .low_angle = -3.2}, "joint.low_angle");
  refused({.kind = JointKind::hinge, .a = a, .axis = z, .high_angle = test::kNan}, "joint.high_angle");
  refused({.kind = JointKind::hinge, .a = a, .axis = z, .low = 1.0}, "joint.low");
  refused({.kind = JointKind::slider, .a = a, .axis = z, .low = 1.0, .high = 0.0}, "joint.high");
  refused({.kind = JointKind::slider, .a = a, .axis = z, .high = kInfinity}, "joint.high");
  refused({.kind = JointKind::slider, .a = a, .axis = z, .low_angle = 0.0}, "joint.low_angle");
  refused({.kind = JointKind::slider, .a = a, .length = 1, .axis = z}, "joint.length");
  refused({.a = a, .b = b, .high = 1.0}, "joint.high");
  EXPECT_EQ(world.joint_counts().joints, 0u);
  EXPECT_TRUE(world.add_joint({.kind = JointKind::slider, .a = a, .b = b, .axis = z, .low = 0.0}));
}

}  // namespace physim::world_joints_hinge_test
