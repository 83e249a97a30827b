#include "simclient/core/recent_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "report/file.hpp"
#include "scenario/text_file.hpp"

namespace physim::client {
namespace {

constexpr std::size_t kMost = 10;

}  // namespace

RecentFiles::RecentFiles(const std::string& list) : list_(list) { read(); }

void RecentFiles::read() {
  constexpr std::uintmax_t kLargestList = 1 << 20;  // [bytes]
  if (list_.empty() || !check_file(list_, kLargestList, "list of files")) return;
  const Result<std::string> text = read_text_file(list_, kLargestList, "list of files");
  if (!text) return;
  files_.clear();
  std::istringstream in(*text);
  for (std::string line; files_.size() < kMost && std::getline(in, line);)
    if (!line.empty()) files_.push_back(line);
}

void RecentFiles::add(const std::string& file) {
  std::error_code unknown;
  const std::string whole = std::filesystem::absolute(file, unknown).lexically_normal().string();
  if (unknown || whole.find('\n') != whole.npos) return;
  read();  // another window may have added some
  std::erase(files_, whole);
  files_.insert(files_.begin(), whole);
  if (files_.size() > kMost) files_.resize(kMost);
  if (list_.empty()) return;
  std::string text;
  for (const std::string& each : files_) text += each + "\n";
  if (report::make_folder(std::filesystem::path(list_).parent_path().string()))
    static_cast<void>(report::write_file(list_, text));
}

std::string list_of_recent_files() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value ? value : "");
  };
  std::string folder = variable("XDG_STATE_HOME");
  if (folder.empty() && !variable("HOME").empty()) folder = variable("HOME") + "/.local/state";
  return folder.empty() ? "" : folder + "/physim/recent_files";
}

}  // namespace physim::client
