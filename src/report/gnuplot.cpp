#include "report/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>

#include "base/assert.hpp"
#include "report/file.hpp"
#include "report/table.hpp"

extern char** environ;

namespace physim::report {
namespace {

/// "png", "svg"; empty for others.
std::string kind_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".png" || ending == ".svg" ? ending.substr(1) : "";
}

std::string terminal(const std::string& kind, const Picture& picture) {
  PHYSIM_ASSERT(kind == "png" || kind == "svg");
  PHYSIM_ASSERT(picture.width > 0);
  PHYSIM_ASSERT(picture.height > 0);
  return "set encoding utf8\nset terminal " + (kind == "png" ? std::string("pngcairo") : kind) + " size " +
         std::to_string(picture.width) + "," + std::to_string(picture.height) +
         " font 'DejaVu Sans,14' noenhanced background rgb 'white'\n";
}

using TemporaryFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
TemporaryFile temporary_file() { return {std::tmpfile(), &std::fclose}; }

std::string content_of(std::FILE* file) {
  std::string content;
  char block[1 << 16];
  std::rewind(file);
  while (const std::size_t count = std::fread(block, 1, sizeof block, file)) content.append(block, count);
  return content;
}

Error missing_gnuplot() {
  return {.message = "gnuplot is needed for plots and was not found",
          .hint = "on Debian: apt-get install gnuplot-nox fonts-dejavu-core"};
}

// Starts gnuplot on three files and waits; 0 for success, the number of the error, or -1 where gnuplot itself failed.
int run_gnuplot(std::FILE* in, std::FILE* out, std::FILE* err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(err), STDERR_FILENO);
  char program[] = "gnuplot", default_session[] = "--default-settings", from_stdin[] = "-";
  char* arguments[] = {program, default_session, from_stdin, nullptr};
  pid_t child = 0;
  const int error_number = posix_spawnp(&child, program, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error_number != 0) return error_number;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return errno;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : -1;
}

Result<std::string> render(const std::string& kind, const Picture& picture) {
  const TemporaryFile in = temporary_file(), out = temporary_file(), err = temporary_file();
  if (!in || !out || !err)
    return Error{.message = std::string("cannot make a temporary file: ") + std::strerror(errno)};
  const std::string script = terminal(kind, picture) + picture.script;
  std::fwrite(script.data(), 1, script.size(), in.get());
  if (std::fflush(in.get()) != 0) return Error{.message = "cannot write a temporary file: disk full?"};
  std::rewind(in.get());
  const int error_number = run_gnuplot(in.get(), out.get(), err.get());
  if (error_number == ENOENT) return missing_gnuplot();
  if (error_number > 0) return Error{.message = std::string("cannot run gnuplot: ") + std::strerror(error_number)};
  std::string content = content_of(out.get());
  if (error_number != 0 || content.empty())
    return Error{.message = "gnuplot failed: " + one_line(content_of(err.get()))};
  return content;
}

}  // namespace

Status check_gnuplot() {
  const char* folders = std::getenv("PATH");
  if (folders == nullptr) return {};  // the system has its own idea then
  std::istringstream in(folders);
  for (std::string folder; std::getline(in, folder, ':');)
    if (::access(((folder.empty() ? "." : folder) + "/gnuplot").c_str(), X_OK) == 0) return {};
  return missing_gnuplot();
}

Status check_plot(const std::string& path) {
  if (kind_of(path).empty())
    return Error{.message = "cannot tell the picture's format from the file name",
                 .place = path,
                 .hint = "end it with .png or .svg"};
  const Status status = check_writable(path);
  return status ? check_gnuplot() : status;
}

Status draw(const std::string& path, const Picture& picture) {
  if (Status status = check_plot(path); !status) return status;
  const Result<std::string> content = render(kind_of(path), picture);
  return content ? write_file(path, *content) : Status(content.error());
}

}  // namespace physim::report
