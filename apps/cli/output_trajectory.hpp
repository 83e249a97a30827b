// Trajectories as files: CSV for tables, JSON for programs.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flown.hpp"
#include "physim/result.hpp"

namespace physim::cli {

inline constexpr std::size_t kMaxSamples = 1'000'000;  // of all shots of a file together

/// The numbers of one row, in the order of the columns.
inline constexpr std::array<std::string_view, 14> kSampleColumns = {
    "t [s]",      "x [m]",      "y [m]",      "z [m]",       "vx [m/s]", "vy [m/s]",  "vz [m/s]",
    "ax [m/s^2]", "ay [m/s^2]", "az [m/s^2]", "speed [m/s]", "mach [-]", "mass [kg]", "thrust [N]"};
using SampleRow = std::array<double, kSampleColumns.size()>;
[[nodiscard]] SampleRow row_of(const Sample& sample);

/// Times of the samples of each shot: every multiple of the interval [s], and the end. Without an interval each shot
/// has a round one that gives 200 to 500 samples. An error where there would be too many.
[[nodiscard]] Result<std::vector<std::vector<double>>> sample_times(const std::vector<FlownShot>& shots,
                                                                    std::optional<double> interval);

using SampleTimes = std::vector<std::vector<double>>;
[[nodiscard]] std::string trajectories_csv(const std::vector<FlownShot>& shots, const SampleTimes& times);
[[nodiscard]] std::string trajectories_json(const FlownScenario& flown, const SampleTimes& times);

/// A value of a CSV file, in quotes where it needs them.
[[nodiscard]] std::string csv_field(const std::string& text);

/// Program, version, scenario and all its settings: where a result came from.
[[nodiscard]] nlohmann::ordered_json provenance(const Scenario& scenario);
/// Outcome, fidelity, events and cost of a flight.
[[nodiscard]] nlohmann::ordered_json flight_json(const Flight& flight, const Fidelity& asked);
/// The verdicts of the scenario's expectations.
[[nodiscard]] nlohmann::ordered_json checks_json(const std::vector<Check>& checks);
/// A list of the three components.
[[nodiscard]] nlohmann::ordered_json vector_json(const Vec3d& v);
/// JSON as text; characters that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace physim::cli
