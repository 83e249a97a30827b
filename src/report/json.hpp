// What JSON files of results have in common.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "report/flown.hpp"
#include "report/json_stream.hpp"

namespace physim::report {

/// Program, version, scenario with the notes about it, `more` among them, and all its settings: where a result came
/// from.
void add_provenance(JsonStream& out, const Scenario& scenario, std::span<const std::string> more = {});
/// Outcome, fidelity, events and cost of a flight.
[[nodiscard]] nlohmann::ordered_json flight_json(const Flight& flight, const Fidelity& asked);
/// A list of the defaults that mattered to a flight and that neither the file nor an override gave: with any of them a
/// little different it ends elsewhere. Null for flights of very many steps, and behind the first 20 shots.
[[nodiscard]] nlohmann::ordered_json assumed_json(const FlownScenario& flown, std::size_t shot);
/// The verdicts of the scenario's expectations.
void add_checks(JsonStream& out, const std::vector<Check>& checks);
/// A list of the three components.
[[nodiscard]] nlohmann::ordered_json vector_json(const Vec3d& v);
/// JSON as text; characters that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);
/// JSON without line breaks.
[[nodiscard]] std::string json_line(const nlohmann::ordered_json& json);

}  // namespace physim::report
