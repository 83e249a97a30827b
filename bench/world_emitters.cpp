// Emitters: births beside bulk spawns, deaths beside despawns, a frame of a million sparks, sixteen emitters at once;
// a plain loop over columns beside them.
#include <algorithm>
#include <cmath>
#include <memory>

#include "world_bench.hpp"

namespace physim::bench {
namespace {

constexpr std::size_t kBirths = 100000;  // in one frame
constexpr std::size_t kSparks = 1000000;
constexpr double kFlow = 1.0 / 60;  // frame of a steady flow [s]
constexpr double kLife = 2;         // of a spark there [s]

/// Upwards out of a cone, 5 to 10 m/s.
EmitterDef spray(KindId kind, double per_second, double lifetime) {
  EmitterDef def;
  def.kind = kind;
  def.seed = 7;
  def.rotation = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
  def.per_second = {per_second};
  def.maximum = 4 * kSparks;
  def.start.lifetime = {lifetime};
  def.start.speed = {5, 10};
  def.from = {.shape = EmitShape::cone, .radius = 0.1};
  return def;
}
PeerSpray peer_spray(double per_second, double lifetime) {
  return {static_cast<float>(per_second), static_cast<float>(lifetime), 5, 10, static_cast<float>(EmitFrom().angle)};
}
/// Smaller and darker as they grow older.
void put_looks(EmitterDef& def) {
  def.start.size = {0.5, 1.5};
  def.life.size = {1, {}, {{0, 1}, {1, 0}}};
  def.life.colour.gradient = {{0, 0xfff0a0ff}, {1, 0xff280000}};
}
World empty_world() { return std::move(World::create(free_flight()).value()); }

/// Medians over rounds, by name, in the order in which they came.
class Times {
 public:
  Times(const Options& options, std::size_t count) : options_(options), count_(count) {}
  void time(const std::string& name, const std::function<void()>& call) {
    add(name, 1e9 * seconds(options_.clock, call) / static_cast<double>(count_));
  }
  void add(const std::string& name, double each) {
    for (auto& [known, taken] : parts_)
      if (known == name) return taken.push_back(each);
    parts_.push_back({name, {each}});
  }
  [[nodiscard]] const std::vector<double>& of(const std::string& name) const {
    for (const auto& [known, taken] : parts_)
      if (known == name) return taken;
    return parts_.front().second;
  }
  /// A row for each, beside the one named `base`.
  [[nodiscard]] std::vector<std::vector<Cell>> rows(const std::string& base) const {
    std::vector<std::vector<Cell>> list;
    for (const auto& [name, taken] : parts_)
      list.push_back({times(median(ratios(taken, of(base)))), name, fixed(static_cast<double>(count_), 0),
                      nanoseconds(median(taken)), quartiles(taken)});
    return list;
  }

 private:
  Options options_;
  std::size_t count_;
  std::vector<std::pair<std::string, std::vector<double>>> parts_;
};

// ------------------------------------------------------------------------------------------- births and deaths
/// Everyone is born at a moment of its own within one frame, and dies so far into the next one.
class Generation {
 public:
  explicit Generation(const std::string& name, const Fidelity& fidelity) : name_(name) {
    kind_ = *world_.add_kind(world_bullet(fidelity));
    EmitterDef def = spray(kind_, static_cast<double>(kBirths) / kFrame, kFrame);
    def.cycle = {.duration = kFrame, .looping = false, .plays = false};
    emitter_ = *world_.add_emitter(def);
    spawning_kind_ = *spawning_.add_kind(world_bullet(fidelity));
    ids_.resize(kBirths);
  }
  [[nodiscard]] std::string spawn_name() const { return name_ + ": World::spawn() of many"; }

  void run(Times& times, const std::vector<Launch>& launches) {
    times.time(spawn_name(), [&] { spawning_.spawn(spawning_kind_, launches, ids_); });
    times.time(name_ + ": World::emit()", [&] { world_.emit(emitter_, kBirths); });
    world_.clear();
    world_.step(kFrame);
    world_.play_emitter(emitter_);
    times.time(name_ + ": births within a frame, and their flight to its end", [&] { world_.step(kFrame); });
    times.time(name_ + ": deaths within a frame, and their flight to that moment", [&] { world_.step(kFrame); });
    times.time(name_ + ": World::despawn() of many", [&] { spawning_.despawn(ids_); });
    world_.clear();
    spawning_.step(kFrame);
    world_.step(kFrame);
  }

 private:
  std::string name_;
  World world_ = empty_world(), spawning_ = empty_world();
  KindId kind_, spawning_kind_;
  EmitterId emitter_;
  std::vector<ProjectileId> ids_;
};

Section births_section(const Options& options) {
  Times times(options, kBirths);
  const std::vector<Launch> launches = volley(kBirths);
  Generation game("game", Fidelity::game()), arcade("arcade", Fidelity::arcade());
  const auto peer = plain_loop(peer_physics(), peer_spray(0, kFrame), kBirths);
  for (int round = 0; round <= options.rounds; ++round) {
    Times first(options, kBirths);  // in which memory is taken
    Times& into = round == 0 ? first : times;
    game.run(into, launches);
    arcade.run(into, launches);
    into.time("plain loop: births", [&] { peer->emit(kBirths); });
    into.time("plain loop: a step in which all die", [&] { peer->step(2 * static_cast<float>(kFrame)); });
  }
  Section s;
  s.title = "Emitters: births and deaths";
  s.intro =
      "Nanoseconds for one of " + fixed(static_cast<double>(kBirths), 0).text +
      " projectiles by one thread, into slots that were used before, beside World::spawn() of many launches of the "
      "game preset: medians of the ratios within each round.";
  s.columns = {"vs spawn", "operation", "projectiles", "ns each", "quartiles"};
  s.rows = times.rows(game.spawn_name());
  s.notes = {
      "Emitters draw place, direction, speed and lifetime of each, and every birth and death has a moment of its own "
      "in the frame. Launches of World::spawn() are there before the clock starts.",
      "Plain loop: columns of floats, sparks of equal forces, births with their place in the frame, a dead one's place "
      "is taken by the last one. -O3 -march=native. It has no ids, no events, and nothing meets anything."};
  return s;
}

// ------------------------------------------------------------------------------------------- a frame of a million
/// What a renderer reads.
struct Columns {
  std::vector<Vec3d> position = std::vector<Vec3d>(kSparks + kSparks / 16);
  std::vector<Vec3d> size = position;
  std::vector<std::uint32_t> colour = std::vector<std::uint32_t>(position.size());
};

Section frame_section(const Options& options) {
  const double per_second = static_cast<double>(kSparks) / kLife;
  World plain = empty_world(), world = empty_world();
  const KindId kind = *plain.add_kind(world_bullet(Fidelity::game()));
  plain.spawn(kind, volley(kSparks), {});
  EmitterDef def = spray(*world.add_kind(world_bullet(Fidelity::game())), per_second, kLife);
  put_looks(def);
  const EmitterId emitter = *world.add_emitter(def);
  const auto peer = plain_loop(peer_physics(), peer_spray(per_second, kLife), 2 * kSparks);
  for (int i = 0; i < static_cast<int>(1.1 * kLife / kFlow); ++i) {
    world.step(kFlow);
    peer->step(static_cast<float>(kFlow));
  }
  Columns columns;
  Times times(options, kSparks);
  const std::string base = "World of as many projectiles, without births: a step";
  for (int round = 0; round < options.rounds; ++round) {
    times.time(base, [&] { plain.step(kFlow); });
    times.time("emitter: a step", [&] { world.step(kFlow); });
    times.time("emitter: places of all", [&] { world.particles(emitter, {.position = columns.position}); });
    times.time("emitter: places, sizes and colours of all", [&] {
      world.particles(emitter, {.position = columns.position, .size = columns.size, .colour = columns.colour});
    });
    times.time("plain loop: a step", [&] { peer->step(static_cast<float>(kFlow)); });
    times.time("plain loop: sizes and colours of all", [&] { peer->look(); });
  }
  const auto frame = [&](const char* read) {
    std::vector<double> sum = times.of("emitter: a step");
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += times.of(read)[i];
    return sum;
  };
  const double looks =
      median(ratios(frame("emitter: places, sizes and colours of all"), frame("emitter: places of all")));
  Section s;
  s.title = "Emitters: a frame of a million sparks";
  s.intro = "Nanoseconds for each spark of the game preset by one thread: " + fixed(per_second * kFlow, 0).text +
            " of " + fixed(static_cast<double>(kSparks), 0).text + " are born in each frame and as many die.";
  s.columns = {"vs step", "operation", "sparks", "ns each", "quartiles"};
  s.rows = times.rows(base);
  s.notes = {"A frame in which sizes and colours over life are read takes " + bench::times(looks).text +
             " of one in which places alone are read."};
  return s;
}

// ------------------------------------------------------------------------------------------- sixteen at once
Section together_section(const Options& options) {
  constexpr double kPerSecond = 120000, kShortLife = 0.25;
  const std::vector<Fidelity> rungs = sixteen_fidelities();
  World together = empty_world();
  std::vector<World> alone;
  const auto add = [](World& world, const Fidelity& rung) {
    static_cast<void>(world.add_emitter(spray(*world.add_kind(world_bullet(rung)), kPerSecond, kShortLife)));
  };
  for (const Fidelity& rung : rungs) {
    alone.push_back(empty_world());
    add(alone.back(), rung);
    add(together, rung);
  }
  for (int i = 0; i < static_cast<int>(1.2 * kShortLife / kFrame); ++i) {
    for (World& world : alone) world.step(kFrame);
    together.step(kFrame);
  }
  Times times(options, together.size());
  const std::string sum = "sixteen worlds of one emitter: a step each";
  for (int round = 0; round < options.rounds; ++round) {
    times.time(sum, [&] {
      for (World& world : alone) world.step(kFrame);
    });
    times.time("one world of sixteen emitters: a step", [&] { together.step(kFrame); });
  }
  Section s;
  s.title = "Emitters: sixteen at once";
  s.intro = "Sixteen emitters of sixteen rungs, each with " + fixed(kPerSecond * kFrame, 0).text +
            " births and deaths a frame, in one world and in sixteen.";
  s.columns = {"vs alone", "operation", "sparks", "ns each", "quartiles"};
  s.rows = times.rows(sum);
  return s;
}

}  // namespace

std::vector<Section> emitter_sections(const Options& options) {
  return {births_section(options), frame_section(options), together_section(options)};
}

}  // namespace physim::bench
