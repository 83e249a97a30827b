// Studies of scenarios: distributions, correlations and targets written as people write them.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/assert.hpp"
#include "scenario/measured_column.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/scenario.hpp"
#include "scenario/schema.hpp"
#include "scenario/study_text.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "study/paths.hpp"

namespace physim {
namespace {

constexpr const char* kInputHint =
    "write it as \"shot.speed = 800 m/s +- 3 m/s\", \"shot.speed = +- 3 m/s\", \"PATH = -2 m/s .. 2 m/s\", \"PATH = "
    "one of 1 m/s, 2 m/s\" or \"PATH = column NAME of FILE.csv\"";
constexpr const char* kTargetHint =
    "write it as \"circle 10 cm at 0 m, 1 m\", \"NAME: rectangle 30 cm x 50 cm\" or \"polygon 0 m, 0 m; 1 m, 0 m; 0 m, "
    "1 m\", or \"thing NAME\" of a scenario's things";

struct Halves {
  std::string_view left, right;
};

/// The text before and behind a word; nothing where it is not there.
std::optional<Halves> split(std::string_view text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string_view::npos) return std::nullopt;
  return Halves{trimmed(text.substr(0, at)), trimmed(text.substr(at + word.size()))};
}

bool take_front(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text = trimmed(text.substr(word.size()));
  return true;
}

bool take_back(std::string_view& text, std::string_view word) {
  if (!text.ends_with(word)) return false;
  text = trimmed(text.substr(0, text.size() - word.size()));
  return true;
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t at = std::min(text.find(separator, from), text.size());
    parts.push_back(trimmed(text.substr(from, at - from)));
    from = at + 1;
  }
  return parts;
}

/// The path of a point without its number, which no setting has.
std::string setting_of_point(std::string_view path) {
  std::string setting;
  for (const std::string_view part : parts_of(path, '.'))
    if (part.empty() || part.find_first_not_of("0123456789") != part.npos)
      setting += (setting.empty() ? "" : ".") + std::string(part);
  return setting;
}

/// What the number of a path measures: its unit says so, but where another setting of the shot decides. `shot`: who has
/// it; null: not known.
Quantity quantity_of_path(std::string_view path, const ScenarioShot* shot) {
  const SchemaNode* node = shot ? find_node(setting_of_point(path)) : nullptr;
  if (node && node->entry && node->entry->quantity_by) {
    ScenarioShot own = *shot;
    return node->entry->quantity_by({.shot = &own});
  }
  return quantity_of_si_unit(study_path(path)->unit);
}

/// An error for what is no number of a shot that may be uncertain.
Status check_path(std::string_view path) {
  static const std::vector<StudyPath> kPaths = study_paths();
  if (study_path(path)) return {};
  std::vector<std::string_view> names;
  for (const StudyPath& known : kPaths) names.push_back(known.path);
  return Error{"no number of a shot that may be uncertain is called " + in_quotes(path), "",
               suggestion(path, names, "they are")};
}

/// Reads numbers of a quantity; a difference of temperatures has no zero of its own. Either all numbers of a text have
/// a unit or none: "45 x 75 cm" would be 45 m wide.
class NumberReader {
 public:
  explicit NumberReader(Quantity quantity) : quantity_(quantity) {}

  double value(std::string_view text) {
    const auto number = parse_quantity(text, quantity_);
    if (!number && !error_) error_ = number.error();
    if (!number) return 0;
    if (std::isfinite(*number) && (*number != 0 || has_unit(text)))
      (has_unit(text) ? with_unit_ : without_unit_) = text;
    if (!with_unit_.empty() && !without_unit_.empty() && !error_)
      error_ = Error{"\"" + without_unit_ + "\" has no unit, and \"" + with_unit_ + "\" has one", "",
                     "give all of them a unit"};
    return *number;
  }
  double difference(std::string_view text) {
    const double number = value(text);
    if (quantity_ != Quantity::temperature || !has_unit(text) || error_) return number;
    return number - value("0 " + std::string(text.substr(unit_of(text))));
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  static std::size_t unit_of(std::string_view text) { return text.find_first_not_of("0123456789.+-eE \t"); }
  static bool has_unit(std::string_view text) { return unit_of(text) != std::string_view::npos; }

  std::string with_unit_, without_unit_;  // the last of each
  Quantity quantity_;
  std::optional<Error> error_;
};

/// Reads a distribution; `added`: all of its numbers are differences.
class DistributionReader {
 public:
  DistributionReader(Quantity quantity, bool added, std::string folder)
      : read_(quantity), quantity_(quantity), added_(added), folder_(std::move(folder)) {}

  std::optional<Distribution> read(std::string_view text) {
    if (take_front(text, "lognormal ")) {
      const auto halves = split(text, "+-");
      if (!halves) return std::nullopt;
      return LognormalDistribution{number(halves->left), read_.difference(halves->right)};
    }
    if (take_front(text, "one of ")) {
      DiscreteDistribution list;
      for (const std::string_view part : parts_of(text, ',')) list.values.push_back(number(part));
      return list;
    }
    if (take_front(text, "column ")) return column(text);
    if (split(text, "+-")) return bell(text);
    if (const auto ends = split(text, "..")) {
      if (const auto peak = split(ends->right, "peak "))
        return TriangularDistribution{number(ends->left), number(peak->right), number(peak->left)};
      return UniformDistribution{number(ends->left), number(ends->right)};
    }
    return std::nullopt;
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_ ? error_ : read_.error(); }

 private:
  /// Measurements, each as likely.
  std::optional<Distribution> column(std::string_view text) {
    const auto halves = split(text, " of ");
    if (!halves || halves->left.empty() || halves->right.empty()) return std::nullopt;
    const std::string file = (std::filesystem::path(folder_) / std::string(halves->right)).string();
    auto numbers =
        read_measured_column(file, halves->left, quantity_, added_ ? Measured::differences : Measured::values);
    if (numbers) return DiscreteDistribution{.values = *std::move(numbers)};
    error_ = numbers.error();
    error_->message = error_->place + ": " + error_->message;  // the place becomes that of the text
    return std::nullopt;
  }
  double number(std::string_view text) { return added_ ? read_.difference(text) : read_.value(text); }

  std::optional<Distribution> bell(std::string_view text) {
    const auto within = split(text, "within ");
    const auto halves = split(within ? within->left : text, "+-");
    PHYSIM_ASSERT(halves.has_value());
    const double mean = halves->left.empty() ? 0 : number(halves->left), deviation = read_.difference(halves->right);
    if (!within) return NormalDistribution{mean, deviation};
    const auto ends = split(within->right, "..");
    if (!ends) return std::nullopt;
    TruncatedNormalDistribution cut{mean, deviation};
    if (!ends->left.empty()) cut.low = number(ends->left);
    if (!ends->right.empty()) cut.high = number(ends->right);
    return cut;
  }

  NumberReader read_;
  Quantity quantity_;
  bool added_;
  std::string folder_;
  std::optional<Error> error_;
};

Error placed(Error error, const std::string& place) {
  error.place = place;
  return error;
}

std::optional<PlanePoint> point_of(std::string_view text, NumberReader& read) {
  const auto halves = split(text, ",");
  if (!halves) return std::nullopt;
  return PlanePoint{read.value(halves->left), read.value(halves->right)};
}

/// The input of a path that a correlation names: the first of them.
std::optional<std::size_t> input_of(const Study& study, std::string_view path) {
  const auto at = std::ranges::find(study.inputs, path, &StudyInput::path);
  if (at == study.inputs.end()) return std::nullopt;
  return static_cast<std::size_t>(at - study.inputs.begin());
}

struct PairOfInputs {
  std::size_t a, b;
  double correlation;
};

/// Inputs that pairs connect become one group, whose other pairs are not correlated.
void add_groups(Study& study, std::vector<PairOfInputs> pairs) {
  while (!pairs.empty()) {
    std::vector<std::size_t> group{pairs[0].a};
    const auto has = [&](std::size_t input) { return std::ranges::count(group, input) > 0; };
    for (bool grows = true; grows;) {
      grows = false;
      for (const PairOfInputs& pair : pairs)
        if (has(pair.a) != has(pair.b)) group.push_back(has(pair.a) ? pair.b : pair.a), grows = true;
    }
    const std::size_t n = group.size();
    StudyCorrelation with{group, std::vector<double>(n * n)};
    for (std::size_t i = 0; i < n; ++i) with.matrix[i * n + i] = 1;
    const auto place = [&](std::size_t input) {
      return static_cast<std::size_t>(std::ranges::find(group, input) - group.begin());
    };
    for (const PairOfInputs& pair : pairs)
      if (has(pair.a)) {
        const std::size_t i = place(pair.a), j = place(pair.b);
        with.matrix[i * n + j] = with.matrix[j * n + i] = pair.correlation;
      }
    std::erase_if(pairs, [&](const PairOfInputs& pair) { return has(pair.a); });
    study.correlated.push_back(std::move(with));
  }
}

Result<PairOfInputs> pair_of(const Study& study, const Halves& names, std::string_view number) {
  const auto a = input_of(study, names.left), b = input_of(study, names.right);
  const auto correlation = parse_quantity(number, Quantity::number);
  if (!a || !b) return Error{std::string(a ? names.right : names.left) + " is none of the study's inputs", "", ""};
  if (!correlation) return correlation.error();
  if (*a == *b) return Error{std::string(names.left) + " is correlated with itself", "", ""};
  return PairOfInputs{*a, *b, *correlation};
}

/// A length has the unit of what the points of the list stand at.
Result<std::vector<PairOfInputs>> pairs_by_distance(const Study& study, std::string_view list, std::string_view text) {
  const auto places = places_of_list(list);
  if (!places) return places.error();
  const auto length = parse_quantity(text, quantity_of_si_unit((*places)->unit));
  if (!length) return length.error();
  const auto with = correlated_by_distance(study, list, *length);
  if (!with) return with.error();
  const std::size_t n = with->inputs.size();
  std::vector<PairOfInputs> pairs;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) pairs.push_back({with->inputs[j], with->inputs[i], with->matrix[i * n + j]});
  return pairs;
}

/// One shot of a scenario, whose paths may be written "shot.NAME.speed".
struct ShotOfScenario {
  const Scenario& scenario;
  const ScenarioShot& shot;

  /// Its own path, "shot.speed"; nothing where a path is of another shot. What names no shot stays as it is.
  [[nodiscard]] std::optional<std::string> path(std::string_view written) const {
    constexpr std::string_view kShot = "shot.";
    const auto is_path = [](std::string_view path) { return study_path(path) || find_list(path); };
    if (is_path(written)) return std::string(written);
    for (const ScenarioShot& each : scenario.shots) {
      const std::string head = std::string(kShot) + each.projectile.name + ".";
      if (!written.starts_with(head)) continue;
      const std::string own = std::string(kShot) + std::string(written.substr(head.size()));
      if (!is_path(own)) continue;
      if (each.projectile.name != shot.projectile.name) return std::nullopt;
      return own;
    }
    return std::string(written);
  }
};

/// None where one of the two is another shot's.
Result<std::vector<PairOfInputs>> pairs_by_name(const Study& study, const ShotOfScenario& of, const Halves& names,
                                                std::string_view number) {
  const auto a = of.path(names.left), b = of.path(names.right);
  if (!a || !b) {
    const bool names_this = (a && *a != names.left) || (b && *b != names.right);
    if (!names_this) return std::vector<PairOfInputs>();
    return Error{std::string(names.left) + " and " + std::string(names.right) + " are of two shots", "",
                 "a study flies one of them; correlate what it draws"};
  }
  const auto pair = pair_of(study, {*a, *b}, number);
  if (!pair) return pair.error();
  return std::vector{*pair};
}

Result<std::vector<PairOfInputs>> pairs_of(const Study& study, const ShotOfScenario& of, std::string_view text) {
  const auto halves = split(text, "=");
  const auto names = halves ? split(halves->left, " with ") : std::nullopt;
  if (names) return pairs_by_name(study, of, *names, halves->right);
  std::string_view list = halves ? halves->left : "";
  if (!take_back(list, " by distance"))
    return Error{in_quotes(text) + " is no correlation", "",
                 "write it as \"shot.speed with shot.mass = 0.5\" or \"shot.drag.curve.N by distance = 0.3\""};
  const auto own = of.path(list);
  if (!own) return std::vector<PairOfInputs>();
  return pairs_by_distance(study, *own, halves->right);
}

using Errors = std::vector<Error>;

Error as_one(const Errors& errors) {
  Mistakes mistakes;
  for (const Error& error : errors) mistakes.take(error);
  return mistakes.status().error();
}

std::string numbered(const char* list, std::size_t i) { return std::string(list) + '[' + std::to_string(i) + ']'; }

void add_inputs(const Scenario& scenario, const ScenarioShot& shot, Study& study, Errors& errors) {
  const std::string folder = std::filesystem::path(scenario.file).parent_path().string();
  for (const InputOfShot& each : inputs_of(scenario, shot)) {
    auto input = parse_study_input_in(folder, each.written, &shot);
    if (input)
      study.inputs.push_back(*std::move(input));
    else
      errors.push_back(placed(input.error(), numbered("study.inputs", each.text)));
  }
}

/// Correlates inputs, where all of them are there.
void add_correlations(const Scenario& scenario, const ScenarioShot& shot, Study& study, Errors& errors) {
  const ScenarioStudy& texts = scenario.study;
  std::vector<PairOfInputs> pairs;
  for (std::size_t i = 0; i < texts.correlated.size(); ++i) {
    const auto told = pairs_of(study, {scenario, shot}, texts.correlated[i]);
    if (!told) {
      errors.push_back(placed(told.error(), numbered("study.correlated", i)));
      continue;
    }
    const auto is_known = [&](const PairOfInputs& pair) {
      return std::ranges::any_of(
          pairs, [&](const PairOfInputs& p) { return std::minmax(p.a, p.b) == std::minmax(pair.a, pair.b); });
    };
    if (std::ranges::any_of(*told, is_known))
      errors.push_back({"\"" + texts.correlated[i] + "\" names a pair that has a correlation already",
                        numbered("study.correlated", i), "give it once"});
    else
      pairs.insert(pairs.end(), told->begin(), told->end());
  }
  add_groups(study, std::move(pairs));
}

void add_targets(const ScenarioStudy& texts, Study& study, Errors& errors) {
  for (std::size_t i = 0; i < texts.targets.size(); ++i) {
    auto target = parse_study_target(texts.targets[i]);
    if (!target) {
      errors.push_back(placed(target.error(), numbered("study.targets", i)));
      continue;
    }
    if (target->name.empty()) target->name = "target-" + std::to_string(i + 1);
    study.targets.push_back(*std::move(target));
  }
}

void add_quantities(const ScenarioStudy& texts, Study& study, Errors& errors) {
  for (std::size_t i = 0; i < texts.quantities.size(); ++i) {
    const std::string& text = texts.quantities[i];
    if (const auto quantity = value_of<StudyQuantity>(text))
      study.quantities.push_back(*quantity);
    else
      errors.push_back({"no quantity of the end of a flight is called " + in_quotes(text),
                        numbered("study.quantities", i), suggestion(text, names_of<StudyQuantity>(), "they are")});
  }
}

void add_places(const ScenarioStudy& texts, std::vector<StudyPlace>& places, Errors& errors) {
  for (std::size_t i = 0; i < texts.at.size(); ++i) {
    auto place = parse_study_place(texts.at[i]);
    if (place)
      places.push_back(*std::move(place));
    else
      errors.push_back(placed(place.error(), numbered("study.at", i)));
  }
}

void add_aim(const ScenarioStudy& texts, Study& study, Errors& errors) {
  if (texts.aim.empty()) return;
  NumberReader read(Quantity::length);
  const auto aim = point_of(texts.aim, read);
  if (read.error())
    errors.push_back(placed(*read.error(), "study.aim"));
  else if (!aim)
    errors.push_back({"\"" + texts.aim + "\" is no point", "study.aim", "write it as \"0 m, 1 m\""});
  else
    study.aim = *aim;
}

bool is_target(const Study& study, const std::string& thing) {
  return std::ranges::any_of(study.targets, [&](const StudyTarget& target) {
    const auto* known = std::get_if<ThingTarget>(&target.shape);
    return known != nullptr && known->thing == thing;
  });
}

/// Shots meet the things of a scenario without a [world]; those that have names are targets.
Status add_scene(const Scenario& scenario, const ScenarioShot& shot, Study& study) {
  constexpr std::size_t kMostNames = 32;
  if (scenario.world.given || scenario.things.empty()) return {};
  Result<Scene> scene = scene_of(scenario);
  if (!scene) return scene.error();
  study.scene = std::make_shared<const Scene>(*std::move(scene));
  study.until.contact = contact_of(shot);
  std::vector<std::string> names;
  for (const ScenarioThing& thing : scenario.things)
    if (!thing.name.empty() && std::ranges::count(names, thing.name) == 0) names.push_back(thing.name);
  if (names.size() > kMostNames) return {};
  for (const std::string& name : names)
    if (!is_target(study, name)) study.targets.push_back({name, ThingTarget{name}});
  return {};
}

}  // namespace

std::vector<InputOfShot> inputs_of(const Scenario& scenario, const ScenarioShot& shot) {
  const ShotOfScenario of{scenario, shot};
  std::vector<InputOfShot> inputs;
  for (std::size_t i = 0; i < scenario.study.inputs.size(); ++i) {
    const std::string& text = scenario.study.inputs[i];
    const std::size_t number = std::min(text.find('='), text.size());
    const auto own = of.path(trimmed(std::string_view(text).substr(0, number)));
    if (own) inputs.push_back({i, number == text.size() ? text : *own + ' ' + text.substr(number), *own});
  }
  return inputs;
}

Result<std::vector<StudyPlace>> study_places_of(const ScenarioStudy& texts) {
  std::vector<StudyPlace> places;
  Errors errors;
  add_places(texts, places, errors);
  if (!errors.empty()) return as_one(errors);
  return places;
}

Result<StudyInput> parse_study_input_in(const std::string& folder, std::string_view text, const ScenarioShot* shot) {
  const auto halves = split(text, "=");
  if (!halves) return Error{"\"" + std::string(text) + "\" names no number and its distribution", "", kInputHint};
  if (Status status = check_path(halves->left); !status) return status.error();
  StudyInput input{.path = std::string(halves->left)};
  std::string_view rest = halves->right;
  if (take_back(rest, "per occasion")) input.drawn_for = DrawnFor::occasion;
  input.added = take_front(rest, "added ") || rest.starts_with("+-");
  DistributionReader reader(quantity_of_path(input.path, shot), input.added, folder);
  const auto distribution = reader.read(rest);
  if (reader.error()) return *reader.error();
  if (!distribution) return Error{"\"" + std::string(rest) + "\" is no distribution", "", kInputHint};
  input.distribution = *distribution;
  return input;
}

Result<StudyInput> parse_study_input(std::string_view text) { return parse_study_input_in("", text); }

Result<StudyTarget> parse_study_target(std::string_view text) {
  StudyTarget target;
  const Error unreadable{"\"" + std::string(text) + "\" is no target", "", kTargetHint};
  if (const auto named = split(text, ":")) target.name = std::string(named->left), text = named->right;
  if (take_front(text, "thing ")) {
    target.shape = ThingTarget{std::string(text)};
    if (target.name.empty()) target.name = std::string(text);
    return target;
  }
  NumberReader read(Quantity::length);
  PlanePoint centre;
  if (const auto at = split(text, " at ")) {
    const auto point = point_of(at->right, read);
    if (!point) return unreadable;
    centre = *point, text = at->left;
  }
  if (take_front(text, "circle ")) {
    target.shape = CircleTarget{centre, read.value(text)};
  } else if (take_front(text, "rectangle ")) {
    const auto sides = split(text, " x ");
    if (!sides) return unreadable;
    target.shape = RectangleTarget{centre, read.value(sides->left), read.value(sides->right)};
  } else if (take_front(text, "polygon ")) {
    PolygonTarget polygon;
    for (const std::string_view corner : parts_of(text, ';')) {
      const auto point = point_of(corner, read);
      if (!point) return unreadable;
      polygon.corners.push_back({centre.right + point->right, centre.up + point->up});
    }
    target.shape = std::move(polygon);
  } else {
    return unreadable;
  }
  if (read.error()) return *read.error();
  return target;
}

Study read_study(const Scenario& scenario, const ScenarioShot& shot, std::vector<Error>& errors) {
  const ScenarioStudy& texts = scenario.study;
  Study study{.projectile = projectile_of(shot),
              .launch = shot.launch,
              .environment = scenario.environment,
              .fidelity = shot.projectile.fidelity,
              .tolerance = scenario.tolerance,
              .until = scenario.until,
              .rounds = static_cast<std::uint32_t>(texts.rounds),
              .sampling = texts.sampling,
              .seed = static_cast<std::uint64_t>(texts.seed),
              .shots = static_cast<std::uint64_t>(texts.shots),
              .indices = texts.indices};
  if (study.rounds > study.shard_shots) study.shard_shots = study.rounds;
  study.shard_shots -= study.shard_shots % study.rounds;  // whole occasions
  std::erase_if(study.until.events, [](const EventSpec& event) { return !event.terminal; });
  if (texts.histograms != 0 && (texts.histograms < 3 || texts.histograms > 1000))
    errors.push_back({"must be from 3 to 1000 bars", "study.histograms", "0 for none"});
  if (texts.over_inputs > 0) study.over_inputs = static_cast<std::uint32_t>(texts.over_inputs);
  const std::size_t before = errors.size();
  add_inputs(scenario, shot, study, errors);
  if (errors.size() == before) add_correlations(scenario, shot, study, errors);
  add_targets(texts, study, errors);
  if (Status status = add_scene(scenario, shot, study); !status) errors.push_back(status.error());
  add_quantities(texts, study, errors);
  add_places(texts, study.at, errors);
  add_aim(texts, study, errors);
  return study;
}

Result<Study> study_of(const Scenario& scenario, const ScenarioShot& shot) {
  Errors errors;
  Study study = read_study(scenario, shot, errors);
  if (!errors.empty()) return as_one(errors);
  return study;
}

}  // namespace physim
