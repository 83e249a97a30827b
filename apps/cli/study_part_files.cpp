#include "study_part_files.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "file_lock.hpp"
#include "report/file.hpp"
#include "scenario/text_file.hpp"
#include "study/part.hpp"
#include "study/plan.hpp"

namespace physim::cli {
namespace {

constexpr std::uintmax_t kLargestPart = std::uintmax_t{4} << 30;  // [bytes]

Result<StudyPart> read_part(const std::string& file, const char* kind) {
  const auto bytes = read_byte_file(file, kLargestPart, kind);
  if (!bytes) return bytes.error();
  auto part = load_part(*bytes);
  if (part) return part;
  Error error = part.error();
  error.place = file;
  return error;
}

/// Reads the part in the file of --resume; an empty part if the file is missing. The file must be a regular one, since
/// the study writes it, too.
Result<StudyPart> read_kept(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return StudyPart();
  if (Status status = check_file(file, kLargestPart, kResumedPart); !status) return status.error();
  return read_part(file, kResumedPart);
}

}  // namespace

Result<StudyPart> flown_before(const std::vector<std::string>& merge, const std::string& resume,
                               const StudyPlan& plan) {
  std::vector<std::string> files = merge;
  if (!resume.empty()) files.push_back(resume);
  StudyPart all;
  for (const std::string& file : files) {
    const bool resumes = &file == &files.back() && !resume.empty();
    const auto part = resumes ? read_kept(file) : read_part(file, "part to be merged");
    if (!part) return part.error();
    if (part->shards() > 0 && part->record().hash != plan.record().hash)
      return Error{"the part is of another study", file, "join parts of this study alone, with all of its options"};
    auto merged = physim::merge(all, *part);
    if (!merged) return Error{merged.error().message, file, merged.error().hint};
    all = *std::move(merged);
  }
  return all;
}

Status PartKeeper::write_together(const StudyPart& part) {
  const FileLock lock(target_of(file_));
  if (!lock.status()) return lock.status();
  const auto there = read_kept(file_);
  if (!there) return there.error();
  auto all = united(part, *there);
  if (!all) return Error{"another study was written into it meanwhile", file_, "give each study a file of its own"};
  kept_ = *std::move(all);
  const std::vector<std::byte> bytes = save_part(kept_);
  return report::write_file(
      file_, std::string_view(static_cast<const char*>(static_cast<const void*>(bytes.data())), bytes.size()));
}

}  // namespace physim::cli
