// Flights and batches.
#include <tuple>

#include "base/ieee_mode.hpp"
#include "capi/objects.hpp"
#include "physim/names.hpp"
#include "physim/study.hpp"

namespace physim::capi {
namespace {

static_assert(static_cast<int>(Outcome::hit) == PHYSIM_HIT && static_cast<int>(Outcome::refused) == PHYSIM_WAS_REFUSED);
static_assert(sizeof(Outcome) == sizeof(std::int32_t) && sizeof(Vec3d) == 3 * sizeof(double));

void launch_as(Call& call, const physim_launch& given, Launch& launch) {
  const bool finite = is_finite(given.position, 3) && is_finite(given.velocity, 3);
  call.need(finite && std::isfinite(given.speed + given.elevation + given.azimuth), "launch",
            "has a number that is none");
  call.need(given.given < 2 * PHYSIM_VELOCITY, "launch.given", "has a bit that is none of PHYSIM_POSITION and so on");
  if (given.given & PHYSIM_POSITION) launch.position = vector_at(given.position);
  if (given.given & (PHYSIM_SPEED | PHYSIM_ELEVATION | PHYSIM_AZIMUTH)) launch.velocity.reset();
  if (given.given & PHYSIM_SPEED) launch.speed = given.speed;
  if (given.given & PHYSIM_ELEVATION) launch.elevation = given.elevation;
  if (given.given & PHYSIM_AZIMUTH) launch.azimuth = given.azimuth;
  if (given.given & PHYSIM_VELOCITY)
    launch.velocity = vector_at(given.velocity), launch.speed = launch.elevation = launch.azimuth = 0;
}

physim_sample sample_of(const Sample& s) {
  physim_sample out{.size = 0,
                    .reserved = 0,
                    .time = s.time,
                    .position = {},
                    .velocity = {},
                    .acceleration = {},
                    .speed = s.speed,
                    .mach = s.mach,
                    .energy = s.energy,
                    .mass = s.mass,
                    .thrust = s.thrust,
                    .range = s.range,
                    .drop = s.drop,
                    .windage = s.windage,
                    .orientation = {},
                    .angular_velocity = {},
                    .angle_of_attack = s.angle_of_attack};
  put(out.position, s.position);
  put(out.velocity, s.velocity);
  put(out.acceleration, s.acceleration);
  put(out.orientation, s.orientation);
  put(out.angular_velocity, s.angular_velocity);
  return out;
}

Result<Sample> at_apex(const Flight& flight) {
  for (const Event& event : flight.events())
    if (event.kind == EventKind::apex) return flight.at(event.time);
  return Error{"the flight has no apex", "value", ""};
}

Result<Sample> sample_at(const Flight& flight, physim_moment moment, double value) {
  switch (moment) {
    case PHYSIM_AT_END: return flight.end();
    case PHYSIM_AT_TIME: return flight.at(value);
    case PHYSIM_AT_RANGE: return flight.at_range(value);
    case PHYSIM_AT_HEIGHT: return flight.at_height(value);
    case PHYSIM_AT_APEX: return at_apex(flight);
  }
  return Error{"is no moment", "moment", "PHYSIM_AT_END and the others are"};
}

void put_sample(const physim_samples& into, std::size_t i, const Sample& s) {
  const std::pair<double*, double> columns[] = {
      {into.time, s.time},     {into.x, s.position.x},  {into.y, s.position.y},  {into.z, s.position.z},
      {into.vx, s.velocity.x}, {into.vy, s.velocity.y}, {into.vz, s.velocity.z}, {into.speed, s.speed},
      {into.mach, s.mach},     {into.range, s.range},   {into.drop, s.drop},     {into.windage, s.windage},
      {into.energy, s.energy},
  };
  for (const auto& [column, value] : columns)
    if (column != nullptr) column[i] = value;
}

/// A column of the C interface and the one of the library that it becomes.
template <class Struct, class T, class Columns, class U>
struct SameColumn {
  T* Struct::*mine;
  std::span<U> Columns::*own;
};
template <class Struct, class T, class Columns, class U>
SameColumn(T* Struct::*, std::span<U> Columns::*) -> SameColumn<Struct, T, Columns, U>;
#define PHYSIM_COLUMN(c, cpp, name) \
  SameColumn { &c::name, &cpp::name }
#define PHYSIM_LAUNCH(name) PHYSIM_COLUMN(physim_launches, LaunchColumns, name)
#define PHYSIM_WEATHER(name) PHYSIM_COLUMN(physim_weather, Weather, name)
#define PHYSIM_END(name) PHYSIM_COLUMN(physim_ends, EndColumns, name)
constexpr std::tuple kLaunchColumns{PHYSIM_LAUNCH(x),
                                    PHYSIM_LAUNCH(y),
                                    PHYSIM_LAUNCH(z),
                                    PHYSIM_LAUNCH(speed),
                                    PHYSIM_LAUNCH(elevation),
                                    PHYSIM_LAUNCH(azimuth),
                                    PHYSIM_LAUNCH(ballistic_coefficient),
                                    PHYSIM_LAUNCH(form_factor)};
constexpr std::tuple kWeatherColumns{PHYSIM_WEATHER(wind_x),      PHYSIM_WEATHER(wind_y),   PHYSIM_WEATHER(wind_z),
                                     PHYSIM_WEATHER(temperature), PHYSIM_WEATHER(pressure), PHYSIM_WEATHER(humidity),
                                     PHYSIM_WEATHER(density)};
constexpr std::tuple kEndColumns{PHYSIM_END(outcome), PHYSIM_END(time), PHYSIM_END(x),      PHYSIM_END(y),
                                 PHYSIM_END(z),       PHYSIM_END(vx),   PHYSIM_END(vy),     PHYSIM_END(vz),
                                 PHYSIM_END(speed),   PHYSIM_END(drop), PHYSIM_END(windage)};
#undef PHYSIM_COLUMN
#undef PHYSIM_LAUNCH
#undef PHYSIM_WEATHER
#undef PHYSIM_END

/// All columns of a list; those that are null stay empty.
template <class Columns, class Struct, class... Same>
Columns columns_by(const std::tuple<Same...>& list, const Struct& given, std::size_t count) {
  Columns columns;
  const auto put_one = [&]<class T, class U>(const SameColumn<Struct, T, Columns, U>& same) {
    if (T* const first = given.*same.mine; first != nullptr) columns.*same.own = {same_memory<U>(first), count};
  };
  std::apply([&](const auto&... same) { (put_one(same), ...); }, list);
  return columns;
}

Weather weather_of(const physim_weather& w, std::size_t count) {
  auto weather = columns_by<Weather>(kWeatherColumns, w, count);
  weather.moves_profile = w.moves_profile != 0;
  return weather;
}

template <class Enum>
const char* name_or_null(std::int32_t value) {
  const auto names = names_of<Enum>();
  return value >= 0 && static_cast<std::size_t>(value) < names.size() ? names[static_cast<std::size_t>(value)].data()
                                                                      : nullptr;
}

}  // namespace

physim_event event_of(const Event& e) {
  physim_event out{.kind = static_cast<std::int32_t>(e.kind),
                   .direction = static_cast<std::int32_t>(e.direction),
                   .reason = static_cast<std::int32_t>(e.reason),
                   .primitive = e.primitive,
                   .material = e.material.index,
                   .id = put_id(e.id),
                   .thing = put_id(e.instance),
                   .other = put_id(e.other),
                   .reserved = 0,
                   .value = e.value,
                   .time = e.time,
                   .position = {},
                   .velocity = {},
                   .normal = {},
                   .energy = e.energy};
  put(out.position, e.position);
  put(out.velocity, e.velocity);
  put(out.normal, e.normal);
  return out;
}

void put_events(Call& call, std::span<const Event> events, std::size_t first, physim_event* into, std::size_t each,
                std::size_t room, std::size_t* count) {
  call.need_rows(into, room, "into");
  call.need(count, "count");
  call.need(each >= sizeof(std::int32_t) || room == 0, "each", "is not the sizeof of the struct");
  if (!call.ok()) return;
  const std::size_t left = events.size() - std::min(first, events.size());
  PHYSIM_ASSERT(left <= events.size());
  *count = std::min(left, room);
  for (std::size_t i = 0; i < *count; ++i) put_row(into, each, i, event_of(events[first + i]));
}

LaunchColumns columns_of(const physim_launches& launches, std::size_t count) {
  return columns_by<LaunchColumns>(kLaunchColumns, launches, count);
}

Until CheckedShot::until() const {
  Until until = scenario().until;
  if (checked->scene) until.scene = &*checked->scene, until.contact = contact_of(shot());
  return until;
}

std::optional<CheckedShot> shot_of(Call& call, const Def& def, const char* shot) {
  const auto checked = def.checked();
  if (!call.take(checked)) return std::nullopt;
  const auto index = shot_in((*checked)->scenario, shot);
  if (!call.take(index, PHYSIM_NOT_FOUND)) return std::nullopt;
  PHYSIM_ASSERT(*index < (*checked)->scenario.shots.size());
  return CheckedShot{*checked, *index};
}

}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

const char* physim_name(const char* enumeration, int32_t value) {
  const char* found = nullptr;
  static_cast<void>(guarded([&](Call& call) {
    call.need(enumeration, "enumeration");
    if (!call.ok()) return;
    const std::string_view wanted = enumeration;
    if (wanted == "outcome") found = name_or_null<Outcome>(value);
    if (wanted == "event") found = name_or_null<EventKind>(value);
    if (wanted == "crossing") found = name_or_null<Crossing>(value);
    if (wanted == "reason") found = name_or_null<Reason>(value);
    if (wanted == "life") found = name_or_null<LifeStatus>(value);
    if (wanted == "joint_event") found = name_or_null<JointEventKind>(value);
    if (wanted == "quantity") found = name_or_null<StudyQuantity>(value);
  }));
  return found;
}

physim_result physim_pool_create(uint32_t threads, physim_pool** pool) {
  return guarded([&](Call& call) {
    call.need(pool, "pool");
    if (!call.ok()) return;
    auto made = std::make_shared<Pool>();
    made->runner = make_thread_pool(threads);
    call.give(pool, std::move(made));
  });
}

physim_result physim_fly(const physim_def* def, const char* shot, const physim_launch* launch, physim_flight** flight) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    const physim_launch given = call.read(launch, "launch");
    call.need(flight, "flight");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    const Scenario& scenario = of->scenario();
    ScenarioShot own = of->shot();
    launch_as(call, given, own.launch);
    if (!call.ok()) return;
    const auto& scene = of->checked->scene;
    Flight flown = scene ? fly_shot(scenario, own, *scene) : fly_shot(scenario, own);
    if (flown.error()) return call.fail(PHYSIM_REFUSED, *flown.error());
    call.give(flight, std::make_shared<FlightObject>(FlightObject{std::move(flown)}));
  });
}

physim_result physim_flight_read(const physim_flight* flight, physim_flight_info* info) {
  return guarded([&](Call& call) {
    const auto of = call.find(flight, "flight");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const Flight& f = of->flight;
    call.write(info, {.size = 0,
                      .outcome = static_cast<std::int32_t>(f.outcome()),
                      .duration = f.duration(),
                      .elevation = f.elevation(),
                      .step = f.step(),
                      .steps = f.cost().steps,
                      .evaluations = f.cost().evaluations,
                      .events = f.events().size()});
  });
}

physim_result physim_flight_at(const physim_flight* flight, physim_moment moment, double value, physim_sample* sample) {
  return guarded([&](Call& call) {
    const auto of = call.find(flight, "flight");
    call.need_struct(sample, "sample");
    call.need(!std::isnan(value), "value", "is not a number");
    call.need(moment >= PHYSIM_AT_END && moment <= PHYSIM_AT_APEX, "moment", "is none");
    if (!call.ok()) return;
    const Result<Sample> found = sample_at(of->flight, moment, value);
    if (call.take(found, PHYSIM_NOT_FOUND)) call.write(sample, sample_of(*found));
  });
}

physim_result physim_flight_jerk(const physim_flight* flight, double time, double jerk[3]) {
  return guarded([&](Call& call) {
    const auto of = call.find(flight, "flight");
    call.need(!std::isnan(time), "time", "is not a number");
    call.need(jerk, "jerk");
    if (call.ok()) put(jerk, of->flight.jerk(time));
  });
}

physim_result physim_flight_samples(const physim_flight* flight, const double* times, size_t count,
                                    const physim_samples* into) {
  return guarded([&](Call& call) {
    const IeeeMode mode;
    const auto of = call.find(flight, "flight");
    call.need(into, "into");
    const physim_samples columns = call.read(into, "into");
    if (!call.ok()) return;
    const Flight& f = of->flight;
    for (std::size_t i = 0; i < count; ++i) {
      const double part = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
      put_sample(columns, i,
                 f.at(times != nullptr          ? times[i]
                      : i + 1 == count && i > 0 ? f.duration()
                                                : part * f.duration()));
    }
  });
}

physim_result physim_flight_events(const physim_flight* flight, size_t first, physim_event* into, size_t each,
                                   size_t room, size_t* count) {
  return guarded([&](Call& call) {
    const auto of = call.find(flight, "flight");
    if (call.ok()) put_events(call, of->flight.events(), first, into, each, room, count);
  });
}

physim_result physim_flight_notes(const physim_flight* flight, char* into, size_t room, size_t* length) {
  return guarded([&](Call& call) {
    const auto of = call.find(flight, "flight");
    call.need_rows(into, room, "into");
    if (!call.ok()) return;
    std::string text;
    for (const FidelityNote& note : of->flight.fidelity_in_use().notes)
      text += note.effect + ": " + note.asked + ", " + note.granted + ": " + note.reason + "\n";
    call.write_text(text, into, room, length);
  });
}

physim_result physim_batch(const physim_def* def, const char* shot, size_t count, const physim_launches* launches,
                           const physim_weather* weather, const physim_ends* into, const physim_pool* pool,
                           physim_batch_info* info) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    const auto threads = call.find_or_null(pool, "pool");
    const physim_launches given = call.read(launches, "launches");
    const physim_weather w = call.read(weather, "weather");
    call.need(into, "into");
    const physim_ends e = call.read(into, "into");
    if (info != nullptr) call.need_struct(info, "info");
    call.need(count > 0, "count", "is 0");
    call.need_rows(into, count, "into");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    const Scenario& scenario = of->scenario();
    const ScenarioShot& own = of->shot();
    if (own.cheapest_within)
      return call.fail(PHYSIM_REFUSED, "a batch has one fidelity for all shots", "fidelity.cheapest_within",
                       "choose it once by physim_choose_fidelity()");
    LaunchColumns columns = columns_of(given, count);
    columns.common = own.launch;
    const std::vector<double> same(columns.size() == 0 ? count : 0, own.launch.position.x);
    if (columns.size() == 0) columns.x = same;  // as many as the shot has it
    const Lent lent(threads);
    const ProjectileDef projectile = projectile_of(own);
    PHYSIM_ASSERT(columns.size() == count);
    const ColumnsResult flown =
        fly_columns(projectile, columns, scenario.environment, projectile.fidelity, scenario.tolerance, of->until(),
                    columns_by<EndColumns>(kEndColumns, e, count), lent.runner(), weather_of(w, count));
    if (flown.refused == count && flown.error) return call.fail(PHYSIM_REFUSED, *flown.error);
    PHYSIM_ASSERT(flown.refused <= count);
    if (info == nullptr) return;
    physim_batch_info out{};
    out.refused = flown.refused;
    put_text(out.kernel, sizeof out.kernel, flown.kernel);
    put_text(out.first_error, sizeof out.first_error, flown.error ? flown.error->text() : "");
    call.write(info, out);
  });
}
