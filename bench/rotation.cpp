// Rotation in packs: NASA's check-cases in six degrees of freedom, and a shell as a point mass, as a modified one and
// as a rigid body.
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

/// The 105 mm shell M1 (R. L. McCoy, Modern Exterior Ballistics (1999), ch. 9), its tables shortened.
Entry shell(const char* name, RotationModel rotation, const std::string& kernel) {
  Entry e{.name = name, .kernel = kernel};
  ProjectileDef& p = e.shot.projectile;
  p.mass = 14.97;
  p.diameter = 0.1048;
  p.twist = 18 * 0.1048;
  p.inertia.moments = {0.02326, 0.23118, 0.23118};
  p.drag.table = DragTable::g1;
  p.drag.form_factor = 0.9;
  p.aero.drag_yaw = {{0.88, 0, 3.2}, {0.97, 0, 6.3}, {1.25, 0, 5.4}};
  p.aero.lift = {{0.4, 0, 1.63}, {0.89, 0, 1.22}, {1.09, 0, 1.57}, {2, 0, 2.25}};
  p.aero.pitching = {{0.46, 0, 3.55}, {0.87, 0, 3.96}, {1.09, 0, 3.83}};
  p.aero.pitch_damping = {{0.79, 0, -3.15}, {1.15, 0, -9.1}};
  p.aero.roll_damping = {{0, 0, -0.0178}, {0.7, 0, -0.0135}, {1.4, 0, -0.011}};
  p.aero.magnus_force = {{0, 0, -0.34}};
  e.shot.launch = {.speed = 493, .elevation = 1};
  e.fidelity = Fidelity::simulation();
  e.fidelity.integrator = Integrator::rk4;
  e.fidelity.rotation = rotation;
  return e;
}

}  // namespace

Section rotation_section(const Options& options) {
  const std::size_t count = options.quick ? 64 : 256;
  std::vector<Entry> entries;
  for (const std::string& kernel : {kernels().front(), std::string("scalar")}) {
    for (const auto make : {nasa_sphere, nasa_wind, nasa_brick}) entries.push_back(make(kernel));
    entries.push_back(shell("105 mm shell M1, point mass", RotationModel::none, kernel));
    entries.push_back(shell("the same, modified point mass", RotationModel::modified_point_mass, kernel));
    entries.push_back(shell("the same, rigid body", RotationModel::rigid_body, kernel));
  }
  std::vector<std::function<void()>> turns;
  for (Entry& e : entries) {
    for (const ShotResult& shot : e.fly(count).shots) e.steps += static_cast<double>(shot.cost.steps);
    turns.emplace_back([&e, count] { static_cast<void>(e.fly(count)); });
  }
  const auto taken = take_turns(options.clock, options.quick ? 3 : 7, turns);
  Section s;
  s.title = "Rotation";
  s.intro =
      "Whole flights of 30 s in batches, RK4 at 0.01 s in double, one thread; a step evaluates all models four times. "
      "A "
      "spinning shell needs shorter steps than these as a rigid body, and far longer ones as a modified point mass.";
  s.columns = {"case", "kernel", "steps/s", "ns a step", "times real time"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double seconds = median(taken[i]);
    s.rows.push_back({entries[i].name, entries[i].kernel, rate(entries[i].steps / seconds),
                      fixed(1e9 * seconds / entries[i].steps, 1), rate(entries[i].steps * kStep / seconds)});
  }
  return s;
}

}  // namespace physim::bench
