// Saves: all of a world as bytes. Functions of one's own are the only thing that is not in them.
//
// A save is its magic and format, the length of what follows (8 bytes), that, and a check sum of it (8).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "physim/world.hpp"

namespace physim {

struct WorldImpl;

[[nodiscard]] Result<std::vector<std::byte>> save_of(const WorldImpl& world);
[[nodiscard]] Result<std::shared_ptr<WorldImpl>> loaded(std::span<const std::byte> save, const LoadOptions& options);
/// How many functions a save has; an error if it is no save, or damaged.
[[nodiscard]] Result<FunctionCounts> functions_of(std::span<const std::byte> save);
/// Whether `given` has the needed number; `what`, "the save", has them.
[[nodiscard]] Status check_given(const FunctionCounts& needed, const LoadOptions& given, const std::string& what);

}  // namespace physim
