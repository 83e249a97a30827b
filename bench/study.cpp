// Studies: what uncertain inputs cost beside flights of which nothing is uncertain, and a rocket's landing ellipse.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "physim/flight.hpp"
#include "physim/study.hpp"
#include "physim/units.hpp"
#include "sections.hpp"

namespace physim::bench {

using namespace physim::units;

namespace {

StudyInput added(const char* path, double deviation) {
  return {.path = path, .distribution = NormalDistribution{0, deviation}, .added = true};
}

StudyPlan planned(const Study& study) {
  const auto plan = plan_study(study);
  if (plan) return *plan;
  std::fprintf(stderr, "%s\n", plan.error().text().c_str());
  std::exit(1);
}

/// Shards flown, joined, and their figures told: what `physim study` does on one thread.
void fly(const StudyPlan& plan) {
  const auto result = run_study(plan);
  if (!result || result->not_arrived == result->shots) std::exit(1);
}

/// A row of the section, and the row of flights of which nothing is uncertain that it stands beside.
struct Runner {
  std::string name, what;
  double flights = 0;
  std::function<void()> fly;
  std::size_t certain = 0;
};

/// Nothing is uncertain: batches and columns of the launches alone.
void add_certain(const Contender& kind, const ShotSet& set, double setting, std::vector<Runner>& list) {
  const std::size_t count = set.shots.size();
  list.push_back({kind.name, "nothing is uncertain", static_cast<double>(count),
                  [kind, &set, setting, count] { kind.fly(set, count, setting, nullptr); }, list.size()});
}

/// Columns of which nothing is uncertain, and a study of seven inputs with the same rungs and settings.
void add_pair(const char* name, const Fidelity& fidelity, const ShotSet& probes, const ShotSet& set,
              const Options& options, std::vector<Runner>& list) {
  constexpr double kTarget = 1e-3;  // [m]
  const Contender columns = batch(std::string("fly_columns(), ") + name, "", fidelity, BatchOf::columns);
  const double setting = calibrate(columns, probes, kTarget, options.per_decade).setting;
  const std::size_t certain = list.size();
  add_certain(columns, set, setting, list);
  const StudyPlan plan = planned(uncertain_308(fidelity, tolerance_of(columns, setting)));
  list.push_back({std::string("a study, ") + name,
                  "speed, elevation, azimuth, wind x and z, temperature, ballistic coefficient",
                  static_cast<double>(plan.study().shots), [plan] { fly(plan); }, certain});
}

}  // namespace

Study rocket_study() {
  Study study;
  ProjectileDef& p = study.projectile;
  p.mass = 20;
  p.diameter = 0.15;
  p.inertia.moments = {0.06, 12, 12};
  p.drag.coefficient = 0.45;
  p.motor = {.thrust = {{0, 0}, {0.05, 1500}, {3, 1400}, {3.2, 0}}, .propellant_mass = 2.4};
  p.aero.lift = {{0, 0, 9}};
  p.aero.pitching = {{0, 0, -18}};
  p.aero.pitch_damping = {{0, 0, -400}};
  p.aero.roll_damping = {{0, 0, -5}};
  study.launch = {.speed = 0, .elevation = 85_deg, .rail_length = 5};
  study.fidelity = Fidelity::simulation();
  study.fidelity.rotation = RotationModel::rigid_body;
  study.until = {.time = 200, .events = {{.kind = EventKind::apex, .terminal = true}}};
  study.inputs = {{.path = "shot.motor.thrust", .distribution = NormalDistribution{1, 0.03}},
                  {.path = "shot.drag.form_factor", .distribution = NormalDistribution{1, 0.05}},
                  added("shot.mass", 0.1),
                  added("shot.elevation", 1_deg),
                  added("shot.azimuth", 2_deg),
                  added("environment.wind.velocity.x", 2),
                  added("environment.wind.velocity.z", 2)};
  study.quantities = {StudyQuantity::x, StudyQuantity::z, StudyQuantity::y};
  study.shard_shots = 1024;
  study.shots = 1024;
  return study;
}

Section study_section(const Options& options) {
  const auto data = peer_data();
  const ShotSet probes = probe_shots();
  const Fidelity rk43 = bench_fidelity(Integrator::rk43);
  const ShotSet flown = uniform_shots(uncertain_308(rk43, {}).shots);
  const Contender odeint = peer("Boost.odeint dopri5, native", "native, FMA", fly_odeint_dopri5, data->model);
  std::vector<Runner> list;
  add_certain(odeint, flown, calibrate(odeint, probes, 1e-3, options.per_decade).setting, list);
  add_pair("RK4(3)", rk43, probes, flown, options, list);
  add_pair("fixed RK4, pilot step", bench_fidelity(Integrator::rk4), probes, flown, options, list);
  add_pair("RK4(3), float32", bench_fidelity(Integrator::rk43, Precision::float32), probes, flown, options, list);
  add_pair("fixed RK4, pilot step, float32", bench_fidelity(Integrator::rk4, Precision::float32), probes, flown,
           options, list);
  const StudyPlan rocket = planned(rocket_study());
  list.push_back({"a study, rocket as a rigid body to its apex", "thrust, drag, mass, elevation, azimuth, wind x and z",
                  static_cast<double>(rocket.study().shots), [&rocket] { fly(rocket); }, list.size()});
  std::vector<std::function<void()>> turns;
  for (const Runner& each : list) turns.push_back(each.fly);
  const auto taken = take_turns(options.clock, options.quick ? 5 : options.rounds, turns);
  const auto per_flight = [&](std::size_t i) {
    std::vector<double> each = taken[i];
    for (double& seconds : each) seconds /= list[i].flights;
    return each;
  };
  Section s;
  s.title = "Studies";
  s.intro =
      ".308 168 gr G7 to 1000 m at 1 mm, one thread. A study draws its inputs, flies, and adds up moments, quantiles, "
      "distances, extreme spreads and hits; no shot is kept.";
  s.columns = {"what", "uncertain", "flights/s", "of fly_columns()", "vs odeint"};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const bool is_study = list[i].certain != i;
    s.rows.push_back({list[i].name, list[i].what, rate(1 / median(per_flight(i))),
                      is_study ? percent(median(ratios(per_flight(list[i].certain), per_flight(i)))) : Cell(""),
                      times(median(ratios(per_flight(0), per_flight(i))))});
  }
  s.notes = {"Ratios: medians of those within each round. The rocket's flights are others: about 15 s long."};
  return s;
}

}  // namespace physim::bench
