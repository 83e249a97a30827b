#include "report/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "scenario/text_file.hpp"

#include "base/assert.hpp"

namespace physim::report {
namespace fs = std::filesystem;
namespace {

Error cannot_write(const std::string& path, int error_number) {
  return {.message = std::string("cannot write: ") + std::strerror(error_number), .place = path};
}

// The number of the error, 0 for success.
int write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    PHYSIM_ASSERT(static_cast<std::size_t>(written) <= content.size());
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

int write_to(const std::string& path, int flags, const Text& text) {
  constexpr std::size_t kGathered = 1 << 16;  // to the system at a time
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (file < 0) return errno;
  int write_error = 0;
  std::string gathered;
  const auto flush = [&] {
    if (write_error == 0) write_error = write_all(file, gathered);
    gathered.clear();
  };
  text([&](std::string_view piece) {
    gathered += piece;
    if (gathered.size() >= kGathered) flush();
  });
  flush();
  const int close_error = ::close(file) == 0 ? 0 : errno;
  return write_error != 0 ? write_error : close_error;
}

// May we write into this file or folder? As far as can be told beforehand.
Status check_permission(const std::string& path, const std::string& file_or_folder) {
  if (::access(file_or_folder.c_str(), W_OK) == 0) return {};
  return cannot_write(path, errno);
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
  if (fs::exists(path, ignored)) return check_permission(path, path);
  return check_permission(path, folder.empty() ? "." : folder.string());
}

Status write_file(const std::string& path, std::string_view content) {
  return write_file(path, [content](const Sink& sink) { sink(content); });
}

Status write_file(const std::string& path, const Text& text) {
  if (Status status = check_writable(path); !status) return status;
  const std::string target = target_of(path);
  if (is_special(target)) {
    const int error_number = write_to(target, 0, text);
    return error_number == 0 ? Status() : Status(cannot_write(path, error_number));
  }
  const std::string temporary = target + ".tmp-" + std::to_string(::getpid());
  int error_number = write_to(temporary, O_CREAT | O_TRUNC, text);
  if (error_number == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) error_number = errno;
  if (error_number == 0) return {};
  ::unlink(temporary.c_str());
  return cannot_write(path, error_number);
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
