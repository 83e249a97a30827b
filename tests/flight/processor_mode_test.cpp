// Every public call that computes does so in a mode of its own (base/ieee_mode.hpp), whatever the caller's thread is
// set to: flush-to-zero, another rounding, traps.
#include "processor_mode.hpp"

#include "support.hpp"

namespace physim::flight_processor_mode_test {

using test::Bits;

struct Shots {
  ProjectileDef bullet = test::bullet_308();
  Launch launch{.position = {0, 1.5, 1e-310}, .speed = 800, .elevation = 0.01, .azimuth = 0.3};
  /// Flies along x: its distance to the side stays a subnormal number.
  Launch straight{.position = {0, 1.5, 1e-310}, .speed = 100};
  Environment windy{.altitude = 120, .wind = {.velocity = {1, 0, -4}}, .earth = {.latitude = 0.8}};
  Tolerance step{.step = 0.01};
  Until until{.ground = 0.0, .time = 3, .range = 700};

  Shots() {
    windy.atmosphere.temperature = 291.3;
    windy.atmosphere.humidity = 0.4;
  }
  [[nodiscard]] Fidelity rung(Integrator integrator, Precision precision) const {
    Fidelity f = Fidelity::simulation();
    f.integrator = integrator;
    f.precision = precision;
    return f;
  }
  [[nodiscard]] ProjectileDef shell() const {
    ProjectileDef p = bullet;
    p.inertia.moments = {1e-7, 8e-7, 8e-7};
    p.aero.lift = {{0, 0, 2}};
    p.aero.pitching = {{0, 0, 2.5}};
    p.aero.pitch_damping = {{0, 0, -6}};
    return p;
  }
};

void add(Bits& bits, const BatchResult& batch) {
  for (const ShotResult& s : batch.shots) bits << s.time << s.position << s.velocity;
  for (const ShotEvent& e : batch.events) bits << e.event.time << e.event.position;
}

TEST(ProcessorMode, OfTheCallerChangesNoFlight) {
  const Shots s;
  std::vector<test::Door> doors;
  for (const Integrator integrator : test::kIntegrators)
    for (const Precision precision : {Precision::float32, Precision::float64})
      doors.push_back({"fly with " + test::text(integrator), [&, f = s.rung(integrator, precision)](Bits& bits) {
                         bits << fly(s.bullet, s.launch, s.windy, f, s.step, s.until);
                       }});
  doors.push_back({"fly by a pilot", [&](Bits& bits) {
                     bits << fly(s.bullet, s.launch, s.windy, s.rung(Integrator::rk4, Precision::float64), {}, s.until);
                   }});
  doors.push_back({"fly at its own fidelity", [&](Bits& bits) { bits << fly(s.bullet, s.straight); }});
  Fidelity rigid = s.rung(Integrator::dop853, Precision::float64);
  rigid.rotation = RotationModel::rigid_body;
  const Flight flight = fly(s.shell(), s.launch, s.windy, rigid, {}, s.until);
  doors.push_back(
      {"fly a rigid body", [&](Bits& bits) { bits << fly(s.shell(), s.launch, s.windy, rigid, {}, s.until); }});
  doors.push_back({"what a flight answers", [&](Bits& bits) {
                     const Accelerations a = flight.accelerations(0.3);
                     bits << flight.at(0.217) << *flight.at_range(412.3) << *flight.at_height(3.0) << flight.end();
                     bits << a.total << a.drag << a.body << a.gravity;
                     for (const double& time : flight.step_times()) bits << time;
                     if (const auto stability = flight.stability(0.5)) bits << stability->gyroscopic;
                     const Geodetic place = flight.earth_frames().geodetic(flight.end().position);
                     bits << place.latitude << place.longitude << place.height;
                   }});
  doors.push_back({"zero_elevation, pilot_step", [&](Bits& bits) {
                     const Fidelity f = Fidelity::small_arms();
                     bits << *zero_elevation(s.bullet, s.launch, s.windy, f, 300);
                     bits << *pilot_step(s.bullet, s.launch, s.windy, s.rung(Integrator::heun, Precision::float64), {},
                                         s.until);
                   }});
  test::expect_own_mode(doors);
}

TEST(ProcessorMode, OfTheCallerChangesNoBatch) {
  const Shots s;
  std::vector<Shot> shots(23, {s.bullet, s.launch});
  std::vector<Launch> launches(23, s.launch);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    shots[i].launch.elevation = launches[i].elevation = 0.003 * static_cast<double>(i);
    shots[i].projectile.mass += 1e-4 * static_cast<double>(i);
  }
  std::vector<test::Door> doors;
  for (const Integrator integrator : test::kIntegrators)
    for (const Precision precision : {Precision::float32, Precision::float64})
      doors.push_back({"fly_batch with " + test::text(integrator), [&, f = s.rung(integrator, precision)](Bits& bits) {
                         add(bits, fly_batch(shots, s.windy, f, s.step, s.until));
                         add(bits, fly_batch(s.bullet, launches, s.windy, f, s.step, s.until));
                       }});
  doors.push_back({"fly_batch beside the axis", [&](Bits& bits) {
                     const std::vector<Launch> straight(9, s.straight);
                     add(bits, fly_batch(s.bullet, straight, {}, Fidelity::small_arms()));
                   }});
  test::expect_own_mode(doors);
}

TEST(ProcessorMode, OfTheCallerChangesNoAnswerBackwards) {
  const Shots s;
  const Target target{.position = {600, 20, 30}, .velocity = {-3, 0, 4}, .acceleration = {0.1, 0, 0.3}};
  const std::vector<Measurement> measured = {{.range = 200, .speed = 680}, {.range = 400, .speed = 575}};
  const std::vector<FlightSetting> settings = {{Fidelity::game(), s.step}, {Fidelity::small_arms(), {}}};
  const Purpose purpose{.error = 0.05, .time = 0.6, .ground = 0.0};
  AutoFidelityCache cache;
  test::expect_own_mode({
      {"Target", [&](Bits& bits) { bits << target.at(0.37) << target.velocity_at(0.37); }},
      {"aim",
       [&](Bits& bits) {
         const auto answer = aim(s.bullet, s.launch, s.windy, Fidelity::small_arms(), target, {.arc = Arc::low});
         bits << answer->nearest.launch.elevation << answer->nearest.miss << answer->nearest.position;
         bits << answer->explanation();
       }},
      {"max_range, time_to_range, danger_space",
       [&](Bits& bits) {
         const auto most = max_range(s.bullet, s.launch, s.windy, Fidelity::constant_air());
         bits << most->elevation << most->range << most->velocity;
         bits << *time_to_range(s.bullet, s.launch, s.windy, Fidelity::small_arms(), 333);
         const auto space = danger_space(fly(s.bullet, s.launch, s.windy, Fidelity::small_arms()), 300, 0.5);
         bits << space->from << space->to;
       }},
      {"fit_drag",
       [&](Bits& bits) {
         const auto fit = fit_drag(s.bullet, s.launch, s.windy, Fidelity::small_arms(), measured);
         bits << fit->scale << fit->rms;
       }},
      {"compare",
       [&](Bits& bits) {
         const auto all = compare(s.bullet, s.launch, s.windy, settings, {Fidelity::reference(), {}}, s.until);
         for (const ComparedFlight& f : all->flights) bits << f.largest_distance << f.end_distance << f.end_delay;
       }},
      {"cheapest_within, fly_chosen, fly_within",
       [&](Bits& bits) {
         const auto chosen = cheapest_within(s.bullet, s.launch, s.windy, purpose);
         bits << chosen->error << chosen->cost << chosen->truth_error << chosen->explanation();
         bits << chosen->note().reason << chosen->tolerance().step;
         bits << fly_chosen(s.bullet, s.launch, s.windy, *chosen);
         bits << fly_within(s.bullet, s.launch, s.windy, purpose);
       }},
      {"AutoFidelityCache, launch_class",
       [&](Bits& bits) {
         cache.clear();
         bits << (*cache.cheapest_within(s.bullet, s.launch, s.windy, purpose))->error;
         for (const Launch& launch : launch_class(s.launch, 0.0)) bits << launch.speed << launch.elevation;
       }},
  });
}

TEST(ProcessorMode, OfTheCallerChangesNoPlaceNorAir) {
  const Shots s;
  const Geodetic place{0.7, 1.2, 345.6};
  const Vec3d x{4.1e6, 2.3e6, 4.3e6}, v{300, -20, 1e-310};
  const Quatd q = quat_from_yaw_pitch_roll(0.1, 0.2, 0.3);
  const MotorDef motor{.thrust = {{0, 3}, {0.7, 11}, {1.9, 0}}, .propellant_mass = 0.013};
  test::expect_own_mode({
      {"geodesy",
       [&](Bits& bits) {
         const Geodetic back = geodetic_from_earth_fixed(x);
         bits << earth_fixed_from_geodetic(place) << back.latitude << back.longitude << back.height;
         bits << inertial_from_earth_fixed(v, 0.4) << earth_fixed_from_inertial(v, 0.4);
         bits << local_from_earth_fixed(v, place) << earth_fixed_from_local(v, place) << normal_gravity(place);
       }},
      {"EarthFrames",
       [&](Bits& bits) {
         const EarthFrames frames(s.windy, EarthModel::ellipsoid);
         const Vec3d position{1000, 200, -300};
         const Geodetic g = frames.geodetic(position);
         const YawPitchRoll a = frames.yaw_pitch_roll(position, q);
         bits << g.latitude << g.longitude << g.height << a.yaw << a.pitch << a.roll << frames.rotation_rate();
         for (const FrameState& state : {frames.earth_fixed(position, v), frames.inertial(position, v, 7.7),
                                         frames.from_earth_fixed({x, v}), frames.from_inertial({x, v}, 7.7)})
           bits << state.position << state.velocity;
         bits << frames.local(position, v) << frames.position(place) << frames.from_local(position, v);
       }},
      {"air",
       [&](Bits& bits) {
         const auto air = air_at(s.windy, 1234.5);
         bits << air->density << air->sound_speed << air->viscosity << air->temperature << air->pressure;
         bits << moist_air_density(293.3, 98765.4, 0.3) << moist_air_sound_speed(293.3, 98765.4, 0.3);
         bits << drag_coefficient(s.bullet.drag, Interpolation::cubic, 1.234) << sphere_drag_coefficient(54321.0);
       }},
      {"motor",
       [&](Bits& bits) {
         bits << total_impulse(motor) << specific_impulse(motor) << thrust_at(motor, 0.333);
         bits << propellant_left(motor, 0.777);
       }},
      {"quaternions by angles",
       [&](Bits& bits) { bits << quat_from_yaw_pitch_roll(0.1, 0.2, 0.3) << quat_from_axis_angle(v, 0.7); }},
      {"presets",
       [&](Bits& bits) {
         for (const std::string_view name : projectile_presets()) {
           const auto preset = projectile_preset(name);
           bits << preset->projectile.diameter << preset->body.gravity_scale << preset->projectile.magnus.drag_per_spin;
           for (const MagnusPoint& p : preset->projectile.magnus.table) bits << p.spin << p.drag << p.lift;
         }
       }},
  });
}

}  // namespace physim::flight_processor_mode_test
