// Flight: one trajectory or many, and what can be asked of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "physim/environment.hpp"
#include "physim/event.hpp"
#include "physim/fidelity.hpp"
#include "physim/math.hpp"
#include "physim/projectile.hpp"
#include "physim/result.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Accelerations: what each effect does to a projectile at a moment.

/// Acceleration by effect. The effects add up to the total, the force on the projectile over its mass; but on the
/// `classic` integrator the total is the register of its loop: what the frame took over from the one before. Damping
/// acts there directly on the velocity, so that `drag` includes it and the register does not.
struct Accelerations {
  Vec3d gravity{};      ///< [m/s^2]
  Vec3d drag{};         ///< of `damping` ln(d) v, v through the air [m/s^2]
  Vec3d lift{};         ///< of balls, by their spin [m/s^2]
  Vec3d body{};         ///< by the attitude: drag of yaw, lift, Magnus force; of a yaw of repose too [m/s^2]
  Vec3d thrust{};       ///< of the motor [m/s^2]
  Vec3d coriolis{};     ///< [m/s^2]
  Vec3d centrifugal{};  ///< of a rotating round Earth, where it is no part of gravity [m/s^2]
  Vec3d applied{};      ///< by ProjectileDef::force, Environment::force and the generators of a world [m/s^2]
  Vec3d constraint{};   ///< reaction of planar flight, frozen axes, the launch rail and surfaces [m/s^2]
  Vec3d total{};        ///< as flown [m/s^2]
};

// ---------------------------------------------------------------------------------------------------------------------
// Departure: a projectile in flight, for a world to continue.

/// The attitude and angular velocity of a rigid body.
struct FlownAttitude {
  Quatd orientation{};       ///< q_WB: takes body axes (x forward, y up, z right) into W [-]
  Vec3d angular_velocity{};  ///< relative to inertial space, along body axes [rad/s]
};

/// State of a projectile that a world continues: already in flight, not launched there.
struct Departure {
  Vec3d position{};                         ///< in W [m]
  Vec3d velocity{};                         ///< in W [m/s]
  double age = 0;                           ///< since its launch: its motor and its own force have acted during it [s]
  Vec3d spin{};                             ///< of a ball, in W [rad/s]
  std::optional<FlownAttitude> attitude{};  ///< of a rigid body; none: along its path, without spin [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// Flight: a whole trajectory that can be asked at any time or range. fly(): computes one. fly_batch(): computes many.

class Scene;

/// The numerical error allowed.
struct Tolerance {
  std::optional<double> relative{};    ///< adaptive integrators: error per step, relative to |position| and |velocity|;
                                       ///< none: Fidelity::tolerance [-]
  std::optional<double> absolute{};    ///< adaptive integrators: error per step where these are near zero: the whole is
                                       ///< sqrt(absolute^2 + (relative |y|)^2); none: 1e-9, or Fidelity::tolerance if
                                       ///< that is less and relative is none [m, m/s]
  double step = 0;                     ///< fixed-step integrators; 0: heun and rk4 by pilot flights, others 1/60 s or
                                       ///< the step that strong drag allows [s]
  double position_error = 1e-3;        ///< kept by pilot flights along the whole flight [m]
  double max_step = kInfinity;         ///< adaptive integrators never step further [s]
  std::int64_t max_steps = 1'000'000;  ///< then the flight ends with Outcome::step_limit [-]
};

/// The end conditions of a flight. Ground and time always guard it; the earliest terminal event ends it.
struct Until {
  std::optional<double> ground = 0.0;  ///< height of the ground above the origin; none: no ground [m]
  double time = 3600;                  ///< after launch [s]
  std::optional<double> range{};       ///< along the line of sight [m]
  std::vector<EventSpec> events{};     ///< further events, at most 24 [-]
  const Scene* scene = nullptr;        ///< things that it meets on its way; null: none. It must stay unchanged
                                       ///< while the call runs, and is not read afterwards [-]
  ContactDef contact{};                ///< with them, and the response to it [-]
};

/// The outcome of a flight.
enum class Outcome {
  landed,         ///< reached the ground
  reached_range,  ///< reached Until::range
  event,          ///< reached a terminal event of Until::events
  time_limit,     ///< reached Until::time
  step_limit,     ///< took Tolerance::max_steps steps
  left_domain,    ///< reached -5 km, the lower end of the standard atmosphere
  non_finite,     ///< a number became infinite or NaN
  stalled,        ///< the step became too small to advance time
  refused,        ///< bad input; see Flight::error()
  hit,            ///< stopped by a thing of Until::scene, stuck in it, or came to rest on it
};

PHYSIM_UNORDERED(Outcome)

/// The flight went as far as it was asked to go.
constexpr bool ended_as_planned(Outcome outcome) {
  switch (outcome) {
    case Outcome::landed:
    case Outcome::reached_range:
    case Outcome::event:
    case Outcome::hit:
    case Outcome::time_limit: return true;
    case Outcome::step_limit:
    case Outcome::left_domain:
    case Outcome::non_finite:
    case Outcome::stalled:
    case Outcome::refused: return false;
  }
  return false;
}

/// The state at one time.
struct Sample {
  double time = 0;             ///< since launch [s]
  Vec3d position{};            ///< in W [m]
  Vec3d velocity{};            ///< in W [m/s]
  Vec3d acceleration{};        ///< in W [m/s^2]
  double speed = 0;            ///< |velocity| [m/s]
  double mach = 0;             ///< air speed over sound speed; 0 without a sound speed [-]
  double energy = 0;           ///< kinetic [J]
  double mass = 0;             ///< [kg]
  double thrust = 0;           ///< of the motor [N]
  double range = 0;            ///< along the line of sight [m]
  double drop = 0;             ///< above the line of sight, perpendicular to it, up positive [m]
  double windage = 0;          ///< right of the line of sight [m]
  Quatd orientation{};         ///< q_WB, where rotation is flown: takes body axes (x forward, y up, z right) into W [-]
  Vec3d angular_velocity{};    ///< relative to inertial space, along body axes, where rotation is flown [rad/s]
  double angle_of_attack = 0;  ///< total: of the body's x axis to the air, where rotation is flown [rad]
};

/// Stability of a spinning, symmetric body at small angles of attack.
struct Stability {
  double gyroscopic = 0;  ///< Sg: above 1 the spin holds the axis; negative where fins do [-]
  double dynamic = 0;     ///< Sd: yaw dies away where 1 / Sg < Sd (2 - Sd) [-]
};

/// Work done.
struct FlightCost {
  std::int64_t steps = 0;        ///< accepted [-]
  std::int64_t rejected = 0;     ///< tried and not accepted [-]
  std::int64_t evaluations = 0;  ///< of the acceleration by the integrator, dense output and stops aside [-]
};

struct FlightRecord;

/// A computed trajectory, as fly() makes it. Cheap to copy. Every question is answered from the dense output, without
/// flying again. One that was moved away, or is made of no record, is refused.
class Flight {
 public:
  explicit Flight(std::shared_ptr<const FlightRecord> record) : record_(record ? std::move(record) : none()) {}
  Flight(const Flight&) = default;
  Flight& operator=(const Flight&) = default;
  Flight(Flight&& other) noexcept : record_(std::exchange(other.record_, none())) {}
  Flight& operator=(Flight&& other) noexcept {
    record_.swap(other.record_);
    other.record_ = none();
    return *this;
  }
  ~Flight() = default;

  [[nodiscard]] Outcome outcome() const;
  /// Why a flight was refused; nothing otherwise.
  [[nodiscard]] const std::optional<Error>& error() const;

  [[nodiscard]] double duration() const;  ///< time of flight [s]
  /// State at a time [s]; times outside 0..duration() give the nearer end, NaN the start. At the time of a bounce it is
  /// the state after it.
  [[nodiscard]] Sample at(double time) const;
  /// State where the flight first crosses a range [m] along the line of sight; an error where it never does.
  [[nodiscard]] Result<Sample> at_range(double range) const;
  /// State where the flight first rises (or falls) through a height [m].
  [[nodiscard]] Result<Sample> at_height(double height, Crossing direction = Crossing::any) const;
  [[nodiscard]] Sample end() const { return at(duration()); }
  /// Acceleration by effect at a time [s].
  [[nodiscard]] Accelerations accelerations(double time) const;
  /// Rate of change of the acceleration along the path at a time [s], by differences of the models (model/jerk.hpp)
  /// [m/s^3].
  [[nodiscard]] Vec3d jerk(double time) const;

  /// The projectile that flew, with the fidelity that was granted to it.
  [[nodiscard]] const ProjectileDef& projectile() const;
  /// Its state at a time [s], for a world to continue (World::spawn()); an error for a flight that was refused, and on
  /// a launch rail. Spin drift, which is only added to the path, is in the place and the velocity.
  [[nodiscard]] Result<Departure> departure(double time) const;
  /// Stability at a time [s]; nothing where rotation is not flown, or without air or an overturning moment.
  [[nodiscard]] std::optional<Stability> stability(double time) const;

  /// The frames of the Earth that was flown over: where a sample is in geodetic, Earth-fixed, inertial or local terms.
  [[nodiscard]] EarthFrames earth_frames() const;
  /// Everything that happened, in order of time.
  [[nodiscard]] std::span<const Event> events() const;
  /// Times of the steps taken, first 0, last duration() [s].
  [[nodiscard]] std::vector<double> step_times() const;
  [[nodiscard]] const FidelityInUse& fidelity_in_use() const;
  [[nodiscard]] const FlightCost& cost() const;
  /// Bore elevation above the horizon before cant: as given, found for the zero range, or of the velocity [rad].
  [[nodiscard]] double elevation() const;
  /// Fixed step in use, 0 for adaptive integrators [s].
  [[nodiscard]] double step() const;

 private:
  [[nodiscard]] static std::shared_ptr<const FlightRecord> none() noexcept;  // of what was moved away
  std::shared_ptr<const FlightRecord> record_;
};

/// Computes one flight. Bad input gives a flight with Outcome::refused and an error; nothing throws.
[[nodiscard]] Flight fly(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                         const Fidelity& fidelity, const Tolerance& tolerance = {}, const Until& until = {});
/// Computes one flight at the projectile's own fidelity.
[[nodiscard]] Flight fly(const ProjectileDef& projectile, const Launch& launch, const Environment& environment = {});

class TaskRunner;

/// One shot of a batch.
struct Shot {
  ProjectileDef projectile{};  ///< [-]
  Launch launch{};             ///< [-]
};

/// The end of one shot of a batch.
struct ShotResult {
  Outcome outcome = Outcome::refused;  ///< [-]
  double time = 0;                     ///< of flight [s]
  Vec3d position{};                    ///< at the end [m]
  Vec3d velocity{};                    ///< at the end [m/s]
  FlightCost cost{};                   ///< [-]
};

/// The attitude and angular velocity of one shot of a batch at its end.
struct ShotAttitude {
  Quatd orientation{};       ///< as Sample::orientation [-]
  Vec3d angular_velocity{};  ///< as Sample::angular_velocity [rad/s]
};

/// An event of one shot of a batch.
struct ShotEvent {
  std::uint32_t shot = 0;  ///< index of the shot [-]
  Event event{};           ///< [-]
};

struct BatchResult {
  std::vector<ShotResult> shots{};        ///< in the order given [-]
  std::vector<ShotAttitude> attitudes{};  ///< of each shot, where rotation is flown; else empty [-]
  std::vector<ShotEvent> events{};        ///< by shot, then by time [-]
  std::string kernel{};                   ///< that flew the batch: "base", "avx2", "avx512" or "scalar" [-]
  FidelityInUse fidelity_in_use{};        ///< of the first shot that was not refused [-]
  std::optional<Error> error{};           ///< the first error among refused shots [-]
};

/// Flies many shots at once, in packs of lanes that are refilled as shots end. The numbers are those of fly(), bit for
/// bit; but apexes, ignition, burnout and rail exit are events of a batch only if Until requests them. All shots share
/// one fidelity, tolerance and set of events; an automatic step (Tolerance::step = 0) is found by pilot flights of a
/// few of the shots, which makes it shorter than the step that fly() would find for one of them.
/// `weather`: what of the environment differs from shot to shot; such shots share packs as others do.
/// `runner`: its threads fly the batch (make_thread_pool(), or an engine's own); null: the caller's alone. Numbers,
/// events and their order do not depend on it. Functions of the environment (Wind::field, Environment::force) are then
/// called from all of its threads at once.
[[nodiscard]] BatchResult fly_batch(std::span<const Shot> shots, const Environment& environment,
                                    const Fidelity& fidelity, const Tolerance& tolerance = {}, const Until& until = {},
                                    TaskRunner* runner = nullptr, const Weather& weather = {});
/// Flies many launches of one projectile, which is checked and prepared once; where it is bad, all are refused.
[[nodiscard]] BatchResult fly_batch(const ProjectileDef& projectile, std::span<const Launch> launches,
                                    const Environment& environment, const Fidelity& fidelity,
                                    const Tolerance& tolerance = {}, const Until& until = {},
                                    TaskRunner* runner = nullptr, const Weather& weather = {});
/// Flies into an existing result: all of it is overwritten, and its memory is reused.
void fly_batch(std::span<const Shot> shots, const Environment& environment, const Fidelity& fidelity,
               const Tolerance& tolerance, const Until& until, BatchResult& result, TaskRunner* runner = nullptr,
               const Weather& weather = {});
void fly_batch(const ProjectileDef& projectile, std::span<const Launch> launches, const Environment& environment,
               const Fidelity& fidelity, const Tolerance& tolerance, const Until& until, BatchResult& result,
               TaskRunner* runner = nullptr, const Weather& weather = {});

/// The bore elevation above the horizon [rad] with which the projectile hits the line of sight at a range [m]. It is
/// found with the models of `fidelity`, an adaptive integrator and float64, upright, without spin drift, and in calm
/// air where the sight says so; an error where no elevation gets there.
[[nodiscard]] Result<double> zero_elevation(const ProjectileDef& projectile, const Launch& launch,
                                            const Environment& environment, const Fidelity& fidelity, double range);

/// Miller's gyroscopic stability factor Sg at the muzzle, in the air of the origin [-]: below 1 a bullet tumbles, small
/// arms have 1.3 to 2. Nothing without a twist, a length or air. Source: model/spin_drift.hpp.
[[nodiscard]] std::optional<double> stability_factor(const ProjectileDef& projectile, const Launch& launch,
                                                     const Environment& environment);

/// Step [s] of a fixed-step integrator that keeps the error below tolerance.position_error along the whole flight, in
/// place and, times its greatest speed, in time; found by flying the shot at several steps against a reference. If
/// tolerance.max_steps or a million steps of all these flights come first, the error names what was reached.
[[nodiscard]] Result<double> pilot_step(const ProjectileDef& projectile, const Launch& launch,
                                        const Environment& environment, const Fidelity& fidelity,
                                        const Tolerance& tolerance, const Until& until);

/// Instruction sets this build and machine can fly with, best first; "scalar" is a loop over plain numbers.
[[nodiscard]] std::vector<std::string> kernels();
/// Chooses the instruction set for all that flies later; "" chooses the best. The environment variable PHYSIM_KERNEL
/// does the same at start. False where the machine or the build does not have it.
bool use_kernel(const std::string& name);

// ---------------------------------------------------------------------------------------------------------------------
// fly_columns(): batches with launches and ends as columns of numbers.

/// Launches of one projectile: what differs from shot to shot is a column, and the rest stands in `common` once. All
/// columns that are given have one length, the number of shots. A shot with an impossible number is refused alone.
struct LaunchColumns {
  Launch common{};                      ///< without a velocity: give a speed and angles [-]
  std::span<const double> x{};          ///< of Launch::position [m]
  std::span<const double> y{};          ///< upwards [m]
  std::span<const double> z{};          ///< [m]
  std::span<const double> speed{};      ///< [m/s]
  std::span<const double> elevation{};  ///< [rad]
  std::span<const double> azimuth{};    ///< [rad]
  /// In the place of DragDef::ballistic_coefficient, as rounds of one lot differ; above 0. Not read where the
  /// projectile has DragDef::bands, as fly() does not read it there [kg/m^2]
  std::span<const double> ballistic_coefficient{};
  /// In the place of DragDef::form_factor; above 0. Not read where there is a ballistic coefficient [-]
  std::span<const double> form_factor{};

  /// Number of shots: the length of the longest column; none are given: no shots.
  [[nodiscard]] std::size_t size() const {
    return std::max({x.size(), y.size(), z.size(), speed.size(), elevation.size(), azimuth.size(),
                     ballistic_coefficient.size(), form_factor.size()});
  }
  /// Whether shots differ in their projectiles' drag.
  [[nodiscard]] bool has_drag() const { return !ballistic_coefficient.empty() || !form_factor.empty(); }
  /// The launch of shot i < size().
  [[nodiscard]] Launch at(std::size_t i) const {
    Launch launch = common;
    if (!x.empty()) launch.position.x = x[i];
    if (!y.empty()) launch.position.y = y[i];
    if (!z.empty()) launch.position.z = z[i];
    if (!speed.empty()) launch.speed = speed[i];
    if (!elevation.empty()) launch.elevation = elevation[i];
    if (!azimuth.empty()) launch.azimuth = azimuth[i];
    return launch;
  }
  /// Writes the drag of shot i < size() over that of a projectile.
  void put(std::size_t i, ProjectileDef& own) const {
    if (!ballistic_coefficient.empty()) own.drag.ballistic_coefficient = ballistic_coefficient[i];
    if (!form_factor.empty()) own.drag.form_factor = form_factor[i];
  }
};

/// Output of the ends of the flights: columns as long as there are shots, in the caller's memory. Those left empty are
/// not wanted, and cost nothing. Of a shot that was refused all numbers are NaN. With Until::range a flight ends at a
/// range line, and these are drop, windage, time and speed there.
struct EndColumns {
  std::span<Outcome> outcome{};  ///< [-]
  std::span<double> time{};      ///< of flight [s]
  std::span<double> x{};         ///< of the end [m]
  std::span<double> y{};         ///< [m]
  std::span<double> z{};         ///< [m]
  std::span<double> vx{};        ///< velocity at the end [m/s]
  std::span<double> vy{};        ///< [m/s]
  std::span<double> vz{};        ///< [m/s]
  std::span<double> speed{};     ///< at the end [m/s]
  std::span<double> drop{};      ///< as Sample::drop: above the line of sight [m]
  std::span<double> windage{};   ///< as Sample::windage: right of the line of sight [m]
};

/// The return value of fly_columns(), beside the columns.
struct ColumnsResult {
  std::size_t refused = 0;          ///< shots [-]
  std::optional<Error> error{};     ///< the first of a shot refused, or of what all have in common [-]
  std::string kernel{};             ///< as BatchResult::kernel [-]
  FidelityInUse fidelity_in_use{};  ///< of the first shot that was not refused [-]
};

/// Flies launches of one projectile as fly_batch() does, with the same numbers, and writes what is asked for of how
/// they end. There are no events; watch them with fly_batch(). Columns of different lengths, or a velocity in
/// `launches.common`, refuse all; then nothing is written. Memory stays the same however many shots there are.
[[nodiscard]] ColumnsResult fly_columns(const ProjectileDef& projectile, const LaunchColumns& launches,
                                        const Environment& environment, const Fidelity& fidelity,
                                        const Tolerance& tolerance, const Until& until, const EndColumns& into,
                                        TaskRunner* runner = nullptr, const Weather& weather = {});

}  // namespace physim
