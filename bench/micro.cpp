// Times the parts of a flight, kernel by kernel.
#include "micro.hpp"

#include <algorithm>

#include "base/kernel_copies.hpp"
#include "prepare/watch_list.hpp"
#include "sections.hpp"

namespace physim {
PHYSIM_KERNEL_COPIES(std::size_t micro(bench::Part part, const bench::MicroJob<double>& job);
                     std::size_t micro(bench::Part part, const bench::MicroJob<float>& job);)
}  // namespace physim

namespace physim::bench {
namespace {

struct MicroKernel {
  std::string name;
  MicroDouble of_double;
  MicroFloat of_float;
};

std::vector<MicroKernel> micro_kernels() {
  std::vector<MicroKernel> list;
  for (const std::string& name : kernels()) {
#if PHYSIM_HAVE_AVX512
    if (name == "avx512") list.push_back({name, avx512::micro, avx512::micro});
#endif
#if PHYSIM_HAVE_AVX2
    if (name == "avx2") list.push_back({name, avx2::micro, avx2::micro});
#endif
    if (name == "base") list.push_back({name, base::micro, base::micro});
  }
  return list;
}

/// A cohort of .308 shots, ready to compute.
struct Bench {
  Cohort cohort;
  std::vector<Body<double>> bodies;
  std::vector<Body<float>> bodies_float;
  WatchList watch{};

  explicit Bench(Precision precision) {
    const ShotSet set = uniform_shots(kMostLanes);
    const Environment environment = bench_environment();
    cohort.in_use = grant(bench_fidelity(Integrator::tsit5, precision), set.shots[0].projectile, environment);
    cohort.conditions = prepare_conditions(environment, cohort.in_use.fidelity, cohort.profiles);
    for (const Shot& shot : set.shots)
      bodies.push_back(
          prepare_body(shot.projectile, shot.launch, shot.launch.elevation, cohort.pool, cohort.conditions));
    cohort.finish();
    watch = prepare_watch(bench_until(), cohort.conditions, Watcher::batch);
    bodies_float.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) cast_numbers(bodies[i], bodies_float[i]);
  }
};

/// Nanoseconds for one lane: the least of several tries.
template <class S>
double cost(const Options& options, Part part, std::size_t (*micro)(Part, const MicroJob<S>&), const Bench& bench) {
  const Course<S> course = bench.cohort.course<S>(Tolerance{}, 0, bench.watch);
  const Body<S>* bodies;
  if constexpr (sizeof(S) == 8) bodies = bench.bodies.data();
  if constexpr (sizeof(S) == 4) bodies = bench.bodies_float.data();
  S sink[kMostLanes];
  MicroJob<S> job{&course, bodies, 1000, sink};
  double best = 1e9;
  for (int i = 0; i < (options.quick ? 5 : 25); ++i) {
    std::size_t lanes = 0;
    const double time = seconds(options.clock, [&] { lanes = micro(part, job); });
    best = std::min(best, 1e9 * time / static_cast<double>(lanes));
    if (time < 2e-4) job.repeats *= 2;
  }
  return best;
}

}  // namespace

const char* name(Part part) {
  constexpr const char* kNames[kParts] = {"exp",
                                          "log",
                                          "Cd look-up",
                                          "standard atmosphere",
                                          "acceleration (RHS)",
                                          "RK4 step",
                                          "Tsit5 step tried",
                                          "DOP853 step tried",
                                          "watch for events",
                                          "accept a step",
                                          "prepare a lane"};
  return kNames[static_cast<int>(part)];
}

Section micro_section(const Options& options) {
  Section s;
  s.title = "Parts";
  s.intro = "Nanoseconds for one lane of a pack; least of several tries.";
  s.columns = {"part"};
  const auto list = micro_kernels();
  for (const MicroKernel& kernel : list) s.columns.push_back(kernel.name + " double");
  for (const MicroKernel& kernel : list) s.columns.push_back(kernel.name + " float");
  const Bench in_double(Precision::float64);
  const Bench in_float(Precision::float32);
  for (int i = 0; i < kParts; ++i) {
    const Part part = static_cast<Part>(i);
    std::vector<Cell> row{name(part)};
    for (const MicroKernel& kernel : list)
      row.push_back(fixed(cost<double>(options, part, kernel.of_double, in_double), 2));
    for (const MicroKernel& kernel : list)
      row.push_back(fixed(cost<float>(options, part, kernel.of_float, in_float), 2));
    s.rows.push_back(row);
  }
  return s;
}

}  // namespace physim::bench
