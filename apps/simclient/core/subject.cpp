#include "simclient/core/subject.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/assert.hpp"
#include "scenario/world_run.hpp"
#include "simclient/core/thinning.hpp"

namespace physim::client {
namespace {

struct Extent3 {
  Vec3d low, high;
  [[nodiscard]] double diagonal() const { return length(high - low); }
  [[nodiscard]] bool holds(const Vec3d& p) const {
    return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
  }
};

Extent3 extent_of(const std::vector<Vec3d>& places) {
  PHYSIM_ASSERT(!places.empty());
  Extent3 all{places[0], places[0]};
  for (const Vec3d& p : places) {
    all.low = {std::min(all.low.x, p.x), std::min(all.low.y, p.y), std::min(all.low.z, p.z)};
    all.high = {std::max(all.high.x, p.x), std::max(all.high.y, p.y), std::max(all.high.z, p.z)};
  }
  return all;
}

/// Removes the few places at the rims of a crowd.
void leave_out_strays(std::vector<Vec3d>& places) {
  constexpr std::size_t kCrowd = 1000;
  constexpr double kPart = 0.01;  // at each end of each axis
  if (places.size() < kCrowd) return;
  Extent3 most;
  for (double Vec3d::*axis : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
    std::vector<double> along;
    for (const Vec3d& p : places) along.push_back(p.*axis);
    std::ranges::sort(along);
    const auto stray = static_cast<std::size_t>(kPart * static_cast<double>(along.size()));
    most.low.*axis = along[stray], most.high.*axis = along[along.size() - 1 - stray];
  }
  std::erase_if(places, [&](const Vec3d& p) { return !most.holds(p); });
}

/// No more than a picture needs; the last stays.
void thin_out(std::vector<Vec3d>& places) {
  constexpr std::size_t kMost = 600;
  const std::size_t stride = places.size() / kMost + 1;
  const Vec3d last = places.back();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); i += stride) places[kept++] = places[i];
  places.resize(kept);
  places.push_back(last);
}

void add_corners(const Extent3& box, std::vector<Vec3d>& places) {
  for (int i = 0; i < 8; ++i)
    places.push_back({(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                      (i & 4) != 0 ? box.high.z : box.low.z});
}

}  // namespace

std::vector<Vec3d> places_of_run(const Scenario& scenario) {
  constexpr std::uint64_t kMostSteps = 20'000, kMostWork = 200'000, kLooks = 120;
  constexpr std::size_t kMostOfLook = 64;
  std::vector<Vec3d> places;
  const bool fires = !scenario.shots.empty() || !scenario.volleys.empty() || !scenario.emitters.empty();
  if (!scenario.world.given || !fires) return places;
  Result<WorldRun> run = WorldRun::create(scenario);
  if (!run) return places;
  const World& world = run->world();
  const std::uint64_t steps = std::min(run->steps(), kMostSteps), every = std::max<std::uint64_t>(steps / kLooks, 1);
  for (std::uint64_t i = 0; i < steps && world.counters().projectile_steps < kMostWork; ++i) {
    if (i % every == 0) {
      const std::vector<ProjectileId> ids = world.ids();
      const std::size_t stride = ids.size() / kMostOfLook + 1;
      for (std::size_t k = 0; k < ids.size(); k += stride) places.push_back(world[ids[k]].position());
    }
    run->step();
  }
  leave_out_strays(places);
  return places;
}

bool has_end(const Flight& whole, const Until& until) {
  return whole.outcome() == Outcome::landed || until.time != Until{}.time || until.range;
}

std::vector<Vec3d> places_of_flight(const Scenario& scenario, const ScenarioShot& shot, const Foreseen& foreseen) {
  constexpr double kOpenEnd = 10;  // of flights that go on and on [s]
  constexpr std::size_t kMostOthers = 6;
  std::vector<Vec3d> places;
  const auto add = [&](const std::vector<TrackSample>& path, double end) {
    for (const TrackSample& s : path)
      if (s.time <= end) places.push_back(s.position);
  };
  const auto add_whole = [&](const Flight& whole) {
    if (!whole.error()) add(samples_of(whole), has_end(whole, scenario.until) ? whole.duration() : kOpenEnd);
  };
  const bool is_single = !scenario.world.given && scenario.things.empty() && !scenario.shots.empty();
  const double wanted = scenario.world.given ? scenario.world.duration : scenario.until.time;
  add(foreseen.path, is_single && foreseen.is_cut ? kOpenEnd : wanted);
  std::size_t others = 0;
  for (const ScenarioShot& other : scenario.shots)
    if (is_single && other.projectile.name != shot.projectile.name && ++others <= kMostOthers)
      add_whole(fly_shot(scenario, other));
  return places;
}

double height_over_length(const std::vector<Vec3d>& places) {
  if (places.empty()) return 0;
  const Extent3 all = extent_of(places);
  const Vec3d size = all.high - all.low;
  return size.y / std::max(std::hypot(size.x, size.z), 1e-9);
}

std::optional<double> long_side_of(const std::vector<Vec3d>& places) {
  constexpr double kMuchLonger = 4;  // of the variance
  if (places.empty()) return std::nullopt;
  const auto count = static_cast<double>(places.size());
  double x = 0, z = 0, xx = 0, xz = 0, zz = 0;
  for (const Vec3d& p : places) x += p.x / count, z += p.z / count;
  for (const Vec3d& p : places)
    xx += (p.x - x) * (p.x - x) / count, xz += (p.x - x) * (p.z - z) / count, zz += (p.z - z) * (p.z - z) / count;
  const double mean = (xx + zz) / 2, apart = std::hypot((xx - zz) / 2, xz);
  if (!(apart > 0) || mean + apart < kMuchLonger * (mean - apart)) return std::nullopt;
  const double angle = 0.5 * std::atan2(2 * xz, xx - zz);
  return angle;
}

std::vector<Vec3d> subject_of(std::vector<Vec3d> places, const Scenery& things, std::optional<double> ground) {
  constexpr double kMuchLarger = 3, kFar = 8;
  if (!places.empty()) thin_out(places);
  const double of_places = places.empty() ? 0 : extent_of(places).diagonal();
  if (things.has_size) {
    const Extent3 box{things.low, things.high};
    const double of_things = box.diagonal();
    if (of_things > 0 && of_places > kFar * of_things) {  // what happens there is what it is about
      const Vec3d about{of_things, of_things, of_things};
      const Extent3 near{box.low - about, box.high + about};
      std::vector<Vec3d> there = places;
      std::erase_if(there, [&](const Vec3d& p) { return !near.holds(p); });
      if (!there.empty()) places = std::move(there);
    }
    // Things that are much larger than all flights are looked at from among them.
    if (of_things < kMuchLarger * of_places || of_places < 1e-3) add_corners(box, places);
  }
  if (places.empty()) return places;
  const Extent3 all = extent_of(places);
  const bool is_near = ground && std::abs(all.low.y - *ground) < std::max(all.diagonal(), 1.0);
  if (is_near)
    for (const double x : {all.low.x, all.high.x}) places.push_back({x, *ground, std::midpoint(all.low.z, all.high.z)});
  return places;
}

}  // namespace physim::client
