#include "world/core/emitter_lead.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "math/quat.hpp"
#include "math/vec3.hpp"
#include "world/core/step_way.hpp"

namespace physim {
namespace {

bool is_key(const MotionKey& key) {
  const bool is_finite = std::isfinite(key.time) && std::isfinite(length(key.position));
  return is_finite && std::abs(norm(key.rotation) - 1) < 1e-9;
}

}  // namespace

double EmitterLead::Leg::length() const { return physim::length(to.position - from.position); }

double EmitterLead::Leg::counted(double counted_from, double until) const {
  const double first = std::clamp(counted_from, from.time, to.time), last = std::clamp(until, first, to.time);
  if (first == from.time && last == to.time) return length();
  return length() * ((last - first) / (to.time - from.time));
}

void EmitterLead::go(const MotionKey& here, const MotionKey& to) {
  const MotionKey& from = empty() ? here : legs_.back().to;
  PHYSIM_ASSERT(to.time - from.time >= kShortestLeg);
  StepWay way(from);
  way.go_straight(to);
  legs_.push_back({from, to, std::make_shared<const collide::Path>(way.path())});
}

MotionState EmitterLead::at(double time) const {
  PHYSIM_ASSERT(!empty());
  for (const Leg& leg : legs_)
    if (time <= leg.to.time) return leg.path->at(std::max(time, leg.from.time));
  return {.position = end().position, .rotation = end().rotation};
}

std::optional<double> EmitterLead::when(double distance, double travelled, double counted_from, double latest) const {
  for (const Leg& leg : legs_) {
    const double all = leg.counted(counted_from, leg.to.time);
    if (distance > travelled + all) {
      travelled += all;
      continue;
    }
    const double first = std::clamp(counted_from, leg.from.time, leg.to.time), left = distance - travelled;
    double time = first;
    if (left > 0) time = std::min(first + left * (leg.to.time - leg.from.time) / leg.length(), leg.to.time);
    return time <= latest ? std::optional(time) : std::nullopt;
  }
  return std::nullopt;
}

void EmitterLead::pass(double now, double counted_from, double& travelled) {
  const auto left = std::ranges::find_if(legs_, [now](const Leg& leg) { return leg.to.time > now; });
  for (auto leg = legs_.begin(); leg != left; ++leg) travelled += leg->counted(counted_from, leg->to.time);
  legs_.erase(legs_.begin(), left);
}

double EmitterLead::counted(double counted_from, double now) const {
  double sum = 0;
  for (const Leg& leg : legs_) sum += leg.counted(counted_from, std::max(now, leg.from.time));
  return sum;
}

void EmitterLead::stop(double now, double counted_from, double& travelled) {
  travelled += counted(counted_from, now);
  legs_.clear();
}

std::vector<MotionKey> EmitterLead::keys() const {
  std::vector<MotionKey> keys;
  if (!empty()) keys.push_back(legs_.front().from);
  for (const Leg& leg : legs_) keys.push_back(leg.to);
  return keys;
}

bool EmitterLead::restore(std::span<const MotionKey> keys) {
  legs_.clear();
  if (keys.empty()) return true;
  if (keys.size() == 1 || !is_key(keys[0])) return false;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (!is_key(keys[i]) || !(keys[i].time - keys[i - 1].time >= kShortestLeg)) return false;
    go(keys[i - 1], keys[i]);
  }
  return true;
}

}  // namespace physim
