// The files that a command is asked to write: an option for each format of results.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "physim/result.hpp"
#include "report/format.hpp"

namespace physim::cli {

class Command;
using namespace report;

/// A path for each of formats(), in their order; empty: not asked for, "-": the standard output.
struct Outputs {
  std::vector<std::string> paths = std::vector<std::string>(formats().size());
  std::string record;  // of worlds

  [[nodiscard]] bool use_stdout() const;
  void forget(const Format& format);
  /// Those that were asked for.
  [[nodiscard]] std::vector<const Format*> asked() const;
  [[nodiscard]] const std::string& path_of(const Format& format) const;
};

/// "--csv", the option of a format.
[[nodiscard]] std::string option_of(const Format& format);

/// An option for each format that can write one of the subjects. `what` is written: "the trajectories".
void add_output_options(Command& command, Outputs& outputs, const std::string& what, std::span<const Subject> subjects);

/// Returns an error if an output path is not writable, or if a picture needs gnuplot and it is missing. Nothing is
/// written.
[[nodiscard]] Status check(const Outputs& outputs);
/// Announces the files that an option writes beside those that options name (FilesInUse).
[[nodiscard]] Status announce(const Outputs& outputs, const std::string& option);
[[nodiscard]] Status announce(const std::string& file, const std::string& option);
/// An error where a format was asked for that cannot write the subject.
[[nodiscard]] Status check_subject(const Outputs& outputs, Subject subject, const std::string& why,
                                   const std::string& hint);

/// Writes what was asked for: pictures first, which may fail for many reasons.
[[nodiscard]] Status write(const Outputs& outputs, const std::function<Content(const Format&)>& make);

/// Writes a file, or to the standard output where the path is "-".
[[nodiscard]] Status write_output(const std::string& path, const Text& text);
/// An error where a file of this path could not be written.
[[nodiscard]] Status check_output(const std::string& path);

/// A folder for a file of each format that can write the subject, all named `stem`.
[[nodiscard]] Outputs outputs_in(const std::string& folder, const std::string& stem, Subject subject);

/// The first error of several steps; later steps are not taken.
template <class... Steps>
[[nodiscard]] Status in_turn(Steps&&... steps) {
  Status status;
  static_cast<void>((... && (status = steps()).ok()));
  return status;
}

}  // namespace physim::cli
