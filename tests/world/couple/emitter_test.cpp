// Emitters of worlds: sub-emitters, limits, moments, calls, and what is refused.
#include <set>

#include "world/emitter_support.hpp"

namespace physim::world_emitter_test {

/// A shell that is thrown up, bursts after a while, and whose stars burst again where they land.
struct Fireworks {
  World world = make_world({.ground = {.mode = GroundMode::land}, .apex_events = true});
  EmitterId embers, stars, shells;

  explicit Fireworks(double per_second = 20) {
    EmitterDef def = spray(kind_of(world, spark()), 0, 0.3);
    def.cycle.plays = false;
    def.from = {.shape = EmitShape::sphere, .radius = 0};
    def.start.speed = {1, 2};
    embers = added(world, def);
    def.seed = 8;
    def.start.speed = {3, 5};
    def.start.lifetime = {20};
    def.subs = {{.on = SubEvent::landing, .emitter = embers, .count = {2}}};
    stars = added(world, def);
    def.seed = 9;
    def.cycle.plays = true;
    def.per_second = {per_second};
    def.from = {.shape = EmitShape::cone, .radius = 0.5};
    def.start.speed = {15, 20};
    def.start.lifetime = {1.1, 1.4};
    def.subs = {{.on = SubEvent::death, .emitter = stars, .count = {4, 6}, .inherit_velocity = 0.5}};
    shells = added(world, def);
  }
};

TEST(Emitter, sub_emitters_fire_once_each_at_the_moment_and_place) {
  std::vector<Event> first;
  for (const int rate : kFrameRates) {
    Fireworks show;
    std::vector<Event> events;
    step_to(show.world, 4, rate, &events);
    const std::vector<Event> born = told(events, EventKind::spawned, 3.9);
    if (first.empty()) first = born;
    ASSERT_GE(born.size(), 450u);
    ASSERT_EQ(born.size(), first.size()) << rate;
    for (std::size_t i = 0; i < born.size(); ++i) {
      EXPECT_NEAR(born[i].time, first[i].time, 1e-12) << rate;
      EXPECT_LT(length(born[i].position - first[i].position), 1e-10) << rate;
      EXPECT_LT(length(born[i].velocity - first[i].velocity), 1e-9) << rate;
    }
    // What landed on the ground, at its moment, gave two embers there where it was a star.
    std::map<double, std::size_t> at;
    for (const Event& b : told(events, EventKind::spawned, 4)) ++at[b.time];
    const std::vector<Event> landings = told(events, EventKind::landed, 4);
    std::uint64_t landed = 0;
    for (const EmitterId id : show.world.emitters()) landed += show.world.emitter_counts(id).landed;
    EXPECT_EQ(landings.size(), landed);
    std::size_t set_off = 0;
    for (const Event& e : landings) {
      EXPECT_NEAR(e.position.y, 0, 1e-9);
      set_off += at.contains(e.time) ? 1 : 0;
    }
    EXPECT_GE(set_off, show.world.emitter_counts(show.stars).landed);
    EXPECT_EQ(show.world.emitter_counts(show.embers).born, 2 * show.world.emitter_counts(show.stars).landed);
    EXPECT_EQ(show.world.emitter_counts(show.embers).refused, 0u);
  }
}

TEST(Emitter, counts_add_up) {
  Fireworks show;
  step_to(show.world, 5, 60);
  for (const EmitterId id : show.world.emitters()) {
    const EmitterCounts c = show.world.emitter_counts(id);
    EXPECT_EQ(c.born, c.aged + c.landed + c.expired + c.replaced + c.taken + c.alive);
    EXPECT_EQ(c.alive, show.world.particles(id, {}));
    EXPECT_GT(c.born, 50u);
  }
  EXPECT_EQ(show.world.emitter_counts(show.shells).aged + show.world.emitter_counts(show.shells).alive, 100u);
}

TEST(Emitter, each_hit_of_a_wall_fires_once) {
  std::uint64_t first = 0;
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    Scene scene;
    const ShapeId box = *scene.add_shape(BoxShape{{0.001, 50, 50}});
    ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = {5, 0, 0}}}));
    ASSERT_TRUE(world.set_scene(scene));
    EmitterDef def{
        .kind = kind_of(world, spark()), .cycle = {.plays = false}, .start = {.lifetime = {0.01}}, .maximum = 1u << 30};
    const EmitterId sparks = added(world, def);
    def.kind = kind_of(world, spark(), {.collision = {.on_hit = OnHit::stop}});
    def.seed = 3;
    def.cycle.plays = true;
    def.per_second = {2000};
    def.start.speed = {100, 900};
    def.start.lifetime = {1};
    def.gun.dispersion = 0;
    def.subs = {{.on = SubEvent::hit, .emitter = sparks, .count = {3}, .axis = SubAxis::normal}};
    const EmitterId gun = added(world, def);
    std::vector<Event> events;
    step_to(world, 1, rate, &events);
    const std::uint64_t hits = told(events, EventKind::hit, 1).size();
    if (first == 0) first = hits;
    EXPECT_NEAR(double(hits), double(first), 1) << rate;  // one may be under way at the end
    EXPECT_GT(hits, 1900u);
    EXPECT_EQ(world.emitter_counts(sparks).born, 3 * hits) << rate;
    EXPECT_EQ(world.emitter_counts(gun).landed, hits);
    std::size_t back = 0;
    for (const Event& e : told(events, EventKind::spawned, 1))
      if (e.velocity.x < 0) {
        ++back;  // away from the wall
        EXPECT_NEAR(e.position.x, 4.999, 1e-9);
        EXPECT_NEAR(e.velocity.x, -5, 1e-9);
      }
    EXPECT_EQ(back, 3 * hits);
  }
}

TEST(Emitter, ages_apexes_and_births_set_off_too) {
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}, .apex_events = true});
    EmitterDef def{.kind = kind_of(world, spark()),
                   .cycle = {.plays = false},
                   .start = {.lifetime = {0.5}, .speed = {0}},
                   .maximum = 1u << 30};
    const EmitterId marks = added(world, def);
    def = spray(def.kind, 100, 3);
    def.subs = {{.on = SubEvent::age, .emitter = marks, .age = 0.2005},
                {.on = SubEvent::age, .emitter = marks, .count = {2}, .age = 0.0135},
                {.on = SubEvent::apex, .emitter = marks, .count = {3}},
                {.on = SubEvent::birth, .emitter = marks, .count = {4}, .inherit_velocity = 1}};
    added(world, def);
    std::vector<Event> events;
    step_to(world, 2.5, rate, &events);
    std::map<double, std::size_t> at;
    std::vector<Event> born;
    for (const Event& e : told(events, EventKind::spawned, 2.5)) {
      ++at[e.time];
      if (length(e.velocity) > 7 && (born.empty() || born.back().time != e.time)) born.push_back(e);
    }
    ASSERT_EQ(born.size(), 250u) << rate;
    const std::vector<Event> apexes = told(events, EventKind::apex, 2.5);
    EXPECT_GT(apexes.size(), 100u);
    for (const Event& e : apexes) EXPECT_EQ(at[e.time], 3u) << rate;
    for (const Event& b : born) {
      if (b.time > 2.2) break;
      EXPECT_EQ(at[b.time], 5u) << rate;
      EXPECT_EQ(at[b.time + 0.2005], 1u) << rate;
      EXPECT_EQ(at[b.time + 0.0135], 2u) << rate;
    }
    for (const Event& e : told(events, EventKind::spawned, 2.2)) {
      if (at[e.time] != 1) continue;
      const auto b = std::ranges::find_if(born, [&](const Event& x) { return x.time + 0.2005 == e.time; });
      ASSERT_NE(b, born.end());
      EXPECT_LT(length(e.position - (b->position + b->velocity * 0.2005 + Vec3d{0, -9.80665 / 2 * 0.2005 * 0.2005, 0})),
                1e-11);
    }
  }
}

TEST(Emitter, a_full_one_refuses_the_newest_at_any_frame_rate) {
  std::uint64_t refused = 0;
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = spray(kind_of(world, spark()), 1000, 0.25);
    def.maximum = 100;
    const EmitterId id = added(world, def);
    std::vector<Event> events;
    step_to(world, 1, rate, &events);
    const EmitterCounts c = world.emitter_counts(id);
    EXPECT_LE(c.alive, 100u);
    EXPECT_EQ(c.born + c.refused, 1000u) << rate;
    if (refused == 0) refused = c.refused;
    EXPECT_EQ(c.refused, refused) << rate;
    EXPECT_EQ(c.born, 400u) << rate;  // a hundred at once every quarter of a second
  }
}

TEST(Emitter, the_oldest_makes_room_where_that_is_asked_for) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, spark()), 1000, 100);
  def.maximum = 100;
  def.when_full = WhenFull::replace_oldest;
  const EmitterId id = added(world, def);
  step_to(world, 1, 60);
  const EmitterCounts c = world.emitter_counts(id);
  EXPECT_EQ(c.born, 1000u);
  EXPECT_EQ(c.replaced, 900u);
  EXPECT_EQ(c.refused, 0u);
  const auto all = alive(world, id);
  EXPECT_EQ(all.size(), 100u);
  EXPECT_EQ(all.begin()->first, 900u);
}

TEST(Emitter, moments_go_on_bit_for_bit) {
  Fireworks show(60);
  step_to(show.world, 1.5, 60);
  const Snapshot snapshot = show.world.snapshot();
  const auto saved = must(show.world.save());
  auto loaded = must(World::load(saved));
  EXPECT_EQ(loaded.hash(), show.world.hash());
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 90; ++i) {
    ASSERT_TRUE(show.world.step(1.0 / 60));
    ASSERT_TRUE(loaded.step(1.0 / 60));
    hashes.push_back(show.world.hash());
    ASSERT_EQ(loaded.hash(), hashes.back()) << i;
  }
  for (const EmitterId id : show.world.emitters()) EXPECT_EQ(loaded.emitter_counts(id), show.world.emitter_counts(id));
  ASSERT_TRUE(show.world.restore(snapshot));
  for (int i = 0; i < 90; ++i) {
    ASSERT_TRUE(show.world.step(1.0 / 60));
    ASSERT_EQ(show.world.hash(), hashes[std::size_t(i)]) << i;
  }
}

TEST(Emitter, recordings_replay_every_call) {
  World world = make_world({.ground = {.mode = GroundMode::land}});
  std::vector<std::byte> bytes;
  ASSERT_TRUE(world.record([&](std::span<const std::byte> piece) -> Status {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return {};
  }));
  EmitterDef def = spray(kind_of(world, spark()), 300, 1);
  def.seed.reset();
  const EmitterId marks = added(world, def);
  def.subs = {{.on = SubEvent::trigger, .emitter = marks, .count = {2}}};
  def.cycle.plays = false;
  const EmitterId id = added(world, def);
  step_to(world, 0.5, 60);
  EXPECT_TRUE(world.play_emitter(id));
  EXPECT_TRUE(world.move_emitter(id, {.position = {3, 2, 1}}));
  step_to(world, 1, 60);
  EXPECT_EQ(*world.emit(id, 17), 17u);
  EXPECT_TRUE(world.trigger_emitter(id));
  EXPECT_TRUE(world.stop_emitter(id));
  step_to(world, 1.5, 60);
  EXPECT_TRUE(world.remove_emitter(id));
  step_to(world, 2, 60);
  replayed(world, bytes);
}

TEST(Emitter, what_a_removed_one_fired_ends_as_it_would) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const EmitterId id = added(world, spray(kind_of(world, spark()), 100, 0.5));
  step_to(world, 0.25, 64);
  EXPECT_EQ(world.size(), 25u);
  ASSERT_TRUE(world.remove_emitter(id));
  EXPECT_FALSE(world.remove_emitter(id));
  EXPECT_EQ(world.size(), 25u);
  EXPECT_EQ(world.particles(id, {}), 0u);
  std::vector<Event> events;
  step_to(world, 0.75, 64, &events);
  EXPECT_EQ(world.size(), 0u);
  EXPECT_EQ(told(events, EventKind::expired, 1).size(), 25u);
}

TEST(Emitter, calls_between_steps_fire_now) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, spark()), 50, 5);
  def.cycle.plays = false;
  const EmitterId marks = added(world, def);
  def.position = {0, 7, 0};
  def.subs = {{.on = SubEvent::trigger, .emitter = marks, .count = {3}, .axis = SubAxis::velocity}};
  const EmitterId id = added(world, def);
  step_to(world, 0.5, 64);
  EXPECT_EQ(world.size(), 0u);
  EXPECT_FALSE(world.is_playing(id));
  EXPECT_EQ(*world.emit(id, 10), 10u);
  EXPECT_EQ(world.size(), 10u);
  for (const auto& [number, state] : alive(world, id)) EXPECT_LE(length(state.position - Vec3d{0, 7, 0}), 0.2 + 1e-12);
  step_to(world, 1, 64);
  const auto before = alive(world, id);
  EXPECT_TRUE(world.trigger_emitter(id));
  EXPECT_EQ(world.size(), 40u);
  std::multiset<double> places, expected;
  for (const auto& [number, state] : alive(world, marks)) expected.insert(std::round(state.position.y * 1e3));
  for (const auto& [number, state] : before)
    for (int i = 0; i < 3; ++i) places.insert(std::round(state.position.y * 1e3));
  EXPECT_EQ(expected.size(), places.size());
  EXPECT_FALSE(world.emit(id, 2'000'000));
  EXPECT_EQ(*world.emit(id, 0), 0u);
}

TEST(Emitter, who_does_not_loop_ends_and_is_removed_where_asked) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, spark()), 100, 0.3);
  def.cycle = {.duration = 0.5, .looping = false, .stop = StopAction::remove};
  const EmitterId id = added(world, def);
  step_to(world, 0.6, 100);
  EXPECT_FALSE(world.is_playing(id));
  EXPECT_EQ(world.emitter_counts(id).born, 50u);
  EXPECT_NE(world.emitter(id), nullptr);
  step_to(world, 0.9, 100);
  EXPECT_EQ(world.emitter(id), nullptr);
  EXPECT_TRUE(world.emitters().empty());
}

TEST(Emitter, one_whose_projectile_is_gone_stops) {
  World world = make_world({});
  const ProjectileId led = *world.spawn(spark(), {.position = {0, 1, 0}, .velocity = Vec3d{5, 0, 0}});
  EmitterDef def = spray(kind_of(world, spark()), 1000, 5);
  def.kind = kind_of(world, spark(), {.gravity_scale = -1});  // they rise
  def.follows = led;
  const EmitterId id = added(world, def);
  std::vector<Event> events;
  step_to(world, 1, 10, &events);
  const double lands = std::sqrt(2 / 9.80665);
  EXPECT_FALSE(world.is_playing(id));
  EXPECT_EQ(world.emitter_counts(id).born, static_cast<std::uint64_t>(lands * 1000));
}

TEST(Emitter, fires_kinds_of_any_rung) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  ProjectileDef rocket = stone();
  rocket.mass = 1;
  rocket.diameter = 0.1;
  rocket.fidelity.integrator = Integrator::rk4;
  rocket.motor.thrust = {{0, 50}, {1, 50}};
  rocket.motor.propellant_mass = 0.1;
  EmitterDef def{.kind = kind_of(world, rocket),
                 .launch = {.rail_length = 0.5},
                 .rotation = {0.7071067811865476, 0, 0, 0.7071067811865476},
                 .per_second = {4},
                 .start = {.lifetime = {kInfinity}, .speed = {0}}};
  const EmitterId id = added(world, def);
  step_to(world, 1, 100);
  ASSERT_EQ(alive(world, id).size(), 4u);
  for (const auto& [number, state] : alive(world, id)) {
    const double t = 1 - 0.25 * static_cast<double>(number + 1);
    EXPECT_GE(state.velocity.y, t * (50 - 9.80665) * 0.999) << number;  // straight up, though it began at rest
    EXPECT_NEAR(state.velocity.x, 0, 1e-9);
  }
}

TEST(Emitter, particles_that_generators_act_on_feel_them_from_their_birth_on) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  ProjectileDef p = spark(Motion::force, Integrator::rk4);
  const KindId kind = kind_of(world, p);
  const auto force =
      world.add_force({.law = ConstantForce{.force = {0.02, 0, 0}}, .target = ForceTarget::everything()});
  ASSERT_TRUE(force) << force.error().text();
  EmitterDef def = spray(kind, 100, 5);
  def.start.speed = {0};
  const EmitterId id = added(world, def);
  std::vector<Event> events;
  step_to(world, 1, 7, &events);
  for (const auto& [number, state] : alive(world, id))
    EXPECT_NEAR(state.velocity.x, 20 * (world.time() - 0.01 * static_cast<double>(number + 1)), 1e-9);
}

TEST(Emitter, what_is_refused) {
  World world = make_world({});
  const KindId kind = kind_of(world, spark());
  const auto place = [&](auto change) {
    EmitterDef def = spray(kind, 10, 1);
    change(def);
    const auto id = world.add_emitter(def);
    return id ? std::string("taken") : id.error().place;
  };
  EXPECT_EQ(place([](EmitterDef&) {}), "taken");
  EXPECT_EQ(place([](EmitterDef& d) { d.kind = {99}; }), "emitter.kind");
  EXPECT_EQ(place([](EmitterDef& d) { d.gun.tracer_every = 3; }), "emitter.gun.tracer");
  EXPECT_EQ(place([](EmitterDef& d) { d.follows = {5, 1}; }), "emitter.follows");
  EXPECT_EQ(place([](EmitterDef& d) { d.subs = {{.emitter = {7, 1}}}; }), "emitter.subs.emitter");
  EXPECT_EQ(place([](EmitterDef& d) { d.start.lifetime = {0}; }), "emitter.start.lifetime");
  EXPECT_FALSE(world.play_emitter({}));
  EXPECT_FALSE(world.stop_emitter({9, 1}));
  EXPECT_FALSE(world.trigger_emitter({1, 9}));
  EXPECT_FALSE(world.emit({}, 1));
  const EmitterId id = world.emitters().front();
  EXPECT_FALSE(world.move_emitter(id, {.rotation = {0, 0, 0, 0}}));
  EXPECT_FALSE(world.move_emitter(id, {.position = {kInfinity, 0, 0}}));
  EmitterDef moving = spray(kind, 10, 1);
  moving.motion = SteadyMotion{.velocity = {1, 0, 0}};
  EXPECT_FALSE(world.move_emitter(added(world, moving), {}));
  EXPECT_EQ(world.emitter_counts({}), EmitterCounts{});
  EXPECT_EQ(world.emitters().size(), 2u);
}

TEST(Emitter, more_than_a_million_in_a_step_stop_it) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, spark()), 1e9, 5);
  def.maximum = 10;
  const EmitterId id = added(world, def);
  ASSERT_TRUE(world.step(0.1));
  const EmitterCounts c = world.emitter_counts(id);
  EXPECT_EQ(c.born + c.refused, 1u << 20);
  EXPECT_EQ(c.cut, 1u);
  EXPECT_FALSE(world.is_playing(id));
}

TEST(Emitter, one_that_fires_itself_is_cut) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, spark()), 1, 5);
  def.subs = {{.on = SubEvent::birth, .count = {1}}};
  const EmitterId id = added(world, def);
  step_to(world, 3, 10);
  const EmitterCounts c = world.emitter_counts(id);
  EXPECT_EQ(c.cut, 3u);
  EXPECT_EQ(c.born, 3u * 33u);
}

}  // namespace physim::world_emitter_test
