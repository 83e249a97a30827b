#include "scenario/text_file.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

#include "base/assert.hpp"

namespace physim {

Result<std::string> read_text_file(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  PHYSIM_ASSERT(!kind.empty());
  const Error too_large{"larger than " + std::to_string(most_bytes >> 20) + " MiB", file, "this cannot be a " + kind};
  std::error_code failure;
  const auto status = std::filesystem::status(file, failure);
  if (!std::filesystem::exists(status)) return Error{"there is no such file", file, ""};
  if (std::filesystem::is_directory(status)) return Error{"this is a folder", file, "name a " + kind + " in it"};
  if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(file, failure) > most_bytes)
    return too_large;
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::vector<char> block(1 << 16);
  while (in.good() && text.size() <= most_bytes) {  // a device or a pipe may have no end
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad() || !in.is_open()) return Error{"the file cannot be read", file, ""};
  if (text.size() > most_bytes) return too_large;
  return text;
}

}  // namespace physim
