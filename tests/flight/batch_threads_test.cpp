// A batch has the same numbers, events and words however many threads fly it.
#include <thread>

#include "flight/batch_support.hpp"
#include "processor_mode.hpp"

namespace physim::flight_batch_threads_test {

using namespace test;

/// Says that it has some threads, and runs tasks one after another, the last one first.
class Backwards final : public TaskRunner {
 public:
  explicit Backwards(unsigned threads) : threads_(threads) {}
  void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
    tasks += count;
    for (std::size_t i = count; i-- > 0;) task(context, i);
  }
  [[nodiscard]] unsigned threads() const override { return threads_; }
  std::size_t tasks = 0;

 private:
  unsigned threads_;
};

/// An engine's threads: each task on a thread of its own, which is set to some mode.
class EnginesThreads final : public TaskRunner {
 public:
  void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
    std::vector<std::thread> all;
    for (std::size_t i = 0; i < count; ++i)
      all.emplace_back([=] {
        const InMode mode(kCallersModes[i % 3]);
        task(context, i);
      });
    for (std::thread& thread : all) thread.join();
  }
  [[nodiscard]] unsigned threads() const override { return 3; }
};

void expect_same_words(const FidelityInUse& one, const FidelityInUse& other, const std::string& what) {
  ASSERT_EQ(one.notes.size(), other.notes.size()) << what;
  for (std::size_t i = 0; i < one.notes.size(); ++i) {
    EXPECT_EQ(one.notes[i].effect, other.notes[i].effect) << what;
    EXPECT_EQ(one.notes[i].granted, other.notes[i].granted) << what;
    EXPECT_EQ(one.notes[i].reason, other.notes[i].reason) << what;
  }
}

template <class Fly>
void expect_same_on_threads(const Fly& fly_on, const std::string& what) {
  const BatchResult alone = fly_on(nullptr);
  EXPECT_FALSE(alone.shots.empty());
  const auto expect_same_on = [&](TaskRunner& runner, const std::string& whose) {
    const BatchResult batch = fly_on(&runner);
    expect_same(alone, batch, what + ", " + whose);
    expect_same_words(alone.fidelity_in_use, batch.fidelity_in_use, what + ", " + whose);
  };
  for (const unsigned threads : {1U, 2U, 7U})
    expect_same_on(*make_thread_pool(threads), std::to_string(threads) + " threads");
  Backwards backwards(5);
  expect_same_on(backwards, "backwards");
  EXPECT_GT(backwards.tasks, 1U) << what << ": too few shots for several threads";
  EnginesThreads engines;
  expect_same_on(engines, "an engine's");
}

/// Launches of which some are refused and some end at once.
std::vector<Launch> launches(int count) {
  Random r(5);
  std::vector<Launch> all;
  for (int i = 0; i < count; ++i) {
    Launch launch{.position = {0, 1, 0}, .speed = r.in(50, 400), .elevation = r.in(-0.1, 0.8)};
    if (r.one_in(50)) launch.speed = kNan;
    if (r.one_in(50)) launch.position.y = -1;
    all.push_back(launch);
  }
  all[0].position.y = -1;  // the first ends at once, the second is refused: neither chooses steps
  all[1].speed = kNan;
  return all;
}

void expect_launches_same(const ProjectileDef& projectile, const Fidelity& fidelity, const Tolerance& tolerance,
                          const std::string& what) {
  const std::vector<Launch> all = launches(9000);
  const Until until{.time = 3, .events = {{EventKind::height, 20}, {EventKind::apex}}};
  expect_same_on_threads(
      [&](TaskRunner* runner) { return fly_batch(projectile, all, {}, fidelity, tolerance, until, runner); }, what);
}

TEST(BatchThreads, launches_of_one_projectile) {
  expect_launches_same(bullet_308(), Fidelity::game(), {}, "game");
  expect_launches_same(bullet_308(), Fidelity::small_arms(), {}, "small arms");
  Fidelity f = Fidelity::simulation();
  f.integrator = Integrator::rk4;
  expect_launches_same(bullet_308(), f, {.position_error = 0.1}, "a step by pilots");
  expect_launches_same(bullet_308(), f, {.position_error = 1e-15, .max_steps = 200}, "a step that keeps no error");
}

TEST(BatchThreads, shots_of_many_projectiles_and_rungs) {
  RandomBatch c = random_batch(3, Integrator::rk4, Precision::float64, 40);
  c.until.time = 2;
  std::vector<Shot> many;
  Random r(9);
  for (int i = 0; i < 40000; ++i) {
    many.push_back(c.shots[static_cast<std::size_t>(r.below(40))]);
    many.back().launch.elevation += 1e-5 * i;
    if (r.one_in(500)) many.back().projectile.mass = -1;
  }
  for (const double step : {0.05, 0.0}) {
    c.tolerance.step = step, c.tolerance.position_error = 0.1;
    expect_same_on_threads(
        [&](TaskRunner* runner) { return fly_batch(many, c.environment, c.fidelity, c.tolerance, c.until, runner); },
        "steps of " + std::to_string(step));
  }
}

TEST(BatchThreads, attitudes) {
  const std::vector<Launch> some = launches(5000);
  Fidelity turning = Fidelity::simulation();
  turning.rotation = RotationModel::rigid_body;
  ProjectileDef shell = bullet_308();
  shell.inertia.moments = {1e-7, 8e-7, 8e-7};
  shell.aero.lift = {{0, 0, 2}};
  expect_same_on_threads(
      [&](TaskRunner* runner) {
        return fly_batch(shell, some, {}, turning, {.max_steps = 60}, {.time = 0.05}, runner);
      },
      "rigid body");
}

TEST(BatchThreads, bad_common_input_refuses_all) {
  const std::vector<Launch> some = launches(5000);
  Environment nowhere{.altitude = kNan};
  const auto pool = make_thread_pool(3);
  expect_same(fly_batch(bullet_308(), some, nowhere, Fidelity::game()),
              fly_batch(bullet_308(), some, nowhere, Fidelity::game(), {}, {}, pool.get()), "nowhere");
}

TEST(BatchThreads, a_result_is_used_again) {
  const auto pool = make_thread_pool(3);
  const std::vector<Launch> some = launches(6000);
  BatchResult used;
  for (const Fidelity& f : {Fidelity::small_arms(), Fidelity::game()}) {
    fly_batch(bullet_308(), some, {}, f, {}, {}, used, pool.get());
    expect_same(fly_batch(bullet_308(), some, {}, f), used, "again");
  }
}

}  // namespace physim::flight_batch_threads_test
