// Auto fidelity: asks for a fidelity by purpose. cheapest_within() finds the cheapest rungs that stay within an error
// of the truth over a time of flight, by flying them; AutoFidelityCache remembers the answer for each kind of
// projectile.
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

/// What a flight is for: how far it may be off, and for how long.
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
  double truth_error = 0;    ///< what the truth itself is unsure of, by its numbers [m]
  double time = 0;           ///< longest flight that was compared, at most purpose.time [s]
  bool ended_early = false;  ///< the search had used up its steps: the fidelity is the truth's own [-]
  Purpose purpose{};         ///< what was asked [-]
  std::vector<FidelityTrial> trials{};  ///< all that was flown, in that order [-]

  /// "the cheapest within 1 cm over 2 s: measured 4.2 mm, 38 times cheaper than the reference".
  [[nodiscard]] std::string explanation() const;
  /// The explanation as a note for FidelityInUse.
  [[nodiscard]] FidelityNote note() const;
  /// With which fly() flies it as it was measured.
  [[nodiscard]] Tolerance tolerance() const;
};

/// The cheapest fidelity whose flight stays within purpose.error [m] of the truth. Error is the largest distance
/// between the two at any time of the flight; one that has landed stays where it landed. An error where the input makes
/// no sense, where the truth itself is not known so well, or where no fidelity comes so near. All flights of a search
/// together take at most five million steps, some seconds; then the truth's own models are granted, stepped by
/// purpose.tolerance, and explanation() says so; an error where the true flights alone take more.
[[nodiscard]] Result<AutoFidelity> cheapest_within(const ProjectileDef& projectile, const Launch& launch,
                                                   const Environment& environment, const Purpose& purpose);
/// The cheapest fidelity for several launches at once; errors are the worst of them.
[[nodiscard]] Result<AutoFidelity> cheapest_within(const ProjectileDef& projectile, std::span<const Launch> launches,
                                                   const Environment& environment, const Purpose& purpose);

/// A flight as it was measured; its fidelity_in_use() tells how it was chosen.
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

  /// Holds so many answers; the one not asked for the longest makes room.
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

}  // namespace physim
