// What choosing an accuracy for each projectile costs: worlds of many rungs beside worlds of one, and each effect with
// what leaving it out saves and spoils.
#include <algorithm>
#include <cmath>

#include "physim/body.hpp"
#include "world_bench.hpp"

namespace physim::bench {
namespace {

// ------------------------------------------------------------------------------------------- many rungs in one world
struct Mix {
  std::size_t rungs;
  std::size_t count;
  std::unique_ptr<World> mixed = {};
  std::vector<std::unique_ptr<World>> alone = {};  // as many projectiles, each world on one of the rungs
};

/// Steps of all of them, a few at a time.
std::function<void()> steps_of(const std::vector<World*>& worlds, int steps) {
  return [worlds, steps] {
    for (World* world : worlds)
      for (int i = 0; i < steps; ++i) world->step(kFrame);
  };
}

std::vector<Cell> row_of(const Options& options, Mix mix) {
  std::vector<Fidelity> rungs = sixteen_fidelities();
  rungs.resize(mix.rungs);
  mix.mixed = std::make_unique<World>(world_of(free_flight(), rungs, mix.count));
  std::vector<World*> alone;
  for (const Fidelity& rung : rungs) {
    mix.alone.push_back(std::make_unique<World>(world_of(free_flight(), {&rung, 1}, mix.count)));
    alone.push_back(mix.alone.back().get());
  }
  const double count = static_cast<double>(mix.count);
  const int steps = std::max(2, static_cast<int>(1e6 / (2 * count)));
  const auto together = steps_of({mix.mixed.get()}, steps), apart = steps_of(alone, steps);
  together(), apart();  // buffers find their size
  const auto taken = take_turns(options.clock, options.rounds, {together, apart});
  const std::vector<double> mixed = each_ns(taken[0], count * steps);
  const std::vector<double> each = each_ns(taken[1], count * steps * static_cast<double>(mix.rungs));
  return {fixed(static_cast<double>(mix.rungs), 0), fixed(count, 0), nanoseconds(median(mixed)),
          nanoseconds(median(each)), times(median(ratios(mixed, each)))};
}

// ------------------------------------------------------------------------------------------- effects
constexpr double kFlown = 1.5, kUsual = 1.0 / 60;  // [s]

struct Variant {
  std::string name;
  Fidelity fidelity;
};

/// Every effect of a point mass over a flat Earth, by Runge and Kutta's method.
Fidelity all_effects() {
  Fidelity f = Fidelity::simulation();
  f.integrator = Integrator::rk4;
  f.rotation = RotationModel::none;  // worlds show what flew; drift by a formula is added to whole flights alone
  return f;
}

template <class Change>
Variant changed(std::string name, const Change& change) {
  Fidelity f = all_effects();
  change(f);
  return {std::move(name), f};
}

std::vector<Variant> variants() {
  std::vector<Variant> list{{"all effects, RK4, double", all_effects()}};
  const auto add = [&](const char* name, const auto& change) { list.push_back(changed(name, change)); };
  add("no drag", [](Fidelity& f) { f.drag = DragModel::off; });
  add("quadratic drag, not a curve", [](Fidelity& f) { f.drag = DragModel::linear_quadratic; });
  add("constant air", [](Fidelity& f) { f.air = AirModel::constant; });
  add("no wind", [](Fidelity& f) { f.wind = WindModel::off; });
  add("constant gravity", [](Fidelity& f) { f.gravity = GravityModel::constant; });
  add("no Coriolis", [](Fidelity& f) { f.earth = EarthModel::flat; });
  add("float32", [](Fidelity& f) { f.precision = Precision::float32; });
  add("semi-implicit Euler", [](Fidelity& f) { f.integrator = Integrator::semi_implicit_euler; });
  add("Heun", [](Fidelity& f) { f.integrator = Integrator::heun; });
  add("RK4(3), adaptive", [](Fidelity& f) { f.integrator = Integrator::rk43; });
  add("Tsit5, adaptive", [](Fidelity& f) { f.integrator = Integrator::tsit5; });
  add("DOP853, adaptive", [](Fidelity& f) { f.integrator = Integrator::dop853; });
  return list;
}

World world_of_bullets(const Fidelity& fidelity, std::size_t count) {
  WorldDef def = free_flight();
  def.environment.wind.velocity = {0, 0, 4};
  World world = std::move(World::create(def).value());
  ProjectilePreset preset = presets::rifle_bullet();
  preset.projectile.fidelity = fidelity;
  const KindId kind = *world.add_kind(preset.projectile);
  world.reserve(kind, count);
  for (std::size_t i = 0; i < count; ++i)
    world.spawn(kind, {.position = {0, 0, static_cast<double>(i)},
                       .speed = preset.speed * (1 - 0.1 * static_cast<double>(i) / static_cast<double>(count)),
                       .elevation = 0.01});
  return world;
}

Vec3d end_of(const Fidelity& fidelity) {
  World world = world_of_bullets(fidelity, 1);
  for (int i = 0; i < std::lround(kFlown / kUsual); ++i) world.step(kUsual);
  return world[world.ids().front()].position();
}

/// Steps of so many bullets until the first has flown its time, on new worlds in each turn; the worlds are made outside
/// of what is timed.
std::vector<double> flight_ns(const Options& options, const Fidelity& fidelity, std::size_t count) {
  World world = world_of_bullets(fidelity, count);
  world.step(kUsual);
  const Snapshot start = world.snapshot();
  std::vector<double> taken;
  const int steps = static_cast<int>(std::lround(kFlown / kUsual));
  for (int round = 0; round < options.rounds; ++round) {
    if (round > 0) world.restore(start);
    taken.push_back(seconds(options.clock, [&] {
      for (int i = 0; i < steps; ++i) world.step(kUsual);
    }));
  }
  return each_ns(taken, static_cast<double>(count) * steps);
}

}  // namespace

Section switches_section(const Options& options) {
  Section s;
  s.title = "Worlds: what a switch costs";
  s.intro =
      "One world whose projectiles are on several rungs, beside worlds of as many projectiles on each of these rungs "
      "alone: what a projectile-step costs in the one, and in the mean of the others.";
  s.columns = {"rungs", "projectiles", "ns mixed", "ns alone", "mixed over alone"};
  for (const std::size_t count : {100000, 10000, 1000})
    for (const std::size_t rungs : {1, 2, 4, 16}) s.rows.push_back(row_of(options, {.rungs = rungs, .count = count}));
  s.notes = {
      "Rungs: two integrators, four models of drag, two of gravity, float32. 1000 projectiles on 16 rungs are 62 on "
      "each: packs that are not full. Moving one to another rung: the section on operations."};
  return s;
}

Section effects_section(const Options& options) {
  const std::size_t count = options.quick ? 1000 : 10000;
  Fidelity exact = all_effects();
  exact.integrator = Fidelity::reference().integrator;
  exact.tolerance = Fidelity::reference().tolerance;
  const Vec3d truth = end_of(exact);
  Section s;
  s.title = "Worlds: what an effect costs";
  s.intro = "A .308 bullet with a wind of 4 m/s across, 60 steps a second, 1.5 s (" + fixed(truth.x, 0).text +
            " m): all effects, and one of them replaced by what is cheaper or dearer. Off: from the preset reference. "
            "Cost: of one of " +
            std::to_string(count) + " on one thread, over these steps.";
  s.columns = {"what is replaced", "off after 1.5 s", "ns a projectile-step", "quartiles"};
  for (const Variant& v : variants()) {
    const std::vector<double> ns = flight_ns(options, v.fidelity, count);
    s.rows.push_back({v.name, metres(length(end_of(v.fidelity) - truth)), nanoseconds(median(ns)), quartiles(ns)});
  }
  return s;
}

}  // namespace physim::bench
