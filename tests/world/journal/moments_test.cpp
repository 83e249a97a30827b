// Snapshots go back bit for bit; hashes tell worlds apart, and only worlds.
#include <functional>

#include "world/random_session.hpp"

namespace physim::world_moments_test {

World made(const WorldDef& def = {}) { return std::move(World::create(def).value()); }

ProjectileDef ball() { return {.mass = 0.4, .diameter = 0.1, .fidelity = Fidelity::game()}; }

TEST(Moments, restore_goes_back_bit_for_bit) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    World world = made(test::session_world());
    test::RandomSession session(world, seed);
    for (int i = 0; i < 400; ++i) session.act();
    const Snapshot start = world.snapshot();
    const std::uint64_t hash = world.hash();
    const auto run = [&] {
      std::vector<std::uint64_t> hashes;
      for (int i = 0; i < 30; ++i) world.advance(0.02), hashes.push_back(world.hash());
      std::vector<Vec3d> places;
      for (const ProjectileId id : world.ids()) places.push_back(world[id].render_position());
      return std::pair(hashes, places);
    };
    const auto first = run();
    test::RandomSession other_inputs(world, seed + 100);
    for (int i = 0; i < 200; ++i) other_inputs.act();
    ASSERT_TRUE(world.restore(start));
    EXPECT_EQ(world.hash(), hash);
    EXPECT_EQ(world.time(), start.time());
    EXPECT_EQ(run().first, first.first) << "seed " << seed;
    ASSERT_TRUE(world.restore(start));
    EXPECT_EQ(run().second, first.second);
  }
}

/// A peer that predicted wrongly and went back ends like one that knew the inputs all along.
TEST(Moments, rolled_back_worlds_equal_those_that_were_not) {
  World knows = made(), predicts = made();
  for (World* w : {&knows, &predicts})
    for (int i = 0; i < 5; ++i) w->spawn(ball(), {.position = {1.0 * i, 2, 0}, .speed = 20, .elevation = 0.5});
  const auto input = [](World& w, const Fidelity& f) {
    const ProjectileId id = w.ids().front();
    w[id].set_fidelity(f);
    w[id].apply_impulse({0, 1, 0});
    w.spawn(ball(), {.speed = 30, .elevation = 0.3});
  };
  const Snapshot agreed = predicts.snapshot();
  input(predicts, Fidelity::arcade());  // wrong: leaves kinds and rungs behind that the other world never has
  predicts.spawn(ProjectileDef{.mass = 9}, {.speed = 9});
  for (int i = 0; i < 30; ++i) predicts.step(1.0 / 60);
  ASSERT_TRUE(predicts.restore(agreed));
  EXPECT_EQ(predicts.hash(), knows.hash());
  for (World* w : {&knows, &predicts}) {
    input(*w, Fidelity::constant_air());
    for (int i = 0; i < 30; ++i) w->step(1.0 / 60);
  }
  EXPECT_EQ(predicts.hash(), knows.hash());
}

/// What a wrong guess spawned, and what turned out to be.
struct Guess {
  const char* name;
  ProjectileDef wrong, right;
};

std::vector<Guess> guesses() {
  const auto rocket = [](double thrust) {
    ProjectileDef p = ball();
    p.motor.thrust = {{0, thrust}, {0.05, 2 * thrust}, {1, 0}};
    p.motor.propellant_mass = 0.1;
    return p;
  };
  const auto curve = [](double drag) {
    ProjectileDef p = ball();
    p.fidelity = Fidelity::constant_air();
    p.drag = {.table = DragTable::custom, .curve = {{0, drag}, {1, 0.5}, {3, 0.4}}};
    return p;
  };
  const auto spinning = [](double lift) {
    ProjectileDef p = ball();
    p.fidelity.rotation = RotationModel::magnus;
    p.magnus.table = {{0, 0, 0.1, 0.2}, {0, 1, 0.2, 0.3}, {50, 0, 0.1, lift}, {50, 1, 0.2, 0.3}};
    return p;
  };
  return {{"motors", rocket(20), rocket(30)},
          {"drag curves", curve(0.3), curve(0.25)},
          {"balls that spin", spinning(0.2), spinning(0.25)}};
}

/// Where its tables lie tells how a world came here, not what it is.
TEST(Moments, the_tables_of_a_guess_are_not_in_the_hash) {
  for (const Guess& guess : guesses()) {
    World knows = made(), predicts = made();
    const Launch up{.position = {0, 10, 0}, .speed = 50, .elevation = 1, .spin = {10, 20, 30}};
    const Snapshot before = predicts.snapshot();
    ASSERT_TRUE(predicts.spawn(guess.wrong, up)) << guess.name;
    predicts.single_step();
    ASSERT_TRUE(predicts.restore(before));
    for (World* w : {&knows, &predicts}) {
      ASSERT_TRUE(w->spawn(guess.right, up));
      for (int i = 0; i < 10; ++i) w->single_step();
    }
    EXPECT_EQ(knows.hash(), predicts.hash()) << guess.name;
    EXPECT_EQ(World::load(*predicts.save())->hash(), knows.hash()) << guess.name;
  }
}

/// Nor are rungs that a rule of a guess asked for.
TEST(Moments, the_rule_of_a_guess_is_not_in_the_hash) {
  ProjectileDef shell = ball();
  shell.drag.table = DragTable::g7;
  World knows = made(), predicts = made();
  const auto fire = [&shell](World& w) { return w.spawn(shell, {.position = {0, 10, 0}, .speed = 50}).ok(); };
  ASSERT_TRUE(fire(knows) && fire(predicts));
  const Snapshot before = predicts.snapshot();
  Fidelity smooth = Fidelity::constant_air();
  smooth.interpolation = Interpolation::linear;
  const DragDef other{.table = DragTable::custom, .curve = {{0, 0.2}, {2, 0.4}}};
  ASSERT_TRUE(predicts.spawn({.drag = other, .fidelity = smooth}, {}));
  ASSERT_TRUE(predicts.set_detail({{{smooth, 1000}, {Fidelity::game()}}}));
  predicts.single_step();
  ASSERT_TRUE(predicts.restore(before));
  for (World* w : {&knows, &predicts}) {
    ASSERT_TRUE(w->set_detail({{{smooth, 1000}, {Fidelity::game()}}}));
    for (int i = 0; i < 10; ++i) w->single_step();
  }
  EXPECT_EQ(knows.hash(), predicts.hash());
}

/// A kind is named by its number, which tells how many there were before; a hash tells which it is.
TEST(Moments, numbers_of_kinds_are_not_in_the_hash) {
  const auto use = [](World& w, const ProjectileDef& p) {
    const KindId kind = *w.add_kind(p);
    ForceDef force{.law = ConstantForce{{1, 0, 0}}, .target = {{}, kind, 0}};
    EmitterDef emitter{.kind = kind, .per_second = {100}};
    emitter.seed = 3, emitter.gun.rounds_per_minute = 600, emitter.gun.tracer_every = 2, emitter.gun.tracer = kind;
    ASSERT_TRUE(w.add_force(force) && w.add_emitter(emitter));
    for (int i = 0; i < 10; ++i) w.single_step();
  };
  World plain = made(), after_others = made(), of_another = made();
  ASSERT_TRUE(after_others.add_kind({.mass = 3}));
  ProjectileDef heavy = ball();
  heavy.mass = 0.5;
  use(plain, ball()), use(after_others, ball()), use(of_another, heavy);
  EXPECT_EQ(plain.hash(), after_others.hash());
  EXPECT_NE(plain.hash(), of_another.hash());
}

TEST(Moments, snapshots_belong_to_their_world) {
  Snapshot stale;
  {
    World gone = made();
    stale = gone.snapshot();
  }
  World world = made();  // most likely where the other one was
  EXPECT_FALSE(world.restore(stale));
  EXPECT_FALSE(world.restore({}));
  World moved = std::move(world);
  const Snapshot own = moved.snapshot();
  World again = std::move(moved);
  EXPECT_TRUE(again.restore(own));
}

TEST(Moments, hash_is_that_of_the_state_not_of_the_way_there) {
  World a = made(), b = made();
  const KindId kind_a = *a.add_kind(ball());
  b.add_kind({.mass = 3});  // never used, and kinds of other numbers
  const KindId kind_b = *b.add_kind(ball());
  const Launch near{.position = {0, 9, 0}, .speed = 5}, far{.position = {50, 9, 0}, .speed = 5};
  for (const auto& [world, kind] : {std::pair(&a, kind_a), std::pair(&b, kind_b)})
    for (const Launch& l : {near, far, near}) world->spawn(kind, l);
  EXPECT_EQ(a.hash(), b.hash());
  // To another cohort and back: rows stand in another order now.
  const std::vector<ProjectileId> ids = b.ids();
  b[ids[0]].set_fidelity(Fidelity::constant_air());
  EXPECT_NE(a.hash(), b.hash());
  b[ids[0]].set_fidelity(ball().fidelity);
  EXPECT_EQ(a.hash(), b.hash());
  for (World* w : {&a, &b}) w->step(0.01);
  EXPECT_EQ(a.hash(), b.hash());
}

TEST(Moments, whatever_decides_the_future_is_in_the_hash) {
  WorldDef def{.pools = {{"a", 3, WhenFull::replace_oldest}}};
  const auto base = [&](World& w) {
    for (int i = 0; i < 3; ++i)
      w.spawn(ball(), {.position = {0, 5, 0}, .speed = 4}, BodyDef{.despawn = {.farther = 50, .older = 9}});
  };
  const auto first = [](World& w) { return w.ids().front(); };
  const std::vector<std::function<void(World&)>> changes = {
      [](World&) {},
      [&](World& w) {
        w[first(w)].set_velocity({1, 2, 3});
      },
      [&](World& w) {
        w[first(w)].set_position({1, 2, 3});
      },
      [&](World& w) { w[first(w)].set_gravity_scale(0.5); },
      [&](World& w) { w[first(w)].set_frozen(Axes::z, Axes::none); },
      [&](World& w) { w[first(w)].set_frozen(Axes::none, Axes::z); },
      [&](World& w) { w[first(w)].set_body({.gravity_scale = 0.7, .despawn = {.farther = 50, .older = 9}}); },
      [&](World& w) { w[first(w)].set_kinematic(true); },
      [&](World& w) { w[first(w)].set_can_sleep(false); },
      [&](World& w) { w[first(w)].sleep(); },
      [&](World& w) { w[first(w)].set_smoothing(Smoothing::none); },
      [&](World& w) { w[first(w)].set_user_data(7); },
      [&](World& w) { w[first(w)].set_layers(6); },
      [&](World& w) { w[first(w)].set_colour(6); },
      [&](World& w) { w[first(w)].set_label("x"); },
      [&](World& w) {
        w[first(w)].set_angular_velocity({1, 0, 0});
      },
      [&](World& w) { w[first(w)].set_fidelity(Fidelity::reference()); },
      [&](World& w) { w[first(w)].despawn(); },
      [&](World& w) {
        w[first(w)].despawn(), w.spawn(ball(), {.position = {0, 5, 0}, .speed = 4});
      },
      [&](World& w) {
        w.spawn(ball(), {.position = {0, 5, 0}, .speed = 4}, {}, 3);
      },
      [&](World& w) {
        w.spawn(ball(), {.position = {0, 5, 0}, .speed = 4}, {}, 4);
      },
      [&](World& w) { w.clear(); },
      [&](World& w) {
        w[first(w)].add_force(ConstantForce{{1, 0, 0}});
      },
      [&](World& w) {
        w[first(w)].add_force(ConstantForce{{2, 0, 0}});
      },
      [&](World& w) {
        w[first(w)].add_force(ConstantForce{{2, 0, 0}}, 3);
      },
      [&](World& w) {
        w.remove_force(*w[first(w)].add_force(ConstantForce{{2, 0, 0}}));
      },
      [](World& w) { w.set_paused(true); },
      [](World& w) { w.set_time_scale(2); },
      [](World& w) { w.advance(0.001); },
      [](World& w) { w.step(0.001); },
      [](World& w) {
        w.set_observer({0, 0, 1});
      },
      [](World& w) {
        w.set_detail({{{Fidelity::game(), 5}, {Fidelity::arcade()}}});
      },
      [](World& w) { (void)w.add_environment({}); },
      [](World& w) { (void)w.set_environment(0, {.altitude = 100}); },
  };
  std::vector<std::uint64_t> hashes;
  for (const auto& change : changes) {
    World world = made(def);
    base(world);
    change(world);
    hashes.push_back(world.hash());
  }
  for (const double height : {1.0, 2.0}) {  // of another ground
    def.ground.height = -height;
    World world = made(def);
    base(world);
    hashes.push_back(world.hash());
  }
  for (std::size_t i = 0; i < hashes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(hashes[i], hashes[j]) << i << " and " << j;
}

/// Two that despawned the same projectiles in another order hand out other ids next.
TEST(Moments, the_order_of_free_slots_is_in_the_hash) {
  World a = made(), b = made();
  for (World* w : {&a, &b})
    for (int i = 0; i < 3; ++i) w->spawn(ball(), {.position = {0, 5, 0}});
  const auto ids = a.ids();
  a[ids[0]].despawn(), a[ids[1]].despawn();
  b[ids[1]].despawn(), b[ids[0]].despawn();
  EXPECT_NE(a.hash(), b.hash());
}

}  // namespace physim::world_moments_test
