// Events of the particles of emitters in a step: lives that end, ages that are reached, and what sets off
// sub-emitters. All of it is noted in the world's EmitterScratch.
#pragma once

#include <optional>

#include "world/couple/emitter_step.hpp"

namespace physim {

class EmitterWatch {
 public:
  /// The step ends at `end` [s].
  EmitterWatch(WorldImpl& world, const SettleContext& context, double end);

  // ------------------------------------------------------------------------------------------- before the step
  void note_followed();
  void reach_ages();
  void end_lives();

  // ------------------------------------------------------------------------------------------- after it
  void watch(const Chunk& chunk);
  void watch(const Event& event);
  /// One was launched inside the step: emitters that follow it stood until then.
  void begin_following(std::uint32_t slot, double time);
  void follow_to_end();
  /// By a rule that is looked at when the step is over.
  void leave_now(std::uint32_t slot);
  void trigger_all(std::uint32_t emitter);
  void trigger(std::uint32_t slot, SubEvent on, double time, const BodyState& at, const Vec3d& normal,
               std::size_t only = ~0u);

  // ------------------------------------------------------------------------------------------- of one newborn
  /// The ages that one emitted `born` into the step reaches in it, and the end of its life there.
  void look_ahead(std::uint32_t slot, double born, double birth, double until);
  void end_life(std::uint32_t slot, std::optional<double> born, double time);
  /// From its birth to the end of the step.
  void fly_newborn(std::uint32_t slot, double born);
  /// Flies one emitted before the world's time, alone up to that time, by steps of the world.
  void grow_up(std::uint32_t slot, double birth, double dies);
  /// Whether particles of the past took as many steps as they may: no more are flown.
  [[nodiscard]] bool has_flown_most() const { return flown_ >= kMostStepsOfPast; }
  [[nodiscard]] double passed_at(double time) const { return std::clamp(time - context_.time, 0.0, context_.dt); }

 private:
  [[nodiscard]] bool is_known(std::uint32_t slot) const;
  [[nodiscard]] bool follows(const Emitter& e, std::uint32_t slot) const;
  [[nodiscard]] BodyState followed_state(const Slot& slot) const;
  std::optional<LedByLaunch> launch_of_followed(Emitter& e, const Slot& slot);
  void turn_followed(const Event& event);
  /// It leaves the world where its last event says, or at the end of the step.
  void leaves(std::uint32_t slot, const Event* last);
  void end_followed(std::uint32_t slot, const BodyState& at, double time);
  void depart(std::uint32_t slot, std::uint32_t emitter, const BodyState& at, double time);
  /// Where one is at a time inside of the step.
  std::optional<BodyState> flown_to(std::uint32_t slot, std::optional<double> born, double time);
  std::optional<BodyState> seen_at(std::uint32_t slot, std::optional<double> born, double time);
  void trigger_age(std::uint32_t slot, const BodyState& at, double time);
  /// Whether it is still there then. One for which no steps are left is retired.
  bool fly_in_parts(std::uint32_t slot, double from, double to, bool is_birth);
  void count_from(const Slot& slot, double step);
  void expire(std::uint32_t slot, const BodyState& at, double time);
  /// Takes the events of a row that was flown alone, and what follows from them; returns whether it left.
  bool tell_chunk();

  WorldImpl& w_;
  const SettleContext& context_;
  Emitters& all_;
  EmitterScratch& s_;
  double end_;               // of the step [s]
  bool is_any_led_ = false;  // an emitter may follow a particle that dies
  std::uint64_t flown_ = 0;  // steps of the past
};

}  // namespace physim
