// Fuzz of asking backwards: random but legal projectiles, environments, rungs and targets. Every solution of aim() is
// flown again, with a tight tolerance, and must hit. Whatever else comes out must be an honest miss with finite
// numbers, or a refusal with words. How many targets are not found that a shot was seen to reach is counted, too.
#include <cmath>
#include <limits>
#include <string>

#include "fuzz/arguments.hpp"
#include "random_shots.hpp"

namespace physim::test {
namespace {

constexpr double kMostLost = 0.005;  // part of the reachable targets that may go unfound

struct Case {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Fidelity fidelity;
  Target target;
  AimOptions options;
  double longest = 100;    // flight that makes the target [s]
  bool reachable = false;  // by the shot that made it
};

struct Tally {
  long hit = 0, missed = 0, refused = 0;
  long reachable = 0, lost = 0;
  long wrong = 0;    // answers that are not true
  double worst = 0;  // miss of a solution flown again, in tolerances
};

Fidelity any_fidelity(Random& r) {
  Fidelity f = random_fidelity(r);
  f.earth = static_cast<EarthModel>(r.below(5));
  f.gravity = r.one_in(10) ? GravityModel::off : static_cast<GravityModel>(1 + r.below(4));
  f.integrator = r.one_in(2) ? Integrator::tsit5 : static_cast<Integrator>(r.below(8));
  f.precision = r.one_in(8) ? Precision::float32 : Precision::float64;
  return f;
}

void spin_ball(Random& r, Case& c) {
  c.fidelity.rotation = RotationModel::magnus;
  c.fidelity.drag = DragModel::equation;
  c.projectile.magnus = {
      .lift = r.in(0.3, 1.5), .lift_base = r.in(0.2, 1), .lift_saturation = r.in(0, 3), .drag_per_spin = r.in(0, 1e-4)};
  c.launch.spin = {.backspin = r.in(-400, 400), .sidespin = r.in(-200, 200), .gyrospin = r.in(-400, 400)};
}

/// A shell with the shape of the 105 mm M1, in its yaw of repose.
void spin_shell(Random& r, Case& c) {
  ProjectileDef& p = c.projectile;
  c.fidelity.rotation = RotationModel::modified_point_mass;
  c.fidelity.drag = DragModel::equation;
  const double md2 = p.mass * p.diameter * p.diameter;
  p.inertia.moments = Vec3d{0.14, 1.4, 1.4} * md2;
  p.twist = (r.one_in(5) ? -1 : 1) * r.in(15, 40) * p.diameter;
  p.aero.drag_yaw = {{0.9, 0, r.in(2, 4)}, {1.1, 0, r.in(4, 7)}};
  p.aero.lift = {{0.4, 0, r.in(1.2, 2)}, {2, 0, r.in(2, 3)}};
  p.aero.pitching = {{0.5, 0, r.in(3, 4)}, {1.5, 0, r.in(2.5, 4)}};
  p.aero.roll_damping = {{0, 0, -r.in(0.005, 0.03)}};
  if (r.one_in(2)) p.aero.magnus_force = {{0, 0, -r.in(0, 1)}, {0, 0.03, -r.in(0, 1)}};
}

/// A body with fins in six degrees of freedom.
void fin_body(Random& r, Case& c) {
  ProjectileDef& p = c.projectile;
  c.fidelity.rotation = RotationModel::rigid_body;
  c.fidelity.drag = DragModel::equation;
  const double length = r.in(4, 12);
  const double md2 = p.mass * p.diameter * p.diameter;
  p.inertia.moments = Vec3d{0.12, length * length / 12, length * length / 12} * md2;
  p.twist = 0;
  p.aero.lift = {{0, 0, r.in(2, 8)}};
  p.aero.pitching = {{0, 0, -r.in(2, 20)}};
  p.aero.pitch_damping = {{0, 0, -r.in(50, 400)}};
  p.aero.roll_damping = {{0, 0, -r.in(1, 20)}};
  c.longest = 6;
}

void add_motor(Random& r, Case& c) {
  ProjectileDef& p = c.projectile;
  const double thrust = p.mass * r.in(5, 80), burn = r.in(0.1, 3);
  p.motor.thrust = {{0, thrust}, {0.3 * burn, thrust * r.in(0.3, 2)}, {burn, 0}};
  p.motor.propellant_mass = p.mass * r.in(0, 0.5);
  if (r.one_in(3)) p.motor.ignition_delay = r.in(0, 2);
  if (r.one_in(3)) p.motor.drag_factor = r.in(0.6, 1);
  // aim() turns a launch.speed, and a rocket that starts from rest needs a rail.
  c.launch.velocity.reset();
  c.launch.speed = std::max(c.launch.speed, 5.0);
}

/// What turns or burns. One in thirteen has fins: flights of those take a hundred times as long as others.
void make_special(Random& r, Case& c) {
  c.fidelity.motion = Motion::force;
  c.fidelity.planar = false;
  if (c.fidelity.integrator == Integrator::classic) c.fidelity.integrator = Integrator::rk4;
  const int kind = r.below(13);
  if (kind < 4) return spin_ball(r, c);
  if (kind < 8) return spin_shell(r, c);
  if (kind < 12) return add_motor(r, c);
  fin_body(r, c);
}

/// Whether a shot means anything: fixed steps may be far too long for light projectiles.
bool is_sound(const Case& c, const Flight& flight) {
  if (flight.error() || flight.duration() == 0 || !ended_as_planned(flight.outcome())) return false;
  if (flight.step() == 0) return true;
  Tolerance half = c.options.flight;
  half.step *= 0.5;
  const Flight finer = fly(c.projectile, c.launch, c.environment, c.fidelity, half, {.ground = {}, .time = c.longest});
  const double time = std::min(flight.duration(), finer.duration());
  return length(flight.at(time).position - finer.at(time).position) < 0.1 + 1e-3 * time * flight.at(0).speed;
}

Case any_case(Random& r) {
  Case c;
  c.projectile = random_projectile(r);
  c.launch = random_launch(r);
  c.launch.sight = {};
  c.environment = random_environment(r);
  c.environment.gravity.model = static_cast<GravityModel>(r.below(5));
  c.fidelity = any_fidelity(r);
  if (r.one_in(5)) make_special(r, c);
  c.options.time = 120;
  // A float32 flight does not tell places to a centimetre.
  if (c.fidelity.precision == Precision::float32) c.options.tolerance = 0.5;
  c.options.flight.max_steps = 20000;
  c.options.flight.step = r.in(0.01, 0.03);  // pilot flights over kinked data would take for ever
  const Flight flight = fly(c.projectile, c.launch, c.environment, c.fidelity, c.options.flight,
                            {.ground = r.in(-100, 0), .time = c.longest});
  const double time = flight.duration() * r.in(0.02, 1);
  c.target.position = flight.at(time).position;
  c.reachable = is_sound(c, flight);
  if (r.one_in(3)) {  // a moving one, that is there at the same time
    c.target.velocity = r.vector(r.one_in(2) ? 10 : 100);
    c.target.acceleration = r.one_in(2) ? Vec3d{} : r.vector(5);
    c.target.position -= (c.target.velocity + c.target.acceleration * (0.5 * time)) * time;
  }
  if (r.one_in(4)) {
    c.target.position += r.vector(r.one_in(2) ? 100 : 10000);
    c.reachable = false;
  }
  return c;
}

/// How near a solution comes to the target, flown again with a tight tolerance and looked at finely.
double miss_again(const Case& c, const AimSolution& s) {
  Tolerance tight = c.options.flight;
  if (c.fidelity.precision == Precision::float64) tight.relative = tight.absolute = 1e-11;
  tight.max_steps *= 10;  // so tight a tolerance takes more of them
  const Flight flight = fly(c.projectile, s.launch, c.environment, c.fidelity, tight,
                            {.ground = std::nullopt, .time = 1.01 * s.time + 1e-6});
  double least = std::numeric_limits<double>::infinity(), width = 0.02 * s.time, middle = s.time;
  for (int round = 0; round < 8 && !flight.error(); ++round, width *= 0.1) {
    double best = middle;
    for (int i = -20; i <= 20; ++i) {
      const double t = middle + width * i / 20;
      const double miss = length(flight.at(t).position - c.target.at(t));
      if (miss < least) least = miss, best = t;
    }
    middle = best;
  }
  return least;
}

bool is_finite(const AimSolution& s) {
  return std::isfinite(s.launch.elevation) && std::isfinite(s.launch.azimuth) && std::isfinite(s.miss) &&
         std::isfinite(s.time) && std::isfinite(s.speed) && std::isfinite(s.descent) && std::isfinite(s.position.x);
}

/// What is wrong with an answer; empty where nothing is.
std::string fault(const Case& c, const Result<Aim>& answer, Tally& tally) {
  if (!answer) return ++tally.refused, answer.error().message.empty() ? "a refusal without words" : "";
  if (!answer->in_reach()) {
    ++tally.missed;
    if (!is_finite(answer->nearest)) return "the nearest miss is not finite";
    return answer->nearest.miss <= c.options.tolerance && !answer->behind_ground ? "a miss that hits" : "";
  }
  ++tally.hit;
  for (const auto& solution : {answer->low, answer->high}) {
    if (!solution || !is_finite(*solution)) return "a solution that is not finite";
    const double miss = miss_again(c, *solution) / c.options.tolerance;
    tally.worst = std::max(tally.worst, miss);
    if (!(miss <= 1.1)) return "flown again it misses by " + std::to_string(miss) + " tolerances";
  }
  return "";
}

void judge(long number, const Case& c, Tally& tally) {
  const Result<Aim> answer = aim(c.projectile, c.launch, c.environment, c.fidelity, c.target, c.options);
  const std::string what = fault(c, answer, tally);
  const bool lost = c.reachable && !(answer && answer->in_reach());
  tally.reachable += c.reachable;
  tally.lost += lost;
  tally.wrong += !what.empty();
  if (!what.empty()) std::printf("case %ld: %s\n", number, what.c_str());
  if (!lost) return;
  const Fidelity& f = answer ? answer->fidelity_in_use.fidelity : c.fidelity;
  std::printf("case %ld: not found (%s, %s, rotation %s, wind %s, %s): %s\n", number, name(f.motion).data(),
              name(f.integrator).data(), name(f.rotation).data(), name(f.wind).data(), name(f.precision).data(),
              answer ? answer->explanation().c_str() : answer.error().text().c_str());
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) {
  using namespace physim::test;
  const auto asked = read_arguments("physim_fuzz", argc, argv);
  if (!asked) return 2;
  Tally tally;
  for (long i = asked->first; i < asked->first + asked->count; ++i) {
    Random r(static_cast<std::uint64_t>(asked->seed) * 1000003u + static_cast<std::uint64_t>(i));
    judge(i, any_case(r), tally);
    if (i % 5000 == 4999) std::fprintf(stderr, "%ld cases\n", i + 1 - asked->first);
  }
  std::printf("%ld cases: %ld hit, %ld missed, %ld refused; %ld wrong; of %ld reachable targets %ld not found\n",
              asked->count, tally.hit, tally.missed, tally.refused, tally.wrong, tally.reachable, tally.lost);
  std::printf("flown again, the worst solution misses by %.3f of the tolerance\n", tally.worst);
  const bool lost_many = static_cast<double>(tally.lost) > kMostLost * static_cast<double>(tally.reachable) + 2;
  return tally.wrong > 0 || lost_many ? 1 : 0;
}
