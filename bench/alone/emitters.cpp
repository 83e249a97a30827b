// What particles of emitters cost, for profilers: births and deaths of one emitter, a frame of a million sparks, or
// sixteen emitters of sixteen rungs in one world and in sixteen.
//
//   g++ -std=c++20 -O2 -g -Iinclude -Isrc -Ibench bench/alone/emitters.cpp bench/sparks.cpp \
//     bench/world_bench.cpp bench/report.cpp bench/timing.cpp build/bench/libphysim.a -lpthread -o emitters
//   ./emitters births 40     rounds of 100 000 births in a step, and of their deaths in the next one
//   ./emitters frame 40      steps of a million sparks without and with drag over life, and reading them
//   ./emitters step 40       one of these alone, or: drag, places, looks
//   ./emitters together 60   steps of sixteen emitters in one world
//   ./emitters apart 60      steps of sixteen worlds of one
//
// Prints nanoseconds of processor time for each: the least and the median of all rounds.
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "sparks.hpp"
#include "timing.hpp"
#include "world_bench.hpp"

using namespace physim;
using namespace physim::bench;

namespace {

void print(const char* what, const std::vector<double>& seconds, double count) {
  std::printf("%-10s least %6.1f  median %6.1f ns\n", what, 1e9 * smallest(seconds) / count,
              1e9 * median(seconds) / count);
}

void births(int rounds, const Fidelity& fidelity) {
  constexpr std::size_t kBirths = 100000;
  World world = empty_world(), spawning = empty_world();
  EmitterDef def = spray(*world.add_kind(world_bullet(fidelity)), kBirths / kFrame, {kFrame});
  def.cycle = {.duration = kFrame, .looping = false, .plays = false};
  const EmitterId emitter = *world.add_emitter(def);
  const KindId kind = *spawning.add_kind(world_bullet(fidelity));
  const std::vector<Launch> launches = volley(kBirths);
  std::vector<ProjectileId> ids(kBirths);
  std::vector<double> spawns, emits, born, died, despawns;
  for (int round = 0; round <= rounds; ++round) {
    if (round == 1)
      for (auto* list : {&spawns, &emits, &born, &died, &despawns}) list->clear();
    spawns.push_back(seconds(Clock::cpu, [&] { spawning.spawn(kind, launches, ids); }));
    emits.push_back(seconds(Clock::cpu, [&] { world.emit(emitter, kBirths); }));
    world.clear();
    world.step(kFrame);
    world.play_emitter(emitter);
    born.push_back(seconds(Clock::cpu, [&] { world.step(kFrame); }));
    died.push_back(seconds(Clock::cpu, [&] { world.step(kFrame); }));
    despawns.push_back(seconds(Clock::cpu, [&] { spawning.despawn(ids); }));
    world.clear();
    spawning.step(kFrame);
    world.step(kFrame);
  }
  print("spawn", spawns, kBirths), print("emit", emits, kBirths), print("birth", born, kBirths);
  print("death", died, kBirths), print("despawn", despawns, kBirths);
}

/// What a frame of a million sparks asks for: one part of it, or all where `what` is "frame".
void frame(int rounds, const std::string& what) {
  SteadySparks sparks;
  struct Part {
    const char* name;
    std::function<void()> call;
    std::vector<double> taken{};
  };
  Part parts[] = {{"step", [&] { sparks.step(); }},
                  {"drag", [&] { sparks.step_driven(); }},
                  {"places", [&] { sparks.read_places(); }},
                  {"looks", [&] { sparks.read_looks(); }}};
  for (int round = 0; round < rounds; ++round)
    for (Part& part : parts)
      if (what == "frame" || what == part.name) part.taken.push_back(seconds(Clock::cpu, part.call));
  for (const Part& part : parts)
    if (!part.taken.empty()) print(part.name, part.taken, SteadySparks::kCount);
}

void sixteen(int rounds, bool together) {
  constexpr double kPerSecond = 120000, kLife = 0.25;
  std::vector<World> worlds;
  for (const Fidelity& rung : sixteen_fidelities()) {
    if (worlds.empty() || !together) worlds.push_back(empty_world());
    World& world = worlds.back();
    static_cast<void>(world.add_emitter(spray(*world.add_kind(world_bullet(rung)), kPerSecond, {kLife})));
  }
  const auto step = [&] {
    for (World& world : worlds) world.step(kFrame);
  };
  for (int i = 0; i < static_cast<int>(1.2 * kLife / kFrame); ++i) step();
  std::vector<double> steps;
  for (int round = 0; round < rounds; ++round) steps.push_back(seconds(Clock::cpu, step));
  std::size_t count = 0;
  for (const World& world : worlds) count += world.size();
  print(together ? "together" : "apart", steps, static_cast<double>(count));
}

}  // namespace

int main(int count, char** given) {
  const std::string what = count > 1 ? given[1] : "births";
  const int rounds = count > 2 ? std::atoi(given[2]) : 20;
  if (what == "births")
    births(rounds, Fidelity::game());
  else if (what == "arcade")
    births(rounds, Fidelity::arcade());
  else if (what == "together" || what == "apart")
    sixteen(rounds, what == "together");
  else
    frame(rounds, what);
}
