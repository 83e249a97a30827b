// A stone is thrown at a window in a wall: how likely does it break, and what would it be worth to aim better?
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

namespace {

/// Two storeys of bricks, 12 m away, with a pane before them.
std::shared_ptr<const Scene> house() {
  Scene scene;
  const auto bricks = scene.add_shape(BoxShape{{0.2, 3, 5}}), pane = scene.add_shape(BoxShape{{0.01, 0.6, 0.5}});
  if (!bricks || !pane) return nullptr;
  const bool stands = scene.add({.shape = *bricks, .transform = {{12.2, 3, 0}}, .name = "wall"}).ok() &&
                      scene.add({.shape = *pane, .transform = {{11.98, 4, 0}}, .name = "window"}).ok();
  return stands ? std::make_shared<const Scene>(std::move(scene)) : nullptr;
}

}  // namespace

int main() {
  Study study;
  study.projectile = {.mass = 0.2, .diameter = 0.055, .drag = {.coefficient = 0.5}};
  study.launch = {.position = {0, 1.8, 0}, .speed = 15, .elevation = 29_deg};
  study.fidelity = Fidelity::simulation();
  study.scene = house();
  study.targets = {{"window", ThingTarget{"window"}}, {"wall", ThingTarget{"wall"}}};
  study.inputs = {{.path = "shot.speed", .distribution = NormalDistribution{15, 0.7}},
                  {.path = "shot.elevation", .distribution = NormalDistribution{0, 0.04}, .added = true},
                  {.path = "shot.azimuth", .distribution = NormalDistribution{0, 0.05}, .added = true}};
  study.over_inputs = 5;
  study.shots = 16384;

  const auto threads = make_thread_pool();
  const auto result = run_study(study, threads.get());
  if (!result) return std::puts(result.error().text().c_str()), 1;
  for (const HitResult& hit : result->hits)
    std::printf("%-6s %4.1f %%, 95 %% sure between %.1f %% and %.1f %%\n", hit.name.c_str(),
                100 * hit.probability.value, 100 * hit.low, 100 * hit.high);
  for (const HitsOverInput& over : result->over_inputs) {
    std::printf("the window over %s:\n", study.inputs[over.input].path.c_str());
    for (const InputPart& part : over.parts)
      std::printf("  about %7.3f: %4.1f %%\n", part.middle, 100 * part.hits[0].probability.value);
  }
  return result->hits[0].hits + result->hits[1].hits > result->shots ? 1 : 0;  // a stone stops at what it hits first
}
