// The original's mode of the launcher: its three shots with its 18 settings, against its frame loop.
#include <cmath>

#include "client/support.hpp"
#include "simclient/core/compare.hpp"

namespace physim::client {
namespace {

struct OriginalShot {
  const char* name;
  double mass, forward, up, gravity, damping;
};
constexpr OriginalShot kShots[] = {
    {"artillery", 200, 40, 2, 20, 0.9}, {"bullet", 2, 35, 1, 2, 0.9}, {"laser", 1, 35, 1, 0, 1}};

/// The loop of docs/original.md, with forces that act in every frame: height and distance after so many.
Vec3d by_the_loop(const OriginalShot& s, const Launcher& set, int e, int frames) {
  const bool pushed = set.original_motion() == Motion::force;
  const OriginalEffect gravity = set.original_gravity(), drag = set.original_drag();
  const double g = gravity == OriginalEffect::constant ? s.gravity : gravity == OriginalEffect::force && pushed ? 4 : 0;
  const double d = drag == OriginalEffect::constant ? s.damping : 1;
  const bool dragged = drag == OriginalEffect::force && pushed;
  double x = 0, y = 1.5, vx = pushed ? 0 : s.forward, vy = pushed ? 0 : s.up * e, ax = 0, ay = 0;
  for (int i = 0; i < frames; ++i) {
    x += vx / 60, y += vy / 60;
    const double rate = dragged ? (0.1 + 0.4 * std::hypot(vx, vy)) / s.mass : 0;  // of the frame's start
    const double next_ax = (pushed ? 10 : 0) - rate * vx, next_ay = (pushed ? e : 0) - g - rate * vy;
    vx += ax / 60, vy += ay / 60;
    vx *= std::pow(d, 1.0 / 60), vy *= std::pow(d, 1.0 / 60);
    ax = next_ax, ay = next_ay;
  }
  return {x, y, 0};
}

TEST(OriginalMode, all_settings_of_all_shots_fly_as_the_loop_does) {
  Client client = client_of();
  for (const OriginalShot& s : kShots)
    for (int i = 0; i < 18; ++i) {
      ASSERT_TRUE(client.launcher.select(s.name));
      for (int e = 0; e < 6; e += 5) {
        while (client.launcher.elevation_setting() != e) client.launcher.cycle_elevation();
        ASSERT_TRUE(client.fire());
        const ProjectileId id = client.selected;
        int frames = 0;
        for (; frames < 24 && client.session.world()[id].is_alive(); ++frames) client.session.single_step();
        if (!client.session.world()[id].is_alive()) continue;  // it landed
        const Vec3d wanted = by_the_loop(s, client.launcher, e, frames), at = client.session.world()[id].position();
        const std::string what = std::string(s.name) + " " + std::string(name(client.launcher.original_motion())) +
                                 " " + std::string(name(client.launcher.original_gravity())) + " " +
                                 std::string(name(client.launcher.original_drag())) + " e " + std::to_string(e);
        EXPECT_NEAR(at.x, wanted.x, 2e-4) << what;
        EXPECT_NEAR(at.y, wanted.y, 2e-4) << what;
      }
      client.launcher.cycle_drag();
      if (i % 3 == 2) client.launcher.cycle_gravity();
      if (i % 9 == 8) client.launcher.cycle_motion();
    }
}

TEST(OriginalMode, settings_stay_when_another_of_the_three_is_chosen) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "motion; drag; gravity; bullet"));
  EXPECT_EQ(client.launcher.original_motion(), Motion::force);
  EXPECT_EQ(client.launcher.original_drag(), OriginalEffect::force);
  EXPECT_EQ(client.launcher.original_gravity(), OriginalEffect::force);
  EXPECT_EQ(client.launcher.speed(), 0);
  EXPECT_EQ(client.launcher.shot().projectile.force, (Vec3d{20, 4, 0}));  // 2 kg, (10, e) m/s^2
  EXPECT_EQ(client.launcher.elevation_setting(), 2);
  client.launcher.cycle_motion();
  EXPECT_EQ(client.launcher.shot().projectile.force, Vec3d{});
  EXPECT_NEAR(client.launcher.speed(), std::hypot(35, 2), 1e-12);
}

TEST(OriginalMode, forces_do_nothing_in_motion_velocity) {
  Client client = client_of();
  while (client.launcher.original_drag() != OriginalEffect::force) client.launcher.cycle_drag();
  while (client.launcher.original_gravity() != OriginalEffect::force) client.launcher.cycle_gravity();
  EXPECT_EQ(client.launcher.shot().projectile.fidelity.drag, DragModel::off);
  EXPECT_EQ(client.launcher.shot().projectile.fidelity.gravity, GravityModel::off);
}

TEST(OriginalMode, the_push_follows_the_barrel_and_the_mass_and_the_arrow_shows_it) {
  Client client = client_of();
  client.launcher.cycle_motion();
  client.launcher.turn(0.5, 0);
  Vec3d push = client.launcher.shot().projectile.force;
  EXPECT_NEAR(push.x, 2000 * std::cos(0.5), 1e-9);
  EXPECT_NEAR(push.z, 2000 * std::sin(0.5), 1e-9);
  EXPECT_NEAR(push.y, 400, 1e-9);
  ASSERT_TRUE(client.set("shot.mass=50 kg"));
  EXPECT_NEAR(client.launcher.shot().projectile.force.y, 100, 1e-9);
  client.launcher.turn(0, 0.3);
  push = client.launcher.shot().projectile.force;
  EXPECT_NEAR(std::atan2(push.y, std::hypot(push.x, push.z)), client.launcher.elevation(), 1e-12);
  EXPECT_NEAR(length(push), 50 * std::hypot(10, 2), 1e-9);
  const auto arrow = must(client.arrow());
  const Vec3d way = normalized(arrow.to - arrow.from);
  EXPECT_NEAR(dot(way, normalized(push)), 1, 1e-12);
}

TEST(OriginalMode, a_push_set_by_hand_stays) {
  Client client = client_of();
  ASSERT_TRUE(client.set("shot.fidelity.motion=force"));
  ASSERT_TRUE(client.set("shot.force=[7, 0, 0]"));
  client.launcher.turn(0.1, 0);
  EXPECT_EQ(client.launcher.shot().projectile.force, (Vec3d{7, 0, 0}));
  EXPECT_GT(client.launcher.speed(), 40) << "what was set by hand is no key";
}

TEST(OriginalMode, ends_with_another_loop_and_other_shots) {
  Client client = client_of();
  EXPECT_TRUE(client.launcher.is_original());
  ASSERT_TRUE(client.set("shot.fidelity.integrator=tsit5"));
  EXPECT_FALSE(client.launcher.is_original());
  client.launcher.cycle_drag();
  EXPECT_EQ(client.launcher.shot().projectile.fidelity.drag, DragModel::linear_quadratic);
  client.launcher.cycle_drag();
  EXPECT_EQ(client.launcher.shot().projectile.fidelity.drag, DragModel::equation);
  ASSERT_TRUE(client.launcher.select("sphere"));
  EXPECT_FALSE(client.launcher.is_original());
}

/// The comparison flies the shot beside it, with its own gravity and its push.
TEST(OriginalMode, the_comparison_flies_what_is_fired) {
  for (const char* type : {"artillery", "bullet", "laser"})
    for (const bool pushed : {false, true}) {
      Client client = client_of();
      ASSERT_TRUE(client.launcher.select(type));
      if (pushed) client.launcher.cycle_motion(), client.launcher.cycle_gravity(), client.launcher.cycle_drag();
      const ComparedRung own = client.comparison().front();
      ASSERT_EQ(own.name, "as set");
      ASSERT_TRUE(own.problem.empty()) << own.problem;
      ASSERT_TRUE(client.fire());
      const ProjectileId id = client.selected;
      for (int i = 0; i < 20; ++i) client.session.single_step();
      const Vec3d at = client.session.world()[id].position(), beside = own.flight->at(20.0 / 60).position;
      EXPECT_NEAR(at.x, beside.x, 1e-4) << type << pushed;
      EXPECT_NEAR(at.y, beside.y, 1e-4) << type << pushed;
    }
}

/// What is saved is what was set.
TEST(OriginalMode, saves_what_it_fires) {
  Client client = client_of();
  client.launcher.cycle_motion(), client.launcher.cycle_gravity(), client.launcher.cycle_drag();
  Scenario scenario{.shots = {client.launcher.shot()}};
  const Scenario again = must(parse_scenario(scenario_text(scenario), "f.toml"));
  const Flight a = fly_shot(scenario, scenario.shots[0]), b = fly_shot(again, again.shots[0]);
  EXPECT_EQ(a.end().position, b.end().position);
}

/// In flight: mass, damping and drag by the session, as the panel does it.
TEST(OriginalMode, its_shots_are_changed_in_flight) {
  Client client = client_of();
  client.launcher.cycle_motion();
  ASSERT_TRUE(client.fire());
  const ProjectileId id = client.selected;
  for (int i = 0; i < 3; ++i) client.session.single_step();
  EXPECT_NEAR(client.session.world()[id].accelerations().total.x, 10, 1e-5);
  ASSERT_TRUE(client.session.edit(id, [](Projectile p) { return p.set_mass(400); }));
  for (int i = 0; i < 2; ++i) client.session.single_step();
  EXPECT_NEAR(client.session.world()[id].accelerations().total.x, 5, 1e-5);
  EXPECT_EQ(client.session.tracks().back().samples.back().mass, 400);
  EXPECT_TRUE(client.session.tracks().back().edited);
  EXPECT_FALSE(client.session.edit(id, [](Projectile p) { return p.set_mass(-1); }));
  client.session.step_back();
  client.session.step_back();
  EXPECT_EQ(client.session.world()[id].mass(), 400);
  client.session.step_back();
  EXPECT_EQ(client.session.world()[id].mass(), 200);
}

}  // namespace
}  // namespace physim::client
