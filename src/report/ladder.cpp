#include "report/ladder.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "model/ladder.hpp"
#include "physim/names.hpp"
#include "report/fidelity_text.hpp"
#include "report/flown.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim::report {
namespace {

// ------------------------------------------------------------------------------------------------------ the rungs
/// A fidelity with the rotation that the shot asks for, where that is more.
Fidelity rotating(Fidelity fidelity, const ScenarioShot& shot) {
  fidelity.rotation = higher_of(fidelity.rotation, shot.projectile.fidelity.rotation);
  return fidelity;
}

// First those that take given steps, then those that choose their own; the original loop is no method to compare.
void add_integrators(const Scenario& scenario, const ScenarioShot& shot, std::vector<Rung>& rungs) {
  struct Setting {
    const char* text;
    double value;
  };
  const std::vector<Setting> steps = {{"1/60 s", 1.0 / 60}, {"10 ms", 0.01}, {"1 ms", 0.001}},
                             errors = {{"1e-3", 1e-3}, {"1e-6", 1e-6}, {"1e-9", 1e-9}, {"1e-12", 1e-12}};
  Fidelity fidelity = rotating(Fidelity::simulation(), shot);
  for (const bool adaptive : {false, true})
    for (const Integrator integrator : all_rungs<Integrator>()) {
      if (integrator == Integrator::classic || is_adaptive(integrator) != adaptive) continue;
      fidelity.integrator = integrator;
      for (const auto& [text, value] : adaptive ? errors : steps) {
        Tolerance tolerance = scenario.tolerance;
        if (adaptive)
          tolerance.relative = tolerance.absolute = value;
        else
          tolerance.step = value;
        rungs.push_back({Family::integrator, std::string(name(integrator)), text, {fidelity, tolerance}});
      }
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
    const Result<FlightSetting> chosen = own_setting(scenario_, shot_);
    if (!chosen) return chosen.error();
    return Rung{Family::preset, "cheapest within " + significant(*shot_.cheapest_within, 4) + " m", "", *chosen};
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
    FlightSetting& in = rung.setting;
    if (flown.flight.step() > 0) in.tolerance.step = flown.flight.step();  // the cost is that without its pilot flight
    const double cost = median_time([&] {
      static_cast<void>(
          fly(shot_.projectile, shot_.launch, scenario_.environment, in.fidelity, in.tolerance, scenario_.until));
    });
    std::string leaves_out =
        physics_left_out(reference.fidelity_in_use().fidelity, flown.flight.fidelity_in_use().fidelity);
    return {std::move(rung), flown.flight, std::move(leaves_out), flown.end_distance, std::abs(flown.end_delay), cost};
  }

  const Scenario& scenario_;
  ScenarioShot shot_;
};

// ------------------------------------------------------------------------------------------------------------ texts
constexpr double kMicro = 1e6;

bool is_reference(const Ladder& ladder, const RungResult& result) { return &result == &ladder.rungs.back(); }

std::string family_text(const Ladder& ladder, const RungResult& result) {
  return is_reference(ladder, result) ? "reference" : std::string(family_name(result.rung.family));
}

std::vector<std::string> row(const RungResult& result) {
  const FlightCost& cost = result.flight.cost();
  std::string leaves_out = result.leaves_out;
  if (result.flight.fidelity_in_use().fidelity.precision == Precision::float32)
    leaves_out += (leaves_out.empty() ? "" : "; ") + std::string("float32");
  return {result.rung.name(),
          significant(result.error, 3),
          significant(result.time_error, 3),
          std::to_string(cost.steps),
          std::to_string(cost.evaluations),
          readable(result.cost * kMicro, 3),
          leaves_out.empty() ? "-" : leaves_out};
}

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

Result<FlightSetting> own_setting(const Scenario& scenario, const ScenarioShot& shot) {
  FlightSetting setting{shot.projectile.fidelity, scenario.tolerance};
  if (!shot.cheapest_within) return setting;
  const Result<Comparison> reference =
      compare(shot.projectile, shot.launch, scenario.environment, {}, reference_setting(shot), scenario.until);
  if (!reference) return about(scenario, shot, reference.error());
  ScenarioShot started = shot;
  started.launch = reference->launch;
  const Flight flight = fly_shot(scenario, started);
  if (flight.error()) return refusal(scenario, started, flight);
  setting.fidelity = flight.fidelity_in_use().fidelity;
  if (flight.step() > 0) setting.tolerance.step = flight.step();
  return setting;
}

Result<Ladder> climb(const Scenario& scenario, const ScenarioShot& shot, const Progress& progress) {
  return Climber(scenario, shot).climb(progress);
}

std::string ladder_text(const LadderOfShot& subject, const Style& style) {
  const auto& [scenario, ladder] = subject;
  PHYSIM_ASSERT(!ladder.rungs.empty());
  std::string out = style.bold(one_line(title_of(scenario))) + ": " + one_line(ladder.shot) + "\n";
  const RungResult& reference = ladder.rungs.back();
  const Sample end = reference.flight.end();
  out += "The reference " + std::string(name(reference.flight.outcome())) + " at " + fixed(end.time, 6) + " s, " +
         fixed(end.range, 4) + " m downrange, height " + fixed(end.position.y, 4) + " m, windage " +
         fixed(end.windage, 4) +
         " m. Errors are distances from there.\nCost is the median time of one fly() on this machine.\n\n";
  Table table({"rung", "error [m]", "time error [s]", "steps [-]", "evaluations [-]", "cost [us]", "leaves out"},
              "lrrrrrl");
  std::string family;
  for (const RungResult& result : ladder.rungs) {
    const std::string next = family_text(ladder, result);
    if (next != family) table.add_row({style.dim("- " + next)});
    family = next;
    table.add_row(row(result));
  }
  out += table.text();
  for (const RungLeftOut& rung : ladder.left_out) out += "not shown: " + rung.name + ": " + rung.reason + "\n";
  return out;
}

Records records_of(const LadderOfShot& subject) {
  const auto rows = [&ladder = subject.ladder](const auto& take) {
    for (const RungResult& result : ladder.rungs) {
      const FlightCost& cost = result.flight.cost();
      const std::string family = family_text(ladder, result), rung = result.rung.name();
      const Cell row[] = {ladder.shot,
                          family,
                          rung,
                          result.error,
                          result.time_error,
                          static_cast<std::uint64_t>(cost.steps),
                          static_cast<std::uint64_t>(cost.evaluations),
                          result.cost * kMicro,
                          name(result.flight.outcome()),
                          result.leaves_out};
      take(row);
    }
  };
  return {{"shot", "family", "rung", "error [m]", "time error [s]", "steps [-]", "evaluations [-]", "cost [us]",
           "outcome", "leaves out"},
          rows};
}

Content ladder_json(const LadderOfShot& subject) {
  return [subject](const Sink& sink) {
    const auto& [scenario, ladder] = subject;
    JsonStream out(sink);
    out.object();
    add_provenance(out, scenario);
    out.add({{"shot", ladder.shot}, {"cost", "cost [us] is the median time of one fly()"}});
    out.list("rungs");
    for (const RungResult& result : ladder.rungs) {
      JsonStream::Json rung = {{"rung", result.rung.name()},        {"family", family_text(ladder, result)},
                               {"error [m]", result.error},         {"time error [s]", result.time_error},
                               {"cost [us]", result.cost * kMicro}, {"leaves_out", result.leaves_out}};
      rung.update(flight_json(result.flight, result.rung.setting.fidelity));
      out.push(std::move(rung));
    }
    out.close();
    out.list("left_out");
    for (const RungLeftOut& rung : ladder.left_out) out.push({{"rung", rung.name}, {"reason", rung.reason}});
    out.close();
    out.close();
  };
}

}  // namespace physim::report
