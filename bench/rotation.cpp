// Six degrees of freedom in packs: NASA's check-cases, and a spinning shell with tables.
#include "sections.hpp"

namespace physim::bench {
namespace {

constexpr double kFoot = 0.3048, kSlug = 14.5939029372;
constexpr double kStep = 0.01;  // [s]

struct Entry {
  const char* name;
  std::string kernel;
  Shot shot;
  Environment place;
  Fidelity fidelity;
  double steps = 0;

  /// Each shot a little different, so that no lane repeats another.
  BatchResult fly(std::size_t count) const {
    std::vector<Shot> shots(count, shot);
    for (std::size_t i = 0; i < count; ++i) shots[i].launch.attitude.rates.x += 1e-3 * static_cast<double>(i);
    use_kernel(kernel);
    BatchResult result = fly_batch(shots, place, fidelity, {.step = kStep}, {.ground = {}, .time = 30});
    use_kernel("");
    return result;
  }
};

/// Case 6: a sphere with drag, in standard air over the turning ellipsoid with J2.
Entry nasa_sphere(const std::string& kernel) {
  Entry e{.name = "NASA case 6, sphere: WGS-84 with J2, standard air", .kernel = kernel};
  e.shot.projectile.mass = kSlug;
  e.shot.projectile.diameter = 0.5 * kFoot;
  e.shot.projectile.drag.coefficient = 0.1;
  e.shot.projectile.inertia.moments = Vec3d{3.6, 3.6, 3.6} * (kSlug * kFoot * kFoot);
  e.shot.launch.velocity = Vec3d{};
  e.shot.launch.attitude = {.frame = AttitudeFrame::world, .rate_frame = RateFrame::inertial};
  e.place.altitude = 30000 * kFoot;
  e.fidelity = {.integrator = Integrator::rk4,
                .gravity = GravityModel::j2,
                .earth = EarthModel::ellipsoid,
                .rotation = RotationModel::rigid_body};
  return e;
}

Entry nasa_wind(const std::string& kernel) {
  Entry e = nasa_sphere(kernel);
  e.name = "NASA case 8, the same in wind that changes with height";
  e.place.wind.profile = {{-30000 * kFoot, {0, 0, -20 * kFoot}}, {0, {0, 0, 70 * kFoot}}};
  return e;
}

Entry nasa_brick(const std::string& kernel) {
  Entry e = nasa_sphere(kernel);
  e.name = "NASA case 3, brick damped by the air";
  ProjectileDef& p = e.shot.projectile;
  p.mass = 0.155404754 * kSlug;
  p.inertia.moments = Vec3d{0.001894220, 0.007194665, 0.006211019} * (kSlug * kFoot * kFoot);
  p.aero = {.area = 0.22222 * kFoot * kFoot, .length = 0.66667 * kFoot, .span = 0.33333 * kFoot};
  p.aero.rate_norm = RateNorm::twice_speed;
  p.aero.roll_damping = p.aero.pitch_damping = p.aero.yaw_damping = {{0, 0, -1}};
  e.shot.launch.attitude.rates = {0.17, -0.5, 0.35};
  return e;
}

}  // namespace

Section rotation_section(const Options& options) {
  const std::size_t count = options.quick ? 64 : 256;
  std::vector<Entry> entries;
  for (const std::string& kernel : {kernels().front(), std::string("scalar")})
    for (const auto make : {nasa_sphere, nasa_wind, nasa_brick}) entries.push_back(make(kernel));
  std::vector<std::function<void()>> turns;
  for (Entry& e : entries) {
    for (const ShotResult& shot : e.fly(count).shots) e.steps += static_cast<double>(shot.cost.steps);
    turns.emplace_back([&e, count] { static_cast<void>(e.fly(count)); });
  }
  const auto taken = take_turns(options.clock, options.quick ? 3 : 7, turns);
  Section s;
  s.title = "Six degrees of freedom";
  s.intro =
      "Whole flights of 30 s in batches, RK4 at 0.01 s in double, one thread; a step evaluates all models four times.";
  s.columns = {"case", "kernel", "steps/s", "ns a step", "times real time"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double seconds = median(taken[i]);
    s.rows.push_back({entries[i].name, entries[i].kernel, rate(entries[i].steps / seconds),
                      fixed(1e9 * seconds / entries[i].steps, 1), rate(entries[i].steps * kStep / seconds)});
  }
  return s;
}

}  // namespace physim::bench
