// Programs of calls of the C interface: each byte chooses a call, those that follow its arguments.
#include <array>
#include <cmath>
#include <limits>

#include "capi/of_all.hpp"
#include "fuzz/covered/target.hpp"
#include "physim/physim.h"

namespace physim::test {
namespace {

constexpr double kNumbers[] = {0,
                               1,
                               -1,
                               0.01,
                               0.5,
                               1e-9,
                               1e9,
                               1e300,
                               -1e300,
                               1e-320,
                               60,
                               1.0 / 60,
                               3.141,
                               1e15,
                               -0.0,
                               100,
                               0.25,
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};
constexpr const char* kValues[] = {"0",
                                   "1",
                                   "-1",
                                   "\"1 kg\"",
                                   "nan",
                                   "\"5 m/s\"",
                                   "[0, 1, 0]",
                                   "true",
                                   "\"g7\"",
                                   "\"game\"",
                                   "1e308",
                                   "\"none\"",
                                   "inf",
                                   "[[1, 2]]",
                                   "{}",
                                   "1e-9",
                                   "\"simulation\"",
                                   "\"rk4\"",
                                   "\"box\"",
                                   "\"3 deg +- 1 deg\""};
constexpr std::size_t kMostSteps = 40, kMostRows = 300;

/// A program and what it has made. Everything is freed at its end.
class Program {
 public:
  explicit Program(std::span<const std::byte> bytes) : bytes_(bytes) {
    take(physim_def_create(kOfAll, "fuzz.toml", &defs_[0]), defs_[0]);
    take(physim_world_create(defs_[0], PHYSIM_FIRE_NOTHING, &worlds_[0]), worlds_[0]);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    for (const void* handle : made_) physim_free(handle);
  }

  void run() {
    for (int calls = 0; !bytes_.empty() && calls < 200; ++calls) {
      const unsigned which = byte() % 48;
      told(which < 16 ? of_settings(which) : which < 32 ? of_worlds(which) : of_scenes(which));
    }
  }

 private:
  unsigned byte() {
    if (bytes_.empty()) return 0;
    const auto first = std::to_integer<unsigned>(bytes_[0]);
    bytes_ = bytes_.subspan(1);
    return first;
  }
  /// One of the odd numbers, or a small one.
  double number() {
    const unsigned b = byte();
    return b < std::size(kNumbers) ? kNumbers[b] : (double(b) - 128) / 8;
  }
  const double* three() {
    static std::array<double, 3> room;
    for (double& x : room) x = number();
    return byte() % 32 == 0 ? nullptr : room.data();
  }
  const char* shot() {
    constexpr const char* kShots[] = {nullptr, "1", "ball", "2", "none", "", "99999999999999999999"};
    return kShots[byte() % std::size(kShots)];
  }
  const char* value() { return kValues[byte() % std::size(kValues)]; }
  const char* path() {
    physim_setting setting{};
    setting.size = sizeof setting;
    const std::size_t at = (byte() * 256U + byte()) % physim_setting_count();
    claim(physim_setting_at(at, &setting) == PHYSIM_OK, "a setting has a row");
    path_ = setting.path;
    if (byte() % 4 == 0) path_.insert(path_.find('.') + 1, std::to_string(byte() % 4) + ".");
    return path_.c_str();
  }
  physim_id id() { return {byte() % 8, 1 + byte() % 3}; }
  const physim_id* ids() {
    for (physim_id& each : ids_) each = id();
    return byte() % 16 == 0 ? nullptr : ids_.data();
  }
  template <class T>
  T& sized(T& of) {
    of = {};
    of.size = byte() % 32 == 0 ? byte() : sizeof(T);
    return of;
  }
  physim_transform* place() {
    physim_transform& to = sized(transform_);
    for (double& x : to.position) x = number();
    for (double& x : to.rotation) x = number();
    to.scale = number();
    return &to;
  }

  /// One of the handles of a kind; now and then one of any kind.
  template <class T, std::size_t n>
  T* one(const std::array<T*, n>& of) {
    const unsigned b = byte();
    if (b % 64 == 63 && !made_.empty()) return static_cast<T*>(const_cast<void*>(made_[byte() % made_.size()]));
    return of[b % n];
  }
  template <class T, std::size_t n>
  T** into(std::array<T*, n>& of) {
    return &of[byte() % n];
  }
  physim_result take(physim_result code, const void* handle) {
    if (code == PHYSIM_OK) made_.push_back(handle);
    return code;
  }
  static void told(physim_result code) {
    claim(code >= PHYSIM_OK && code < PHYSIM_FAILED, "a call does what it says, or refuses");
    claim(code == PHYSIM_OK || *physim_last_error() != '\0', "an error has a text");
  }
  /// What the handle in `*to` becomes, if the call succeeds.
  template <class T, class F>
  physim_result make(T** to, const F& call) {
    T* made = nullptr;
    const physim_result code = take(call(&made), made);
    if (code == PHYSIM_OK) *to = made;
    return code;
  }

  physim_result of_settings(unsigned which) {
    physim_def* def = one(defs_);
    std::size_t count = 0;
    double x = 0;
    switch (which) {
      case 0:
      case 1:
      case 2: return physim_set(def, path(), value());
      case 3: return physim_set_number(def, path(), number());
      case 4: return physim_get(def, path(), text_.data(), byte() % text_.size(), &count);
      case 5: return physim_get_number(def, path(), &x);
      case 6: return physim_text(def, text_.data(), text_.size(), &count);
      case 7: return physim_check(def);
      case 8: return make(into(defs_), [&](physim_def** to) { return physim_def_copy(def, to); });
      case 9: {
        physim_launch& launch = sized(launch_);
        launch.given = byte();
        launch.speed = number(), launch.elevation = number(), launch.azimuth = number();
        return make(into(flights_),
                    [&](physim_flight** to) { return physim_fly(short_flights(def), shot(), &launch, to); });
      }
      case 10: return physim_flight_at(one(flights_), physim_moment(byte() % 6), number(), &sized(sample_));
      case 11: {
        std::array<physim_event, 4> events;
        return physim_flight_events(one(flights_), byte(), events.data(), byte() % 4 ? sizeof events[0] : byte(), 4,
                                    &count);
      }
      case 12: return batch(def);
      case 13: return physim_free(forget());
      case 14: return physim_count(def, path(), &count);
      default: return make(into(bytes_made_), [&](physim_bytes** to) { return physim_save(one(worlds_), to); });
    }
  }
  /// The same def, with flights that end soon.
  physim_def* short_flights(physim_def* def) {
    physim_set(def, "shot.until.time", "1");
    physim_set(def, "shot.tolerance.max_steps", "2000");
    return def;
  }
  physim_result batch(physim_def* def) {
    std::array<double, 5> speed{}, x{};
    for (double& each : speed) each = number();
    physim_launches& launches = sized(launches_);
    launches.speed = speed.data();
    physim_ends& ends = sized(ends_);
    ends.x = x.data();
    return physim_batch(short_flights(def), shot(), byte() % 6, &launches, nullptr, &ends, nullptr, nullptr);
  }
  const void* forget() {
    if (made_.empty()) return nullptr;
    const std::size_t at = byte() % made_.size();
    const void* handle = made_[at];
    made_.erase(made_.begin() + std::ptrdiff_t(at));  // a copy of it may stay in the lists, and be tried again
    return handle;
  }

  physim_result of_worlds(unsigned which) {
    physim_world* world = one(worlds_);
    std::size_t count = 0;
    std::uint32_t number_of = 0;
    switch (which) {
      case 16:
        return make(into(worlds_), [&](physim_world** to) {
          return physim_world_create(one(defs_), physim_firing(byte() % 8 == 0), to);
        });
      case 17: return physim_world_add_kind(world, one(defs_), shot(), byte() % 3, byte() % 3, &number_of);
      case 18:
      case 19:
        return physim_world_spawn(world, byte() % 4, byte() % 9, nullptr, byte() % 2 ? ids_.data() : nullptr, &count);
      case 20:
      case 21: return step(world);
      case 22: return physim_world_despawn(world, ids(), byte() % 4, &count);
      case 23: return states(world);
      case 24: return physim_world_push(world, ids(), byte() % 2, three(), &count);
      case 25: return physim_world_set(world, id(), path() + (byte() % 2 ? 5 : 0), value());
      case 26:
        return make(into(flights_),
                    [&](physim_flight** to) { return physim_world_predict(world, id(), std::min(number(), 2.0), to); });
      case 27: return make(into(snapshots_), [&](physim_snapshot** to) { return physim_world_snapshot(world, to); });
      case 28: return physim_world_restore(world, one(snapshots_));
      case 29: return physim_world_record(world, byte() % 3);
      case 30:
        return make(into(bytes_made_), [&](physim_bytes** to) { return physim_world_stop_recording(world, to); });
      default: return load();
    }
  }
  physim_result step(physim_world* world) {
    physim_world_info info{};
    info.size = sizeof info;
    if (physim_world_read(world, &info) == PHYSIM_OK && (info.projectiles > kMostRows || ++steps_ > kMostSteps))
      return PHYSIM_OK;
    return physim_world_step(world, byte() % 3, number());
  }
  physim_result states(physim_world* world) {
    std::array<double, 24> position{}, orientation{};
    std::array<physim_id, 8> which{};
    physim_states& columns = sized(states_);
    columns.position = position.data();
    if (byte() % 2) return physim_world_put(world, ids(), byte() % 4, &columns, nullptr);
    columns.id = which.data();
    columns.orientation = orientation.data();
    return physim_world_states(world, byte() % 2 ? ids() : nullptr, byte() % 6 % 5, &columns, nullptr);
  }
  physim_result load() {
    const void* data = nullptr;
    std::size_t size = 0;
    if (const auto code = physim_bytes_data(one(bytes_made_), &data, &size); code != PHYSIM_OK) return code;
    if (byte() % 2) {
      return make(into(worlds_), [&](physim_world** to) {
        return physim_world_load(data, size, byte() % 2 ? one(defs_) : nullptr, nullptr, to);
      });
    }
    physim_replay_info info{};
    info.size = sizeof info;
    return physim_replay(data, size, nullptr, &info);
  }

  physim_result of_scenes(unsigned which) {
    physim_world* world = one(worlds_);
    void* scene = byte() % 2 ? static_cast<void*>(world) : one(scenes_);
    std::size_t count = 0;
    physim_id made{};
    std::array<physim_hit, 4> hits;
    switch (which) {
      case 32: return make(into(scenes_), [&](physim_scene** to) { return physim_scene_create(one(defs_), to); });
      case 33: return physim_scene_add(scene, one(defs_), ids_.data(), byte() % 8, &count);
      case 34: return physim_scene_copy(scene, id(), place(), &made);
      case 35: return physim_scene_move(scene, id(), place());
      case 36: {
        physim_motion& motion = sized(motion_);
        motion.start = number();
        for (double& x : motion.velocity) x = number();
        for (double& x : motion.angular_velocity) x = number();
        return physim_scene_set_motion(scene, id(), byte() % 8 ? &motion : nullptr);
      }
      case 37: return physim_scene_set_conveyor(scene, id(), three());
      case 38: return physim_scene_remove(scene, id());
      case 39: {
        const physim_segment way = segment();
        return byte() % 2 ? physim_scene_cast(scene, &way, 1, byte(), hits.data(), sizeof hits[0], nullptr)
                          : physim_scene_hits(scene, &way, ~0U, hits.data(), sizeof hits[0], byte() % 5, &count);
      }
      case 40: return physim_scene_nearest(scene, three(), number(), ~0U, number(), &sized(nearest_));
      case 41: return physim_world_set_scene(world, one(scenes_));
      case 42: return physim_world_add_emitter(world, one(defs_), shot(), byte() % 2 ? ids() : nullptr, &made);
      case 43: {
        const auto action = physim_emitter_action(byte() % 6);
        return physim_emitter_do(world, id(), action, action == PHYSIM_EMIT ? byte() % 20 : std::fmod(number(), 10));
      }
      case 44:
        return physim_world_add_force(world, one(defs_), shot(), ids(), byte() % 3, byte() % 2 ? ids() : nullptr,
                                      &made);
      case 45: {
        physim_joint& joint = sized(joint_);
        joint.kind = int(byte() % 4), joint.a = id(), joint.b = byte() % 2 ? id() : physim_id{};
        for (double& x : joint.point) x = number();
        joint.length = number(), joint.stiffness = number(), joint.damping = number();
        return physim_world_add_joint(world, &joint, &made);
      }
      case 46: return physim_world_remove(world, physim_what(byte() % 4), id());
      default: return physim_world_rest(world, ids(), byte() % 4, int(byte() % 3), &count);
    }
  }
  physim_segment segment() {
    physim_segment way{};
    for (double& x : way.from) x = number();
    for (double& x : way.to) x = number();
    way.radius = number(), way.time = number(), way.duration = number();
    return way;
  }

  std::span<const std::byte> bytes_;
  std::array<physim_def*, 3> defs_{};
  std::array<physim_world*, 3> worlds_{};
  std::array<physim_flight*, 2> flights_{};
  std::array<physim_snapshot*, 2> snapshots_{};
  std::array<physim_bytes*, 2> bytes_made_{};
  std::array<physim_scene*, 2> scenes_{};
  std::array<physim_id, 8> ids_{};
  std::array<char, 100> text_{};
  std::vector<const void*> made_;
  std::string path_;
  std::size_t steps_ = 0;
  physim_transform transform_{};
  physim_launch launch_{};
  physim_launches launches_{};
  physim_ends ends_{};
  physim_sample sample_{};
  physim_states states_{};
  physim_motion motion_{};
  physim_nearest nearest_{};
  physim_joint joint_{};
};

void play(std::span<const std::byte> bytes) { Program(bytes).run(); }

std::vector<Bytes> programs_to_begin_with() {
  std::vector<Bytes> seeds;
  for (unsigned seed = 1; seed < 40; ++seed) {
    Bytes bytes;
    std::uint64_t state = seed;
    for (int i = 0; i < 120; ++i) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      bytes.push_back(static_cast<std::byte>(state >> 56));
    }
    seeds.push_back(std::move(bytes));
  }
  return seeds;
}

}  // namespace

const Target kCalls{"calls", play, programs_to_begin_with};

}  // namespace physim::test
