// WorldImpl: the parts of a world and what its files share.
#pragma once

#include "model/attitude.hpp"
#include "physim/auto_fidelity.hpp"
#include "physim/world.hpp"
#include "world/forced_step.hpp"
#include "world/recorder.hpp"
#include "world/settle.hpp"
#include "world/state.hpp"

namespace physim {

struct WorldImpl {
  explicit WorldImpl(const WorldDef& definition);

  WorldDef def;
  Registry registry;
  WorldState state;
  AutoFidelityCache answers;  // remembers what it would answer anyway
  TaskRunner* lent = nullptr;
  std::unique_ptr<TaskRunner> own_threads;
  StepScratch scratch;
  std::uint64_t moments = 0;  // snapshots taken
  std::unique_ptr<Recorder> recorder;
  /// Hashes of what never changes: the definition, and each kind on each of its rungs.
  std::uint64_t def_hash = 0;
  std::vector<std::vector<std::uint64_t>> kind_hashes;
  mutable ForcedScratch forced_scratch;

  // ------------------------------------------------------------------------------------------- slots
  /// The slot of a projectile that is alive; null otherwise.
  [[nodiscard]] const Slot* find(ProjectileId id) const { return state.find(id); }
  [[nodiscard]] Slot* find(ProjectileId id) { return const_cast<Slot*>(std::as_const(*this).find(id)); }
  [[nodiscard]] ProjectileId id_of(std::uint32_t slot) const { return {slot, state.slots[slot].generation}; }
  [[nodiscard]] Rows& rows_of(const Slot& slot) { return state.rows[slot.cohort]; }
  [[nodiscard]] const Rows& rows_of(const Slot& slot) const { return state.rows[slot.cohort]; }
  [[nodiscard]] const Kind& kind_of(const Slot& slot) const { return registry.kind(slot.kind); }
  [[nodiscard]] BodyState state_of(const Slot& slot) const {
    const Rows& rows = rows_of(slot);
    return {rows.position(slot.row), rows.velocity(slot.row)};
  }
  /// In a loop over many projectiles: fetches what the next ones need while this one is worked on.
  void prefetch(std::span<const ProjectileId> ids, std::size_t at) const {
    constexpr std::size_t kSlots = 16, kRows = 4;  // so far ahead
    if (at + kSlots < ids.size() && ids[at + kSlots].index < state.slots.size())
      __builtin_prefetch(&state.slots[ids[at + kSlots].index]);
    if (at + kRows >= ids.size()) return;
    if (const Slot* slot = find(ids[at + kRows])) rows_of(*slot).prefetch(slot->row);
  }
  [[nodiscard]] const Own& own_of(std::uint32_t slot) const;
  Own& own(std::uint32_t slot);
  Tags& tags(std::uint32_t slot);
  [[nodiscard]] std::uint32_t layers_of(std::uint32_t slot) const;

  // ------------------------------------------------------------------------------------------- coming and going
  Result<ProjectileId> spawn(KindId kind, const Launch& launch, double delay);
  Result<ProjectileId> spawn(std::uint32_t kind, const Launch& launch, double delay);
  /// Refuses a state whose numbers the rung's precision cannot hold.
  [[nodiscard]] Status fits(const Slot& slot, const BodyState& at) const;
  [[nodiscard]] Result<std::uint16_t> rung_for(std::uint32_t kind, const Launch& launch);
  void push_due(std::vector<Due>& heap, double time, std::uint32_t slot);
  /// Takes out the next one alive that is due by now; null where there is none.
  ProjectileId take_due(std::vector<Due>& heap);
  std::uint32_t take_slot();
  void free_slot(std::uint32_t slot);
  /// Takes a projectile out of the world; the event is told before.
  void remove(std::uint32_t slot, LifeStatus status);
  void retire(std::uint32_t slot, Reason reason);
  [[nodiscard]] Status make_room(std::uint32_t pool);
  void link_to_pool(std::uint32_t slot, std::uint32_t pool);
  void unlink_from_pool(std::uint32_t slot, std::uint32_t pool);

  // ------------------------------------------------------------------------------------------- rows
  std::uint16_t cohort_for(const Slot& slot);
  /// Puts a projectile that has no row yet into its cohort.
  void place(std::uint32_t slot, const BodyState& at, const Launch& launch);
  /// Moves a projectile to where it belongs after its flags or rung changed.
  Status relocate(std::uint32_t slot);
  void take_out(Slot& slot);
  /// How a projectile points and turns at a launch; how it does now, and setting it, where its rung turns.
  [[nodiscard]] Attitude attitude_at_launch(const Slot& slot, const Vec3d& velocity, const Launch& launch) const;
  [[nodiscard]] std::optional<Attitude> attitude(std::uint32_t slot) const;
  void set_attitude(std::uint32_t slot, const Attitude& attitude);
  /// It stands still in W.
  void stop_turning(std::uint32_t slot);
  /// Of W in I, along body axes.
  [[nodiscard]] Vec3d omega_of_W(const Slot& slot, const Quatd& q_WB) const;
  /// What a row is filled from, beside the state.
  struct RowStart {
    Vec3d previous;                     // position
    const Launch* launch = nullptr;     // gives the plane of fire and the rail; else the velocity gives the plane ...
    const Body<double>* old = nullptr;  // ... and what the row was, the rail
    double age = 0;                     // time since launch as motors count it [s]
  };
  /// Fills a row anew: the models start from here.
  void write_row(std::uint32_t slot, const BodyState& at, const RowStart& start);
  /// The same anew, where its switches changed: its clock and its motor go on.
  void rewrite_row(std::uint32_t slot);
  Body<double> special_body(std::uint32_t slot, BodyState& at, const RowStart& start);
  static void start_spin(const BodyState& at, const RowStart& start, Body<double>& body);
  static void start_motor(const Conditions<double>& c, const BodyState& at, const RowStart& start, Body<double>& body);
  /// Puts a state into its row; closed forms start anew from it.
  void set_row_state(std::uint32_t slot, const BodyState& at);
  /// The numbers that the models read of one projectile, and its time since launch as they count it.
  [[nodiscard]] Body<double> body_of(const Slot& slot) const;
  [[nodiscard]] double clock_of(const Slot& slot) const;
  void rebase(double new_dt);

  // ------------------------------------------------------------------------------------------- changes
  void tell(EventKind kind, std::uint32_t slot, Reason reason = Reason::none);
  /// It is launched now; where its motor needs no waiting for, it burns.
  void tell_launch(std::uint32_t slot);
  bool put_to_sleep(std::uint32_t slot);
  bool wake(std::uint32_t slot);
  Status change_state(ProjectileId id, const BodyState& to);
  Status set_flag(ProjectileId id, std::uint32_t flag, bool on);
  Status change_fidelity(std::uint32_t slot, const Fidelity& asked);
  Status change_rung(std::uint32_t slot, std::uint16_t rung);
  bool uses_detail() const { return !state.detail.rungs.empty(); }
  void apply_detail();

  // ------------------------------------------------------------------------------------------- forces
  /// A generator acts on it that it can feel.
  [[nodiscard]] bool feels_forces(std::uint32_t slot) const;
  [[nodiscard]] bool is_target(std::uint32_t slot) const;
  void update_forced(std::uint32_t slot);
  /// Lets generators begin that start within the next dt; ends those that are over or act on nobody any more.
  void begin_generators(double dt);
  void end_generators();
  void begin_generator(std::uint32_t index);
  void end_generator(std::uint32_t index);
  /// What acts on its targets has changed: their cohorts follow, and who sleeps wakes.
  void stir_targets(const Generator& generator);
  void stir(std::uint32_t slot);
  void count_targets(const Generator& generator, bool on);
  Result<ForceId> add_force(const ForceDef& force);
  [[nodiscard]] Status refuses(const ForceDef& force) const;
  [[nodiscard]] Generator* find(ForceId force);
  Status remove_target(ForceId force, ProjectileId id);
  /// By all generators on one projectile now [N].
  [[nodiscard]] Vec3d generator_force(std::uint32_t slot) const;

  // ------------------------------------------------------------------------------------------- stepping
  void step(double dt);
  void launch_pending();
  void expire_old();
  void step_free(double dt);
  void step_forced(double dt);
  void turn(double dt);
  void finish_step();
  [[nodiscard]] TaskRunner& runner(std::size_t rows);

  // ------------------------------------------------------------------------------------------- moments
  [[nodiscard]] std::uint64_t hash();
  /// Numbers of snapshots as a recording counts them: the next one's, and that of one taken before.
  [[nodiscard]] std::uint64_t next_moment() const;
  [[nodiscard]] std::uint64_t recorded_moment(std::uint64_t moment);
};

}  // namespace physim
