// The six tests of the original's evaluation, as scenarios to be opened and fired from the menu.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "physim/result.hpp"

namespace physim::client {

class Client;

struct OriginalTest {
  std::string_view name;  // "3-drag"
  std::string_view title;
  std::string_view file;   // in scenarios/
  std::string_view plots;  // what is plotted, as in parse_plots()
};

[[nodiscard]] std::span<const OriginalTest> original_tests();

/// Opens a test by its name, fires its shots, and plots them over what was published.
[[nodiscard]] Status open_original_test(Client& client, std::string_view name);

/// Where a scenario that ships with the library lies.
[[nodiscard]] std::string shipped_scenario(std::string_view file);

}  // namespace physim::client
