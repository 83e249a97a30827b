// Texts of scenarios and of motors.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/covered/target.hpp"
#include "physim/scenario.hpp"

namespace physim::test {

std::vector<std::string> scenario_texts() {
  std::vector<std::string> texts;
  for (const char* folder : {PHYSIM_SOURCE_DIR "/scenarios", PHYSIM_SOURCE_DIR "/tests/fuzz/bases"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
  }
  std::ranges::sort(texts);
  return texts;
}

namespace {

void read_scenario(std::span<const std::byte> bytes) {
  const Result<ScenarioFile> read = ScenarioFile::parse(text_of(bytes), "fuzz.toml");
  if (!read) {
    claim(!read.error().message.empty() && !read.error().place.empty(), "is refused with a reason and a place");
    return;
  }
  const std::string written = read->text();
  const Result<ScenarioFile> again = ScenarioFile::parse(written, "fuzz.toml");
  claim(static_cast<bool>(again), "what was written is read");
  claim(again->text() == written, "it is the same text when it is read again");
}

std::vector<Bytes> texts_to_begin_with() {
  std::vector<Bytes> seeds;
  for (const std::string& text : scenario_texts()) seeds.push_back(bytes_of(text));
  return seeds;
}

void read_motors(std::span<const std::byte> bytes) {
  const auto motors = parse_motor_file(text_of(bytes), "fuzz.eng");
  if (!motors) {
    claim(!motors.error().message.empty() && !motors.error().place.empty(), "is refused with a reason and a place");
    return;
  }
  for (const MotorFileEntry& entry : *motors) {
    const auto picked = pick_motor(*motors, entry.motor.name, "fuzz.eng");
    claim(picked || !picked.error().message.empty(), "a motor is found by its name, or it is said why not");
    if (entry.fault) continue;
    claim(entry.motor.thrust.size() > 1, "a motor that flies has thrust");
    double last = 0;
    for (const auto& point : entry.motor.thrust) {
      claim(std::isfinite(point.time) && std::isfinite(point.force) && point.time >= last, "times of thrust rise");
      last = point.time;
    }
  }
}

std::vector<Bytes> motors_to_begin_with() {
  return {bytes_of("; of no maker\nF7 18 70 3-5-7 0.0108 0.0241 NONE\n0.05 12.1\n0.3 14.5\n0.9 7.2\n1.4 0\n;\n"
                   "G3 29 120 P 0.06 0.12 NONE\n 0.1 80\n 0.1 60\n 1.9 55\n 2 0\n"),
          bytes_of("C6 18 70 0-3-5-7 .0108 .0241 E\r\n.1 12\r\n1.86 0\r\n")};
}

}  // namespace

const Target kTexts{"texts", read_scenario, texts_to_begin_with};
const Target kMotors{"motors", read_motors, motors_to_begin_with};

}  // namespace physim::test
