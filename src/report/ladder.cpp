#include "report/ladder.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "flight/shot_groups.hpp"
#include "model/ladder.hpp"
#include "physim/names.hpp"
#include "prepare/fidelity_cost.hpp"
#include "prepare/grant.hpp"
#include "report/fidelity_text.hpp"
#include "report/flown.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"
#include "report/world_steps.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim::report {
namespace {

// ------------------------------------------------------------------------------------------------------ the rungs
/// A preset as a shot is compared on it. A shot that says its drag by a damping, or by k1 and k2, has no other data of
/// drag: every rung that knows drag takes those.
Fidelity for_shot(Fidelity preset, const ScenarioShot& shot) {
  const ProjectileDef& p = shot.projectile;
  const bool off_without_table = p.fidelity.drag == DragModel::off && p.drag.table == DragTable::constant;
  const bool by_factors =
      (p.fidelity.drag == DragModel::linear_quadratic || off_without_table) && (p.drag.k1 != 0 || p.drag.k2 != 0);
  if ((by_factors || p.fidelity.drag == DragModel::damping) && preset.drag != DragModel::off)
    preset.drag = p.fidelity.drag;
  return preset;
}

/// A preset with the Earth, gravity and rotation that the shot sets, if those are truer.
Fidelity at_least_as_asked(Fidelity preset, const Scenario& scenario, const ScenarioShot& shot) {
  preset = for_shot(preset, shot);
  const Fidelity& asked = shot.projectile.fidelity;
  preset.earth = higher_of(preset.earth, asked.earth);
  preset.gravity = higher_of(preset.gravity, asked.gravity);
  const RotationModel by_data = grant(preset, shot.projectile, scenario.environment).fidelity.rotation;
  const bool is_chosen = asked.rotation == RotationModel::automatic || asked.rotation == RotationModel::automatic_point;
  preset.rotation = is_chosen ? by_data : higher_of(by_data, asked.rotation);
  return preset;
}

/// Steps and tolerances belong to a rung: those that a scenario gives belong to its own rung.
Tolerance own_tolerance(const Scenario& scenario) {
  return {.position_error = scenario.tolerance.position_error, .max_steps = scenario.tolerance.max_steps};
}

// First those that take given steps, then those that choose their own; the original loop is no method to compare.
void add_integrators(const Scenario& scenario, const ScenarioShot& shot, std::vector<Rung>& rungs) {
  struct Setting {
    const char* text;
    double value;
  };
  const std::vector<Setting> steps = {{"1/60 s", 1.0 / 60}, {"10 ms", 0.01}, {"1 ms", 0.001}},
                             errors = {{"1e-3", 1e-3}, {"1e-6", 1e-6}, {"1e-9", 1e-9}, {"1e-12", 1e-12}};
  Fidelity fidelity = at_least_as_asked(Fidelity::simulation(), scenario, shot);
  for (const bool adaptive : {false, true})
    for (const Integrator integrator : all_rungs<Integrator>()) {
      if (is_chosen_by_rotation(integrator) || integrator == Integrator::classic) continue;
      if (is_adaptive(integrator) != adaptive) continue;
      fidelity.integrator = integrator;
      for (const auto& [text, value] : adaptive ? errors : steps) {
        Tolerance tolerance = own_tolerance(scenario);
        if (adaptive)
          tolerance.relative = tolerance.absolute = value;
        else
          tolerance.step = value;
        rungs.push_back({Family::integrator, std::string(name(integrator)), text, {fidelity, tolerance}});
      }
    }
}

void add_effects(const Scenario& scenario, const ScenarioShot& shot, std::vector<Rung>& rungs) {
  const Fidelity best = at_least_as_asked(Fidelity::simulation(), scenario, shot);
  const auto without = [&](const char* name, const std::function<void(Fidelity&)>& change) {
    Fidelity fidelity = best;
    change(fidelity);
    rungs.push_back({Family::effect, name, "", {fidelity, own_tolerance(scenario)}});
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
  coarse.relative = coarse.absolute = 1e-5;
}

/// Whether the shot is one of the original's kind: its velocity is damped, or constants act on it.
bool is_original(const ScenarioShot& shot) {
  const Fidelity& f = shot.projectile.fidelity;
  return f.drag == DragModel::damping || f.motion == Motion::velocity || f.integrator == Integrator::classic;
}

std::vector<Rung> all_rungs(const Scenario& scenario, const ScenarioShot& shot) {
  std::vector<Rung> rungs;
  for (const std::string_view preset : fidelity_presets())
    if (preset != "reference" && preset != "classic")
      rungs.push_back({Family::preset, std::string(preset), "", preset_setting(scenario, shot, preset)});
  if (is_original(shot)) {
    Fidelity velocity = Fidelity::classic();
    velocity.integrator = Integrator::semi_implicit_euler;
    rungs.push_back({Family::preset, "motion velocity", "", {velocity, own_tolerance(scenario)}});
    rungs.push_back({Family::preset, "classic", "", preset_setting(scenario, shot, "classic")});
  }
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

// ----------------------------------------------------------------------------------------------------------- beaten
/// The greatest of a measure over a flight.
template <class Measure>
double greatest(const Flight& flight, const Measure& measure) {
  constexpr int kPieces = 64;
  double out = 0;
  for (int i = 0; i <= kPieces; ++i) out = std::max(out, measure(flight.at(flight.duration() * i / kPieces).position));
  return out;
}

constexpr double kMicrometre = 1e-6;  // errors below are none [m]

/// The row that beats one: of those that may, the one of the least error, if that is smaller by 1 % at least; null if
/// none does.
template <class Row>
const Row* beater_of(const Row& row, const std::vector<Row>& rows, double (*error)(const Row&), const auto& may_beat) {
  const Row* best = nullptr;
  double least = 0.99 * error(row);
  for (const Row& other : rows)
    if (may_beat(other) && error(other) < least) best = &other, least = error(other);
  return best;
}

/// Marks rows that another row of their family beats: one that costs no more and has a smaller error. Errors below what
/// no measurement resolves, and below a rung's rounding, count as that.
void mark_beaten(Ladder& ladder) {
  constexpr double kResolved = 1e-8, kRoundings = 128;  // of the flight's greatest distance
  PHYSIM_ASSERT(!ladder.rungs.empty());
  const Flight& reference = ladder.rungs.back().flight;
  const double extent = greatest(reference, [](const Vec3d& place) { return length(place); });
  for (RungResult& result : ladder.rungs) {
    const Fidelity& f = result.flight.fidelity_in_use().fidelity;
    const double part = std::max(kResolved, kRoundings * row(f.precision).rounding);
    result.resolved = std::max({result.largest, part * extent, kMicrometre});
  }
  for (RungResult& result : ladder.rungs) {
    if (result.rung.family == Family::effect) continue;  // what leaves an effect out shows what that is worth
    const auto may_beat = [&](const RungResult& other) {
      return other.rung.family == result.rung.family && other.holds() && other.work <= result.work;
    };
    const auto error = +[](const RungResult& each) { return each.resolved; };
    if (const RungResult* other = beater_of(result, ladder.rungs, error, may_beat))
      result.beaten_by = other->rung.name();
  }
}

/// As mark_beaten(), of the steps of a world, whose costs are measured.
void mark_beaten_steps(std::vector<StepsOfRung>& steps) {
  for (StepsOfRung& rung : steps) {
    const auto may_beat = [&](const StepsOfRung& other) { return other.cost <= rung.cost; };
    const auto error = +[](const StepsOfRung& each) { return std::max(each.largest, kMicrometre); };
    if (const StepsOfRung* other = beater_of(rung, steps, error, may_beat)) rung.beaten_by = other->name;
  }
}

// --------------------------------------------------------------------------------------------------------- climbing
class Climber {
  static constexpr double kHighestConstantAir = 10e3;  // a third of the density is left there [m]

 public:
  Climber(const Scenario& scenario, const ScenarioShot& shot, bool presets_alone)
      : scenario_(scenario), shot_(shot), presets_alone_(presets_alone) {}

  Result<Ladder> climb(const Progress& progress) {
    std::vector<Rung> rungs = all_rungs(scenario_, shot_);
    if (presets_alone_) std::erase_if(rungs, [](const Rung& rung) { return rung.family != Family::preset; });
    if (shot_.cheapest_within && !presets_alone_) {
      const Result<Rung> chosen = chosen_rung();
      if (!chosen) return chosen.error();
      rungs.insert(rungs.begin(), *chosen);
    }
    std::vector<FlightSetting> settings;
    for (const Rung& rung : rungs) settings.push_back(rung.setting);
    settings.push_back({at_least_as_asked(Fidelity::simulation(), scenario_, shot_), own_tolerance(scenario_)});
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
    const Rung truth{Family::preset, "reference", "", reference_setting(scenario_, shot_)};
    ladder.rungs.push_back(result_of(compared->reference, truth, {compared->reference, {}}));
    mark_beaten(ladder);
    if (!presets_alone_) add_steps(ladder);
    return ladder;
  }

 private:
  /// What each preset is worth in a world.
  void add_steps(Ladder& ladder) const {
    WorldDef def = scenario_.world.def;
    def.environment = scenario_.environment;
    ScenarioShot shot = shot_;
    const Flight& reference = ladder.rungs.back().flight;
    for (const RungResult& result : ladder.rungs) {
      if (result.rung.family != Family::preset) continue;
      shot.projectile.fidelity = result.rung.setting.fidelity;
      const std::optional<double> largest = error_of_steps(def, shot, kGameFrame, reference);
      const std::optional<double> cost = time_of_step(def, shot, kGameFrame);
      if (!largest || !cost) continue;
      std::string leaves_out = result.leaves_out;
      if (drifts(result.flight.fidelity_in_use().fidelity))
        leaves_out += (leaves_out.empty() ? "" : "; ") + std::string("rotation none");
      ladder.steps.push_back({result.rung.name(), *largest, *cost, std::move(leaves_out)});
    }
    mark_beaten_steps(ladder.steps);
  }

  [[nodiscard]] Result<Comparison> compare(std::span<const FlightSetting> settings, const Progress& progress) const {
    return physim::compare(shot_.projectile, shot_.launch, scenario_.environment, settings,
                           reference_setting(scenario_, shot_), scenario_.until, progress);
  }

  /// The setting of a shot that gives an error instead of rungs.
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
    const double cost = presets_alone_ ? 0 : median_time([&] {
      static_cast<void>(
          fly(shot_.projectile, shot_.launch, scenario_.environment, in.fidelity, in.tolerance, scenario_.until));
    });
    const Fidelity& granted = flown.flight.fidelity_in_use().fidelity;
    const FlightCost& steps = flown.flight.cost();
    const bool is_constant = granted.drag != DragModel::off && granted.air == AirModel::constant;
    const bool is_high =
        greatest(reference, [](const Vec3d& place) { return std::abs(place.y); }) > kHighestConstantAir;
    return {.rung = std::move(rung),
            .flight = flown.flight,
            .leaves_out = physics_left_out(reference.fidelity_in_use().fidelity, granted),
            .error = flown.end_distance,
            .largest = flown.largest_distance,
            .time_error = std::abs(flown.end_delay),
            .cost = cost,
            .work = step_cost(granted, shot_.projectile, scenario_.environment) *
                    static_cast<double>(std::max<std::int64_t>(steps.steps + steps.rejected, 1)),
            .doubt = is_constant && is_high && scenario_.environment.atmosphere.model != AirModel::constant
                         ? "constant air does not hold on this flight, which leaves the lowest 10 km"
                         : ""};
  }

  const Scenario& scenario_;
  ScenarioShot shot_;
  bool presets_alone_;
};

// ------------------------------------------------------------------------------------------------------------ texts
constexpr double kMicro = 1e6, kNano = 1e9;

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
          significant(result.largest, 3),
          significant(result.time_error, 3),
          std::to_string(cost.steps),
          std::to_string(cost.evaluations),
          readable(result.cost * kMicro, 3),
          result.beaten_by.empty() ? "-" : result.beaten_by,
          leaves_out.empty() ? "-" : leaves_out};
}

}  // namespace

std::string_view family_name(Family family) {
  constexpr std::string_view names[] = {"presets", "integrators", "effects"};
  PHYSIM_ASSERT(static_cast<int>(family) < kFamilies);
  return names[static_cast<int>(family)];
}

FlightSetting reference_setting(const Scenario& scenario, const ScenarioShot& shot) {
  return {at_least_as_asked(Fidelity::reference(), scenario, shot), kReferenceTolerance};
}

FlightSetting preset_setting(const Scenario& scenario, const ScenarioShot& shot, std::string_view preset) {
  const auto fidelity = fidelity_preset(preset);
  PHYSIM_ASSERT(fidelity.has_value());
  return {for_shot(*fidelity, shot), own_tolerance(scenario)};
}

Result<FlightSetting> own_setting(const Scenario& scenario, const ScenarioShot& shot) {
  FlightSetting setting{shot.projectile.fidelity, scenario.tolerance};
  if (!shot.cheapest_within) return setting;
  const Result<Comparison> reference = compare(shot.projectile, shot.launch, scenario.environment, {},
                                               reference_setting(scenario, shot), scenario.until);
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
  return Climber(scenario, shot, false).climb(progress);
}

Result<Ladder> climb_presets(const Scenario& scenario, const ScenarioShot& shot) {
  return Climber(scenario, shot, true).climb({});
}

std::string ladder_text(const LadderOfShot& subject, const Style& style) {
  const auto& [scenario, ladder] = subject;
  PHYSIM_ASSERT(!ladder.rungs.empty());
  std::string out = style.bold(one_line(title_of(scenario))) + ": " + one_line(ladder.shot) + "\n";
  const RungResult& reference = ladder.rungs.back();
  const Sample end = reference.flight.end();
  out +=
      "The reference " + std::string(name(reference.flight.outcome())) + " at " + fixed(end.time, 6) + " s, " +
      fixed(end.range, 4) + " m downrange, height " + fixed(end.position.y, 4) + " m, windage " +
      fixed(end.windage, 4) +
      " m. Errors are distances from there, and at worst from where the reference is at the same time.\nCost is the "
      "median time of one fly() on this machine. A rung that costs no less and errs more than another is beaten.\n\n";
  Table table({"rung", "error [m]", "at worst [m]", "time error [s]", "steps [-]", "evaluations [-]", "cost [us]",
               "beaten by", "leaves out"},
              "lrrrrrrll");
  std::string family;
  for (const RungResult& result : ladder.rungs) {
    const std::string next = family_text(ladder, result);
    if (next != family) table.add_row({style.dim("- " + next)});
    family = next;
    table.add_row(row(result));
  }
  out += table.text();
  for (const RungResult& result : ladder.rungs)
    if (!result.holds()) out += "doubtful: " + result.rung.name() + ": " + result.doubt + "\n";
  if (!ladder.steps.empty()) {
    out +=
        "\nIn a world of 60 steps a second: the greatest distance from the reference at any frame, and what a step of "
        "one\n"
        "projectile costs on this machine, by one thread among a thousand that are alike.\n\n";
    Table steps({"rung", "at worst [m]", "a step [ns]", "beaten by", "leaves out"}, "lrrll");
    for (const StepsOfRung& rung : ladder.steps)
      steps.add_row({rung.name, significant(rung.largest, 3), readable(rung.cost * kNano, 3),
                     rung.beaten_by.empty() ? "-" : rung.beaten_by, rung.leaves_out.empty() ? "-" : rung.leaves_out});
    out += steps.text();
  }
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
                          result.largest,
                          result.time_error,
                          static_cast<std::uint64_t>(cost.steps),
                          static_cast<std::uint64_t>(cost.evaluations),
                          result.cost * kMicro,
                          result.work,
                          result.beaten_by,
                          name(result.flight.outcome()),
                          result.leaves_out};
      take(row);
    }
  };
  return {{"shot", "family", "rung", "error [m]", "at worst [m]", "time error [s]", "steps [-]", "evaluations [-]",
           "cost [us]", "work [operations]", "beaten by", "outcome", "leaves out"},
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
      JsonStream::Json rung = {{"rung", result.rung.name()},
                               {"family", family_text(ladder, result)},
                               {"error [m]", result.error},
                               {"at_worst [m]", result.largest},
                               {"time error [s]", result.time_error},
                               {"cost [us]", result.cost * kMicro},
                               {"work [operations]", result.work},
                               {"beaten_by", result.beaten_by},
                               {"doubt", result.doubt},
                               {"leaves_out", result.leaves_out}};
      rung.update(flight_json(result.flight, result.rung.setting.fidelity));
      out.push(std::move(rung));
    }
    out.close();
    out.list("steps_of_a_world");
    for (const StepsOfRung& rung : ladder.steps)
      out.push({{"rung", rung.name},
                {"at_worst [m]", rung.largest},
                {"a step [ns]", rung.cost * kNano},
                {"beaten_by", rung.beaten_by},
                {"leaves_out", rung.leaves_out}});
    out.close();
    out.list("left_out");
    for (const RungLeftOut& rung : ladder.left_out) out.push({{"rung", rung.name}, {"reason", rung.reason}});
    out.close();
    out.close();
  };
}

}  // namespace physim::report
