// Values of settings as text that reads back as the same value, bit for bit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenario/schema.hpp"

namespace physim {

/// Hands over the settings of effective_settings() one by one: a scenario of many shots has very many.
void each_setting(const Scenario& scenario,
                  const std::function<void(const std::string& path, const std::string& value)>& take);

/// As effective_settings(), with values as they stand in a file: texts in quotes.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> settings_in_file(const Scenario& scenario);

/// The keys of each element of a list of tables of a scenario ("shot", "thing"), a line each, without their headers.
[[nodiscard]] std::vector<std::string> element_texts(const Scenario& scenario, std::string_view list);

/// The value of a setting as the right side of an override; nothing where there is nothing to say (a preset).
[[nodiscard]] std::optional<std::string> written(const Entry& entry, const Scope& scope);

/// As it stands in a file: texts and quantities in quotes.
[[nodiscard]] std::optional<std::string> written_in_file(const Entry& entry, const Scope& scope);

}  // namespace physim
