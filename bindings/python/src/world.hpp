// A world as Python has it: one of its own, or the run of a scenario.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "physim/scene.hpp"
#include "scenario/world_run.hpp"
#include "setup.hpp"

namespace physim::python {

class PyWorld {
 public:
  PyWorld(SetupPtr setup, World world) : setup_(std::move(setup)), own_(std::move(world)) {}
  PyWorld(SetupPtr setup, WorldRun run) : setup_(std::move(setup)), run_(std::move(run)) {}
  PyWorld(SetupPtr setup, Replay replay) : setup_(std::move(setup)), replay_(std::move(replay)) {}
  PyWorld(const PyWorld&) = delete;
  PyWorld& operator=(const PyWorld&) = delete;

  /// The world, to be read. An error once it is closed, and while another thread steps it.
  [[nodiscard]] const World& read() const {
    check();
    return replay_ ? replay_->world() : run_ ? run_->world() : *own_;
  }
  /// The world, to be changed. An error where a recording alone moves it, too.
  [[nodiscard]] World& get() {
    check();
    if (replay_) fail("a recording moves this world", "world", "next() goes on with it");
    return run_ ? run_->world() : *own_;
  }
  [[nodiscard]] const std::optional<Replay>& replay() const { return replay_; }
  [[nodiscard]] WorldRun* run() {
    check();
    return run_ ? &*run_ : nullptr;
  }
  [[nodiscard]] const Setup& setup() const { return *setup_; }
  [[nodiscard]] bool is_closed() const { return is_closed_; }
  void close();

  void step(std::size_t count, std::optional<double> dt);
  int advance(double real_dt);
  /// Makes the calls of a recording up to and with the next one that took steps; false if there is none.
  bool next();
  bool seek(std::uint64_t steps);
  [[nodiscard]] std::span<const Event> events() const { return events_; }
  [[nodiscard]] const std::vector<ThingHit>& hits() const { return hits_; }
  [[nodiscard]] const std::vector<WallHit>& wall_hits() const { return wall_hits_; }
  bool moved_by(const std::function<bool(physim::Replay&)>& move);
  void forget() { events_.clear(), hits_.clear(), wall_hits_.clear(); }

  [[nodiscard]] const std::vector<Function>& functions() const { return functions_; }
  /// Keeps a function of Python, so that what it raises comes out of step().
  const Function& keep(nb::object function, const char* name);
  /// The index of an environment of this world; it is added where it is new.
  std::uint32_t environment(const Environment& environment);
  KindId kind(const ScenarioShot& shot, const Setup& setup, bool asks = false);

 private:
  void check() const {
    if (is_closed_) fail("the world is closed", "world");
    const std::thread::id stepping = stepping_.load();
    if (stepping != std::thread::id() && stepping != std::this_thread::get_id())
      fail("another thread steps the world", "world", "take turns, as by a threading.Lock");
  }
  void take_events();
  [[nodiscard]] bool has_raised() const;
  void raise_kept();

  /// Marks the thread that steps.
  class Stepping;

  SetupPtr setup_;
  std::optional<World> own_;
  std::optional<WorldRun> run_;
  std::optional<Replay> replay_;
  std::vector<Function> functions_;
  std::vector<Environment> environments_;
  std::vector<Event> events_;   // of the last steps
  std::vector<ThingHit> hits_;  // of the last steps of a run
  std::vector<WallHit> wall_hits_;
  std::atomic<std::thread::id> stepping_{};
  bool is_closed_ = false;
};

/// A question of a scene to a function of Python, which answers for all segments at once.
[[nodiscard]] EngineQuery engine_query(const Function& function);

}  // namespace physim::python
