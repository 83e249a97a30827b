// What the handles of the C interface stand for.
#pragma once

#include <charconv>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "capi/call.hpp"
#include "physim/physim.hpp"
#include "scenario/document.hpp"
#include "scenario/scenario.hpp"
#include "scenario/scene_maker.hpp"
#include "scenario/world_run.hpp"

namespace physim::capi {

/// Settings that passed all checks together, and the scene that they make.
struct Checked {
  Scenario scenario;
  std::optional<Scene> scene;  // that separate flights meet
};

/// physim_def: a document, and what was read from it since it changed.
struct Def {
  std::string file;
  Value document;
  WindFunction wind;
  ForceFunction field;

  Def() = default;
  Def(const Def& other) : file(other.file), document(other.document), wind(other.wind), field(other.field) {}
  Def& operator=(const Def&) = delete;

  /// Checked and kept until a setting changes.
  [[nodiscard]] Result<std::shared_ptr<const Checked>> checked() const;
  /// Calls f with the scenario as it is so far, whether or not its settings fit together.
  template <class F>
  [[nodiscard]] auto with_read(const F& f) const {
    const std::unique_lock lock(mutex_);
    using Answer = decltype(f(std::declval<Scenario&>()));
    if (const Status status = read_again(); !status) return Answer(status.error());
    return f(*read_);
  }
  Status set(std::string_view path, std::string_view value);
  /// What was read is out of date.
  void changed();

 private:
  [[nodiscard]] Status read_again() const;

  mutable std::mutex mutex_;
  mutable std::unique_ptr<Scenario> read_;
  mutable std::shared_ptr<const Checked> checked_;
};

/// The index of one of some named things, by its name or its number from 1; null: the first.
template <class List, class Name>
[[nodiscard]] Result<std::size_t> index_in(const List& list, const char* wanted, const char* what, const Name& name) {
  const std::string_view text = wanted != nullptr ? wanted : "1";
  for (std::size_t i = 0; wanted != nullptr && i < list.size(); ++i)
    if (name(list[i]) == text) return i;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size() && number >= 1 && number <= list.size())
    return number - 1;
  return Error{std::string("there is no such ") + what, std::string(text), "give its name, or its number from 1"};
}
[[nodiscard]] Result<std::size_t> shot_in(const Scenario& scenario, const char* shot);

struct FlightObject {
  Flight flight;
};

struct SceneObject {
  Scene scene;
  std::vector<InstanceId> things;  // that defs brought
};

struct WorldObject {
  bool lost = false;  // an exception came in the middle of a change
  std::optional<WorldRun> run;
  World own;
  std::vector<InstanceId> things;             // that defs brought
  std::map<std::string, EmitterId> emitters;  // by name, of those that calls added
  std::map<std::uint32_t, Launch> launches;   // by kind: as its shot says
  std::vector<std::byte> recording;
  std::optional<Replay> replay;  // that alone moves it

  [[nodiscard]] World& world() {
    PHYSIM_ASSERT(!replay);  // Call::look_at() refuses changes
    return run ? run->world() : own;
  }
  [[nodiscard]] const World& world() const { return replay ? replay->world() : run ? run->world() : own; }
};

struct SnapshotObject {
  Snapshot of_world;
  RunSnapshot of_run;
};

struct Bytes {
  std::vector<std::byte> bytes;
};

/// Threads; one call at a time has them.
struct Pool {
  std::unique_ptr<TaskRunner> runner;
  mutable std::mutex mutex;
};

/// The threads of a pool for the length of a call; none of a pool that is null.
class Lent {
 public:
  explicit Lent(std::shared_ptr<const Pool> pool) : pool_(std::move(pool)) {
    if (pool_ != nullptr) pool_->mutex.lock();
  }
  ~Lent() {
    if (pool_ != nullptr) pool_->mutex.unlock();
  }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;
  [[nodiscard]] TaskRunner* runner() const { return pool_ != nullptr ? pool_->runner.get() : nullptr; }

 private:
  std::shared_ptr<const Pool> pool_;
};

struct StudyObject {
  StudyPlan plan;
};
struct PartObject {
  StudyPart part;
};
struct FiguresObject {
  StudyResult result;
};

/// An event as the C interface has it.
[[nodiscard]] physim_event event_of(const Event& event);
/// Writes a part of a list of events.
void put_events(Call& call, std::span<const Event> events, std::size_t first, physim_event* into, std::size_t each,
                std::size_t room, std::size_t* count);

/// Functions of the caller's as those of the library.
[[nodiscard]] WindFunction wind_of(physim_wind_function function, void* user);
[[nodiscard]] ForceFunction field_of(physim_field_function function, void* user);

/// Columns of launches; checks are those of the library.
[[nodiscard]] LaunchColumns columns_of(const physim_launches& launches, std::size_t count);

/// A shot of a def with what its flights need.
struct CheckedShot {
  std::shared_ptr<const Checked> checked;
  std::size_t index = 0;

  [[nodiscard]] const Scenario& scenario() const { return checked->scenario; }
  [[nodiscard]] const ScenarioShot& shot() const { return scenario().shots[index]; }
  /// End conditions, with the scene that flights meet.
  [[nodiscard]] Until until() const;
};
/// The shot of a call; nothing after an error.
[[nodiscard]] std::optional<CheckedShot> shot_of(Call& call, const Def& def, const char* shot);

/// Refuses functions that are missing in their list.
void need_functions(Call& call, const physim_functions& functions);
/// What a save or a recording lacks.
[[nodiscard]] LoadOptions options_of(const physim_functions& functions);
[[nodiscard]] EngineQuery engine_of(physim_engine_function function, void* user);

}  // namespace physim::capi
