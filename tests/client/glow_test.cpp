// The light of hot particles.
#include "simclient/core/glow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/support.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

GlowMap glow_of(const Camera& camera, const std::vector<Light>& lights) {
  GlowMaker maker(camera, 1, 1e9);
  for (const Light& light : lights) maker.add(light);
  GlowMap map;
  maker.make(map);
  return map;
}

/// The light of the cell that holds a pixel; red.
int red_at(const GlowMap& map, double x, double y) {
  const int column = static_cast<int>(std::floor(x / map.cell)) - map.left;
  const int row = static_cast<int>(std::floor(y / map.cell)) - map.top;
  if (column < 0 || row < 0 || column >= map.columns || row >= map.rows) return 0;
  return map.light[static_cast<std::size_t>(row * map.columns + column) * 3];
}

/// The picture after a script.
Scene shown_after(Client& client, const std::string& script) {
  client.camera.set_viewport(960, 712);
  EXPECT_TRUE(run(client, script));
  Scene scene;
  build_scene(client, 1, scene);
  return scene;
}

TEST(Glow, ColoursOfFireAreHot) {
  for (const Colour fire : {0xE69F00FFU, 0xD55E00FFU, 0xFF8020FFU, 0xFFE080FFU}) EXPECT_GT(heat(fire), 0.5);
  for (const Colour cold : {0x0072B2FFU, 0x56B4E9FFU, 0x009E73FFU, 0x606060FFU, 0xFFFFFFFFU, 0x000000FFU})
    EXPECT_EQ(heat(cold), 0);
  EXPECT_LT(heat(0x801000FF), 0.5 * heat(0xFF2000FF)) << "an ember that dies";
  EXPECT_NEAR(heat(0xE69F0080), heat(0xE69F00FF) / 2, 0.01);
}

TEST(Glow, IsBrightestWhereTheLightIsAndFadesAllAround) {
  Camera camera;
  camera.set_viewport(900, 700);
  const Vec3d at = camera.target;
  const Pixel seen = camera.project(at).value();
  const GlowMap map = glow_of(camera, {{at, at, 0xE69F00FF, 6}});
  ASSERT_GT(map.columns, 0);
  const int most = red_at(map, seen.x, seen.y);
  EXPECT_EQ(most, *std::ranges::max_element(map.light));
  EXPECT_GT(most, 20);
  for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}}) {
    int last = most;
    for (const double far : {8.0, 16.0, 30.0}) {
      const int here = red_at(map, seen.x + x * far, seen.y + y * far);
      EXPECT_LT(here, last) << far << " pixels away";
      last = here;
    }
    EXPECT_EQ(red_at(map, seen.x + 200 * x, seen.y + 200 * y), 0);
  }
}

TEST(Glow, MoreLightsAreBrighterInAnyOrder) {
  Camera camera;
  camera.set_viewport(900, 700);
  const Light a{camera.target, camera.target, 0xE69F00FF, 6}, b{a.from + Vec3d{0.3, 0, 0}, a.from, 0xD55E00FF, 4};
  const Pixel seen = camera.project(camera.target).value();
  EXPECT_GT(red_at(glow_of(camera, {a, b}), seen.x, seen.y), red_at(glow_of(camera, {a}), seen.x, seen.y));
  EXPECT_EQ(glow_of(camera, {a, b, b}).light, glow_of(camera, {b, a, b}).light);
}

TEST(Glow, WhatIsColdOrBehindTheEyeHasNone) {
  Camera camera;
  camera.set_viewport(900, 700);
  const Vec3d at = camera.target, behind = camera.eye() - camera.forward() * 5.0;
  EXPECT_EQ(glow_of(camera, {{at, at, 0x0072B2FF, 6}}).columns, 0);
  EXPECT_EQ(glow_of(camera, {{behind, behind, 0xE69F00FF, 6}}).columns, 0);
}

/// A wall two metres wide and high across the view, so far before the camera's target; in front of the eye it is
/// turned by 45 degrees.
Scenery wall_before(const Camera& camera, double before) {
  Scenery out{.origin = camera.target - camera.forward() * before};
  const Vec3d right = camera.right() + camera.forward(), up = camera.up();
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}})
    out.vertices.push_back(lit_vertex(right * x + up * y, {0, 0, 1}, 0x808080FF));
  out.solid = out.vertices.size();
  return out;
}

TEST(Glow, WhatAThingHidesHasNone) {
  Camera camera;
  camera.set_viewport(900, 700);
  const Vec3d at = camera.target, aside = at + camera.right() * 3.0;
  const auto columns = [&](const Vec3d& from, const Vec3d& to, const Scenery& scenery) {
    GlowMaker maker(camera, 1, 1e9, &scenery);
    maker.add({from, to, 0xE69F00FF, 6});
    GlowMap map;
    maker.make(map);
    return map.columns;
  };
  const int free = columns(at, at, Scenery{});
  ASSERT_GT(free, 0);
  EXPECT_EQ(columns(at, at, wall_before(camera, 1)), 0) << "behind it";
  EXPECT_EQ(columns(at, at, wall_before(camera, -1)), free) << "before it";
  for (const double along : {-0.9, -0.3, 0.0, 0.4, 0.8}) {
    const Vec3d on_it = at + (camera.right() + camera.forward()) * along;
    EXPECT_GT(columns(on_it, on_it, wall_before(camera, 0)), 0) << "on it, " << along;
  }
  EXPECT_GT(columns(aside, aside, wall_before(camera, 1)), 0) << "beside it";
  const int whole = columns(at, aside, Scenery{}), rest = columns(at, aside, wall_before(camera, 1));
  EXPECT_GT(rest, 0) << "a streak that comes out behind it";
  EXPECT_LT(rest, whole);
  Scenery sensor = wall_before(camera, 1);
  sensor.solid = 0;
  EXPECT_EQ(columns(at, at, sensor), free) << "sensors are seen through";
}

/// Rounds hit its wall from in front; from behind it they are hidden.
TEST(Glow, SparksBehindAWallDoNotShineThroughIt) {
  Client client = client_of("emit_machine_gun");
  const Scene scene = shown_after(client, "seek 1.5; wait 3");
  const auto of_sparks = [&] {
    GlowMap map;
    GlowMaker maker(client.camera, 1, 1e9, scene.scenery);
    for (const Light& light : scene.lights)
      if (light.to.x > 90) maker.add(light);
    maker.make(map);
    return map.columns == 0 ? 0 : static_cast<int>(*std::ranges::max_element(map.light));
  };
  EXPECT_GT(of_sparks(), 20);
  client.camera.target = {100, 3, 0}, client.camera.yaw = std::numbers::pi, client.camera.pitch = 0.05;
  client.camera.distance = 20;
  const int behind = of_sparks();
  client.camera.yaw = 0;
  EXPECT_LT(behind, of_sparks() / 2);
}

TEST(Glow, SparksShineButForOnWhite) {
  for (const std::string theme : {"day", "dusk", "night", "chart"}) {
    Client client = client_of("world_sparks");
    const Scene scene = shown_after(client, "theme " + theme + "; wait 40");
    EXPECT_EQ(scene.glow.columns > 0, theme != "chart") << theme;
  }
}

/// The picture of the machine gun by script.
TEST(Glow, ATracerIsAStreakOfLight) {
  Client client = client_of("emit_machine_gun");
  const Scene scene = shown_after(client, "seek 1.96; wait 3");
  const auto is_tracer = [](const Light& light) { return length(light.to - light.from) > 20; };
  EXPECT_EQ(std::ranges::count_if(scene.lights, is_tracer), 1);
}

}  // namespace
}  // namespace physim::client
