// Mixed projectiles against equal ones, and what a batch allocates.
#include <algorithm>

#include "allocations.hpp"
#include "sections.hpp"

namespace physim::bench {
namespace {

struct Entry {
  const char* name;
  Contender contender;
  const ShotSet* set;
  Work work = {};
  Miss miss = {};
};

std::vector<Cell> row_of(const Entry& e, const std::vector<double>& taken, const Entry& base,
                         const std::vector<double>& base_taken) {
  const double flights = static_cast<double>(e.set->shots.size());
  const double tries = static_cast<double>(e.work.tries);
  const double base_tries = static_cast<double>(base.work.tries);
  const double part = median(ratios(base_taken, taken));
  return {e.name,
          e.contender.kernel,
          rate(flights / median(taken)),
          percent(part),
          fixed(tries / flights, 1),
          rate(tries / median(taken)),
          percent(part * tries / base_tries),
          fixed(1e9 * median(taken) / tries, 1),
          percent(static_cast<double>(e.work.tries - e.work.steps) / tries),
          metres(e.miss.rms),
          metres(e.miss.worst)};
}

}  // namespace

Section mixed_section(const Options& options, double tolerance) {
  const std::size_t count = 10000;
  const ShotSet uniform = uniform_shots(count);
  const ShotSet mixed = mixed_shots(count);
  const ShotSet searched = mixed_shots(count, true);
  const Fidelity tsit5 = bench_fidelity(Integrator::tsit5);
  std::vector<Entry> entries;
  for (const std::string& kernel : {kernels().front(), std::string("scalar")}) {
    entries.push_back({"uniform", batch("", kernel, tsit5, BatchOf::shots), &uniform});
    entries.push_back({"mixed", batch("", kernel, tsit5, BatchOf::shots), &mixed});
    entries.push_back({"mixed, own curves at odd Mach numbers", batch("", kernel, tsit5, BatchOf::shots), &searched});
  }
  std::vector<std::function<void()>> turns;
  for (Entry& e : entries) {
    e.work = e.contender.fly(*e.set, count, tolerance, nullptr);
    e.miss = miss(e.contender, *e.set, count, tolerance);
    turns.emplace_back([&e, tolerance] { e.contender.fly(*e.set, count, tolerance, nullptr); });
  }
  const auto taken = take_turns(options.clock, options.rounds, turns);

  Section s;
  s.title = "Mixed projectiles";
  s.intro =
      "10 000 projectiles to the same range line at the same tolerance (" + power(tolerance).text +
      "): equal ones, then a mixed company (4.5 to 155 mm, 0.15 to 1.0 lb/in^2, 300 to 1000 m/s, 0 to 5 degrees, nine "
      "standard drag functions and four own curves).";
  s.columns = {"company",   "kernel",   "flights/s", "of uniform", "steps a flight", "steps/s", "of uniform's steps/s",
               "ns a step", "rejected", "rms error", "worst error"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t base = i / 3 * 3;
    s.rows.push_back(row_of(entries[i], taken[i], entries[base], taken[base]));
  }
  s.notes = {
      "Flights a second compare whole flights, which differ: slow projectiles cross Mach 1 and need more steps. Steps "
      "a "
      "second (tried ones, rejected included) compare the machinery: divergence, refill, curves of many kinds.",
      "The scalar rows say what the mixture costs without packs: divergence is what the packs lose beyond that."};
  return s;
}

Section allocation_section(const Options& options) {
  Section s;
  s.title = "Allocations";
  s.intro = "Calls of operator new during one fly_batch(), by batch size and tolerance, and during one fly_columns().";
  s.columns = {"flights", "tolerance", "steps", "allocations", "a step more allocates"};
  const std::size_t most = std::min<std::size_t>(options.flights, 8000);
  const ShotSet set = uniform_shots(most);
  const Contender packs = batch("", kernels().front(), bench_fidelity(Integrator::tsit5), BatchOf::shots);
  for (const std::size_t count : {most / 2, most}) {
    std::int64_t steps_before = 0, allocations_before = 0;
    for (const double tolerance : {1e-6, 1e-12}) {
      const std::int64_t start = allocations();
      const Work work = packs.fly(set, count, tolerance, nullptr);
      const std::int64_t made = allocations() - start;
      Cell more = "";
      if (steps_before > 0)
        more =
            fixed(static_cast<double>(made - allocations_before) / static_cast<double>(work.steps - steps_before), 3);
      s.rows.push_back({fixed(static_cast<double>(count), 0), power(tolerance),
                        fixed(static_cast<double>(work.steps), 0), fixed(static_cast<double>(made), 0), more});
      steps_before = work.steps;
      allocations_before = made;
    }
  }
  const Contender columns = batch("", kernels().front(), bench_fidelity(Integrator::tsit5), BatchOf::columns);
  for (const std::size_t count : {most / 2, most}) {
    columns.fly(set, count, 1e-6, nullptr);  // fills the columns
    const std::int64_t start = allocations();
    columns.fly(set, count, 1e-6, nullptr);
    s.rows.push_back({fixed(static_cast<double>(count), 0).text + " in columns", power(1e-6), "",
                      fixed(static_cast<double>(allocations() - start), 0), ""});
  }
  return s;
}

}  // namespace physim::bench
