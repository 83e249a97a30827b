// Random calls of everything that flies or answers without a world.
#pragma once

#include "fuzz/odd_input.hpp"
#include "fuzz/verdict.hpp"

namespace physim::test {

class OddFlights {
 public:
  explicit OddFlights(Odd& r) : r_(r) {}

  void act() {
    switch (r_.below(12)) {
      case 0:
      case 1:
      case 2:
      case 3: return fly_one();
      case 4:
      case 5: return fly_many();
      case 6: return tables();
      case 7: return places();
      case 8: return words();
      case 9: return r_.one_in(12) ? aim_at() : tables();
      case 10: return r_.one_in(20) ? choose() : places();
      default: return r_.one_in(10) ? measure() : words();
    }
  }

 private:
  void fly_one() {
    Flight flight = fly(r_.projectile(), r_.launch(), r_.environment(), r_.fidelity(), r_.tolerance(), r_.until());
    ++tally.flights, tally.flown += flight.outcome() != Outcome::refused;
    expect((flight.outcome() == Outcome::refused) == flight.error().has_value(), "a refusal without a reason");
    expect(flight.outcome() != Outcome::refused || !flight.error()->message.empty(), "a refusal without words");
    ask(flight);
    const Flight other = std::move(flight);
    expect(flight.outcome() == Outcome::refused, "a flight that was moved away is not refused");
    ask(flight);
    flight = other;
    expect(flight.duration() == other.duration(), "a copy of a flight is another");
  }
  void ask(const Flight& flight) {
    for (const double time : {r_.number(-1, 6), 0.0, flight.duration()}) {
      const Sample s = flight.at(time);
      const bool finite = is_finite(s.position) && is_finite(s.velocity) && std::isfinite(s.time);
      expect(finite, "a sample of a flight is not finite");
      static_cast<void>(flight.accelerations(time)), static_cast<void>(flight.stability(time));
    }
    static_cast<void>(flight.at_range(r_.number(-10, 300)));
    static_cast<void>(flight.at_height(r_.number(-10, 50), r_.any<Crossing>()));
    static_cast<void>(danger_space(flight, r_.number(-10, 300), r_.number(-1, 2)));
    for (const Event& e : flight.events()) expect(std::isfinite(e.time) && is_finite(e.position), "an event nowhere");
    expect(flight.outcome() == Outcome::refused || !flight.step_times().empty(), "a flight without a step");
    ask(flight.earth_frames());
    static_cast<void>(flight.fidelity_in_use()), static_cast<void>(flight.cost()),
        static_cast<void>(flight.elevation());
    static_cast<void>(flight.step()), static_cast<void>(flight.end());
  }
  void ask(const EarthFrames& frames) {
    const Vec3d x = r_.vector3(1e6), v = r_.vector3(1e3);
    const Geodetic place = frames.geodetic(x);
    static_cast<void>(frames.position(place)), static_cast<void>(frames.earth_fixed(x, v));
    static_cast<void>(frames.inertial(x, v, r_.number(0, 100))), static_cast<void>(frames.local(x, v));
    static_cast<void>(
        frames.yaw_pitch_roll(x, {r_.number(-1, 1), r_.number(-1, 1), r_.number(-1, 1), r_.number(-1, 1)}));
    static_cast<void>(frames.from_earth_fixed({x, v})),
        static_cast<void>(frames.from_inertial({x, v}, r_.number(0, 100)));
    static_cast<void>(frames.from_local(x, v)), static_cast<void>(frames.ground_distance(x, v));
    static_cast<void>(frames.position({r_.number(-2, 2), r_.number(-4, 4), r_.number(-100, 1e5)}));
  }
  void fly_many() {
    std::vector<Shot> shots(static_cast<std::size_t>(r_.below(6)));
    for (Shot& shot : shots) shot = {r_.projectile(), r_.launch()};
    std::vector<Launch> launches(static_cast<std::size_t>(r_.below(6)));
    for (Launch& launch : launches) launch = r_.launch();
    const Environment environment = r_.environment();
    const Fidelity fidelity = r_.fidelity();
    const Tolerance tolerance = r_.tolerance();
    const Until until = r_.until();
    BatchResult result = fly_batch(shots, environment, fidelity, tolerance, until);
    check(result, shots.size());
    fly_batch(r_.projectile(), launches, environment, fidelity, tolerance, until, result);
    check(result, launches.size());
    if (r_.one_in(4)) fly_from_columns(environment, fidelity, tolerance, until);
  }
  /// Launches and weather from columns, some of another length: all are refused, or they fly as in a batch.
  void fly_from_columns(const Environment& environment, const Fidelity& fidelity, const Tolerance& tolerance,
                        const Until& until) {
    const auto count = static_cast<std::size_t>(1 + r_.below(40));
    const auto column = [&](double low, double high, bool wanted = false) {
      std::vector<double> numbers(!wanted && r_.coin() ? 0 : r_.one_in(60) ? count + 1 : count);
      for (double& x : numbers) x = r_.number(low, high);
      return numbers;
    };
    const auto speed = column(1, 900, true), elevation = column(-0.1, 1), y = column(0, 30), wind = column(-9, 9),
               temperature = column(250, 310), pressure = column(5e4, 1e5), humidity = column(0, 1),
               density = column(0.1, 2), coefficient = column(1, 500), factor = column(0.1, 3);
    const LaunchColumns from{.common = {.position = {0, 5, 0}},
                             .y = y,
                             .speed = speed,
                             .elevation = elevation,
                             .ballistic_coefficient = coefficient,
                             .form_factor = factor};
    const Weather weather{
        .wind_z = wind, .temperature = temperature, .pressure = pressure, .humidity = humidity, .density = density};
    const ProjectileDef projectile = r_.projectile();
    std::vector<double> time(from.size()), x(from.size());
    const ColumnsResult ends = fly_columns(projectile, from, environment, fidelity, tolerance, until,
                                           {.time = time, .x = x}, nullptr, weather);
    expect((ends.refused > 0) == ends.error.has_value(), "columns refused without a reason");
    if (ends.refused == from.size()) return;
    std::vector<Shot> shots(from.size(), {projectile, {}});
    for (std::size_t i = 0; i < from.size(); ++i) {
      shots[i].launch = from.at(i);
      from.put(i, shots[i].projectile);
      if (!coefficient.empty() && !(coefficient[i] > 0)) shots[i].projectile.mass = 0;  // what else refuses it
    }
    const BatchResult batch = fly_batch(shots, environment, fidelity, tolerance, until, nullptr, weather);
    check(batch, shots.size());
    for (std::size_t i = 0; i < shots.size(); ++i) {
      const ShotResult& shot = batch.shots[i];
      const bool refused = shot.outcome == Outcome::refused;
      expect(refused ? std::isnan(time[i]) : time[i] == shot.time && x[i] == shot.position.x,
             "a shot of columns is not that of a batch");
    }
  }
  static void check(const BatchResult& result, std::size_t shots) {
    expect(result.shots.size() == shots, "a batch of another size");
    expect(result.attitudes.empty() || result.attitudes.size() == shots, "attitudes of another number");
    bool refused = false;
    for (const ShotResult& shot : result.shots) {
      ++tally.flights, tally.flown += shot.outcome != Outcome::refused;
      refused = refused || shot.outcome == Outcome::refused;
      expect(name(shot.outcome) != "?", "an outcome without a name");
    }
    expect(!refused || result.error.has_value(), "a refused shot without a reason");
    for (const ShotEvent& e : result.events) expect(e.shot < shots, "an event of no shot");
  }
  void aim_at() {
    const Target target{r_.vector3(200), r_.vector3(10), r_.one_in(3) ? r_.vector3(3) : Vec3d{}};
    if (const auto answer =
            aim(r_.projectile(), r_.launch(), r_.environment(), r_.fidelity(), target, r_.aim_options())) {
      expect(!answer->explanation().empty(), "an aim without words");
      expect(answer->in_reach() || std::isfinite(answer->nearest.miss), "a miss by no number");
    }
    if (r_.one_in(3))
      static_cast<void>(max_range(r_.projectile(), r_.launch(), r_.environment(), r_.fidelity(), r_.number(-10, 0),
                                  r_.number(-0.3, 0.3), r_.number(1, 60)));
    static_cast<void>(time_to_range(r_.projectile(), r_.launch(), r_.environment(), r_.fidelity(), r_.number(1, 200)));
    static_cast<void>(zero_elevation(r_.projectile(), r_.launch(), r_.environment(), r_.fidelity(), r_.number(1, 200)));
  }
  void choose() {
    const ProjectileDef projectile = r_.projectile();
    const Environment environment = r_.environment();
    const auto answer = cheapest_within(projectile, r_.launch(), environment, r_.purpose());
    if (answer) {
      expect(!answer->explanation().empty(), "a choice without words");
      static_cast<void>(fly_chosen(projectile, r_.launch(), environment, *answer, r_.until()));
    }
    AutoFidelityCache cache(static_cast<std::size_t>(r_.below(3)));
    static_cast<void>(cache.cheapest_within(projectile, r_.launch(), environment, r_.purpose()));
    expect(cache.size() <= 3, "a cache that holds too much");
    static_cast<void>(pilot_step(projectile, r_.launch(), environment, r_.fidelity(), r_.tolerance(), r_.until()));
  }
  void measure() {
    std::vector<Measurement> measured(static_cast<std::size_t>(r_.below(4)));
    for (Measurement& m : measured) m = {r_.number(1, 200), r_.maybe(10, 300), r_.maybe(-2, 0), r_.maybe(0, 2)};
    static_cast<void>(fit_drag(r_.projectile(), r_.launch(), r_.environment(), r_.fidelity(), measured,
                               {r_.coin(), r_.number(0.1, 1), r_.number(0.1, 1), r_.number(0.1, 1)}));
    const FlightSetting settings[] = {{r_.fidelity(), r_.tolerance()}, {r_.fidelity(), r_.tolerance()}};
    const auto compared =
        compare(r_.projectile(), r_.launch(), r_.environment(), settings, {r_.fidelity(), r_.tolerance()}, r_.until());
    if (compared) expect(compared->flights.size() == 2, "a comparison of others");
  }
  void tables() {
    const DragDef drag = r_.drag();
    static_cast<void>(drag_coefficient(drag, r_.any<Interpolation>(), r_.number(0, 4)));
    static_cast<void>(drag_points(r_.any<DragTable>())), static_cast<void>(sphere_drag_coefficient(r_.number(0, 1e6)));
    static_cast<void>(air_at(r_.environment(), r_.number(-5000, 90000)));
    static_cast<void>(moist_air_density(r_.number(250, 310), r_.number(6e4, 1e5), r_.number(0, 1)));
    static_cast<void>(moist_air_sound_speed(r_.number(250, 310), r_.number(6e4, 1e5), r_.number(0, 1)));
    static_cast<void>(stability_factor(r_.projectile(), r_.launch(), r_.environment()));
    const MotorDef motor = r_.motor();
    static_cast<void>(burn_time(motor)), static_cast<void>(total_impulse(motor)),
        static_cast<void>(specific_impulse(motor));
    static_cast<void>(thrust_at(motor, r_.number(-1, 2))), static_cast<void>(propellant_left(motor, r_.number(-1, 2)));
    static_cast<void>(launch_class(r_.launch(), r_.maybe(-10, 10)));
  }
  void places() {
    ask(EarthFrames(r_.environment(), r_.any<EarthModel>()));
    const auto preset =
        projectile_presets()[static_cast<std::size_t>(r_.below(static_cast<int>(projectile_presets().size())))];
    const ProjectilePreset made = *projectile_preset(preset);
    static_cast<void>(fly(made.projectile, {.speed = r_.number(0, made.speed)}, r_.environment()));
  }
  void words() {
    const std::string text = r_.text();
    static_cast<void>(fidelity_preset(text)), static_cast<void>(projectile_preset(text));
    static_cast<void>(value_of<DragTable>(text)), static_cast<void>(value_of<Motion>(text));
    expect(!name(static_cast<EventKind>(r_.below(256))).empty(), "a value without a name");
    expect(!name(r_.any<Integrator>()).empty() && !name(r_.any<Arc>()).empty(), "a value without a name");
    if (r_.one_in(8)) static_cast<void>(use_kernel(text)), static_cast<void>(use_kernel(""));
  }

  Odd& r_;
};

}  // namespace physim::test
