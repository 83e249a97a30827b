// Worlds that are stepped, and what is done in each step, in turn.
#include "allocations.hpp"
#include "world_bench.hpp"

namespace physim::bench {
namespace {

constexpr int kSteps = 8;  // in a turn: a detail rule looks at all projectiles in so many

/// Allocations in ten steps, after ten in which buffers find their size.
std::vector<std::int64_t> settle(std::vector<SteppedWorld>& worlds) {
  std::vector<std::int64_t> allocated;
  for (SteppedWorld& w : worlds) {
    for (int i = 0; i < 10; ++i) w.step(w.world);
    const std::int64_t start = allocations();
    for (int i = 0; i < 10; ++i) w.step(w.world);
    allocated.push_back(allocations() - start);
  }
  return allocated;
}

void take_times(std::vector<SteppedWorld>& worlds, const Options& options) {
  std::vector<std::function<void()>> turns;
  for (SteppedWorld& w : worlds)
    turns.emplace_back([&w] {
      for (int i = 0; i < kSteps; ++i) {
        w.step(w.world);
        w.events += static_cast<double>(w.world.events().size());
      }
    });
  const auto taken = take_turns(options.clock, options.rounds, turns);
  for (std::size_t i = 0; i < worlds.size(); ++i)
    worlds[i].each = each_ns(taken[i], kSteps * static_cast<double>(worlds[i].world.size()));
}

}  // namespace

SteppedWorld with_apexes(std::string name, const Fidelity& fidelity) {
  WorldDef def = free_flight();
  def.apex_events = true;
  World world = std::move(World::create(def).value());
  const KindId kind = *world.add_kind(world_bullet(fidelity));
  world.reserve(kind, kStepped);
  for (std::size_t i = 0; i < kStepped; ++i) {
    Launch launch = volley_launch(i);
    launch.velocity->y = 25.0 * static_cast<double>(i % 1000) / 1000;
    world.spawn(kind, launch);
  }
  return {std::move(name), std::move(world)};
}

SteppedWorld landing(std::string name, const Fidelity& fidelity) {
  WorldDef def = free_flight();
  def.ground.mode = GroundMode::land;
  World world = std::move(World::create(def).value());
  const KindId kind = *world.add_kind(world_bullet(fidelity));
  world.reserve(kind, 2 * kStepped);
  std::vector<Launch> launches = volley(kStepped / 100);
  for (Launch& launch : launches) {
    launch.position.y = 0;
    launch.velocity->y = 0.5 * 9.80665 * 100 * kFrame;  // in the air for a hundred steps
  }
  const auto step = [kind, launches](World& w) {
    for (const Launch& launch : launches) w.spawn(kind, launch);
    w.step(kFrame);
  };
  for (int i = 0; i < 300; ++i) step(world);  // until every buffer has seen its worst
  return {std::move(name), std::move(world), step};
}

Section steps_section(std::vector<SteppedWorld> worlds, const std::string& first, const std::string& what,
                      const Options& options) {
  const std::vector<std::int64_t> allocated = settle(worlds);
  take_times(worlds, options);
  Section s;
  s.intro = "Steps of " + fixed(static_cast<double>(kStepped), 0).text +
            " projectiles by one thread, eight in each turn, beside those of the first world: medians of the ratios "
            "within each round.";
  s.columns = {"vs " + first, what, "ns a projectile-step", "quartiles", "events a step", "allocations in 10 steps"};
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    const SteppedWorld& w = worlds[i];
    s.rows.push_back({times(median(ratios(worlds[0].each, w.each))), w.name, nanoseconds(median(w.each)),
                      quartiles(w.each), fixed(w.events / (kSteps * options.rounds), 0),
                      fixed(static_cast<double>(allocated[i]), 0)});
  }
  return s;
}

}  // namespace physim::bench
