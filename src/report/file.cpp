#include "report/file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "scenario/files_in_use.hpp"
#include "scenario/new_file.hpp"

namespace physim::report {
namespace fs = std::filesystem;
namespace {

// Whether this program may write into a file or folder, as far as can be checked beforehand.
Status check_permission(const std::string& path, const std::string& file_or_folder) {
  if (::access(file_or_folder.c_str(), W_OK) == 0) return {};
  return Error{.message = std::string("cannot write: ") + std::strerror(errno), .place = path};
}

}  // namespace

Status check_writable(const std::string& path) {
  std::error_code ignored;
  if (path.empty()) return Error{.message = "the name of an output file is empty"};
  if (fs::is_directory(path, ignored)) return Error{.message = "cannot write: it is a directory", .place = path};
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    return Error{
        .message = "cannot write: no such directory", .place = path, .hint = "make " + folder.string() + " first"};
  if (Status status = begin_writing(path); !status) return status;
  if (fs::exists(path, ignored)) return check_permission(path, path);
  return check_permission(path, folder.empty() ? "." : folder.string());
}

Status write_file(const std::string& path, std::string_view content) {
  return write_file(path, [content](const Sink& sink) { sink(content); });
}

Status write_file(const std::string& path, const Text& text) {
  if (Status status = check_writable(path); !status) return status;
  constexpr std::size_t kGathered = 1 << 16;  // bytes to the system at a time
  NewFile file(path);
  Status status = file.open();
  std::string gathered;
  const auto flush = [&] {
    if (status) status = file.write(gathered);
    gathered.clear();
  };
  text([&](std::string_view piece) {
    gathered += piece;
    if (gathered.size() >= kGathered) flush();
  });
  flush();
  return status ? file.complete() : status;
}

Status make_folder(const std::string& path) {
  std::error_code error;
  if (path.empty()) return Error{.message = "the name of the output directory is empty"};
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    return Error{.message = "it is a file, not a directory", .place = path};
  fs::create_directories(path, error);
  if (error) return Error{.message = "cannot make the directory: " + error.message(), .place = path};
  return {};
}

}  // namespace physim::report
