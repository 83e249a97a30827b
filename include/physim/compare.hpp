// Compare: one shot flown in several ways, each measured against one reference flight.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "physim/environment.hpp"
#include "physim/fidelity.hpp"
#include "physim/flight.hpp"
#include "physim/progress.hpp"
#include "physim/projectile.hpp"
#include "physim/result.hpp"

namespace physim {

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
