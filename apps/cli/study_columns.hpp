// Shots of a study one by one as columns of an HDF5 file, where the build found that library.
#pragma once

#include <cstdint>
#include <string>

#include "physim/result.hpp"
#include "physim/study.hpp"

namespace physim::cli {

/// An error where this build knows no HDF5, or the file could not be written.
[[nodiscard]] Status check_columns_file(const std::string& file);
/// Flies so many shards again and writes their shots: /inputs/PATH, /quantities/NAME and /hits/TARGET, a number of each
/// shot in the order of shots, with their units. The file is there whole or not at all.
[[nodiscard]] Status write_columns(const std::string& file, const std::string& title, const StudyPlan& plan,
                                   std::uint64_t shards, TaskRunner& threads);

}  // namespace physim::cli
