// A target of a fuzzer that is led by coverage (libFuzzer): what it does with bytes, and bytes to begin with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace physim::test {

using Bytes = std::vector<std::byte>;

struct Target {
  const char* name;
  void (*run)(std::span<const std::byte>);
  std::vector<Bytes> (*seeds)();
};

[[nodiscard]] inline std::string text_of(std::span<const std::byte> bytes) {
  std::string text(bytes.size(), '\0');
  if (!bytes.empty()) std::memcpy(text.data(), bytes.data(), bytes.size());
  return text;
}
[[nodiscard]] inline Bytes bytes_of(const std::string& text) {
  const auto view = std::as_bytes(std::span(text));
  return {view.begin(), view.end()};
}

/// What cannot be true whatever the bytes are; ends the program, so that the fuzzer keeps them.
void claim(bool holds, const char* what);

/// The text of each shipped scenario, and of each base of the fuzz of pairs of settings.
[[nodiscard]] std::vector<std::string> scenario_texts();

extern const Target kTexts, kMotors, kMeshes, kSaves, kScenes, kRecordings, kParts, kCalls;

}  // namespace physim::test
