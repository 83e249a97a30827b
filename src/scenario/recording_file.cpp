#include "physim/recording_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/assert.hpp"
#include "scenario/text_file.hpp"

namespace physim {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestRecording = std::uintmax_t{4} << 30;  // of a file that is read into memory [bytes]

/// A file that is written under another name until it is complete.
class NewFile {
 public:
  explicit NewFile(const std::string& path)
      : path_(path), target_(target_of(path)), written_(is_special(target_) ? target_ : target_ + ".part") {}

  Status open() {
    std::error_code ignored;
    if (path_.empty()) return Error{"the name of the recording is empty", "", ""};
    if (fs::is_directory(target_, ignored)) return Error{"cannot write: it is a folder", path_, "name a file in it"};
    errno = 0;
    out_.open(written_, std::ios::binary | std::ios::trunc);
    return out_.is_open() ? Status() : cannot_write();
  }
  Status write(std::span<const std::byte> bytes) {
    PHYSIM_ASSERT(out_.is_open());
    errno = 0;
    out_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out_.flush();  // from here on it survives the end of the program
    return out_.good() ? Status() : cannot_write();
  }
  Status complete() {
    PHYSIM_ASSERT(out_.is_open());
    errno = 0;
    out_.close();
    if (out_.fail()) return cannot_write();
    std::error_code failure;
    if (written_ != target_) fs::rename(written_, target_, failure);
    if (failure) return Error{"cannot write: " + failure.message(), path_, "it is left as " + written_};
    return {};
  }
  void give_up() {
    std::error_code ignored;
    out_.close();
    if (written_ != target_) fs::remove(written_, ignored);
  }

 private:
  [[nodiscard]] Status cannot_write() const {
    return Error{std::string("cannot write") + (errno != 0 ? std::string(": ") + std::strerror(errno) : ""), path_, ""};
  }

  std::string path_, target_, written_;
  std::ofstream out_;
};

}  // namespace

Status record_to_file(World& world, const std::string& path, const RecordOptions& options) {
  const auto file = std::make_shared<NewFile>(path);
  if (Status status = file->open(); !status) return status;
  const auto sink = [file](std::span<const std::byte> bytes) {
    return bytes.empty() ? file->complete() : file->write(bytes);
  };
  RecordOptions completed = options;
  completed.complete_at_end = true;  // the sink owns its file
  Status status = world.record(sink, completed);
  if (!status) file->give_up();
  return status;
}

Status save_recording(const std::string& path, std::span<const std::byte> recording) {
  NewFile file(path);
  if (Status status = file.open(); !status) return status;
  Status status = file.write(recording);
  if (status) status = file.complete();
  if (!status) file.give_up();
  return status;
}

Result<std::vector<std::byte>> load_recording(const std::string& path) {
  return read_byte_file(path, kLargestRecording, "recording");
}

}  // namespace physim
