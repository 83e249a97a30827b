// Fidelity in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physim/fidelity.hpp"

namespace physim::report {

struct FidelityField {
  std::string_view effect;
  std::string_view rung;
};

/// Every field of a fidelity with the name of its value.
[[nodiscard]] std::vector<FidelityField> fidelity_fields(const Fidelity& fidelity);

/// The name of the preset that a fidelity equals, or "custom".
[[nodiscard]] std::string preset_name(const Fidelity& fidelity);

/// "force motion, tsit5, constant gravity, ...": all rungs in one line.
[[nodiscard]] std::string in_words(const Fidelity& fidelity);

/// "drag off where equation was asked: there is no air".
[[nodiscard]] std::string note_text(const FidelityNote& note);

/// An effect whose rung differs between two fidelities.
struct RungApart {
  std::string_view effect;
  std::string_view full, rung;  // of the fuller one, and of the other
};
/// The effects in which `fidelity` differs from `full`. Neither the integrator nor the precision is physics.
[[nodiscard]] std::vector<RungApart> rungs_apart(const Fidelity& full, const Fidelity& fidelity);

/// Why flights of the two part, for people: "no drag, no lift from spin, flat earth"; empty if nothing is left out.
[[nodiscard]] std::string why_apart(const Fidelity& full, const Fidelity& fidelity);

/// The physics in which `fidelity` differs from `full`, as "drag off; air vacuum"; empty for none. Neither the
/// integrator nor the precision is physics.
[[nodiscard]] std::string physics_left_out(const Fidelity& full, const Fidelity& fidelity);

}  // namespace physim::report
