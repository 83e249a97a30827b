// The gallery: every scenario that ships stands in it, its picture shows what it is about, and one that is chosen
// flies.
#include "simclient/core/gallery.hpp"

#include <map>

#include "client/support.hpp"
#include "shipped.hpp"
#include "simclient/core/actions.hpp"

namespace physim::client::client_gallery {
namespace {

TEST(Gallery, HasEachShippedScenarioOnce) {
  std::map<std::string, int> times;
  for (const std::string& name : test::shipped_scenarios()) times[name] = 0;
  for (const GalleryGroup& group : gallery())
    for (const GalleryItem& item : group.items) {
      ASSERT_TRUE(times.contains(std::string(item.scenario))) << item.scenario << " does not ship";
      ++times[std::string(item.scenario)];
      EXPECT_FALSE(item.title.empty());
      EXPECT_LE(item.title.size(), 31U) << item.title << " has no room on a card";
    }
  for (const auto& [name, count] : times) EXPECT_EQ(count, 1) << name;
}

TEST(Gallery, IsSearchedInEitherCase) {
  const auto found = gallery_items("", "GOLF drive");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]->scenario, "golf_drive");
  EXPECT_EQ(gallery_items("Sport", "").size(), 11U);
  EXPECT_TRUE(gallery_items("Shooters", "golf").empty());
  EXPECT_GT(gallery_items("", "nasa").size(), 9U);
  EXPECT_TRUE(gallery_items("", "zebra").empty());
}

/// A shot of a file without a world is fired; a world runs by itself.
TEST(Gallery, WhatIsChosenFlies) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "gallery golf_drive; wait 5"));
  EXPECT_EQ(client.session.scenario().title, "A golf drive with backspin");
  ASSERT_EQ(client.session.tracks().size(), 1U);
  EXPECT_TRUE(client.session.tracks()[0].is_flying());
  ASSERT_TRUE(run(client, "gallery emit_fountain; wait 30"));
  EXPECT_GT(client.session.world().size(), 10U);
  const Status bad = run(client, "gallery golf_dive");
  ASSERT_FALSE(bad);
  EXPECT_NE(bad.error().text().find("did you mean \"golf_drive\""), std::string::npos) << bad.error().text();
  EXPECT_EQ(client.session.scenario().title, "Fountain: a ring of jets, 1600 drops without air") << "it stays";
}

TEST(Gallery, AsksBeforeWorkIsLost) {
  Client client = client_of();
  run_action(client, *find_action("gallery"));
  EXPECT_EQ(client.dialog, Dialog::gallery);
  EXPECT_FALSE(client.question);
  ASSERT_TRUE(run(client, "set shot.mass=3 kg"));
  run_action(client, *find_action("gallery"), "billiards");
  ASSERT_TRUE(client.question);
  answer(client, Answer::yes);
  EXPECT_EQ(client.session.scenario().title, "Balls on a billiard table");
}

/// In each of them something has flown, in a picture that it fills as a window would be.
TEST(Gallery, PicturesShowWhatFlies) {
  for (const GalleryItem* item : gallery_items("", "")) {
    Result<Pose> pose = pose_of(item->scenario, 224, 140);
    ASSERT_TRUE(pose) << item->scenario << ": " << pose.error().text();
    Client& client = pose->client;
    const bool is_world = client.session.scenario().world.given;
    EXPECT_TRUE(is_world ? client.session.step() > 0 : !pose->paths.empty()) << item->scenario;
    EXPECT_EQ(client.camera.width(), 224);
    EXPECT_GE(client.camera.cover(client.subject()), 0.25) << item->scenario;
  }
  EXPECT_FALSE(pose_of("nowhere", 224, 140));
}

/// Its second shot goes over the hill that stops the first.
TEST(Gallery, PicturesShowAllOfEachFlight) {
  const Pose pose = must(pose_of("mortar_over_hill", 224, 140));
  ASSERT_GE(pose.paths.size(), 2U);
  for (const auto& path : pose.paths)
    for (const TrackSample& s : path) {
      const auto at = pose.client.camera.project(s.position);
      ASSERT_TRUE(at && at->x >= 0 && at->y >= 0 && at->x <= 224 && at->y <= 140) << at->x << " " << at->y;
    }
}

}  // namespace
}  // namespace physim::client::client_gallery
