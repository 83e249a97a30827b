// A world that is played with by random calls of its whole interface, from outside and from within.
#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "base/hash.hpp"
#include "fuzz/odd_change.hpp"
#include "fuzz/odd_scene.hpp"
#include "fuzz/verdict.hpp"
#include "world/recording_bytes.hpp"

namespace physim::test {

/// A piece of a save whose sum is right, whatever it says.
inline void sign_save(Bytes& save) {
  constexpr std::size_t kHead = 20, kSum = 8;
  if (save.size() < kHead + kSum) return;
  const std::uint64_t length = save.size() - kHead - kSum;
  Hash hash;
  hash.add(std::span(save).subspan(kHead, length));
  for (std::size_t i = 0; i < 8; ++i) {
    save[12 + i] = static_cast<std::byte>(length >> (8 * i));
    save[kHead + length + i] = static_cast<std::byte>(hash.value() >> (8 * i));
  }
}

/// Some bytes changed, cut out or put in.
inline void damage(Bytes& bytes, Odd& r) {
  for (int i = 0, n = 1 + r.below(3); i < n && !bytes.empty(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(r.below(static_cast<int>(bytes.size())));
    const auto end = std::min<std::ptrdiff_t>(at + 1 + r.below(9), static_cast<std::ptrdiff_t>(bytes.size()));
    constexpr std::uint8_t kByte[] = {0, 0xff, 0x7f, 0x80, 1, 0xf0};
    switch (r.below(6)) {
      case 0: bytes.erase(bytes.begin() + at, bytes.begin() + end); break;
      case 1: bytes.insert(bytes.begin() + at, static_cast<std::size_t>(end - at), std::byte{0}); break;
      case 2: bytes.resize(static_cast<std::size_t>(at)); break;
      case 3: std::fill(bytes.begin() + at, bytes.begin() + end, std::byte{kByte[r.below(6)]}); break;
      default: bytes[static_cast<std::size_t>(at)] ^= static_cast<std::byte>(1 << r.below(8)); break;
    }
  }
}

/// A world that somebody plays with who knows no rules.
class Session {
 public:
  explicit Session(Odd& r) : r_(r) {
    const WorldDef def = r_.world();
    Result<World> made = World::create(def);
    world_ = std::make_unique<World>(made ? std::move(*made) : World());
    if (r_.coin()) static_cast<void>(world_->set_hit_function(answer));
    if (r_.coin()) start_recording();
    if (r_.one_in(3)) rain_on_plane();
  }
  ~Session() {
    active_ = nullptr;
    if (world_ == nullptr) return;
    if (world_->is_recording()) finish_recording();
    check_all();
    world_->set_task_runner(nullptr);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void act() {
    ++tally.calls;
    active_ = this;
    if (world_ == nullptr) return;
    switch (r_.below(18)) {
      case 16:
      case 17: return scene_.act(*world_, r_);
      case 0:
      case 1:
      case 2: return spawn();
      case 3:
      case 4:
      case 5: return time();
      case 6: return surroundings();
      case 7: return force();
      case 8: return moment();
      case 9: return r_.one_in(3) ? save() : ask_world();
      case 10: return r_.one_in(4) ? several() : events();
      case 11: return r_.one_in(8) ? moves() : ask();
      default: return change();
    }
  }

 private:
  class Runner final : public TaskRunner {
   public:
    void run(std::size_t count, void (*task)(void* context, std::size_t i), void* context) override {
      meddle();
      for (std::size_t i = count; i-- > 0;) task(context, i);
    }
    [[nodiscard]] unsigned threads() const override { return 3; }
  };

  // ---------------------------------------------------------------------------------------------------- from inside
  /// From inside a step or a sink of the world that is played with. All that would change it is refused.
  static void meddle() {
    Session* const session = active_;
    if (session == nullptr || session->world_ == nullptr || session->is_inside_) return;
    session->is_inside_ = true;
    session->meddle_with(*session->world_);
    session->is_inside_ = false;
  }
  void meddle_with(World& w) {
    ++tally.inside;
    const ProjectileId id = some();
    const std::size_t size = w.size();
    switch (r_.below(14)) {
      case 0: expect(!w.step(0.01), "a step within a step"); break;
      case 1: expect(!w.spawn(r_.projectile(), r_.launch()), "a spawn within a step"); break;
      case 2: expect(w.despawn(std::array{id}) == 0, "a despawn within a step"); break;
      case 3: w.clear(); break;
      case 4: expect(w.advance(0.1) == 0, "time within a step"); break;
      case 5: expect(!w.snapshot(), "a snapshot within a step"); break;
      case 6: expect(!w.save(), "a save within a step"); break;
      case 7: expect(!w.set_detail(r_.detail()) && !w.set_observer({}), "a rule within a step"); break;
      case 8: expect(!w.add_force({ConstantForce{}, ForceTarget::everything()}), "a force within a step"); break;
      case 9: expect(!w[id].set_fidelity(r_.fidelity()) && !w[id].set_velocity({}), "a change within a step"); break;
      case 10: w.set_task_runner(nullptr), w.forget_events(), w.set_paused(true), w.single_step(); break;
      case 11: static_cast<void>(w.record([](auto) { return Status(); })), static_cast<void>(w.stop_recording()); break;
      case 12: return vanish();
      default: read(w);
    }
    expect(w.size() == size, "a change within a step");
  }
  /// Now and then the world goes, or goes elsewhere, within its own step.
  void vanish() {
    if (reading_ > 0 || !r_.one_in(40)) return;  // who reads holds it by reference
    if (r_.coin()) return world_.reset();
    auto other = std::make_unique<World>(std::move(*world_));
    world_ = std::move(other);
  }

  /// Some that ask, if somebody answers, on their way down to a plane above the ground.
  void rain_on_plane() {
    Scene scene;
    const Result<ShapeId> plane = scene.add_shape(PlaneShape{});
    if (!plane || !scene.add({.shape = *plane, .transform = {.position = {0, 5, 0}}})) return;
    static_cast<void>(world_->set_scene(scene));
    for (int i = 0; i < 4; ++i) {
      const Launch launch{.position = {0.1 * i, r_.in(6, 9), 0}, .velocity = Vec3d{r_.in(-9, 9), -60, 0}};
      note(world_->spawn(ProjectileDef{}, launch, {.collision = {.on_hit = OnHit::ask, .radius = i % 2 * 0.1}}));
    }
  }
  static void answer(const HitBatch& batch) {
    meddle();
    answer_oddly(batch);
  }

  // ------------------------------------------------------------------------------------------------------- recording
  RecordSink sink(Bytes& into) {
    const bool fails = r_.one_in(12);
    return [this, &into, fails](std::span<const std::byte> piece) {
      if (r_.one_in(3)) meddle();
      if (fails && into.size() > 3000) return Status(Error{"no room"});
      into.insert(into.end(), piece.begin(), piece.end());
      return Status();
    };
  }
  void start_recording() {
    recording_.clear();
    const bool new_one = world_->counters().steps == 0 && ids_.empty();
    static_cast<void>(
        world_->record(sink(recording_), {static_cast<std::uint32_t>(r_.below(3)), !new_one || r_.coin()}));
  }
  static LoadOptions options() {
    LoadOptions o{.threading = {1, 4}};
    o.custom_forces.assign(200, custom());
    o.hit_function = answer;
    return o;
  }
  void finish_recording() {
    const std::uint64_t hash = world_->hash();
    if (!world_->stop_recording()) return;
    active_ = nullptr;
    ++tally.replays;
    auto replay = Replay::open(recording_, options());
    if (!replay) return fault(("a recording is refused: " + replay.error().text()).c_str());
    while (replay->next()) {
    }
    if (const auto& d = replay->report().difference)
      fault(("a replay differs in " + d->call + "() of step " + std::to_string(d->step) + ": " + d->what).c_str());
    expect(replay->report().complete && replay->world().hash() == hash, "a replay ends elsewhere");
    Bytes bytes = recording_;
    damage(bytes, r_);
    if (r_.coin()) sign(bytes);
    if (auto damaged = Replay::open(bytes, options())) {
      for (int i = 0; i < 200 && damaged->next_frame();) ++i;
      read(damaged->world());
    }
  }

  // ----------------------------------------------------------------------------------------------------------- saves
  void save() {
    const auto bytes = world_->save();
    if (!bytes) return fault("a world is not saved");
    ++tally.saves;
    Session* const before = std::exchange(active_, nullptr);
    auto loaded = World::load(*bytes, options());
    if (!loaded) fault(("a save is refused: " + loaded.error().text()).c_str());
    if (loaded) expect(loaded->hash() == world_->hash(), "a save loads as another world");
    Bytes bad = *bytes;
    damage(bad, r_);
    if (!r_.one_in(4)) sign_save(bad);
    auto damaged = World::load(bad, options());
    if (damaged) {
      ++tally.damaged_loads;
      for (int i = 0; i < 3; ++i) static_cast<void>(damaged->step(0.02));
      read(*damaged);
      static_cast<void>(damaged->save());
    }
    active_ = before;
    if (loaded && r_.one_in(3)) go_on_beside(*loaded);
  }
  void go_on_beside(World& other) {
    const double dt = r_.in(0.001, 0.05);
    Session* const before = std::exchange(active_, nullptr);
    world_->set_task_runner(nullptr);
    const bool stepped = world_->step(dt).ok();
    expect(other.step(dt).ok() == stepped, "a loaded world steps otherwise");
    expect(other.hash() == world_->hash(), "a loaded world goes on otherwise");
    active_ = before;
  }

  // ---------------------------------------------------------------------------------------------------------- moments
  void moment() {
    if (snapshots_.empty() || r_.coin()) {
      snapshots_.emplace_back(world_->snapshot(), world_->hash());
      return;
    }
    if (r_.one_in(4)) {
      World other;
      expect(!world_->restore(r_.coin() ? other.snapshot() : Snapshot()), "a snapshot of another world is taken");
      return;
    }
    const auto& [snapshot, hash] = snapshots_[static_cast<std::size_t>(r_.below(static_cast<int>(snapshots_.size())))];
    if (const Status status = world_->restore(snapshot); !status)
      return fault(("a snapshot is refused: " + status.error().text()).c_str());
    expect(world_->hash() == hash, "a restored world differs");
  }

  // ----------------------------------------------------------------------------------------------------- life and time
  ProjectileId some() {
    if (r_.one_in(12)) return {r_.count(300), r_.count(3)};
    return ids_.empty() ? ProjectileId{} : ids_[static_cast<std::size_t>(r_.below(static_cast<int>(ids_.size())))];
  }
  KindId kind() {
    if (kinds_.empty() || r_.one_in(15)) return {r_.count(50)};
    return kinds_[static_cast<std::size_t>(r_.below(static_cast<int>(kinds_.size())))];
  }
  std::vector<ProjectileId> some_of_them() {
    std::vector<ProjectileId> list(static_cast<std::size_t>(r_.below(6)));
    for (ProjectileId& id : list) id = some();
    return list;
  }
  void note(const Result<ProjectileId>& id) {
    if (!id) return;
    ++tally.spawned;
    ids_.push_back(*id);
  }
  void spawn() {
    const double delay = r_.one_in(5) ? r_.number(0, 0.3) : 0;
    switch (r_.below(6)) {
      case 0:
        if (const auto made = world_->add_kind(r_.projectile(), r_.body())) kinds_.push_back(*made);
        return;
      case 1: {
        std::vector<Launch> launches(static_cast<std::size_t>(r_.below(8)));
        for (Launch& l : launches) l = r_.launch();
        std::vector<ProjectileId> ids(static_cast<std::size_t>(r_.below(10)));
        constexpr std::size_t kRoom[] = {0, 1, 20, std::size_t{1} << 40, ~std::size_t{0}};
        static_cast<void>(world_->reserve(kind(), kRoom[r_.below(5)]));
        world_->spawn(kind(), launches, ids);
        ids_.insert(ids_.end(), ids.begin(), ids.end());
        return;
      }
      case 2: return note(world_->spawn(r_.projectile(), r_.launch(), r_.body(), delay));
      default: return note(world_->spawn(kind(), r_.launch(), delay));
    }
  }
  void time() {
    if (r_.one_in(10)) world_->set_task_runner(r_.coin() ? &runner_ : nullptr);
    switch (r_.below(8)) {
      case 0: return world_->set_paused(r_.one_in(3));
      case 1: return void(world_->set_time_scale(r_.number(0.2, 3)));
      case 2: return world_->single_step();
      case 3:
      case 4: return void(world_->advance(r_.number(0, 0.1)));
      default: return void(tally.steps += world_->step(r_.number(0.001, 0.1)).ok());
    }
  }
  void surroundings() {
    switch (r_.below(4)) {
      case 0: return void(world_->add_environment(r_.environment()));
      case 1: return void(world_->set_environment(r_.count(2), r_.environment()));
      case 2: return void(world_->set_detail(r_.detail()));
      default: return void(world_->set_observer(r_.vector3(100)));
    }
  }

  // ----------------------------------------------------------------------------------------------------------- forces
  /// Of what it sees alone, so that a replay feels the same; it meddles, throws, or hands in what is no number.
  static CustomForce custom() {
    return {[](const ForceBatch& b) {
      meddle();
      const auto tenths = static_cast<int>(std::fmod(b.time * 10, 16));
      for (std::size_t i = 0; i < b.force.size(); ++i) {
        b.force[i] += b.velocity[i] * (-0.1 * b.mass[i]);
        if (tenths == 5 && b.id[i].index % 8 == 3) b.force[i].x = std::numeric_limits<double>::quiet_NaN();
      }
      if (tenths == 3) throw std::runtime_error("a force that throws");
    }};
  }
  ForceLaw law() {
    return r_.law([this] { return some(); }, custom());
  }
  void force() {
    const ForceId known = forces_.empty() || r_.one_in(9)
                              ? ForceId{r_.count(20), r_.count(2)}
                              : forces_[static_cast<std::size_t>(r_.below(static_cast<int>(forces_.size())))];
    Result<ForceId> added = Error{};
    switch (r_.below(7)) {
      case 0: added = (*world_)[some()].add_force(law()); break;
      case 1: added = (*world_)[some()].add_force(law(), r_.number(0, 1)); break;
      case 2: return void(world_->remove_force(known));
      case 3: return void((*world_)[some()].remove_force(known));
      case 4: return void(world_->is_active(known) ? world_->felt_by(known) : world_->force_count());
      default:
        added = world_->add_force(
            {law(), {some_of_them(), r_.coin() ? kind() : KindId{}, r_.count(3)}, r_.number(0, 0.2), r_.number(0, 1)});
    }
    if (added) forces_.push_back(*added);
  }

  // ---------------------------------------------------------------------------------------------------------- changes
  void several() {
    const auto list = some_of_them();
    std::vector<BodyState> states(static_cast<std::size_t>(r_.below(8)));
    std::vector<Vec3d> places(static_cast<std::size_t>(r_.below(8)));
    world_->states(list, states);
    world_->render_positions(list, places);
    if (r_.one_in(30)) return world_->clear();
    if (r_.coin()) return void(world_->despawn(list));
    world_->set_fidelity(list, r_.fidelity());
  }
  void change() { change_oddly((*world_)[some()], r_); }
  /// What is held of events stays as it is, whatever is changed.
  void events() {
    const std::span<const Event> held = world_->events();
    const std::vector<Event> copy(held.begin(), held.end());
    for (int i = 0; i < 4; ++i) change(), spawn();
    for (const Event& e : held)
      if (r_.one_in(4)) static_cast<void>((*world_)[e.id].despawn());
    const auto same = [](const Event& a, const Event& b) {
      return a.kind == b.kind && a.id == b.id && a.time == b.time;
    };
    expect(std::equal(held.begin(), held.end(), copy.begin(), copy.end(), same), "events that are held change");
    if (r_.one_in(5)) world_->forget_events();
  }
  /// Moved away and back: handles of projectiles stay what they are, and what is left behind is an empty world.
  void moves() {
    const ProjectileId id = some();
    Projectile handle = (*world_)[id];
    const std::uint64_t hash = world_->hash();
    World other = std::move(*world_);
    expect(world_->size() == 0, "a world that was moved away is not empty");
    static_cast<void>(world_->spawn(r_.projectile(), r_.launch()));
    static_cast<void>(world_->step(0.01));
    read(*world_);
    expect(handle.is_alive() == other[id].is_alive(), "a handle is of another world");
    *world_ = std::move(other);
    expect(world_->hash() == hash, "a world that was moved is another");
    World left = std::move(other);
    read(left);
  }

  // ---------------------------------------------------------------------------------------------------------- reading
  class Reading {
   public:
    Reading() { ++reading_; }
    ~Reading() { --reading_; }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
  };
  void ask() { ask_one(*world_, some()); }
  static void ask_one(const World& world, ProjectileId id) {
    const Reading reading;
    const ProjectileView p = world[id];
    const bool alive = p.is_alive();
    expect(is_finite(p.position()) && is_finite(p.velocity()), "a projectile has bad numbers");
    expect(alive == (p.definition() != nullptr), "a projectile without a definition");
    static_cast<void>(name(p.status())), static_cast<void>(p.is_asleep()), static_cast<void>(p.is_kinematic());
    static_cast<void>(p.previous_position()), static_cast<void>(p.render_position()),
        static_cast<void>(p.orientation());
    static_cast<void>(p.angular_velocity()), static_cast<void>(p.age()), static_cast<void>(p.mach());
    static_cast<void>(p.mass()), static_cast<void>(p.inverse_mass()), static_cast<void>(p.resultant_force());
    static_cast<void>(p.accelerations()), static_cast<void>(p.kind()), static_cast<void>(p.fidelity_in_use());
    static_cast<void>(p.body()), static_cast<void>(p.user_data()), static_cast<void>(p.layers());
    static_cast<void>(p.colour()), static_cast<void>(p.label());
  }
  void ask_world() { read(*world_); }
  static void read(const World& world) {
    const Reading reading;
    std::vector<Segment> segments;
    world.segments(segments);
    std::vector<ProjectileId> ids;
    world.ids(ids);
    expect(ids.size() == world.size(), "ids are not as many as the world has");
    for (const ProjectileId id : ids) ask_one(world, id);
    std::size_t counted = 0;
    for (const CohortInfo& cohort : world.cohorts()) counted += cohort.count;
    expect(counted == world.size(), "cohorts are not as many as the world has");
    for (const Event& e : world.events()) {
      expect(std::isfinite(e.time), "an event at no time");
      expect(std::isfinite(length_squared(e.normal)) && std::isfinite(e.energy), "a hit of no numbers");
    }
    static_cast<void>(world.memory()), static_cast<void>(world.fraction()), static_cast<void>(world.def());
    static_cast<void>(world.time_scale()), static_cast<void>(world.is_paused()), static_cast<void>(world.counters());
  }
  void check_all() {
    read(*world_);
    expect(std::isfinite(world_->time()), "a world at no time");
    expect(world_->hash() == world_->hash(), "a hash that changes");
  }

  static inline Session* active_ = nullptr;
  static inline int reading_ = 0;
  Odd& r_;
  Runner runner_;
  Bytes recording_;
  std::unique_ptr<World> world_;
  std::vector<ProjectileId> ids_;
  std::vector<KindId> kinds_;
  std::vector<ForceId> forces_;
  OddScene scene_;
  std::vector<std::pair<Snapshot, std::uint64_t>> snapshots_;
  bool is_inside_ = false;
};

}  // namespace physim::test
