// Flights, their samples and events, and batches in columns.
#include "report/trajectory.hpp"

#include <algorithm>
#include <limits>

#include "report/range_card.hpp"
#include "report_table.hpp"
#include "setup.hpp"

namespace physim::python {

nb::dict sample_table(const Sample& s) {
  nb::dict row;
  row["time"] = s.time;
  row["position"] = array_of(s.position);
  row["velocity"] = array_of(s.velocity);
  row["acceleration"] = array_of(s.acceleration);
  row["speed"] = s.speed;
  row["mach"] = s.mach;
  row["energy"] = s.energy;
  row["mass"] = s.mass;
  row["thrust"] = s.thrust;
  row["range"] = s.range;
  row["drop"] = s.drop;
  row["windage"] = s.windage;
  row["orientation"] = array_of(s.orientation);
  row["angular_velocity"] = array_of(s.angular_velocity);
  row["angle_of_attack"] = s.angle_of_attack;
  return row;
}

nb::list notes_table(const FidelityInUse& in_use) {
  nb::list notes;
  for (const FidelityNote& note : in_use.notes) {
    nb::dict row;
    row["effect"] = note.effect;
    row["asked"] = note.asked;
    row["granted"] = note.granted;
    row["reason"] = note.reason;
    notes.append(row);
  }
  return notes;
}

nb::dict event_table(const Event& e) {
  nb::dict row;
  row["kind"] = std::string(name(e.kind));
  row["direction"] = std::string(name(e.direction));
  row["reason"] = std::string(name(e.reason));
  row["id"] = number_of(e.id);
  row["value"] = e.value;
  row["time"] = e.time;
  row["position"] = array_of(e.position);
  row["velocity"] = array_of(e.velocity);
  row["normal"] = array_of(e.normal);
  row["instance"] = number_of(e.instance);
  row["primitive"] = e.primitive;
  row["material"] = e.material.index;
  row["energy"] = e.energy;
  row["other"] = number_of(e.other);
  return row;
}

nb::dict event_columns(std::span<const Event> events) {
  nb::dict all;
  all["kind"] = column_of<std::uint8_t>(events, [](const Event& e) { return static_cast<unsigned>(e.kind); });
  all["direction"] = column_of<std::uint8_t>(events, [](const Event& e) { return static_cast<unsigned>(e.direction); });
  all["reason"] = column_of<std::uint8_t>(events, [](const Event& e) { return static_cast<unsigned>(e.reason); });
  all["id"] = column_of<std::uint64_t>(events, [](const Event& e) { return number_of(e.id); });
  all["value"] = column_of<double>(events, [](const Event& e) { return e.value; });
  all["time"] = column_of<double>(events, [](const Event& e) { return e.time; });
  all["position"] = rows_of(events, [](const Event& e) { return e.position; });
  all["velocity"] = rows_of(events, [](const Event& e) { return e.velocity; });
  all["normal"] = rows_of(events, [](const Event& e) { return e.normal; });
  all["instance"] = column_of<std::uint64_t>(events, [](const Event& e) { return number_of(e.instance); });
  all["primitive"] = column_of<std::uint32_t>(events, [](const Event& e) { return e.primitive; });
  all["material"] = column_of<std::uint32_t>(events, [](const Event& e) { return e.material.index; });
  all["energy"] = column_of<double>(events, [](const Event& e) { return e.energy; });
  all["other"] = column_of<std::uint64_t>(events, [](const Event& e) { return number_of(e.other); });
  return all;
}

namespace {

// ------------------------------------------------------------------------------------------------------------- flights
Flight fly_setup(const Setup& setup, const std::string& name) {
  const ScenarioShot& shot = setup.shot(name);
  Flight flight = [&] {
    const Released free;
    return setup.scene ? fly_shot(setup.scenario, shot, *setup.scene) : fly_shot(setup.scenario, shot);
  }();
  setup.raise_kept();
  if (flight.error()) fail(*flight.error());
  return flight;
}

template <class Get>
nb::object numbers_of(const std::vector<Sample>& samples, const Get& get) {
  return column_of<double>(samples, get);
}

nb::dict sample_columns(const std::vector<Sample>& all, bool turning) {
  nb::dict out;
  out["time"] = numbers_of(all, [](const Sample& s) { return s.time; });
  out["x"] = numbers_of(all, [](const Sample& s) { return s.position.x; });
  out["y"] = numbers_of(all, [](const Sample& s) { return s.position.y; });
  out["z"] = numbers_of(all, [](const Sample& s) { return s.position.z; });
  out["vx"] = numbers_of(all, [](const Sample& s) { return s.velocity.x; });
  out["vy"] = numbers_of(all, [](const Sample& s) { return s.velocity.y; });
  out["vz"] = numbers_of(all, [](const Sample& s) { return s.velocity.z; });
  out["ax"] = numbers_of(all, [](const Sample& s) { return s.acceleration.x; });
  out["ay"] = numbers_of(all, [](const Sample& s) { return s.acceleration.y; });
  out["az"] = numbers_of(all, [](const Sample& s) { return s.acceleration.z; });
  out["speed"] = numbers_of(all, [](const Sample& s) { return s.speed; });
  out["mach"] = numbers_of(all, [](const Sample& s) { return s.mach; });
  out["energy"] = numbers_of(all, [](const Sample& s) { return s.energy; });
  out["mass"] = numbers_of(all, [](const Sample& s) { return s.mass; });
  out["thrust"] = numbers_of(all, [](const Sample& s) { return s.thrust; });
  out["range"] = numbers_of(all, [](const Sample& s) { return s.range; });
  out["drop"] = numbers_of(all, [](const Sample& s) { return s.drop; });
  out["windage"] = numbers_of(all, [](const Sample& s) { return s.windage; });
  if (!turning) return out;
  std::vector<double> quaternions;
  for (const Sample& s : all)
    quaternions.insert(quaternions.end(), {s.orientation.w, s.orientation.x, s.orientation.y, s.orientation.z});
  out["orientation"] = owned(std::move(quaternions), {all.size(), 4});
  out["angular_velocity"] = rows_of(all, [](const Sample& s) { return s.angular_velocity; });
  out["angle_of_attack"] = numbers_of(all, [](const Sample& s) { return s.angle_of_attack; });
  return out;
}

/// The row of a place that a flight does not get to.
Sample nowhere(double range) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vec3d none{nan, nan, nan};
  return {.time = nan,
          .position = none,
          .velocity = none,
          .acceleration = none,
          .speed = nan,
          .mach = nan,
          .energy = nan,
          .mass = nan,
          .thrust = nan,
          .range = range,
          .drop = nan,
          .windage = nan,
          .angular_velocity = none,
          .angle_of_attack = nan};
}

nb::dict at_times(const Flight& flight, const Numbers& times) {
  std::vector<Sample> all(times.size());
  {
    const Released free;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double time = times.data()[i];
      all[i] = time == time ? flight.at(time) : nowhere(time);
    }
  }
  return sample_columns(all, turns(flight.fidelity_in_use().fidelity));
}

/// Samples to be drawn: breaks of the path have one before and one behind them.
nb::dict drawn_samples(const Flight& flight, std::size_t count) {
  std::vector<Sample> all;
  {
    const Released free;
    report::Times times;
    const double parts = static_cast<double>(std::max<std::size_t>(count, 2) - 1);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(parts); ++i)
      times.push_back(flight.duration() * (static_cast<double>(i) / parts));
    times = report::with_breaks(flight, times);
    for (std::size_t i = 0; i < times.size(); ++i) all.push_back(report::sample_at(flight, times, i));
  }
  return sample_columns(all, turns(flight.fidelity_in_use().fidelity));
}

nb::dict at_ranges(const Flight& flight, const Numbers& ranges) {
  std::vector<Sample> all(ranges.size());
  {
    const Released free;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Result<Sample> found = flight.at_range(ranges.data()[i]);
      all[i] = found ? *found : nowhere(ranges.data()[i]);
    }
  }
  return sample_columns(all, turns(flight.fidelity_in_use().fidelity));
}

Crossing crossing_of(const std::string& text) {
  const auto crossing = value_of<Crossing>(text);
  if (!crossing) fail("unknown direction \"" + text + "\"", "direction", "known are any, rising, falling");
  return *crossing;
}

nb::dict accelerations_table(const Accelerations& a) {
  nb::dict out;
  out["gravity"] = array_of(a.gravity), out["drag"] = array_of(a.drag), out["lift"] = array_of(a.lift);
  out["body"] = array_of(a.body), out["thrust"] = array_of(a.thrust), out["coriolis"] = array_of(a.coriolis);
  out["centrifugal"] = array_of(a.centrifugal), out["applied"] = array_of(a.applied);
  out["constraint"] = array_of(a.constraint), out["total"] = array_of(a.total);
  return out;
}

// ------------------------------------------------------------------------------------------------------------- batches
struct LaunchName {
  const char* name;
  std::span<const double> LaunchColumns::*member;
};
constexpr LaunchName kLaunchNames[] = {
    {"x", &LaunchColumns::x},
    {"y", &LaunchColumns::y},
    {"z", &LaunchColumns::z},
    {"speed", &LaunchColumns::speed},
    {"elevation", &LaunchColumns::elevation},
    {"azimuth", &LaunchColumns::azimuth},
    {"ballistic_coefficient", &LaunchColumns::ballistic_coefficient},
    {"form_factor", &LaunchColumns::form_factor},
};
struct WeatherName {
  const char* name;
  std::span<const double> Weather::*member;
};
constexpr WeatherName kWeatherNames[] = {
    {"wind_x", &Weather::wind_x},           {"wind_y", &Weather::wind_y},     {"wind_z", &Weather::wind_z},
    {"temperature", &Weather::temperature}, {"pressure", &Weather::pressure}, {"humidity", &Weather::humidity},
    {"density", &Weather::density},
};
struct EndName {
  const char* name;
  std::span<double> EndColumns::*member;
};
constexpr EndName kEndNames[] = {
    {"time", &EndColumns::time}, {"x", &EndColumns::x},
    {"y", &EndColumns::y},       {"z", &EndColumns::z},
    {"vx", &EndColumns::vx},     {"vy", &EndColumns::vy},
    {"vz", &EndColumns::vz},     {"speed", &EndColumns::speed},
    {"drop", &EndColumns::drop}, {"windage", &EndColumns::windage},
};

template <class Names>
auto member_of(const Names& names, const std::string& name) {
  using Member = decltype(names[0].member);
  for (const auto& each : names)
    if (name == each.name) return each.member;
  return Member{nullptr};
}

/// Columns that are read, by name: of launches and of the weather.
struct InputColumns {
  LaunchColumns launches;
  Weather weather;
  std::vector<Numbers> kept;

  void add(const std::string& name, nb::handle object) {
    Numbers numbers;
    if (!nb::try_cast<Numbers>(object, numbers, false)) fail("is no column of float64", name);
    kept.push_back(numbers);
    if (const auto member = member_of(kLaunchNames, name); member != nullptr)
      launches.*member = span_of(numbers);
    else if (const auto of_weather = member_of(kWeatherNames, name); of_weather != nullptr)
      weather.*of_weather = span_of(numbers);
    else
      fail("unknown column", name);
  }
};

nb::dict fly_batch_columns(const Setup& setup, const std::string& name, const nb::dict& inputs, const nb::dict& outputs,
                           nb::handle outcomes, bool moves_profile, unsigned threads) {
  const ScenarioShot& shot = setup.shot(name);
  InputColumns in;
  for (const auto& [key, column] : inputs) in.add(nb::cast<std::string>(key), column);
  in.launches.common = shot.launch;
  in.weather.moves_profile = moves_profile;
  const std::size_t count = std::max(in.launches.size(), in.weather.size());
  // Weather alone makes shots, too: its columns need launches beside them.
  std::vector<double> speeds;
  if (in.launches.size() == 0 && count > 0) speeds.assign(count, shot.launch.speed), in.launches.speed = speeds;

  std::vector<Output> written;
  written.reserve(nb::len(outputs));
  EndColumns into;
  for (const auto& [key, column] : outputs) {
    const std::string end = nb::cast<std::string>(key);
    const auto member = member_of(kEndNames, end);
    if (member == nullptr) fail("unknown column", end);
    written.emplace_back(column, end);
    check_length(written.back().size(), count, end);
    into.*member = written.back().span();
  }
  std::vector<Outcome> codes(outcomes.is_none() ? 0 : count);
  into.outcome = codes;
  const ProjectileDef projectile = projectile_of(shot);
  const Until until = setup.until(shot);
  ColumnsResult result;
  {
    const Released free;
    const Threads pool(threads);
    result = fly_columns(projectile, in.launches, setup.scenario.environment, projectile.fidelity,
                         setup.scenario.tolerance, until, into, pool.runner(), in.weather);
    for (Output& each : written) each.finish();
  }
  setup.raise_kept();
  if (!outcomes.is_none()) {
    nb::ndarray<std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu> array;
    if (!nb::try_cast(outcomes, array, false) || array.size() != count) fail("is no column of uint8", "outcome");
    for (std::size_t i = 0; i < count; ++i) array.data()[i] = static_cast<std::uint8_t>(codes[i]);
  }
  nb::dict out;
  out["refused"] = result.refused;
  out["kernel"] = result.kernel;
  out["notes"] = notes_table(result.fidelity_in_use);
  out["air"] = std::string(physim::name(result.fidelity_in_use.fidelity.air));
  out["wind"] = std::string(physim::name(result.fidelity_in_use.fidelity.wind));
  out["error"] = nb::none();
  if (result.error) out["error"] = nb::make_tuple(result.error->message, result.error->place, result.error->hint);
  return out;
}

template <std::size_t n, class Row>
std::vector<std::string> names_in(const Row (&rows)[n]) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.emplace_back(row.name);
  return names;
}

// --------------------------------------------------------------------------------------------------------- range cards
nb::dict range_card(const Setup& setup, const std::string& name, const std::vector<double>& ranges,
                    const std::vector<std::string>& labels, const std::vector<double>& winds, bool customary,
                    bool in_moa) {
  if (labels.size() != winds.size()) fail("has no label for each wind", "winds");
  report::AskedShot asked{setup.scenario, 0};
  asked.scenario.things.clear();
  if (!ranges.empty()) asked.scenario.ranges = ranges;
  const auto index = report::find_shot(asked.scenario, name);
  asked.index = taken(index);
  report::CardWishes wishes;
  if (customary) wishes.units = report::kCustomary;
  wishes.units.angle = in_moa ? report::kMoa : report::kMil;
  wishes.scenario_ranges = !customary || !ranges.empty();
  for (std::size_t i = 0; i < winds.size(); ++i) wishes.winds.push_back({labels[i], winds[i]});
  report::Records records;
  std::optional<report::Card> card;
  {
    const Released free;
    card = taken(report::make_card(asked, wishes));
    records = report::records_of(*card);
  }
  return columns_of(records);
}

}  // namespace

void add_flight(nb::module_& m) {
  nb::class_<Sample>(m, "Sample", "The state at one moment.")
      .def("table", &sample_table)
      .def_ro("time", &Sample::time)
      .def_prop_ro("position", [](const Sample& s) { return array_of(s.position); })
      .def_prop_ro("velocity", [](const Sample& s) { return array_of(s.velocity); })
      .def_prop_ro("acceleration", [](const Sample& s) { return array_of(s.acceleration); })
      .def_prop_ro("x", [](const Sample& s) { return s.position.x; })
      .def_prop_ro("y", [](const Sample& s) { return s.position.y; })
      .def_prop_ro("z", [](const Sample& s) { return s.position.z; })
      .def_ro("speed", &Sample::speed)
      .def_ro("mach", &Sample::mach)
      .def_ro("energy", &Sample::energy)
      .def_ro("mass", &Sample::mass)
      .def_ro("thrust", &Sample::thrust)
      .def_ro("range", &Sample::range)
      .def_ro("drop", &Sample::drop)
      .def_ro("windage", &Sample::windage)
      .def_prop_ro("orientation", [](const Sample& s) { return array_of(s.orientation); })
      .def_prop_ro("angular_velocity", [](const Sample& s) { return array_of(s.angular_velocity); })
      .def_ro("angle_of_attack", &Sample::angle_of_attack);
  nb::class_<Flight>(m, "Flight", "A computed trajectory.")
      .def_prop_ro(
          "outcome", [](const Flight& f) { return std::string(name(f.outcome())); }, "How it ended.")
      .def_prop_ro("duration", &Flight::duration, "Time of flight [s].")
      .def_prop_ro("elevation", &Flight::elevation, "Of the bore above the horizon, before cant [rad].")
      .def_prop_ro("step", &Flight::step, "Fixed step in use; 0 of adaptive integrators [s].")
      .def_prop_ro(
          "kinds_of_rotation", [](const Flight& f) { return turns(f.fidelity_in_use().fidelity); },
          "Whether its attitude was flown.")
      .def(
          "at", [](const Flight& f, double time) { return f.at(time); }, "time"_a, "State at a time.")
      .def(
          "at_range", [](const Flight& f, double range) { return taken(f.at_range(range)); }, "range"_a,
          "State at a range along the line of sight.")
      .def(
          "at_height",
          [](const Flight& f, double height, const std::string& direction) {
            return taken(f.at_height(height, crossing_of(direction)));
          },
          "height"_a, "direction"_a = "any", "State at a height.")
      .def("at_times", &at_times, "times"_a, "Columns of states at times.")
      .def("at_ranges", &at_ranges, "ranges"_a, "Columns of states at ranges; NaN where it does not get.")
      .def("drawn", &drawn_samples, "count"_a, "Columns of states for a picture: corners stay corners.")
      .def(
          "accelerations", [](const Flight& f, double time) { return accelerations_table(f.accelerations(time)); },
          "time"_a, "Acceleration by effect.")
      .def(
          "jerk", [](const Flight& f, double time) { return array_of(f.jerk(time)); }, "time"_a,
          "Jerk: the change of acceleration along the path.")
      .def(
          "step_times", [](const Flight& f) { return owned(f.step_times()); }, "Times of the steps taken.")
      .def(
          "events",
          [](const Flight& f) {
            nb::list all;
            for (const Event& event : f.events()) all.append(event_table(event));
            return all;
          },
          "All that happened, in order of time.")
      .def(
          "event_columns", [](const Flight& f) { return event_columns(f.events()); }, "Events as columns.")
      .def(
          "notes", [](const Flight& f) { return notes_table(f.fidelity_in_use()); },
          "Where the fidelity granted differs from what was asked for, and why.")
      .def(
          "cost",
          [](const Flight& f) {
            nb::dict cost;
            cost["steps"] = f.cost().steps;
            cost["rejected"] = f.cost().rejected;
            cost["evaluations"] = f.cost().evaluations;
            return cost;
          },
          "Work done.")
      .def(
          "stability",
          [](const Flight& f, double time) -> nb::object {
            const std::optional<Stability> s = f.stability(time);
            if (!s) return nb::none();
            return nb::make_tuple(s->gyroscopic, s->dynamic);
          },
          "time"_a, "Gyroscopic and dynamic stability, or None.")
      .def(
          "geodetic",
          [](const Flight& f, double time) {
            const Geodetic g = f.earth_frames().geodetic(f.at(time).position);
            return nb::make_tuple(g.latitude, g.longitude, g.height);
          },
          "time"_a, "Latitude [rad], longitude [rad] and height [m] at a time.")
      .def(
          "danger_space",
          [](const Flight& f, double range, double height) {
            const DangerSpace space = taken(danger_space(f, range, height));
            return nb::make_tuple(space.from, space.to);
          },
          "range"_a, "height"_a, "Ranges between which a target of a height is hit.");

  m.def("fly", &fly_setup, "setup"_a, "shot"_a = "", "Flies a shot.");
  m.def("fly_columns", &fly_batch_columns, "setup"_a, "shot"_a, "inputs"_a, "outputs"_a, "outcomes"_a,
        "moves_profile"_a, "threads"_a, "Flies launches out of columns into columns.");
  m.def("batch_inputs", [] {
    std::vector<std::string> names = names_in(kLaunchNames);
    for (const WeatherName& each : kWeatherNames) names.emplace_back(each.name);
    return names;
  });
  m.def("batch_outputs", [] { return names_in(kEndNames); });
  m.def("range_card", &range_card, "setup"_a, "shot"_a, "ranges"_a, "labels"_a, "winds"_a, "customary"_a, "in_moa"_a,
        "A range card as columns.");
  m.def("names", [](const std::string& of) {
    const auto list = [](auto names) { return std::vector<std::string>(names.begin(), names.end()); };
    if (of == "event") return list(names_of<EventKind>());
    if (of == "outcome") return list(names_of<Outcome>());
    if (of == "crossing") return list(names_of<Crossing>());
    if (of == "reason") return list(names_of<Reason>());
    if (of == "on_hit") return list(names_of<OnHit>());
    if (of == "fidelity") return list(fidelity_presets());
    if (of == "projectile") return list(projectile_presets());
    if (of == "kernel") return kernels();
    fail("unknown list \"" + of + "\"", "of");
  });
}

}  // namespace physim::python
