// The RASP format of thrust curves. Source: the format of G. H. Stine's program RASP as described by the National
// Association of Rocketry and thrustcurve.org ("RASP file format").
#include "physim/scenario.hpp"

#include <algorithm>
#include <string_view>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/suggest.hpp"
#include "scenario/text_file.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

constexpr std::uintmax_t kLargestMotorFile = 16 << 20;
constexpr std::size_t kMostMotorPoints = 1000;  // of a motor
constexpr std::size_t kHeader = 7;              // words
constexpr std::string_view kHeaderHint =
    "a motor begins with seven words: name, diameter [mm], length [mm], delays, propellant [kg], mass [kg], maker";

class MotorReader {
 public:
  explicit MotorReader(const std::string& file) : file_(file) {}

  Result<std::vector<MotorFileEntry>> read(std::string_view text) {
    if (text.starts_with('<'))
      return Error{"this is XML, as RockSim writes it", place(1), "only RASP files (.eng) are read"};
    while (!text.empty()) {
      ++line_;
      if (Status status = read_line(take_line(text)); !status) {
        if (motors_.empty()) return status.error();
        keep(status.error());
      }
    }
    end_open();
    if (motors_.empty()) return Error{"there is no motor in it", file_, std::string(kHeaderHint)};
    const auto sound = [](const MotorFileEntry& entry) { return !entry.fault; };
    if (std::ranges::none_of(motors_, sound)) return *motors_.front().fault;
    return motors_;
  }

 private:
  [[nodiscard]] std::string place(std::size_t line) const { return file_ + ":" + std::to_string(line); }
  [[nodiscard]] Error fault(const std::string& message, std::string_view hint) const {
    return Error{message, place(line_), std::string(hint)};
  }
  /// Thrust that does not end at zero falls to it at its last point, as other programs have it. Zeros inside are a
  /// pause of the motor; those behind its end say nothing.
  void end_open() {
    if (motors_.empty()) return;
    MotorDef& motor = motors_.back().motor;
    std::vector<ThrustPoint>& thrust = motor.thrust;
    if (thrust.size() < 2)
      return keep(fault("the thrust of " + in_quotes(motor.name) + " has no points", "is the file cut off?"));
    if (!(total_impulse(motor) > 0))
      return keep({"the motor gives no impulse", place(point_line_), "its thrust is zero"});
    while (thrust.back().force == 0 && thrust[thrust.size() - 2].force == 0) thrust.pop_back();
    const double end = thrust.back().time;
    if (thrust.back().force == 0) return;
    if (thrust[thrust.size() - 2].time == end)
      thrust.back().force = 0;
    else
      thrust.push_back({end, 0});
  }
  /// The first thing that is wrong with the motor at hand.
  void keep(const Error& error) {
    PHYSIM_ASSERT(!motors_.empty());
    if (!motors_.back().fault) motors_.back().fault = error;
  }

  Status read_line(std::string_view line) {
    line = line.substr(0, line.find(';'));
    const auto words = words_of(line);
    if (words.empty()) return {};
    // A line that begins with a word is the header of another motor, sound or not.
    constexpr std::size_t kLikeHeader = 5;
    if (words.size() == kHeader || (words.size() >= kLikeHeader && !finite_number(words[0]))) {
      end_open();
      return read_header(words);
    }
    if (!motors_.empty()) return read_point(words);
    const bool is_point = words.size() == 2 && finite_number(words[0]) && finite_number(words[1]);
    if (is_point) return fault("a point of thrust before any motor", kHeaderHint);
    return no_header(words);
  }
  [[nodiscard]] Error no_header(const std::vector<std::string_view>& words) const {
    return fault(std::to_string(words.size()) + " words are no header of a motor", kHeaderHint);
  }

  Status read_header(const std::vector<std::string_view>& words) {
    PHYSIM_ASSERT(!words.empty());
    MotorFileEntry& entry = motors_.emplace_back();
    entry.motor.name = words[0];
    entry.line = line_;
    if (words.size() != kHeader) return no_header(words);
    entry.delays = words[3];
    entry.manufacturer = words[6];
    double numbers[4];  // diameter, length, propellant, mass
    constexpr std::size_t kPlaces[] = {1, 2, 4, 5};
    constexpr std::string_view kPlaceNames[] = {"diameter", "length", "propellant", "mass"};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto number = finite_number(words[kPlaces[i]]);
      if (!number || *number < 0)
        return fault(in_quotes(words[kPlaces[i]]) + " is no " + std::string(kPlaceNames[i]), kHeaderHint);
      numbers[i] = *number;
    }
    if (numbers[2] > numbers[3])
      return fault("more propellant than the motor weighs", "propellant comes before the mass of the loaded motor");
    entry.motor.propellant_mass = numbers[2];
    entry.diameter = numbers[0] / 1000;
    entry.length = numbers[1] / 1000;
    entry.mass = numbers[3];
    return {};
  }

  Status read_point(const std::vector<std::string_view>& words) {
    PHYSIM_ASSERT(!motors_.empty());
    constexpr std::string_view kHint = "a point is a time [s] and a thrust [N]";
    if (words.size() != 2) return fault(std::to_string(words.size()) + " words are no point of thrust", kHint);
    for (const std::string_view word : words)
      if (!finite_number(word)) return fault(in_quotes(word) + " is no number", kHint);
    const double time = *finite_number(words[0]), force = *finite_number(words[1]);
    std::vector<ThrustPoint>& thrust = motors_.back().motor.thrust;
    if (time < 0 || force < 0) return fault("times and thrusts are not negative", kHint);
    if (thrust.empty() && time > 0) thrust.push_back({0, 0});
    const std::size_t count = thrust.size();
    if (count > 0 && time < thrust.back().time)
      return fault("time " + number_text(time) + " after " + number_text(thrust.back().time), "times must rise");
    if (count > 1 && time == thrust[count - 2].time)
      return fault("three points at time " + number_text(time), "two points at one time are a step");
    if (count == kMostMotorPoints) return fault("too many points", "at most " + std::to_string(kMostMotorPoints));
    thrust.push_back({time, force});
    point_line_ = line_;
    return {};
  }

  const std::string& file_;
  std::size_t line_ = 0;
  std::size_t point_line_ = 0;  // of the last point of thrust
  std::vector<MotorFileEntry> motors_;
};

}  // namespace

Result<std::vector<MotorFileEntry>> parse_motor_file(const std::string& text, const std::string& file) {
  const IeeeMode mode;
  return MotorReader(file).read(text);
}

Result<std::vector<MotorFileEntry>> read_motor_file(const std::string& file) {
  const Result<std::string> text = read_text_file(file, kLargestMotorFile, "motor file");
  if (!text) return text.error();
  return parse_motor_file(*text, file);
}

namespace {

Result<MotorFileEntry> sound_only(const MotorFileEntry& entry) {
  if (entry.fault) return *entry.fault;
  return entry;
}

std::string with_maker(const MotorFileEntry& entry) { return entry.manufacturer + " " + entry.motor.name; }

/// Names that say which motor is meant: the maker stands before one that several have.
std::vector<std::string> telling_names(const std::vector<MotorFileEntry>& motors) {
  std::vector<std::string> names;
  for (const MotorFileEntry& entry : motors) {
    const bool is_one_of = std::ranges::any_of(motors, [&](const MotorFileEntry& other) {
      return other.motor.name == entry.motor.name && other.manufacturer != entry.manufacturer;
    });
    names.push_back(is_one_of ? with_maker(entry) : entry.motor.name);
  }
  return names;
}

/// Copies of one motor are no two.
bool is_copy(const MotorFileEntry& a, const MotorFileEntry& b) {
  return a.motor == b.motor && a.manufacturer == b.manufacturer && a.mass == b.mass && !a.fault && !b.fault;
}

Error named_twice(const MotorFileEntry& first, const MotorFileEntry& other, const std::string& name,
                  const std::string& file) {
  PHYSIM_ASSERT(first.line < other.line);
  const bool differs = first.manufacturer != other.manufacturer;
  return Error{"two motors are named " + in_quotes(name) + ", in lines " + std::to_string(first.line) + " and " +
                   std::to_string(other.line),
               file,
               differs ? "name its maker, too: " + in_quotes(with_maker(first)) + " or " + in_quotes(with_maker(other))
                       : "take one of them out of the file"};
}

}  // namespace

Result<MotorFileEntry> pick_motor(const std::vector<MotorFileEntry>& motors, const std::string& name,
                                  const std::string& file) {
  if (name.empty() && motors.size() == 1) return sound_only(motors.front());
  const std::vector<std::string> own = telling_names(motors);
  const std::vector<std::string_view> names(own.begin(), own.end());
  const MotorFileEntry* found = nullptr;
  for (const MotorFileEntry& entry : motors) {
    if (entry.motor.name != name && with_maker(entry) != name) continue;
    if (found != nullptr && !is_copy(*found, entry)) return named_twice(*found, entry, name, file);
    if (found == nullptr) found = &entry;
  }
  if (found != nullptr) return sound_only(*found);
  if (name.empty())
    return Error{"there are " + std::to_string(motors.size()) + " motors in it", file,
                 suggestion("", names, "name one of them")};
  return Error{"there is no motor " + in_quotes(name) + " in it", file, suggestion(name, names, "motors")};
}

}  // namespace physim
