// Which version of PhySim wrote a save, a recording or a part of a study. Errors that refuse one name that version.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "physim/result.hpp"

namespace physim {

/// The version at the start of `bytes`, written as an archive writes texts. Empty if no version stands there: the bytes
/// may come from anywhere.
[[nodiscard]] inline std::string version_at(std::span<const std::byte> bytes) {
  constexpr std::size_t kLength = 4, kLongest = 32;
  std::size_t length = 0;
  if (bytes.size() < kLength) return {};
  for (std::size_t i = 0; i < kLength; ++i) length |= std::to_integer<std::size_t>(bytes[i]) << (8 * i);
  if (length == 0 || length > kLongest || length > bytes.size() - kLength) return {};
  std::string text;
  for (const std::byte byte : bytes.subspan(kLength, length)) text += static_cast<char>(byte);
  const auto is_of_version = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '.' || c == '-' || c == '+';
  };
  const bool is_version = text[0] >= '0' && text[0] <= '9' && text.find('.') != std::string::npos;
  return is_version && std::ranges::all_of(text, is_of_version) ? text : std::string();
}

/// Why a file of another format is refused: "the save is of format 7, written by PhySim 0.1.0; this is PhySim 0.2.0,
/// which reads format 9". Files that do not state their version are written "by an older version of PhySim".
[[nodiscard]] inline Error of_other_format(const std::string& what, const std::string& place, std::uint64_t format,
                                           std::uint32_t known, const std::string& version) {
  const std::string writer = !version.empty() ? "PhySim " + version
                             : format < known ? "an older version of PhySim"
                                              : "a newer version of PhySim";
  return {"the " + what + " is of format " + std::to_string(format) + ", written by " + writer + "; this is PhySim " +
              kVersion + ", which reads format " + std::to_string(known),
          place, "read it with the version that wrote it"};
}

/// What is added to an error about bytes that another version wrote; empty if this version wrote them.
[[nodiscard]] inline std::string by_another_version(const std::string& made_by) {
  if (made_by.empty() || made_by == kVersion) return {};
  return ": PhySim " + made_by + " wrote it, and this is PhySim " + kVersion;
}

}  // namespace physim
