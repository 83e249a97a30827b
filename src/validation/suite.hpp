// What a suite is, and how suites read their folders and judge their flights.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "math/angles.hpp"
#include "physim/flight.hpp"
#include "validation/csv.hpp"
#include "validation/validate.hpp"

namespace physim::validation {

constexpr double kFoot = 0.3048;  // in which many figures are published [m]

/// A suite: its name, what it shows, its folder, the files that identify such a folder, and how to run it.
struct Suite {
  std::string_view name;
  std::string_view title;
  std::string_view gate;    ///< in words
  std::string_view folder;  ///< in the reference collection
  std::span<const std::string_view> files;
  void (*run)(const std::filesystem::path& folder, SuiteResult& result);
};

extern const Suite kClassicSuite;
extern const Suite kAnalyticSuite;
extern const Suite kUs76Suite;
extern const Suite kGravitySuite;
extern const Suite kBallisticsSuite;
extern const Suite kNescSuite;
extern const Suite kMccoySuite;
extern const Suite kSportsSuite;

/// All suites, in the order they run.
[[nodiscard]] std::span<const Suite* const> all_suites();
/// The suite of a name, or none.
[[nodiscard]] const Suite* find_suite(std::string_view name);

/// Reads the tables of a folder. Those that `compare` does not know, for which it gives false, are skipped; `otherwise`
/// says why.
void compare_tables(const std::filesystem::path& folder, std::span<const std::string_view> known, const char* otherwise,
                    SuiteResult& result, const std::function<bool(const CsvFile&, SuiteResult&)>& compare);
/// Files of a folder with an extension, by name; those of `known` that are there come first, in that order.
[[nodiscard]] std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                          std::span<const std::string_view> known,
                                                          std::string_view extension);
/// Why a flight cannot be judged: refused, ended otherwise than it should, or not flown the way that was asked for.
/// Empty: it can.
[[nodiscard]] std::string complaint(const Flight& flight, const Fidelity& asked);

}  // namespace physim::validation
