// Which numbers of a Body the models of a cohort read: only those get columns.
#pragma once

#include <cstdint>
#include <vector>

#include "physim/fidelity.hpp"
#include "world/rows.hpp"

namespace physim {

/// What some projectiles have beside the plain models; part of a cohort's key, so that the others pay nothing.
struct Features {
  bool applied = false;        // ProjectileDef::force
  bool motor = false;          // ProjectileDef::motor
  bool rail = false;           // Launch::rail_length
  bool magnus_tables = false;  // MagnusDef::table
  bool spheres = false;        // Cd by Reynolds number
  bool bands = false;          // banded ballistic coefficients
  bool searched = false;       // a drag curve that fits no equal cells
  bool aero = false;           // aerodynamic coefficients beside drag
  bool aero_tables = false;    // ... that change with the Mach number
  bool aero_angles = false;    // ... or with the angle of attack
  bool gravity_scale = false;  // its own part of gravity
  bool frozen = false;         // axes along which it does not move
  bool launch_place = false;   // a rule asks how far it is from there

  bool operator==(const Features&) const = default;
};

/// The columns of a cohort.
[[nodiscard]] RowLayout layout_of(const Fidelity& granted, const Features& features);

/// Index of a number in Body<S>.
template <class Member>
[[nodiscard]] std::uint8_t body_field(Member Body<double>::*member, unsigned part = 0) {
  static const Body<double> body{};
  const auto at = reinterpret_cast<const char*>(&(body.*member)) - reinterpret_cast<const char*>(&body);
  return static_cast<std::uint8_t>(static_cast<unsigned>(at) / sizeof(double) + part);
}

}  // namespace physim
