// A ball is kicked, not always the same: how high does it fly, and where does it come down through 5 m? The same
// flights, which go on to the ground, tell of them all.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Study study;
  study.projectile = {.mass = 0.43, .diameter = 0.22, .drag = {.coefficient = 0.25}};
  study.launch = {.speed = 27, .elevation = 30_deg};
  study.fidelity = Fidelity::simulation();
  study.inputs = {{.path = "shot.speed", .distribution = NormalDistribution{27, 0.5}},
                  {.path = "shot.elevation", .distribution = NormalDistribution{0, 0.02}, .added = true}};
  study.at = {{.event = {.kind = EventKind::apex}, .quantities = {StudyQuantity::y, StudyQuantity::time}},
              {.event = {.kind = EventKind::height, .value = 5, .direction = Crossing::falling}}};
  study.shots = 16384;

  const auto threads = make_thread_pool();
  const auto result = run_study(study, threads.get());
  if (!result) return std::puts(result.error().text().c_str()), 1;
  const QuantityResult& apex = result->at[0].quantities[0];
  std::printf("its apex is %.2f m high, 90 %% between %.2f and %.2f m\n", apex.mean.value, apex.cells.quantile(0.05),
              apex.cells.quantile(0.95));
  for (const HistogramBar& bar : apex.cells.histogram(12))
    std::printf("  %5.2f .. %5.2f m: %5llu\n", bar.low, bar.high, static_cast<unsigned long long>(bar.count));
  const StudyResult& falling = result->at[1];
  std::printf("at 5 m on its way down it is %.1f m away, +- %.1f m\n", falling.quantities[1].mean.value,
              falling.quantities[1].deviation);
  const double there = falling.quantities[1].mean.value, end = result->quantities[1].mean.value;
  return there < end ? 0 : 1;
}
