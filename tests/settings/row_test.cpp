// Rows of settings: what they say of ranges is what check() refuses, and what files and studies show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "physim/study.hpp"
#include "prepare/check.hpp"
#include "scenario/scenario.hpp"
#include "settings/environment_rows.hpp"
#include "settings/flight_rows.hpp"
#include "settings/shot_rows.hpp"
#include "settings/units.hpp"

namespace physim::settings_row_test {

using namespace setting_rows;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Numbers that no row of a range allows.
std::vector<double> bad_numbers(const Range& range) {
  std::vector<double> bad = {kNan, -kInfinity};
  if (range.low > -kInfinity) bad.push_back(range.low - 1 - std::abs(range.low));
  if (range.low_open) bad.push_back(range.low);
  if (range.high < kInfinity) bad.push_back(2 * range.high + 1);
  if (!range.infinite) bad.push_back(kInfinity);
  return bad;
}

/// Spoils one number after the other of a sound structure. check() must name each.
template <const auto& rows, class Owner>
void expect_refusals(const Owner& sound, const std::string& before) {
  ASSERT_TRUE(check(sound)) << before;
  const auto spoil = [&](const auto& row, auto&& number_of) {
    for (const double bad : bad_numbers(row.range)) {
      Owner spoilt = sound;
      number_of(row.get(spoilt)) = bad;
      const Status status = check(spoilt);
      ASSERT_FALSE(status) << row.path << ' ' << bad;
      EXPECT_EQ(status.error().place, before + std::string(row.path)) << bad;
    }
  };
  const auto look = [&](const auto& row) {
    using Member = std::decay_t<decltype(row.get(sound))>;
    if constexpr (std::is_same_v<Member, double>) spoil(row, [](double& x) -> double& { return x; });
    if constexpr (std::is_same_v<Member, std::optional<double>>)
      spoil(row, [](std::optional<double>& x) -> double& { return x.emplace(); });
    if constexpr (std::is_same_v<Member, Vec3d>) {
      spoil(row, [](Vec3d& v) -> double& { return v.x; });
      spoil(row, [](Vec3d& v) -> double& { return v.y; });
      spoil(row, [](Vec3d& v) -> double& { return v.z; });
    }
  };
  std::apply([&](const auto&... row) { (look(row), ...); }, rows);
}

TEST(SettingRows, every_number_of_a_projectile_is_checked) {
  const ProjectileDef sound;
  expect_refusals<kProjectileRows>(sound, "projectile.");
  expect_refusals<kMagnusRows>(sound, "projectile.");
  expect_refusals<kInertiaRows>(sound, "projectile.");
  expect_refusals<kAeroRows>(sound, "projectile.");
  expect_refusals<kMotorRows>(ProjectileDef{.motor = {.thrust = {{0, 10}, {1, 10}}}}, "projectile.");
}

TEST(SettingRows, every_number_of_a_launch_is_checked) {
  const Launch sound{.speed = 100};
  expect_refusals<kMuzzleRows>(sound, "launch.");
  expect_refusals<kLaunchRows>(sound, "launch.");
  expect_refusals<kSightRows>(sound, "launch.");
  expect_refusals<kAttitudeRows>(sound, "launch.");
}

TEST(SettingRows, every_number_of_a_place_and_of_an_end_is_checked) {
  expect_refusals<kGroundRows>(Environment{}, "environment.");
  expect_refusals<kAirRows>(Environment{}, "environment.");
  expect_refusals<kScaleHeightRows>(Environment{}, "environment.");
  expect_refusals<kWindRows>(Environment{}, "environment.");
  expect_refusals<kEarthRows>(Environment{}, "environment.");
  expect_refusals<kUntilRows>(Until{}, "until.");
}

/// Numbers whose sum overflows are in range: each of them is finite.
TEST(SettingRows, large_numbers_are_no_infinite_ones) {
  ProjectileDef projectile;
  projectile.twist = projectile.gravity_scale = projectile.magnus.lift = std::numeric_limits<double>::max();
  EXPECT_TRUE(check(projectile));
  EXPECT_TRUE(check(Launch{.position = {1e308, 1e308, 1e308}, .speed = 1}));
}

/// The unit of an uncertain number is that of its setting.
TEST(SettingRows, studies_and_files_agree_on_units) {
  for (const Setting& setting : settings()) {
    const auto path = study_path(setting.path);
    if (!path || setting.type != "quantity") continue;
    EXPECT_EQ(path->unit, setting.unit.empty() ? "-" : setting.unit) << setting.path;
    EXPECT_EQ(path->about, setting.doc) << setting.path;
  }
}

}  // namespace physim::settings_row_test
