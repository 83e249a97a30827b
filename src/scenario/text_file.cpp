#include "scenario/text_file.hpp"

#include <filesystem>
#include <fstream>

#include "base/assert.hpp"
#include "scenario/files_in_use.hpp"

namespace physim {
namespace fs = std::filesystem;

namespace {

/// A file as text or bytes.
template <class Content>
Result<Content> read_whole(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  PHYSIM_ASSERT(!kind.empty());
  const Error too_large{"larger than " + std::to_string(most_bytes >> 20) + " MiB", file, "this cannot be a " + kind};
  std::error_code failure;
  const auto status = fs::status(file, failure);
  if (!fs::exists(status)) return Error{"there is no such file", file, ""};
  if (fs::is_directory(status)) return Error{"this is a folder", file, "name a " + kind + " in it"};
  if (Status begun = begin_reading(file, kind); !begun) return begun.error();
  const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(file, failure) : 0;
  if (size > most_bytes) return too_large;
  std::ifstream in(file, std::ios::binary);
  Content content;
  content.reserve(static_cast<std::size_t>(size));
  std::vector<char> block(1 << 16);
  while (in.good() && content.size() <= most_bytes) {  // a device or a pipe may have no end
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto* const first = reinterpret_cast<const typename Content::value_type*>(block.data());
    content.insert(content.end(), first, first + in.gcount());
  }
  if (in.bad() || !in.is_open()) return Error{"the file cannot be read", file, ""};
  if (content.size() > most_bytes) return too_large;
  return content;
}

}  // namespace

Result<std::string> read_text_file(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  return read_whole<std::string>(file, most_bytes, kind);
}

Result<std::vector<std::byte>> read_bytes(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  return read_whole<std::vector<std::byte>>(file, most_bytes, kind);
}

std::string target_of(const std::string& path) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : fs::path(path);
  return target.empty() ? path : target.string();
}

bool is_special(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

}  // namespace physim
