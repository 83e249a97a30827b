// Files that are written whole or not at all: to a temporary name beside the target, then renamed.
#pragma once

#include <string>
#include <string_view>

#include "physim/result.hpp"
#include "report/text.hpp"

namespace physim::report {

/// Writes a file. What stood there before stays until the new is complete.
[[nodiscard]] Status write_file(const std::string& path, const Text& text);
[[nodiscard]] Status write_file(const std::string& path, std::string_view content);

/// An error if a file of this path could not be written: a folder, a place in no folder, or a file that is read
/// (FilesInUse).
[[nodiscard]] Status check_writable(const std::string& path);

/// Makes a folder and those above it.
[[nodiscard]] Status make_folder(const std::string& path);

}  // namespace physim::report
