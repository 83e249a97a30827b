// A lock that keeps programs from changing one file at the same time.
#pragma once

#include <string>

#include "physim/result.hpp"

namespace physim::cli {

/// Holds FILE.lock while it lives; other programs, and other objects of this one, wait for it. The lock file is removed
/// at the end. A file system without locks lets everybody pass.
class FileLock {
 public:
  explicit FileLock(const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// An error if the lock file cannot be made.
  [[nodiscard]] const Status& status() const { return status_; }

 private:
  std::string path_;
  int number_ = -1;
  Status status_;
};

}  // namespace physim::cli
