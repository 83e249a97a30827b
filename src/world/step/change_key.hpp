// Changes in the order in which they are carried out.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/assert.hpp"
#include "world/step/settle.hpp"

namespace physim {

/// Changes are carried out by slot; what comes first of those of one slot follows from their kinds. All that decides is
/// one number, with the place of the change in its list: they are sorted step after step.
struct ChangeKey {
  static constexpr int kSlot = 32, kKind = 30;  // bits below them

  static std::uint64_t of(const Change& c, std::size_t at) {
    PHYSIM_ASSERT(at < (std::size_t{1} << kKind) && static_cast<unsigned>(c.kind) < 4);
    return std::uint64_t{c.slot} << kSlot | static_cast<std::uint64_t>(c.kind) << kKind | at;
  }
  static std::uint32_t slot(std::uint64_t key) { return static_cast<std::uint32_t>(key >> kSlot); }
  static std::size_t at(std::uint64_t key) { return key & ((std::uint64_t{1} << kKind) - 1); }
};

}  // namespace physim
