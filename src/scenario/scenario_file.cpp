// Source: physim/scenario.hpp.
#include "physim/scenario.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/assert.hpp"
#include "scenario/by_path.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim {

struct ScenarioFile::State {
  Scenario scenario;
  std::string text;
  bool is_of_file = false;  // the text was read from scenario.file
  std::vector<std::string> overrides;

  static Result<ScenarioFile> read(const std::string& text, const std::string& file, bool is_of_file,
                                   std::vector<std::string> overrides) {
    Result<Scenario> scenario =
        is_of_file ? parse_scenario_file(text, file, overrides) : parse_scenario(text, file, overrides);
    if (!scenario) return scenario.error();
    return ScenarioFile(
        std::make_shared<const State>(State{std::move(*scenario), text, is_of_file, std::move(overrides)}));
  }
};

ScenarioFile::ScenarioFile(std::shared_ptr<const State> state) : state_(std::move(state)) {
  PHYSIM_ASSERT(state_ != nullptr && !state_->scenario.shots.empty());
}

Result<ScenarioFile> ScenarioFile::load(const std::string& file, std::span<const std::string> overrides) {
  const Result<std::string> text = read_scenario_text(file);
  if (!text) return text.error();
  return State::read(*text, file, true, {overrides.begin(), overrides.end()});
}

Result<ScenarioFile> ScenarioFile::parse(const std::string& text, const std::string& file,
                                         std::span<const std::string> overrides) {
  return State::read(text, file, false, {overrides.begin(), overrides.end()});
}

std::span<const std::string> ScenarioFile::notes() const { return state_->scenario.notes; }

std::vector<std::string> ScenarioFile::shots() const {
  std::vector<std::string> names;
  for (const ScenarioShot& shot : state_->scenario.shots) names.push_back(shot.projectile.name);
  return names;
}

Result<std::string> ScenarioFile::get(std::string_view path) const {
  Scenario copy = state_->scenario;
  return value_at(copy, path);
}

Status ScenarioFile::set(std::string_view path, std::string_view value) {
  std::vector<std::string> overrides = state_->overrides;
  overrides.push_back(std::string(path) + "=" + std::string(value));
  Result<ScenarioFile> changed =
      State::read(state_->text, state_->scenario.file, state_->is_of_file, std::move(overrides));
  if (!changed) return changed.error();
  *this = std::move(*changed);
  return {};
}

std::string ScenarioFile::text() const { return scenario_text(state_->scenario); }

Result<Flight> ScenarioFile::fly(std::string_view shot) const {
  const auto& shots = state_->scenario.shots;
  const auto found = std::ranges::find_if(shots, [&](const ScenarioShot& s) { return s.projectile.name == shot; });
  if (found != shots.end()) return fly_shot(state_->scenario, *found);
  if (shot.empty()) return fly_shot(state_->scenario, shots.front());
  return Error{"there is no shot of this name", std::string(shot), "shots() names them"};
}

// ------------------------------------------------------------------------------------------------------------- worlds
ScenarioRun::ScenarioRun(std::unique_ptr<WorldRun> run) : run_(std::move(run)) {}
ScenarioRun::ScenarioRun(ScenarioRun&&) noexcept = default;
ScenarioRun& ScenarioRun::operator=(ScenarioRun&&) noexcept = default;
ScenarioRun::~ScenarioRun() = default;

void ScenarioRun::step() { run_->step(); }
std::uint64_t ScenarioRun::steps() const { return run_->steps(); }
World& ScenarioRun::world() { return run_->world(); }
const World& ScenarioRun::world() const { return std::as_const(*run_).world(); }

Result<ScenarioRun> ScenarioFile::run(const std::string& recording) const {
  Result<WorldRun> run = WorldRun::create(state_->scenario, recording);
  if (!run) return run.error();
  return ScenarioRun(std::make_unique<WorldRun>(std::move(*run)));
}

}  // namespace physim
