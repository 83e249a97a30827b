// Recent files: the scenarios and recordings that were opened or saved last, kept in a file of a user's own.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace physim::client {

class RecentFiles {
 public:
  RecentFiles() = default;
  /// Reads the list out of a file with a path in each line; an empty list where there is none.
  explicit RecentFiles(const std::string& list);

  /// Reads the list anew, puts a file in front, and writes it. If it cannot be written, it is forgotten at the end.
  void add(const std::string& file);
  /// The last one first, with whole paths.
  [[nodiscard]] std::span<const std::string> files() const { return files_; }

 private:
  void read();

  std::string list_;
  std::vector<std::string> files_;
};

/// Where the list is: $XDG_STATE_HOME/physim/recent_files, or ~/.local/state/physim/recent_files; empty where there is
/// no home.
[[nodiscard]] std::string list_of_recent_files();

}  // namespace physim::client
