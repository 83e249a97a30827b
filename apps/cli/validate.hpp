// physim validate: computed figures against published or exact ones. Shared by the suites and the printers.
#pragma once

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physim/flight.hpp"
#include "physim/result.hpp"

namespace physim::cli::validate {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Data that cannot be read, with its place: "file:line".
struct DataError {
  Error error;
};

/// One number that was compared.
struct Figure {
  std::string case_name;  ///< "linear_drag tsit5"
  std::string figure;     ///< "range_m v0=100 elev=45"
  double expected = 0;    ///< SI unit of the figure
  double actual = kNaN;   ///< same unit; NaN: could not be computed
  double gate = 0;        ///< allowed error, same unit
  std::string note;       ///< why it could not be computed

  [[nodiscard]] double error() const;
  [[nodiscard]] bool pass() const;
  /// Error in units of the gate; infinite where there is no number.
  [[nodiscard]] double badness() const;
};

/// Where the figures of one file come from.
struct Source {
  std::string file;  ///< name without folder
  std::string text;  ///< its own words
};

/// A row of numbers under the names of their columns.
struct StateRow {
  std::string name;  ///< "case 01", "case 01, NASA simulation 02"
  std::vector<std::pair<std::string, double>> columns;
};

/// What one suite found.
struct SuiteResult {
  std::string name;
  std::filesystem::path folder;
  std::vector<Figure> figures;
  std::vector<std::string> skipped;  ///< what was not compared, and why
  std::vector<Source> sources;
  std::vector<StateRow> states;  ///< where the cases ended, judged or not
  std::vector<StateRow> beside;  ///< how far others lie from them

  [[nodiscard]] std::size_t missed() const;
};

/// All figures of one case, summed up.
struct CaseSummary {
  std::string name;
  std::size_t figures = 0;
  std::size_t missed = 0;
  const Figure* worst = nullptr;
};
[[nodiscard]] std::vector<CaseSummary> summarize(const SuiteResult& result);

/// A suite: its name, what it shows, the folder it lives in, the files that tell such a folder, and how to run it.
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

// Printers, in validate_print.cpp.
[[nodiscard]] std::string json_text(const std::vector<SuiteResult>& results);
/// One line per case, or per figure.
[[nodiscard]] std::string table_text(const SuiteResult& result, bool every_figure);
/// The last line of a suite.
[[nodiscard]] std::string summary_text(const SuiteResult& result);
/// The Markdown report.
[[nodiscard]] std::string report_text(const std::string& command, const std::vector<SuiteResult>& results);

/// printf into a string.
[[nodiscard]] [[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);
/// Files of a folder with an extension, by name; those of `known` that are there come first, in that order.
[[nodiscard]] std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                          std::span<const std::string_view> known,
                                                          std::string_view extension);
/// Why a flight cannot be judged: refused, ended otherwise than it should, or not flown the way that was asked for.
/// Empty: it can.
[[nodiscard]] std::string complaint(const Flight& flight, const Fidelity& asked);

}  // namespace physim::cli::validate
