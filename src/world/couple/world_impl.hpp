// WorldImpl: the parts of a world and what its files share.
#pragma once

#include <functional>
#include <mutex>

#include "physim/solve.hpp"
#include "physim/world.hpp"
#include "world/core/joints.hpp"
#include "world/core/placement.hpp"
#include "world/core/recorder.hpp"
#include "world/core/state.hpp"
#include "world/couple/emitter_step.hpp"
#include "world/couple/pairs.hpp"
#include "world/step/forced_step.hpp"
#include "world/step/hit_asking.hpp"
#include "world/step/settle.hpp"

namespace physim {

/// How a projectile comes.
struct Coming {
  double delay = 0;                // pending until then [s]
  double age = 0;                  // time since its launch [s]
  std::optional<double> moment{};  // launched at that time, inside the step just taken [s]
  double gravity = 1;              // times that of its kind
  std::uint32_t emitter = 0;       // index of its emitter; 0: none
};

struct WorldImpl : Gate {
  explicit WorldImpl(const WorldDef& definition);
  ~WorldImpl() { recorder.reset(); }  // its sink may look at the world for the last time

  WorldDef def;
  Registry registry;
  WorldState state;
  Placement placement{registry, state};
  AutoFidelityCache answers;  // remembers what it would answer anyway
  TaskRunner* lent = nullptr;
  std::unique_ptr<TaskRunner> own_threads;
  StepScratch scratch;
  mutable std::mutex taking;          // of snapshots, which several threads may take
  mutable std::uint64_t moments = 0;  // snapshots taken
  mutable Living living;
  std::uint64_t def_hash = 0;
  mutable std::mutex showing;        // of events, which several threads may read
  mutable GivenEvents given_events;  // that are kept until the next step
  ForcedScratch forced_scratch;
  PairScratch pairs;
  EmitterScratch emitting;
  JointScratch jointed;
  HitAsking hit_asking{*this};
  Restless restless;        // things of the scene, in the step at hand
  bool is_stirred = false;  // no projectile that meets things sleeps

  // ------------------------------------------------------------------------------------------- slots
  /// The slot of a projectile that is alive; null otherwise.
  [[nodiscard]] const Slot* find(ProjectileId id) const { return state.slots.find(id); }
  [[nodiscard]] Slot* find(ProjectileId id) { return const_cast<Slot*>(std::as_const(*this).find(id)); }
  /// In a loop over many projectiles: fetches what the next ones need while this one is worked on.
  void prefetch(std::span<const ProjectileId> ids, std::size_t at) const {
    prefetch(ids.size(), at, [ids](std::size_t i) { return ids[i].index; });
  }
  template <class SlotOf>
  void prefetch(std::size_t count, std::size_t at, const SlotOf& slot_of) const {
    constexpr std::size_t kSlots = 16, kRows = 4;  // how far ahead
    if (at + kSlots < count) state.slots.prefetch(slot_of(at + kSlots));
    if (at + kRows >= count) return;
    const std::uint32_t index = slot_of(at + kRows);
    if (index == 0 || index >= state.slots.size() || !state.slots[index].is(kAlive)) return;
    state.rows_of(state.slots[index]).prefetch(state.slots[index].row);
  }
  Own& own(std::uint32_t slot);
  Tags& tags(std::uint32_t slot);
  [[nodiscard]] std::uint32_t layers_of(std::uint32_t slot) const;

  // ------------------------------------------------------------------------------------------- coming and going
  Result<std::uint32_t> find_or_add_kind(const ProjectileDef& projectile, const BodyDef& body) {
    if (body.collision.on_hit == OnHit::ask && !hit_asking.has_function())
      return Error{"asks, and nobody answers", "body.collision.on_hit", "World::set_hit_function() comes first"};
    return registry.find_or_add_kind(projectile, body, moments);
  }
  Result<ProjectileId> spawn(const ProjectileDef& projectile, const Launch& launch, const BodyDef& body,
                             const Coming& coming);
  Result<ProjectileId> spawn(KindId kind, const Launch& launch, const Coming& coming);
  Result<ProjectileId> spawn_of(std::uint32_t kind, const Launch& launch, const Coming& coming);
  Result<ProjectileId> spawn_in_memory(std::uint32_t kind, const Launch& launch, const Coming& coming);
  /// The elevation of a launch's bore above the horizon, for a launch that makes sense [rad].
  [[nodiscard]] Result<double> bore_of(const Kind& kind, const Launch& launch, double time) const;
  /// Refuses a state with numbers that the rung's precision cannot hold.
  [[nodiscard]] Status fits(const Slot& slot, const BodyState& at) const;
  [[nodiscard]] Result<std::uint16_t> rung_for(std::uint32_t kind, const Launch& launch, double time,
                                               const Coming& coming);
  /// Where a kind flies, by the clock of a launch at a time [s].
  [[nodiscard]] Environment surroundings_of(const Kind& kind, double time) const;
  /// Takes a projectile out of the world; the caller adds the event before.
  void remove(std::uint32_t slot, LifeStatus status);
  void retire(std::uint32_t slot, Reason reason);
  [[nodiscard]] Status make_room(std::uint32_t pool);

  // ------------------------------------------------------------------------------------------- changes
  /// Now, or at a time inside of the step just taken [s].
  void tell(EventKind kind, std::uint32_t slot, Reason reason = Reason::none, std::optional<double> moment = {},
            std::uint32_t value = 0);
  /// Keeps an event; those that were given out stay where they are.
  void keep_event(const Event& event) {
    if (may_keep_event()) state.events.add(event);
  }
  void keep_event(const PlainEvent& event) {
    if (may_keep_event()) state.events.add(event);
  }
  void keep_events(std::span<const PlainEvent> told);
  /// Whether there is room for one more; counts it if not.
  bool may_keep_event();
  /// How many more are kept now.
  [[nodiscard]] std::size_t room_for_events() const;
  void forget_events();
  /// A projectile comes, launched `age` ago [s]; if its motor has no delay, it is ignited by its launch.
  void tell_launch(std::uint32_t slot, const Coming& coming);
  bool put_to_sleep(std::uint32_t slot);
  /// Wakes a projectile and what sleeps at it; true if it slept.
  bool wake(std::uint32_t slot);
  /// Wakes it and nothing else, now or at a time inside of the step at hand [s]; true if it slept.
  bool wake_alone(std::uint32_t slot, std::optional<double> moment = {});
  /// Wakes these, and what sleeps at them, and so on.
  void wake_piled(std::vector<std::uint32_t> slots);
  /// Wakes sleepers with what sleeps at them, now or at the end of the step at hand.
  void disturb(const std::vector<std::uint32_t>& sleepers);
  /// Those that sleep where they touch one of their pile, in order of slots.
  [[nodiscard]] std::vector<std::uint32_t> sleepers_at(std::uint32_t slot) const;
  Status change_state(ProjectileId id, const BodyState& to);
  Status set_flag(ProjectileId id, std::uint32_t flag, bool on);
  Status change_own(std::uint32_t slot, const Own& to);
  template <class T>
  Status change_tag(ProjectileId id, T Tags::*tag, const T& to);
  /// Makes a change of its definition: it goes over to another kind.
  Status change_projectile(ProjectileId id, const std::function<void(ProjectileDef&)>& change);
  Status change_kind(std::uint32_t slot, std::uint32_t kind);
  Status change_fidelity(std::uint32_t slot, const Fidelity& asked);
  Status change_rung(std::uint32_t slot, std::uint16_t rung);
  bool uses_detail() const { return !state.detail.rungs.empty(); }
  void apply_detail();

  // ------------------------------------------------------------------------------------------- scene
  void put_scene(std::shared_ptr<Scene> scene);
  Scene& own_scene();
  template <class F>
  Status change_scene(InstanceId changed, const F& f);
  void stir_scene();
  void forget_clear();
  void notice(InstanceId changed);
  void find_restless(bool is_covered);
  void move_scene(double dt);
  template <class F>
  void each_sleeper(const F& f) const;

  // ------------------------------------------------------------------------------------------- forces
  /// A generator, or its emitter, acts on it that it can feel.
  [[nodiscard]] bool feels_forces(std::uint32_t slot) const;
  [[nodiscard]] bool is_target(std::uint32_t slot) const;
  /// Whether forces move it on its rung.
  [[nodiscard]] bool is_moved_by_forces(std::uint32_t slot) const;
  void update_forced(std::uint32_t slot);
  /// Starts generators that begin within the next dt; ends those that are over or have no target left.
  void begin_generators(double dt);
  void end_generators();
  void begin_generator(std::uint32_t index);
  void end_generator(std::uint32_t index);
  /// One of a save, that acts already.
  void resume_generator(std::uint32_t index);
  /// What acts on its targets has changed: their cohorts follow, and sleeping ones wake.
  void stir_targets(const Generator& generator);
  void stir(std::uint32_t slot);
  void count_targets(const Generator& generator, bool on);
  Result<ForceId> add_force(const ForceDef& force);
  [[nodiscard]] Status refuses(const ForceDef& force) const;
  [[nodiscard]] std::size_t felt_by(const Generator& generator) const;
  Status remove_target(ForceId force, ProjectileId id);
  /// By all generators on one projectile now, were it there [N], and the rate of the drag in it, times its mass [kg/s].
  [[nodiscard]] Vec3d generator_force(std::uint32_t slot, const BodyState& there, double* drag_rate = nullptr) const;
  /// By its emitter on the flight of a particle now [m/s^2].
  [[nodiscard]] Vec3d emitter_push(std::uint32_t slot) const;

  // ------------------------------------------------------------------------------------------- emitters
  [[nodiscard]] Status refuses(const EmitterDef& asked) const;
  /// What follows from a definition that makes sense.
  void equip(Emitter& emitter, const EmitterDef& asked, std::uint64_t seed) const;
  void play(std::uint32_t emitter);
  /// Restarts the play at hand, begun `time` ago [s].
  void seek(std::uint32_t emitter, double time);
  void begin_counting(Emitter& emitter) const;
  /// Births by distance are counted from where it began to play.
  void count_metres(Emitter& emitter) const;

  // ------------------------------------------------------------------------------------------- stepping
  void step(double dt);
  [[nodiscard]] SettleContext settle_context(double dt) {
    return {&def,
            &registry,
            &state,
            dt,
            state.clock.now(),
            state.clock.time(),
            state.scene.get(),
            nullptr,
            pairs.used,
            &hit_asking,
            restless.is_any() ? &restless : nullptr};
  }
  void launch_pending(const SettleContext& context);
  void expire_old();
  void step_free(double dt);
  void step_forced(double dt);
  void turn(double dt);
  void finish_step();
  /// What settling decided of one projectile.
  void carry_out(const Change& change);
  [[nodiscard]] TaskRunner& runner(std::size_t rows);

  // ------------------------------------------------------------------------------------------- moments
  [[nodiscard]] std::uint64_t hash() const;
  /// Numbers of snapshots as a recording counts them: the next one's, and that of one taken before.
  [[nodiscard]] std::uint64_t next_moment() const;
  [[nodiscard]] std::uint64_t recorded_moment(std::uint64_t moment);
};

}  // namespace physim
