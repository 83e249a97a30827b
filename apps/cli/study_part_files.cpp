#include "study_part_files.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>

#include "report/file.hpp"
#include "study/part.hpp"
#include "study/plan.hpp"

namespace physim::cli {
namespace {

Result<StudyPart> read_part(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return Error{"the file cannot be read", file, ""};
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  auto part = load_part(std::as_bytes(std::span(text)));
  if (part) return part;
  Error error = part.error();
  error.place = file;
  return error;
}

}  // namespace

Result<StudyPart> flown_before(const std::vector<std::string>& merge, const std::string& resume,
                               const StudyPlan& plan) {
  std::vector<std::string> files = merge;
  if (!resume.empty() && std::filesystem::exists(resume)) files.push_back(resume);
  StudyPart all;
  for (const std::string& file : files) {
    const auto part = read_part(file);
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
