// Emitters: births beside bulk spawns, deaths beside despawns, a frame of a million sparks, sixteen emitters at once;
// a plain loop over columns beside them.
#include <algorithm>
#include <cmath>
#include <memory>

#include "sparks.hpp"
#include "world_bench.hpp"

namespace physim::bench {
namespace {

constexpr std::size_t kBirths = 100000;  // in one frame

PeerSpray peer_spray(double per_second, double shortest, double longest) {
  const auto in_float = [](double x) { return static_cast<float>(x); };
  return {in_float(per_second), in_float(shortest), in_float(longest), 5, 10, in_float(EmitFrom().angle)};
}

/// Medians over rounds, by name, in the order in which they came, each beside another one.
class Times {
 public:
  Times(const Options& options, std::size_t count) : options_(options), count_(count) {}
  /// `base` is the name of what it stands beside.
  void time(const std::string& base, const std::string& name, const std::function<void()>& call) {
    const double each = 1e9 * seconds(options_.clock, call) / static_cast<double>(count_);
    for (Part& part : parts_)
      if (part.name == name) return part.taken.push_back(each);
    parts_.push_back({base, name, {each}});
  }
  [[nodiscard]] const std::vector<double>& of(const std::string& name) const {
    return std::ranges::find(parts_, name, &Part::name)->taken;
  }
  [[nodiscard]] std::vector<std::vector<Cell>> rows() const {
    std::vector<std::vector<Cell>> list;
    for (const auto& [base, name, taken] : parts_)
      list.push_back({times(median(ratios(taken, of(base)))), name, fixed(static_cast<double>(count_), 0),
                      nanoseconds(median(taken)), quartiles(taken)});
    return list;
  }

 private:
  struct Part {
    std::string base, name;
    std::vector<double> taken;  // [ns]
  };
  Options options_;
  std::size_t count_;
  std::vector<Part> parts_;
};

// ------------------------------------------------------------------------------------------- births and deaths
/// Everyone is born at a moment of its own within one frame, and dies so far into the next one.
class Generation {
 public:
  explicit Generation(const std::string& name, const Fidelity& fidelity) : name_(name) {
    kind_ = *world_.add_kind(world_bullet(fidelity));
    EmitterDef def = spray(kind_, static_cast<double>(kBirths) / kFrame, {kFrame});
    def.cycle = {.duration = kFrame, .looping = false, .plays = false};
    emitter_ = *world_.add_emitter(def);
    spawning_kind_ = *spawning_.add_kind(world_bullet(fidelity));
    ids_.resize(kBirths);
  }
  [[nodiscard]] std::string spawn_name() const { return name_ + ": World::spawn() of many"; }

  void run(Times& times, const std::vector<Launch>& launches) {
    const std::string base = spawn_name();
    times.time(base, base, [&] { spawning_.spawn(spawning_kind_, launches, ids_); });
    times.time(base, name_ + ": World::emit()", [&] { world_.emit(emitter_, kBirths); });
    world_.clear();
    world_.step(kFrame);
    world_.play_emitter(emitter_);
    times.time(base, name_ + ": births within a frame, and their flight to its end", [&] { world_.step(kFrame); });
    times.time(base, name_ + ": deaths within a frame, and their flight to that moment", [&] { world_.step(kFrame); });
    times.time(base, name_ + ": World::despawn() of many", [&] { spawning_.despawn(ids_); });
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
  const auto peer = plain_loop(peer_physics(), peer_spray(0, kFrame, kFrame), kBirths);
  for (int round = 0; round <= options.rounds; ++round) {
    Times first(options, kBirths);  // in which memory is taken
    Times& into = round == 0 ? first : times;
    game.run(into, launches);
    arcade.run(into, launches);
    into.time(game.spawn_name(), "plain loop: births", [&] { peer->emit(kBirths); });
    into.time(game.spawn_name(), "plain loop: a step in which all die",
              [&] { peer->step(2 * static_cast<float>(kFrame)); });
  }
  Section s;
  s.title = "Emitters: births and deaths";
  s.intro = "Nanoseconds for one of " + fixed(static_cast<double>(kBirths), 0).text +
            " projectiles by one thread, into slots that were used before, beside World::spawn() of many launches of "
            "their rung: medians of the ratios within each round.";
  s.columns = {"vs spawn", "operation", "projectiles", "ns each", "quartiles"};
  s.rows = times.rows();
  s.notes = {
      "Emitters draw place, direction, speed and lifetime of each, and every birth and death has a moment of its own "
      "in the frame. Launches of World::spawn() are there before the clock starts.",
      "Plain loop: columns of floats, sparks of equal forces, births with their place in the frame, a dead one's place "
      "is taken by the last one. -O3 -march=native. It has no ids, no events, and nothing meets anything."};
  return s;
}

// ------------------------------------------------------------------------------------------- a frame of a million
Section frame_section(const Options& options) {
  using Sparks = SteadySparks;
  constexpr auto kPeerFlow = static_cast<float>(Sparks::kFlow);
  World plain = empty_world();
  plain.spawn(*plain.add_kind(world_bullet(Fidelity::game())), volley(Sparks::kCount), {});
  Sparks sparks;
  const auto peer = plain_loop(peer_physics(), peer_spray(Sparks::kPerSecond, Sparks::kShortest, Sparks::kLongest),
                               2 * Sparks::kCount);
  for (int i = 0; i < Sparks::kFramesBefore; ++i) peer->step(kPeerFlow);
  Times times(options, Sparks::kCount);
  const std::string base = "World of as many projectiles, without births: a step";
  for (int round = 0; round < options.rounds; ++round) {
    times.time(base, base, [&] { plain.step(Sparks::kFlow); });
    times.time(base, "emitter: a step", [&] { sparks.step(); });
    times.time(base, "emitter: a step, with drag over life", [&] { sparks.step_driven(); });
    times.time(base, "emitter: places of all", [&] { sparks.read_places(); });
    times.time(base, "emitter: places, sizes and colours of all", [&] { sparks.read_looks(); });
    times.time(base, "plain loop: a step", [&] { peer->step(kPeerFlow); });
    times.time(base, "plain loop: sizes and colours of all", [&] { peer->look(); });
  }
  const auto frame = [&](const char* read, const char* step = "emitter: a step") {
    std::vector<double> sum = times.of(step);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += times.of(read)[i];
    return sum;
  };
  const double looks =
      median(ratios(frame("emitter: places, sizes and colours of all"), frame("emitter: places of all")));
  const double flights =
      median(ratios(frame("emitter: places, sizes and colours of all", "emitter: a step, with drag over life"),
                    frame("emitter: places of all")));
  Section s;
  s.title = "Emitters: a frame of a million sparks";
  s.intro = "Nanoseconds for each spark of the game preset by one thread: " +
            fixed(Sparks::kPerSecond * Sparks::kFlow, 0).text + " of " +
            fixed(static_cast<double>(Sparks::kCount), 0).text + " are born in each frame and as many die.";
  s.columns = {"vs step", "operation", "sparks", "ns each", "quartiles"};
  s.rows = times.rows();
  s.notes = {"A frame in which sizes and colours over life are read takes " + bench::times(looks).text +
             " of one in which places alone are read; with drag over life, too, " + bench::times(flights).text + "."};
  return s;
}

// ------------------------------------------------------------------------------------------- sixteen at once
Section together_section(const Options& options) {
  constexpr double kPerSecond = 120000, kShortLife = 0.25;
  const std::vector<Fidelity> rungs = sixteen_fidelities();
  World together = empty_world();
  std::vector<World> alone;
  const auto add = [](World& world, const Fidelity& rung) {
    static_cast<void>(world.add_emitter(spray(*world.add_kind(world_bullet(rung)), kPerSecond, {kShortLife})));
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
    times.time(sum, sum, [&] {
      for (World& world : alone) world.step(kFrame);
    });
    times.time(sum, "one world of sixteen emitters: a step", [&] { together.step(kFrame); });
  }
  Section s;
  s.title = "Emitters: sixteen at once";
  s.intro = "Sixteen emitters of sixteen rungs, each with " + fixed(kPerSecond * kFrame, 0).text +
            " births and deaths a frame, in one world and in sixteen.";
  s.columns = {"vs alone", "operation", "sparks", "ns each", "quartiles"};
  s.rows = times.rows();
  return s;
}

}  // namespace

std::vector<Section> emitter_sections(const Options& options) {
  return {births_section(options), frame_section(options), together_section(options)};
}

}  // namespace physim::bench
