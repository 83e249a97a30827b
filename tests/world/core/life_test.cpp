// Coming and going: ids, pools, rules, pending launches, switches, things carried along, time.
#include <random>

#include "world/world_support.hpp"

namespace physim::world_life_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(Life, stale_ids_are_detected) {
  World world;
  const ProjectileId first = *world.spawn(stone(), {.position = {0, 5, 0}});
  ASSERT_TRUE(world[first].is_alive());
  EXPECT_TRUE(world[first].despawn());
  EXPECT_FALSE(world[first].despawn());
  EXPECT_EQ(world[first].status(), LifeStatus::retired);
  const ProjectileId second = *world.spawn(stone(), {.position = {0, 5, 0}});
  EXPECT_EQ(second.index, first.index);
  EXPECT_NE(second, first);
  EXPECT_EQ(world[first].status(), LifeStatus::unknown);
  EXPECT_FALSE(world[first].set_velocity({1, 0, 0}));
  EXPECT_EQ(world[first].position(), Vec3d{});
  EXPECT_FALSE(world[ProjectileId{}].is_alive());
  EXPECT_FALSE((world[ProjectileId{1000000, 1}].is_alive()));
}

TEST(Life, bad_input_is_refused_with_a_place) {
  World world;
  const auto refused = [&](const ProjectileDef& p, const Launch& launch, const BodyDef& body = {}) {
    const auto id = world.spawn(p, launch, body);
    return !id && !id.error().place.empty();
  };
  ProjectileDef p = stone();
  p.mass = kNan;
  EXPECT_TRUE(refused(p, {}));
  p.mass = -1;
  EXPECT_TRUE(refused(p, {}));
  p = stone();
  p.diameter = 0;
  EXPECT_TRUE(refused(p, {}));
  EXPECT_TRUE(refused(stone(), {.position = {kNan, 0, 0}}));
  EXPECT_TRUE(refused(stone(), {.velocity = Vec3d{0, kInf, 0}}));
  for (auto change : std::vector<void (*)(BodyDef&)>{
           [](BodyDef& b) { b.restitution = 1.5; }, [](BodyDef& b) { b.friction = -1; },
           [](BodyDef& b) { b.gravity_scale = kNan; }, [](BodyDef& b) { b.drag_scale = -1; },
           [](BodyDef& b) { b.pool = 3; }, [](BodyDef& b) { b.environment = 3; },
           [](BodyDef& b) { b.despawn.older = 0; }, [](BodyDef& b) { b.despawn.farther = -1; },
           [](BodyDef& b) { b.despawn.outside_box = true; }, [](BodyDef& b) { b.sleep_speed = kNan; }}) {
    BodyDef body;
    change(body);
    EXPECT_TRUE(refused(stone(), {}, body));
  }
  EXPECT_EQ(world.size(), 0u);
  EXPECT_EQ(world.counters().refused, 15u);
  EXPECT_FALSE(world.step(0));
  EXPECT_FALSE(world.step(kNan));
  EXPECT_FALSE(world.step(-1));
  EXPECT_EQ(world.advance(kInf), 0);
  EXPECT_FALSE(world.set_time_scale(-1));
  EXPECT_FALSE(world.spawn(KindId{77}, {}));

  for (auto change : std::vector<void (*)(WorldDef&)>{
           [](WorldDef& d) { d.step = 0; }, [](WorldDef& d) { d.step = kNan; }, [](WorldDef& d) { d.time_scale = -1; },
           [](WorldDef& d) { d.max_steps = 0; }, [](WorldDef& d) { d.ground.height = kNan; },
           [](WorldDef& d) { d.ground.restitution = 2; }, [](WorldDef& d) { d.detail.rungs.resize(1); },
           [](WorldDef& d) { d.environment.wind.velocity.x = kInf; }, [](WorldDef& d) { d.max_projectiles = 0; }}) {
    WorldDef def;
    change(def);
    const auto made = World::create(def);
    ASSERT_FALSE(made.ok());
    EXPECT_FALSE(made.error().place.empty());
  }
}

TEST(Life, pools_refuse_or_replace) {
  WorldDef def{.pools = {{"few", 3, WhenFull::refuse}, {"newest", 3, WhenFull::replace_oldest}}};
  World world = make_world(def);
  BodyDef body;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(world.spawn(stone(), {.position = {0, 9, 0}}, body));
  const auto too_many = world.spawn(stone(), {.position = {0, 9, 0}}, body);
  ASSERT_FALSE(too_many);
  EXPECT_EQ(too_many.error().place, "body.pool");
  EXPECT_EQ(world.size(), 3u);
  world.clear();
  body.pool = 1;
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 5; ++i) ids.push_back(*world.spawn(stone(), {.position = {0, 9, 0}}, body));
  EXPECT_EQ(world.size(), 3u);
  EXPECT_FALSE(world[ids[0]].is_alive());
  EXPECT_FALSE(world[ids[1]].is_alive());
  EXPECT_TRUE(world[ids[2]].is_alive());
  world[ids[3]].despawn();
  ids.push_back(*world.spawn(stone(), {.position = {0, 9, 0}}, body));
  EXPECT_TRUE(world[ids[2]].is_alive());
  ids.push_back(*world.spawn(stone(), {.position = {0, 9, 0}}, body));
  EXPECT_FALSE(world[ids[2]].is_alive());
  EXPECT_TRUE(world[ids[4]].is_alive());
}

TEST(Life, despawn_rules) {
  struct Case {
    void (*set)(DespawnRules&);
    Launch launch;
    Reason reason;
    double when;
  };
  const std::vector<Case> cases{
      {[](DespawnRules& d) { d.below = 3; }, {.position = {0, 5, 0}}, Reason::below, std::sqrt(2 * 2 / 9.80665)},
      {[](DespawnRules& d) { d.farther = 20; },
       {.position = {7, 50, 0}, .velocity = Vec3d{0, 0, 40}},
       Reason::farther,
       0.5},
      {[](DespawnRules& d) { d.older = 0.75; }, {.position = {0, 50, 0}}, Reason::older, 0.75},
      {[](DespawnRules& d) { d.slower = 5; },
       {.position = {0, 5, 0}, .velocity = Vec3d{0, 10, 0}},
       Reason::slower,
       5 / 9.80665},
      {[](DespawnRules& d) {
         d.outside_box = true;
         d.box_low = {-1, 0, -1};
         d.box_high = {10, 90, 1};
       },
       {.position = {0, 50, 0}, .velocity = Vec3d{40, 0, 0}},
       Reason::outside_box,
       0.25}};
  for (const Case& c : cases) {
    World world;
    BodyDef body;
    c.set(body.despawn);
    const ProjectileId id = *world.spawn(stone(), c.launch, body);
    const ProjectileId other = *world.spawn(stone(), {.position = {0, 90, 0}});
    const auto events = run_for(world, 1);
    const auto end =
        std::find_if(events.begin(), events.end(), [](const auto& e) { return e.kind == EventKind::expired; });
    ASSERT_NE(end, events.end());
    EXPECT_EQ(end->reason, c.reason);
    EXPECT_EQ(end->id, id);
    EXPECT_GE(end->time, c.when - 1e-9);
    EXPECT_LE(end->time, c.when + 2.5 / 64);
    EXPECT_EQ(world[id].status(), LifeStatus::expired);
    EXPECT_TRUE(world[other].is_alive());
  }
}

TEST(Life, pending_shots_start_later) {
  World world;
  const ProjectileId id = *world.spawn(*world.add_kind(stone()), {.position = {0, 50, 0}}, 0.5);
  EXPECT_EQ(world[id].status(), LifeStatus::pending);
  run_for(world, 0.5);
  EXPECT_EQ(world[id].position(), (Vec3d{0, 50, 0}));
  const auto events = run_for(world, 0.25);
  EXPECT_EQ(world[id].status(), LifeStatus::in_flight);
  EXPECT_NEAR(world[id].age(), 0.25, 1e-12);
  EXPECT_LT(world[id].position().y, 50);
  EXPECT_EQ(std::count_if(events.begin(), events.end(), [](auto& e) { return e.kind == EventKind::spawned; }), 1);
}

TEST(Life, switches_of_a_body) {
  World world;
  const Launch high{.position = {0, 100, 0}, .velocity = Vec3d{10, 0, 5}};
  const ProjectileId plain = *world.spawn(stone(), high);
  const ProjectileId floating = *world.spawn(stone(), high);
  const ProjectileId half = *world.spawn(stone(), high);
  const ProjectileId kinematic = *world.spawn(stone(), high);
  const ProjectileId frozen = *world.spawn(stone(), high);
  const ProjectileId heavy = *world.spawn(stone(), high, {.infinite_mass = true});
  EXPECT_TRUE(world[floating].set_use_gravity(false));
  EXPECT_TRUE(world[half].set_gravity_scale(0.5));
  EXPECT_TRUE(world[kinematic].set_kinematic(true));
  EXPECT_TRUE(world[frozen].set_frozen(Axes::x | Axes::y, Axes::none));
  EXPECT_EQ(world[heavy].inverse_mass(), 0);
  EXPECT_FALSE(world[heavy].apply_impulse({1, 1, 1}));
  run_for(world, 1);
  const double fall = 100 - world[plain].position().y;
  EXPECT_GT(fall, 4.5);
  EXPECT_EQ(world[floating].position().y, 100);
  EXPECT_NEAR(100 - world[half].position().y, 0.5 * fall, 1e-12);
  EXPECT_EQ(world[kinematic].position(), high.position);
  EXPECT_NEAR(world[frozen].position().z, 5, 1e-12);
  EXPECT_EQ(world[frozen].position().x, 0);
  EXPECT_EQ(world[frozen].position().y, 100);
  EXPECT_EQ(world[heavy].position(), high.position);
  EXPECT_TRUE(world[kinematic].set_position({1, 2, 3}));
  EXPECT_EQ(world[kinematic].position(), (Vec3d{1, 2, 3}));
  EXPECT_TRUE(world[floating].set_use_gravity(true));
  EXPECT_TRUE(world[kinematic].set_kinematic(false));
  run_for(world, 0.5);
  EXPECT_LT(world[floating].position().y, 100);
  EXPECT_LT(world[kinematic].position().y, 2);
}

TEST(Life, a_drag_scale_is_that_of_every_rung) {
  WorldDef def{.ground = {.mode = GroundMode::none}};
  Tolerance tolerance{.step = 1.0 / 64};
  const Until until{.ground = {}, .time = 2};
  for (const DragModel drag : {DragModel::damping, DragModel::linear_quadratic, DragModel::equation}) {
    ProjectileDef p = bullet();
    p.fidelity = Fidelity::constant_air();
    p.fidelity.integrator = Integrator::rk4;  // in frames, as the flight beside it
    p.fidelity.drag = drag;
    const Launch launch{.position = {0, 100, 0}, .velocity = Vec3d{300, 20, 5}};
    for (const double scale : {0.0, 0.5, 3.0}) {
      BodyDef body{.drag_scale = scale};
      World world = make_world(def);
      const ProjectileId id = *world.spawn(p, launch, body);
      run_for(world, 1);
      ProjectileDef scaled = p;
      scaled.drag.damping = std::pow(p.drag.damping, scale);
      scaled.drag.k1 *= scale;
      scaled.drag.k2 *= scale;
      scaled.drag.ballistic_coefficient = scale > 0 ? p.drag.ballistic_coefficient / scale : 1e300;
      Fidelity f = p.fidelity;
      if (scale == 0) f.drag = DragModel::off;
      const Flight flight = fly(scaled, launch, def.environment, f, tolerance, until);
      EXPECT_LT(length(world[id].position() - flight.at(1).position), 1e-9) << scale;
    }
  }
}

TEST(Life, a_drag_scale_leaves_the_drag_finite) {
  World world = make_world(WorldDef{});
  const auto refusal_of = [&](const ProjectileDef& p, double scale) {
    const auto id = world.spawn(p, {.speed = 1}, {.drag_scale = scale});
    return id ? std::string("none") : id.error().place;
  };
  ProjectileDef tiny = stone();
  tiny.diameter = 1e-200;  // whose square is nothing in double
  EXPECT_EQ(refusal_of(tiny, 1e300), "none");
  tiny.drag.form_factor = 1e100;
  EXPECT_EQ(refusal_of(tiny, 1e300), "body.drag_scale") << "infinite times nothing";
  ProjectileDef damped = stone();
  damped.drag.damping = 0.5;
  EXPECT_EQ(refusal_of(damped, 1e4), "body.drag_scale");
  EXPECT_EQ(refusal_of(damped, 100), "none");
  ProjectileDef linear = stone();
  linear.drag.k1 = 1e300;
  EXPECT_EQ(refusal_of(linear, 1e10), "body.drag_scale");
  ProjectileDef banded = stone();
  banded.drag.bands = {{0, 300}, {500, 200}};
  EXPECT_EQ(refusal_of(banded, 0), "none");
  EXPECT_EQ(refusal_of(banded, 1e308), "none");
  banded.drag.bands[0].ballistic_coefficient = 1e-300;
  EXPECT_EQ(refusal_of(banded, 1e308), "body.drag_scale");
}

TEST(Life, a_drag_scale_is_in_the_zero) {
  WorldDef def{.ground = {.mode = GroundMode::none}};
  World world = make_world(def);
  ProjectileDef p = bullet();
  p.fidelity = Fidelity::constant_air();
  Launch launch{.speed = 500, .sight = {.zero_range = 200}};
  const ProjectileId id = *world.spawn(p, launch, {.drag_scale = 2});
  ASSERT_TRUE(id);
  ProjectileDef dragged = p;
  dragged.drag.ballistic_coefficient /= 2;
  const auto elevation = must(zero_elevation(dragged, launch, def.environment, p.fidelity, 200));
  EXPECT_NEAR(std::atan2(world[id].velocity().y, world[id].velocity().x), elevation, 1e-12);
}

TEST(Life, an_updraught_that_throws_a_leaf_up_again_lands_it_before) {
  WorldDef def{.environment = {.wind = {.velocity = {0, 30, 0}}}};
  ProjectileDef leaf;
  leaf.mass = 0.01;
  leaf.drag.damping = 1e-5;
  leaf.fidelity = Fidelity::game();
  leaf.fidelity.drag = DragModel::damping;
  leaf.fidelity.integrator = Integrator::rk4;
  leaf.fidelity.precision = Precision::float64;
  World world = make_world(def);
  const ProjectileId id = *world.spawn(leaf, {.position = {0, 0.02, 0}, .velocity = Vec3d{0, -6, 0}});
  world.step(0.1);  // it dips below the ground and would come out of it within the step
  EXPECT_EQ(world[id].status(), LifeStatus::landed);
}

TEST(Life, frozen_closed_forms_stay_on_their_axis) {
  World world;
  ProjectileDef p = stone();
  p.fidelity.motion = Motion::closed_form;
  const ProjectileId id = *world.spawn(p, {.position = {0, 5, 0}, .velocity = Vec3d{10, 0, 5}}, {.frozen = Axes::y});
  run_for(world, 1);
  EXPECT_NEAR(world[id].position().x, 10, 1e-12);
  EXPECT_EQ(world[id].position().y, 5);
}

TEST(Life, things_carried_along) {
  World world;
  BodyDef body{.layers = 6, .colour = 0xff0000ff, .label = "arrow"};
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 5, 0}}, body);
  EXPECT_EQ(world[id].label(), "arrow");
  EXPECT_EQ(world[id].colour(), 0xff0000ffu);
  EXPECT_EQ(world[id].layers(), 6u);
  EXPECT_TRUE(world[id].set_user_data(42));
  EXPECT_TRUE(world[id].set_colour(1));
  EXPECT_EQ(world[id].user_data(), 42u);
  EXPECT_EQ(world[id].colour(), 1u);
  EXPECT_EQ(world[id].label(), "arrow");
  world[id].despawn();
  EXPECT_EQ(world[id].user_data(), 0u);
}

TEST(Life, turning_follows_its_closed_form) {
  World world;
  BodyDef body{.angular_drag = 0.5, .angular_velocity = {0, 2, 0}};
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 500, 0}}, body);
  run_for(world, 2);
  const double angle = 2 * (1 - std::exp(-1.0)) / 0.5;
  EXPECT_NEAR(world[id].angular_velocity().y, 2 * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(world[id].orientation().w, std::cos(angle / 2), 1e-12);
  EXPECT_NEAR(world[id].orientation().y, std::sin(angle / 2), 1e-12);
  EXPECT_TRUE(world[id].set_frozen(Axes::none, Axes::y));
  run_for(world, 0.5);
  EXPECT_EQ(world[id].angular_velocity().y, 0);
}

TEST(Time, advance_takes_fixed_steps_and_keeps_the_rest) {
  World world = make_world({.step = 1.0 / 64});
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 100, 0}, .velocity = Vec3d{64, 0, 0}});
  EXPECT_EQ(world.advance(2.5 / 64), 2);
  EXPECT_NEAR(world.fraction(), 0.5, 1e-12);
  EXPECT_NEAR(world[id].render_position().x, 1.5, 1e-12);
  world[id].set_smoothing(Smoothing::extrapolate);
  EXPECT_NEAR(world[id].render_position().x, 2.5, 1e-12);
  world[id].set_smoothing(Smoothing::none);
  EXPECT_NEAR(world[id].render_position().x, 2, 1e-12);
  world.set_paused(true);
  EXPECT_EQ(world.advance(1), 0);
  EXPECT_NEAR(world.time(), 2.0 / 64, 1e-15);
  world.single_step();
  EXPECT_NEAR(world.time(), 3.0 / 64, 1e-15);
  world.set_paused(false);
  world.set_time_scale(0.5);
  EXPECT_EQ(world.advance(1.0 / 64), 1);
  EXPECT_EQ(world.advance(10), 8);  // WorldDef::max_steps
  EXPECT_NEAR(world.counters().dropped_time, 5 - 8.0 / 64, 0.02);
  EXPECT_LT(world.fraction(), 1);
}

TEST(Time, a_change_of_step_keeps_clocks) {
  ProjectileDef p = stone();
  p.fidelity.motion = Motion::closed_form;
  World world;
  const ProjectileId id = *world.spawn(p, {.position = {0, 1000, 0}, .velocity = Vec3d{10, 20, 0}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> dt(0.001, 0.05);
  for (int i = 0; i < 100; ++i) world.step(dt(random));
  const double t = world.time();
  EXPECT_NEAR(world[id].age(), t, 1e-12);
  EXPECT_NEAR(world[id].position().y, 1000 + 20 * t - 0.5 * 9.80665 * t * t, 1e-9);
}

}  // namespace physim::world_life_test
