// Validation: computed figures against published or exact ones, suite by suite, and what came out as text.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "physim/result.hpp"
#include "report/style.hpp"

namespace physim::validation {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

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
  /// Error in units of the gate; infinite if the error is not finite.
  [[nodiscard]] double badness() const;
};

/// A published figure that differs from what it should be, and was compared as that.
struct Misprint {
  std::string figure;   ///< "test 3 as published, vy frame 44"
  std::string printed;  ///< the figure as it was published
  std::string instead;  ///< the figure that should stand there
  std::string reason;   ///< "sign lost"
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
  std::vector<Misprint> misprints;
  std::vector<Source> sources;
  std::vector<StateRow> states;  ///< where the cases ended, judged or not
  std::vector<StateRow> beside;  ///< how far others lie from them

  /// Adds a figure; `problem` says why it could not be computed, and is empty if it could.
  void compare(std::string case_name, std::string figure, double expected, double actual, double gate,
               std::string problem = {});
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

/// Which suites to run, and where their figures lie.
struct Request {
  std::vector<std::string> suites;  ///< names; none: all
  std::filesystem::path data;       ///< a folder with figures of one suite, or with a folder per suite
  bool must_be_complete = false;    ///< the folder must have figures of every suite
};

/// "classic, analytic, ...".
[[nodiscard]] std::string names_of_suites();

/// Runs suites; an error where figures are missing or cannot be read.
[[nodiscard]] Result<std::vector<SuiteResult>> validate(const Request& request, const Progress& progress = {});

[[nodiscard]] std::string json_text(const std::vector<SuiteResult>& results);
/// One line per case, or per figure.
[[nodiscard]] std::string table_text(const SuiteResult& result, bool every_figure, const report::Style& style);
/// The last line of a suite.
[[nodiscard]] std::string summary_text(const SuiteResult& result, const report::Style& style);
/// The Markdown report.
[[nodiscard]] std::string report_text(const std::string& command, const std::vector<SuiteResult>& results);

}  // namespace physim::validation
