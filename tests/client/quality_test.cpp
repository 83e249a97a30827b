// The quality of what is drawn: it follows the time that frames take, and calmly.
#include "simclient/core/quality.hpp"

#include <functional>

#include "client/support.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

/// Shows frames for so long [s], each as long as its quality takes [s]; how often the quality changed.
int show(QualityPicker& picker, double seconds, const std::function<double(Quality)>& frame) {
  int changes = 0;
  for (double time = 0; time < seconds;) {
    const Quality before = picker.now();
    const double taken = frame(before);
    time += taken;
    picker.add(taken);
    changes += picker.now() != before;
  }
  return changes;
}

TEST(Quality, StaysHighWhereFramesAreShort) {
  QualityPicker picker;
  EXPECT_EQ(show(picker, 60, [](Quality) { return 0.016; }), 0);
  EXPECT_EQ(picker.now(), Quality::high);
}

TEST(Quality, IsLoweredWithinASecondAndNoFurtherThanNeeded) {
  QualityPicker picker;
  const auto heavy = [](Quality q) { return q == Quality::high ? 0.060 : q == Quality::medium ? 0.018 : 0.010; };
  EXPECT_EQ(show(picker, 1, heavy), 1);
  EXPECT_EQ(picker.now(), Quality::medium);
  EXPECT_EQ(show(picker, 300, heavy), 0) << "between the two bounds nothing changes";
}

TEST(Quality, OneSlowFrameChangesNothing) {
  QualityPicker picker;
  int number = 0;
  EXPECT_EQ(show(picker, 20, [&](Quality) { return ++number % 40 == 0 ? 0.1 : 0.012; }), 0);
}

TEST(Quality, IsRaisedAtOnceWhenThereIsLessToDraw) {
  QualityPicker picker;
  const auto heavy = [](Quality q) { return q == Quality::high ? 0.2 : q == Quality::medium ? 0.05 : 0.015; };
  show(picker, 5, heavy);
  ASSERT_EQ(picker.now(), Quality::low);
  EXPECT_EQ(show(picker, 1, [](Quality) { return 0.005; }), 2);
  EXPECT_EQ(picker.now(), Quality::high);
}

TEST(Quality, RisesThatDoNotHoldComeSeldom) {
  QualityPicker picker;
  const auto heavy = [](Quality q) { return q == Quality::high ? 0.1 : 0.010; };
  const int first = show(picker, 60, heavy);
  EXPECT_LE(first, 12);
  EXPECT_LE(show(picker, 600, heavy), 10) << "twice as long after each";
  EXPECT_EQ(show(picker, 1, heavy), 0);
}

TEST(Quality, IsChosenByHandAndNamed) {
  Client client = client_of();
  EXPECT_FALSE(client.quality.is_told());
  ASSERT_TRUE(run(client, "quality medium"));
  EXPECT_EQ(client.quality.by_hand, Quality::medium);
  client.quality.now = Quality::medium;
  EXPECT_EQ(client.quality.text(), "medium");
  ASSERT_TRUE(run(client, "quality picked"));
  EXPECT_FALSE(client.quality.by_hand);
  EXPECT_EQ(client.quality.text(), "medium (picked)");
  EXPECT_TRUE(client.quality.is_told());
  for (const auto wanted : {Quality::high, Quality::medium, Quality::low}) {
    ASSERT_TRUE(run(client, "quality"));
    EXPECT_EQ(client.quality.by_hand, wanted);
  }
  ASSERT_TRUE(run(client, "quality"));
  EXPECT_FALSE(client.quality.by_hand);
  const Status wrong = run(client, "quality best");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().text().find("best"), std::string::npos);
}

// ------------------------------------------------------------------------------------------------------ what is drawn
TEST(Quality, DotsInOneCellAreTheNearestOfThem) {
  Camera camera;
  camera.set_viewport(800, 600);
  Scene scene{.quality = Quality::medium, .crowd_size = 3};
  const Vec3d eye = camera.eye(), at = camera.target;
  for (const double part : {1.0, 0.5, 0.8}) scene.crowd.push_back({eye + (at - eye) * part, 0xFF});  // behind another
  scene.crowd.push_back({at + camera.right() * (8 * camera.pixel_size(at)), 0xFF});                  // beside them
  scene.crowd.push_back({eye - (at - eye), 0xFF});                                                   // behind the eye
  scene.crowd.push_back({at + camera.right() * (5000 * camera.pixel_size(at)), 0xFF});               // out of view
  const std::vector<SceneDot> all = scene.crowd;
  thin_crowd(camera, scene);
  ASSERT_EQ(scene.crowd.size(), 2u);
  EXPECT_EQ(scene.crowd[0].at, all[1].at);
  EXPECT_EQ(scene.crowd[1].at, all[3].at);
}

/// All that is drawn of a crowd is still there to be seen: each dot that was left out has another on its pixels.
TEST(Quality, NoPlaceOfACrowdIsLeftEmpty) {
  Client client = client_of("world_sparks");
  ASSERT_TRUE(run(client, "wait 60"));
  Scene full, thin;
  build_scene(client, 1, full);
  client.quality.now = Quality::medium;
  build_scene(client, 1, thin);
  ASSERT_GT(full.crowd.size(), 2000u);
  EXPECT_LT(thin.crowd.size(), full.crowd.size());
  EXPECT_GT(thin.crowd.size(), 100u);
  EXPECT_EQ(thin.lines.size(), full.lines.size());
  std::vector<Pixel> kept;
  for (const SceneDot& dot : thin.crowd) kept.push_back(client.camera.project(dot.at).value());
  for (const SceneDot& dot : full.crowd) {
    const auto seen = client.camera.project(dot.at);
    if (!seen || !(seen->x >= 0 && seen->y >= 0 && seen->x < client.camera.width() && seen->y < client.camera.height()))
      continue;
    EXPECT_TRUE(std::ranges::any_of(kept,
                                    [&](const Pixel& p) {
                                      return std::abs(p.x - seen->x) < full.crowd_size &&
                                             std::abs(p.y - seen->y) < full.crowd_size;
                                    }))
        << seen->x << " " << seen->y;
  }
}

TEST(Quality, ParticlesOfACrowdedEmitterAreDots) {
  Client client = client_of("emit_fireworks");
  ASSERT_TRUE(run(client, "wait 400"));
  Scene scene;
  build_scene(client, 1, scene);
  const std::size_t particles = scene.drawn.size();
  EXPECT_TRUE(std::ranges::is_sorted(scene.drawn));
  EXPECT_TRUE(scene.crowd.empty());
  client.quality.now = Quality::low;
  build_scene(client, 1, scene);
  EXPECT_EQ(scene.drawn.size(), particles);
  EXPECT_FALSE(scene.crowd.empty());
  Client few = client_of("emit_fountain");
  ASSERT_TRUE(run(few, "wait 60"));
  few.quality.now = Quality::low;
  build_scene(few, 1, scene);
  EXPECT_GT(scene.drawn.size(), 100u);
  EXPECT_TRUE(scene.crowd.empty()) << "they keep their looks";
}

}  // namespace
}  // namespace physim::client
