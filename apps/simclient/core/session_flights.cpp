// Flights that were computed whole, played in a session out of their dense output.
#include <algorithm>
#include <cmath>

#include "math/angles.hpp"
#include "simclient/core/session.hpp"
#include "simclient/core/thinning.hpp"

namespace physim::client {
namespace {

constexpr std::uint32_t kNoSlot = 0xFFFFFFFF;  // of the world: ids of played flights name nothing in it

/// Up to an age [s]: its trail, what happened on the way, and whether it has ended.
void follow(Track& track, double age) {
  const Flight& flight = *track.whole;
  const double now = std::clamp(age, 0.0, flight.duration());
  // The last one is where it was drawn, between two samples of the path.
  while (track.samples.size() > 1 && track.samples.size() > track.passed) track.samples.pop_back();
  for (; track.passed < track.path->size() && (*track.path)[track.passed].time <= now; ++track.passed)
    track.samples.push_back((*track.path)[track.passed]);
  if (now > track.samples.back().time) track.samples.push_back(sample_of(flight, now));
  for (const Event& event : flight.events())
    if (event.kind == EventKind::apex && event.time <= now && !track.apex) track.apex = sample_of(flight, event.time);
  if (age < flight.duration()) return;
  const bool has_landed = flight.outcome() == Outcome::landed;
  if (has_landed) track.impact = sample_of(flight, flight.duration());
  track.status = has_landed ? LifeStatus::landed : LifeStatus::expired;
}

}  // namespace

Result<ProjectileId> Session::play(const ScenarioShot& shot, const Flight& flight) {
  if (is_replay()) return cannot_change();
  if (flight.error()) return *flight.error();
  begin_change();
  Track track;
  track.id = {kNoSlot, static_cast<std::uint32_t>(++by_hand_)};
  track.by_hand = true;
  track.shot = std::make_shared<const ScenarioShot>(shot);
  track.name = shot.projectile.name;
  track.colour = shot.body.colour != kNoColour ? shot.body.colour : palette(fired_);
  track.radius = shot.projectile.diameter / 2;
  track.look = look_of(shot.projectile);
  track.spin = spin_in_world(shot.launch);
  track.born = world().time();
  track.granted = flight.fidelity_in_use();
  track.whole = std::make_shared<const Flight>(flight);
  track.path = std::make_shared<const std::vector<TrackSample>>(samples_of(flight));
  if (const MotorDef& motor = shot.projectile.motor; !motor.thrust.empty())
    track.burnout = motor.ignition_delay + burn_time(motor);
  track.samples.push_back(track.path->front());
  const ProjectileId id = track.id;
  add_track(std::move(track));
  return id;
}

void Session::follow_flights() {
  for (Track& track : tracks_)
    if (track.whole && track.is_flying()) follow(track, world().time() - track.born);
}

bool Session::is_whole(ProjectileId id) const {
  const Track* found = track(id);
  return found != nullptr && found->whole != nullptr;
}

namespace {

/// Nose along the path; of a ball, as it has spun since its launch.
Quatd attitude_of(const Track& track, const Vec3d& velocity, double age) {
  const double rate = length(track.spin);
  return rate > 0 ? turn_about(track.spin * (1 / rate), std::remainder(rate * age, 4 * kPi)) : nose_along(velocity);
}

double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

}  // namespace

Session::Shown Session::shown(const Track& track) const {
  const bool flies_attitude = turns(track.granted.fidelity);
  const double age = world().time() + leftover_ - track.born;
  Shown out;
  if (!track.whole) {
    const ProjectileView projectile = world()[track.id];
    out = {shown_position(track.id), projectile.velocity(), projectile.accelerations(), projectile.mass(), {}, 0};
    const Quatd own = projectile.orientation();
    const bool has_turned = flies_attitude || !(own == Quatd{});  // or rolls
    out.attitude = has_turned ? own : attitude_of(track, out.velocity, age);
  } else {
    const Sample at = track.whole->at(age);
    out = {at.position, at.velocity, track.whole->accelerations(at.time), at.mass, {}, 0};
    out.attitude = flies_attitude ? at.orientation : attitude_of(track, at.velocity, age);
  }
  if (flies_attitude && length(out.velocity) > 0)
    out.yaw = angle_between(rotate(out.attitude, Vec3d{1, 0, 0}), out.velocity);
  return out;
}

std::size_t Session::in_flight() const {
  const auto played =
      std::ranges::count_if(tracks_, [](const Track& track) { return track.whole && track.is_flying(); });
  return world().size() + static_cast<std::size_t>(played);
}

}  // namespace physim::client
