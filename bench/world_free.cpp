// Free flight through the public World, with the original loop and Bullet beside it.
#include <algorithm>
#include <cmath>

#include "world_bench.hpp"

namespace physim::bench {
namespace {

constexpr const char* kOriginal = "original loop";
constexpr const char* kBullet = "Bullet 3";

struct Entry {
  std::string name;
  std::size_t count;
  int steps;  // in one turn
  std::function<void()> turn;
  std::vector<double> each = {};  // [ns]
};

/// Steps in one turn: enough to be measured, few enough to be waited for.
int steps_for(std::size_t count, double guess_ns) {
  return std::max(1, static_cast<int>(4e6 / (static_cast<double>(count) * guess_ns)));
}

/// How far a peer that flies the same physics is from the World after a hundred steps [m].
double distance_from_world(PeerWorld& peer) {
  const Fidelity game = Fidelity::game();
  constexpr std::size_t kCount = 100;
  World world = world_of(free_flight(), {&game, 1}, kCount);
  for (int i = 0; i < 100; ++i) {
    world.step(kFrame);
    peer.step(static_cast<float>(kFrame));
  }
  double worst = 0;
  const std::vector<ProjectileId> ids = world.ids();
  for (std::size_t i = 0; i < kCount; ++i) {
    float x[3];
    peer.position(i, x);
    worst = std::max(worst, length(world[ids[i]].position() - Vec3d{x[0], x[1], x[2]}));
  }
  return worst;
}

class Field {
 public:
  explicit Field(const Options& options) : options_(options) {}

  void add_world(std::size_t count) {
    const Fidelity game = Fidelity::game();
    worlds_.push_back(std::make_unique<World>(world_of(free_flight(), {&game, 1}, count)));
    World* world = worlds_.back().get();
    add("PhySim World, game preset", count, 1, [world] { world->step(kFrame); });
  }
  void add_peer(const std::string& name, std::size_t count, double guess_ns, std::unique_ptr<PeerWorld> peer) {
    peers_.push_back(std::move(peer));
    PeerWorld* p = peers_.back().get();
    add(name, count, guess_ns, [p] { p->step(static_cast<float>(kFrame)); });
  }
  void run() {
    std::vector<std::function<void()>> turns;
    for (const Entry& e : entries_) turns.push_back(e.turn);
    for (const auto& turn : turns) turn();  // the first step has first steps to take
    const auto taken = take_turns(options_.clock, options_.rounds, turns);
    for (std::size_t i = 0; i < entries_.size(); ++i)
      entries_[i].each = each_ns(taken[i], static_cast<double>(entries_[i].count) * entries_[i].steps);
  }
  [[nodiscard]] std::vector<std::vector<Cell>> rows() const {
    std::vector<std::vector<Cell>> list;
    for (const Entry& e : entries_) {
      const auto versus = [&](const char* name) -> Cell {
        for (const Entry& o : entries_)
          if (o.name == name && o.count == e.count) return times(median(ratios(o.each, e.each)));
        return "";
      };
      list.push_back({versus(kOriginal), versus(kBullet), e.name, fixed(static_cast<double>(e.count), 0),
                      nanoseconds(median(e.each)), quartiles(e.each),
                      fixed(1e-6 * median(e.each) * static_cast<double>(e.count), 3)});
    }
    return list;
  }

 private:
  void add(std::string name, std::size_t count, double guess_ns, std::function<void()> step) {
    const int steps = steps_for(count, guess_ns);
    entries_.push_back({std::move(name), count, steps, [step = std::move(step), steps] {
                          for (int i = 0; i < steps; ++i) step();
                        }});
  }

  Options options_;
  std::vector<Entry> entries_;
  std::vector<std::unique_ptr<World>> worlds_;
  std::vector<std::unique_ptr<PeerWorld>> peers_;
};

}  // namespace

Section free_flight_section(const Options& options) {
  const PeerPhysics physics = peer_physics();
  const double apart = distance_from_world(*original_loop(physics, peer_volley(100)));
  Field field(options);
  for (const std::size_t count : {10000, 100000, 1000000}) {
    field.add_world(count);
    field.add_peer(kOriginal, count, 10, original_loop(physics, peer_volley(count)));
    if (count > 100000) continue;  // it would take a minute to be set up
    field.add_peer(kBullet, count, 1000, bullet_world(physics, peer_volley(count), true));
    field.add_peer("Bullet 3 without detection", count, 500, bullet_world(physics, peer_volley(count), false));
  }
  field.run();
  Section s;
  s.title = "Worlds: free flight";
  s.intro =
      "Projectiles in one world, stepped one frame after the other by one thread, in single precision: gravity, and "
      "drag linear and quadratic in speed. How many times faster than the original loop and than Bullet with as many "
      "projectiles: medians of the ratios within each round.";
  s.columns = {"vs original", "vs Bullet", "world", "projectiles", "ns a projectile-step", "quartiles", "ms a step"};
  s.rows = field.rows();
  s.notes = {
      "Original loop: the first PhySim's, after Millington's Cyclone: a particle on the heap for each projectile, "
      "virtual generators of gravity and drag, a registry of pointers asked in every frame. Compiled with -O3 "
      "-march=native and fused multiply-add. After 100 steps its projectiles are within " +
          metres(apart).text + " of the World's.",
      "Bullet 3 (Debian's): spheres that share a shape, no damping, no sleeping, an empty collision filter, no "
      "contact response, one undivided step a frame. It flies in a vacuum: a user would add drag in a callback. "
      "Without "
      "detection: performDiscreteCollisionDetection() is overridden and does nothing."};
  return s;
}

}  // namespace physim::bench
