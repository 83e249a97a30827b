#include "study_part_files.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "report/file.hpp"
#include "scenario/text_file.hpp"
#include "study/part.hpp"
#include "study/plan.hpp"

namespace physim::cli {
namespace {

constexpr std::uintmax_t kLargestPart = std::uintmax_t{4} << 30;  // [bytes]

Result<StudyPart> read_part(const std::string& file, const char* kind) {
  const auto bytes = read_bytes(file, kLargestPart, kind);
  if (!bytes) return bytes.error();
  auto part = load_part(*bytes);
  if (part) return part;
  Error error = part.error();
  error.place = file;
  return error;
}

}  // namespace

Result<StudyPart> flown_before(const std::vector<std::string>& merge, const std::string& resume,
                               const StudyPlan& plan) {
  struct PartFile {
    const std::string& path;
    const char* kind;
  };
  std::vector<PartFile> files;
  for (const std::string& file : merge) files.push_back({file, "part to be merged"});
  if (!resume.empty() && std::filesystem::exists(resume)) files.push_back({resume, kResumedPart});
  StudyPart all;
  for (const auto& [file, kind] : files) {
    const auto part = read_part(file, kind);
    if (!part) return part.error();
    if (part->shards() > 0 && part->record().hash != plan.record().hash)
      return Error{"the part is of another study", file, "join parts of this study alone, with all of its options"};
    auto merged = physim::merge(all, *part);
    if (!merged) return Error{merged.error().message, file, merged.error().hint};
    all = *std::move(merged);
  }
  return all;
}

Status write_part(const std::string& file, const StudyPart& part) {
  const std::vector<std::byte> bytes = save_part(part);
  return report::write_file(
      file, std::string_view(static_cast<const char*>(static_cast<const void*>(bytes.data())), bytes.size()));
}

}  // namespace physim::cli
