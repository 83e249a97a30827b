// [[joint]] of a scenario: what its tables cannot say about themselves, and how a run's world gets them.
#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

#include "base/assert.hpp"
#include "base/joint_table.hpp"
#include "math/quat.hpp"
#include "scenario/checks.hpp"
#include "scenario/scene_maker.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/world_run_impl.hpp"
#include "world/core/joints.hpp"

namespace physim {
namespace {

/// What the library says of a joint; its ends are any ones.
Status check_def(const ScenarioJoint& joint, const Value& table) {
  Joint def = joint.def;
  def.a = {1, 1};
  if (!joint.b.empty()) def.b = {2, 1};
  if (!joint.thing.empty()) def.thing = {1, 1};
  const Status status = check(def);
  if (status) return {};
  const Error& error = status.error();
  const std::string key = error.place.substr(error.place.find('.') + 1);
  return Error{error.place + ": " + error.message, place_of(table, key), error.hint};
}

Status check_joint(const ScenarioNames& names, const ScenarioJoint& joint, const Value& table) {
  if (Status status = check_lone_shot(names, joint.a, "joint.a", place_of(table, "a")); !status) return status;
  if (!joint.b.empty())
    if (Status status = check_lone_shot(names, joint.b, "joint.b", place_of(table, "b")); !status) return status;
  if (joint.a == joint.b) return error_at(table, "joint.b", "is joint.a too", "a joint holds two different shots");
  if (!joint.b.empty() && table.find("point"))
    return error_at(table, "joint.point", "given together with b", "give one of them");
  if (!joint.thing.empty())
    if (Status status = check_named(names.things, joint.thing, "thing", "joint.thing", place_of(table, "thing"));
        !status)
      return status;
  PHYSIM_ASSERT(!joint.a.empty());  // a required key
  return check_def(joint, table);
}

/// Where the point of a joint is at the start, and how its axis is turned.
MotionState point_at_start(const Scenario& scenario, const ScenarioNames& names, const ScenarioJoint& joint) {
  if (joint.thing.empty()) return {.position = joint.def.point};
  const ScenarioThing& thing = scenario.things[*names.things.find(joint.thing)];
  Scene scene;
  const auto shape = scene.add_shape(SphereShape{});
  const auto id = scene.add({.shape = *shape,
                             .transform = {thing.position, thing.rotation.quaternion(), thing.scale},
                             .motion = motion_of(thing)});
  MotionState at = id ? *scene.state(*id) : MotionState{};  // a scene that cannot be made is refused elsewhere
  at.position += rotate(at.rotation, joint.def.point * thing.scale);
  return at;
}

/// Joints as a net: its knots are shots and points of the world, and a rod or cable lets two of them be so far apart.
class JointNet {
 public:
  explicit JointNet(const Scenario& scenario) : scenario_(scenario), names_(scenario) {
    for (const ScenarioJoint& joint : scenario.joints) {
      const MotionState point = point_at_start(scenario, names_, joint);
      const bool moves = !joint.thing.empty() || joint.def.velocity != Vec3d{};
      Held held{.a = knot_of_shot(joint.a),
                .b = !joint.b.empty() ? knot_of_shot(joint.b)
                     : moves          ? add(point.position, false)
                                      : knot_of_point(point.position)};
      Vec3d between = places_[held.a] - places_[held.b];
      const JointRow& kind = row_of(joint.def.kind);
      if (kind.turns || kind.slides) {
        const Vec3d axis = rotate(point.rotation, normalized(joint.def.axis)), along = axis * dot(axis, between);
        held.beside = kind.slides ? length(between - along) : joint.b.empty() ? 0 : length(along);
        if (kind.turns) between -= along;
      }
      held.launched = length(between);
      held.length = joint.def.length.value_or(held.launched);
      if (row_of(joint.def.kind).pulls) {
        held_by_[held.a].push_back(joints_.size());
        held_by_[held.b].push_back(joints_.size());
      }
      joints_.push_back(held);
    }
  }

  [[nodiscard]] std::vector<JointRemark> remarks() const {
    std::vector<JointRemark> all;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const Held& held = joints_[i];
      PHYSIM_ASSERT(held.a < places_.size() && held.b < places_.size());
      const JointKind kind = scenario_.joints[i].def.kind;
      const std::string said = text(held.length);
      if (held.beside > kRounding * held.launched)
        all.push_back(
            {i, "its ends are " + text(held.beside) + " beside it at launch: the first step moves them", "axis"});
      const double more = held.launched - held.length, slack = kRounding * std::max(held.launched, held.length);
      if (breaks(kind, more, slack))
        all.push_back({i, said + ", and its ends are " + text(held.launched) +
                              " apart at launch: the first step moves them, which throws them"});
      if (!row_of(kind).pushes) continue;
      if (const double most = farthest(i); most < held.length - kRounding * held.length)
        all.push_back(
            {i, said + ", and other joints let its ends be " + text(most) + " apart at most: they contradict it"});
    }
    return all;
  }

 private:
  static constexpr double kRounding = 1e-6;
  struct Held {
    std::size_t a, b;  // knots
    double length = 0, launched = 0;
    double beside = 0;  // the axis of a slider, or the plane of a hinge
  };

  static std::string text(double metres) { return quantity_in_words(metres, Quantity::length); }

  std::size_t add(const Vec3d& place, bool is_point) {
    places_.push_back(place);
    held_by_.emplace_back();
    if (is_point) points_.push_back(places_.size() - 1);
    return places_.size() - 1;
  }
  std::size_t knot_of_shot(const std::string& name) {
    const std::size_t shot = *names_.shots.find(name);
    const auto [known, is_new] = of_shot_.emplace(shot, places_.size());
    return is_new ? add(scenario_.shots[shot].launch.position, false) : known->second;
  }
  std::size_t knot_of_point(const Vec3d& at) {
    const auto [known, is_new] = of_point_.emplace(std::tuple{at.x, at.y, at.z}, places_.size());
    return is_new ? add(at, true) : known->second;
  }

  /// The largest distance that all other joints allow between the ends of a joint: the shortest way through the net.
  /// The search ends at the length of the joint [m].
  [[nodiscard]] double farthest(std::size_t of) const {
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    std::map<std::size_t, double> way;
    const auto reach = [&](std::size_t knot, double distance) {
      if (distance > joints_[of].length) return;
      const auto [known, is_new] = way.emplace(knot, distance);
      if (!is_new && known->second <= distance) return;
      known->second = distance;
      next.emplace(distance, knot);
    };
    for (reach(joints_[of].a, 0); !next.empty();) {
      const auto [distance, knot] = next.top();
      next.pop();
      if (knot == joints_[of].b) return distance;
      if (way[knot] < distance) continue;
      for (const std::size_t i : held_by_[knot])
        if (i != of) reach(joints_[i].a == knot ? joints_[i].b : joints_[i].a, distance + joints_[i].length);
      if (std::ranges::binary_search(points_, knot))
        for (const std::size_t point : points_) reach(point, distance + length(places_[point] - places_[knot]));
    }
    return kInfinity;
  }

  const Scenario& scenario_;
  ScenarioNames names_;
  std::map<std::size_t, std::size_t> of_shot_;                          // knots, by shot
  std::map<std::tuple<double, double, double>, std::size_t> of_point_;  // ... by place
  std::vector<Vec3d> places_;                                           // of knots, at launch
  std::vector<std::size_t> points_;                                     // knots that stay where they are
  std::vector<std::vector<std::size_t>> held_by_;                       // rods and cables of each knot
  std::vector<Held> joints_;
};

/// What a world objects to in a joint: where the file has the key, or else the joint.
Error joint_error(const Scenario& scenario, std::size_t index, const Error& error) {
  if (index >= scenario.joint_places.size())  // a program's scenario
    return with_place(error, scenario.file + ": joint " + in_quotes(scenario.joints[index].name));
  const auto& places = scenario.joint_places[index];
  const auto of_key = places.find(error.place);
  return {error.place + ": " + error.message, (of_key != places.end() ? of_key : places.find(""))->second, error.hint};
}

}  // namespace

std::vector<JointRemark> joint_remarks(const Scenario& scenario) { return JointNet(scenario).remarks(); }

Status check_joints(const Scenario& scenario, const ScenarioNames& names, const Value& document) {
  for (std::size_t i = 0; i < scenario.joints.size(); ++i)
    if (Status status = check_joint(names, scenario.joints[i], element(document, "joint", i)); !status) return status;
  return check_given_names(scenario.joints, "joint", document);
}

Status WorldRun::Impl::add_joints() {
  for (std::size_t i = 0; i < scenario.joints.size(); ++i) {
    const ScenarioJoint& joint = scenario.joints[i];
    Joint def = joint.def;
    def.a = lone[index_of_shot(joint.a)];
    if (!joint.b.empty()) def.b = lone[index_of_shot(joint.b)];
    if (!joint.thing.empty()) def.thing = things[*names.things.find(joint.thing)];
    const Result<JointId> added = world.add_joint(def);
    if (!added) return joint_error(scenario, i, added.error());
    joints.push_back(*added);
  }
  return {};
}

}  // namespace physim
