// The C interface beside C++ and scenario files: the same bits; every setting by its path; bad input.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "physim/physim.h"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim::capi_capi_test {

/// A handle that is freed at the end of its block.
template <class Handle>
class Owned {
 public:
  Owned() = default;
  ~Owned() { EXPECT_EQ(physim_free(handle_), PHYSIM_OK); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  operator Handle*() const { return handle_; }  // NOLINT: it is one
  Handle** into() { return &handle_; }

 private:
  Handle* handle_ = nullptr;
};

#define EXPECT_DONE(call) EXPECT_EQ(call, PHYSIM_OK) << physim_last_error()
#define ASSERT_DONE(call) ASSERT_EQ(call, PHYSIM_OK) << physim_last_error()

template <class T>
T sized() {
  T made{};
  made.size = sizeof(T);
  return made;
}

std::string get(const physim_def* def, const std::string& path) {
  std::size_t length = 0;
  if (physim_get(def, path.c_str(), nullptr, 0, &length) != PHYSIM_OK) return physim_last_error();
  std::string text(length + 1, '\0');
  EXPECT_DONE(physim_get(def, path.c_str(), text.data(), text.size(), nullptr));
  text.resize(length);
  return text;
}

constexpr const char* kShot = R"(physim = 1
[environment]
wind = { velocity = [1, 0, -4] }
[[shot]]
name = "match"
mass = "168 gr"
diameter = "0.308 in"
length = "1.215 in"
twist = "12 in"
speed = "800 m/s"
elevation = "1 deg"
drag = { table = "g7", ballistic_coefficient = "0.218 lb/in^2" }
fidelity = "small_arms"
[until]
range = "800 m"
)";

// ---------------------------------------------------------------------------------------------------------- equal bits
TEST(CInterface, a_flight_has_the_bits_of_cpp_and_of_the_file) {
  Owned<physim_def> def;
  Owned<physim_flight> flight;
  ASSERT_DONE(physim_def_create(kShot, "c.toml", def.into()));
  ASSERT_DONE(physim_fly(def, "match", nullptr, flight.into()));
  const Flight of_file = *ScenarioFile::parse(kShot, "c.toml")->fly("match");
  const Scenario s = *parse_scenario(kShot, "c.toml");
  const Flight in_cpp = fly(projectile_of(s.shots[0]), s.shots[0].launch, s.environment, s.shots[0].projectile.fidelity,
                            s.tolerance, s.until);
  auto at = sized<physim_sample>();
  for (int i = 0; i <= 100; ++i) {
    const double time = in_cpp.duration() * i / 100;
    ASSERT_DONE(physim_flight_at(flight, PHYSIM_AT_TIME, time, &at));
    for (const Flight* other : {&of_file, &in_cpp}) {
      const Sample sample = other->at(time);
      EXPECT_EQ((Vec3d{at.position[0], at.position[1], at.position[2]}), sample.position);
      EXPECT_EQ((Vec3d{at.velocity[0], at.velocity[1], at.velocity[2]}), sample.velocity);
      EXPECT_EQ(at.mach, sample.mach);
      EXPECT_EQ(at.windage, sample.windage);
      EXPECT_EQ(at.energy, sample.energy);
    }
  }
}

TEST(CInterface, a_batch_has_the_bits_of_cpp) {
  constexpr std::size_t kCount = 500;
  std::vector<double> speed(kCount), wind(kCount), x(kCount), y(kCount), z(kCount), time(kCount), drop(kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    speed[i] = 700 + 0.3 * static_cast<double>(i);
    wind[i] = 0.01 * static_cast<double>(i);
  }
  Owned<physim_def> def;
  Owned<physim_pool> pool;
  ASSERT_DONE(physim_def_create(kShot, "c.toml", def.into()));
  ASSERT_DONE(physim_pool_create(2, pool.into()));
  auto launches = sized<physim_launches>();
  auto weather = sized<physim_weather>();
  auto ends = sized<physim_ends>();
  launches.speed = speed.data();
  weather.wind_z = wind.data();
  ends.x = x.data(), ends.y = y.data(), ends.z = z.data(), ends.time = time.data(), ends.drop = drop.data();
  ASSERT_DONE(physim_batch(def, nullptr, kCount, &launches, &weather, &ends, pool, nullptr));

  const Scenario s = *parse_scenario(kShot, "c.toml");
  std::vector<double> x2(kCount), y2(kCount), z2(kCount), time2(kCount), drop2(kCount);
  const ColumnsResult flown =
      fly_columns(projectile_of(s.shots[0]), {.common = s.shots[0].launch, .speed = speed}, s.environment,
                  s.shots[0].projectile.fidelity, s.tolerance, s.until,
                  {.time = time2, .x = x2, .y = y2, .z = z2, .drop = drop2}, nullptr, {.wind_z = wind});
  EXPECT_EQ(flown.refused, 0U);
  EXPECT_EQ(x, x2);
  EXPECT_EQ(y, y2);
  EXPECT_EQ(z, z2);
  EXPECT_EQ(time, time2);
  EXPECT_EQ(drop, drop2);
}

constexpr const char* kWorld = R"(physim = 1
[[shot]]
name = "spark"
mass = "1 g"
diameter = "3 mm"
fidelity = "game"
body = { restitution = 0.6, collision = { on_hit = "bounce", radius = "2 mm" } }
[[shot]]
name = "ball"
mass = "2 kg"
diameter = "10 cm"
speed = "30 m/s"
elevation = "40 deg"
fidelity = "small_arms"
body = { collision = { on_hit = "bounce", radius = "5 cm" } }
[world]
step = "10 ms"
duration = "4 s"
[[shape]]
name = "wall"
box = { half = [0.5, 4, 4] }
[[thing]]
name = "wall"
shape = "wall"
position = [12, 4, 0]
[[emitter]]
name = "sparks"
shot = "spark"
per_second = 300
seed = 11
position = [11, 6, 0]
from = { shape = "sphere", radius = "10 cm" }
start = { speed = ["1 m/s", "6 m/s"], lifetime = "3 s" }
[[volley]]
shot = "ball"
count = 20
interval = "100 ms"
spread = { horizontal = "2 deg", vertical = "1 deg" }
)";

TEST(CInterface, a_world_with_scene_and_emitter_has_the_bits_of_cpp_and_of_the_file) {
  Owned<physim_def> def;
  Owned<physim_world> world;
  ASSERT_DONE(physim_def_create(kWorld, "c.toml", def.into()));
  ASSERT_DONE(physim_world_create(def, PHYSIM_FIRE_ALL, world.into()));
  ScenarioRun of_file = *ScenarioFile::parse(kWorld, "c.toml")->run();
  WorldRun in_cpp = *WorldRun::create(*parse_scenario(kWorld, "c.toml"));
  std::uint64_t hash = 0;
  for (std::uint64_t i = 0; i < in_cpp.steps(); ++i) {
    ASSERT_DONE(physim_world_step(world, 1, 0));
    of_file.step();
    in_cpp.step();
    ASSERT_DONE(physim_world_hash(world, &hash));
    ASSERT_EQ(hash, in_cpp.world().hash()) << "step " << i;
  }
  EXPECT_EQ(hash, of_file.world().hash());
  EXPECT_GT(in_cpp.world().size(), 300U);
}

/// The same world, built call by call.
TEST(CInterface, a_world_of_calls_has_the_bits_of_cpp) {
  Owned<physim_def> def;
  Owned<physim_world> world;
  ASSERT_DONE(physim_def_create(kWorld, "c.toml", def.into()));
  ASSERT_DONE(physim_world_create(def, PHYSIM_FIRE_NOTHING, world.into()));
  std::uint32_t kind = 0;
  physim_id emitter{}, ids[10];
  std::array<double, 10> z{};
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = 0.2 * static_cast<double>(i);
  auto launches = sized<physim_launches>();
  launches.z = z.data();
  ASSERT_DONE(physim_world_add_emitter(world, def, "sparks", nullptr, &emitter));
  ASSERT_DONE(physim_world_add_kind(world, def, "ball", 0, 0, &kind));
  ASSERT_DONE(physim_world_spawn(world, kind, z.size(), &launches, ids, nullptr));
  ASSERT_DONE(physim_world_step(world, 100, 0));
  const std::array<double, 3> push{1, 2, 3};
  ASSERT_DONE(physim_world_push(world, ids, 1, push.data(), nullptr));
  ASSERT_DONE(physim_world_step(world, 100, 0));

  const Scenario s = *parse_scenario(kWorld, "c.toml");
  WorldDef own = s.world.def;
  own.environment = s.environment;
  own.tolerance = s.tolerance;
  World twin = *World::create(own);
  ASSERT_TRUE(twin.set_scene(*scene_of(s)));
  const KindId spark = *twin.add_kind(s.shots[0].projectile, s.shots[0].body);
  EmitterDef fires = s.emitters[0].def;
  fires.kind = spark;
  ASSERT_TRUE(twin.add_emitter(fires).ok());
  const KindId ball = *twin.add_kind(s.shots[1].projectile, s.shots[1].body);
  std::vector<Launch> launched(z.size(), s.shots[1].launch);
  std::vector<ProjectileId> born(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) launched[i].position.z = z[i];
  EXPECT_EQ(twin.spawn(ball, launched, born), z.size());
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(twin.step(s.world.def.step));
  ASSERT_TRUE(twin[born[0]].apply_impulse({1, 2, 3}));
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(twin.step(s.world.def.step));

  std::uint64_t hash = 0;
  ASSERT_DONE(physim_world_hash(world, &hash));
  EXPECT_EQ(hash, twin.hash());
  auto states = sized<physim_states>();
  std::vector<double> positions(3 * twin.size());
  std::size_t count = 0;
  std::vector<physim_id> alive(twin.size());
  states.position = positions.data();
  states.id = alive.data();
  ASSERT_DONE(physim_world_states(world, nullptr, twin.size(), &states, &count));
  ASSERT_EQ(count, twin.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d at = twin[{alive[i].index, alive[i].generation}].position();
    EXPECT_EQ((Vec3d{positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}), at);
  }
}

TEST(CInterface, a_study_has_the_bits_of_cpp_and_of_the_file) {
  const std::string text = std::string(kShot) +
                           "[study]\nshots = 8000\ninputs = [\"shot.speed = 800 m/s +- 3 m/s\", "
                           "\"environment.wind.velocity.z = -6 m/s .. -2 m/s\"]\n";
  Owned<physim_def> def;
  Owned<physim_study> study;
  Owned<physim_part> part;
  Owned<physim_bytes> bytes;
  ASSERT_DONE(physim_def_create(text.c_str(), "c.toml", def.into()));
  ASSERT_DONE(physim_study_create(def, nullptr, study.into()));
  auto info = sized<physim_study_info>();
  ASSERT_DONE(physim_study_read(study, &info));
  ASSERT_DONE(physim_study_fly(study, 0, info.shards, nullptr, part.into()));
  ASSERT_DONE(physim_save(part, bytes.into()));
  const void* data = nullptr;
  std::size_t size = 0;
  ASSERT_DONE(physim_bytes_data(bytes, &data, &size));
  const Scenario s = *parse_scenario(text, "c.toml");
  const StudyPlan plan = *plan_study(*study_of(s, s.shots[0]));
  ASSERT_EQ(plan.shards(), info.shards);
  const std::vector<std::byte> in_cpp = save_part(*run_shards(plan, 0, plan.shards()));
  const auto* first = static_cast<const std::byte*>(data);
  EXPECT_EQ(std::vector<std::byte>(first, first + size), in_cpp);
}

// ----------------------------------------------------------------------------------------------------------- settings
/// A value of a setting's type that is not its default; nothing if there is none.
std::vector<std::string> values_of(const physim_setting& setting) {
  const std::string type = setting.type, range = setting.range, value = setting.default_value;
  if (type == "boolean") return {value == "true" ? "false" : "true"};
  if (type == "text") return {"some words"};
  if (type == "choice") {
    std::vector<std::string> names;
    for (std::size_t at = 0; at < range.size();) {
      const std::size_t end = std::min(range.find(" | ", at), range.size());
      names.push_back(range.substr(at, end - at));
      at = end + 3;
    }
    return names;
  }
  return {"1",
          "2",
          "0.5",
          "300",
          "50000",
          "5e7",
          "[1, 2, 3]",
          "[[0, 1], [1, 2]]",
          "[\"some\", \"words\"]",
          "[1, 2]",
          "[[0, \"#ff0000\"]]",
          "[[0, 1, 2]]",
          "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]",
          "\"#ff0000\""};
}

/// The path of a setting in the first element of each list on its way: "emitter.1.bursts.1.time".
std::string numbered(const std::string& path, const std::set<std::string>& lists) {
  std::string out;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t dot = std::min(path.find('.', at), path.size());
    out += (at == 0 ? "" : ".") + path.substr(at, dot - at);
    if (dot < path.size() && lists.contains(path.substr(0, dot))) out += ".1";
    at = dot + 1;
  }
  return out;
}

/// The version, settings that stand for others, which are read instead, and those that belong to a file that is named.
bool is_only_set(const std::string& path) {
  static const std::set<std::string> kOnlySet = {"physim",
                                                 "shot.1.preset",
                                                 "shot.1.motor.file",
                                                 "shot.1.fidelity.preset",
                                                 "volley.1.rate",
                                                 "material.1.preset",
                                                 "material.1.concrete",
                                                 "shape.1.mesh.reach",
                                                 "shape.1.mesh.every",
                                                 "shape.1.mesh.geoid",
                                                 "shape.1.mesh.missing",
                                                 "shape.1.height_field.low",
                                                 "shape.1.height_field.high"};
  return kOnlySet.contains(path);
}

TEST(CInterface, every_setting_is_set_and_read_by_its_path) {
  std::vector<physim_setting> all(physim_setting_count(), sized<physim_setting>());
  std::set<std::string> lists;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_DONE(physim_setting_at(i, &all[i]));
    if (std::string(all[i].type) == "list") lists.insert(all[i].path);
  }
  for (const physim_setting& setting : all) {
    const std::string below = std::string(setting.path) + ".";
    const auto is_below = [&below](const physim_setting& s) { return std::string_view(s.path).starts_with(below); };
    if (std::ranges::any_of(all, is_below)) continue;  // a list: what is in its elements is set one by one
    const std::string path = numbered(setting.path, lists);
    bool is_set = false, is_read = false;
    for (const std::string& value : values_of(setting)) {
      Owned<physim_def> def;
      ASSERT_DONE(physim_def_create(nullptr, nullptr, def.into()));
      if (physim_set(def, path.c_str(), value.c_str()) != PHYSIM_OK) continue;
      is_set = true;
      char read[256];
      const physim_result code = physim_get(def, path.c_str(), read, sizeof read, nullptr);
      is_read = is_read || (code == PHYSIM_OK && setting.default_value != std::string(read));
    }
    EXPECT_TRUE(is_set) << path << " (" << setting.type << "): " << physim_last_error();
    EXPECT_TRUE(is_read || is_only_set(path)) << path << " (" << setting.type << "): " << physim_last_error();
  }
}

}  // namespace physim::capi_capi_test
