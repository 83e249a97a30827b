// What particles of emitters cost, for profilers: births and deaths of one emitter, a frame of a million sparks, or
// sixteen emitters of sixteen rungs in one world and in sixteen.
//
//   g++ -std=c++20 -O2 -g -Iinclude -Isrc -Ibench bench/alone/emitters.cpp bench/world_bench.cpp bench/report.cpp \
//     bench/timing.cpp build/bench/libphysim.a -lpthread -o emitters
//   ./emitters births 40     rounds of 100 000 births in a step, and of their deaths in the next one
//   ./emitters frame 40      steps of a million sparks without and with drag over life, and reading them
//   ./emitters step 40       one of these alone, or: drag, places, looks
//   ./emitters together 60   steps of sixteen emitters in one world
//   ./emitters apart 60      steps of sixteen worlds of one
//
// Prints nanoseconds of processor time for each: the least and the median of all rounds.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "timing.hpp"
#include "world_bench.hpp"

using namespace physim;
using namespace physim::bench;

namespace {

EmitterDef spray(KindId kind, double per_second, double lifetime) {
  EmitterDef def;
  def.kind = kind;
  def.seed = 7;
  def.rotation = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
  def.per_second = {per_second};
  def.maximum = 4000000;
  def.start.lifetime = {lifetime};
  def.start.speed = {5, 10};
  def.from = {.shape = EmitShape::cone, .radius = 0.1};
  return def;
}
World empty_world() { return std::move(World::create(free_flight()).value()); }

void print(const char* what, const std::vector<double>& seconds, double count) {
  std::printf("%-10s least %6.1f  median %6.1f ns\n", what, 1e9 * smallest(seconds) / count,
              1e9 * median(seconds) / count);
}

void births(int rounds, const Fidelity& fidelity) {
  constexpr std::size_t kBirths = 100000;
  World world = empty_world(), spawning = empty_world();
  EmitterDef def = spray(*world.add_kind(world_bullet(fidelity)), kBirths / kFrame, kFrame);
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

/// One of what a frame of a million sparks asks for, or all of it where `what` is "frame".
void frame(int rounds, const std::string& what) {
  constexpr double kFlow = 1.0 / 60;
  constexpr std::size_t kSparks = 1000000;
  World world = empty_world(), driven = empty_world();
  EmitterDef def = spray(*world.add_kind(world_bullet(Fidelity::game())), kSparks / 2.0, 2);
  def.start.lifetime = {1.5, 2.5};
  def.start.size = {0.5, 1.5};
  def.life.size = {1, {}, {{0, 1}, {1, 0}}};
  def.life.colour.gradient = {{0, 0xfff0a0ff}, {1, 0xff280000}};
  const EmitterId emitter = *world.add_emitter(def);
  def.kind = *driven.add_kind(world_bullet(Fidelity::game()));
  def.flight.drag = {1, {}, {{0, 1}, {1, 0}}};
  static_cast<void>(*driven.add_emitter(def));
  for (int i = 0; i < 165; ++i) {
    if (what != "drag") world.step(kFlow);
    if (what == "drag" || what == "frame") driven.step(kFlow);
  }
  std::vector<Vec3d> position(kSparks + kSparks / 16), size = position;
  std::vector<std::uint32_t> colour(position.size());
  std::vector<double> plain, drag, places, looks, ratios;
  const auto time = [&](const char* part, std::vector<double>& taken, const auto& call) {
    if (what == "frame" || what == part) taken.push_back(seconds(Clock::cpu, call));
  };
  for (int round = 0; round < rounds; ++round) {
    time("step", plain, [&] { world.step(kFlow); });
    time("drag", drag, [&] { driven.step(kFlow); });
    time("places", places, [&] { world.particles(emitter, {.position = position}); });
    time("looks", looks, [&] { world.particles(emitter, {.position = position, .size = size, .colour = colour}); });
    if (what == "frame") ratios.push_back((drag.back() + looks.back()) / (plain.back() + places.back()));
  }
  if (!plain.empty()) print("step", plain, kSparks);
  if (!drag.empty()) print("drag", drag, kSparks);
  if (!places.empty()) print("places", places, kSparks);
  if (!looks.empty()) print("looks", looks, kSparks);
  if (!ratios.empty()) std::printf("with looks and drag over life, beside places: median %.3f\n", median(ratios));
}

void sixteen(int rounds, bool together) {
  constexpr double kPerSecond = 120000, kLife = 0.25;
  std::vector<World> worlds;
  for (const Fidelity& rung : sixteen_fidelities()) {
    if (worlds.empty() || !together) worlds.push_back(empty_world());
    World& world = worlds.back();
    static_cast<void>(world.add_emitter(spray(*world.add_kind(world_bullet(rung)), kPerSecond, kLife)));
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
  const char* what = count > 1 ? given[1] : "births";
  const int rounds = count > 2 ? std::atoi(given[2]) : 20;
  if (std::strcmp(what, "births") == 0) births(rounds, Fidelity::game());
  if (std::strcmp(what, "arcade") == 0) births(rounds, Fidelity::arcade());
  if (std::strcmp(what, "frame") == 0 || std::strcmp(what, "step") == 0 || std::strcmp(what, "drag") == 0 ||
      std::strcmp(what, "places") == 0 || std::strcmp(what, "looks") == 0)
    frame(rounds, what);
  if (std::strcmp(what, "together") == 0) sixteen(rounds, true);
  if (std::strcmp(what, "apart") == 0) sixteen(rounds, false);
}
