// Prints four hashes: over elementary functions, flights and worlds, over what meets things, over studies, and over
// emitters. Every compiler, optimisation and instruction set must print the same: `./dev determinism` builds and runs
// this with all of them. `physim_golden upward` calls the library from a thread that rounds upwards, `physim_golden
// flush` from one that takes subnormal numbers for zero.
#include <array>
#include <cfenv>
#include <cinttypes>
#include <cstdio>
#include <string>

#include "math/elementary.hpp"
#include "random_shots.hpp"
#include "scenes.hpp"
#include "world.hpp"

namespace physim::test {
namespace {

/// What this version of the library must print. A change of the physics or the numerics changes it: say so in the
/// commit.
using Sums = std::array<std::uint64_t, 5>;
constexpr Sums kExpectedSums = {0x2b584708ee1e1267, 0xcb627ab80280aca6, 0x71ae1fc08213a0c9, 0x9b3d264e278b6a50,
                                0xe7fcee5f922a58a6};

void print(std::FILE* file, const Sums& sums) {
  for (std::size_t i = 0; i < sums.size(); ++i)
    std::fprintf(file, "%016" PRIx64 "%s", sums[i], i + 1 < sums.size() ? " " : "\n");
}

/// FNV-1a over the bits of numbers; all NaNs count as one, since their bits are nobody's promise.
class Hash {
 public:
  void add_bits(std::uint64_t bits) {
    for (int i = 0; i < 8; ++i) value_ = (value_ ^ ((bits >> (8 * i)) & 0xff)) * 0x100000001b3u;
  }
  void add(double x) { add_bits(x != x ? 0x7ff8000000000000u : to_bits(x)); }
  void add(const Vec3d& v) { add(v.x), add(v.y), add(v.z); }
  void add(const Event& e) {
    add_bits(static_cast<std::uint64_t>(e.kind) * 8 + static_cast<std::uint64_t>(e.direction));
    add(e.value), add(e.time), add(e.position), add(e.velocity);
  }
  void add(const FlightCost& c) {
    add_bits(static_cast<std::uint64_t>(c.steps));
    add_bits(static_cast<std::uint64_t>(c.rejected));
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

// ---------------------------------------------------------------------------------------------- elementary functions
/// All functions of a number or a pack, each lane added to a hash of its own.
template <class R>
void add_functions(Hash* lanes, const R& x, const R& y) {
  const R results[] = {exp(x), expm1(x), log(abs(x)), log1p(x), pow(abs(x), y), sin(x),  cos(x),
                       tan(x), asin(x),  acos(x),     atan(x),  atan2(x, y),    sqrt(x), floor_small(x)};
  for (const R& result : results)
    for (int lane = 0; lane < kLanes<R>; ++lane) lanes[lane].add(static_cast<double>(lane_of(result, lane)));
}

/// Values of every size, both signs, dense around the ordinary ones.
template <class S>
S grid_value(Random& r) {
  const double u = r.in(-1, 1);
  switch (r.below(4)) {
    case 0: return static_cast<S>(u);
    case 1: return static_cast<S>(u * 20);
    case 2: return static_cast<S>(u * 1000);
    default: return static_cast<S>(u * u * u * u * u * u * u * u * 1e-3);
  }
}

template <class R>
bool add_elementary(Hash& hash, int count) {
  using S = ScalarOf<R>;
  Random r(7);
  Hash pack[kLanes<R>], expected[kLanes<R>];
  for (int i = 0; i < count; ++i) {
    R x(S(0)), y(S(0));
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      const S a = grid_value<S>(r), b = grid_value<S>(r);
      set_lane(x, lane, a);
      set_lane(y, lane, b);
      add_functions(&expected[lane], a, b);
    }
    add_functions(pack, x, y);
  }
  bool same = true;
  for (int lane = 0; lane < kLanes<R>; ++lane) {
    same = same && pack[lane].value() == expected[lane].value();
    hash.add_bits(pack[lane].value());
  }
  if (!same) std::fprintf(stderr, "golden: packs and numbers give different elementary functions\n");
  return same;
}

// ----------------------------------------------------------------------------------------------------------- flights
struct Course {
  Environment environment;
  Fidelity fidelity;
  Until until;
  Tolerance tolerance;
  std::vector<Shot> shots;
};

Course course(std::uint64_t seed, Integrator integrator, Precision precision) {
  Random r(seed);
  Course c{random_environment(r), random_fidelity(r), random_until(r), {}, {}};
  c.fidelity.integrator = integrator;
  c.fidelity.precision = precision;
  const double relative = precision == Precision::float32 ? 1e-4 : 1e-7;
  c.tolerance = {.relative = relative, .absolute = relative, .step = r.in(0.05, 0.2), .max_steps = 2000};
  c.shots = random_shots(r, 8);
  return c;
}

double part_of(double whole, double part) {
  const IeeeMode mode;
  return part * whole;
}

void add_flight(Hash& hash, const Flight& flight) {
  hash.add_bits(static_cast<std::uint64_t>(flight.outcome()));
  hash.add(flight.duration());
  hash.add(flight.cost());
  for (const Event& e : flight.events()) hash.add(e);
  for (const double part : {0.0, 0.3, 0.7, 1.0}) {
    const Sample s = flight.at(part_of(flight.duration(), part));
    for (const Vec3d& v : {s.position, s.velocity, s.acceleration}) hash.add(v);
    for (const double x : {s.mach, s.energy, s.range, s.drop, s.windage}) hash.add(x);
    if (!turns(flight.fidelity_in_use().fidelity)) continue;
    for (const double x : {s.orientation.w, s.orientation.x, s.orientation.y, s.orientation.z, s.angle_of_attack})
      hash.add(x);
    hash.add(s.angular_velocity);
  }
}

void add_batch(Hash& hash, const BatchResult& batch) {
  for (std::size_t i = 0; i < batch.shots.size(); ++i) {
    const ShotResult& s = batch.shots[i];
    const ShotAttitude a = batch.attitudes.empty() ? ShotAttitude{} : batch.attitudes[i];
    hash.add_bits(static_cast<std::uint64_t>(s.outcome));
    hash.add(s.time), hash.add(s.position), hash.add(s.velocity), hash.add(s.cost);
    for (const double x : {a.orientation.w, a.orientation.x, a.orientation.y, a.orientation.z}) hash.add(x);
    hash.add(a.angular_velocity);
  }
  for (const ShotEvent& e : batch.events) {
    hash.add_bits(e.shot);
    hash.add(e.event);
  }
}

/// Over the Earths that turn, under every gravity there is.
Course round_course(std::uint64_t seed, Integrator integrator, Precision precision) {
  Course c = course(seed, integrator, precision);
  Random r(seed + 1000);
  c.environment.gravity = {};
  c.environment.earth.longitude = r.in(-3, 3);
  c.fidelity.motion = Motion::force;
  c.fidelity.earth = r.one_in(3) ? EarthModel::sphere_rotating : EarthModel::ellipsoid;
  c.fidelity.gravity = static_cast<GravityModel>(1 + r.below(4));
  return c;
}

/// Rockets among other shots, from rails.
Course rocket_course(std::uint64_t seed, Integrator integrator, Precision precision) {
  Course c = course(seed, integrator, precision);
  Random r(seed + 2000);
  c.fidelity.motion = Motion::force;
  for (Shot& shot : c.shots) {
    if (r.one_in(4)) continue;
    MotorDef& motor = shot.projectile.motor;
    double time = 0;
    for (int i = 0, n = 2 + r.below(5); i <= n; ++i, time += r.in(0.01, 0.6))
      motor.thrust.push_back({time, i == n ? 0 : r.in(5, 200) * shot.projectile.mass});
    motor.propellant_mass = r.in(0, 0.6) * shot.projectile.mass;
    if (r.one_in(2)) motor.ignition_delay = r.in(0, 0.3);
    motor.drag_factor = r.in(0.5, 1);
    shot.launch.rail_length = r.in(0.1, 5);
    if (!shot.launch.velocity && r.one_in(2)) shot.launch.speed = 0;
  }
  return c;
}

/// Rigid bodies of both forms, with and without coefficients.
Course rigid_course(std::uint64_t seed, Integrator integrator, Precision precision) {
  Course c = round_course(seed, integrator, precision);
  Random r(seed + 2000);
  c.fidelity.rotation = RotationModel::rigid_body;
  c.fidelity.planar = false;
  c.tolerance.step = r.in(0.002, 0.01);
  c.until.time = 0.3;
  for (Shot& shot : c.shots) {
    ProjectileDef& p = shot.projectile;
    const double across = 0.06 * p.mass * p.length * p.length, along = 0.12 * p.mass * p.diameter * p.diameter;
    p.inertia.moments = {std::min(along, 1.9 * across), across, r.one_in(3) ? 1.01 * across : across};
    if (r.one_in(3)) p.twist = 0;
    shot.launch.attitude = {.yaw = r.in(-0.1, 0.1), .pitch = r.in(-0.1, 0.1), .rates = r.vector(3)};
    if (r.one_in(4)) continue;
    p.aero.lift = {{0, 0, r.in(1, 2)}, {1, 0, r.in(1, 2)}, {2.3, 0, 2.5}};
    p.aero.pitching = {{0.7, 0, r.in(-3, 4)}, {1.1, 0, 3}};
    p.aero.pitch_damping = {{0, 0, r.in(-8, -2)}};
    p.aero.roll_damping = {{0, 0, -0.01}};
    if (r.one_in(2)) p.aero.magnus_moment = {{0, 0, -1}, {0, 0.01, 0.1}, {1.5, 0, -0.3}, {1.5, 0.02, 0.2}};
  }
  return c;
}

/// Shells in their yaw of repose; some with motors.
Course shell_course(std::uint64_t seed, Integrator integrator, Precision precision) {
  Course c = rigid_course(seed, integrator, precision);
  const Course rockets = rocket_course(seed, integrator, precision);
  c.fidelity.rotation = RotationModel::modified_point_mass;
  c.fidelity.drag = DragModel::equation;
  c.fidelity.air = AirModel::isa;
  for (std::size_t i = 0; i < c.shots.size(); ++i) {
    ProjectileDef& p = c.shots[i].projectile;
    p.inertia.moments.z = p.inertia.moments.y;
    if (seed % 2 == 0) p.motor = rockets.shots[i].projectile.motor;
  }
  return c;
}

std::vector<Course> courses() {
  std::vector<Course> list;
  std::uint64_t seed = 100;
  for (int integrator = 0; integrator <= static_cast<int>(Integrator::dop853); ++integrator)
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (int i = 0; i < 24; ++i) list.push_back(course(++seed, static_cast<Integrator>(integrator), precision));
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853})
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (int i = 0; i < 8; ++i) list.push_back(round_course(++seed, integrator, precision));
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853})
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (int i = 0; i < 4; ++i) list.push_back(rocket_course(++seed, integrator, precision));
  for (int integrator = 1; integrator <= static_cast<int>(Integrator::dop853); ++integrator)
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (int i = 0; i < 4; ++i) list.push_back(rigid_course(++seed, static_cast<Integrator>(integrator), precision));
  for (int integrator = 1; integrator <= static_cast<int>(Integrator::dop853); ++integrator)
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (int i = 0; i < 4; ++i) list.push_back(shell_course(++seed, static_cast<Integrator>(integrator), precision));
  return list;
}

/// A zero, a pilot step and the air of a station: whatever prepares flights.
void add_preparations(Hash& hash) {
  Random r(3);
  for (int i = 0; i < 4; ++i) {
    Environment e = random_environment(r);
    e.atmosphere.model = AirModel::isa;
    for (const double z : {0.0, 9000.0, 15000.0, 50000.0}) {
      const auto air = air_at(e, z);
      for (const double x : {air->temperature, air->pressure, air->density, air->sound_speed, air->viscosity})
        hash.add(x);
    }
    ProjectileDef p = random_projectile(r);
    const Launch launch{.speed = r.in(200, 900),
                        .sight = {.height = 0.05, .look_angle = r.in(-0.3, 0.3), .zero_range = 150}};
    Fidelity f = Fidelity::small_arms();
    const Flight zeroed = fly(p, launch, e, f, {1e-8, 1e-8}, {.ground = {}, .time = 1});
    hash.add(zeroed.elevation());
    add_flight(hash, zeroed);
    f.integrator = Integrator::rk4;
    hash.add(fly(p, {.speed = 300, .elevation = 0.1}, e, f, {}, {.ground = {}, .time = 1}).step());
  }
}

/// Coordinates and frames.
void add_places(Hash& hash) {
  Random r(8);
  for (int i = 0; i < 100; ++i) {
    Environment e;
    e.altitude = r.in(-1000, 1e6);
    e.earth = {.latitude = r.in(-1.57, 1.57), .longitude = r.in(-3.1, 3.1), .azimuth = r.in(-3, 3)};
    const EarthFrames frames(e, static_cast<EarthModel>(r.below(5)));
    const Vec3d x = r.vector(1e6), v = r.vector(8000);
    const Geodetic g = frames.geodetic(x);
    const FrameState inertial = frames.inertial(x, v, r.in(0, 1e5));
    for (const double number : {g.latitude, g.longitude, g.height}) hash.add(number);
    for (const Vec3d& vector : {inertial.position, inertial.velocity, frames.local(x, v), frames.position(g),
                                normal_gravity(g), earth_fixed_from_geodetic(g)})
      hash.add(vector);
  }
}

bool add_flights(Hash& hash, const std::vector<Course>& all) {
  for (const Course& c : all)
    for (const Shot& shot : c.shots)
      add_flight(hash, fly(shot.projectile, shot.launch, c.environment, c.fidelity, c.tolerance, c.until));
  bool same = true;
  std::uint64_t first = 0;
  for (const std::string& kernel : kernels()) {
    use_kernel(kernel);
    Hash batches;
    for (const Course& c : all) add_batch(batches, fly_batch(c.shots, c.environment, c.fidelity, c.tolerance, c.until));
    if (first == 0) hash.add_bits(batches.value());
    if (first == 0) first = batches.value();
    if (batches.value() == first) continue;
    std::fprintf(stderr, "golden: kernel %s gives other bits than the first\n", kernel.c_str());
    same = false;
  }
  return same;
}

/// The mode that the library is called in; false where there is none of that name.
bool set_mode(const std::string& mode) {
  if (mode == "upward") return std::fesetround(FE_UPWARD) == 0;
#if defined(__SSE2__)
  if (mode == "flush") return _mm_setcsr(_mm_getcsr() | 0x8040), true;  // flush to zero, denormals are zero
#endif
  return mode.empty();
}

int run(const std::string& mode) {
  Hash hash;
  bool good = true;
  std::vector<Course> all;
  {
    const IeeeMode strict;  // what is computed here and not in the library, of a program that may be linked for speed
    good = add_elementary<Pack<double, 8>>(hash, 250);
    good = add_elementary<Pack<float, 16>>(hash, 125) && good;
    all = courses();
  }
  if (!set_mode(mode)) return 2;
  add_preparations(hash);
  add_places(hash);
  good = add_flights(hash, all) && good;
  std::uint64_t worlds = 0;
  good = add_worlds(worlds) && good;
  hash.add_bits(worlds);
  Sums sums{hash.value(), 0, 0, 0, 0};
  good = add_scenes(sums[1]) && good;
  good = add_studies(sums[2]) && good;
  good = add_emitters(sums[3]) && good;
  good = add_joints(sums[4]) && good;
  print(stdout, sums);
  if (sums != kExpectedSums) {
    std::fprintf(stderr, "golden: this was expected: ");
    print(stderr, kExpectedSums);
    good = false;
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) { return physim::test::run(argc > 1 ? argv[1] : ""); }
