#include "simclient/film.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include "base/assert.hpp"

namespace physim::client {
namespace {

/// A GIF has a palette of its own, and no more pixels than people send each other.
std::vector<std::string> words_of(const std::string& path, int width, int height, const std::string& written) {
  std::vector<std::string> words = {"ffmpeg",   "-loglevel",
                                    "error",    "-y",
                                    "-f",       "rawvideo",
                                    "-pix_fmt", "rgb24",
                                    "-s",       std::to_string(width) + "x" + std::to_string(height),
                                    "-r",       std::to_string(Film::kRate),
                                    "-i",       "pipe:0"};
  if (path.ends_with(".gif"))
    words.insert(words.end(), {"-filter_complex",
                               "fps=15,scale='min(720,iw)':-1:flags=lanczos,split[a][b];[a]palettegen[p];"
                               "[b][p]paletteuse",
                               "-f", "gif"});
  else
    words.insert(words.end(), {"-pix_fmt", "yuv420p", "-f", "mp4"});
  words.push_back(written);
  return words;
}

/// Starts a program that reads from one file and complains into another; 0, or the number of the error.
int spawn(std::vector<std::string> words, int in, int err, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int problem = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return problem;
}

}  // namespace

Status Film::start(const std::string& path, int width, int height) {
  PHYSIM_ASSERT(!is_running() && width > 0 && height > 0 && width % 2 == 0 && height % 2 == 0);
  if (!path.ends_with(".mp4") && !path.ends_with(".gif"))
    return Error{"cannot tell the film's format from the file name", path, "end it with .mp4 or .gif"};
  path_ = path;
  file_ = std::make_unique<NewFile>(path);
  if (Status status = file_->open(); !status) return status;
  problems_.reset(std::tmpfile());
  int ends[2] = {-1, -1};
  if (!problems_ || pipe2(ends, O_CLOEXEC) != 0)
    return Error{std::string("cannot start a film: ") + std::strerror(errno), path, ""};
  std::signal(SIGPIPE, SIG_IGN);  // ffmpeg may end before its last picture: that is an error like others
  const int problem =
      spawn(words_of(path, width, height, file_->written()), ends[0], fileno(problems_.get()), process_);
  close(ends[0]);
  pictures_.reset(fdopen(ends[1], "wb"));
  if (problem == 0) return {};
  process_ = -1;
  give_up();
  if (problem == ENOENT)
    return Error{"ffmpeg is needed for films and was not found", path,
                 "on Debian: apt-get install ffmpeg; a picture (F12) needs none"};
  return Error{std::string("cannot run ffmpeg: ") + std::strerror(problem), path, ""};
}

Status Film::add(const Picture& picture) {
  PHYSIM_ASSERT(is_running());
  const std::size_t size = picture.pixels.size();
  if (std::fwrite(picture.pixels.data(), 1, size, pictures_.get()) == size) return {};
  wait();
  const Error error = failure();
  give_up();
  return error;
}

Status Film::finish() {
  PHYSIM_ASSERT(is_running());
  const bool is_complete = std::fflush(pictures_.get()) == 0;
  pictures_.reset();
  if (wait() == 0 && is_complete) {
    const Status status = file_->complete();
    give_up();
    return status;
  }
  const Error error = failure();
  give_up();
  return error;
}

void Film::give_up() {
  pictures_.reset();  // ffmpeg ends with its input
  if (is_running()) wait();
  file_.reset();  // removes what is not complete
  problems_.reset();
}

int Film::wait() {
  pictures_.reset();
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

Error Film::failure() const {
  std::string told;
  char block[256];
  std::rewind(problems_.get());
  if (const std::size_t count = std::fread(block, 1, sizeof block, problems_.get())) told.assign(block, count);
  for (char& c : told)
    if (c == '\n') c = ' ';
  return Error{"ffmpeg failed" + (told.empty() ? "" : ": " + told), path_, ""};
}

}  // namespace physim::client
