// Pairs of settings at random: a setting that is given beside another one changes the result, or something names it.
//
//   physim_settings_fuzz [COUNT [SEED]]
//
// Each case puts two settings of the list into a scenario of tests/fuzz/bases. If the second one leaves every bit of
// the result as it is with the first one alone, whichever of several values it has, a note or an error must name its
// path.
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>

#include "arguments.hpp"
#include "scenario/by_path.hpp"
#include "scenario/overrides.hpp"
#include "scenario/reader.hpp"
#include "settings_result.hpp"
#include "settings_values.hpp"

namespace physim::test {
namespace {

/// Settings that no number of a result comes from: names, texts and figures to compare with; what is for windows, or
/// for the time that a run takes.
bool is_beside_results(std::string_view path) {
  constexpr std::string_view kNames[] = {".name", "shot.motor.name"};
  constexpr std::string_view kHeads[] = {"physim", "title", "source", "expect"};
  constexpr std::string_view kWhole[] = {"world.threads",       "world.rows_per_thread",   "world.max_steps",
                                         "world.time_scale",    "study.until_time",        "study.histograms",
                                         "shot.body.smoothing", "shot.motor.file",         "shape.mesh.file",
                                         "shape.mesh.terrain",  "shape.height_field.file", "emitter.from.surface.file"};
  for (const std::string_view name : kNames)
    if (path.ends_with(name)) return true;
  for (const std::string_view head : kHeads)
    if (path == head || (path.starts_with(head) && path[head.size()] == '.')) return true;
  return std::ranges::find(kWhole, path) != std::end(kWhole);
}

std::vector<std::string> numbers_of(Quantity quantity) {
  static const std::map<Quantity, std::vector<std::string>> all = {
      {Quantity::length, {"0.3", "2", "35", "0.02"}}, {Quantity::time, {"0.05", "0.3", "0.01"}},
      {Quantity::speed, {"7", "40", "2", "250"}},     {Quantity::angle, {"0.2", "0.05", "0.7"}},
      {Quantity::angular_rate, {"50", "3", "300"}},   {Quantity::force, {"0.5", "20"}},
      {Quantity::pressure, {"90000", "2e7"}},         {Quantity::stiffness, {"5", "60"}}};
  const auto of_quantity = all.find(quantity);
  return of_quantity != all.end() ? of_quantity->second : std::vector<std::string>{"0.3", "0.8", "1.6", "3", "40"};
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0, end = 0; end != text.npos; at = end + 3) {
    end = text.find(" | ", at);
    parts.push_back(text.substr(at, end == text.npos ? end : end - at));
  }
  return parts;
}

/// Values to try, as they stand right of "=" in an override.
std::vector<std::string> values_of(const Setting& setting) {
  const std::string_view path = setting.path;
  for (const auto& [end, values] : hinted_values())
    if (path == end || (path.size() > end.size() && path.ends_with(end) && path[path.size() - end.size() - 1] == '.'))
      return values;
  for (const auto& [head, values] : hinted_values())
    if (path.starts_with(head) && (path[head.size()] == '.' || path[head.size()] == '_') && setting.type == "points")
      return values;
  const std::vector<std::string> numbers = numbers_of(setting.quantity);
  if (setting.type == "quantity" || setting.type == "drawn") return numbers;
  if (setting.type == "vector") {
    std::vector<std::string> vectors;
    for (const std::string& x : numbers) vectors.push_back("[" + x + ", " + numbers[1] + ", -" + numbers[0] + "]");
    return vectors;
  }
  if (setting.type == "integer") return {"2", "1", "3", "5"};
  if (setting.type == "boolean") return {"true", "false"};
  if (setting.type == "choice") return split(setting.range);
  if (setting.type == "points") return {"[[0, 0.4], [1, 0.9]]"};
  return {};
}

/// The paths of a setting: that of all elements of the lists that it is in, then those of single elements.
std::vector<std::string> paths_of(const std::string& path, Scenario& scenario) {
  std::vector<std::string> paths{path};
  for (const Setting& list : settings()) {
    if (list.type != "list" || !path.starts_with(list.path + ".")) continue;
    const std::string behind = path.substr(list.path.size());
    const std::vector<std::string> so_far = paths;
    for (const std::string& each : so_far) {
      const std::string head = each.substr(0, each.size() - behind.size());
      const Result<std::size_t> elements = length_at(scenario, head);
      for (std::size_t i = 1; elements && i <= *elements; ++i) paths.push_back(head + "." + std::to_string(i) + behind);
    }
  }
  return paths;
}

/// A setting of a base with the values that it can have there, best those that change the result alone.
struct Usable {
  std::string path{}, setting{};  // with numbers of elements, and without
  std::vector<std::string> values{}, telling{};
};

std::string joined(const Usable& setting, std::size_t value) { return setting.path + "=" + setting.values[value]; }

class Base {
 public:
  explicit Base(const std::filesystem::path& file) : name(file.stem().string()) {
    std::ifstream in(file);
    text_.assign(std::istreambuf_iterator<char>(in), {});
    document_ = parse_document(text_, "f.toml").value();
    scenario_ = parsed({}).value();
    plain_ = result_of({});
    if (!plain_.error.empty()) std::printf("%s: %s\n", name.c_str(), plain_.error.c_str());
    const bool is_study = text_.find("[study]") != text_.npos, is_aim = text_.find("[target]") != text_.npos;
    for (const Setting& setting : settings()) {
      if (is_beside_results(setting.path)) continue;
      // Options of the command line may bring what these go with.
      if (setting.path.starts_with("world.") && text_.find("[world]") == text_.npos) continue;
      if ((setting.path.starts_with("study.") && !is_study) || (setting.path.starts_with("target.") && !is_aim))
        continue;
      add(setting);
    }
  }

  /// A result with one setting, computed once.
  const SettingsResult& with(const std::string& first) {
    const auto [at, is_new] = alone_.try_emplace(first);
    if (is_new) at->second = result_of({first});
    return at->second;
  }

  [[nodiscard]] SettingsResult result_of(const std::vector<std::string>& overrides) const {
    const Result<Scenario> scenario = parsed(overrides);
    if (!scenario) return {.error = scenario.error().text()};
    return ResultHash(*scenario).result();
  }

  [[nodiscard]] const std::vector<Usable>& usable() const { return usable_; }
  /// Whether both leave the scenario as the first one does: the second says what is so anyway.
  [[nodiscard]] bool says_nothing_new(const std::string& first, const std::string& second) const {
    std::vector<std::string> given;
    if (!first.empty()) given.push_back(first);
    const auto before = parsed(given);
    given.push_back(second);
    const auto after = parsed(given);
    return before && after && effective_settings(*before) == effective_settings(*after);
  }

  /// The hits and bounces of a result without more than the first setting.
  [[nodiscard]] const SettingsResult& plain() const { return plain_; }

  /// Whether notes say that nothing reads a setting in any of the tables that have it.
  [[nodiscard]] bool is_called_unread(const SettingsResult& result, const Usable& of) {
    const bool is_of_all = of.path == of.setting;
    const Result<std::size_t> tables = length_at(*scenario_, of.setting.substr(0, of.setting.find('.')));
    const auto is_note = [&](const std::string& note) {
      const std::string words = " " + of.setting + ": has no effect";
      const std::size_t at = note.find(words);
      return at != note.npos && note.compare(at + words.size(), 4, " but") != 0;
    };
    const std::size_t needed = is_of_all && tables ? std::max<std::size_t>(1, *tables) : 1;
    return std::ranges::count_if(result.notes, is_note) >= static_cast<long>(needed);
  }

  std::string name;

 private:
  /// The scenario with overrides, from the document that is parsed once.
  [[nodiscard]] Result<Scenario> parsed(const std::vector<std::string>& overrides) const {
    Value document = document_;
    for (const std::string& each : overrides)
      if (Status status = apply_override(document, each); !status) return status.error();
    Scenario scenario;
    if (Status status = read_scenario(document, "f.toml", Checks::all, scenario); !status) return status.error();
    return scenario;
  }
  /// Adds the first path of a setting that changes the result, or else the first that can be given.
  void add(const Setting& setting) {
    std::optional<Usable> first;
    for (const std::string& path : paths_of(setting.path, *scenario_)) {
      Usable usable = tried(setting, path);
      if (!usable.telling.empty()) return usable_.push_back(std::move(usable));
      if (!usable.values.empty() && !first) first = std::move(usable);
    }
    if (first) usable_.push_back(std::move(*first));
  }
  Usable tried(const Setting& setting, const std::string& path) {
    Usable usable{.path = path, .setting = setting.path};
    for (const std::string& value : values_of(setting)) {
      const std::string given = path + "=" + value;
      const SettingsResult& alone = with(given);
      if (!alone.error.empty() || says_nothing_new("", given)) continue;
      usable.values.push_back(value);
      if (alone.bits != plain_.bits) usable.telling.push_back(value);
    }
    return usable;
  }

  std::string text_;
  Value document_;
  std::optional<Scenario> scenario_;
  SettingsResult plain_;
  std::vector<Usable> usable_;
  std::map<std::string, SettingsResult> alone_;
};

/// Whether a note or an error is about a setting: it names its path, a table that it is in, or something in it.
bool is_named(const SettingsResult& result, const std::string& path) {
  if (!result.error.empty()) return true;
  return std::ranges::any_of(result.notes, [&](const std::string& note) {
    if (note.find(" " + path + ".") != note.npos) return true;
    for (std::string here = path;; here.resize(here.rfind('.'))) {
      const std::size_t at = note.find(here + ":");
      if (at != note.npos && (at == 0 || note[at - 1] == ' ')) return true;
      if (here.find('.') == here.npos) return false;
    }
  });
}

/// Bounds of a flight, of a place, of an error or of what is asked, which may not be reached, and reports of what may
/// not happen.
bool is_limit(std::string_view path) {
  constexpr std::string_view kParts[] = {
      "until.",        ".despawn.",        ".max_",         ".maximum",       "pools",
      ".wall",         "flight.limit",     "detail.rungs",  ".duration",      ".magazine",
      ".delay",        ".when_full",       "apex_events",   "tolerance",      ".sleep_",
      "gravity.model", "atmosphere.model", ".planar",       "target.arc",     "study.shots",
      "trail.time",    ".preset",          "wind_zone.low", "wind_zone.high", "cycle.looping",
      "bands.above",   ".hysteresis"};
  return std::ranges::any_of(kParts, [&](std::string_view part) { return path.find(part) != path.npos; });
}
bool is_of_contact(std::string_view path) {
  constexpr std::string_view kHeads[] = {"material", "shape", "thing", "shot.body.", "world.ground"};
  return std::ranges::any_of(kHeads, [&](std::string_view head) { return path.starts_with(head); });
}

class SettingsFuzz {
 public:
  explicit SettingsFuzz(long seed) : random_(static_cast<std::uint64_t>(seed)) {
    const char* one = std::getenv("PHYSIM_FUZZ_BASE");
    std::set<std::filesystem::path> files;  // by name
    for (const auto& entry : std::filesystem::directory_iterator(PHYSIM_SOURCE_DIR "/tests/fuzz/bases"))
      if (one == nullptr || entry.path().stem() == one) files.insert(entry.path());
    for (const std::filesystem::path& file : files) bases_.emplace_back(file);
  }

  /// Settings that do nothing alone, each once; and those that do nothing in any base.
  void try_each_alone() {
    std::map<std::string, bool> tells;
    for (const Setting& setting : settings())
      if (!is_beside_results(setting.path)) tells[setting.path] = false;
    for (Base& base : bases_)
      for (const Usable& setting : base.usable()) {
        tells[setting.setting] |= !setting.telling.empty();
        if (!setting.telling.empty() || is_limit(setting.setting) || is_of_contact(setting.setting)) continue;
        bool silent = true;
        for (std::size_t i = 0; i < setting.values.size() && silent; ++i)
          silent = !is_named(base.with(joined(setting, i)), setting.setting);
        if (silent) found(base, "", setting, "says nothing");
      }
    for (const auto& [path, does] : tells)
      if (!does) std::printf("%s tells nothing anywhere\n", path.c_str());
  }

  /// False where two settings do not go together.
  bool try_pair() {
    Base& base = bases_[below(bases_.size())];
    const Usable& first = base.usable()[below(base.usable().size())];
    const Usable& second = base.usable()[below(base.usable().size())];
    if (&first == &second) return false;
    const std::string a = first.path + "=" + one_of(first.telling.empty() ? first.values : first.telling);
    const SettingsResult& alone = base.with(a);
    if (!alone.error.empty()) return false;
    bool is_silent = false;
    for (const std::string& value : second.telling.empty() ? second.values : second.telling) {
      const std::string b = second.path + "=" + value;
      const SettingsResult both = base.result_of({a, b});
      if (!both.error.empty()) return true;
      if (both.bits != alone.bits) {
        const bool is_chosen = first.setting == "shot.fidelity.cheapest_within" ||
                               first.setting == "shot.fidelity.precision" || is_limit(first.setting);
        if (!is_chosen && differ_clearly(both, alone) && base.is_called_unread(both, second))
          found(base, a, second, "is wrongly said to have no effect");
        return true;
      }
      if (is_named(both, second.setting)) return true;
      is_silent = is_silent || !base.says_nothing_new(a, b);
    }
    if (is_silent && !is_out_of_the_way(base, first, second, alone)) found(base, a, second, "says nothing");
    return true;
  }

  [[nodiscard]] std::size_t findings() const { return found_.size(); }

 private:
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  const std::string& one_of(const std::vector<std::string>& values) { return values[below(values.size())]; }

  /// A setting that does something alone, but has nothing to do beside the first one: a limit that is not reached, what
  /// comes after the end, or what hits would need.
  static bool is_out_of_the_way(const Base& base, const Usable& first, const Usable& setting,
                                const SettingsResult& alone) {
    if (is_limit(setting.setting) || is_of_contact(setting.setting)) return true;
    if (first.setting == "shot.fidelity.cheapest_within") return true;  // it leaves out what is below its error
    if (first.setting == "shot.body.frozen") return true;               // others may push along that axis alone
    if (first.setting == "shot.body.collision.on_hit") return true;     // what stops or sticks feels little after that
    if (setting.setting.starts_with("joint.") &&
        (first.setting == "shot.body.use_gravity" || first.setting == "environment.gravity.model"))
      return true;                                         // nothing pulls on joints
    if (first.setting == "shot.rail_length") return true;  // longer than the flight, nothing turns it
    // All rungs may be one, or the first is never left.
    if (first.setting == "world.detail.rungs" || first.setting == "world.detail.rungs.fidelity") return true;
    if (first.setting == "target.velocity") return true;  // too fast for any shot
    if (first.setting == "force.bungee.rest_length" || first.setting == "force.bungee.other") return true;  // slack
    // A velocity that no force changes has no drag, nor has a shot without air, which feels no wind either.
    if ((setting.setting == "shot.fidelity.drag" || setting.setting == "shot.fidelity.wind") &&
        (first.setting == "shot.fidelity.motion" || first.setting == "shot.fidelity.air" ||
         first.setting == "environment.atmosphere.model"))
      return true;
    // Beside a ballistic coefficient only what a shot meets reads its size.
    if (setting.setting == "shot.diameter" &&
        (first.setting == "shot.drag.bands" || first.setting == "shot.drag.ballistic_coefficient"))
      return true;
    // Particles go elsewhere, and meet nothing there; fast ones have one colour; few are near nothing.
    if (setting.setting.starts_with("emitter.sub.") &&
        (first.setting.starts_with("emitter.flight.") || first.setting == "environment.wind.velocity"))
      return true;
    if (setting.setting == "emitter.rain.shelter" && first.setting == "emitter.rain.density") return true;
    // A straight way meets the line of sight at all ranges or at none.
    if (first.setting == "environment.gravity.model" && setting.setting == "shot.sight.zero_range") return true;
    constexpr double kLittle = 0.1;  // of the way
    if (setting.telling.empty()) return false;
    return alone.time < base.plain().time || alone.moved < kLittle * base.plain().moved;
  }

  void found(const Base& base, const std::string& first, const Usable& second, const char* what) {
    const std::string values = second.telling.empty() ? second.values.front() : second.telling.front();
    const std::string text =
        base.name + ": " + second.path + " = " + values + " " + what + (first.empty() ? "" : " beside " + first);
    if (found_.insert(text).second) std::printf("%s\n", text.c_str());
  }

  std::mt19937_64 random_;
  std::vector<Base> bases_;
  std::set<std::string> found_;
};

}  // namespace
}  // namespace physim::test

int main(int count, char** given) {
  const auto arguments = physim::test::read_arguments("physim_settings_fuzz", count, given);
  if (!arguments) return 2;
  physim::test::SettingsFuzz fuzz(arguments->seed);
  fuzz.try_each_alone();
  constexpr long kTold = 5000;  // pairs between two lines, which a run that is stopped leaves
  for (long i = 0; i < arguments->count;) {
    if (!fuzz.try_pair()) continue;
    if (++i % kTold == 0) std::printf("%ld pairs so far\n", i);
  }
  std::printf("%ld pairs, %zu findings\n", arguments->count, fuzz.findings());
  return fuzz.findings() == 0 ? 0 : 1;
}
