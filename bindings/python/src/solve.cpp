// Questions asked backwards, fits, auto fidelity and comparisons.
#include "physim/solve.hpp"

#include <optional>

#include "report/ladder.hpp"
#include "setup.hpp"

namespace physim::python {
namespace {

/// Of a setup and one of its shots: what the library's questions are asked with.
struct Asked {
  const Setup& setup;
  const ScenarioShot& shot;
  ProjectileDef projectile;

  Asked(const Setup& s, const std::string& name) : setup(s), shot(s.shot(name)), projectile(projectile_of(shot)) {}
  [[nodiscard]] const Environment& environment() const { return setup.scenario.environment; }
  [[nodiscard]] const Launch& launch() const { return shot.launch; }

  template <class Work>
  auto run(const Work& work) const {
    auto result = [&] {
      const Released free;
      return work();
    }();
    setup.raise_kept();
    return taken(std::move(result));
  }
  /// The setup with another launch of this shot.
  [[nodiscard]] SetupPtr with(const Launch& launch, const ProjectileDef* projectile_def = nullptr) const {
    Scenario changed = setup.scenario;
    for (ScenarioShot& each : changed.shots)
      if (each.projectile.name == shot.projectile.name) {
        each.launch = launch;
        if (projectile_def != nullptr) each.projectile = *projectile_def;
      }
    return setup.with(changed);
  }
};

nb::dict solution_table(const AimSolution& s) {
  nb::dict out;
  out["elevation"] = s.launch.elevation;
  out["azimuth"] = s.launch.azimuth;
  out["miss"] = s.miss;
  out["time"] = s.time;
  out["position"] = array_of(s.position);
  out["velocity"] = array_of(s.velocity);
  out["speed"] = s.speed;
  out["descent"] = s.descent;
  return out;
}

template <class T, class Table>
nb::object table_or_none(const std::optional<T>& value, const Table& table) {
  return value ? nb::object(table(*value)) : nb::none();
}

nb::dict aim_setup(const Setup& setup, const std::string& name, const std::vector<double>& position,
                   const std::vector<double>& velocity, const std::vector<double>& acceleration, const std::string& arc,
                   double tolerance, std::optional<double> ground, double time) {
  const Asked asked(setup, name);
  const Target target{vec_of(position, "position"), vec_of(velocity, "velocity"), vec_of(acceleration, "acceleration")};
  AimOptions options{.tolerance = tolerance, .ground = ground, .time = time, .flight = setup.scenario.tolerance};
  const auto wanted = value_of<Arc>(arc);
  if (!wanted) fail("unknown arc \"" + arc + "\"", "arc", "known are low, high, both");
  options.arc = *wanted;
  if (setup.scene) options.scene = &*setup.scene, options.contact = contact_of(asked.shot);
  const Aim answer = asked.run([&] {
    return aim(asked.projectile, asked.launch(), asked.environment(), asked.projectile.fidelity, target, options);
  });
  nb::dict out;
  out["low"] = table_or_none(answer.low, solution_table);
  out["high"] = table_or_none(answer.high, solution_table);
  out["nearest"] = solution_table(answer.nearest);
  out["behind_ground"] = answer.behind_ground;
  nb::list blocked;
  for (const BlockedWay& way : answer.blocked)
    blocked.append(nb::make_tuple(solution_table(way.solution), event_table(way.hit)));
  out["blocked"] = blocked;
  out["sight_ends"] = table_or_none(answer.sight_ends, event_table);
  out["flights"] = answer.flights;
  out["explanation"] = answer.explanation();
  out["notes"] = notes_table(answer.fidelity_in_use);
  return out;
}

/// The shot as it hits: aimed in a plain sight.
SetupPtr aimed(const Setup& setup, const std::string& name, double elevation, double azimuth) {
  const Asked asked(setup, name);
  Launch launch = asked.launch();
  launch.elevation = elevation, launch.azimuth = azimuth, launch.velocity.reset(), launch.sight = {};
  return asked.with(launch);
}

nb::dict max_range_of(const Setup& setup, const std::string& name, double ground, double slope, double time) {
  const Asked asked(setup, name);
  const MaxRange far = asked.run([&] {
    return max_range(asked.projectile, asked.launch(), asked.environment(), asked.projectile.fidelity, ground, slope,
                     time);
  });
  nb::dict out;
  out["elevation"] = far.elevation, out["range"] = far.range, out["time"] = far.time;
  out["position"] = array_of(far.position), out["velocity"] = array_of(far.velocity), out["flights"] = far.flights;
  return out;
}

std::optional<double> number_or_none(nb::handle numbers, std::size_t i) {
  if (numbers.is_none()) return std::nullopt;
  Numbers column;
  if (!nb::try_cast<Numbers>(numbers, column, false)) fail("is no column of float64", "measurements");
  const double value = column.data()[i];
  return value == value ? std::optional(value) : std::nullopt;  // NaN: not measured
}

nb::tuple fit_setup(const Setup& setup, const std::string& name, const Numbers& ranges, nb::handle speeds,
                    nb::handle drops, nb::handle times, bool muzzle_speed, double speed_error, double drop_error,
                    double time_error) {
  const Asked asked(setup, name);
  std::vector<Measurement> all;
  for (std::size_t i = 0; i < ranges.size(); ++i)
    all.push_back({ranges.data()[i], number_or_none(speeds, i), number_or_none(drops, i), number_or_none(times, i)});
  const FitOptions options{muzzle_speed, speed_error, drop_error, time_error};
  const Fit fit = asked.run([&] {
    return fit_drag(asked.shot.projectile, asked.launch(), asked.environment(), asked.shot.projectile.fidelity, all,
                    options);
  });
  nb::dict out;
  out["scale"] = fit.scale, out["scale_error"] = fit.scale_error;
  out["speed"] = fit.launch.speed, out["speed_error"] = fit.muzzle_speed_error;
  out["rms"] = fit.rms, out["flights"] = fit.flights;
  nb::list residuals;
  for (const FitResidual& r : fit.residuals)
    residuals.append(nb::make_tuple(r.measurement, r.quantity, r.measured, r.computed));
  out["residuals"] = residuals;
  return nb::make_tuple(out, asked.with(fit.launch, &fit.projectile));
}

nb::dict fidelity_table(const Fidelity& f) {
  nb::dict out;
  const auto say = [&](const char* effect, auto value) { out[effect] = std::string(physim::name(value)); };
  say("motion", f.motion), say("integrator", f.integrator), say("gravity", f.gravity), say("drag", f.drag);
  say("air", f.air), say("wind", f.wind), say("earth", f.earth), say("rotation", f.rotation);
  say("body_form", f.body_form), say("precision", f.precision), say("interpolation", f.interpolation);
  return out;
}

nb::dict cheapest_of(const Setup& setup, const std::string& name, double error, double time, double step,
                     std::optional<double> ground) {
  const Asked asked(setup, name);
  const Purpose purpose{.error = error, .time = time, .step = step, .ground = ground};
  const AutoFidelity found =
      asked.run([&] { return cheapest_within(asked.projectile, asked.launch(), asked.environment(), purpose); });
  nb::dict out;
  out["fidelity"] = fidelity_table(found.fidelity);
  out["step"] = found.step, out["error"] = found.error, out["cost"] = found.cost;
  out["truth_cost"] = found.truth_cost, out["truth_error"] = found.truth_error, out["time"] = found.time;
  out["explanation"] = found.explanation();
  return out;
}

/// Each preset of fidelity beside the reference, as `physim compare` shows them.
nb::dict compare_presets(const Setup& setup, const std::string& name, const std::vector<std::string>& presets) {
  const Asked asked(setup, name);
  std::vector<FlightSetting> settings;
  for (const std::string& preset : presets) {
    if (!fidelity_preset(preset))
      fail("unknown fidelity \"" + preset + "\"", "fidelities", "physim.fidelities() lists all");
    settings.push_back(report::preset_setting(setup.scenario, asked.shot, preset));
  }
  const Until until = setup.until(asked.shot);
  const Comparison found = asked.run([&] {
    return compare(asked.projectile, asked.launch(), asked.environment(), settings,
                   report::reference_setting(setup.scenario, asked.shot), until);
  });
  nb::list flights;
  for (const ComparedFlight& each : found.flights) {
    nb::dict row;
    row["flight"] = each.flight;
    row["problem"] = each.problem;
    row["end_distance"] = each.end_distance, row["largest_distance"] = each.largest_distance;
    row["end_delay"] = each.end_delay;
    row["steps"] = each.flight.cost().steps, row["evaluations"] = each.flight.cost().evaluations;
    flights.append(row);
  }
  nb::dict out;
  out["reference"] = found.reference;
  out["flights"] = flights;
  return out;
}

}  // namespace

void add_solve(nb::module_& m) {
  m.def("aim", &aim_setup, "setup"_a, "shot"_a, "position"_a, "velocity"_a, "acceleration"_a, "arc"_a, "tolerance"_a,
        "ground"_a.none(), "time"_a, "Directions that hit a target.");
  m.def("aimed", &aimed, "setup"_a, "shot"_a, "elevation"_a, "azimuth"_a, "The shot in another direction.");
  m.def("max_range", &max_range_of, "setup"_a, "shot"_a, "ground"_a, "slope"_a, "time"_a,
        "The elevation that carries farthest.");
  m.def("fit", &fit_setup, "setup"_a, "shot"_a, "ranges"_a, "speeds"_a.none(), "drops"_a.none(), "times"_a.none(),
        "muzzle_speed"_a, "speed_error"_a, "drop_error"_a, "time_error"_a, "Drag out of measurements.");
  m.def("cheapest_within", &cheapest_of, "setup"_a, "shot"_a, "error"_a, "time"_a, "step"_a, "ground"_a.none(),
        "The cheapest fidelity within an error of the truth.");
  m.def("compare", &compare_presets, "setup"_a, "shot"_a, "fidelities"_a, "Presets of fidelity beside the reference.");
  m.def(
      "stability_factor",
      [](const Setup& setup, const std::string& name) {
        const Asked asked(setup, name);
        return stability_factor(asked.projectile, asked.launch(), asked.environment());
      },
      "setup"_a, "shot"_a, "Miller's gyroscopic stability factor at the muzzle, or None.");
  m.def(
      "time_to_range",
      [](const Setup& setup, const std::string& name, double range) {
        const Asked asked(setup, name);
        return asked.run([&] {
          return time_to_range(asked.projectile, asked.launch(), asked.environment(), asked.projectile.fidelity, range);
        });
      },
      "setup"_a, "shot"_a, "range"_a, "Time of flight to a range.");
  m.def(
      "zero_elevation",
      [](const Setup& setup, const std::string& name, double range) {
        const Asked asked(setup, name);
        return asked.run([&] {
          return zero_elevation(asked.projectile, asked.launch(), asked.environment(), asked.projectile.fidelity,
                                range);
        });
      },
      "setup"_a, "shot"_a, "range"_a, "Elevation that zeroes a sight at a range.");
  m.def(
      "air_at",
      [](const Setup& setup, double altitude) {
        const AirSample air = taken(air_at(setup.scenario.environment, altitude));
        nb::dict out;
        out["temperature"] = air.temperature, out["pressure"] = air.pressure, out["density"] = air.density;
        out["sound_speed"] = air.sound_speed, out["viscosity"] = air.viscosity;
        return out;
      },
      "setup"_a, "altitude"_a, "The air of an environment at an altitude.");
  m.def(
      "suvat",
      [](std::optional<double> s, std::optional<double> u, std::optional<double> v, std::optional<double> a,
         std::optional<double> t) {
        nb::list all;
        for (const Suvat& found : taken(suvat({s, u, v, a, t}))) {
          nb::dict row;
          row["s"] = found.s, row["u"] = found.u, row["v"] = found.v, row["a"] = found.a, row["t"] = found.t;
          all.append(row);
        }
        return all;
      },
      "s"_a.none(), "u"_a.none(), "v"_a.none(), "a"_a.none(), "t"_a.none(),
      "Motions under constant acceleration out of three of their five quantities.");
}

}  // namespace physim::python
