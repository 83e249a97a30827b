// Steps a world in which little happens but one kind of event: for counts of instructions, and for times that other
// programs disturb. The cases are those of the benchmark's "Worlds: rungs, ground and events".
//
//   g++ -std=c++20 -O2 -Iinclude bench/alone/events.cpp build/release/libphysim.a -o events
//   valgrind --tool=callgrind ./events bounce 2000 50    case (free, fall, bounce, land, apex), projectiles, steps
//   ./events bounce 100000 200
//
// Closed forms, to which nothing happens while they are timed: fall alone; read by fall-segments, fall-places,
// fall-columns, fall-hash and fall-snapshot in each step; watched by fall-ground, fall-rules and
// fall-detail. In fall-apex some reach their highest point in each step, in fall-land they land and are replaced.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "physim/physim.hpp"
#include "physim/units.hpp"

using namespace physim;
using namespace physim::units;

namespace {

constexpr double kFrame = 1.0 / 240;  // [s]
constexpr double kGravity = 9.80665;

ProjectileDef bullet(const Fidelity& fidelity) {
  ProjectileDef p;
  p.mass = 168_gr;
  p.diameter = 7.82_mm;
  p.drag.k1 = 2e-5;
  p.drag.k2 = 1.2e-5;
  p.fidelity = fidelity;
  return p;
}

Launch launch_of(int i, double height, double climb, double speed) {
  Launch launch;
  launch.position = {double(i % 1000), height, double(i / 1000)};
  launch.velocity = Vec3d{speed, climb, 0.1 * (i % 7)};
  return launch;
}

struct Case {
  World world;
  KindId kind;
  int replaced = 0;    // in a step
  std::string read{};  // what is read after each step
  std::vector<ProjectileId> ids{};
  std::vector<Vec3d> places{};
  std::vector<Segment> segments{};
  std::vector<WorldColumns> columns{};
  std::uint64_t hash = 0;

  void fire(int first, int count) {
    for (int i = first; i < first + count; ++i) world.spawn(kind, launch_of(i, 0, 0.5 * kGravity * 100 * kFrame, 300));
  }
  void step() {
    if (replaced > 0) fire(0, replaced);
    world.step(kFrame);
    if (read == "fall-segments") world.segments(segments);
    if (read == "fall-places") world.render_positions(ids, places);
    if (read == "fall-columns") world.columns(columns);
    if (read == "fall-hash") hash += world.hash();
    if (read == "fall-snapshot") static_cast<void>(world.snapshot());
  }
};

Case case_of(const std::string& name, int count) {
  const bool lands = name == "land" || name == "fall-land";
  WorldDef def;
  def.threading.threads = 1;
  def.ground.mode = name == "bounce" ? GroundMode::bounce : lands ? GroundMode::land : GroundMode::none;
  if (name == "fall-ground") def.ground = {GroundMode::land, -1e5, 0, 0};
  def.apex_events = name == "apex" || name == "fall-apex";
  if (name == "fall-detail") def.detail.rungs = {{Fidelity::arcade(), 1e6}, {Fidelity::game()}};
  Case c{std::move(World::create(def).value()), {}};
  BodyDef body;
  if (name == "fall-rules")
    body.despawn = {.below = -1e5,
                    .farther = 1e6,
                    .slower = 1,
                    .outside_box = true,
                    .box_low = {-1e6, -1e6, -1e6},
                    .box_high = {1e6, 1e6, 1e6}};
  if (name == "bounce") body.restitution = 0.999, body.friction = 0, body.can_sleep = false;
  c.kind = *c.world.add_kind(bullet(name.starts_with("fall") ? Fidelity::arcade() : Fidelity::game()), body);
  c.world.reserve(c.kind, static_cast<std::size_t>(2 * count));
  for (int i = 0; i < count && !lands; ++i) {
    const double part = double(i % 1000) / 1000;
    if (name == "bounce") {  // hops of a tenth of a second, all parts of one
      const double climb = 0.5 - part;
      c.world.spawn(c.kind, launch_of(i, (0.25 - climb * climb) / (2 * kGravity) + 1e-4, climb, 5));
    } else {
      c.world.spawn(c.kind, launch_of(i, 100, 25 * part, 600));
    }
  }
  if (lands) {  // a hundredth of them in each step, and as many are fired
    c.replaced = count / 100;
    for (int i = 0; i < 300; ++i) c.step();
  }
  c.ids = c.world.ids();
  c.places.resize(c.ids.size());
  c.read = name;
  for (int i = 0; i < 10; ++i) c.step();
  return c;
}

}  // namespace

int main(int count, char** arguments) {
  Case c = case_of(count > 1 ? arguments[1] : "bounce", count > 2 ? std::atoi(arguments[2]) : 2000);
  const int steps = count > 3 ? std::atoi(arguments[3]) : 50;
  double least = 1e18, sum = 0;
  std::size_t events = 0;
  for (int i = 0; i < steps; ++i) {
    const auto start = std::chrono::steady_clock::now();
    c.step();
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
    sum += taken.count();
    events += c.world.events().size();
  }
  std::printf("%.0f ns a step, least %.0f; %.1f events a step; hash %016llx\n", sum / steps, least,
              double(events) / steps, static_cast<unsigned long long>(c.world.hash()));
}
