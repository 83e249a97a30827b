#include "scenario/new_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/assert.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/text_file.hpp"

namespace physim {
namespace fs = std::filesystem;

NewFile::NewFile(const std::string& path, std::string_view ending)
    : path_(path), ending_(ending), target_(target_of(path)) {}

NewFile::~NewFile() {
  if (ending_.empty()) give_up();
}

Status NewFile::open() {
  PHYSIM_ASSERT(!stream_);
  std::error_code ignored;
  if (fs::is_directory(target_, ignored)) return Error{"cannot write: it is a folder", path_, "name a file in it"};
  if (Status status = begin_writing(target_); !status) return status;
  written_ = target_ + ending_;
  if (is_special(target_)) {
    written_ = target_;
    stream_.reset(std::fopen(written_.c_str(), "wb"));
  } else if (!ending_.empty()) {
    if (Status status = begin_writing(written_); !status) return status;
    stream_.reset(std::fopen(written_.c_str(), "wb"));
  } else {
    constexpr int kMostNames = 10000;  // taken by others that write now, or left by programs that died
    for (int number = 1; number <= kMostNames && !stream_; ++number) {
      written_ = target_ + ".tmp-" + std::to_string(number);
      stream_.reset(std::fopen(written_.c_str(), "wbx"));  // x: fails if the file is there
      if (!stream_ && errno != EEXIST) break;
    }
  }
  return stream_ ? Status() : cannot_write();
}

Status NewFile::write(std::span<const std::byte> bytes) {
  PHYSIM_ASSERT(stream_);
  errno = 0;
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) == bytes.size();
  return is_written && std::fflush(stream_.get()) == 0 ? Status() : cannot_write();
}

Status NewFile::write(std::string_view text) { return write(std::as_bytes(std::span(text))); }

Status NewFile::complete() {
  PHYSIM_ASSERT(stream_);
  errno = 0;
  if (std::fclose(stream_.release()) != 0) return cannot_write();
  if (!is_beside()) return {};
  std::error_code failure;
  fs::rename(written_, target_, failure);
  if (!failure) {
    written_.clear();
    return {};
  }
  const std::string hint = ending_.empty() ? "" : "it is left as " + written_;
  return Error{"cannot write: " + failure.message(), path_, hint};
}

void NewFile::give_up() {
  std::error_code ignored;
  stream_.reset();
  if (!written_.empty() && is_beside()) fs::remove(written_, ignored);
  written_.clear();
}

Status NewFile::cannot_write() const {
  return Error{std::string("cannot write") + (errno != 0 ? std::string(": ") + std::strerror(errno) : ""), path_, ""};
}

}  // namespace physim
