// Wind and force by functions of one's own, in worlds: as flights have them, by the world's clock, through every door.
#include "world/world_support.hpp"

namespace physim::world_field_world_test {

using namespace test;
using Bytes = std::vector<std::byte>;

constexpr double kStep = 1.0 / 64;

Vec3d gust(double t, const Vec3d& x) { return {1, 0, t > 2 ? -8 - 0.01 * x.y : 0.5 * t}; }
Vec3d tug(double t, const Vec3d& x, const Vec3d& v, double m) {
  return (Vec3d{0.1 * v.z, t, -0.1 * v.x} - x * 1e-3) * m;
}

WindFunction gusts(double later = 0) {
  return [later](const WindBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i) b.velocity[i] = gust(later + b.time[i], b.position[i]);
  };
}
ForceFunction tugs(double later = 0) {
  return [later](const FieldForceBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i)
      b.force[i] = tug(later + b.time[i], b.position[i], b.velocity[i], b.mass[i]);
  };
}
Environment both(double later = 0) { return {.wind = {.field = gusts(later)}, .force = tugs(later)}; }
/// Nothing but a force of m a0 from a time of the world on.
Environment pushing_from(double start, const Vec3d& a0) {
  Environment e{.gravity = {.model = GravityModel::off}, .atmosphere = {.model = AirModel::vacuum}};
  e.force = [start, a0](const FieldForceBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i) b.force[i] = a0 * (b.time[i] >= start ? b.mass[i] : 0);
  };
  return e;
}

WorldDef open_world(const Environment& environment) {
  return {.environment = environment, .ground = {.mode = GroundMode::none}, .step = kStep};
}

ProjectileDef on(Fidelity f, Integrator integrator = Integrator::rk4) {
  ProjectileDef p = bullet();
  p.fidelity = f;
  p.fidelity.integrator = integrator;
  return p;
}

constexpr Integrator kFixed[] = {Integrator::classic, Integrator::explicit_euler, Integrator::semi_implicit_euler,
                                 Integrator::heun, Integrator::rk4};

const Launch kLaunch{.position = {3, 20, -5}, .speed = 400, .elevation = 0.3};

// ------------------------------------------------------------------------------------------------ as flights
TEST(FieldWorld, is_the_flight_bit_for_bit_whenever_it_starts) {
  for (const Integrator integrator : kFixed)
    for (const Precision precision : {Precision::float64, Precision::float32})
      for (const double start : {0.0, 1.25}) {
        SCOPED_TRACE(text(integrator) + (precision == Precision::float32 ? " float " : " ") + std::to_string(start));
        ProjectileDef p = on(Fidelity::simulation(), integrator);
        p.fidelity.rotation = RotationModel::none;
        p.fidelity.precision = precision;
        World world = make_world(open_world(both()));
        while (world.time() < start) world.step(kStep);
        std::vector<ProjectileId> ids;
        for (int i = 0; i < 19; ++i) ids.push_back(*world.spawn(p, kLaunch));
        for (int i = 0; i < 128; ++i) world.step(kStep);
        const Flight flight =
            fly(p, kLaunch, both(start), p.fidelity, {.step = kStep}, {.ground = {}, .time = 128 * kStep});
        for (const ProjectileId id : ids) {
          EXPECT_TRUE(same_bits(world[id].position(), flight.end().position));
          EXPECT_TRUE(same_bits(world[id].velocity(), flight.end().velocity));
        }
        if (precision == Precision::float32) continue;
        EXPECT_EQ(world[ids[3]].accelerations().applied, flight.accelerations(flight.duration()).applied);
        EXPECT_EQ(world[ids[3]].accelerations().drag, flight.accelerations(flight.duration()).drag);
        EXPECT_TRUE(near(world[ids[3]].mach(), flight.end().mach, 1e-15));
      }
}

TEST(FieldWorld, what_flies_in_a_vacuum_has_no_mach_number_as_in_its_flight) {
  for (const AirModel air : {AirModel::vacuum, AirModel::constant}) {
    ProjectileDef p = on(Fidelity::simulation(), Integrator::rk4);
    p.fidelity.air = air;
    World world = make_world(WorldDef{});
    const ProjectileId id = *world.spawn(p, kLaunch);
    const Flight flight = fly(p, kLaunch, Environment{}, p.fidelity, {}, {.ground = {}, .time = 1});
    EXPECT_EQ(flight.at(0).mach > 0, air == AirModel::constant);
    EXPECT_TRUE(near(world[id].mach(), flight.at(0).mach, 1e-15)) << world[id].mach();
  }
}

TEST(FieldWorld, adaptive_frames_and_bodies_follow_their_flights) {
  for (const RotationModel rotation : {RotationModel::none, RotationModel::modified_point_mass}) {
    ProjectileDef p = on(Fidelity::simulation(), Integrator::tsit5);
    p.fidelity.rotation = rotation;
    p.length = 0.03;
    p.twist = 0.3;
    p.inertia.moments = {1e-7, 1e-6, 1e-6};
    p.aero.pitching = {{.value = 2.5}};
    const double start = 0.5;
    World world = make_world(open_world(both()));
    for (int i = 0; i < 32; ++i) world.step(kStep);
    const ProjectileId id = *world.spawn(p, kLaunch);
    EXPECT_EQ(world[id].fidelity_in_use().fidelity.rotation, rotation);
    for (int i = 0; i < 64; ++i) world.step(kStep);
    const Flight flight = fly(p, kLaunch, both(start), p.fidelity, {1e-12, 1e-12}, {.ground = {}, .time = 64 * kStep});
    EXPECT_TRUE(near(world[id].position(), flight.end().position, 0, 1e-5));
    EXPECT_TRUE(near(world[id].mach(), flight.end().mach, 1e-7));
  }
}

TEST(FieldWorld, a_spring_swings_as_it_should) {
  const double k = 50, m = 2, omega = 5;
  Environment e = pushing_from(0, {});
  e.force = [=](const FieldForceBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i) b.force[i] = b.position[i] * -k;
  };
  ProjectileDef p = on(vacuum());
  p.mass = m;
  World world = make_world(open_world(e));
  const ProjectileId id = *world.spawn(p, {.position = {1, 0, 0}, .velocity = Vec3d{0, 2, 0}});
  for (int i = 0; i < 640; ++i) world.step(kStep);
  const double t = 10;
  EXPECT_TRUE(near(world[id].position(), {std::cos(omega * t), 2 / omega * std::sin(omega * t), 0}, 0, 2e-5));
}

// ------------------------------------------------------------------------------------------------ the world's clock
TEST(FieldWorld, a_gust_meets_all_at_the_same_moment) {
  const Vec3d a0{0, 0, 4};
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    ProjectileDef p = on(vacuum(), Integrator::semi_implicit_euler);
    p.fidelity.precision = precision;
    World world = make_world(open_world(pushing_from(2, a0)));
    const BodyDef awake{.can_sleep = false};  // what rests sleeps, whatever the wind will do
    std::vector<ProjectileId> ids{*world.spawn(p, {}, awake), *world.spawn(p, {}, awake, 1.0),
                                  *world.spawn(p, {}, awake, 2.5)};
    while (world.time() < 0.75) world.step(kStep);
    ids.push_back(*world.spawn(p, {}, awake));
    while (world.time() < 1.5) world.step(kStep / 2);  // another length of step
    ids.push_back(*world.spawn(p, {}, awake));
    world[ids[0]].set_fidelity(on(vacuum(), Integrator::rk4).fidelity);  // and another rung
    while (world.time() < 3) world.step(kStep);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const double pushed = i == 2 ? 0.5 : 1.0;
      const double slack = i == 0 ? kStep : 0;  // RK4 looks at the start of the gust from inside its step
      EXPECT_TRUE(near(world[ids[i]].velocity(), a0 * pushed, 1e-6, 4 * slack)) << i;
    }
  }
}

TEST(FieldWorld, forced_rows_feel_it_too) {
  ProjectileDef p = on(Fidelity::simulation());
  p.fidelity.rotation = RotationModel::none;
  const Vec3d push{0, 0, 0.1};
  World world = make_world(open_world(both()));
  const ProjectileId id = *world.spawn(p, kLaunch);
  world[id].add_force(ConstantForce{push});
  for (int i = 0; i < 128; ++i) world.step(kStep);
  p.force = push;
  const Flight flight = fly(p, kLaunch, both(), p.fidelity, {.step = kStep}, {.ground = {}, .time = 2});
  EXPECT_TRUE(near(world[id].position(), flight.end().position, 1e-13));
  EXPECT_TRUE(near(world[id].accelerations().applied, flight.accelerations(2).applied, 1e-12));
}

TEST(FieldWorld, a_zone_takes_the_place_of_its_wind) {
  // In a zone that is everywhere, the wind outside means nothing, whatever gives it.
  const double far = std::numeric_limits<double>::infinity();
  const WindZone zone{.velocity = {0, 0, 5}, .low = {-far, -far, -far}, .high = {far, far, far}};
  Environment field, constant;
  field.wind.field = gusts();
  constant.wind.velocity = {1, 0, -4};
  ProjectileDef p = on(Fidelity::simulation());
  p.fidelity.rotation = RotationModel::none;
  std::vector<Vec3d> places;
  for (const Environment& e : {field, constant}) {
    World world = make_world(open_world(e));
    const ProjectileId id = *world.spawn(p, kLaunch);
    world[id].add_force(zone);
    for (int i = 0; i < 200; ++i) world.step(kStep);
    places.push_back(world[id].position());
  }
  EXPECT_TRUE(near(places[0], places[1], 0, 1e-9));
}

TEST(FieldWorld, an_environment_may_get_and_lose_functions_in_flight) {
  const Vec3d a0{0, 0, 4};
  Environment calm = pushing_from(0, a0);
  calm.force = {};
  World world = make_world(open_world(calm));
  const ProjectileId id = *world.spawn(on(vacuum()), {.speed = 1});
  for (int i = 0; i < 64; ++i) world.step(kStep);
  ASSERT_TRUE(world.set_environment(0, pushing_from(1.5, a0)));
  for (int i = 0; i < 64; ++i) world.step(kStep);
  EXPECT_TRUE(near(world[id].velocity(), {1, 0, 2}, 0, 2 * kStep));
  const Vec3d kept = world[id].velocity();
  ASSERT_TRUE(world.set_environment(0, calm));
  for (int i = 0; i < 64; ++i) world.step(kStep);
  EXPECT_EQ(world[id].velocity(), kept);
}

TEST(FieldWorld, a_shell_survives_the_loss_of_its_wind) {
  ProjectileDef p = on(Fidelity::simulation(), Integrator::rk4);
  p.fidelity.rotation = RotationModel::modified_point_mass;
  p.twist = 0.3;
  p.inertia.moments = {1e-7, 1e-6, 1e-6};
  p.aero.pitching = {{.value = 2.5}};
  World world = make_world(open_world(both()));
  const ProjectileId id = *world.spawn(p, kLaunch);
  world.step(kStep);
  ASSERT_TRUE(world.set_environment(0, Environment{}));
  for (int i = 0; i < 64; ++i) world.step(kStep);
  EXPECT_TRUE(world[id].is_alive());
  EXPECT_EQ(world[id].accelerations().applied, (Vec3d{}));
}

TEST(FieldWorld, zeros_and_rungs_are_found_for_the_time_of_the_launch) {
  Environment e;
  e.force = [](const FieldForceBatch& b) {  // it lifts from the second second on
    for (std::size_t i = 0; i < b.time.size(); ++i) b.force[i] = {0, b.time[i] > 2 ? 9 * b.mass[i] : 0, 0};
  };
  ProjectileDef p = on(Fidelity::simulation());
  p.fidelity.rotation = RotationModel::none;
  World world = make_world(open_world(e));
  const Launch launch{.speed = 800, .sight = {.zero_range = 400}};
  while (world.time() < 3) world.step(kStep);
  const ProjectileId now = *world.spawn(p, launch);
  const ProjectileId pending = *world.spawn(p, launch, {}, 1.0);
  Environment lifting = e;
  lifting.force = [](const FieldForceBatch& b) {
    for (std::size_t i = 0; i < b.time.size(); ++i) b.force[i] = {0, 9 * b.mass[i], 0};
  };
  const auto elevation = must(zero_elevation(p, launch, lifting, p.fidelity, 400));
  for (const ProjectileId id : {now, pending}) {
    const Vec3d v = world[id].velocity();
    EXPECT_NEAR(std::atan2(v.y, v.x), elevation, 1e-9);
  }
  World chosen = make_world(open_world(pushing_from(2, {0, 0, 30})));
  const auto motion_of = [&] {
    return chosen[*chosen.spawn(p, {.speed = 10}, {.cheapest_within = 0.01, .within_time = 1})]
        .fidelity_in_use()
        .fidelity.motion;
  };
  EXPECT_EQ(motion_of(), Motion::closed_form) << "nothing pushes it yet";
  while (chosen.time() < 1.5) chosen.step(kStep);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(motion_of(), Motion::force);
}

TEST(FieldWorld, predictions_know_the_time_of_the_world) {
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    ProjectileDef p = on(Fidelity::simulation());
    p.fidelity.rotation = RotationModel::none;
    p.fidelity.precision = precision;
    World world = make_world(open_world(both()));
    while (world.time() < 0.75) world.step(kStep);
    const ProjectileId id = *world.spawn(p, kLaunch);
    while (world.time() < 1.5) world.step(kStep);
    const Flight predicted = world.predict(id, Until{.ground = {}, .time = 2}, kStep);
    ASSERT_FALSE(predicted.error());
    const double mach = world[id].mach();
    for (int i = 0; i < 128; ++i) world.step(kStep);
    EXPECT_TRUE(same_bits(world[id].position(), predicted.end().position));
    EXPECT_TRUE(near(predicted.at(0).mach, mach, 1e-15));
    EXPECT_TRUE(near(predicted.end().mach, world[id].mach(), 1e-14));
  }
}

TEST(FieldWorld, what_comes_from_a_flight_goes_on_by_the_worlds_clock) {
  ProjectileDef p = on(Fidelity::simulation());
  p.fidelity.rotation = RotationModel::none;
  const Flight flight = fly(p, kLaunch, both(), p.fidelity, {.step = kStep}, {.ground = {}, .time = 3});
  World world = make_world(open_world(both()));
  while (world.time() < 1) world.step(kStep);
  const ProjectileId id = *world.spawn(flight, 1);
  while (world.time() < 3) world.step(kStep);
  EXPECT_TRUE(near(world[id].position(), flight.end().position, 0, 1e-9));
}

// ---------------------------------------- threads, bad functions
TEST(FieldWorld, threads_change_nothing) {
  std::vector<std::uint64_t> hashes;
  for (const unsigned threads : {1u, 3u}) {
    WorldDef def = open_world(both());
    def.ground = {.mode = GroundMode::bounce};
    def.threading = {.threads = threads, .rows_per_thread = 1};
    World world = make_world(def);
    const KindId kind = *world.add_kind(on(Fidelity::simulation()));
    const KindId game = *world.add_kind(on(Fidelity::game(), Integrator::semi_implicit_euler));
    for (int i = 0; i < 6000; ++i)
      ASSERT_TRUE(world.spawn(i % 2 ? kind : game, {.position = {0, 0.1 * (i % 50), 0.01 * i}, .speed = 20}));
    for (int i = 0; i < 64; ++i) world.step(kStep);
    hashes.push_back(world.hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(FieldWorld, wrong_answers_retire_whom_they_concern) {
  const auto is_wrong = [](double t, const Vec3d& x) { return t > 0.25 && x.z > 1; };
  for (const bool throwing : {false, true})
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::tsit5})
      for (const bool forced : {false, true}) {
        Environment e;
        e.wind.field = [=](const WindBatch& b) {
          for (std::size_t i = 0; i < b.time.size(); ++i) {
            if (!is_wrong(b.time[i], b.position[i])) continue;
            if (throwing) throw std::runtime_error("no wind");
            b.velocity[i] = {0, kNan, 0};
          }
        };
        World world = make_world(open_world(e));
        std::vector<ProjectileId> ids;
        for (int i = 0; i < 40; ++i) {
          ProjectileDef p = on(Fidelity::simulation(), integrator);
          ids.push_back(*world.spawn(p, {.position = {0, 50, i % 4 == 0 ? 5.0 : -5.0}, .speed = 100}));
          if (forced) world[ids.back()].add_force(ConstantForce{{0, 1e-3, 0}});
        }
        std::size_t retired = 0;
        for (int i = 0; i < 64; ++i) {
          world.step(kStep);
          for (const Event& event : events_of(world, EventKind::retired)) {
            EXPECT_TRUE(event.reason == Reason::non_finite ||
                        (event.reason == Reason::stalled && integrator == Integrator::tsit5 && !forced));
            ++retired;
          }
        }
        EXPECT_EQ(retired, 10u) << throwing << text(integrator) << forced;
        for (int i = 0; i < 40; ++i) EXPECT_EQ(world[ids[static_cast<std::size_t>(i)]].is_alive(), i % 4 != 0) << i;
      }
}

// ---------------------------------------- moments, saves, replays
LoadOptions with_fields() { return {.wind_fields = {gusts()}, .force_fields = {tugs()}}; }

World busy_world() {
  World world = make_world(open_world(both()));
  for (const Fidelity& f : {Fidelity::simulation(), Fidelity::game(), Fidelity::constant_air(), Fidelity::arcade()}) {
    EXPECT_TRUE(world.spawn(on(f, f.integrator), kLaunch));
    EXPECT_TRUE(world.spawn(on(f, f.integrator), kLaunch, {}, 0.3));
  }
  for (int i = 0; i < 40; ++i) world.step(kStep);
  EXPECT_TRUE(world.spawn(on(Fidelity::simulation()), kLaunch));
  return world;
}

TEST(FieldWorld, snapshots_bring_functions_back) {
  World world = busy_world();
  const Snapshot here = world.snapshot();
  for (int i = 0; i < 30; ++i) world.step(kStep);
  const std::uint64_t hash = world.hash();
  ASSERT_TRUE(world.set_environment(0, Environment{}));
  for (int i = 0; i < 30; ++i) world.step(kStep);
  ASSERT_TRUE(world.restore(here));
  for (int i = 0; i < 30; ++i) world.step(kStep);
  EXPECT_EQ(world.hash(), hash);
}

TEST(FieldWorld, saves_need_their_functions) {
  World world = busy_world();
  ASSERT_TRUE(world.add_environment(world.def().environment)) << "twice the same functions: given once";
  const Bytes save = *world.save();
  for (const char* missing : {"wind_fields", "force_fields"}) {
    LoadOptions some = with_fields();
    (missing[0] == 'w' ? some.wind_fields.clear() : some.force_fields.clear());
    const auto refused = World::load(save, some);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().place, missing);
  }
  auto loaded = must(World::load(save, with_fields()));
  World again = std::move(loaded);
  EXPECT_EQ(*again.save(), save);
  for (int i = 0; i < 60; ++i) {
    ASSERT_EQ(world.hash(), again.hash()) << i;
    world.step(kStep), again.step(kStep);
  }
  for (const ProjectileId id : world.ids()) EXPECT_EQ(world[id].state(), again[id].state());
}

TEST(FieldWorld, replays_need_them_in_the_order_in_which_they_came) {
  for (const bool from_now : {false, true}) {
    Bytes bytes;
    World world = make_world(open_world(both()));
    if (from_now) (void)world.spawn(on(Fidelity::simulation()), kLaunch);
    ASSERT_TRUE(world.record(record_into(bytes), {.from_now = from_now}));
    ASSERT_TRUE(world.spawn(on(Fidelity::simulation()), kLaunch));
    for (int i = 0; i < 20; ++i) world.step(kStep);
    Environment other{.wind = {.field = gusts(5)}};
    ASSERT_TRUE(world.set_environment(0, other));
    for (int i = 0; i < 20; ++i) world.step(kStep);
    ASSERT_TRUE(world.stop_recording());
    const auto refused = replay(bytes, with_fields());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().place, "wind_fields");
    ReplayOptions all = with_fields();
    all.wind_fields.push_back(gusts(5));
    const auto report = must(replay(bytes, all));
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.steps, 40u);
    std::swap(all.wind_fields[0], all.wind_fields[1]);
    EXPECT_TRUE(replay(bytes, all)->difference);
  }
}

TEST(FieldWorld, hashes_tell_worlds_with_functions_from_others) {
  EXPECT_NE(make_world(open_world(both())).hash(), make_world(open_world({})).hash());
}

}  // namespace physim::world_field_world_test
