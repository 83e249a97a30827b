// Files that are written beside their place and moved there when they are complete.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "physim/result.hpp"

namespace physim {

/// Ending of a recording until it is complete.
inline constexpr const char* kIncomplete = ".part";

/// A file that is written under another name until it is complete: what stood in its place stays until then. Devices
/// and pipes are written in place. A link is kept, and the file it leads to replaced.
class NewFile {
 public:
  /// It is written as `path` + `ending`, which stays if it is never completed. Without an ending it is written under a
  /// free name and removed if it is not completed.
  explicit NewFile(const std::string& path, std::string_view ending = "");
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Refuses what begin_writing() refuses, and directories.
  [[nodiscard]] Status open();
  /// After it returns the bytes survive the end of the program.
  [[nodiscard]] Status write(std::span<const std::byte> bytes);
  [[nodiscard]] Status write(std::string_view text);
  /// Moves it to its place.
  [[nodiscard]] Status complete();
  /// Removes what was written.
  void give_up();
  /// The path under which it is written.
  [[nodiscard]] const std::string& written() const { return written_; }

 private:
  using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

  [[nodiscard]] bool is_beside() const { return written_ != target_; }
  [[nodiscard]] Status cannot_write() const;

  std::string path_, ending_, target_, written_;
  Stream stream_{nullptr, &std::fclose};
};

}  // namespace physim
