// Fuzz of asking backwards: random but legal projectiles, environments, rungs and targets. Every solution of aim() is
// flown again and must hit; every target that a shot was seen to reach must be found; everything else must be a refusal
// or an honest miss with finite numbers.
#include <cstdio>
#include <cstdlib>
#include <cmath>
#include <limits>
#include <string>

#include "physim/physim.hpp"
#include "random_shots.hpp"

namespace physim::test {
namespace {

struct Case {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Fidelity fidelity;
  Target target;
  AimOptions options;
  bool reachable = false;  // by the shot that made it
};

struct Tally {
  int hit = 0, missed = 0, refused = 0;
  int wrong = 0;   // an answer that is not true
  int lost = 0;    // a reachable target that was not found
  double worst = 0;  // of the misses of solutions flown again, in tolerances
};

Fidelity any_fidelity(Random& r) {
  Fidelity f = random_fidelity(r);
  f.earth = static_cast<EarthModel>(r.below(5));
  f.gravity = r.one_in(10) ? GravityModel::off : static_cast<GravityModel>(1 + r.below(4));
  f.integrator = r.one_in(2) ? Integrator::tsit5 : static_cast<Integrator>(r.below(7));
  f.precision = r.one_in(8) ? Precision::float32 : Precision::float64;
  return f;
}

Case any_case(Random& r) {
  Case c;
  c.projectile = random_projectile(r);
  c.launch = random_launch(r);
  c.launch.sight = {};
  c.environment = random_environment(r);
  c.environment.gravity.model = static_cast<GravityModel>(r.below(5));
  c.fidelity = any_fidelity(r);
  c.options.time = 120;
  const bool rough = c.fidelity.precision == Precision::float32;  // cannot tell places to a centimetre far out
  if (rough) c.options.tolerance = 0.5;
  c.options.flight.step = r.in(0.01, 0.03);  // of fixed steps: pilot flights over kinked data would take for ever
  const Flight flight = fly(c.projectile, c.launch, c.environment, c.fidelity, c.options.flight, {.ground = r.in(-100, 0), .time = 100});
  const double time = flight.duration() * r.in(0.02, 1);
  c.target.position = flight.at(time).position;
  c.reachable = !flight.error() && time > 0;
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
  const Flight flight =
      fly(c.projectile, s.launch, c.environment, c.fidelity, tight, {.ground = std::nullopt, .time = 1.01 * s.time + 1e-6});
  if (flight.error()) return std::numeric_limits<double>::infinity();
  const auto miss = [&](double t) { return length(flight.at(t).position - c.target.at(t)); };
  double least = std::numeric_limits<double>::infinity(), width = 0.02 * s.time, middle = s.time;
  for (int round = 0; round < 8; ++round, width *= 0.1) {
    double best = middle;
    for (int i = -20; i <= 20; ++i) {
      const double t = middle + width * i / 20;
      if (const double m = miss(t); m < least) least = m, best = t;
    }
    middle = best;
  }
  return least;
}

bool finite(const AimSolution& s) {
  return std::isfinite(s.launch.elevation) && std::isfinite(s.launch.azimuth) && std::isfinite(s.miss) &&
         std::isfinite(s.time) && std::isfinite(s.speed) && std::isfinite(s.descent);
}

std::string judge(const Case& c, Tally& tally) {
  const Result<Aim> answer = aim(c.projectile, c.launch, c.environment, c.fidelity, c.target, c.options);
  if (!answer) {
    ++tally.refused;
    if (answer.error().message.empty()) return ++tally.wrong, "a refusal without words";
    return c.reachable && c.launch.speed > 0.1 ? (++tally.lost, "refused: " + answer.error().text()) : "";
  }
  if (!answer->in_reach()) {
    ++tally.missed;
    if (!finite(answer->nearest)) return ++tally.wrong, "the nearest miss is not finite";
    if (answer->nearest.miss <= c.options.tolerance) return ++tally.wrong, "a miss that hits";
    return c.reachable ? (++tally.lost, "reachable, but nearest " + std::to_string(answer->nearest.miss) + " m") : "";
  }
  ++tally.hit;
  for (const auto& solution : {answer->low, answer->high}) {
    if (!solution || !finite(*solution)) return ++tally.wrong, "a solution that is not finite";
    const double miss = miss_again(c, *solution) / c.options.tolerance;
    tally.worst = std::max(tally.worst, miss);
    if (!(miss <= 1.2)) return ++tally.wrong, "flown again it misses by " + std::to_string(miss) + " tolerances, said " + std::to_string(solution->miss);
  }
  return "";
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) {
  using namespace physim::test;
  const long count = argc > 1 ? std::atol(argv[1]) : 500;
  const long seed = argc > 2 ? std::atol(argv[2]) : 1;
  const long only = argc > 3 ? std::atol(argv[3]) : -1;
  setvbuf(stdout, nullptr, _IOLBF, 1 << 12);
  Tally tally;
  long reachable = 0;
  for (long i = 0; i < count; ++i) {
    if (only >= 0 && i != only) continue;
    Random r(static_cast<std::uint64_t>(seed) * 1000003u + static_cast<std::uint64_t>(i));
    const Case c = any_case(r);
    reachable += c.reachable;
    const std::string complaint = judge(c, tally);
    const auto& f = c.fidelity;
    if (!complaint.empty()) std::printf("case %ld: %s [motion %d integ %d grav %d drag %d air %d wind %d earth %d rot %d prec %d planar %d v %.3f el %.2f force %d mov %d]\n", i, complaint.c_str(),int(f.motion),int(f.integrator),int(f.gravity),int(f.drag),int(f.air),int(f.wind),int(f.earth),int(f.rotation),int(f.precision),f.planar,c.launch.velocity?length(*c.launch.velocity):c.launch.speed,c.launch.elevation*57.3,!(c.projectile.force==physim::Vec3d{}),!(c.target.velocity==physim::Vec3d{}));
  }
  std::printf("%ld cases, %ld reachable: %d hit, %d missed, %d refused; %d wrong, %d not found; worst miss %.3f of the tolerance\n", count,
              reachable, tally.hit, tally.missed, tally.refused, tally.wrong, tally.lost, tally.worst);
  return tally.wrong > 0 ? 1 : 0;
}
