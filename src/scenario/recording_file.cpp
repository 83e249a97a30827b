#include "physim/scenario.hpp"

#include <memory>

#include "scenario/new_file.hpp"
#include "scenario/text_file.hpp"

namespace physim {
namespace {

constexpr std::uintmax_t kLargestRecording = std::uintmax_t{4} << 30;  // of a file that is read into memory [bytes]

}  // namespace

Status record_to_file(World& world, const std::string& path, const RecordOptions& options) {
  if (path.empty()) return Error{"the name of the recording is empty", "", ""};
  const auto file = std::make_shared<NewFile>(path, kIncomplete);
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
  if (path.empty()) return Error{"the name of the recording is empty", "", ""};
  NewFile file(path);
  if (Status status = file.open(); !status) return status;
  if (Status status = file.write(recording); !status) return status;
  return file.complete();
}

Result<std::vector<std::byte>> load_recording(const std::string& path) {
  return read_byte_file(path, kLargestRecording, "recording");
}

}  // namespace physim
