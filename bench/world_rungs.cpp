// What a step costs on other rungs, with ground and with events, beside the game preset.
#include "allocations.hpp"
#include "world_bench.hpp"

namespace physim::bench {
namespace {

constexpr std::size_t kCount = 100000;
constexpr int kSteps = 5;  // in a turn

struct Entry {
  std::string name;
  World world;
  std::function<void(World&)> step = [](World& w) { w.step(kFrame); };
  double events = 0;  // in each step
  std::vector<double> each = {};
};

Entry free_entry(std::string name, const std::vector<Fidelity>& fidelities) {
  return {std::move(name), world_of(free_flight(), fidelities, kCount)};
}

Fidelity with_precision(Fidelity f, Precision precision) {
  f.precision = precision;
  return f;
}

/// Balls that hop on a plane, a tenth of a second each.
Entry bouncing_entry() {
  WorldDef def = free_flight();
  def.ground.mode = GroundMode::bounce;
  World world = std::move(World::create(def).value());
  BodyDef body;
  body.restitution = 0.999;
  body.friction = 0;
  body.can_sleep = false;
  const KindId kind = *world.add_kind(world_bullet(Fidelity::game()), body);
  world.reserve(kind, kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    Launch launch = volley_launch(i);
    const double climb = 0.5 - static_cast<double>(i % 1000) / 1000;  // all parts of a hop
    launch.position.y = (0.25 - climb * climb) / (2 * 9.80665) + 1e-4;
    launch.velocity = Vec3d{5, climb, 0};
    world.spawn(kind, launch);
  }
  return {"game, bouncing ground", std::move(world)};
}

/// A volley that rises and falls: apexes are told.
Entry apex_entry() {
  WorldDef def = free_flight();
  def.apex_events = true;
  World world = std::move(World::create(def).value());
  const KindId kind = *world.add_kind(world_bullet(Fidelity::game()));
  world.reserve(kind, kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    Launch launch = volley_launch(i);
    launch.velocity->y = 25.0 * static_cast<double>(i % 1000) / 1000;
    world.spawn(kind, launch);
  }
  return {"game, apex events", std::move(world)};
}

/// A machine gun: a hundredth of the projectiles lands in every step and as many are spawned.
Entry landing_entry() {
  WorldDef def = free_flight();
  def.ground.mode = GroundMode::land;
  World world = std::move(World::create(def).value());
  const KindId kind = *world.add_kind(world_bullet(Fidelity::game()));
  world.reserve(kind, 2 * kCount);
  std::vector<Launch> launches = volley(kCount / 100);
  for (Launch& launch : launches) {
    launch.position.y = 0;
    launch.velocity->y = 0.5 * 9.80665 * 100 * kFrame;  // in the air for a hundred steps
  }
  const auto step = [kind, launches](World& w) {
    for (const Launch& launch : launches) w.spawn(kind, launch);
    w.step(kFrame);
  };
  for (int i = 0; i < 300; ++i) step(world);  // until every buffer has seen its worst
  return {"game, 1 % land and are replaced", std::move(world), step};
}

std::vector<Entry> entries() {
  std::vector<Entry> list;
  list.push_back(free_entry("game", {Fidelity::game()}));
  Fidelity no_drag = Fidelity::game();
  no_drag.drag = DragModel::off;
  list.push_back(free_entry("game without drag", {no_drag}));
  list.push_back(free_entry("game in double", {with_precision(Fidelity::game(), Precision::float64)}));
  list.push_back(free_entry("arcade (closed form)", {Fidelity::arcade()}));
  list.push_back(free_entry("classic", {Fidelity::classic()}));
  list.push_back(free_entry("G7, standard air, semi-implicit", {curve_fidelity(Integrator::semi_implicit_euler)}));
  list.push_back(free_entry("G7, standard air, RK4", {curve_fidelity(Integrator::rk4)}));
  list.push_back(free_entry("G7, standard air, RK4, double",
                            {with_precision(curve_fidelity(Integrator::rk4), Precision::float64)}));
  list.push_back(free_entry("small_arms (Tsit5, double)", {Fidelity::small_arms()}));
  list.push_back(free_entry("16 fidelities mixed", sixteen_fidelities()));
  list.push_back(bouncing_entry());
  list.push_back(apex_entry());
  list.push_back(landing_entry());
  return list;
}

}  // namespace

Section rungs_section(const Options& options) {
  std::vector<Entry> list = entries();
  std::vector<std::function<void()>> turns;
  for (Entry& e : list) {
    for (int i = 0; i < 10; ++i) e.step(e.world);  // buffers find their size
    turns.emplace_back([&e] {
      for (int i = 0; i < kSteps; ++i) {
        e.step(e.world);
        e.events += static_cast<double>(e.world.events().size());
      }
    });
  }
  std::vector<std::int64_t> allocated;
  for (Entry& e : list) {
    const std::int64_t start = allocations();
    for (int i = 0; i < 10; ++i) e.step(e.world);
    allocated.push_back(allocations() - start);
  }
  const auto taken = take_turns(options.clock, options.rounds, turns);
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].each = each_ns(taken[i], kSteps * static_cast<double>(list[i].world.size()));

  Section s;
  s.title = "Worlds: rungs, ground and events";
  s.intro =
      "Steps of " + fixed(static_cast<double>(kCount), 0).text +
      " projectiles by one thread, five in each turn, beside those of the game preset: medians of the ratios within "
      "each round.";
  s.columns = {"vs game", "rung", "ns a projectile-step", "quartiles", "events a step", "allocations in 10 steps"};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Entry& e = list[i];
    s.rows.push_back({times(median(ratios(list[0].each, e.each))), e.name, nanoseconds(median(e.each)),
                      quartiles(e.each), fixed(e.events / (kSteps * options.rounds), 0),
                      fixed(static_cast<double>(allocated[i]), 0)});
  }
  s.notes = {
      "Mixed: semi-implicit and explicit Euler, no drag, damping, linear and quadratic, G7 in standard air, "
      "constant gravity and Newton's, float."};
  return s;
}

}  // namespace physim::bench
