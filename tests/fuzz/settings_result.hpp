// The result of a scenario as one number: all that its flights, its range card, its aim, its study or its world give.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "base/hash.hpp"
#include "model/ladder.hpp"
#include "model/sight.hpp"
#include "physim/solve.hpp"
#include "physim/study.hpp"
#include "prepare/grant.hpp"
#include "scenario/world_run.hpp"

namespace physim::test {

/// A result: the hash of its numbers, or the error that refuses it; and what was said about it.
struct SettingsResult {
  std::uint64_t bits = 0;
  std::string error{};
  std::vector<std::string> notes{};  // of the scenario, and "shot.fidelity.EFFECT" of what was granted
  std::uint64_t contacts = 0;        // hits, bounces and rests
  double time = 0;                   // of flight, of all projectiles together [s]
  double moved = 0;                  // how far they came, all together [m]
  std::vector<double> numbers{};     // the first ones
};

/// Whether the first numbers of two results differ by more than rounding and errors of steps do.
[[nodiscard]] inline bool differ_clearly(const SettingsResult& a, const SettingsResult& b) {
  constexpr double kRounding = 1e-5;
  if (a.numbers.size() != b.numbers.size()) return true;
  for (std::size_t i = 0; i < a.numbers.size(); ++i) {
    const double x = a.numbers[i], y = b.numbers[i];
    if (std::isfinite(x) && std::isfinite(y) && std::abs(x - y) > kRounding * (1 + std::abs(x))) return true;
  }
  return false;
}

class ResultHash {
 public:
  explicit ResultHash(const Scenario& scenario) : scenario_(scenario) { result_.notes = scenario.notes; }

  [[nodiscard]] SettingsResult result() {
    if (scenario_.world.given)
      of_world();
    else
      of_flights();
    of_questions();
    result_.bits = hash_.value();
    return result_;
  }

 private:
  void add(double x) {
    constexpr std::size_t kMost = 600;
    hash_.add(x);
    if (result_.numbers.size() < kMost && !is_of_steps_) result_.numbers.push_back(x);
  }
  void add(const Vec3d& v) { add(v.x), add(v.y), add(v.z); }
  void add(const std::string& text) { hash_.add(std::as_bytes(std::span(text))); }
  void add(const FidelityInUse& in_use) {
    for (const FidelityNote& note : in_use.notes)
      result_.notes.push_back("shot.fidelity." + (note.effect == "fidelity" ? "cheapest_within" : note.effect) + ": " +
                              note.reason);
  }
  void add(const Event& event) {
    hash_.add(static_cast<std::uint64_t>(event.kind));
    add(event.time), add(event.position), add(event.velocity), add(event.value);
  }
  void add(const Sample& s) {
    for (const double x : {s.time, s.speed, s.mach, s.energy, s.mass, s.thrust, s.range, s.drop, s.windage,
                           s.orientation.w, s.orientation.x, s.orientation.y, s.orientation.z, s.angle_of_attack})
      add(x);
    add(s.position), add(s.velocity), add(s.acceleration), add(s.angular_velocity);
  }
  void refuse(const Error& error) {
    if (result_.error.empty()) result_.error = error.text();
  }

  // ---------------------------------------------------------------------------------------------------------- flights
  void add(const Flight& flight) {
    if (flight.error()) return refuse(*flight.error());
    hash_.add(static_cast<std::uint64_t>(flight.outcome()));
    result_.time += flight.duration();
    result_.moved += length(flight.end().position - flight.at(0).position);
    for (const Event& event : flight.events()) result_.contacts += event.kind == EventKind::hit ? 1 : 0;
    add(flight.fidelity_in_use());
    add(flight.duration()), add(flight.elevation()), add(flight.step());
    constexpr int kParts = 16;
    for (int i = 0; i <= kParts; ++i) add(flight.at(flight.duration() * i / kParts));
    const std::vector<double> times = flight.step_times();
    is_of_steps_ = true;
    for (const double time : {times[times.size() / 3], times[times.size() / 2]}) add(flight.at(time));
    is_of_steps_ = false;
    for (const Event& event : flight.events()) add(event);
    for (const double range : scenario_.ranges)
      if (const auto sample = flight.at_range(range)) add(*sample);
    add_place(flight.fidelity_in_use().fidelity.earth, flight.end().position, flight.end().velocity);
  }
  /// Coordinates and directions of the compass: over a flat Earth nothing that the program writes has them.
  void add_place(EarthModel earth, const Vec3d& position, const Vec3d& velocity) {
    if (row(earth).shape == EarthShape::flat) return;
    const EarthFrames frames(scenario_.environment, earth);
    const Geodetic place = frames.geodetic(position);
    add(place.latitude), add(place.longitude), add(place.height), add(frames.local(position, velocity));
  }

  void of_flights() {
    const Result<SceneParts> parts = scene_parts(scenario_);
    if (!parts) return refuse(parts.error());
    for (const ScenarioShot& shot : scenario_.shots) {
      add(shot.projectile.name);
      hash_.add(std::uint64_t{shot.body.colour});
      const Flight flight =
          scenario_.things.empty() ? fly_shot(scenario_, shot) : fly_shot(scenario_, shot, parts->scene);
      add(flight);
      add(stability_factor(shot.projectile, shot.launch, scenario_.environment).value_or(0));
      if (!flight.error())
        for (const ThingHit& hit : flight_hits(scenario_, shot, flight, *parts).all) add_hit(hit);
    }
  }

  void of_questions() {
    const Result<SceneParts> parts = scene_parts(scenario_);
    if (!parts || !result_.error.empty()) return;
    if (scenario_.target.position) of_aim(*parts);
    if (!scenario_.study.inputs.empty()) of_study();
    for (const double range : scenario_.ranges) add(range);
  }

  void of_aim(const SceneParts& parts) {
    const ScenarioShot& shot = scenario_.shots.front();
    const ScenarioTarget& given = scenario_.target;
    AimOptions options{.arc = given.arc,
                       .tolerance = given.tolerance,
                       .ground = scenario_.until.ground,
                       .flight = scenario_.tolerance};
    if (!scenario_.things.empty()) options.scene = &parts.scene;
    options.contact = contact_of(shot);
    Launch launch = shot.launch;
    launch.sight = {};
    const auto aim = physim::aim(shot.projectile, launch, scenario_.environment, shot.projectile.fidelity,
                                 {*given.position, given.velocity, given.acceleration}, options);
    if (!aim) return refuse(aim.error());
    for (const auto& solution : {aim->low, aim->high})
      if (solution) add(solution->launch.elevation), add(solution->launch.azimuth), add(solution->time);
    add(aim->nearest.miss), add(options.tolerance);
  }

  void of_study() {
    const Result<Study> study = study_of(scenario_, scenario_.shots.front());
    if (!study) return refuse(study.error());
    const Result<StudyPlan> plan = plan_study(*study);
    if (!plan) return refuse(plan.error());
    const Result<StudyResult> done = run_study(*plan);
    if (!done) return refuse(done.error());
    add(*done);
  }
  void add(const Estimate& estimate) { add(estimate.value), add(estimate.error); }
  void add(const StudyResult& done) {
    hash_.add(done.shots), hash_.add(done.not_arrived);
    for (const QuantityResult& each : done.quantities) {
      add(each.mean), add(each.deviation);
      hash_.add(static_cast<std::uint64_t>(each.quantity));
    }
    if (done.from_aim) add(done.from_aim->mean);
    for (const HitResult& hit : done.hits) add(hit.name), add(hit.probability);
    for (const SpreadResult& spread : done.spreads) hash_.add(spread.groups);
    for (const HitsOverInput& over : done.over_inputs) hash_.add(std::uint64_t{over.parts.size()});
    for (const IndexResult& index : done.indices)
      for (const Estimate& total : index.total) add(total);
    for (const StudyResult& at : done.at) add(at);
  }

  // ----------------------------------------------------------------------------------------------------------- worlds
  void add_hit(const ThingHit& hit) {
    hash_.add(std::uint64_t{hit.launched.group}), hash_.add(hit.launched.number);
    add(hit.time), add(hit.position), add(hit.velocity), add(hit.velocity_after), add(hit.depth), add(hit.energy);
    hash_.add(std::uint64_t{hit.thing}), hash_.add(static_cast<std::uint64_t>(hit.outcome));
    if (hit.thing < scenario_.things.size()) add(scenario_.things[hit.thing].name);
    if (hit.material < scenario_.materials.size()) add(scenario_.materials[hit.material].name);
  }

  void of_world() {
    auto run = WorldRun::create(scenario_);
    if (!run) return refuse(run.error());
    for (const ScenarioShot& shot : scenario_.shots)  // which may be gone before the first look
      add(grant(shot.projectile.fidelity, shot.projectile, scenario_.environment));
    const std::uint64_t steps = std::min<std::uint64_t>(run->steps(), 90);
    add(scenario_.world.duration);
    for (std::uint64_t i = 0; i < steps; ++i) {
      run->step();
      for (const RunEvent& event : run->events()) hash_.add(event.launched.number), add(event.event);
      for (const WallHit& hit : run->hits()) add(hit.time), add(hit.position), add(hit.velocity);
      for (const ThingHit& hit : run->thing_hits()) add_hit(hit);
      result_.contacts += run->thing_hits().size();
      for (const RunEvent& event : run->events()) result_.contacts += event.event.kind == EventKind::bounced ? 1 : 0;
      result_.time += static_cast<double>(run->world().size()) * scenario_.world.def.step;
      if (i % 5 == 0) of_rows(*run);
    }
    of_rows(*run);
    for (const WorldGroup& group : run->groups()) {
      add(group.name), add(group.refusal);
      for (const std::uint64_t count : {group.spawned, group.refused, group.landed, group.bounces, group.slept,
                                        group.expired, group.hits, group.alive})
        hash_.add(count);
      add(group.range.mean), add(group.speed.mean), add(group.apex.mean), add(group.hit_y.mean);
    }
  }

  void of_rows(const WorldRun& run) {
    const World& world = run.world();
    std::vector<WorldColumns> columns;
    world.columns(columns);
    std::vector<ProjectileView> views;  // by age: the order of columns and of slots follows from rungs, too
    const auto view = [&](std::uint32_t index) { return world[world.id_at(index)]; };
    for (const WorldColumns& each : columns)
      std::visit([&](const auto& rows) { std::ranges::transform(rows.index, std::back_inserter(views), view); }, each);
    std::ranges::stable_sort(views, {}, [](const ProjectileView& row) {
      const Vec3d x = row.position();
      return std::tuple(row.age(), x.x, x.y, x.z);
    });
    for (const ProjectileView& row : views) of_row(row);
    for (const WorldGroup& group : run.groups())
      if (group.emitter) of_particles(world, group.emitter);
  }
  void of_row(const ProjectileView& row) {
    result_.moved += length(row.position() - row.previous_position());
    add_place(row.fidelity_in_use().fidelity.earth, row.position(), row.velocity());
    add(row.position()), add(row.velocity()), add(row.mass()), add(row.angular_velocity());
    add(row.mach());
    const Quatd q = row.orientation();
    for (const double x : {q.w, q.x, q.y, q.z}) add(x);
    hash_.add(row.colour(), row.layers());
    hash_.add(std::uint64_t{row.is_asleep()});
    add(row.label());
    if (result_.notes.size() < 100) add(row.fidelity_in_use());
  }
  void of_particles(const World& world, EmitterId emitter) {
    constexpr std::size_t kMost = 4096;
    std::vector<Vec3d> size(kMost), rotation(kMost), places(kMost);
    std::vector<std::uint32_t> colour(kMost);
    std::vector<double> age(kMost), time(kMost);
    const std::size_t count =
        world.particles(emitter, {.size = size, .rotation = rotation, .colour = colour, .age = age});
    for (std::size_t i = 0; i < std::min(count, kMost); ++i)
      add(size[i]), add(rotation[i]), hash_.add(std::uint64_t{colour[i]}), add(age[i]);
    const TrailCounts trails = world.trails(emitter, {.position = places, .time = time});
    for (std::size_t i = 0; i < std::min(trails.places, kMost); ++i) add(places[i]), add(time[i]);
  }

  const Scenario& scenario_;
  Hash hash_;
  bool is_of_steps_ = false;  // adds what depends on where steps end
  SettingsResult result_;
};

}  // namespace physim::test
