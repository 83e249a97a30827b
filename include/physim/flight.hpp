// Flight: a whole trajectory that can be asked at any time or range. fly(): computes one. fly_batch(): computes many.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "physim/accelerations.hpp"
#include "physim/collision.hpp"
#include "physim/departure.hpp"
#include "physim/environment.hpp"
#include "physim/event.hpp"
#include "physim/fidelity.hpp"
#include "physim/frames.hpp"
#include "physim/infinity.hpp"
#include "physim/projectile.hpp"
#include "physim/quat.hpp"
#include "physim/result.hpp"
#include "physim/vec3.hpp"
#include "physim/weather.hpp"

namespace physim {

class Scene;

/// The numerical error allowed.
struct Tolerance {
  std::optional<double> relative{};    ///< adaptive integrators: error per step, relative to |position| and |velocity|;
                                       ///< none: 1e-9, in float32 2e-6 [-]
  double absolute = 1e-9;              ///< adaptive integrators: error per step where these are near zero: the whole is
                                       ///< sqrt(absolute^2 + (relative |y|)^2) [m, m/s]
  double step = 0;                     ///< fixed-step integrators; 0: heun and rk4 by pilot flights, others 1/60 s or
                                       ///< what strong drag allows [s]
  double position_error = 1e-3;        ///< what pilot flights keep along the whole flight [m]
  double max_step = kInfinity;         ///< adaptive integrators never step further [s]
  std::int64_t max_steps = 1'000'000;  ///< then the flight ends with Outcome::step_limit [-]
};

/// When a flight ends. Ground and time always guard it; the earliest terminal event ends it.
struct Until {
  std::optional<double> ground = 0.0;  ///< height of the ground above the origin; none: no ground [m]
  double time = 3600;                  ///< after launch [s]
  std::optional<double> range{};       ///< along the line of sight [m]
  std::vector<EventSpec> events{};     ///< further events, at most 24 [-]
  const Scene* scene = nullptr;  ///< things that it meets on its way; null: none. It must stay, and stay as it is,
                                 ///< while the call runs, and is not read any more afterwards [-]
  ContactDef contact{};          ///< how it meets them, and what it does then [-]
};

/// How a flight ended.
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
  /// State at a time [s]; times outside 0..duration() give the nearer end, what is no number the start. At the time of
  /// a bounce it is that after it.
  [[nodiscard]] Sample at(double time) const;
  /// State where the flight first crosses a range [m] along the line of sight; an error where it never does.
  [[nodiscard]] Result<Sample> at_range(double range) const;
  /// State where the flight first rises (or falls) through a height [m].
  [[nodiscard]] Result<Sample> at_height(double height, Crossing direction = Crossing::any) const;
  [[nodiscard]] Sample end() const { return at(duration()); }
  /// Acceleration by effect at a time [s].
  [[nodiscard]] Accelerations accelerations(double time) const;
  /// How fast the acceleration changes along the path at a time [s], by differences of the models (model/jerk.hpp)
  /// [m/s^3].
  [[nodiscard]] Vec3d jerk(double time) const;

  /// What flew, with the fidelity that was granted to it.
  [[nodiscard]] const ProjectileDef& projectile() const;
  /// How it goes on from a time [s] in a world (World::spawn()); an error for a flight that was refused, and on a
  /// launch rail. Spin drift, which is only added to the path, is in the place and the velocity.
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
  /// Bore elevation above the horizon, as given or as found for the zero range [rad].
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

/// How one shot of a batch ended.
struct ShotResult {
  Outcome outcome = Outcome::refused;  ///< [-]
  double time = 0;                     ///< of flight [s]
  Vec3d position{};                    ///< at the end [m]
  Vec3d velocity{};                    ///< at the end [m/s]
  FlightCost cost{};                   ///< [-]
};

/// How one shot of a batch points and turns at its end.
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
/// bit; but apexes, ignition, burnout and rail exit are events of a batch only where Until asks for them. All shots
/// share one fidelity, tolerance and set of events; an automatic step (Tolerance::step = 0) is found by pilot flights
/// of a few of the shots, which makes it shorter than the step that fly() would find for one of them.
/// `weather`: what of the environment differs from shot to shot; such shots share packs as others do.
/// `runner`: whose threads fly it (make_thread_pool(), or an engine's own); null: the caller's alone. Numbers, events
/// and their order do not depend on it. Functions of the environment (Wind::field, Environment::force) are then called
/// from all of its threads at once.
[[nodiscard]] BatchResult fly_batch(std::span<const Shot> shots, const Environment& environment,
                                    const Fidelity& fidelity, const Tolerance& tolerance = {}, const Until& until = {},
                                    TaskRunner* runner = nullptr, const Weather& weather = {});
/// Flies many launches of one projectile, which is checked and prepared once; where it is bad, all are refused.
[[nodiscard]] BatchResult fly_batch(const ProjectileDef& projectile, std::span<const Launch> launches,
                                    const Environment& environment, const Fidelity& fidelity,
                                    const Tolerance& tolerance = {}, const Until& until = {},
                                    TaskRunner* runner = nullptr, const Weather& weather = {});
/// Flies into a result of before: all of it is written anew, its memory is used again.
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
/// place and, times its greatest speed, in time; found by flying the shot at several steps against a reference. An
/// error, which tells what was reached, where tolerance.max_steps or a million steps of all these flights come first.
[[nodiscard]] Result<double> pilot_step(const ProjectileDef& projectile, const Launch& launch,
                                        const Environment& environment, const Fidelity& fidelity,
                                        const Tolerance& tolerance, const Until& until);

/// Instruction sets this build and machine can fly with, best first; "scalar" is a loop over plain numbers.
[[nodiscard]] std::vector<std::string> kernels();
/// Chooses the instruction set for all that flies later; "" chooses the best. The environment variable PHYSIM_KERNEL
/// does the same at start. False where the machine or the build does not have it.
bool use_kernel(const std::string& name);

}  // namespace physim
