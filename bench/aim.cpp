// aim(): how many trajectories a solution takes, how long, and whether it is right.
#include <algorithm>
#include <cmath>

#include "physim/solve.hpp"
#include "random_shots.hpp"
#include "sections.hpp"

namespace physim::bench {
namespace {

/// A target that a random shot was seen to pass.
struct Question {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Target target;
};

/// A rifle bullet, a shell, a golf ball or a steel sphere.
ProjectileDef random_kind(test::Random& r, Launch& launch) {
  ProjectileDef p;
  switch (r.below(4)) {
    case 0:
      p = {.mass = 0.0109, .diameter = 0.00782, .length = 0.031, .twist = 0.3};
      p.drag = {.table = DragTable::g7, .ballistic_coefficient = r.in(140, 240)};
      launch.speed = r.in(600, 900);
      break;
    case 1:
      p = {.mass = 15, .diameter = 0.105};
      p.drag = {.table = DragTable::g1, .form_factor = r.in(0.8, 1.2)};
      launch.speed = r.in(200, 600);
      break;
    case 2:
      p = {.mass = 0.0459, .diameter = 0.0427};
      p.drag.coefficient = r.in(0.2, 0.45);
      launch.speed = r.in(30, 80);
      break;
    default:
      p = {.mass = 5, .diameter = 0.11};
      p.drag.table = DragTable::sphere;
      launch.speed = r.in(20, 300);
  }
  return p;
}

Question random_question(std::uint64_t seed) {
  test::Random r(seed);
  Question q;
  q.projectile = random_kind(r, q.launch);
  q.environment.wind.velocity = {r.in(-10, 10), 0, r.in(-10, 10)};
  q.environment.earth.latitude = r.in(-1.5, 1.5);
  q.launch.position = {r.in(-100, 100), r.in(0, 500), r.in(-100, 100)};
  q.launch.azimuth = r.in(-3.1, 3.1);
  q.launch.elevation = r.in(-0.3, 1.5);
  const Flight flight = fly(q.projectile, q.launch, q.environment, Fidelity::simulation(), {.relative = 1e-10},
                            {.ground = r.in(-100, 0)});
  const double time = flight.duration() * r.in(0.02, 1);
  q.target.position = flight.at(time).position;
  if (r.one_in(4)) {
    q.target.velocity = r.vector(30);
    q.target.position -= q.target.velocity * time;
  }
  return q;
}

/// How near a solution passes, flown again with a tight tolerance and the reference integrator.
double miss_again(const Question& q, const AimSolution& s) {
  const double end = s.time * 1.001 + 1e-4;
  const Flight flight = fly(q.projectile, s.launch, q.environment, Fidelity::reference(),
                            {.relative = 1e-12, .absolute = 1e-12}, {.ground = std::nullopt, .time = end});
  double best = s.time, least = 1e300;
  for (double width = 1e-3 * s.time + 1e-4; width > 1e-12 * s.time; width *= 0.2) {
    const double middle = best;
    for (int i = -10; i <= 10; ++i) {
      const double t = std::clamp(middle + width * i / 10, 0.0, end);
      const double miss = length(flight.at(t).position - q.target.at(t));
      if (miss < least) least = miss, best = t;
    }
  }
  return least;
}

struct ArcTally {
  std::vector<double> flights;
  std::size_t found = 0, wrong = 0;
  double worst = 0;
};

void count(const Question& q, const std::optional<AimSolution>& solution, ArcTally& tally) {
  if (!solution) return;
  ++tally.found;
  tally.flights.push_back(static_cast<double>(solution->flights));
  const double miss = miss_again(q, *solution);
  tally.worst = std::max(tally.worst, miss);
  if (!(miss <= AimOptions{}.tolerance * 1.01)) ++tally.wrong;
}

}  // namespace

Section aim_section(const Options& options) {
  const std::size_t number = options.quick ? 1000 : 10000;
  std::vector<Question> questions;
  for (std::size_t i = 0; i < number; ++i) questions.push_back(random_question(i + 1));
  Section s;
  s.title = "Asking backwards: aim() at " + std::to_string(number) + " targets";
  s.intro =
      "Rifle bullets, shells, golf balls and steel spheres in wind, simulation(); targets on the paths of random shots "
      "at all elevations, every fourth one moving. A hit is 1 cm. Every solution was flown again with the reference "
      "integrator; wrong are those that miss.";
  s.columns = {"arc", "found", "wrong", "worst miss", "trajectories, median", "mean", "9 of 10", "most", "us"};
  for (const Arc arc : {Arc::low, Arc::high}) {
    ArcTally tally;
    double mean = 0;
    for (const Question& q : questions) {
      const auto answer = aim(q.projectile, q.launch, q.environment, Fidelity::simulation(), q.target, {.arc = arc});
      if (answer) count(q, arc == Arc::low ? answer->low : answer->high, tally);
    }
    for (const double flights : tally.flights) mean += flights / static_cast<double>(tally.flights.size());
    const auto ask_all = [&] {
      for (const Question& q : questions)
        static_cast<void>(aim(q.projectile, q.launch, q.environment, Fidelity::simulation(), q.target, {.arc = arc}));
    };
    const auto taken = take_turns(options.clock, std::min(options.rounds, 5), {ask_all});
    s.rows.push_back({arc == Arc::low ? "low" : "high", fixed(static_cast<double>(tally.found), 0),
                      fixed(static_cast<double>(tally.wrong), 0), metres(tally.worst), fixed(median(tally.flights), 0),
                      fixed(mean, 2), fixed(quantile(tally.flights, 0.9), 0), fixed(quantile(tally.flights, 1), 0),
                      fixed(1e6 * median(taken[0]) / static_cast<double>(number), 0)});
  }
  return s;
}

}  // namespace physim::bench
