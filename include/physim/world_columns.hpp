// A world's projectiles as they lie in memory: for renderers and others that read all of them in every frame.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>

namespace physim {

/// Projectiles of one rung, a column for each coordinate; the i-th number of each column is of the i-th of them. R is
/// the precision in which they fly. Spans of the world's own memory: they hold until it is changed or steps.
template <class R>
struct ColumnsOf {
  std::span<const std::uint32_t> index{};        ///< ProjectileId::index; World::id_at() makes it one [-]
  std::array<std::span<const R>, 3> position{};  ///< x, y and z [m]
  std::array<std::span<const R>, 3> previous{};  ///< at the start of the last step, see segments() [m]
  std::array<std::span<const R>, 3> velocity{};  ///< [m/s]
};

using WorldColumns = std::variant<ColumnsOf<float>, ColumnsOf<double>>;

}  // namespace physim
