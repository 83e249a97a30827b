// What emitters do to the flight of their particles: closed forms, frames, contacts, and everything that worlds keep.
#include "emit/flight_law.hpp"
#include "math/quat.hpp"
#include "math/vec3.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_flight_test {

constexpr double kBorn = 0.0123;  // within a frame at any rate below

BodyDef weightless() { return {.use_gravity = false}; }
ProjectileDef driven(Integrator integrator = Integrator::rk4) { return spark(Motion::force, integrator); }

/// One particle, born at kBorn with 10 m/s along x and 3 upwards, of 2 s.
EmitterDef single(KindId kind, const ParticleFlight& flight) {
  EmitterDef def{.kind = kind,
                 .cycle = {.duration = 5, .looping = false},
                 .seed = 3,
                 .per_second = {0},
                 .bursts = {{.time = kBorn}},
                 .start = {.lifetime = {2}, .speed = {std::sqrt(109.0)}}};
  const double angle = std::atan2(3, 10);
  def.rotation = {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
  def.flight = flight;
  return def;
}

const Curve kFalling{{0, 1}, {1, 0}};

struct Flown {
  double age;
  BodyState at;
};
/// Where such a particle is after about a second.
Flown flown(const ParticleFlight& flight, double dt, Integrator integrator = Integrator::rk4,
            const BodyDef& body = weightless(), double end = 1) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const EmitterId id = added(world, single(kind_of(world, driven(integrator), body), flight));
  while (world.time() < end - dt / 4) EXPECT_TRUE(world.step(dt));
  const auto all = alive(world, id);
  EXPECT_EQ(all.size(), 1u);
  return {world.time() - kBorn, all.empty() ? BodyState{} : all.begin()->second};
}

// ------------------------------------------------------------------------------------------- closed forms
TEST(EmitterFlight, drag_that_falls_with_age_is_the_exponential_of_its_integral) {
  const ParticleFlight flight{.drag = {3, {}, kFalling}};  // k = 3 (1 - t / 2)
  for (const double dt : {1.0 / 10, 1.0 / 60, 1.0 / 144}) {
    const auto [t, at] = flown(flight, dt);
    const double left = std::exp(-(3 * t - 0.75 * t * t));
    EXPECT_LT(length(at.velocity - Vec3d{10, 3, 0} * left), 40 * std::pow(dt, 4)) << dt;
    double way = 0;  // the integral, by Simpson's rule
    const int n = 20'000;
    for (int i = 0; i <= n; ++i) {
      const double s = t * i / n, f = std::exp(-(3 * s - 0.75 * s * s));
      way += f * (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * t / n / 3;
    }
    EXPECT_LT(length(at.position - Vec3d{10, 3, 0} * way), 20 * std::pow(dt, 4)) << dt;
  }
}

TEST(EmitterFlight, drag_by_speed_is_quadratic_where_its_curve_is_straight) {
  const ParticleFlight flight{.drag = {20}, .fast = 20, .drag_by_speed = {{0, 0}, {1, 1}}};  // a = -v |v|
  const auto [t, at] = flown(flight, 1.0 / 500);
  const double v0 = std::sqrt(109.0), v = v0 / (1 + v0 * t);
  EXPECT_NEAR(length(at.velocity), v, 1e-7);
  EXPECT_NEAR(length(at.position), std::log(1 + v0 * t), 1e-7);
}

TEST(EmitterFlight, gravity_by_age_is_integrated_twice) {
  const ParticleFlight flight{.gravity = {1, {}, {{0, 1}, {1, -1}}}};  // g (1 - t)
  const double g = Environment{}.gravity.acceleration;
  for (const double dt : {1.0 / 10, 1.0 / 24, 1.0 / 60}) {
    const auto [t, at] = flown(flight, dt, Integrator::rk4, {});
    EXPECT_LT(length(at.velocity - Vec3d{10, 3 - g * (t - t * t / 2), 0}), 1e-12) << dt;
    EXPECT_LT(length(at.position - Vec3d{10 * t, 3 * t - g * (t * t / 2 - t * t * t / 6), 0}), 1e-12) << dt;
  }
}

TEST(EmitterFlight, gravity_by_age_is_a_part_of_what_it_feels_itself) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = single(kind_of(world, driven()), {.gravity = {0.5}});
  def.start.gravity = {3};
  const EmitterId id = added(world, def);
  step_to(world, 1, 60);
  const double t = world.time() - kBorn, g = Environment{}.gravity.acceleration;
  EXPECT_NEAR(alive(world, id).at(0).velocity.y, 3 - 1.5 * g * t, 1e-12);
}

TEST(EmitterFlight, a_force_is_over_the_mass) {
  const ParticleFlight flight{.force_x = {0.002}, .force_y = {-0.001, {}, kFalling}, .force_z = {0.004}};
  const auto [t, at] = flown(flight, 1.0 / 30);
  EXPECT_LT(length(at.velocity - Vec3d{10 + 2 * t, 3 - (t - t * t / 4), 4 * t}), 1e-12);
  EXPECT_LT(length(at.position - Vec3d{(10 + t) * t, 3 * t - (t * t / 2 - t * t * t / 12), 2 * t * t}), 1e-12);
}

TEST(EmitterFlight, a_velocity_is_what_its_curve_says_at_the_ends_of_all_steps_of_all_integrators) {
  // Its corners, at 0.3 and 1.1 s, lie within steps.
  const Curve corners{{0.15, 1}, {0.3, 2.5}, {0.55, -1}};
  const ParticleFlight flight{.velocity_x = {4, {}, corners}, .velocity_y = {2}, .velocity_z = {-3, {}, kFalling}};
  const FlightLaw law(flight, 3);
  for (const Integrator integrator : {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun,
                                      Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    for (const double dt : {1.0 / 7, 1.0 / 60}) {
      const auto [t, at] = flown(flight, dt, integrator);
      const Vec3d added = law.added_velocity({0, 0, 2}, t);
      EXPECT_LT(length(at.velocity - (Vec3d{10, 3, 0} + added)), 1e-12) << int(integrator) << ", " << dt;
    }
  }
  // Its way is the integral of the curve.
  const auto [t, at] = flown(flight, 1.0 / 2000);
  Vec3d way = Vec3d{10, 3, 0} * t;
  for (int i = 0; i < 100'000; ++i) way += law.added_velocity({0, 0, 2}, (i + 0.5) * t / 100'000) * (t / 100'000);
  EXPECT_LT(length(at.position - way), 1e-6);
}

TEST(EmitterFlight, a_limit_takes_away_what_is_above_it) {
  const double v0 = std::sqrt(109.0);
  const auto [t, at] = flown({.limit = {4}, .limit_rate = 3}, 1.0 / 100);
  EXPECT_NEAR(length(at.velocity), 4 + (v0 - 4) * std::exp(-3 * t), 1e-7);
  EXPECT_NEAR(at.velocity.y / at.velocity.x, 0.3, 1e-12);
  EXPECT_NEAR(length(at.position), 4 * t + (v0 - 4) * (1 - std::exp(-3 * t)) / 3, 1e-7);
  const auto [u, free] = flown({.limit = {11}, .limit_rate = 3}, 1.0 / 100);
  EXPECT_LT(length(free.velocity - Vec3d{10, 3, 0}), 1e-13);
}

TEST(EmitterFlight, noise_is_one_field_that_all_particles_of_a_seed_feel) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, driven(), weightless()), 200, 1);
  def.flight = {.noise = {7}, .noise_size = 0.4, .noise_rate = 0.3, .noise_octaves = 2};
  def.from.shape = EmitShape::sphere;
  const EmitterId one = added(world, def);
  def.position = {5, 0, 0};
  const EmitterId other = added(world, def);
  step_to(world, 1, 60);
  const FlightLaw law(def.flight, *def.seed);
  for (const EmitterId id : {one, other}) {
    std::vector<ProjectileId> ids(world.particles(id, {}));
    ASSERT_GT(ids.size(), 100u);
    world.particles(id, {.id = ids});
    for (const ProjectileId each : ids) {
      const ProjectileView p = std::as_const(world)[each];
      const Vec3d field = law.acceleration({}, world.time(), {p.position(), p.velocity()});
      EXPECT_LT(length(p.accelerations().applied - field), 1e-12);
      EXPECT_GT(length(field), 0);
    }
  }
}

// ------------------------------------------------------------------------------------------- frames
ParticleFlight everything() {
  return {.drag = {1, 3, kFalling},
          .fast = 30,
          .drag_by_speed = {{0, 1}, {1, 2}},
          .gravity = {0.2, 1, kFalling},
          .velocity_x = {3, {}, {{0, 0}, {0.5, 1}, {1, 0}}},
          .velocity_y = {1, 2},
          .force_z = {0.001, 0.003},
          .limit = {40},
          .noise = {4, 6},
          .noise_size = 3,
          .noise_rate = 0.2,
          .noise_octaves = 2};
}

/// Everyone after half a second at a frame rate.
std::map<std::uint64_t, BodyState> at_half(int rate, Integrator integrator, bool by_path = false) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, driven(integrator)), 150, 3);
  def.flight = everything();
  if (by_path) def.motion = SteadyMotion{.velocity = {30, 0, 0}};
  const EmitterId id = added(world, def);
  for (int i = 0; i < rate / 2; ++i) EXPECT_TRUE(world.step(1.0 / rate));
  return alive(world, id);
}
double farthest(const std::map<std::uint64_t, BodyState>& a, const std::map<std::uint64_t, BodyState>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (const auto& [number, at] : a) most = std::max(most, length(at.position - b.at(number).position));
  return most;
}

TEST(EmitterFlight, who_is_born_does_not_depend_on_frames) {
  std::vector<Event> first;
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = spray(kind_of(world, driven()), 300, 0.4);
    def.flight = everything();
    added(world, def);
    std::vector<Event> events;
    step_to(world, 0.7, rate, &events);
    const std::vector<Event> born = told(events, EventKind::spawned, 0.5);
    if (first.empty()) first = born;
    ASSERT_EQ(born.size(), first.size());
    ASSERT_GT(born.size(), 100u);
    for (std::size_t i = 0; i < born.size(); ++i) {
      ASSERT_EQ(born[i].time, first[i].time);
      ASSERT_EQ(born[i].velocity, first[i].velocity);
    }
    EXPECT_EQ(told(events, EventKind::expired, 0.5).size(), 30u);
  }
}

TEST(EmitterFlight, places_come_together_with_the_order_of_the_rung) {
  const struct {
    Integrator integrator;
    double order, within;
  } rows[] = {{Integrator::semi_implicit_euler, 1, 0.5}, {Integrator::heun, 2, 2e-3}, {Integrator::rk4, 3, 1e-4}};
  const auto truth = at_half(5000, Integrator::rk4);
  for (const auto& row : rows) {
    const double coarse = farthest(at_half(50, row.integrator), truth);
    const double fine = farthest(at_half(200, row.integrator), truth);
    EXPECT_LT(coarse, row.within);
    EXPECT_GT(std::log(coarse / fine) / std::log(4), row.order - 0.35) << coarse << ", " << fine;
  }
}

TEST(EmitterFlight, ends_of_lives_are_where_the_flight_is_then) {
  const auto ended = [](int rate) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = single(kind_of(world, driven(), weightless()), {.drag = {2}});
    def.start.lifetime = {0.5017};
    added(world, def);
    std::vector<Event> events;
    step_to(world, 0.8, rate, &events);
    const auto told_so = told(events, EventKind::expired, 1);
    EXPECT_EQ(told_so.size(), 1u);
    return told_so.empty() ? Event{} : told_so.front();
  };
  for (const int rate : {10, 24, 60, 144}) {
    const Event end = ended(rate);
    EXPECT_NEAR(end.time, kBorn + 0.5017, 1e-12);
    EXPECT_LT(length(end.velocity - Vec3d{10, 3, 0} * std::exp(-2 * 0.5017)), 40 * std::pow(1.0 / rate, 4)) << rate;
  }
}

TEST(EmitterFlight, a_past_is_as_if_one_had_waited) {
  const auto run = [](bool prewarm, int frames) {
    World world = make_world({.ground = {.mode = GroundMode::none}, .step = 1.0 / 100});
    EmitterDef def = spray(kind_of(world, driven()), 97, 0.605);
    def.flight = everything();
    def.flight.noise = {0};  // a field is that of the world's time
    def.cycle = {.duration = 1, .prewarm = prewarm};
    const EmitterId id = added(world, def);
    for (int i = 0; i < frames; ++i) world.single_step();
    return alive(world, id);
  };
  const auto waited = run(false, 110), warm = run(true, 10);
  EXPECT_GT(waited.size(), 50u);
  EXPECT_LT(farthest(waited, warm), 1e-6);
}

// ------------------------------------------------------------------------------------------- contacts, forces
TEST(EmitterFlight, goes_on_behind_a_bounce_with_the_order_of_the_rung) {
  // Down on the ground with linear drag and back up: v = -(v0 e^-kt1) after the bounce, in closed form.
  const auto height = [](double dt) {
    World world = make_world({.ground = {.mode = GroundMode::bounce, .restitution = 1, .friction = 0}});
    BodyDef body = weightless();
    body.restitution = 1;
    EmitterDef one = single(kind_of(world, driven(), body), {.drag = {1.5}});
    one.rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, -1.5707963267948966);
    one.position = {0, 2, 0};
    const EmitterId id = added(world, one);
    while (world.time() < 0.6 - dt / 4) EXPECT_TRUE(world.step(dt));
    return alive(world, id).at(0).position.y;
  };
  const double t = 0.6 - kBorn, v0 = std::sqrt(109.0);
  const double truth = v0 * (1 - std::exp(-1.5 * t)) / 1.5 - 2;
  const double coarse = std::abs(height(0.1) - truth), fine = std::abs(height(0.025) - truth);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, coarse / 64);
}

TEST(EmitterFlight, acts_beside_generators) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const EmitterId id = added(world, single(kind_of(world, driven(), weightless()), {.force_x = {0.001}}));
  ASSERT_TRUE(world.add_force({.law = ConstantForce{{0, 0.002, 0}}, .target = ForceTarget::everything()}));
  step_to(world, 1, 30);
  const double t = world.time() - kBorn;
  EXPECT_LT(length(alive(world, id).at(0).velocity - Vec3d{10 + t, 3 + 2 * t, 0}), 1e-12);
}

TEST(EmitterFlight, ends_with_its_emitter) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const EmitterId id = added(world, single(kind_of(world, driven(), weightless()), {.drag = {2}}));
  step_to(world, 0.5, 60);
  const ProjectileId particle = world.ids().front();
  ASSERT_TRUE(world.remove_emitter(id));
  const Vec3d before = world[particle].velocity();
  step_to(world, 1, 60);
  EXPECT_EQ(world[particle].velocity(), before);
}

TEST(EmitterFlight, ends_with_its_emitter_beside_others_and_generators) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const EmitterId id = added(world, single(kind_of(world, driven(), weightless()), {.drag = {2}}));
  const EmitterId other = added(world, single(kind_of(world, driven(), weightless()), {.drag = {2}}));
  ASSERT_TRUE(world.add_force({.law = ConstantForce{{0, 0, 0}}, .target = ForceTarget::everything()}));
  step_to(world, 0.5, 60);
  std::vector<ProjectileId> its(1), others(1);
  world.particles(id, {.id = its}), world.particles(other, {.id = others});
  ASSERT_TRUE(world.remove_emitter(id));
  const Vec3d before = world[its[0]].velocity();
  step_to(world, 1, 60);
  EXPECT_EQ(world[its[0]].velocity(), before);
  EXPECT_LT(length(world[others[0]].velocity()), 0.5 * length(before));
}

TEST(EmitterFlight, of_a_closed_form_is_refused) {
  World world;
  const KindId kind = kind_of(world, spark());
  const auto refused = world.add_emitter(single(kind, {.drag = {1}}));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "emitter.flight");
  EmitterDef def = single(kind_of(world, driven()), {.drag = {1}});
  def.gun = {.rounds_per_minute = 60, .tracer_every = 2, .tracer = kind};
  EXPECT_FALSE(world.add_emitter(def));
  EXPECT_TRUE(world.add_emitter(single(kind, {})));
}

TEST(EmitterFlight, is_not_felt_on_a_rung_that_knows_no_forces) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const EmitterId id = added(world, single(kind_of(world, driven(), weightless()), {.drag = {2}}));
  step_to(world, 0.5, 60);
  const ProjectileId particle = world.ids().front();
  ASSERT_TRUE(world[particle].set_fidelity(spark().fidelity));
  const Vec3d before = world[particle].velocity();
  step_to(world, 0.6, 60);
  EXPECT_EQ(alive(world, id).at(0).velocity, before);
  const auto notes = std::as_const(world)[particle].fidelity_in_use().notes;
  EXPECT_TRUE(std::ranges::any_of(notes, [](const auto& note) { return note.reason.starts_with("its emitter"); }));
  ASSERT_TRUE(world[particle].set_fidelity(driven().fidelity));
  step_to(world, 0.8, 60);
  EXPECT_LT(length(alive(world, id).at(0).velocity), length(before) * 0.9);
}

// ------------------------------------------------------------------------------------------- what worlds keep
World bouncing_world(unsigned threads) {
  WorldDef def{.ground = {.mode = GroundMode::bounce, .restitution = 0.5},
               .threading = {.threads = threads, .rows_per_thread = 16}};
  return make_world(def);
}
/// Particles of several rungs that bounce and are driven by everything.
void fill(World& world) {
  int i = 0;
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::tsit5, Integrator::classic}) {
    ProjectileDef p = driven(integrator);
    if (i % 2 == 0) p.fidelity.precision = Precision::float32;
    EmitterDef emitter = spray(kind_of(world, p), 120, 0.9);
    emitter.seed = static_cast<std::uint64_t>(i);
    emitter.position = {5.0 * i++, 0.5, 0};
    emitter.flight = everything();
    added(world, emitter);
  }
}
World busy_world(unsigned threads) {
  World world = bouncing_world(threads);
  fill(world);
  return world;
}

std::vector<std::uint64_t> hashes_of(World& world, int steps) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < steps; ++i) {
    EXPECT_TRUE(world.step(1.0 / 50));
    hashes.push_back(world.hash());
  }
  return hashes;
}

TEST(EmitterFlight, threads_and_kernels_change_no_bit) {
  World one = busy_world(1), three = busy_world(3);
  const auto hashes = hashes_of(one, 80);
  EXPECT_EQ(hashes, hashes_of(three, 80));
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    World world = busy_world(1);
    EXPECT_EQ(hashes, hashes_of(world, 80)) << kernel;
  }
  ASSERT_TRUE(use_kernel(""));
}

TEST(EmitterFlight, snapshots_saves_and_recordings_go_on_bit_for_bit) {
  World world = bouncing_world(1);
  std::vector<std::byte> bytes;
  ASSERT_TRUE(world.record([&](std::span<const std::byte> piece) -> Status {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return {};
  }));
  fill(world);
  hashes_of(world, 40);
  const Snapshot snapshot = world.snapshot();
  auto loaded = reloaded(world);
  const auto hashes = hashes_of(world, 40);
  EXPECT_EQ(hashes, hashes_of(loaded, 40));
  ASSERT_TRUE(world.restore(snapshot));
  EXPECT_EQ(hashes, hashes_of(world, 40));
  replayed(world, bytes);
}

TEST(EmitterFlight, predictions_go_where_the_world_does) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  EmitterDef def = spray(kind_of(world, driven()), 60, 5);
  def.flight = everything();
  added(world, def);
  step_to(world, 0.5, 64);
  const auto ids = world.ids();
  ASSERT_GT(ids.size(), 20u);
  std::vector<Flight> flights;
  for (const ProjectileId id : ids) flights.push_back(world.predict(id, 2, 1.0 / 64));
  step_to(world, 1.5, 64);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(flights[i].at(1).position, world[ids[i]].position()) << i;
}

}  // namespace physim::world_emitter_flight_test
