// Your engine's job system: the world hands its work to it, and the numbers stay the same.
#include <atomic>
#include <cstdio>
#include <physim/physim.hpp>
#include <thread>
#include <vector>

using namespace physim;
using namespace physim::units;

/// Stands for an engine's job system: run() returns when all pieces are done, whoever did them.
class EngineJobs final : public TaskRunner {
 public:
  void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < count; i = next++) task(context, i);
    };
    std::vector<std::thread> helpers;
    for (unsigned i = 1; i < threads(); ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
    pieces += count;
  }
  [[nodiscard]] unsigned threads() const override { return 3; }

  std::size_t pieces = 0;
};

World busy_world() {
  WorldDef def;
  def.threading.rows_per_thread = 4096;  // ask for help from 8192 projectiles on
  World world = World::create(def).value();
  ProjectileDef spark{.mass = 1_g, .diameter = 5_mm};
  spark.fidelity = Fidelity::game();
  const KindId kind = *world.add_kind(spark);
  for (int i = 0; i < 20'000; ++i)
    world.spawn(kind, {.position = {0, 1, 0}, .speed = 10 + i * 1e-3, .elevation = 1, .azimuth = i * 0.01});
  return world;
}

int main() {
  EngineJobs jobs;  // must outlive the world that it is lent to
  World lent = busy_world(), alone = busy_world();
  lent.set_task_runner(&jobs);
  for (int i = 0; i < 60; ++i) lent.single_step(), alone.single_step();
  std::printf("%zu pieces of work were done by the engine; %zu projectiles are in the air\n", jobs.pieces, lent.size());
  std::printf("hashes %016llx and %016llx\n", static_cast<unsigned long long>(lent.hash()),
              static_cast<unsigned long long>(alone.hash()));
  return jobs.pieces > 0 && lent.hash() == alone.hash() ? 0 : 1;
}
