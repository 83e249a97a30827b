#include "simclient/core/compare.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "physim/solve.hpp"
#include "report/fidelity_text.hpp"
#include "report/ladder.hpp"
#include "report/number.hpp"
#include "report/world_steps.hpp"
#include "simclient/core/length_text.hpp"

namespace physim::client {
namespace {

constexpr const char* kTruth = "reference";
constexpr const char* kAsSet = "as set";
constexpr int kPathPoints = 400;  // of what is drawn

/// Those of the palette, and a grey and a brown, as there are more presets than colours in it. Its white is that of
/// bodies without a colour.
constexpr std::pair<std::string_view, Colour> kColours[] = {
    {kAsSet, kPalette[0]},       {"game", kPalette[1]},      {"constant_air", kPalette[2]},
    {"small_arms", kPalette[3]}, {"artillery", kPalette[4]}, {"simulation", kPalette[5]},
    {kTruth, 0xF4F4F4FF},        {"arcade", 0x9AA3ADFF},     {"classic", 0xA0764AFF},
};

std::vector<TrackSample> path_of(const Flight& flight) {
  std::vector<TrackSample> path;
  for (int i = 0; i <= kPathPoints; ++i) path.push_back(sample_of(flight, flight.duration() * i / kPathPoints));
  return path;
}

void fill(ComparedRung& rung, const ComparedFlight& flown) {
  rung.problem = flown.problem;
  rung.granted = flown.flight.fidelity_in_use();
  if (!rung.problem.empty()) return;
  rung.path = path_of(flown.flight);
  rung.farthest = flown.largest_distance;
  rung.at_end = flown.end_distance;
  rung.later = flown.end_delay;
  rung.end = flown.flight.end();
  rung.flight = flown.flight;
}

}  // namespace

WorldDef bare_world(const Session& session) {
  WorldDef def = session.world().def();
  def.environment = session.scenario().environment;
  return def;
}

Colour colour_of_rung(std::string_view name) {
  const auto found = std::ranges::find(kColours, name, &std::pair<std::string_view, Colour>::first);
  PHYSIM_ASSERT(found != std::end(kColours));
  return found->second;
}

std::array<std::string, 7> ComparedRung::figures() const {
  using report::fixed, report::significant;
  return {significant(at_end, 3), significant(std::abs(later), 3), significant(farthest, 3), fixed(end.time, 6),
          fixed(end.range, 4),    fixed(end.position.y, 4),        fixed(end.windage, 4)};
}

std::string ComparedRung::why(const ComparedRung& truth) const {
  PHYSIM_ASSERT(problem.empty() && truth.problem.empty());
  constexpr double kSame = 1e-6;  // [m]
  if (is_truth) return "the truth";
  const Vec3d way = truth.end.position - truth.path.front().position, off = end.position - truth.end.position;
  const double far = std::hypot(way.x, way.z);
  const Vec3d along = far > 0 ? Vec3d{way.x / far, 0, way.z / far} : Vec3d{1, 0, 0}, right{-along.z, 0, along.x};
  const struct {
    double by;
    const char *more, *less;
  } sides[] = {{dot(off, along), "too far", "short"}, {off.y, "high", "low"}, {dot(off, right), "right", "left"}};
  const auto& side = *std::ranges::max_element(sides, {}, [](const auto& each) { return std::abs(each.by); });
  std::string reasons = report::why_apart(truth.granted.fidelity, granted.fidelity);
  if (reasons.empty())
    reasons = granted.fidelity.precision == Precision::float32 ? "float32" : "the same physics, other steps";
  std::ranges::replace(reasons, '_', ' ');  // names of rungs, as a sentence has them
  if (std::abs(side.by) < kSame) return "at the same place: " + reasons;
  return length_text(std::abs(side.by)) + " " + (side.by > 0 ? side.more : side.less) + ": " + reasons;
}

std::vector<ComparedRung> compare_rungs(const Scenario& scenario, const WorldDef& world, const ScenarioShot& fired,
                                        const std::vector<std::string>& presets, CostTable& costs) {
  const ScenarioShot shot = as_flown(fired);
  std::vector<ComparedRung> rungs;
  std::vector<FlightSetting> settings;
  const auto add = [&](const std::string& name, const FlightSetting& setting) {
    rungs.push_back({.name = name, .asked = setting.fidelity, .colour = colour_of_rung(name)});
    settings.push_back(setting);
  };
  const Result<FlightSetting> own = report::own_setting(scenario, shot);
  add(kAsSet, own ? *own : FlightSetting{shot.projectile.fidelity, scenario.tolerance});
  for (const std::string& name : presets)
    if (name != kTruth && fidelity_preset(name)) add(name, report::preset_setting(scenario, shot, name));
  const FlightSetting truth = report::reference_setting(scenario, shot);
  const Result<Comparison> compared =
      compare(shot.projectile, shot.launch, scenario.environment, settings, truth, scenario.until);
  add(kTruth, truth);
  rungs.back().is_truth = true;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    ComparedRung& rung = rungs[i];
    if (!compared)
      rung.problem = compared.error().message;
    else if (!own && i == 0)
      rung.problem = own.error().message;
    else
      fill(rung, rung.is_truth ? ComparedFlight{compared->reference, {}} : compared->flights[i]);
    if (!rung.problem.empty()) continue;
    ScenarioShot changed = shot;
    changed.projectile.fidelity = rung.asked;
    rung.per_step = costs.of(world, changed);
    changed.launch = compared->launch;
    rung.in_frames = report::error_of_steps(world, changed, report::kGameFrame, compared->reference);
  }
  return rungs;
}

double CostTable::of(const WorldDef& world, const ScenarioShot& shot) {
  for (const auto& [projectile, seconds] : known_)
    if (projectile == shot.projectile) return seconds;
  if (known_.size() >= 64) known_.clear();
  known_.emplace_back(shot.projectile, report::time_of_step(world, shot, world.step).value_or(0));  // 0: refused
  return known_.back().second;
}

}  // namespace physim::client
