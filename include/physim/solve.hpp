// Solving: questions asked backwards, fits, and the cheapest fidelity that is true enough.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physim/environment.hpp"
#include "physim/fidelity.hpp"
#include "physim/flight.hpp"
#include "physim/projectile.hpp"
#include "physim/result.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Asking backwards: aim() finds the directions that hit a target, max_range() the one that carries farthest.

/// The target of a shot: a point, standing or moving, by its place when the shot is fired.
struct Target {
  Vec3d position{};      ///< at launch, in W [m]
  Vec3d velocity{};      ///< at launch [m/s]
  Vec3d acceleration{};  ///< constant [m/s^2]

  /// The place of the target at a time after launch [s].
  [[nodiscard]] Vec3d at(double time) const;
  /// Its velocity then [m/s].
  [[nodiscard]] Vec3d velocity_at(double time) const;

  bool operator==(const Target&) const = default;
};

/// The choice among the ways to a target.
enum class Arc {
  low,   ///< the one of the shortest time of flight
  high,  ///< the one of the longest
  both,
};

/// The options of aim().
struct AimOptions {
  Arc arc = Arc::both;             ///< solutions that are looked for [-]
  double tolerance = 0.01;         ///< a path that passes so near to the target hits it [m]
  std::optional<double> ground{};  ///< height of ground that stops the shot; none: no ground [m]
  double time = 600;               ///< longest time of flight [s]
  Tolerance flight{};              ///< of the flights [-]
  const Scene* scene = nullptr;  ///< things that may stand in the way; null: none. It must stay while the call runs [-]
  ContactDef contact{};          ///< of it collision.radius, collision.layers and scene_time are read [-]
  InstanceId target_thing{};     ///< the thing of the scene to be hit, which blocks no path; or none [-]
};

/// A direction that was flown, and how it passed the target.
struct AimSolution {
  Launch launch{};           ///< with the elevation and azimuth found, and a plain sight: fly() it to see it hit [-]
  double miss = 0;           ///< distance between projectile and target where they are closest, as flown [m]
  double time = 0;           ///< of flight, to there [s]
  Vec3d position{};          ///< of the projectile there [m]
  Vec3d velocity{};          ///< of the projectile there [m/s]
  double speed = 0;          ///< |velocity| [m/s]
  double descent = 0;        ///< angle of the path there, downwards positive [rad]
  std::int64_t flights = 0;  ///< trajectories flown to find it [-]
};

/// A way to the target that something stands in.
struct BlockedWay {
  AimSolution solution{};  ///< as it hits where nothing stands [-]
  Event hit{};             ///< on the thing in the way, and its place [-]
};

/// The answer of aim().
struct Aim {
  std::optional<AimSolution> low{};   ///< of the shortest time of flight, where it was asked for [-]
  std::optional<AimSolution> high{};  ///< of the longest; equal to `low` where only one exists [-]
  AimSolution nearest{};              ///< the closest that any flight came; a solution, where there is one [-]
  bool behind_ground = false;         ///< paths hit the target, but only through AimOptions::ground [-]
  std::vector<BlockedWay>
      blocked{};  ///< ways to the target that something of AimOptions::scene stands in, low first [-]
  std::optional<Event> sight_ends{};  ///< EventKind::hit that hides the target from the muzzle; none: nothing does [-]
  std::int64_t flights = 0;           ///< trajectories flown in all; those that find a fixed step are not counted [-]
  FidelityInUse fidelity_in_use{};    ///< of the flights [-]

  [[nodiscard]] bool in_reach() const { return low || high; }
  /// "hit in 2.18 s, ..." or "out of reach: the nearest path passes 12 m from the target".
  [[nodiscard]] std::string explanation() const;
};

/// Finds the bore elevation and azimuth with which a projectile of launch.speed hits a target, flown with the models of
/// `fidelity`. Elevation, azimuth and sight of `launch` are not read. Every solution was flown, and its path passes
/// within options.tolerance. If no path does, the answer has the nearest one that was found. Returns an error for bad
/// input, and if all flights together take more than five million steps or 20 million evaluations of forces.
///
/// A rocket may start from rest on a rail: the ways to the target of the shortest and of the longest time are found,
/// of those that a fan of flights over all elevations shows.
///
///   const auto answer = aim(shell, {.speed = 300}, {}, Fidelity::simulation(), {.position = {5000, 120, 300}});
///   if (answer && answer->low) fire(answer->low->launch);
[[nodiscard]] Result<Aim> aim(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                              const Fidelity& fidelity, const Target& target, const AimOptions& options = {});

/// The answer of max_range().
struct MaxRange {
  double elevation = 0;  ///< of the bore above the horizon [rad]
  /// Along the ground, from below the muzzle to the point of impact; below 0 if that lies behind the muzzle [m].
  double range = 0;
  double time = 0;           ///< of flight [s]
  Vec3d position{};          ///< of impact [m]
  Vec3d velocity{};          ///< at impact [m/s]
  std::int64_t flights = 0;  ///< trajectories flown [-]
};

/// The bore elevation that carries farthest ahead over even ground that rises with `slope` [rad] in the direction of
/// fire, launch.azimuth, and lies at the height `ground` [m] below or at the muzzle. An error where there is no
/// farthest: the shot does not come down within `time` [s]; and where all flights together take more than five million
/// steps or 20 million evaluations of forces.
[[nodiscard]] Result<MaxRange> max_range(const ProjectileDef& projectile, const Launch& launch,
                                         const Environment& environment, const Fidelity& fidelity, double ground = 0,
                                         double slope = 0, double time = 3600);

/// Ranges along the line of sight between which a flight stays near a height over it.
struct DangerSpace {
  double from = 0;                ///< [m]
  double to = 0;                  ///< [m]
  bool ends_with_flight = false;  ///< the path still lies within it at its end [-]
};

/// The ranges around `range` [m] within which a target of a height [m], aimed at in its middle, is hit by a flight that
/// passes its middle at `range`: the path lies within half the height of where it is there. It ends where the path
/// turns back along the line of sight, and with the flight.
[[nodiscard]] Result<DangerSpace> danger_space(const Flight& flight, double range, double height);
/// ... of a target that stands on the ground of a scene at time 0: the ranges around `range` within which the path lies
/// no more than `height` [m] above the nearest surface below it, of things of these layers but for sensors. It is
/// looked at each quarter of the height along the path; where a step of the ground is narrower, it may be missed. Ends
/// with the flight. An error where the path lies higher at `range`, or over no ground.
[[nodiscard]] Result<DangerSpace> danger_space(const Flight& flight, double range, double height, const Scene& ground,
                                               std::uint32_t layers = 0xffffffff);

/// Time of flight [s] to a range [m] along the line of sight of `launch`, with its elevation or its zero range.
[[nodiscard]] Result<double> time_to_range(const ProjectileDef& projectile, const Launch& launch,
                                           const Environment& environment, const Fidelity& fidelity, double range);

// ---------------------------------------------------------------------------------------------------------------------
// Fitting: the drag of a projectile, and its muzzle speed, from what was measured of its flight.

/// Measured figures of a flight at one range; at least one of them.
struct Measurement {
  double range = 0;               ///< along the line of sight [m]
  std::optional<double> speed{};  ///< [m/s]
  std::optional<double> drop{};   ///< above the line of sight, below it negative [m]
  std::optional<double> time{};   ///< of flight [s]
};

/// The fitted quantities, and the errors of measurements: figures count by their deviation over their error.
struct FitOptions {
  bool muzzle_speed = false;  ///< fits launch.speed, too [-]
  double speed_error = 1;     ///< of measured speeds [m/s]
  double drop_error = 0.01;   ///< of measured drops [m]
  double time_error = 1e-3;   ///< of measured times [s]
};

/// One figure as measured and as computed by what was fitted.
struct FitResidual {
  std::size_t measurement = 0;  ///< its index [-]
  std::string quantity{};       ///< "speed", "drop" or "time" [-]
  double measured = 0;          ///< [m/s, m or s]
  double computed = 0;          ///< [m/s, m or s]
};

/// A fitted projectile.
struct Fit {
  ProjectileDef projectile{};            ///< as given, its drag scaled [-]
  Launch launch{};                       ///< as given, with the muzzle speed fitted [-]
  double scale = 1;                      ///< drag of the fitted projectile over that of the given one [-]
  double scale_error = 0;                ///< standard error; 0 without more figures than unknowns [-]
  double muzzle_speed_error = 0;         ///< standard error, as scale_error; 0 if it is not fitted [m/s]
  double rms = 0;                        ///< of the residuals over their errors; about 1 where the errors are right [-]
  std::vector<FitResidual> residuals{};  ///< in the order of the measurements [-]
  std::int64_t flights = 0;              ///< trajectories flown [-]
};

/// Finds by how much the drag of a projectile must be scaled for its flight to come nearest to measurements, in the
/// sense of least squares. What is scaled is what the projectile has: its ballistic coefficients (by 1 / scale),
/// without them the form factor (a scale on its drag curve); k1 and k2; the exponent of its damping. An error if the
/// measurements make no sense, are too few, do not depend on drag, or need a drag beyond 1/1000 to 1000 times the given
/// one, or if all flights together take more than five million steps or 20 million
/// evaluations of forces.
[[nodiscard]] Result<Fit> fit_drag(const ProjectileDef& projectile, const Launch& launch,
                                   const Environment& environment, const Fidelity& fidelity,
                                   std::span<const Measurement> measurements, const FitOptions& options = {});

// ---------------------------------------------------------------------------------------------------------------------
// SUVAT: motion in a straight line under constant acceleration. Three of its five quantities give the other two.

/// All five quantities of one motion: v = u + a t, s = u t + a t^2 / 2. Each may have either sign.
struct Suvat {
  double s = 0;  ///< displacement from the start, between 0 and t [m]
  double u = 0;  ///< velocity at time 0 [m/s]
  double v = 0;  ///< velocity at time t [m/s]
  double a = 0;  ///< acceleration, constant [m/s^2]
  double t = 0;  ///< time since the start; negative: before it [s]
};

/// The quantities that are known: exactly three. Each is 0, or its size lies between 1e-50 and 1e50.
struct SuvatGiven {
  std::optional<double> s{};  ///< as Suvat::s [m]
  std::optional<double> u{};  ///< as Suvat::u [m/s]
  std::optional<double> v{};  ///< as Suvat::v [m/s]
  std::optional<double> a{};  ///< as Suvat::a [m/s^2]
  std::optional<double> t{};  ///< as Suvat::t [s]
};

/// Returns every motion that has the given quantities, by rising time: one, or two where s and a are given with one of
/// the velocities, as a ball thrown upwards passes a height twice. An error if no motion has them, if any number of
/// motions has, or if there are not three.
[[nodiscard]] Result<std::vector<Suvat>> suvat(const SuvatGiven& given);

// ---------------------------------------------------------------------------------------------------------------------
// Auto fidelity: chooses a fidelity by purpose. cheapest_within() finds the cheapest rungs that stay within an error of
// the truth over a time of flight, by flying them; AutoFidelityCache remembers the answer for each kind of projectile.

/// The purpose of a flight: its largest error, and the time over which it must hold.
struct Purpose {
  double error = 0.01;             ///< largest distance from the truth, at any time of the flight [m]
  double time = 2;                 ///< of flight [s]
  double step = 1.0 / 60;          ///< a frame: what a fixed step is, and what an adaptive one never exceeds;
                                   ///< 0: steps are free, and found for each integrator [s]
  std::optional<double> ground{};  ///< height where flights end and stay; none: no ground [m]
  Motion least_motion = Motion::closed_form;       ///< never less; `force` where forces will be added [-]
  Precision least_precision = Precision::float32;  ///< never less [-]
  Fidelity truth = Fidelity::reference();  ///< models that errors are measured against; flown by dop853 in float64 [-]
  Tolerance tolerance{};                   ///< of the adaptive integrators to choose from; `step` is not read [-]
};

/// A fidelity that was flown, and what came out.
struct FidelityTrial {
  Fidelity fidelity{};    ///< as granted [-]
  double step = 0;        ///< fixed step, 0: none [s]
  double error = 0;       ///< largest distance from the truth; infinite where the flight failed [m]
  double cost = 0;        ///< floating-point operations for a second of flight; float64 counts twice [1/s]
  std::string lowered{};  ///< "drag", "integrator", ...: the truth with this one rung lowered; empty: a candidate [-]
  bool within = false;    ///< whether it keeps the error [-]
};

/// The answer of cheapest_within().
struct AutoFidelity {
  Fidelity fidelity{};       ///< the cheapest that keeps the error [-]
  double step = 0;           ///< its fixed step, 0: none [s]
  double error = 0;          ///< its largest distance from the truth, as measured, <= purpose.error [m]
  double cost = 0;           ///< floating-point operations for a second of flight; float64 counts twice [1/s]
  double truth_cost = 0;     ///< the same, of the truth at the same frames [1/s]
  double truth_error = 0;    ///< uncertainty of the truth itself, by its numbers [m]
  double time = 0;           ///< longest flight that was compared, at most purpose.time [s]
  bool ended_early = false;  ///< the search had used up its steps: the fidelity is the truth's own [-]
  Purpose purpose{};         ///< as asked [-]
  std::vector<FidelityTrial> trials{};  ///< all that was flown, in that order [-]

  /// "the cheapest within 1 cm over 2 s: measured 4.2 mm, 38 times cheaper than the reference".
  [[nodiscard]] std::string explanation() const;
  /// The explanation as a note for FidelityInUse.
  [[nodiscard]] FidelityNote note() const;
  /// The tolerance with which fly() flies it as it was measured.
  [[nodiscard]] Tolerance tolerance() const;
};

/// The cheapest fidelity with a flight within purpose.error [m] of the truth. Error is the largest distance between the
/// two at any time of the flight; one that has landed stays where it landed. An error if the input makes no sense, if
/// the truth itself is not known that well, or if no fidelity comes that near. All flights of a search together take at
/// most five million steps, some seconds; then the truth's own models are granted, stepped by purpose.tolerance, and
/// explanation() says so; an error where the true flights alone take more.
[[nodiscard]] Result<AutoFidelity> cheapest_within(const ProjectileDef& projectile, const Launch& launch,
                                                   const Environment& environment, const Purpose& purpose);
/// The cheapest fidelity for several launches at once; errors are the worst of them.
[[nodiscard]] Result<AutoFidelity> cheapest_within(const ProjectileDef& projectile, std::span<const Launch> launches,
                                                   const Environment& environment, const Purpose& purpose);

/// A flight as it was measured; its fidelity_in_use() says how it was chosen.
[[nodiscard]] Flight fly_chosen(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                                const AutoFidelity& chosen, const Until& until = {});

/// Chooses for this one flight, and flies it. Refused where nothing can be chosen.
[[nodiscard]] Flight fly_within(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                                const Purpose& purpose, const Until& until = {});

/// The launches that stand for all that are like one: corners and middle of a box of speeds (an eighth of an octave),
/// elevations (a sixteenth of a radian) and heights (above the ground a factor of two; without one 128 m) that it lies
/// in, with azimuth and place across rounded.
[[nodiscard]] std::vector<Launch> launch_class(const Launch& launch, std::optional<double> ground);

/// Answers of cheapest_within() for kinds of projectile: equal data, environment, purpose and class of launch; where
/// the environment has functions, equal launches. May be used from many threads at once. What it answers does not
/// depend on what it holds.
class AutoFidelityCache {
 public:
  using Answer = Result<std::shared_ptr<const AutoFidelity>>;

  /// Holds up to `capacity` answers; the least recently used one makes room.
  explicit AutoFidelityCache(std::size_t capacity = 256);
  ~AutoFidelityCache();
  AutoFidelityCache(AutoFidelityCache&&) noexcept;
  AutoFidelityCache& operator=(AutoFidelityCache&&) noexcept;

  /// The answer for the class of a launch, from memory where it was asked before.
  [[nodiscard]] Answer cheapest_within(const ProjectileDef& projectile, const Launch& launch,
                                       const Environment& environment, const Purpose& purpose);

  [[nodiscard]] std::size_t size() const;        ///< answers held
  [[nodiscard]] std::uint64_t computed() const;  ///< answers that had to be computed
  void clear();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// ---------------------------------------------------------------------------------------------------------------------
// Compare: one shot flown in several ways, each measured against one reference flight.

/// A way to fly a shot.
struct FlightSetting {
  Fidelity fidelity{};    ///< [-]
  Tolerance tolerance{};  ///< [-]
};

/// The tightest tolerance that double precision can keep.
inline constexpr Tolerance kReferenceTolerance{.relative = 1e-15, .absolute = 1e-15};

/// A flight beside the reference.
struct ComparedFlight {
  Flight flight;                ///< [-]
  std::string problem{};        ///< why it is not measured: refused, or it never came to its end; empty: it is [-]
  double end_distance = 0;      ///< between its end and that of the reference [m]
  double largest_distance = 0;  ///< between the two at any equal time; one that has landed stays there [m]
  double end_delay = 0;         ///< of its end after that of the reference [s]
};

/// The answer of compare().
struct Comparison {
  Flight reference;                       ///< [-]
  Launch launch{};                        ///< of all: the bore is where the reference zeroes it [-]
  std::vector<ComparedFlight> flights{};  ///< in the order of the settings [-]
};

/// Flies a shot in each of the ways and measures how far it comes from the reference. All share the bore of the
/// reference, so that a zero range is found once. An error where the reference is refused or never comes to an end.
[[nodiscard]] Result<Comparison> compare(const ProjectileDef& projectile, const Launch& launch,
                                         const Environment& environment, std::span<const FlightSetting> settings,
                                         const FlightSetting& reference = {Fidelity::reference(), kReferenceTolerance},
                                         const Until& until = {}, const Progress& progress = {});

}  // namespace physim
