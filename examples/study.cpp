// How likely is a hit? Speed, aim and wind that are not known for sure, and what each of them costs.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Study study;
  study.projectile = {
      .mass = 168_gr, .diameter = 0.308_in, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  study.launch = {.speed = 2650_fps, .sight = {.height = 5_cm, .zero_range = 600}};
  study.fidelity = Fidelity::small_arms();
  study.until = {.ground = std::nullopt, .range = 600};
  study.inputs = {
      {.path = "shot.speed", .distribution = NormalDistribution{0, 3}, .added = true},
      {.path = "shot.elevation", .distribution = NormalDistribution{0, 0.14e-3}, .added = true},
      {.path = "shot.azimuth", .distribution = NormalDistribution{0, 0.14e-3}, .added = true},
      {.path = "environment.wind.velocity.z", .distribution = NormalDistribution{0, 1}},
  };
  study.targets = {{"plate", RectangleTarget{{}, 45_cm, 75_cm}}};

  const auto plan = plan_study(study);
  if (!plan) return std::puts(plan.error().text().c_str()), 1;
  const auto threads = make_thread_pool();
  const auto result = run_study(*plan, threads.get());
  if (!result) return std::puts(result.error().text().c_str()), 1;

  const HitResult& hit = result->hits[0];
  std::printf("%llu shots: %.1f %% hit, 95 %% sure between %.1f %% and %.1f %%\n",
              static_cast<unsigned long long>(result->shots), 100 * hit.probability.value, 100 * hit.low,
              100 * hit.high);
  std::printf("half of them within %.0f cm of the aim, 95 %% within %.0f cm\n", 100 * result->from_aim->r50,
              100 * result->from_aim->r95);

  const auto linear = propagate_linearly(*plan);  // by slopes, without sampling
  if (!linear) return std::puts(linear.error().text().c_str()), 1;
  for (const LinearRow& row : linear->rows)
    std::printf("  %-28s moves it %5.1f cm aside and %5.1f cm up: %2.0f %% and %2.0f %% of the variance\n",
                study.inputs[row.input].path.c_str(), 100 * row.effect[0], 100 * row.effect[1], 100 * row.share[0],
                100 * row.share[1]);

  const WorstShot& worst = result->worst[0];
  const double again = std::hypot(fly_shot_of(*plan, worst.shot)[0], fly_shot_of(*plan, worst.shot)[1]);
  std::printf("the worst, number %llu, missed by %.0f cm\n", static_cast<unsigned long long>(worst.shot), 100 * again);
  return std::abs(again - worst.distance) < 1_mm ? 0 : 1;
}
