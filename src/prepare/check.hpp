// What users give is refused where it is bad, with a place and a hint; nothing is returned where all is well.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physim/flight.hpp"

namespace physim {

inline constexpr double kShortestStep = 1e-9;  // a part of a shorter one is nothing [s]

/// The first mistake of an input. Files ask for all of them, each in its place: `all` is filled where it is not null.
[[nodiscard]] Status check(const ProjectileDef& projectile, std::vector<Error>* all = nullptr);
/// check() of a projectile whose own drag curve is known to be right.
[[nodiscard]] Status check_but_curve(const ProjectileDef& projectile);
[[nodiscard]] Status check(const Launch& launch, std::vector<Error>* all = nullptr);
/// What neither of them can say alone, where each is sound by itself.
[[nodiscard]] Status check(const ProjectileDef& projectile, const Launch& launch);
[[nodiscard]] Status check(const Environment& environment, std::vector<Error>* all = nullptr);
[[nodiscard]] Status check(const Tolerance& tolerance, const Fidelity& fidelity);
[[nodiscard]] Status check(const Until& until);
[[nodiscard]] Status check(const CombineDef& combine, std::string_view place);
[[nodiscard]] Status check(const ConveyorDef& conveyor, std::string_view place);
[[nodiscard]] Status check(const CollisionDef& collision, std::string_view place);
[[nodiscard]] Status check(const ContactDef& contact, const std::string& place);
/// Whether a place [m] and a velocity [m/s] are numbers in a precision.
[[nodiscard]] Status check_fits(const Vec3d& position, const Vec3d& velocity, Precision precision);

}  // namespace physim
