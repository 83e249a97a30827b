// Saves: all of a world as bytes. Custom forces are the only thing that is not in them.
//
// A save is its magic and format, the length of what follows (8 bytes), that, and a check sum of it (8).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physim/world.hpp"

namespace physim {

struct WorldImpl;

[[nodiscard]] Result<std::vector<std::byte>> save_of(const WorldImpl& world);
[[nodiscard]] Result<std::shared_ptr<WorldImpl>> loaded(std::span<const std::byte> save, const LoadOptions& options);
/// How many custom forces a save has; an error where it is none, or damaged.
[[nodiscard]] Result<std::size_t> custom_forces_of(std::span<const std::byte> save);

}  // namespace physim
