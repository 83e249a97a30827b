// The table of joints: a row for each JointKind. It gives the name of a kind and what it keeps.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "base/enumerators.hpp"
#include "physim/world.hpp"

namespace physim {

struct JointRow {
  JointKind kind;
  std::string_view name;
  bool pulls = false;   // it keeps its ends from being farther apart than its length
  bool pushes = false;  // ... and from being nearer; what does neither, and does not slide, is a spring
  bool turns = false;   // it keeps them in a plane across its axis
  bool slides = false;  // ... on its axis
};

constexpr auto kJointTable = std::array{
    JointRow{.kind = JointKind::rod, .name = "rod", .pulls = true, .pushes = true},
    JointRow{.kind = JointKind::cable, .name = "cable", .pulls = true},
    JointRow{.kind = JointKind::spring, .name = "spring"},
    JointRow{.kind = JointKind::hinge, .name = "hinge", .pulls = true, .pushes = true, .turns = true},
    JointRow{.kind = JointKind::slider, .name = "slider", .slides = true},
};
static_assert(has_row_for_each(kJointTable, &JointRow::kind), "a kind has no row");

[[nodiscard]] constexpr const JointRow& row_of(JointKind kind) { return kJointTable[static_cast<std::size_t>(kind)]; }
/// True if a joint does not allow its present length. `more`: present length less the joint's own [m]; `slack`: the
/// difference that rounding explains [m].
[[nodiscard]] constexpr bool breaks(JointKind kind, double more, double slack) {
  return (row_of(kind).pulls && more > slack) || (row_of(kind).pushes && more < -slack);
}

}  // namespace physim
