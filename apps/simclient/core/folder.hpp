// Folder: the entries that a dialog lists, and the file that its text field names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace physim::client {

struct FolderEntry {
  std::string name, path;
  bool is_folder = false;
};

/// True if a name contains all words of a text, without regard to case.
[[nodiscard]] bool passes_filter(std::string_view name, std::string_view filter);

/// Folders, then scenarios and recordings, by name; the folder above first. Hidden ones are left out. A filter holds
/// for files alone. Nothing where it cannot be read.
[[nodiscard]] std::vector<FolderEntry> entries_of(const std::string& folder, std::string_view filter);

/// The path that a text means in a folder: itself where it is absolute, else under that.
[[nodiscard]] std::string path_in(const std::string& folder, const std::string& text);

/// The file that Enter opens: the path itself where it leads to a file, from here or from the folder that is shown;
/// else the first entry that passes; empty: none.
[[nodiscard]] std::string meant_by(const std::string& text, const std::string& folder);

/// The folder of the scenarios that ship with the client.
[[nodiscard]] std::string folder_of_scenarios();

}  // namespace physim::client
