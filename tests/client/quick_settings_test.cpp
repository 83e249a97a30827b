// Sliders: each changes what it is called after, and nothing else; accuracy is one of them.
#include "simclient/core/quick_settings.hpp"

#include <algorithm>

#include "client/support.hpp"
#include "math/angles.hpp"
#include "physim/names.hpp"

namespace physim::client::client_quick {
namespace {

QuickSetting setting_of(Client& client, Quick what) {
  const std::vector<QuickSetting> all = quick_settings(client);
  return *std::ranges::find(all, what, &QuickSetting::what);
}

TEST(Sliders, ChangeWhatTheyAreCalledAfter) {
  Client client = client_of("golf_drive");
  const std::pair<Quick, double> wanted[] = {{Quick::speed, 60}, {Quick::elevation, 20},   {Quick::azimuth, -30},
                                             {Quick::mass, 50},  {Quick::wind_along, 3.5}, {Quick::wind_across, -7}};
  for (const auto& [what, value] : wanted) {
    const std::vector<QuickSetting> before = quick_settings(client);
    ASSERT_TRUE(set_quick(client, setting_of(client, what), value));
    for (std::size_t i = 0; i < before.size(); ++i) {
      const QuickSetting now = quick_settings(client)[i];
      EXPECT_NEAR(now.value, now.what == what ? value : before[i].value, 1e-9) << now.name;
      EXPECT_LE(now.low, now.value);
      EXPECT_GE(now.high, now.value);
    }
  }
  EXPECT_NEAR(client.launcher.shot().projectile.mass, 0.05, 1e-12) << "in g";
  EXPECT_NEAR(client.launcher.shot().launch.azimuth, -30 * kDegree, 1e-12);
  EXPECT_EQ(client.session.scenario().environment.wind.velocity, (Vec3d{3.5, 0, -7}));
}

TEST(Sliders, DragGoesOffAndComesBack) {
  Client client = client_of("308_168gr_g7");
  const DragModel own = client.launcher.shot().projectile.fidelity.drag;
  ASSERT_TRUE(set_quick(client, setting_of(client, Quick::drag), 0));
  EXPECT_EQ(client.launcher.shot().projectile.fidelity.drag, DragModel::off);
  EXPECT_NE(setting_of(client, Quick::wind_across).idle, "") << "nothing for the wind to blow on";
  ASSERT_TRUE(set_quick(client, setting_of(client, Quick::drag), 1));
  EXPECT_EQ(client.launcher.shot().projectile.fidelity.drag, own);
  EXPECT_EQ(setting_of(client, Quick::wind_across).idle, "");
  Client vacuum = client_of("mortar_over_hill");
  EXPECT_NE(setting_of(vacuum, Quick::wind_along).idle.find("without air"), std::string::npos);
}

/// The slider of a zeroed rifle says how far the barrel is raised above its zero.
TEST(Sliders, KeepAZero) {
  Client client = client_of("22lr");
  EXPECT_EQ(setting_of(client, Quick::elevation).value, 0);
  ASSERT_TRUE(set_quick(client, setting_of(client, Quick::elevation), 0.5));
  ASSERT_TRUE(set_quick(client, setting_of(client, Quick::speed), 350));
  EXPECT_TRUE(client.launcher.is_zeroed());
  EXPECT_NEAR(client.launcher.raised(), 0.5 * kDegree, 1e-12);
  EXPECT_NEAR(client.launcher.speed(), 350, 1e-12);
}

TEST(Accuracy, IsOneSliderOverThePresets) {
  Client client = client_of("308_168gr_g7");
  const auto now = [&] { return accuracy_of(client.launcher.shot().projectile.fidelity); };
  EXPECT_EQ(accuracy_rungs()[now().rung].preset, "small_arms");
  EXPECT_TRUE(now().is_preset);
  double end = 0;
  for (std::size_t i = 0; i < accuracy_rungs().size(); ++i) {
    ASSERT_TRUE(set_accuracy(client, i)) << accuracy_rungs()[i].preset;
    EXPECT_EQ(client.launcher.shot().projectile.fidelity, *fidelity_preset(accuracy_rungs()[i].preset));
    EXPECT_EQ(now().rung, i);
    EXPECT_TRUE(now().is_preset);
    ASSERT_FALSE(client.prediction().error);
    const double falls = client.prediction().path.back().position.y;
    EXPECT_NE(falls, end) << "each flies otherwise than the one before: " << accuracy_rungs()[i].preset;
    end = falls;
  }
  ASSERT_TRUE(set_accuracy(client, 4));
  ASSERT_TRUE(client.set("shot.fidelity.interpolation=linear"));
  EXPECT_FALSE(now().is_preset);
  EXPECT_EQ(now().rung, 4U) << "the one that has most of it";
}

/// A shell whose attitude is flown is simulated, though some of its settings differ from the preset.
TEST(Accuracy, IsNearestToWhatIsFlown) {
  const std::pair<const char*, const char*> wanted[] = {
      {"105mm_m1_six_dof", "simulation"}, {"golf_drive", "constant_air"}, {"world_force_field", "game"}};
  for (const auto& [scenario, preset] : wanted)
    EXPECT_EQ(accuracy_rungs()[accuracy_of(client_of(scenario).launcher.shot().projectile.fidelity).rung].preset,
              preset)
        << scenario;
}

TEST(Sliders, OneDragIsOneStepBack) {
  Client client = client_of("golf_drive");
  const double before = client.launcher.shot().projectile.mass;
  client.slide = 1;
  for (int grams = 41; grams < 60; ++grams) {
    ASSERT_TRUE(set_quick(client, setting_of(client, Quick::mass), grams));
    client.advance(1.5);  // as slowly as one likes
  }
  client.slide = 0;
  ASSERT_TRUE(client.set("shot.mass=70 g"));
  ASSERT_TRUE(client.undo());
  EXPECT_NEAR(client.launcher.shot().projectile.mass, 0.059, 1e-12) << "what was typed";
  ASSERT_TRUE(client.undo());
  EXPECT_EQ(client.launcher.shot().projectile.mass, before) << "all of the drag";
}

}  // namespace
}  // namespace physim::client::client_quick
