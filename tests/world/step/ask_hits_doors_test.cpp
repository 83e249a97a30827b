// Hits that ask through every door: what is refused, saves, snapshots, recordings, predictions, flights.
#include "world/ask_support.hpp"
#include "world/random_session.hpp"

namespace physim::world_ask_hits_doors_test {

using namespace test_ask;

BodyDef asks(double radius = 0) { return {.restitution = 0.9, .collision = {.on_hit = OnHit::ask, .radius = radius}}; }

/// A room in which some ask what happens.
World asking_room(const HitFunction& function = answer_by_place) {
  World world = make_world(in_the_open(), room({5, 3, 4}, {.restitution = 0.8, .friction = 0.3}));
  EXPECT_TRUE(world.set_hit_function(function));
  return world;
}
void spray(World& world, int count) {
  test::Random r(3);
  for (int i = 0; i < count; ++i)
    ASSERT_TRUE(world.spawn(stone(), {.position = r.vector(1), .velocity = r.vector(40)}, asks(i % 2 * 0.05)));
}

TEST(AskHitsDoors, who_asks_needs_somebody_who_answers) {
  World world = make_world(in_the_open());
  const auto refused = world.add_kind(stone(), asks());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "body.collision.on_hit");
  EXPECT_NE(refused.error().hint.find("set_hit_function"), std::string::npos);
  EXPECT_FALSE(world.spawn(stone(), {}, asks()));
  EXPECT_FALSE(world.set_hit_function({}));
  ASSERT_TRUE(world.set_hit_function(always({})));
  EXPECT_TRUE(world.add_kind(stone(), asks()));
  EXPECT_FALSE(world.set_hit_function({}));
  EXPECT_EQ(world.hit_counts().calls, 0u);
}

TEST(AskHitsDoors, flights_have_nobody_to_ask) {
  const Scene scene = room({5, 3, 4}, {});
  const Flight flight = fly(stone(), {.speed = 10}, {}, stone().fidelity, {}, test_scene::meeting(scene, OnHit::ask));
  EXPECT_EQ(flight.outcome(), Outcome::refused);
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.error()->place, "until.contact.collision.on_hit");
}

TEST(AskHitsDoors, answers_that_make_no_sense_stop_it) {
  const std::pair<HitAnswer, const char*> bad[] = {
      {{OnHit::ask}, "asks again"},
      {{static_cast<OnHit>(77)}, "none of"},
      {{OnHit::bounce, Vec3d{kNan, 0, 0}}, "finite"},
      {{OnHit::bounce, Vec3d{-kInfinity, 0, 0}}, "finite"},
      {{OnHit::bounce, Vec3d{-51, 0, 0}}, "gains speed"},
      {{OnHit::bounce, Vec3d{10, 0, 0}}, "leads into"},
      {{OnHit::pass, Vec3d{-10, 0, 0}}, "leads away"},
      {{OnHit::pass, Vec3d{0, 10, 0}}, "leads away"},
      {{OnHit::stop, Vec3d{-10, 0, 0}}, "not for stop"},
      {{OnHit::impact, Vec3d{-10, 0, 0}}, "not for impact"},
  };
  for (const auto& [answer, why] : bad) {
    World world = asking_room(always(answer));
    const ProjectileId id = *world.spawn(stone(), {.velocity = Vec3d{50, 0, 0}}, asks());
    world.step(0.2);
    EXPECT_EQ(world[id].status(), LifeStatus::landed) << why;
    EXPECT_EQ(events_of(world, EventKind::hit).size(), 1u);
    EXPECT_EQ(world.hit_counts().refused, 1u) << why;
    EXPECT_NE(world.refused_answer().find(why), std::string::npos) << world.refused_answer();
    EXPECT_NE(world.refused_answer().find("answer 1 of 1, projectile 1 at 0.1 s"), std::string::npos)
        << world.refused_answer();
  }
  World world = asking_room([](const HitBatch&) { throw std::runtime_error("no"); });
  spray(world, 20);
  for (int i = 0; i < 30; ++i) world.step(1.0 / 60);
  EXPECT_EQ(world.size(), 0u);
  EXPECT_EQ(world.hit_counts().refused, 20u);
  EXPECT_NE(world.refused_answer().find("threw"), std::string::npos);
}

TEST(AskHitsDoors, the_function_reads_the_world_and_changes_nothing) {
  World world = asking_room();
  ProjectileId id;
  int asked = 0;
  ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
    ++asked;
    EXPECT_EQ(batch.questions[0].projectile, id);
    EXPECT_TRUE(world[id].is_alive());
    EXPECT_EQ(world[id].position(), (Vec3d{0, 0, 0})) << "as the step began";
    EXPECT_EQ(world.scene()->instance(batch.questions[0].instance)->layers, 1u);
    EXPECT_FALSE(world.spawn(stone(), {}));
    EXPECT_FALSE(world.step(0.1));
    EXPECT_FALSE(world[id].set_velocity({}));
    EXPECT_FALSE(world.set_hit_function(always({})));
    EXPECT_FALSE(world.move_instance(batch.questions[0].instance, {}));
    EXPECT_FALSE(world.save());
    batch.answers[0].then = OnHit::bounce;
  }));
  id = *world.spawn(stone(), {.velocity = Vec3d{50, 0, 0}}, asks());
  EXPECT_TRUE(world.step(0.15));
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(world.size(), 1u);
}

/// A world that goes while it asks ends its call first.
TEST(AskHitsDoors, the_function_may_destroy_its_world) {
  for (const bool steps : {true, false}) {
    auto world = std::make_unique<World>(asking_room());
    World* const asking = world.get();
    ASSERT_TRUE(world->set_hit_function([&](const HitBatch& batch) {
      world.reset();
      batch.answers[0].then = OnHit::bounce;
    }));
    EmitterDef def{.kind = *world->add_kind(stone(), asks()),
                   .cycle = {.duration = 1, .prewarm = !steps},
                   .per_second = {steps ? 600.0 : 0.0},
                   .start = {.speed = {300}}};
    ASSERT_TRUE(world->spawn(stone(), {.velocity = Vec3d{50, 0, 0}}, asks()));
    if (steps) static_cast<void>(asking->step(0.2));
    if (!steps) def.per_second = {100}, static_cast<void>(asking->add_emitter(def));
    EXPECT_FALSE(world);
  }
}

/// It is let out between two steps, into the past of the emitter, and asks there.
TEST(AskHitsDoors, who_is_let_out_between_steps_asks_then) {
  World world = asking_room(always({.then = OnHit::bounce}));
  EmitterDef def{.kind = *world.add_kind(stone(), asks()),
                 .cycle = {.duration = 1, .prewarm = true},
                 .per_second = {100},
                 .start = {.lifetime = {2}, .speed = {20, 30}}};
  ASSERT_TRUE(world.add_emitter(def));
  world.step(1.0 / 60);
  EXPECT_GT(world.hit_counts().questions, 50u);
  EXPECT_EQ(world.hit_counts().refused, 0u) << world.refused_answer();
}

TEST(AskHitsDoors, saves_and_snapshots_go_on_the_same) {
  World world = asking_room();
  spray(world, 60);
  for (int i = 0; i < 6; ++i) world.step(1.0 / 60);
  const Snapshot moment = world.snapshot();
  const std::vector<std::byte> save = *world.save();
  const auto refused = World::load(save);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "hit_function");
  auto loaded = must(World::load(save, {.hit_function = answer_by_place}));
  EXPECT_EQ(*loaded.save(), save);
  for (int i = 0; i < 40; ++i) world.step(1.0 / 60), loaded.step(1.0 / 60);
  EXPECT_EQ(loaded.hash(), world.hash());
  const std::uint64_t then = world.hash();
  ASSERT_TRUE(world.restore(moment));
  for (int i = 0; i < 40; ++i) world.step(1.0 / 60);
  EXPECT_EQ(world.hash(), then);
  EXPECT_GT(world.hit_counts().questions, 60u);
}

/// What was said is recorded, what made no sense too: a replay asks nobody.
TEST(AskHitsDoors, a_replay_has_the_answers) {
  for (const bool from_now : {false, true}) {
    int asked = 0;
    World world = asking_room([&](const HitBatch& batch) {
      answer_by_place(batch);
      if (++asked % 3 == 0) batch.answers[0] = {OnHit::bounce, batch.questions[0].velocity * -0.5};
      if (asked % 5 == 0) batch.answers[0] = {OnHit::bounce, Vec3d{kNan, 0, 0}};
      if (asked % 11 == 0) throw std::runtime_error("no");
    });
    if (from_now) {
      spray(world, 40);
      for (int i = 0; i < 5; ++i) world.step(1.0 / 60);
    }
    World fresh = make_world(in_the_open());
    World& recorded = from_now ? world : fresh;
    std::vector<std::byte> recording;
    ASSERT_TRUE(fresh.set_hit_function(answer_by_place));
    ASSERT_TRUE(recorded.record(record_into(recording), {.from_now = from_now}));
    if (!from_now) {
      ASSERT_TRUE(recorded.set_scene(room({5, 3, 4}, {.restitution = 0.8, .friction = 0.3})));
      ASSERT_TRUE(recorded.set_hit_function([&](const HitBatch& batch) {
        answer_by_place(batch);
        if (++asked % 4 == 0) batch.answers[0] = {OnHit::pass, batch.questions[0].velocity * 0.5};
        if (asked % 7 == 0) batch.answers[0].then = OnHit::ask;
      }));
    }
    spray(recorded, 60);
    EmitterDef def{.kind = *recorded.add_kind(stone(), asks()), .start = {.lifetime = {0.5}, .speed = {300}}};
    const EmitterId emitter = *recorded.add_emitter(def);
    for (int i = 0; i < 30; ++i) {
      recorded.step(1.0 / 60);
      if (i % 10 != 0) continue;
      EXPECT_TRUE(recorded.emit(emitter, 5));
    }
    const Snapshot moment = recorded.snapshot();
    for (int i = 0; i < 10; ++i) recorded.step(1.0 / 60);
    ASSERT_TRUE(recorded.restore(moment));
    for (int i = 0; i < 10; ++i) recorded.step(1.0 / 60);
    ASSERT_TRUE(recorded.stop_recording());
    EXPECT_GT(recorded.hit_counts().refused, 0u);
    const auto report = must(replay(recording));
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(report.hashes, 50u);
    if (report.difference) ADD_FAILURE() << report.difference->call << ": " << report.difference->what;
  }
}

/// Everything that a world can do, with projectiles among it that ask: replays agree, without anybody to ask, and saves
/// go on.
TEST(AskHitsDoors, random_sessions_replay_and_go_on) {
  std::uint64_t asked = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::vector<std::byte> recording;
    World world = make_world(test::session_world());
    ASSERT_TRUE(world.set_hit_function(test::answer_somehow));
    ASSERT_TRUE(world.record(record_into(recording)));
    test::RandomSession session(world, seed);
    session.asks = session.joints = true;
    test::Random r(seed);
    for (int i = 0; i < 2000; ++i) {
      session.act();
      if (i % 8 != 0) continue;  // towards the wall of such sessions
      const Launch launch{.position = {r.in(11, 19), r.in(1, 6), r.in(-5, 5)}, .velocity = r.vector(90)};
      static_cast<void>(world.spawn(stone(), launch, asks(i % 3 * 0.1)));
    }
    ASSERT_TRUE(world.stop_recording());
    asked += world.hit_counts().questions;
    LoadOptions options;
    options.custom_forces.assign(1000, {[](const ForceBatch& b) {
                                   for (std::size_t i = 0; i < b.id.size(); ++i) b.force[i].y += b.mass[i] * 3;
                                 }});
    const auto report = must(replay(recording, options));
    EXPECT_TRUE(report.complete);
    if (report.difference) ADD_FAILURE() << seed << ", " << report.difference->call << ": " << report.difference->what;
    options.hit_function = test::answer_somehow;
    auto loaded = reloaded(world, options);
    for (int i = 0; i < 30; ++i) world.single_step(), loaded.single_step();
    EXPECT_EQ(loaded.hash(), world.hash()) << seed;
  }
  EXPECT_GT(asked, 100u);
}

/// It may not be known what somebody will say.
TEST(AskHitsDoors, a_prediction_ends_where_it_will_ask) {
  World world = asking_room(always({.then = OnHit::bounce}));
  const ProjectileId id = *world.spawn(stone(), {.velocity = Vec3d{50, 0, 0}}, asks(0.1));
  const Flight flight = world.predict(id, 1.0);
  EXPECT_EQ(flight.outcome(), Outcome::hit);
  EXPECT_EQ(world.hit_counts().calls, 0u);
  EXPECT_TRUE(std::ranges::any_of(flight.fidelity_in_use().notes,
                                  [](const FidelityNote& note) { return note.effect == "on_hit"; }));
  double met = 0;
  for (int i = 0; i < 20; ++i) {
    world.single_step();
    for (const Event& event : events_of(world, EventKind::hit)) met = met == 0 ? event.time : met;
  }
  EXPECT_EQ(flight.duration(), met);
}

/// It lies in a thing that was put over it: told, and nothing but stopping is there to choose.
TEST(AskHitsDoors, who_begins_inside_stays) {
  for (const OnHit answer : {OnHit::bounce, OnHit::pass, OnHit::stick, OnHit::stop}) {
    World world = make_world(in_the_open());
    Scene scene;
    put(scene, BoxShape{{1, 1, 1}}, {});
    ASSERT_TRUE(world.set_scene(scene));
    bool inside = false;
    ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
      inside = batch.questions[0].inside;
      batch.answers[0].then = answer;
    }));
    const ProjectileId id = *world.spawn(stone(), {.speed = 1}, asks());
    ASSERT_TRUE(world.step(0.01));
    EXPECT_TRUE(inside);
    EXPECT_EQ(world[id].is_alive(), answer != OnHit::stop);
    EXPECT_EQ(events_of(world, EventKind::hit).at(0).reason, Reason::inside);
    ASSERT_TRUE(world.step(0.01));
    EXPECT_EQ(world.hit_counts().questions, 1u);
  }
}

}  // namespace physim::world_ask_hits_doors_test
