// Placement: where projectiles lie, in rows of cohorts, and their moves between them.
#pragma once

#include <optional>

#include "model/attitude.hpp"
#include "physim/flight.hpp"
#include "world/core/closed_form_law.hpp"
#include "world/core/registry.hpp"
#include "world/core/state.hpp"

namespace physim {

/// Fills and moves the rows of a world's state. It has no state.
class Placement {
 public:
  Placement(Registry& registry, WorldState& state) : registry_(registry), state_(state) {}

  /// The cohort of a slot's kind, rung and switches; kNoCohort where there are too many.
  std::uint16_t cohort_for(const Slot& slot);
  /// Puts a projectile that has no row yet into its cohort; `birth`: when it is launched, if that is not now [s].
  void place(std::uint32_t slot, const BodyState& at, const Launch& launch, double elevation,
             std::optional<double> birth = {});
  /// One that was just placed is on its way already.
  void depart(std::uint32_t slot, const Departure& from);
  /// Moves a projectile to where it belongs after its flags or rung changed.
  Status relocate(std::uint32_t slot);
  /// The laws by which the cohorts' closed forms fly, by cohort.
  [[nodiscard]] std::vector<ClosedFormLaw> closed_forms() const;
  /// Moves a projectile to where it belongs now that its environment is another one; `before`: the laws until now.
  void follow_environment(std::uint32_t slot, const std::vector<ClosedFormLaw>& before);
  /// Takes its row out of its cohort.
  void take_out(Slot& slot);
  /// How a projectile points and turns at a launch; how it does now, and setting it, where its rung turns.
  [[nodiscard]] Attitude attitude_at_launch(const Slot& slot, const Vec3d& velocity, const Launch& launch,
                                            double elevation) const;
  [[nodiscard]] std::optional<Attitude> attitude(std::uint32_t slot) const;
  void set_attitude(std::uint32_t slot, const Attitude& attitude);
  /// Makes a projectile with a flown attitude stand still in W.
  void stop_turning(std::uint32_t slot);
  /// Angular velocity of W in inertial space, along body axes.
  [[nodiscard]] Vec3d omega_of_W(const Slot& slot, const Quatd& q_WB) const;
  /// What a row is filled from, beside the state.
  struct RowStart {
    Vec3d previous;                     // position
    const Launch* launch = nullptr;     // gives the bore, the plane of fire and the rail; else the velocity does ...
    const Body<double>* old = nullptr;  // ... and what the row was, the rail
    double age = 0;                     // time since launch as motors count it [s]
    double elevation = 0;               // of the launch's bore above the horizon [rad]
    std::optional<double> birth{};      // time of the launch; none: as its age says [s]
  };
  /// Fills a row again: the models start from here.
  void write_row(std::uint32_t slot, const BodyState& at, const RowStart& start);
  /// Fills a row again after its switches changed: its clock and its motor continue.
  void rewrite_row(std::uint32_t slot);
  /// The numbers of a row that do not follow from its kind and rung, as a save holds them; the other way round, false
  /// where they make no sense.
  [[nodiscard]] std::vector<double> saved_numbers(std::uint32_t slot) const;
  [[nodiscard]] bool put_saved(std::uint32_t slot, const std::vector<double>& numbers);
  /// Puts a state into its row; closed forms start again from it.
  void set_row_state(std::uint32_t slot, const BodyState& at);
  /// As set_row_state(). The way of the last step is carried along, so that what is drawn between two steps moves on by
  /// it behind the jump and not across the jump.
  void jump(std::uint32_t slot, const BodyState& to);
  /// The numbers that the models read of one projectile, and its time since launch as they count it.
  [[nodiscard]] Body<double> body_of(const Slot& slot) const;
  [[nodiscard]] double clock_of(const Slot& slot) const;
  /// Before a step: rows count steps of this length from here on, where it is another one than before.
  void rebase(double new_dt);

 private:
  /// Fills a row again; the place of its launch stays.
  void refill_row(std::uint32_t slot, const BodyState& at, const RowStart& start);
  void relaunch(std::uint32_t slot);
  Body<double> special_body(std::uint32_t slot, BodyState& at, const RowStart& start);

  Registry& registry_;
  WorldState& state_;
};

/// Whether the projectile of a row belongs where it lies, and moves.
[[nodiscard]] bool is_in_place(const Registry& registry, const WorldState& state, std::uint16_t cohort,
                               std::uint32_t row);

}  // namespace physim
