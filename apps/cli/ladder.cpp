#include "ladder.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "fidelity_text.hpp"
#include "flown.hpp"
#include "model/ladder.hpp"
#include "output_number.hpp"
#include "physim/names.hpp"
#include "progress.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim::cli {
namespace {

// ------------------------------------------------------------------------------------------------------ the rungs
void add_presets(const Scenario& scenario, std::vector<Rung>& rungs) {
  const auto preset = [&](const char* name, double step) {
    Tolerance tolerance = scenario.tolerance;
    if (tolerance.step == 0) tolerance.step = step;
    rungs.push_back({Family::preset, name, "", *fidelity_preset(name), tolerance});
  };
  preset("arcade", 1.0 / 60);
  preset("game", 1.0 / 60);
  preset("sport_ball", 0);  // a pilot flight finds the step
  for (const char* name : {"small_arms", "artillery", "simulation"}) preset(name, 0);
}

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
    rungs.push_back({Family::integrator, std::string(name(integrator)), detail, fidelity, tolerance});
  };
  struct Setting {
    const char* text;
    double value;
  };
  for (const Integrator integrator : stepped_by(false))
    for (const auto& [text, step] : {Setting{"1/60 s", 1.0 / 60}, {"10 ms", 0.01}, {"1 ms", 0.001}}) {
      Tolerance tolerance = scenario.tolerance;
      tolerance.step = step;
      add(integrator, text, tolerance);
    }
  for (const Integrator integrator : stepped_by(true))
    for (const auto& [text, error] : {Setting{"1e-3", 1e-3}, {"1e-6", 1e-6}, {"1e-9", 1e-9}, {"1e-12", 1e-12}}) {
      Tolerance tolerance = scenario.tolerance;
      tolerance.relative = tolerance.absolute = error;
      add(integrator, text, tolerance);
    }
}

void add_effects(const Scenario& scenario, const ScenarioShot& shot, std::vector<Rung>& rungs) {
  const Fidelity best = rotating(Fidelity::simulation(), shot);
  const auto without = [&](const char* name, const std::function<void(Fidelity&)>& change) {
    Fidelity fidelity = best;
    change(fidelity);
    rungs.push_back({Family::effect, name, "", fidelity, scenario.tolerance});
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
  Tolerance& coarse = rungs.back().tolerance;
  coarse.relative = coarse.absolute = std::max(coarse.relative.value_or(0), 1e-5);
}

std::vector<Rung> all_rungs(const Scenario& scenario, const ScenarioShot& shot) {
  std::vector<Rung> rungs;
  add_presets(scenario, rungs);
  add_integrators(scenario, shot, rungs);
  add_effects(scenario, shot, rungs);
  return rungs;
}

// ---------------------------------------------------------------------------------------------- flying and timing
class Climber {
 public:
  Climber(const Scenario& scenario, const ScenarioShot& shot) : scenario_(scenario), shot_(shot) {}

  [[nodiscard]] Flight fly_rung(const Fidelity& fidelity, const Tolerance& tolerance) const {
    return fly(shot_.projectile, shot_.launch, scenario_.environment, fidelity, tolerance, scenario_.until);
  }

  /// From here on the launch is what a flight started with: the bore's elevation is known and no longer looked for.
  void start_as(const Flight& flight) {
    shot_.launch.velocity = flight.at(0).velocity;
    shot_.launch.speed = shot_.launch.elevation = shot_.launch.azimuth = 0;
    shot_.launch.sight.zero_range = 0;
  }

  /// What the shot asks for by an error instead of rungs.
  [[nodiscard]] Result<Rung> chosen_rung() const {
    const Flight flight = fly_shot(scenario_, shot_);
    if (flight.error()) return refusal(scenario_, shot_, flight);
    Rung rung{Family::preset, "cheapest within " + significant(*shot_.cheapest_within, 4) + " m", "",
              flight.fidelity_in_use().fidelity, scenario_.tolerance};
    if (flight.step() > 0) rung.tolerance.step = flight.step();
    return rung;
  }

  /// Median time of one fly() [s]: of samples that are each long enough for the clock, at least three of them unless
  /// the flight itself is a long one.
  [[nodiscard]] double cost_of(const Fidelity& fidelity, const Tolerance& tolerance) const {
    using Clock = std::chrono::steady_clock;
    constexpr double kSample = 100e-6, kBudget = 20e-3, kPatience = 100e-3;  // [s]
    constexpr std::size_t kFewest = 3, kMost = 101;
    double spent = 0;
    const auto time_of = [&](int flights) {
      const auto start = Clock::now();
      for (int i = 0; i < flights; ++i) static_cast<void>(fly_rung(fidelity, tolerance));
      const double time = std::chrono::duration<double>(Clock::now() - start).count();
      spent += time;
      return time / flights;
    };
    const double first = std::max(time_of(1), 1e-8);  // warms the caches up
    if (spent >= kPatience) return first;
    const int flights = std::clamp(static_cast<int>(kSample / first), 1, 1000);
    std::vector<double> times;
    while (times.size() < kMost && spent < (times.size() < kFewest ? kPatience : kBudget))
      times.push_back(time_of(flights));
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return *middle;
  }

 private:
  const Scenario& scenario_;
  ScenarioShot shot_;
};

RungResult result_of(const Climber& climber, const Flight& reference, Rung rung, Flight flight) {
  if (flight.step() > 0) rung.tolerance.step = flight.step();  // the cost is that of the flight, without its pilot
  const double cost = climber.cost_of(rung.fidelity, rung.tolerance);
  const double error = length(flight.end().position - reference.end().position);
  const double time_error = std::abs(flight.duration() - reference.duration());
  std::string leaves_out = physics_left_out(reference.fidelity_in_use().fidelity, flight.fidelity_in_use().fidelity);
  return {std::move(rung), std::move(flight), std::move(leaves_out), error, time_error, cost};
}

// Why a flight has no place in the table; empty where it has one.
std::string reason_to_leave_out(const Rung& rung, const Flight& flight, const Flight& simulation) {
  if (flight.error()) return flight.error()->message;
  if (!ended_as_planned(flight.outcome())) return "its flight ended with " + std::string(name(flight.outcome()));
  const bool is_the_same =
      flight.fidelity_in_use().fidelity == simulation.fidelity_in_use().fidelity ||
      (flight.end().position == simulation.end().position && flight.duration() == simulation.duration());
  return rung.family == Family::effect && is_the_same ? "it changes nothing on this shot" : "";
}

}  // namespace

std::string_view family_name(Family family) {
  constexpr std::string_view names[] = {"presets", "integrators", "effects"};
  return names[static_cast<int>(family)];
}

Result<Ladder> climb(const Scenario& scenario, const ScenarioShot& shot) {
  Climber climber(scenario, shot);
  const Fidelity truest = rotating(Fidelity::reference(), shot);
  Flight reference = climber.fly_rung(truest, kReferenceTolerance);
  if (reference.outcome() == Outcome::refused) return refusal(scenario, shot, reference);
  if (!ended_as_planned(reference.outcome()))
    return Error{.message = "the reference flight ended with " + std::string(name(reference.outcome())),
                 .place = scenario.file,
                 .hint = "give it an end that it reaches, as until.ground, until.range or until.time"};
  climber.start_as(reference);
  reference = climber.fly_rung(truest, kReferenceTolerance);
  const Flight simulation = climber.fly_rung(rotating(Fidelity::simulation(), shot), scenario.tolerance);

  Ladder ladder{.shot = shot.projectile.name};
  std::vector<Rung> rungs = all_rungs(scenario, shot);
  if (shot.cheapest_within) {
    const Result<Rung> chosen = climber.chosen_rung();
    if (!chosen) return chosen.error();
    rungs.insert(rungs.begin(), *chosen);
  }
  Progress progress("comparing", rungs.size() + 1);
  for (const Rung& rung : rungs) {
    Flight flight = climber.fly_rung(rung.fidelity, rung.tolerance);
    if (std::string reason = reason_to_leave_out(rung, flight, simulation); !reason.empty())
      ladder.left_out.push_back({rung.name(), std::move(reason)});
    else
      ladder.rungs.push_back(result_of(climber, reference, rung, std::move(flight)));
    progress.advance();
  }
  const Rung truth{Family::preset, "reference", "", truest, kReferenceTolerance};
  ladder.rungs.push_back(result_of(climber, reference, truth, reference));
  return ladder;
}

}  // namespace physim::cli
