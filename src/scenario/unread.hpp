// Settings that nothing reads: whether one is read depends on others. One list of rules says on which.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/assert.hpp"
#include "scenario/document.hpp"
#include "scenario/schema.hpp"

namespace physim {

/// A setting, or a table with all in it, that is given and that nothing reads.
struct UnreadSetting {
  std::string place{};  // file:line:column
  std::string path{};   // "shot.magnus.lift"
  std::string why{};    // what follows "has no effect": " beside shot.magnus.table"; " but ..." says what it has
};

/// All of a sound scenario, in the order of the list of settings. `document` is what it was read from.
[[nodiscard]] std::vector<UnreadSetting> unread_settings(Scenario& scenario, const Value& document);

/// True if the world's rule of detail, and not shot.fidelity, chooses the rung of a shot.
[[nodiscard]] inline bool is_ruled_by_detail(const Scenario& scenario, const ScenarioShot& shot) {
  const DetailRule& detail = scenario.world.def.detail;
  return scenario.world.given && !detail.rungs.empty() && (detail.layers & shot.body.layers) != 0;
}

/// True if an emitter has a rate, bursts, a gun or rain: it fires without being the sub of another one.
[[nodiscard]] bool has_own_fire(const EmitterDef& emitter);

/// A fidelity that a shot may fly at.
struct FlownRung {
  const ScenarioShot* shot;
  Fidelity asked;
  Fidelity granted;
};

/// The question of a rule: the scenario, and the table of a list that a setting stands in.
struct Reading {
  const Scenario& scenario;
  const Scope& scope;                // the pointers of the lists that the setting stands in
  std::span<const FlownRung> rungs;  // of all shots

  /// The shot in whose table the setting stands.
  [[nodiscard]] const ScenarioShot& shot() const {
    PHYSIM_ASSERT(scope.shot != nullptr);
    return *scope.shot;
  }
  /// Whether the study draws a setting, or something in a table.
  [[nodiscard]] bool is_drawn(std::string_view path) const;
  /// Whether something is true of a rung: of one shot in its table, else of any shot.
  template <class F>
  [[nodiscard]] bool any(const F& is_true) const {
    return std::ranges::any_of(rungs, [&](const FlownRung& rung) {
      return (scope.shot == nullptr || scope.shot == rung.shot) && is_true(rung);
    });
  }
  /// ... of a shot by its name.
  template <class F>
  [[nodiscard]] bool any_of(std::string_view shot, const F& is_true) const {
    return std::ranges::any_of(
        rungs, [&](const FlownRung& rung) { return rung.shot->projectile.name == shot && is_true(rung); });
  }
};

/// A rule about settings, or about tables with all in them. Of two rules about one setting the first that finds it
/// unread says why.
struct UnreadRule {
  std::string_view settings;  // their paths, parted by blanks
  bool (*is_read)(const Reading&);
  std::string_view why;                            // if it is not, as UnreadSetting::why
  std::string (*value)(const Reading&) = nullptr;  // what follows that
  /// In a file it describes what is there, and is no wish: only an override that nothing reads is told.
  bool describes = false;
};

[[nodiscard]] constexpr UnreadRule described(UnreadRule rule) { return rule.describes = true, rule; }

[[nodiscard]] std::span<const UnreadRule> unread_in_flights();   // environment, shots, tolerance
[[nodiscard]] std::span<const UnreadRule> unread_in_scenes();    // materials, shapes, things, contact
[[nodiscard]] std::span<const UnreadRule> unread_in_worlds();    // worlds, bodies, volleys, joints
[[nodiscard]] std::span<const UnreadRule> unread_in_emitters();  // emitters

/// Whether a world moves a shot only by its own velocity, or by calls.
[[nodiscard]] inline bool is_unmoved(const BodyDef& body) {
  return body.kinematic || body.infinite_mass || body.frozen == Axes::all;
}
[[nodiscard]] inline bool is_pushed(const FlownRung& f) { return f.granted.motion == Motion::force; }
/// Whether gravity moves a shot.
[[nodiscard]] inline bool feels_gravity(const FlownRung& f) {
  const BodyDef& body = f.shot->body;
  return f.granted.gravity != GravityModel::off && f.shot->projectile.gravity_scale != 0 && body.use_gravity &&
         body.gravity_scale != 0 && !is_unmoved(body) && !has(body.frozen, Axes::y);
}
/// Whether what a shot meets may turn it: a ball that bounces off something, and no point.
[[nodiscard]] bool may_be_turned(const Reading& reading);

}  // namespace physim
