#include "shots.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "physim/units.hpp"

namespace physim::bench {

using namespace physim::units;

namespace {

Shot bullet_308(double speed, double elevation) {
  Shot shot;
  shot.projectile.name = ".308 168 gr";
  shot.projectile.mass = 168_gr;
  shot.projectile.diameter = 7.82_mm;
  shot.projectile.drag.table = DragTable::g7;
  shot.projectile.drag.ballistic_coefficient = 0.218_lb_in2;
  shot.launch.speed = speed;
  shot.launch.elevation = elevation;
  return shot;
}

void add_308(ShotSet& set, double speed, double elevation) {
  set.shots.push_back(bullet_308(speed, elevation));
  set.launches.push_back(set.shots.back().launch);
  set.peer_shots.push_back({speed, elevation});
}

void add_reference(ShotSet& set) {
  Tolerance tight;
  tight.relative = tight.absolute = 1e-13;
  const BatchResult result =
      fly_batch(set.shots, bench_environment(), bench_fidelity(Integrator::dop853), tight, bench_until());
  for (const ShotResult& shot : result.shots) set.reference.push_back(shot.position);
}

/// A curve like a drag function: a level, a rise through Mach 1, a slow fall.
std::vector<DragPoint> own_curve(std::mt19937_64& random, bool searched) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double level = 0.1 + 0.15 * unit(random);
  const double rise = 0.15 + 0.2 * unit(random);
  std::vector<DragPoint> curve;
  for (double mach = 0; mach<3.6; mach += mach> 0.8 && mach < 1.2 ? 0.05 : 0.2) {
    const double odd = searched && mach > 0 ? 0.02 * unit(random) : 0;
    const double at = std::round((mach + odd) * 1e6) * 1e-6;
    curve.push_back({at, level + rise * (0.5 + 0.5 * std::tanh((at - 1) * 8)) * (at < 1 ? 1 : std::pow(at, -0.5))});
  }
  return curve;
}

}  // namespace

Environment bench_environment() {
  Environment environment;
  environment.gravity.model = GravityModel::constant;
  return environment;
}

Until bench_until() {
  Until until;
  until.ground.reset();
  until.range = kRange;
  until.time = 60;
  return until;
}

Fidelity bench_fidelity(Integrator integrator, Precision precision) {
  Fidelity fidelity;
  fidelity.integrator = integrator;
  fidelity.precision = precision;
  fidelity.interpolation = Interpolation::cubic;
  fidelity.wind = WindModel::off;
  return fidelity;
}

ShotSet probe_shots() {
  ShotSet set;
  for (int i = 0; i < 64; ++i) add_308(set, 700 + 200.0 / 63 * i, 1_deg / 63 * ((19 * i) % 64));
  add_reference(set);
  return set;
}

ShotSet uniform_shots(std::size_t count) {
  ShotSet set;
  std::mt19937_64 random(308);
  std::uniform_real_distribution<double> around(-1, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double speed = 823 + 15 * around(random);
    add_308(set, speed, 0.7_deg + 0.3_deg * around(random));
  }
  add_reference(set);
  return set;
}

Study uncertain_308(const Fidelity& fidelity, const Tolerance& tolerance) {
  constexpr std::uint64_t kShards = 4;
  const auto added = [](const char* path, double deviation) {
    return StudyInput{.path = path, .distribution = NormalDistribution{0, deviation}, .added = true};
  };
  const Shot one = bullet_308(823, 0.7_deg);
  Study study;
  study.projectile = one.projectile;
  study.launch = one.launch;
  study.environment = bench_environment();
  study.environment.wind.velocity = {0, 0, 0};
  study.fidelity = fidelity;
  study.fidelity.wind = WindModel::constant;
  study.tolerance = tolerance;
  study.until = bench_until();
  study.inputs = {added("shot.speed", 3),
                  added("shot.elevation", 1e-4),
                  added("shot.azimuth", 1e-4),
                  added("environment.wind.velocity.x", 1),
                  added("environment.wind.velocity.z", 1),
                  added("environment.atmosphere.temperature", 3),
                  added("shot.drag.ballistic_coefficient", 0.004_lb_in2)};
  study.quantities = {StudyQuantity::right, StudyQuantity::up};
  study.targets = {{"plate", RectangleTarget{{}, 0.45, 0.75}}};
  study.shots = kShards * study.shard_shots;
  return study;
}

ShotSet mixed_shots(std::size_t count, bool searched) {
  ShotSet set;
  std::mt19937_64 random(1000);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<DragPoint> own[4];
  for (auto& curve : own) curve = own_curve(random, searched);
  constexpr DragTable kTables[] = {DragTable::g1, DragTable::g2, DragTable::g5, DragTable::g6, DragTable::g7,
                                   DragTable::g8, DragTable::gi, DragTable::gs, DragTable::ra4};
  for (std::size_t i = 0; i < count; ++i) {
    Shot shot = bullet_308(300 + 700 * unit(random), 5_deg * unit(random));
    ProjectileDef& p = shot.projectile;
    p.name.clear();
    p.diameter = 4.5e-3 * std::pow(155 / 4.5, unit(random));
    const double bc = 0.15_lb_in2 * std::pow(1 / 0.15, unit(random));
    p.mass = bc * p.diameter * p.diameter;
    const auto curve = random() % 13;
    p.drag.ballistic_coefficient = curve % 2 == 0 ? bc : 0;  // half of them by mass, diameter and form factor
    p.drag.table = curve < 9 ? kTables[curve] : DragTable::custom;
    if (curve >= 9) p.drag.curve = own[curve - 9];
    set.shots.push_back(shot);
  }
  add_reference(set);
  return set;
}

static_assert(kPeerLayers == kAirLayers && kPeerDensityTerms == kDensityTerms && kPeerSoundTerms == kPerSoundTerms);

std::unique_ptr<PeerData> peer_data() {
  auto data = std::make_unique<PeerData>();
  Cohort& cohort = data->cohort;
  const Shot shot = bullet_308(823, 0);
  const Environment environment = bench_environment();
  cohort.in_use = grant(bench_fidelity(Integrator::tsit5), shot.projectile, environment);
  cohort.conditions = prepare_conditions(environment, cohort.in_use.fidelity, cohort.profiles);
  const Body<double> body = prepare_body(shot.projectile, shot.launch, 0, cohort.pool, cohort.conditions);
  cohort.finish();
  const Conditions<double>& c = cohort.conditions;
  PeerModel& m = data->model;
  m = {};
  m.gravity = c.gravity;
  m.altitude = c.altitude;
  m.geopotential_radius = kGeopotentialRadius;
  m.layers = c.air.layers;
  for (int i = 0; i < c.air.layers; ++i) {
    const AirLayer<double>& layer = c.air.common.layer[i];
    m.base[i] = c.air.base[i];
    m.lapse[i] = layer.lapse;
    m.power[i] = layer.power;
    m.decay[i] = layer.decay;
    m.base_density[i] = layer.base_density;
    m.base_per_sound_speed[i] = layer.base_per_sound;
  }
  m.middle = c.air.low_middle;
  m.scale = c.air.low_scale;
  m.top = c.air.low_top;
  std::copy(std::begin(c.air.common.low_density), std::end(c.air.common.low_density), m.density);
  std::copy(std::begin(c.air.common.low_per_sound), std::end(c.air.common.low_per_sound), m.per_sound_speed);
  m.rows = c.curve_rows + 4 * static_cast<std::size_t>(body.curve_row);
  PHYSIM_ASSERT(body.curve_first == 0);  // which the peers do not subtract either
  m.cells_per_mach = body.curve_cells;
  m.last_cell = static_cast<int>(body.curve_last);
  m.half_area_per_mass = body.half_area_per_mass;
  return data;
}

}  // namespace physim::bench
