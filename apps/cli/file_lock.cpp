#include "file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace physim::cli {
namespace {

/// Returns true if the path still names the open file. The previous holder of a lock removes the lock file.
bool is_at(const std::string& path, int number) {
  struct stat at {};
  struct stat held {};
  return ::stat(path.c_str(), &at) == 0 && ::fstat(number, &held) == 0 && at.st_ino == held.st_ino &&
         at.st_dev == held.st_dev;
}

}  // namespace

FileLock::FileLock(const std::string& file) : path_(file + ".lock") {
  for (;;) {
    // O_RDWR, although nothing is written: network file systems lock writable files alone.
    number_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (number_ < 0) {
      status_ = Error{std::string("cannot make the lock file: ") + std::strerror(errno), path_, ""};
      return;
    }
    int failed = 0;
    while ((failed = ::flock(number_, LOCK_EX)) != 0 && errno == EINTR) {
    }
    if (failed != 0 || is_at(path_, number_)) return;
    ::close(number_);
  }
}

FileLock::~FileLock() {
  if (number_ < 0) return;
  ::unlink(path_.c_str());
  ::close(number_);
}

}  // namespace physim::cli
