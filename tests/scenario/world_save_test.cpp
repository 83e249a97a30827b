// Runs of scenarios that are saved and go on: as if they had not stopped.
#include <cstring>

#include "base/hash.hpp"
#include "physim/result.hpp"
#include "physim/world.hpp"
#include "scenario/run_support.hpp"
#include "shipped.hpp"

namespace physim::scenario_world_save_test {

const std::string kGun = R"(
[[shot]]
name = "gun"
speed = "100 m/s"
position = [0, "2 m", 0]
fidelity = "game"
[[volley]]
name = "burst"
shot = "gun"
count = 50
rate = "120 rpm"
[world]
duration = "30 s"
)";

void expect_same(const WorldRun& a, const WorldRun& b) {
  EXPECT_EQ(a.world().hash(), b.world().hash());
  EXPECT_EQ(a.world().time(), b.world().time());
  const auto left = a.groups(), right = b.groups();
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(left[i].spawned, right[i].spawned);
    EXPECT_EQ(left[i].landed, right[i].landed);
    EXPECT_EQ(left[i].bounces, right[i].bounces);
    EXPECT_EQ(left[i].hits, right[i].hits);
    EXPECT_EQ(left[i].alive, right[i].alive);
    EXPECT_EQ(left[i].range.mean, right[i].range.mean);
    EXPECT_EQ(left[i].speed.spread(), right[i].speed.spread());
    EXPECT_EQ(left[i].position, right[i].position);
  }
}

TEST(WorldSave, every_shipped_world_goes_on_from_a_save) {
  int worlds = 0;
  for (const std::string& name : test::shipped_scenarios()) {
    const auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/" + name + ".toml"));
    if (!scenario.world.given) continue;
    SCOPED_TRACE(name);
    ++worlds;
    WorldRun whole = WorldRun::create(scenario).value();
    WorldRun parts = WorldRun::create(scenario).value();
    const std::uint64_t steps = std::min<std::uint64_t>(whole.steps(), 300);
    for (std::uint64_t step = 0; step < steps; ++step) {
      if (step % 97 == 0) {
        const auto save = must(parts.save());
        auto loaded = must(WorldRun::load(scenario, save));
        parts = std::move(loaded);
      }
      whole.step(), parts.step();
    }
    expect_same(whole, parts);
  }
  EXPECT_GE(worlds, 5);
}

TEST(WorldSave, of_another_scenario_is_refused) {
  WorldRun run = WorldRun::create(parsed(kGun)).value();
  for (int i = 0; i < 90; ++i) run.step();
  const std::vector<std::byte> save = run.save().value();
  ASSERT_TRUE(WorldRun::load(parsed(kGun), save));
  EXPECT_TRUE(WorldRun::load(parsed(kGun, {"world.duration=60 s"}), save)) << "it may last longer";
  for (const char* other : {"volley.seed=2", "shot.speed=90 m/s", "volley.count=51", "world.step=0.01 s"}) {
    const auto loaded = WorldRun::load(parsed(kGun, {other}), save);
    ASSERT_FALSE(loaded) << other;
    EXPECT_EQ(loaded.error().place, "save");
  }
  for (std::size_t i = 0; i < save.size(); i += 5) {
    std::vector<std::byte> damaged = save;
    damaged[i] ^= std::byte{4};
    EXPECT_FALSE(WorldRun::load(parsed(kGun), damaged)) << i;
    EXPECT_FALSE(WorldRun::load(parsed(kGun), std::span(save).first(i))) << i;
  }
}

/// A save with other bytes and the check sum that goes with them.
std::vector<std::byte> with_sum(std::vector<std::byte> save) {
  constexpr std::size_t kHead = 12, kSum = 8;
  Hash hash;
  hash.add(std::span(save).subspan(kHead, save.size() - kHead - kSum));
  for (std::size_t i = 0; i < kSum; ++i) save[save.size() - kSum + i] = std::byte(hash.value() >> (8 * i));
  return save;
}

TEST(WorldSave, of_another_version_is_read_or_refused_by_name) {
  WorldRun run = WorldRun::create(parsed(kGun)).value();
  for (int i = 0; i < 90; ++i) run.step();
  std::vector<std::byte> save = run.save().value();
  constexpr std::size_t kFormat = 8, kLength = 12, kVersionPlace = 16;
  save[kVersionPlace] = std::byte{'7'};
  EXPECT_TRUE(WorldRun::load(parsed(kGun), with_sum(save))) << "it has the same format";
  save[kFormat] = std::byte{99};
  const Error error = WorldRun::load(parsed(kGun), save).error();
  EXPECT_EQ(error.place, "save");
  EXPECT_NE(error.message.find("is of format 99, written by PhySim 7" + std::string(kVersion).substr(1) +
                               "; this is PhySim " + kVersion + ", which reads format "),
            std::string::npos)
      << error.message;
  // Format 5 has no version: it is that of 0.1.0, which goes on.
  save[kFormat] = std::byte{5};
  save.erase(save.begin() + kLength, save.begin() + kVersionPlace + static_cast<long>(std::strlen(kVersion)));
  EXPECT_TRUE(WorldRun::load(parsed(kGun), with_sum(save)));
  save[kFormat] = std::byte{4};
  EXPECT_NE(WorldRun::load(parsed(kGun), save).error().message.find("format 4, written by an older version of PhySim;"),
            std::string::npos);
}

TEST(WorldRun, one_that_would_never_end_is_refused) {
  for (const char* duration : {"world.duration=1e300 s", "world.duration=1e12 s", "world.duration=1e18 s"}) {
    const auto run = WorldRun::create(parsed(kGun, {duration}));
    ASSERT_FALSE(run) << duration;
    EXPECT_NE(run.error().place.find("world.duration"), std::string::npos);
    EXPECT_NE(run.error().message.find("1e12"), std::string::npos);
  }
}

/// More launches at once than a world keeps events of.
TEST(WorldRun, every_launch_of_a_large_volley_is_counted) {
  const auto run = must(WorldRun::create(
      parsed(kGun, {"volley.count=200000", "volley.interval=0 s", "volley.rate=none", "world.duration=0.1 s",
                    "world.pools=[{ name = \"p\", maximum = 30, when_full = \"replace_oldest\" }]"})));
  EXPECT_EQ(run.groups()[0].spawned, 200'000u);
  EXPECT_EQ(run.groups()[0].retired, 200'000u - 30);
}

}  // namespace physim::scenario_world_save_test
