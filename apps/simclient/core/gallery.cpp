#include "simclient/core/gallery.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "scenario/suggest.hpp"
#include "simclient/core/folder.hpp"
#include "simclient/core/original_tests.hpp"
#include "simclient/core/subject.hpp"
#include "simclient/core/thinning.hpp"

namespace physim::client {
namespace {

constexpr GalleryItem kShooters[] = {
    {"308_168gr_g7", "Rifle bullet to 1000 m"},
    {"308_168gr_published", "Rifle in a quartering wind"},
    {"308_168gr_six_dof", "Bullet that leaves with a yaw"},
    {"22lr", "A .22 to 600 yards"},
    {"arrow", "Olympic arrow at 70 m"},
    {"105mm_m1_six_dof", "Howitzer shell and its yaw"},
    {"lob_16km", "A lob to 16 km"},
    {"mortar_over_hill", "Mortar behind a hill"},
    {"aim_moving_target", "A shell led onto a ship"},
    {"bullet_through_plank", "Through a plank into a wall"},
    {"house_of_wood", "Three bullets and a house"},
    {"ricochet_on_water", "Round shot skips on the sea"},
    {"emit_machine_gun", "Twin machine gun with tracers"},
    {"emit_shotgun", "Shotgun patterns of two chokes"},
    {"world_machine_gun", "300 rounds on a wall"},
    {"study_308", "Will it hit at 600 m?"},
};
constexpr GalleryItem kSport[] = {
    {"golf_drive", "Golf drive with backspin"},
    {"golf_ball_no_spin", "Golf ball without spin"},
    {"free_kick", "Free kick round the wall"},
    {"study_free_kick", "How likely is the goal?"},
    {"curve_ball", "A curve ball"},
    {"baseball_no_spin", "Fly ball without spin"},
    {"table_tennis", "Loop, flat ball and chop"},
    {"tennis_ball", "Tennis: serve and lob"},
    {"use_free_throw", "Free throw, least speed"},
    {"study_free_throw", "Does the throw drop through?"},
    {"shot_put", "Shot put: what the air costs"},
};
constexpr GalleryItem kRocketeers[] = {
    {"model_rocket", "Model rocket on a C6 motor"},
    {"study_model_rocket", "Where the rocket comes down"},
    {"sounding_rocket", "Sounding rocket to 100 km"},
    {"low_orbit", "One revolution at 400 km"},
    {"intercontinental_lob", "A lob to another continent"},
    {"use_reentry", "A tank comes back from orbit"},
    {"use_firework", "How long must the fuse burn?"},
    {"nesc_case01", "NASA 1: sphere, no drag"},
    {"nesc_case02", "NASA 2: a brick that tumbles"},
    {"nesc_case03", "NASA 3: the brick, damped"},
    {"nesc_case04", "NASA 4: round Earth at rest"},
    {"nesc_case05", "NASA 5: round Earth that turns"},
    {"nesc_case06", "NASA 6: sphere with drag"},
    {"nesc_case07", "NASA 7: steady wind"},
    {"nesc_case08", "NASA 8: wind by height"},
    {"nesc_case09", "NASA 9: thrown up and east"},
    {"nesc_case10", "NASA 10: thrown up and north"},
};
constexpr GalleryItem kTeachers[] = {
    {"cannonball_galileo", "Galileo: iron and wood"},
    {"reich_1831", "1831: the Earth turns"},
    {"newtons_cradle", "Newton's cradle"},
    {"billiards", "Balls on a billiard table"},
    {"joint_pendulums", "Pendulum, spring and cable"},
    {"laser", "A pulse of light"},
    {"world_mixed_fidelities", "One bullet on every rung"},
    {"use_car_over_edge", "How fast was the car?"},
    {"use_hail", "How fast hail falls"},
    {"study_hail", "Hail on a greenhouse"},
    {"use_spray", "Spray drifts with the wind"},
    {"emit_rain", "Rain, 5 mm an hour"},
};
constexpr GalleryItem kDesigners[] = {
    {"emit_fireworks", "Fireworks that burst twice"},
    {"emit_fountain", "Fountain of 1600 drops"},
    {"emit_volcano", "Volcano with its bombs"},
    {"emit_embers", "Embers and smoke"},
    {"emit_spiral", "Bullet-hell spiral"},
    {"arcade_space", "Arcade space"},
    {"world_force_field", "Wind zone, attractor, explosion"},
    {"world_sparks", "6000 sparks"},
    {"world_bouncing_balls", "Balls bounce and sleep"},
    {"world_originals", "The presets side by side"},
};
constexpr GalleryItem kOriginal[] = {
    {"original_artillery", "Artillery"},
    {"original_bullet", "Bullet"},
    {"original_laser", "Laser"},
    {"original_test_1", "Test 1: bullet, constants"},
    {"original_test_2", "Test 2: level bullet"},
    {"original_test_3", "Test 3: bullet, forces"},
    {"original_test_3_drag", "Test 3 as it was meant"},
    {"original_test_4", "Test 4: laser"},
    {"original_test_5", "Test 5: shell, constants"},
    {"original_test_6", "Test 6: shell, forces"},
    {"original_test_6_drag", "Test 6 as it was meant"},
};
constexpr GalleryGroup kGroups[] = {{"Shooters", "bullets, arrows, shells, and what they hit", kShooters},
                                    {"Sport", "balls that spin, bounce and fly far", kSport},
                                    {"Rocketeers", "motors, orbits, and NASA's check-cases", kRocketeers},
                                    {"Teachers", "one law at a time", kTeachers},
                                    {"Game designers", "emitters, crowds, invented physics", kDesigners},
                                    {"The original", "PhySim of 2017: its shots and its tests", kOriginal}};

std::string file_of(std::string_view scenario) { return shipped_scenario(std::string(scenario) + ".toml"); }

/// Plays what flies by itself: as far as some steps of projectiles go, and no further than most of its run.
void play_on(Client& client) {
  constexpr double kFrame = 1.0 / 60, kPart = 0.6;                // of the run
  constexpr std::uint64_t kMostWork = 60'000, kMostFrames = 900;  // steps of projectiles
  const Scenario& scenario = client.session.scenario();
  const double end = kPart * scenario.world.duration;
  for (std::uint64_t i = 0;
       i < kMostFrames && client.session.time() < end && client.session.world().counters().projectile_steps < kMostWork;
       ++i)
    client.advance(kFrame);
}

}  // namespace

std::span<const GalleryGroup> gallery() { return kGroups; }

const GalleryItem* find_in_gallery(std::string_view scenario) {
  for (const GalleryGroup& group : kGroups)
    for (const GalleryItem& item : group.items)
      if (item.scenario == scenario) return &item;
  return nullptr;
}

std::vector<const GalleryItem*> gallery_items(std::string_view group, std::string_view filter) {
  std::vector<const GalleryItem*> items;
  for (const GalleryGroup& each : kGroups)
    for (const GalleryItem& item : each.items) {
      const std::string all = std::string(item.scenario) + " " + std::string(item.title) + " " + std::string(each.name);
      if ((group.empty() || group == each.name) && passes_filter(all, filter)) items.push_back(&item);
    }
  return items;
}

Status open_from_gallery(Client& client, const std::string& scenario) {
  const GalleryItem* item = find_in_gallery(scenario);
  if (item == nullptr) {
    std::vector<std::string_view> names;
    for (const GalleryItem* each : gallery_items("", "")) names.push_back(each->scenario);
    return Error{"the gallery has no scenario " + in_quotes(scenario), "gallery",
                 suggestion(scenario, names, "scenarios")};
  }
  if (Status status = client.open(file_of(item->scenario)); !status) return status;
  const bool flies_by_itself = client.session.scenario().world.given;
  return flies_by_itself || client.session.scenario().shots.empty() ? Status() : client.fire_by_hand();
}

Result<Pose> pose_of(std::string_view scenario, int width, int height) {
  PHYSIM_ASSERT(width > 0 && height > 0);
  constexpr std::size_t kMostShots = 6;
  Result<Client> opened = open_client(file_of(scenario), {});
  if (!opened) return opened.error();
  Pose pose{std::move(*opened), {}};
  Client& client = pose.client;
  client.show.aim = client.show.marks = false;
  client.camera.set_viewport(width, height);
  client.fit_view();
  const Scenario& own = client.session.scenario();
  if (own.world.given) {
    play_on(client);
  } else {
    for (const ScenarioShot& shot : own.shots) {
      if (pose.paths.size() >= kMostShots) break;
      const Flight flight = fly_shot(own, shot);
      if (!flight.error()) pose.paths.push_back(samples_of(flight));
    }
  }
  client.keep_view();
  if (client.scenery().is_empty()) return pose;
  std::vector<Vec3d> places;  // what things stop is not all that is shown
  for (const auto& path : pose.paths)
    for (const TrackSample& s : path) places.push_back(s.position);
  if (!places.empty()) client.camera.fit(subject_of(std::move(places), client.scenery(), client.session.ground()));
  return pose;
}

}  // namespace physim::client
