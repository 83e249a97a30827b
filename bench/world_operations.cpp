// Spawning, despawning, moving between rungs, reading, snapshots: what each costs for one projectile.
#include <algorithm>
#include <random>

#include "world_bench.hpp"

namespace physim::bench {
namespace {

/// One world through its life, again and again; each part is timed by itself.
class Life {
 public:
  Life(const Options& options, std::size_t count) : options_(options), count_(count), launches_(volley(count)) {
    game_ = Fidelity::game();
    other_ = game_;
    other_.drag = DragModel::damping;
  }

  void run() {
    World world = std::move(World::create(free_flight()).value());
    const KindId kind = *world.add_kind(world_bullet(game_));
    world.reserve(kind, count_);
    ids_.resize(count_);
    time("spawn, one by one", [&] {
      for (std::size_t i = 0; i < count_; ++i) ids_[i] = *world.spawn(kind, launches_[i]);
    });
    bytes_ = static_cast<double>(world.memory()) / static_cast<double>(count_);
    world.step(kFrame);
    std::vector<ProjectileId> shuffled = ids_;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
    read(world, "read by id, in order", ids_);
    read(world, "read by id, at random", shuffled);
    time("snapshot", [&] { snapshot_ = world.snapshot(); });
    time("restore", [&] { world.restore(snapshot_); });
    snapshot_ = {};
    std::vector<BodyState> states(count_);
    time("read many states, in order", [&] { world.states(ids_, states); });
    world.set_fidelity(ids_, other_);  // its columns grow
    world.set_fidelity(ids_, game_);
    world.step(kFrame);
    time("move many to another rung, in order", [&] { world.set_fidelity(ids_, other_); });
    world.step(kFrame);
    time("move many to another rung, at random", [&] { world.set_fidelity(shuffled, game_); });
    world.step(kFrame);
    time("move to another rung, one by one, in order", [&] {
      for (const ProjectileId id : ids_) world[id].set_fidelity(other_);
    });
    world.step(kFrame);
    time("despawn, at random", [&] { world.despawn(shuffled); });
    world.step(kFrame);
    time("spawn many, into used slots", [&] { world.spawn(kind, launches_, ids_); });
    world.step(kFrame);
    time("despawn, in order", [&] { world.despawn(ids_); });
  }

  void add_rows(Section& s) const {
    for (const auto& [name, taken] : parts_)
      s.rows.push_back({name, fixed(static_cast<double>(count_), 0), nanoseconds(median(taken)), quartiles(taken)});
    s.rows.push_back({"memory, game preset, with the event of its spawn", fixed(static_cast<double>(count_), 0),
                      Cell(fixed(bytes_, 1).text + " bytes", bytes_), ""});
  }

 private:
  void time(const std::string& name, const std::function<void()>& call) {
    const double each = 1e9 * seconds(options_.clock, call) / static_cast<double>(count_);
    for (auto& [known, taken] : parts_)
      if (known == name) return taken.push_back(each);
    parts_.push_back({name, {each}});
  }
  void read(const World& world, const std::string& name, const std::vector<ProjectileId>& ids) {
    time(name, [&] {
      double sum = 0;
      for (const ProjectileId id : ids) sum += world[id].position().x;
      sum_ = sum;
    });
  }

  Options options_;
  std::size_t count_;
  std::vector<Launch> launches_;
  std::vector<ProjectileId> ids_;
  Snapshot snapshot_;
  Fidelity game_;
  Fidelity other_;
  std::vector<std::pair<std::string, std::vector<double>>> parts_;
  double bytes_ = 0;
  volatile double sum_ = 0;  // somebody must want it
};

}  // namespace

Section operations_section(const Options& options) {
  Section s;
  s.title = "Worlds: operations";
  s.intro =
      "Nanoseconds for one projectile of the game preset, through ids: medians and quartiles over whole lives of a "
      "world that was reserved for as many.";
  s.columns = {"operation", "projectiles", "ns each", "quartiles"};
  for (const std::size_t count : {10000, 100000}) {
    Life life(options, count);
    for (int round = 0; round < options.rounds; ++round) life.run();
    life.add_rows(s);
  }
  s.notes = {
      "Each spawn, despawn and move also writes its event. Memory: World::memory() right after spawning; an event "
      "takes " +
      std::to_string(sizeof(Event)) + " bytes of it."};
  return s;
}

std::vector<Section> world_sections(const Options& options) {
  std::vector<Section> sections{free_flight_section(options), rungs_section(options), closed_forms_section(options),
                                operations_section(options)};
  for (Section& section : emitter_sections(options)) sections.push_back(std::move(section));
  return sections;
}

}  // namespace physim::bench
