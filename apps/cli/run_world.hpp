// `physim run` of a scenario with a [world].
#pragma once

#include <optional>
#include <string>

#include "outputs.hpp"
#include "physim/scenario.hpp"

namespace physim::cli {

class Command;

/// Options that only worlds have.
struct WorldOptions {
  std::optional<std::uint64_t> steps;
  std::optional<std::uint32_t> threads;
  /// The first that was given, for messages; empty: none.
  [[nodiscard]] std::string given() const;
};
void add_world_options(Command& command, WorldOptions& options, Outputs& outputs);

/// Runs, prints and writes; into a folder too where it is not empty. `all_met` tells of the scenario's expectations.
[[nodiscard]] Status run_in_world(Scenario scenario, const Outputs& outputs, const std::string& folder,
                                  std::optional<double> interval, const WorldOptions& options, bool& all_met);

}  // namespace physim::cli
