// A program of calls, played in several ways that must lead to one world: straight, on several threads, saved and
// loaded in the middle, taken back from a detour, recorded and replayed.
#pragma once

#include <memory>

#include "base/archive.hpp"
#include "soak/calls.hpp"

namespace physim::test {

/// Seeds of calls: `before`, then what a rollback takes back, then `after`.
struct CallProgram {
  std::uint64_t world = 0;  // seed of its definition
  std::vector<std::uint64_t> before, detour, after;
};

/// Calls drawn from a seed.
inline CallProgram random_program(std::uint64_t seed) {
  Random r(seed);
  CallProgram p{.world = seed, .before = {}, .detour = {}, .after = {}};
  const auto fill = [&r](std::vector<std::uint64_t>& calls, int count) {
    for (int i = 0; i < count; ++i) calls.push_back(std::uint64_t{r.bits()} << 32 | r.bits());
  };
  fill(p.before, 15 + r.below(30));
  fill(p.detour, 2 + r.below(20));
  fill(p.after, 5 + r.below(25));
  return p;
}

/// What a call left behind.
struct CallMark {
  std::string name;
  std::optional<std::uint64_t> hash;    // of the world; none: nobody looked
  std::optional<std::uint64_t> events;  // of its steps
};

inline std::uint64_t hash_of_events(const World& w) {
  Hasher hasher;
  for (const Event& e : w.events()) hasher.add(e);
  for (const JointEvent& e : w.joint_events()) hasher.add(e.kind, e.joint, e.projectile, e.time, e.speed);
  return hasher.value();
}

/// All that can be read of a world and is no part of its hash, or is read by another door.
inline std::uint64_t hash_of_reading(const World& w, const Known& known) {
  std::uint64_t sum = 0;  // rows lie in any order
  std::vector<WorldColumns> columns;
  w.columns(columns);
  const auto add = [&sum](const auto& c) {
    for (std::size_t i = 0; i < c.index.size(); ++i)
      sum += hash_of(c.index[i], double{c.position[0][i]}, double{c.position[1][i]}, double{c.position[2][i]});
  };
  for (const WorldColumns& some : columns) std::visit(add, some);
  Hasher hasher;
  hasher.add(sum);
  const WorldCounters& c = w.counters();
  hasher.add(c.steps, c.projectile_steps, c.refused, c.retired, c.dropped_time, c.dropped_events);
  for (const ProjectileId id : w.ids()) {
    const ProjectileView p = w[id];
    const Accelerations a = p.accelerations();
    hasher.add(id, p.position(), p.previous_position(), p.velocity(), p.age(), p.mass(), p.angular_velocity());
    hasher.add(p.is_asleep(), p.resultant_force(), a.total, p.label(), p.fidelity_in_use().fidelity);
  }
  for (const JointId joint : w.joints()) {
    const JointState s = w.joint_state(joint);
    hasher.add(joint, s.length, s.tension, s.is_taut, s.force, s.angle, s.way);
  }
  for (const ForceId force : known.forces) hasher.add(w.is_active(force), std::uint64_t{w.felt_by(force)});
  for (const EmitterId emitter : w.emitters()) {
    hasher.add(emitter, w.emitter_counts(emitter), w.is_playing(emitter));
    const std::size_t count = w.particles(emitter, {});
    std::vector<Vec3d> size(count), rotation(count);
    std::vector<std::uint32_t> colour(count);
    static_cast<void>(w.particles(emitter, {.size = size, .rotation = rotation, .colour = colour}));
    hasher.add(size, rotation, colour);
    const TrailCounts trails = w.trails(emitter, {});
    std::vector<Vec3d> places(trails.places);
    static_cast<void>(w.trails(emitter, {.position = places}));
    hasher.add(places);
  }
  return hasher.value();
}

/// A world of a program on its way.
class PlayedProgram {
 public:
  PlayedProgram(const CallProgram& program, const Threading& threading) : threading_(threading) {
    Odd r(program.world, 0);
    WorldDef def = r.world();
    def.step = r.in(1.0 / 120, 1.0 / 30);
    def.threading = threading;
    if (r.one_in(4)) def.max_projectiles = 300;
    if (r.one_in(4)) def.environment.wind.field = soak_wind();
    look_every_ = r.coin() ? 1 : 7;
    Result<World> made = World::create(def);
    world_ = std::make_unique<World>(made ? std::move(*made) : World());
    asks_ = !r.one_in(4);
    if (asks_) static_cast<void>(world_->set_hit_function(soak_answer));
  }

  World& world() { return *world_; }
  Known& known() { return known_; }

  /// Makes calls and marks what they leave behind. Calls are counted so that all ways look at the same moments.
  void make(const std::vector<std::uint64_t>& calls) {
    for (const std::uint64_t seed : calls) {
      SoakCall call(*world_, known_, seed);
      CallMark& mark = marks_.emplace_back();
      mark.name = call.make();
      if (call.stepped()) mark.events = hash_of_events(*world_);
      if (marks_.size() % look_every_ == 0) mark.hash = world_->hash();
    }
  }
  /// Makes calls that are taken back: nothing is marked.
  void make_in_vain(const std::vector<std::uint64_t>& calls) {
    for (const std::uint64_t seed : calls) static_cast<void>(SoakCall(*world_, known_, seed).make());
  }
  /// Reads all that there is, which must change nothing.
  void read() { static_cast<void>(hash_of_reading(*world_, known_)); }
  /// Goes on with what a save of it loads; what went wrong.
  [[nodiscard]] std::string save_and_load() {
    const auto save = world_->save();
    if (!save) return "it is not saved: " + save.error().text();
    LoadOptions functions = soak_functions(threading_);
    if (!asks_) functions.hit_function = {};
    auto loaded = World::load(*save, functions);
    if (!loaded) return "its save is refused: " + loaded.error().text();
    if (loaded->hash() != world_->hash()) return "its save loads with another hash";
    *world_ = std::move(*loaded);
    return {};
  }
  void finish() { marks_.push_back({"the end", world_->hash(), hash_of_reading(*world_, known_)}); }
  [[nodiscard]] const std::vector<CallMark>& marks() const { return marks_; }

 private:
  Threading threading_;
  std::unique_ptr<World> world_;
  Known known_;
  std::vector<CallMark> marks_;
  std::size_t look_every_ = 1;
  bool asks_ = true;  // hits that ask are answered
};

enum class PlayedHow { straight, threads, loaded, rolled_back, replayed, replayed_detour };
inline constexpr const char* kPlayedHow[] = {"straight",    "on 3 threads", "loaded",
                                             "rolled back", "replayed",     "replayed from a save, rolled back"};

/// Ends a recording and plays it again; what differs.
inline std::string replay_of(World& world, const std::vector<std::byte>& bytes) {
  const std::uint64_t hash = world.hash();
  if (Status stopped = world.stop_recording(); !stopped) return "the recording failed: " + stopped.error().text();
  auto replay = Replay::open(bytes, soak_functions({1, 1}));
  if (!replay) return "the recording is refused: " + replay.error().text();
  while (replay->next()) {
  }
  if (const auto& d = replay->report().difference)
    return "the replay differs in " + d->call + "() of step " + std::to_string(d->step) + ": " + d->what;
  return replay->world().hash() == hash ? "" : "the replay ends with another hash";
}

/// Plays a program in a way; what went wrong, and what it left behind.
inline std::pair<std::string, std::vector<CallMark>> play(const CallProgram& program, PlayedHow how) {
  const Threading threading = how == PlayedHow::threads ? Threading{3, 1} : Threading{1, 1};
  PlayedProgram played(program, threading);
  std::vector<std::byte> recording;
  if (how == PlayedHow::replayed) {
    if (Status s = played.world().record(record_into(recording)); !s) return {"no recording: " + s.error().text(), {}};
  }
  played.make(program.before);
  if (how == PlayedHow::replayed_detour) {
    if (Status s = played.world().record(record_into(recording), {.from_now = true}); !s)
      return {"no recording: " + s.error().text(), {}};
  }
  if (how == PlayedHow::loaded) {
    if (std::string wrong = played.save_and_load(); !wrong.empty()) return {wrong, {}};
  }
  if (how == PlayedHow::rolled_back || how == PlayedHow::replayed_detour) {
    const Snapshot moment = played.world().snapshot();
    const Known known = played.known();
    played.make_in_vain(program.detour);
    if (Status s = played.world().restore(moment); !s) return {"a snapshot is refused: " + s.error().text(), {}};
    played.known() = known;
  }
  if (how == PlayedHow::threads) played.read();
  played.make(program.after);
  played.finish();
  std::string wrong;
  if (played.world().is_recording()) wrong = replay_of(played.world(), recording);
  return {wrong, played.marks()};
}

/// Where two ways of playing a program differ; empty where they do not.
inline std::string difference(const std::vector<CallMark>& straight, const std::vector<CallMark>& other) {
  if (straight.size() != other.size()) return "another number of calls";
  for (std::size_t i = 0; i < straight.size(); ++i) {
    const CallMark &a = straight[i], &b = other[i];
    const std::string at = "call " + std::to_string(i) + " (" + b.name + ")";
    if (a.name != b.name) return at + ": another call than " + a.name;
    if (a.events != b.events) return at + (i + 1 < straight.size() ? ": other events" : ": it reads otherwise");
    if (a.hash != b.hash) return at + ": another hash";
  }
  return {};
}

}  // namespace physim::test
