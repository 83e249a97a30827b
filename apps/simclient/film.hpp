// Film: pictures, one behind the other, as a file that ffmpeg makes of them.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <string>

#include "scenario/new_file.hpp"
#include "simclient/gl/target.hpp"

namespace physim::client {

class Film {
 public:
  static constexpr int kRate = 30;  // pictures in a second

  Film() = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  /// What was not finished is given up.
  ~Film() { give_up(); }

  /// Starts ffmpeg for pictures of one size. The ending of the path, .mp4 or .gif, is the format. An error if there is
  /// no ffmpeg, or if the file cannot be written. What stands there stays until the film is complete.
  [[nodiscard]] Status start(const std::string& path, int width, int height);
  [[nodiscard]] Status add(const Picture& picture);
  /// Waits for ffmpeg, and moves the film to its place.
  [[nodiscard]] Status finish();
  void give_up();
  [[nodiscard]] bool is_running() const { return process_ > 0; }

 private:
  using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

  /// How it ended: 0 for success.
  int wait();
  [[nodiscard]] Error failure() const;

  std::string path_;
  std::unique_ptr<NewFile> file_;
  Stream pictures_{nullptr, &std::fclose}, problems_{nullptr, &std::fclose};
  pid_t process_ = -1;
};

}  // namespace physim::client
