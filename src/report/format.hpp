// Every format that results can be written in, a row each. The options of the command line and their help, the endings
// of file names, and what is refused follow from the rows: a new format is a file that writes it and a row here.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "report/ladder.hpp"
#include "report/picture.hpp"
#include "report/records.hpp"
#include "report/replay_log.hpp"
#include "report/trajectory.hpp"
#include "report/world_log.hpp"

namespace physim::report {

/// What results are of.
enum class Subject { flights, world, ladder, replay, records };

struct Format {
  std::string_view name;          // "csv": its option is --csv
  std::string_view ending;        // of its files, ".csv"
  std::string_view other_ending;  // ".svg"; may be empty
  std::string_view what;          // it writes, where that is not all of the result: "what happened"
  std::string_view doc;           // "as CSV"
  LogParts world_parts = {};      // what it reads of the log of a world's run
  bool is_picture = false;

  // What makes the file of each subject. If it is null, `records` does; if that is null too, the format
  // cannot show the subject.
  Content (*flights)(const Flights& flights) = nullptr;
  Content (*world)(const WorldLog& log) = nullptr;
  Content (*ladder)(const LadderOfShot& ladder) = nullptr;
  Content (*replay)(const ReplayLog& log) = nullptr;
  Text (*records)(Records records) = nullptr;
  /// An error where it cannot show these flights; may be missing.
  Status (*check)(const FlownScenario& flown) = nullptr;
  /// An error where it cannot show the world of this scenario; may be missing.
  Status (*check_world)(const Scenario& scenario) = nullptr;
  /// Whether a scenario has what it shows; missing: every one has.
  bool (*scenario_has)(const Scenario& scenario) = nullptr;
};

[[nodiscard]] std::span<const Format> formats();
[[nodiscard]] bool can_write(const Format& format, Subject subject);

/// The format of a file by the ending of its name, among those that can write the subject.
[[nodiscard]] Result<const Format*> format_of_file(const std::string& path, Subject subject);

// The file's content, to be written while the subject is still there; only for formats that can write it.
[[nodiscard]] Content content_of(const Format& format, const Flights& flights);
[[nodiscard]] Content content_of(const Format& format, const WorldLog& log);
[[nodiscard]] Content content_of(const Format& format, const LadderOfShot& ladder);
[[nodiscard]] Content content_of(const Format& format, const ReplayLog& log);
[[nodiscard]] Content content_of(const Format& format, Records records);

/// Writes a text, or draws a picture, into a file.
[[nodiscard]] Status write_content(const std::string& path, const Content& content);

}  // namespace physim::report
