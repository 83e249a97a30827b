#include "report/ladder.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "base/assert.hpp"
#include "model/ladder.hpp"
#include "physim/names.hpp"
#include "report/fidelity_text.hpp"
#include "report/flown.hpp"
#include "report/number.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim::report {
namespace {

// ------------------------------------------------------------------------------------------------------ the rungs
/// A fidelity with the rotation that the shot asks for, where that is more.
Fidelity rotating(Fidelity fidelity, const ScenarioShot& shot) {
  fidelity.rotation = higher_of(fidelity.rotation, shot.projectile.fidelity.rotation);
  return fidelity;
}

// Integrators with a step of their own choice, or with a given one; the original loop is no method to compare.
std::vector<Integrator> stepped_by(bool themselves) {
  std::vector<Integrator> list;
  for (const Integrator integrator : all_rungs<Integrator>())
    if (integrator != Integrator::classic && is_adaptive(integrator) == themselves) list.push_back(integrator);
  return list;
}

void add_integrators(const Scenario& scenario, const ScenarioShot& shot, std::vector<Rung>& rungs) {
  const auto add = [&](Integrator integrator, const char* detail, Tolerance tolerance) {
    Fidelity fidelity = rotating(Fidelity::simulation(), shot);
    fidelity.integrator = integrator;
    rungs.push_back({Family::integrator, std::string(name(integrator)), detail, {fidelity, tolerance}});
  };
  struct Setting {
    const char* text;
    double value;
  };
  Tolerance tolerance = scenario.tolerance;
  for (const Integrator integrator : stepped_by(false))
    for (const auto& [text, step] : {Setting{"1/60 s", 1.0 / 60}, {"10 ms", 0.01}, {"1 ms", 0.001}}) {
      tolerance.step = step;
      add(integrator, text, tolerance);
    }
  tolerance = scenario.tolerance;
  for (const Integrator integrator : stepped_by(true))
    for (const auto& [text, error] : {Setting{"1e-3", 1e-3}, {"1e-6", 1e-6}, {"1e-9", 1e-9}, {"1e-12", 1e-12}}) {
      tolerance.relative = tolerance.absolute = error;
      add(integrator, text, tolerance);
    }
}

void add_effects(const Scenario& scenario, const ScenarioShot& shot, std::vector<Rung>& rungs) {
  const Fidelity best = rotating(Fidelity::simulation(), shot);
  const auto without = [&](const char* name, const std::function<void(Fidelity&)>& change) {
    Fidelity fidelity = best;
    change(fidelity);
    rungs.push_back({Family::effect, name, "", {fidelity, scenario.tolerance}});
  };
  without("no drag", [](Fidelity& f) { f.drag = DragModel::off; });
  without("constant air", [](Fidelity& f) { f.air = AirModel::constant; });
  without("no wind", [](Fidelity& f) { f.wind = WindModel::off; });
  const bool only_drift = best.rotation == RotationModel::spin_drift;
  without(only_drift ? "no spin drift" : "no rotation", [](Fidelity& f) { f.rotation = RotationModel::none; });
  if (!only_drift) without("spin drift only", [](Fidelity& f) { f.rotation = RotationModel::spin_drift; });
  if (best.rotation == RotationModel::rigid_body)
    without("modified point mass", [](Fidelity& f) { f.rotation = RotationModel::modified_point_mass; });
  without("no Coriolis", [](Fidelity& f) { f.earth = EarthModel::flat; });
  without("constant gravity", [](Fidelity& f) { f.gravity = GravityModel::constant; });
  without("linear drag curve", [](Fidelity& f) { f.interpolation = Interpolation::linear; });
  without("pchip drag curve", [](Fidelity& f) { f.interpolation = Interpolation::pchip; });
  without("float32", [](Fidelity& f) { f.precision = Precision::float32; });
  // A tolerance below the rounding of a float cannot be kept.
  Tolerance& coarse = rungs.back().setting.tolerance;
  coarse.relative = coarse.absolute = std::max(coarse.relative.value_or(0), 1e-5);
}

std::vector<Rung> all_rungs(const Scenario& scenario, const ScenarioShot& shot) {
  std::vector<Rung> rungs;
  for (const char* preset : {"arcade", "game", "sport_ball", "small_arms", "artillery", "simulation"})
    rungs.push_back({Family::preset, preset, "", preset_setting(scenario, preset)});
  add_integrators(scenario, shot, rungs);
  add_effects(scenario, shot, rungs);
  return rungs;
}

// ----------------------------------------------------------------------------------------------------------- timing
/// Median time of one call [s]: of samples that are each long enough for the clock, at least three of them unless the
/// call itself is a long one.
template <class Call>
double median_time(const Call& call) {
  using Clock = std::chrono::steady_clock;
  constexpr double kSample = 100e-6, kBudget = 20e-3, kPatience = 100e-3;  // [s]
  constexpr std::size_t kFewest = 3, kMost = 101;
  double spent = 0;
  const auto time_of = [&](int calls) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) call();
    const double time = std::chrono::duration<double>(Clock::now() - start).count();
    spent += time;
    return time / calls;
  };
  const double first = std::max(time_of(1), 1e-8);  // warms the caches up
  if (spent >= kPatience) return first;
  const int calls = std::clamp(static_cast<int>(kSample / first), 1, 1000);
  std::vector<double> times;
  while (times.size() < kMost && spent < (times.size() < kFewest ? kPatience : kBudget))
    times.push_back(time_of(calls));
  PHYSIM_ASSERT(!times.empty());
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::ranges::nth_element(times, middle);
  return *middle;
}

// --------------------------------------------------------------------------------------------------------- climbing
class Climber {
 public:
  Climber(const Scenario& scenario, const ScenarioShot& shot) : scenario_(scenario), shot_(shot) {}

  Result<Ladder> climb(const Progress& progress) {
    std::vector<Rung> rungs = all_rungs(scenario_, shot_);
    if (shot_.cheapest_within) {
      const Result<Rung> chosen = chosen_rung();
      if (!chosen) return chosen.error();
      rungs.insert(rungs.begin(), *chosen);
    }
    std::vector<FlightSetting> settings;
    for (const Rung& rung : rungs) settings.push_back(rung.setting);
    settings.push_back({rotating(Fidelity::simulation(), shot_), scenario_.tolerance});
    const std::size_t work = settings.size() + rungs.size() + 1;  // flying, timing, and timing the reference
    const Result<Comparison> compared = compare(settings, [&](std::size_t done, std::size_t) {
      if (progress) progress(done, work);
    });
    if (!compared) return about(scenario_, shot_, compared.error());
    shot_.launch = compared->launch;
    PHYSIM_ASSERT(compared->flights.size() == settings.size());

    Ladder ladder{.shot = shot_.projectile.name};
    for (std::size_t i = 0; i < rungs.size(); ++i) {
      const ComparedFlight& flown = compared->flights[i];
      if (std::string reason = reason_to_leave_out(rungs[i], flown, compared->flights.back().flight); !reason.empty())
        ladder.left_out.push_back({rungs[i].name(), std::move(reason)});
      else
        ladder.rungs.push_back(result_of(compared->reference, rungs[i], flown));
      if (progress) progress(settings.size() + i + 1, work);
    }
    const Rung truth{Family::preset, "reference", "", reference_setting(shot_)};
    ladder.rungs.push_back(result_of(compared->reference, truth, {compared->reference, {}}));
    return ladder;
  }

 private:
  [[nodiscard]] Result<Comparison> compare(std::span<const FlightSetting> settings, const Progress& progress) const {
    return physim::compare(shot_.projectile, shot_.launch, scenario_.environment, settings, reference_setting(shot_),
                           scenario_.until, progress);
  }

  /// What the shot asks for by an error instead of rungs.
  [[nodiscard]] Result<Rung> chosen_rung() const {
    const Result<Comparison> reference = compare({}, {});
    if (!reference) return about(scenario_, shot_, reference.error());
    ScenarioShot started = shot_;
    started.launch = reference->launch;
    const Flight flight = fly_shot(scenario_, started);
    if (flight.error()) return refusal(scenario_, started, flight);
    Rung rung{Family::preset,
              "cheapest within " + significant(*shot_.cheapest_within, 4) + " m",
              "",
              {flight.fidelity_in_use().fidelity, scenario_.tolerance}};
    if (flight.step() > 0) rung.setting.tolerance.step = flight.step();
    return rung;
  }

  /// Why a flight has no place in the table; empty where it has one.
  static std::string reason_to_leave_out(const Rung& rung, const ComparedFlight& flown, const Flight& simulation) {
    if (!flown.problem.empty()) return flown.problem;
    const Flight& flight = flown.flight;
    const bool is_the_same =
        flight.fidelity_in_use().fidelity == simulation.fidelity_in_use().fidelity ||
        (flight.end().position == simulation.end().position && flight.duration() == simulation.duration());
    return rung.family == Family::effect && is_the_same ? "it changes nothing on this shot" : "";
  }

  [[nodiscard]] RungResult result_of(const Flight& reference, Rung rung, const ComparedFlight& flown) const {
    PHYSIM_ASSERT(flown.problem.empty());
    auto& [fidelity, tolerance] = rung.setting;
    if (flown.flight.step() > 0) tolerance.step = flown.flight.step();  // the cost is that without its pilot flight
    const double cost = median_time([&] {
      static_cast<void>(
          fly(shot_.projectile, shot_.launch, scenario_.environment, fidelity, tolerance, scenario_.until));
    });
    std::string leaves_out =
        physics_left_out(reference.fidelity_in_use().fidelity, flown.flight.fidelity_in_use().fidelity);
    return {std::move(rung), flown.flight, std::move(leaves_out), flown.end_distance, std::abs(flown.end_delay), cost};
  }

  const Scenario& scenario_;
  ScenarioShot shot_;
};

}  // namespace

std::string_view family_name(Family family) {
  constexpr std::string_view names[] = {"presets", "integrators", "effects"};
  PHYSIM_ASSERT(static_cast<int>(family) < kFamilies);
  return names[static_cast<int>(family)];
}

FlightSetting reference_setting(const ScenarioShot& shot) {
  return {rotating(Fidelity::reference(), shot), kReferenceTolerance};
}

FlightSetting preset_setting(const Scenario& scenario, std::string_view preset) {
  Tolerance tolerance = scenario.tolerance;
  const bool is_framed = preset == "arcade" || preset == "game";  // the others find their step by a pilot flight
  if (is_framed && tolerance.step == 0) tolerance.step = 1.0 / 60;
  const auto fidelity = fidelity_preset(preset);
  PHYSIM_ASSERT(fidelity.has_value());
  return {*fidelity, tolerance};
}

Result<Ladder> climb(const Scenario& scenario, const ScenarioShot& shot, const Progress& progress) {
  return Climber(scenario, shot).climb(progress);
}

}  // namespace physim::report
