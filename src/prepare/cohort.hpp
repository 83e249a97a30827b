// Cohort: everything that flights of equal fidelity and environment share, checked, granted and ready to compute.
#pragma once

#include <memory>

#include "model/drag_curves.hpp"
#include "model/sight.hpp"
#include "model/spin_drift.hpp"
#include "physim/air.hpp"
#include "physim/flight.hpp"
#include "solve/lanes.hpp"

namespace physim {

/// Refuses bad input with a place and a hint; nothing where all is well.
[[nodiscard]] Status check(const ProjectileDef& projectile);
[[nodiscard]] Status check(const Launch& launch);
/// What neither of them can say alone; both are sound by themselves.
[[nodiscard]] Status check(const ProjectileDef& projectile, const Launch& launch);
[[nodiscard]] Status check(const Environment& environment);
[[nodiscard]] Status check(const Tolerance& tolerance, const Fidelity& fidelity);
[[nodiscard]] Status check(const Until& until);

/// What of the asked fidelity this projectile in this environment can have.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment);
/// The same, with a note where it leaves out the rail of the launch.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment, const Launch& launch);

/// Environment and granted rungs, ready to compute. Curves and flags come with the projectiles.
[[nodiscard]] Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted);
[[nodiscard]] Conditions<float> to_float(const Conditions<double>& conditions);

/// Whether a flight ends at the lower end of the standard atmosphere.
[[nodiscard]] bool has_lowest_altitude(const Fidelity& granted);

/// The events of a flight: those asked for; ground, range, time and the lower end of the air as terminal ones; apexes
/// and what happens to motors and on rails where `with_all`.
[[nodiscard]] WatchList prepare_watch(const Until& until, const Conditions<double>& conditions, bool with_all);

[[nodiscard]] bool has_motor(const ProjectileDef& projectile);
/// It has data of lift by spin.
[[nodiscard]] bool has_magnus(const ProjectileDef& projectile);
/// Turns the spin of a launch into W.
void prepare_spin(const Launch& launch, const Vec3d& forward, const Vec3d& right, Body<double>& body);
/// Whether motors and launch rails are part of a fidelity.
[[nodiscard]] bool flies_motors(const Fidelity& granted);
/// Puts a body on its launch rail, which lies along the bore; without one the bore says where a resting nose points.
void prepare_rail(const Launch& launch, const Vec3d& bore, Conditions<double>& conditions, Body<double>& body);

/// A projectile ready to compute but for its launch; adds its drag curve to the pool and its flags to the conditions.
[[nodiscard]] Body<double> prepare_kind(const ProjectileDef& projectile, CurvePool& pool,
                                        Conditions<double>& conditions);
/// Launches it with a bore elevation above the horizon [rad]; a rail comes with the launch, and its flag.
void put_launch(const ProjectileDef& projectile, const Launch& launch, double elevation, Conditions<double>& conditions,
                Body<double>& body);
/// A projectile launched: prepare_kind() and put_launch().
[[nodiscard]] Body<double> prepare_body(const ProjectileDef& projectile, const Launch& launch, double elevation,
                                        CurvePool& pool, Conditions<double>& conditions);

/// What of it only rungs that turn read, but for the launch, its tables added to the pool.
[[nodiscard]] Rotor<double> prepare_rotor_kind(const ProjectileDef& projectile, CurvePool& pool,
                                               Conditions<double>& conditions);
/// How it turns at launch; `body` is launched already.
void put_launch(const ProjectileDef& projectile, const Launch& launch, double elevation, const Body<double>& body,
                const Conditions<double>& conditions, Rotor<double>& rotor);
/// Both.
[[nodiscard]] Rotor<double> prepare_rotor(const ProjectileDef& projectile, const Launch& launch, double elevation,
                                          const Body<double>& body, CurvePool& pool, Conditions<double>& conditions);

/// The quadratic drag that equals the drag equation where a projectile is: its wind, bands, air and curve included. It
/// stands in where k1 and k2 are asked for and not given.
class EquivalentDrag {
 public:
  EquivalentDrag(const ProjectileDef& projectile, const Body<double>& body, const Conditions<double>& conditions);
  [[nodiscard]] double k2_per_mass(const State<double>& s);  // [1/m]

 private:
  Body<double> body_;
  Conditions<double> conditions_;
  CurvePool pool_;
};

/// Litz's aerodynamic jump, where it is granted: turns the launch velocity up or down.
void jump_in_crosswind(const ProjectileDef& projectile, const Environment& environment,
                       const Conditions<double>& conditions, Body<double>& body);
[[nodiscard]] SpinDrift prepare_spin_drift(const ProjectileDef& projectile, double launch_speed,
                                           const Environment& environment, const Fidelity& granted);

template <class S>
[[nodiscard]] StepPlan<S> prepare_plan(const Tolerance& tolerance, const Fidelity& granted, double step);

/// Bodies with the data they point to, in the cohort's precision.
struct Cohort {
  FidelityInUse in_use;
  CurvePool pool;
  Conditions<double> conditions;
  std::vector<float> rows_float;
  Conditions<float> conditions_float;

  /// Points the conditions to the finished pool; call after all projectiles are prepared and after every move.
  void finish();

  template <class S>
  [[nodiscard]] const Conditions<S>& conditions_in() const {
    if constexpr (sizeof(S) == 4) return conditions_float;
    if constexpr (sizeof(S) == 8) return conditions;
  }
  template <class S>
  [[nodiscard]] Course<S> course(const Tolerance& tolerance, double step, const WatchList& watch) const {
    return {&conditions_in<S>(), &conditions, prepare_plan<S>(tolerance, in_use.fidelity, step), watch,
            corners_matter()};
  }
  [[nodiscard]] bool corners_matter() const;
};

/// The bore elevation that a launch asks for: its own, or that of its zero range.
[[nodiscard]] Result<double> elevation_of(const ProjectileDef& projectile, const Launch& launch,
                                          const Environment& environment, const Fidelity& fidelity);
/// The fixed step to use, 0 for adaptive integrators and closed forms; nothing where a pilot flight must find it.
[[nodiscard]] std::optional<double> step_without_pilot(const Fidelity& granted, const Tolerance& tolerance);
/// The step, at most `longest` [s], with which a shot ends within `error_allowed` [m] of a reference flight.
[[nodiscard]] Result<double> step_within(const ProjectileDef& projectile, const Launch& launch,
                                         const Environment& environment, const Fidelity& granted,
                                         const Tolerance& tolerance, const Until& until, double error_allowed,
                                         double longest);

/// How a flight ends that is over before it begins: it starts on or below the ground and descends, or below the air.
[[nodiscard]] std::optional<Outcome> ends_at_once(const Conditions<double>& conditions, const Body<double>& body,
                                                  const Until& until);

}  // namespace physim
