// The fuzzer that is led by coverage. PHYSIM_FUZZ names its target.
//
//   PHYSIM_FUZZ=saves physim_covered_fuzz --seeds FOLDER     writes inputs to begin with into a folder
//   PHYSIM_FUZZ=saves physim_covered_fuzz FOLDER [-max_total_time=600 ...]     changes them (options of libFuzzer)
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "fuzz/covered/target.hpp"

namespace physim::test {

void claim(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

namespace {

const Target& chosen() {
  static const Target& target = []() -> const Target& {
    const char* wanted = std::getenv("PHYSIM_FUZZ");
    for (const Target* each : {&kTexts, &kMotors, &kMeshes, &kSaves, &kScenes, &kRecordings, &kParts, &kCalls})
      if (wanted && std::string_view(wanted) == each->name) return *each;
    std::fprintf(stderr, "PHYSIM_FUZZ names none of: texts motors meshes saves scenes recordings parts calls\n");
    std::exit(2);
  }();
  return target;
}

}  // namespace
}  // namespace physim::test

extern "C" int LLVMFuzzerInitialize(int* count, char*** given) {
  using namespace physim::test;
  const Target& target = chosen();
  if (*count != 3 || std::string_view((*given)[1]) != "--seeds") return 0;
  int number = 0;
  for (const Bytes& seed : target.seeds()) {
    std::ofstream file(std::string((*given)[2]) + "/" + target.name + std::to_string(number++), std::ios::binary);
    file << text_of(seed);
  }
  std::printf("%d inputs\n", number);
  std::exit(number == 0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  physim::test::chosen().run(std::as_bytes(std::span(data, size)));
  return 0;
}
