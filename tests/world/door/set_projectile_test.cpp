// What a projectile is, changed while it flies: mass, diameter, drag and damping.
#include <map>

#include "scenario/scenario.hpp"
#include "world/world_support.hpp"

namespace physim::world_set_projectile_test {

constexpr double kStep = 1.0 / 60;
const Launch kHigh{.position = {0, 500, 0}, .velocity = Vec3d{60, 10, 5}};

World open_world() { return make_world({.ground = {.mode = GroundMode::none}}); }

/// Rungs of each drag and motion.
std::vector<Fidelity> rungs() {
  std::vector<Fidelity> list;
  for (const DragModel drag : {DragModel::off, DragModel::damping, DragModel::linear_quadratic, DragModel::equation})
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::tsit5}) {
      Fidelity f = Fidelity::constant_air();
      f.drag = drag, f.integrator = integrator;
      list.push_back(f);
    }
  Fidelity closed = Fidelity::arcade();
  closed.drag = DragModel::damping, closed.precision = Precision::float64;
  list.push_back(closed);
  return list;
}

ProjectileDef ball() {
  return {.mass = 2, .diameter = 0.1, .drag = {.coefficient = 0.4, .damping = 0.8, .k1 = 0.1, .k2 = 0.01}};
}
ProjectileDef other_ball() {
  return {.mass = 5, .diameter = 0.2, .drag = {.coefficient = 0.3, .damping = 0.5, .k1 = 0.3, .k2 = 0.02}};
}

/// After the change it flies as one that is launched there as what it became.
TEST(SetProjectile, flies_on_as_one_that_is_launched_there) {
  for (const Fidelity& f : rungs()) {
    SCOPED_TRACE(std::string(name(f.drag)) + " " + std::string(name(f.integrator)) + " " + std::string(name(f.motion)));
    ProjectileDef from = ball(), to = other_ball();
    from.fidelity = to.fidelity = f;
    World world = open_world(), fresh = open_world();
    const ProjectileId id = *world.spawn(from, kHigh);
    for (int i = 0; i < 20; ++i) world.step(kStep);
    const BodyState at = world[id].state();
    ASSERT_TRUE(world[id].set_projectile(to));
    EXPECT_EQ(world[id].state(), at);
    EXPECT_EQ(*world[id].definition(), to);
    EXPECT_EQ(world[id].mass(), 5);
    const ProjectileId other = *fresh.spawn(to, {.position = at.position, .velocity = at.velocity});
    EXPECT_TRUE(test::near(world[id].accelerations().total, fresh[other].accelerations().total, 1e-12, 1e-12));
    for (int i = 0; i < 20; ++i) world.step(kStep), fresh.step(kStep);
    EXPECT_TRUE(test::near(world[id].position(), fresh[other].position(), 1e-9));
    EXPECT_TRUE(test::near(world[id].velocity(), fresh[other].velocity(), 1e-9));
  }
}

TEST(SetProjectile, single_calls_are_parts_of_it) {
  ProjectileDef from = ball();
  from.fidelity = Fidelity::constant_air();
  World one = open_world(), many = open_world();
  const ProjectileId a = *one.spawn(from, kHigh), b = *many.spawn(from, kHigh);
  ProjectileDef to = from;
  to.mass = 3, to.drag = other_ball().drag, to.drag.damping = 0.7;
  ASSERT_TRUE(one[a].set_projectile(to));
  ASSERT_TRUE(many[b].set_mass(3));
  ASSERT_TRUE(many[b].set_drag(other_ball().drag));
  ASSERT_TRUE(many[b].set_damping(0.7));
  EXPECT_EQ(*one[a].definition(), *many[b].definition());
  EXPECT_EQ(one.hash(), many.hash());
}

/// Momentum does not stay, velocity does; a push then makes half of the acceleration.
TEST(SetProjectile, twice_the_mass_is_half_of_the_acceleration_by_a_force) {
  Fidelity f = Fidelity::reference();
  f.drag = DragModel::off, f.gravity = GravityModel::off, f.earth = EarthModel::flat;
  const ProjectileDef pushed{.mass = 2, .force = {8, 0, 0}, .fidelity = f};
  World world = open_world();
  const ProjectileId id = *world.spawn(pushed, kHigh);
  ASSERT_TRUE(world[id].add_force(ConstantForce{.force = {0, 4, 0}}).ok());
  world.step(kStep);
  EXPECT_TRUE(test::near(world[id].accelerations().total, {4, 2, 0}, 1e-12));
  const Vec3d v = world[id].velocity();
  ASSERT_TRUE(world[id].set_mass(4));
  EXPECT_EQ(world[id].velocity(), v);
  EXPECT_TRUE(test::near(world[id].accelerations().total, {2, 1, 0}, 1e-12));
  for (int i = 0; i < 60; ++i) world.step(kStep);
  EXPECT_TRUE(test::near(world[id].velocity() - v, {2, 1, 0}, 1e-9));
}

/// Motion velocity knows no mass: where it was launched, and the register of the original's loop, stay.
TEST(SetProjectile, keeps_where_it_was_launched_and_what_its_loop_took_over) {
  World world = open_world(), plain = open_world();
  const ProjectileDef p = presets::artillery().projectile;
  const BodyDef near{.despawn = {.farther = 20}};
  const ProjectileId id = *world.spawn(p, {.velocity = Vec3d{40, 0, 0}}, near);
  const ProjectileId same = *plain.spawn(p, {.velocity = Vec3d{40, 0, 0}}, near);
  for (int frame = 0; plain[same].is_alive(); ++frame) {
    if (frame == 10) {
      ASSERT_TRUE(world[id].set_mass(500));
    }
    EXPECT_EQ(world[id].position(), plain[same].position()) << frame;
    world.step(kStep), plain.step(kStep);
    ASSERT_LT(frame, 200);
  }
  EXPECT_FALSE(world[id].is_alive()) << "it expires 20 m from its muzzle, not from where it was changed";
}

TEST(SetProjectile, refuses_what_makes_no_sense_and_changes_nothing) {
  World world = open_world();
  ProjectileDef p = ball();
  p.fidelity = Fidelity::constant_air();
  const ProjectileId id = *world.spawn(p, kHigh);
  const std::uint64_t before = world.hash();
  const auto place = [&](const Status& status) {
    EXPECT_FALSE(status);
    EXPECT_EQ(world.hash(), before);
    EXPECT_EQ(*world[id].definition(), p);
    return status ? std::string() : status.error().place;
  };
  for (const double mass : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_EQ(place(world[id].set_mass(mass)), "projectile.mass") << mass;
  for (const double damping : {0.0, -0.1, 1.1, double(NAN)})
    EXPECT_EQ(place(world[id].set_damping(damping)), "projectile.drag.damping") << damping;
  EXPECT_EQ(place(world[id].set_drag({.k1 = -1})), "projectile.drag.k1");
  EXPECT_EQ(place(world[id].set_drag({.table = DragTable::custom})), "projectile.drag.curve");
  ProjectileDef longer = p;
  longer.length = 1;
  EXPECT_EQ(place(world[id].set_projectile(longer)), "projectile");
  ProjectileDef other_rung = p;
  other_rung.fidelity = Fidelity::game();
  EXPECT_EQ(place(world[id].set_projectile(other_rung)), "projectile");
  EXPECT_FALSE(world[ProjectileId{}].set_mass(1));

  ProjectileDef rocket{.mass = 1, .motor = {.thrust = {{0, 50}, {2, 0}}, .propellant_mass = 0.3}};
  const ProjectileId flown = *world.spawn(rocket, kHigh);
  const Status of_rocket = world[flown].set_mass(2);
  ASSERT_FALSE(of_rocket);
  EXPECT_NE(of_rocket.error().text().find("motor"), std::string::npos);
  EXPECT_TRUE(world[flown].set_mass(1)) << "what changes nothing is no change";
}

TEST(SetProjectile, is_kept_by_snapshots_saves_and_recordings) {
  std::vector<std::byte> recording;
  World world = open_world();
  ASSERT_TRUE(world.record(record_into(recording)));
  ProjectileDef p = ball();
  p.fidelity = Fidelity::constant_air();
  const ProjectileId id = *world.spawn(p, kHigh);
  world.step(kStep);
  const Snapshot before = world.snapshot();
  ASSERT_TRUE(world[id].set_projectile([&] {
    ProjectileDef to = other_ball();
    to.fidelity = p.fidelity;
    return to;
  }()));
  world.step(kStep);
  ASSERT_TRUE(world[id].set_mass(9));
  ASSERT_TRUE(world[id].set_damping(0.3));
  const Snapshot after = world.snapshot();
  const std::uint64_t hash = world.hash();
  ASSERT_TRUE(world.restore(before));
  EXPECT_EQ(world[id].mass(), 2);
  ASSERT_TRUE(world.restore(after));
  EXPECT_EQ(world[id].mass(), 9);
  EXPECT_EQ(world.hash(), hash);
  const auto saved = world.save();
  ASSERT_TRUE(saved.ok());
  Result<World> loaded = World::load(*saved);
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  EXPECT_EQ((*loaded)[id].mass(), 9);
  EXPECT_EQ(loaded->hash(), hash);
  for (int i = 0; i < 20; ++i) world.step(kStep), loaded->step(kStep);
  EXPECT_EQ((*loaded)[id].state(), world[id].state());
  ASSERT_TRUE(world.stop_recording());
  Result<Replay> replay = Replay::open(recording);
  ASSERT_TRUE(replay.ok()) << replay.error().text();
  while (replay->next()) {
  }
  EXPECT_FALSE(replay->report().difference);
  EXPECT_TRUE(replay->report().complete);
  EXPECT_EQ(replay->world().hash(), world.hash());
}

TEST(SetProjectile, wakes_what_sleeps_and_forgets_kinds_that_nobody_uses) {
  World world;
  ProjectileDef p = stone();
  const ProjectileId id = *world.spawn(p, kHigh);
  ASSERT_TRUE(world[id].sleep());
  ASSERT_TRUE(world[id].set_mass(3));
  EXPECT_FALSE(world[id].is_asleep());
  const std::size_t before = world.memory();
  for (int i = 0; i < 20000; ++i) ASSERT_TRUE(world[id].set_mass(1 + 1e-4 * i));
  EXPECT_LT(world.memory(), before + (4u << 20)) << "each mass is a kind, and kinds come and go";
  EXPECT_NEAR(world[id].mass(), 2.9999, 1e-12);
}

/// Forces on a kind act on what is of that kind; what was changed is of another.
TEST(SetProjectile, leaves_the_generators_of_its_former_kind) {
  World world = open_world();
  const KindId kind = *world.add_kind(stone(), {});
  const ProjectileId a = *world.spawn(kind, kHigh), b = *world.spawn(kind, kHigh);
  ASSERT_TRUE(world.add_force({ConstantAcceleration{{3, 0, 0}}, {.kind = kind}}).ok());
  world.step(kStep);
  ASSERT_TRUE(world[a].set_mass(7));
  EXPECT_FALSE(world[a].kind() == kind);
  world.step(kStep);
  EXPECT_NEAR(world[a].accelerations().applied.x, 0, 1e-12);
  EXPECT_NEAR(world[b].accelerations().applied.x, 3, 1e-12);
}

/// The list of settings marks as live what set_projectile() takes.
TEST(SetProjectile, the_list_of_settings_marks_what_it_takes) {
  const std::map<std::string, std::string> others = {
      {"shot.mass", "3 kg"},          {"shot.diameter", "0.3 m"},
      {"shot.drag.table", "g7"},      {"shot.drag.coefficient", "0.9"},
      {"shot.drag.form_factor", "2"}, {"shot.drag.ballistic_coefficient", "100 kg/m^2"},
      {"shot.drag.damping", "0.4"},   {"shot.drag.k1", "2 kg/s"},
      {"shot.drag.k2", "2 kg/m"},     {"shot.length", "1 m"},
      {"shot.twist", "1 m"},          {"shot.gravity_scale", "2"},
      {"shot.force", "[1, 0, 0]"},    {"shot.magnus.lift", "2"}};
  std::size_t found = 0;
  for (const Setting& setting : settings()) {
    const auto other = others.find(setting.path);
    if (other == others.end()) continue;
    ++found;
    const std::vector<std::string> changed = {setting.path + "=" + other->second};
    const std::string text =
        "physim = 1\n[[shot]]\nname = \"ball\"\nmass = \"2 kg\"\ndiameter = \"0.1 m\"\nspeed = \"9 m/s\"\n";
    const Result<Scenario> plain = parse_scenario(text, "f.toml"), with = parse_scenario(text, "f.toml", changed);
    ASSERT_TRUE(plain.ok() && with.ok()) << setting.path;
    World world = open_world();
    const ProjectileId id = *world.spawn(plain->shots[0].projectile, kHigh);
    EXPECT_EQ(world[id].set_projectile(with->shots[0].projectile).ok(), setting.live) << setting.path;
  }
  EXPECT_EQ(found, others.size());
}

}  // namespace physim::world_set_projectile_test
