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
  bool pushes = false;  // ... and from being nearer; one that does neither is a spring
};

constexpr auto kJointTable = std::array{
    JointRow{.kind = JointKind::rod, .name = "rod", .pulls = true, .pushes = true},
    JointRow{.kind = JointKind::cable, .name = "cable", .pulls = true},
    JointRow{.kind = JointKind::spring, .name = "spring"},
};
static_assert(kJointTable.size() == kEnumerators<JointKind>, "the last kinds have no row");
static_assert(
    [] {
      for (std::size_t i = 0; i < kJointTable.size(); ++i)
        if (static_cast<std::size_t>(kJointTable[i].kind) != i) return false;
      return true;
    }(),
    "rows stand in the order of their kinds");

[[nodiscard]] constexpr const JointRow& row_of(JointKind kind) { return kJointTable[static_cast<std::size_t>(kind)]; }
/// Whether ends that are so much farther apart than its length (negative: nearer) break what a joint keeps. `slack`:
/// what does not count. All in m.
[[nodiscard]] constexpr bool breaks(JointKind kind, double more, double slack) {
  return (row_of(kind).pulls && more > slack) || (row_of(kind).pushes && more < -slack);
}

}  // namespace physim
