// The right-hand side and its ledger: what Flight and World tell effect by effect adds up to what is flown, on every
// rung and under every constraint.
#include "flight/flight_record.hpp"
#include "random_shots.hpp"
#include "support.hpp"

namespace physim::model_acceleration_test {

using namespace test;

/// Of the entries, without the total.
Vec3d sum_of(const Accelerations& a) {
  return a.gravity + a.drag + a.lift + a.body + a.thrust + a.coriolis + a.centrifugal + a.applied + a.constraint;
}
double size_of(const Accelerations& a) {
  double size = 0;
  for (const Vec3d& entry : {a.gravity, a.drag, a.lift, a.body, a.thrust, a.coriolis, a.centrifugal, a.applied})
    size += length(entry);
  return size;
}

/// A finned body with a motor, an applied force and all aerodynamics, that also has a yaw of repose.
ProjectileDef everything() {
  return {.mass = 15,
          .diameter = 0.105,
          .twist = 1.9,
          .drag = {.coefficient = 0.15, .k1 = 0.1, .k2 = 0.01},
          .inertia = {.moments = {0.023, 0.23, 0.23}},
          .aero = {.drag_yaw = {{0, 0, 3.2}},
                   .lift = {{0, 0, 1.6}},
                   .pitching = {{0, 0, 3.5}},
                   .pitch_damping = {{0, 0, -3.2}},
                   .roll_damping = {{0, 0, -0.015}},
                   .magnus_force = {{0, 0, -0.6}}},
          .force = {3, -2, 5},
          .force_duration = 1.5,
          .motor = {.thrust = {{0, 900}, {0.4, 600}, {2, 0}}, .propellant_mass = 2}};
}

struct Case {
  const char* name;
  ProjectileDef projectile;
  Launch launch;
  Fidelity fidelity;
};

/// Point masses, balls that spin, shells in repose and rigid bodies; free, in a plane and on rails.
std::vector<Case> cases() {
  std::vector<Case> all;
  Fidelity f = Fidelity::simulation();
  f.earth = EarthModel::ellipsoid;
  f.gravity = GravityModel::wgs84;
  const Launch thrown{.position = {0, 5, 0}, .speed = 240, .elevation = 0.6, .azimuth = 0.3};
  Launch sliding = thrown;
  sliding.speed = 20;
  sliding.rail_length = 30;
  sliding.attitude.pitch = 0.05;
  const auto add = [&](const char* name, RotationModel rotation, BodyForm form, const Launch& launch) {
    f.rotation = rotation;
    f.body_form = form;
    all.push_back({name, everything(), launch, f});
  };
  add("point", RotationModel::none, {}, thrown);
  add("point on a rail", RotationModel::none, {}, sliding);
  add("repose", RotationModel::modified_point_mass, {}, thrown);
  add("repose on a rail", RotationModel::modified_point_mass, {}, sliding);
  add("axis", RotationModel::rigid_body, BodyForm::axis, thrown);
  add("axis on a rail", RotationModel::rigid_body, BodyForm::axis, sliding);
  add("quaternion", RotationModel::rigid_body, BodyForm::quaternion, thrown);
  add("quaternion on a rail", RotationModel::rigid_body, BodyForm::quaternion, sliding);
  for (std::size_t i = all.size() - 2; i < all.size(); ++i) {  // steps need not resolve a fast spin
    all[i].projectile.twist = 0;
    all[i].projectile.aero.pitching = {{0, 0, -3.5}};
  }
  f.rotation = RotationModel::none;
  f.planar = true;
  all.push_back({"planar", everything(), thrown, f});
  f.earth = EarthModel::flat_coriolis;
  all.push_back({"planar on a rail", everything(), sliding, f});
  f.planar = false;
  f.rotation = RotationModel::magnus;
  Launch struck{.speed = 70, .elevation = 0.2, .spin = {.backspin = 270}};
  all.push_back({"ball", presets::golf_ball().projectile, struck, f});
  f.planar = true;
  all.push_back({"planar ball", presets::golf_ball().projectile, struck, f});
  return all;
}

Environment windy() { return {.wind = {.velocity = {4, 1, -6}}, .earth = {.latitude = 0.7}}; }

/// Steps of order one are braked by drag: they fly the same acceleration, less of it. A rate of drag k and a step h
/// leave 1 / (1 + k h); `most` is an upper bound of k h.
testing::AssertionResult is_braked(const Vec3d& flown, const Vec3d& total, double most) {
  const double square = dot(total, total), part = square > 0 ? dot(flown, total) / square : 1;
  if (length(flown - total * part) > 1e-12 * length(total))
    return testing::AssertionFailure() << "the step is not along the sum of what acts";
  if (part <= 1 + 1e-12 && part >= 1 / (1 + most) - 1e-12) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the part that is left is " << part << ", with k h up to " << most;
}
/// What heun and rk4 take in full where they hold the drag: what pulls against the velocity through the air.
Vec3d taken_in_full(const Fidelity& f, const Accelerations& a) {
  const bool holds = f.integrator == Integrator::heun || f.integrator == Integrator::rk4;
  if (!holds || a.drag == Vec3d{}) return {};
  const Vec3d along = normalized(a.drag);  // against the velocity
  return along * std::max(0.0, dot(a.total - a.drag, along));
}
bool brakes(const Fidelity& f) {
  const bool is_fixed = f.integrator == Integrator::explicit_euler || f.integrator == Integrator::semi_implicit_euler ||
                        f.integrator == Integrator::heun || f.integrator == Integrator::rk4;
  return f.drag != DragModel::off && is_fixed;
}

/// At every step the ledger's total is the slope that was flown, to the bit, and its entries add up to it.
void expect_ledger_of(const FlightRecord& r) {
  ASSERT_NE(r.outcome, Outcome::refused) << r.error->text();
  const Fidelity& f = r.cohort.in_use.fidelity;
  const bool original = f.motion != Motion::closed_form && f.integrator == Integrator::classic;
  for (std::size_t i = 0; i < r.path.nodes.size() && r.path.nodes[i].t <= r.duration; ++i) {
    const bool jumps = i + 1 < r.path.nodes.size() && r.path.nodes[i + 1].t == r.path.nodes[i].t;
    const Accelerations a = r.accelerations_at(r.path.nodes[i].t);
    const double size = size_of(a);
    if (!std::isfinite(size)) continue;  // on its way to Outcome::non_finite
    if (original) {                      // what is summed here is felt in the next frame
      if (i + 1 < r.path.nodes.size() && r.path.nodes[i + 1].t <= r.duration) {
        const Vec3d damping = f.drag == DragModel::damping ? a.drag : Vec3d{};  // acts on the velocity by itself
        EXPECT_TRUE(near(sum_of(a) - damping, r.path.nodes[i + 1].a, 0, 1e-14 * size)) << i;
      }
      continue;
    }
    ASSERT_TRUE(near(sum_of(a), a.total, 0, 4e-15 * size)) << i;
    if (!jumps && f.motion != Motion::closed_form) {
      if (brakes(f)) {
        const Vec3d whole = taken_in_full(f, a);
        ASSERT_TRUE(is_braked(r.path.nodes[i].a - whole, a.total - whole, kInfinity)) << i;
      } else {
        ASSERT_TRUE(same_bits(a.total, r.path.nodes[i].a)) << i;
      }
    }
  }
}

TEST(Ledger, of_random_point_masses_adds_up_to_what_is_flown) {
  Random random(14);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const ProjectileDef p = random_projectile(random);
    const Launch launch = random_launch(random);
    const Environment e = random_environment(random);
    Fidelity f = random_fidelity(random);
    f.integrator = kIntegrators[random.below(8)];
    expect_ledger_of(*record_flight(p, launch, e, f, {.step = 0.05}, {.time = 2}));
  }
}

TEST(Ledger, of_rotations_and_constraints_adds_up_to_what_is_flown) {
  for (const Case& each : cases())
    for (const Integrator integrator : kIntegrators) {
      SCOPED_TRACE(std::string(each.name) + " " + text(integrator));
      Fidelity f = each.fidelity;
      f.integrator = integrator;
      expect_ledger_of(*record_flight(each.projectile, each.launch, windy(), f, {.step = 0.01}, {.time = 3}));
    }
}

TEST(Ledger, tells_what_constraints_take_up) {
  for (const Case& each : cases()) {
    SCOPED_TRACE(each.name);
    const Flight flight = fly(each.projectile, each.launch, windy(), each.fidelity, {}, {.time = 3});
    const Fidelity& f = flight.fidelity_in_use().fidelity;
    ASSERT_EQ(f.rotation, each.fidelity.rotation);
    const bool railed = each.launch.rail_length > 0;
    const Accelerations a = flight.accelerations(0.1);
    if (railed || f.planar) {
      EXPECT_GT(length(a.constraint), 0.05);
    } else {
      EXPECT_EQ(a.constraint, Vec3d());
    }
    if (railed) {
      const Vec3d bore = normalized(flight.at(0.1).velocity);
      EXPECT_LT(length(cross(a.total, bore)), 1e-12 * size_of(a));
      if (f.rotation == RotationModel::rigid_body) {
        EXPECT_GT(length(a.body), 0.005) << "it is taken up too";
      }
    }
  }
}

// ------------------------------------------------------------------------------------------- in worlds
/// The change of velocity in a step of semi-implicit Euler is what the world told before it, times the step.
void expect_step_by_ledger(World& world, ProjectileId id, const char* name) {
  constexpr double h = 1.0 / 128;
  for (int i = 0; i < 50; ++i) {  // up to the first corner of its thrust
    SCOPED_TRACE(std::string(name) + " " + std::to_string(i));
    const Accelerations a = world[id].accelerations();
    ASSERT_TRUE(near(sum_of(a), a.total, 0, 4e-15 * size_of(a)));
    EXPECT_EQ(world[id].resultant_force(), a.total * world[id].mass());
    const Vec3d before = world[id].velocity();
    world.step(h);
    ASSERT_TRUE(world[id].is_alive());
    const bool stops = !world.events().empty();  // ignition, or the end of the rail, within the step
    if (!stops) {
      const double rate = length(a.drag) / length(before - windy().wind.velocity);
      ASSERT_TRUE(is_braked((world[id].velocity() - before) * (1 / h), a.total, 1.01 * rate * h));
    }
  }
}

TEST(Ledger, of_a_world_is_what_its_steps_feel) {
  for (Case each : cases())
    for (const bool pushed : {false, true})
      for (const bool frozen : {false, true}) {
        World world = std::move(World::create({.environment = windy(), .ground = {.mode = GroundMode::none}}).value());
        each.projectile.fidelity = each.fidelity;
        each.projectile.fidelity.integrator = Integrator::semi_implicit_euler;
        BodyDef body;
        if (frozen) body.frozen = Axes::z;
        const ProjectileId id = world.spawn(each.projectile, each.launch, body).value();
        if (pushed) {
          ASSERT_TRUE(world[id].add_force(ConstantForce{{5, 20, -40}}));
        }
        expect_step_by_ledger(world, id, each.name);
      }
}

}  // namespace physim::model_acceleration_test
