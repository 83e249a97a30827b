// Texts of scenarios and of motors, changed at random.
//
//   physim_text_fuzz [COUNT [SEED [FIRST]]]
//
// Fails if a text is refused without a message and a place, and if a text that is taken is not the same after it was
// written and read again. What crashes or hangs shows by itself.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz/arguments.hpp"
#include "physim/scenario.hpp"

namespace physim::test {
namespace {

using Texts = std::vector<std::pair<std::string, std::string>>;  // file, text

const std::string kMotor =
    "; of no maker\nF7 18 70 3-5-7 0.0108 0.0241 NONE\n0.05 12.1\n0.3 14.5\n0.9 7.2\n1.4 0\n;\n"
    "G3 29 120 P 0.06 0.12 NONE\n 0.1 80\n 0.1 60\n 1.9 55\n 2 0\n";

class Change {
 public:
  Change(long seed, long number) : random_(static_cast<std::uint64_t>(seed) * 1'000'003 + std::uint64_t(number)) {}

  std::size_t pick(std::size_t below) { return static_cast<std::size_t>(random_() % std::max<std::size_t>(below, 1)); }

  /// Changes a text at a few places; takes lines from another one.
  void change(std::string& text, const std::string& other) {
    for (std::size_t edits = 1 + pick(4); edits != 0; --edits) {
      const std::size_t at = pick(text.size() + 1), length = std::min(pick(pick(4) == 0 ? 400 : 8), text.size() - at);
      switch (pick(7)) {
        case 0: text.erase(at, length); break;
        case 1: text.insert(at, text.substr(pick(text.size()), length)); break;
        case 2: text.insert(at, kOdd[pick(std::size(kOdd))]); break;
        case 3: put_number(text, at); break;
        case 4: text.insert(line_at(text, at), line_of(other)); break;
        case 5: text.insert(line_at(text, at), line_of(text)); break;
        default:
          if (at < text.size()) text[at] = static_cast<char>(random_() & 0xff);
      }
    }
  }

 private:
  static constexpr const char* kOdd[] = {
      "nan",        "-inf",      "1e308",   "-1",   "0",        "1e-320",  "9223372036854775807",
      "true",       "\"\"",      "\"\"\"",  "'",    "[",        "]]",      "{",
      "}",          ",",         "=",       "\n",   "#",        "\\u0000", "\xff\xfe",
      "[[shot]]\n", "[world]\n", "\"m/s\"", "0x7f", "12:00:00", "."};

  static std::size_t line_at(const std::string& text, std::size_t at) {
    const std::size_t end = text.find('\n', at);
    return end == std::string::npos ? text.size() : end + 1;
  }
  std::string line_of(const std::string& text) {
    const std::size_t begin = line_at(text, pick(text.size()));
    return text.substr(begin, line_at(text, begin) - begin);
  }
  /// Writes another number in the place of the next one.
  void put_number(std::string& text, std::size_t at) {
    const std::size_t begin = text.find_first_of("0123456789", at);
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.e", begin), text.size());
    text.replace(begin, end - begin, kOdd[pick(7)]);
  }

  std::mt19937_64 random_;
};

long faults = 0, taken = 0;

void fault(long number, const std::string& what, const std::string& text) {
  ++faults;
  std::printf("text %ld: %s\n%s\n", number, what.c_str(), text.c_str());
}

void read_scenario(long number, const std::string& file, const std::string& text) {
  const Result<ScenarioFile> read = ScenarioFile::parse(text, file);
  if (!read) {
    if (read.error().message.empty() || read.error().place.empty()) fault(number, "is refused without a reason", text);
    return;
  }
  ++taken;
  const std::string written = read->text();
  const Result<ScenarioFile> again = ScenarioFile::parse(written, file);
  if (!again)
    return fault(number, "what was written is refused: " + again.error().text(), text + "\n--- written:\n" + written);
  if (again->text() != written) fault(number, "is another text when it is read again", text);
}

void read_motors(long number, const std::string& text) {
  const auto motors = parse_motor_file(text, "fuzz.eng");
  if (!motors) {
    if (motors.error().message.empty() || motors.error().place.empty())
      fault(number, "is refused without a reason", text);
    return;
  }
  ++taken;
  for (const MotorFileEntry& entry : *motors) {
    double last = -1;
    for (const auto& point : entry.fault ? decltype(entry.motor.thrust){} : entry.motor.thrust) {
      if (!std::isfinite(point.time) || !std::isfinite(point.force) || point.time < last)
        return fault(number, "a motor that flies has a thrust that makes no sense", text);
      last = point.time;
    }
  }
}

Texts scenarios() {
  Texts all;
  for (const auto& entry : std::filesystem::directory_iterator(PHYSIM_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    all.emplace_back(entry.path().string(), std::string(std::istreambuf_iterator<char>(file), {}));
  }
  std::ranges::sort(all);  // folders come in any order
  return all;
}

int run(int argc, char** argv) {
  const auto arguments = read_arguments("physim_text_fuzz", argc, argv);
  if (!arguments) return 2;
  const Texts texts = scenarios();
  for (long i = arguments->first; i < arguments->first + arguments->count && faults < 20; ++i) {
    Change change(arguments->seed, i);
    const auto& [file, base] = texts[change.pick(texts.size())];
    std::string text = i % 4 == 3 ? kMotor : base;
    change.change(text, i % 4 == 3 ? kMotor : texts[change.pick(texts.size())].second);
    if (i % 4 == 3) {
      read_motors(i, text);
    } else {
      read_scenario(i, file, text);
    }
  }
  std::printf("%ld texts, %ld taken: %ld wrong\n", arguments->count, taken, faults);
  return faults == 0 && taken != 0 ? 0 : 1;
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) { return physim::test::run(argc, argv); }
