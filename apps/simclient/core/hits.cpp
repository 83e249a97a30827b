#include "simclient/core/hits.hpp"

#include <algorithm>
#include <vector>

#include "collide/seen_hit.hpp"
#include "math/angles.hpp"

namespace physim::client {
namespace {

/// At the same place, of the same shape and material.
bool is_same(const ScenarioThing& a, const ScenarioThing& b) {
  const Quatd turn = a.rotation.quaternion(), other = b.rotation.quaternion();
  return a.name == b.name && a.shape == b.shape && a.material == b.material && a.position == b.position &&
         a.scale == b.scale && rotate(turn, Vec3d{1, 0, 0}) == rotate(other, Vec3d{1, 0, 0}) &&
         rotate(turn, Vec3d{0, 1, 0}) == rotate(other, Vec3d{0, 1, 0});
}

/// What an event says about a thing.
Hit hit_of(const World& world, const physim::Scene& scene, const Event& event) {
  Hit hit;
  hit.id = event.id;
  hit.instance = event.instance;
  hit.primitive = event.primitive;
  hit.time = event.time;
  hit.position = event.position;
  hit.velocity = hit.after = event.velocity;
  hit.material = scene.material(event.material).name;
  const ProjectileView projectile = world[event.id];
  hit.colour = projectile.colour();
  if (const ProjectileDef* what = projectile.definition()) hit.shot = what->name, hit.radius = what->diameter / 2;
  const auto thing = scene.instance(event.instance);
  const auto state = scene.state(event.instance, event.time);
  if (!thing || !state) return hit;
  hit.thing = thing->name;
  const Quatd back = conjugate(state->rotation);
  // The event of a ball tells where its middle is.
  const SceneNearest nearest = scene.nearest(event.position, 4 * hit.radius, {}, event.time);
  const Vec3d surface = nearest && nearest.instance == event.instance ? nearest.position : event.position;
  hit.at = hit.end = rotate(back, surface - state->position);
  hit.normal = rotate(back, event.normal);
  hit.surface_velocity = velocity_at(*state, surface);
  hit.obliquity = obliquity_of(event.velocity - hit.surface_velocity, event.normal);
  if (event.kind == EventKind::left) hit.obliquity = kPi - hit.obliquity;  // it goes outwards
  return hit;
}

/// What became of a hit.
void complete(Hit& hit, const physim::Scene& scene, const Event& event) {
  hit.outcome = event.kind;
  hit.after = event.kind == EventKind::stopped ? Vec3d{} : event.velocity;
  hit.energy = event.energy;
  if (event.kind == EventKind::penetrated || event.kind == EventKind::stopped) hit.depth = event.value;
  if (event.kind != EventKind::penetrated && event.kind != EventKind::stopped) return;
  if (const auto state = scene.state(event.instance, event.time))
    hit.end = rotate(conjugate(state->rotation), event.position - state->position);
}

}  // namespace

double Hit::speed() const { return length(velocity - surface_velocity); }
double Hit::speed_after() const { return outcome == EventKind::stopped ? 0 : length(after - surface_velocity); }

Vec3d place_in_world(const MotionState& thing, const Vec3d& at) { return thing.position + rotate(thing.rotation, at); }

bool is_passed(const Hit& hit) {
  return hit.outcome == EventKind::entered || hit.outcome == EventKind::left || hit.outcome == EventKind::sensed;
}

void HitLog::look_at(const World& world, std::span<const Event> events) {
  const physim::Scene* scene = world.scene();
  if (scene == nullptr) return;
  std::vector<Hit> open;  // of this step
  for (const Event& event : events) {
    if (!event.instance) continue;
    const bool is_outcome = event.kind == EventKind::bounced || event.kind == EventKind::ricocheted ||
                            event.kind == EventKind::penetrated || event.kind == EventKind::stopped;
    if (!is_outcome) {
      open.push_back(hit_of(world, *scene, event));
      // A projectile that stays where it struck, or ends there, has no other event.
      const bool ends = event.reason == Reason::inside || world[event.id].status() == LifeStatus::landed;
      if (event.kind != EventKind::hit)
        open.back().outcome = event.kind;
      else if (ends)
        open.back().outcome = EventKind::stopped, open.back().after = {};
      continue;
    }
    const auto is_its = [&](const Hit& hit) {
      const bool is_open = hit.outcome == EventKind::hit || hit.outcome == EventKind::stopped;
      // Parts that are met at one time are all told before what became of the first of them.
      return hit.id == event.id && hit.instance == event.instance && hit.primitive == event.primitive &&
             hit.time >= event.time && is_open;
    };
    const auto hit = std::ranges::find_if(open, is_its);
    if (hit != open.end()) complete(*hit, *scene, event);
  }
  for (Hit& hit : open)
    if (hit.outcome != EventKind::hit) add(std::move(hit));
}

void HitLog::add(Hit hit) {
  if (hits_.size() >= kMost) hits_.pop_front();
  hits_.push_back(std::move(hit));
  ++count_;
}

void HitLog::forget_after(double time) {
  const std::size_t before = hits_.size();
  std::erase_if(hits_, [time](const Hit& hit) { return hit.time > time; });
  count_ -= before - hits_.size();
  std::erase_if(gone_, [time](const Gone& each) { return each.hit.time > time; });
}

void HitLog::change_things(const std::vector<ScenarioThing>& before, const std::vector<ScenarioThing>& after) {
  std::vector<Gone> all = std::move(gone_);
  gone_.clear();
  for (Hit& hit : hits_) {
    const auto thing = std::ranges::find(before, hit.thing, &ScenarioThing::name);
    if (thing != before.end()) all.push_back({std::move(hit), *thing});
  }
  hits_.clear();
  for (Gone& each : all) {
    const bool stands =
        std::ranges::any_of(after, [&](const ScenarioThing& thing) { return is_same(thing, each.thing); });
    if (stands)
      hits_.push_back(std::move(each.hit));
    else
      gone_.push_back(std::move(each));
  }
  std::ranges::stable_sort(hits_, {}, &Hit::time);
}

const Hit* HitLog::last_of(ProjectileId id) const {
  const Hit* last = nullptr;
  const auto look = [&](const Hit& hit) {
    if (hit.id == id && (last == nullptr || hit.time >= last->time)) last = &hit;
  };
  for (const Gone& each : gone_) look(each.hit);
  for (const Hit& hit : hits_) look(hit);
  return last;
}

}  // namespace physim::client
