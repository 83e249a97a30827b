// The materials of physim::materials by the names that files call them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "physim/scene.hpp"

namespace physim {

[[nodiscard]] std::span<const std::string_view> published_materials();
/// Nothing where none has this name.
[[nodiscard]] std::optional<Material> published_material(std::string_view name);

}  // namespace physim
