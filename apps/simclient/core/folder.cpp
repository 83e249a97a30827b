#include "simclient/core/folder.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <tuple>

#include "physim/scenario.hpp"
#include "scenario/text_file.hpp"

namespace physim::client {
namespace {

namespace fs = std::filesystem;

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool can_be_opened(const std::string& name) {
  return name.ends_with(".toml") || name.ends_with(".rec") || name.ends_with(".rec.part");
}

bool is_file(const std::string& path) {
  std::error_code unknown;
  return fs::is_regular_file(path, unknown);
}

}  // namespace

bool passes_filter(std::string_view name, std::string_view filter) {
  const std::string in = in_lower_case(name);
  std::istringstream words(in_lower_case(filter));
  for (std::string word; words >> word;)
    if (in.find(word) == in.npos) return false;
  return true;
}

std::vector<FolderEntry> entries_of(const std::string& folder, std::string_view filter) {
  std::vector<FolderEntry> entries;
  std::error_code unreadable;
  for (fs::directory_iterator each(folder, unreadable), end; !unreadable && each != end; each.increment(unreadable)) {
    std::error_code unknown;
    FolderEntry entry{each->path().filename().string(), each->path().string(), each->is_directory(unknown)};
    const bool is_shown = entry.is_folder || (can_be_opened(entry.name) && passes_filter(entry.name, filter));
    if (is_shown && !entry.name.starts_with('.')) entries.push_back(std::move(entry));
  }
  std::ranges::sort(entries, {}, [](const FolderEntry& e) { return std::tuple(!e.is_folder, in_lower_case(e.name)); });
  const fs::path whole = fs::absolute(folder, unreadable).lexically_normal();
  const fs::path above = whole.has_filename() ? whole.parent_path() : whole.parent_path().parent_path();
  if (!unreadable && above != whole) entries.insert(entries.begin(), {"..", above.string(), true});
  return entries;
}

std::string path_in(const std::string& folder, const std::string& text) {
  return fs::path(text).is_absolute() ? text : (fs::path(folder) / text).lexically_normal().string();
}

std::string meant_by(const std::string& text, const std::string& folder) {
  if (is_file(text)) return text;
  if (const std::string there = path_in(folder, text); is_file(there)) return there;
  for (const FolderEntry& entry : entries_of(folder, text))
    if (!entry.is_folder) return entry.path;
  return "";
}

std::string folder_of_scenarios() { return fs::path(shipped_scenario("arrow.toml")).parent_path().string(); }

}  // namespace physim::client
