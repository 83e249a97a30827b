// Sweep of auto fidelity: random shots; what cheapest_within() and its cache grant is flown again and compared with the
// truth, at more times than they looked at. Both promise an error; this counts how often they break their word.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "random_shots.hpp"

namespace physim::test {
namespace {

constexpr int kTimes = 2000;  // at which a flight is compared with the true one

struct Case {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Purpose purpose;
};

/// Evenly in the logarithm.
double spread(Random& r, double low, double high) { return low * std::pow(high / low, r.unit()); }

Case random_case(Random& r) {
  Case c;
  c.projectile.diameter = spread(r, 0.003, 0.2);
  c.projectile.mass = std::pow(c.projectile.diameter, 3) * spread(r, 30, 6000);
  c.projectile.drag.table = static_cast<DragTable>(r.below(11));
  c.projectile.drag.coefficient = r.in(0.1, 1.2);
  c.launch.speed = spread(r, 5, 1200);
  c.launch.elevation = r.in(-0.3, 1.4);
  c.launch.azimuth = r.in(-3, 3);
  c.launch.position.y = r.one_in(3) ? spread(r, 0.1, 2000) : 1.5;
  c.environment.earth.latitude = r.in(-1.2, 1.2);
  if (r.one_in(3)) c.environment.wind.velocity = {r.in(-15, 15), 0, r.in(-15, 15)};
  c.purpose.error = spread(r, 1e-4, 10);
  c.purpose.time = spread(r, 0.2, 30);
  if (r.one_in(2)) c.purpose.ground = 0;
  if (r.one_in(4)) c.purpose.step = 0;
  return c;
}

Flight fly_true(const Case& c) {
  return fly(c.projectile, c.launch, c.environment, c.purpose.truth, {.relative = 1e-13, .absolute = 1e-13},
             {.ground = c.purpose.ground, .time = c.purpose.time});
}

/// The largest distance from the truth over the error that was asked; one that has landed stays where it landed.
double part_of_error(const Case& c, const Flight& truth, const AutoFidelity& chosen) {
  const bool landed = truth.outcome() == Outcome::landed;
  const double end = landed ? 1.5 * truth.duration() : truth.duration();
  const Flight flight = fly(c.projectile, c.launch, c.environment, chosen.fidelity, chosen.tolerance(),
                            {.ground = c.purpose.ground, .time = end});
  if (flight.error()) return INFINITY;
  double worst = 0;
  const double last = std::max(truth.duration(), flight.outcome() == Outcome::landed ? flight.duration() : 0.0);
  for (int i = 0; i <= kTimes; ++i) {
    const double time = last * i / kTimes;
    worst = std::max(worst, length(flight.at(time).position - truth.at(time).position));
  }
  return worst / c.purpose.error;
}

struct Tally {
  const char* name;
  long granted = 0, refused = 0, broken = 0;
  double worst = 0;

  void count(const Case& c, const Flight& truth, const AutoFidelity* chosen, long shot) {
    if (chosen == nullptr) return void(++refused);
    ++granted;
    const double part = part_of_error(c, truth, *chosen);
    worst = std::max(worst, part);
    if (part <= 1) return;
    ++broken;
    std::printf("shot %ld: %s is off by %.3f of the error, %g m over %g s\n", shot, name, part, c.purpose.error,
                c.purpose.time);
  }
  void print() const {
    std::printf("%-16s %ld granted, %ld refused, %ld broke their word (%.3f %%), the worst by a factor of %.3f\n", name,
                granted, refused, broken,
                granted > 0 ? 100.0 * static_cast<double>(broken) / static_cast<double>(granted) : 0, worst);
  }
};

int run(long count, std::uint64_t seed) {
  Tally alone{"cheapest_within"}, cached{"cache"};
  AutoFidelityCache cache;
  for (long shot = 0; shot < count; ++shot) {
    Random r(seed + static_cast<std::uint64_t>(shot));
    const Case c = random_case(r);
    const Flight truth = fly_true(c);
    if (truth.error() || truth.duration() == 0) continue;
    const auto one = cheapest_within(c.projectile, c.launch, c.environment, c.purpose);
    alone.count(c, truth, one ? &*one : nullptr, shot);
    const auto of_class = cache.cheapest_within(c.projectile, c.launch, c.environment, c.purpose);
    cached.count(c, truth, of_class ? of_class->get() : nullptr, shot);
  }
  alone.print();
  cached.print();
  // One in ten thousand is aimed at; what a sweep of this size can show is one in three thousand.
  return alone.broken * 3000 > alone.granted || cached.broken * 1000 > cached.granted || cached.worst > 1.1 ? 1 : 0;
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) {
  const long count = argc > 1 ? std::atol(argv[1]) : 3000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  if (count <= 0) return std::fprintf(stderr, "usage: physim_fidelity_sweep [COUNT [SEED]]\n"), 2;
  return physim::test::run(count, seed);
}
