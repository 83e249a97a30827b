// Batches on two threads, beside what two processes reach that fly the same at the same time.
#include "physim/flight.hpp"
#include "physim/result.hpp"
#include "sections.hpp"

namespace physim::bench {
namespace {

struct Company {
  const char* name;
  std::function<void(TaskRunner*)> fly;
  double flights = 0;  // 0: as many as there are launches
};

std::vector<Cell> row_of(const Company& company, double flights, const std::vector<std::vector<double>>& taken) {
  const std::vector<double>&one = taken[0], &two = taken[1], &processes = taken[2];
  return {company.name,
          rate(flights / median(one)),
          rate(flights / median(two)),
          rate(2 * flights / median(processes)),
          times(median(ratios(one, two))),
          fixed(0.5 * median(ratios(processes, two)), 2)};
}

}  // namespace

Section threads_section(const Options& options) {
  const std::size_t count = options.quick ? 100'000 : 400'000;
  const ShotSet set = uniform_shots(1000);
  std::vector<Launch> launches;
  std::vector<double> speed, elevation, drop(count), windage(count);
  for (std::size_t i = 0; i < count; ++i) {
    launches.push_back(set.launches[i % set.launches.size()]);
    speed.push_back(launches.back().speed), elevation.push_back(launches.back().elevation);
  }
  const ProjectileDef& bullet = set.shots[0].projectile;
  const Fidelity fidelity = bench_fidelity(Integrator::rk43);
  const Tolerance tolerance{.relative = 1e-6, .absolute = 1e-6};
  BatchResult result;
  Study uncertain = uncertain_308(fidelity, tolerance);
  uncertain.shots = count;
  const Result<StudyPlan> study = plan_study(uncertain);
  const std::vector<Company> companies{
      {"fly_batch()",
       [&](TaskRunner* runner) {
         fly_batch(bullet, launches, bench_environment(), fidelity, tolerance, bench_until(), result, runner);
       }},
      {"fly_columns()",
       [&](TaskRunner* runner) {
         static_cast<void>(fly_columns(bullet, {.speed = speed, .elevation = elevation}, bench_environment(), fidelity,
                                       tolerance, bench_until(), {.drop = drop, .windage = windage}, runner));
       }},
      {"run_study(), seven uncertain inputs",
       [plan = study.value()](TaskRunner* runner) { static_cast<void>(run_study(plan, runner)); },
       static_cast<double>(study.value().shards() * study.value().study().shard_shots)}};
  Section s;
  s.title = "Threads";
  s.intro = "Flights a second of " + std::to_string(count) +
            " launches, RK4(3): by one thread, by two threads of one process, and by two processes of one thread that "
            "fly as many each at the same time.";
  s.columns = {"what", "one thread", "two threads", "two processes", "two threads over one", "over two processes"};
  const auto pool = make_thread_pool(2);
  for (const Company& company : companies) {
    std::vector<std::vector<double>> taken(3);
    for (int round = 0; round < options.rounds; ++round) {
      taken[0].push_back(seconds(Clock::wall, [&] { company.fly(nullptr); }));
      taken[1].push_back(seconds(Clock::wall, [&] { company.fly(pool.get()); }));
      taken[2].push_back(seconds_of_two([&] { company.fly(nullptr); }));
    }
    s.rows.push_back(row_of(company, company.flights > 0 ? company.flights : static_cast<double>(count), taken));
  }
  return s;
}

}  // namespace physim::bench
