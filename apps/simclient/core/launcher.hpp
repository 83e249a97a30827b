// Launcher: the shot that is fired next. Its keys are those of the original client.
//
// The original's three shots, on its own loop, have its own settings: two motions, three gravities and three drags.
// They stay when another of the three is chosen, as they did there. Elsewhere the same keys go through all rungs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physim/names.hpp"
#include "scenario/scenario.hpp"

namespace physim::client {

/// A kind of shot to choose from.
struct ShotType {
  std::string name, doc;
  ScenarioShot shot;
  /// Shots of the original alone: at its elevation setting e the velocity is (forward, up e).
  double forward = 0, up = 0;  // [m/s]

  [[nodiscard]] bool is_original() const { return forward > 0; }
};

/// What gravity or drag of the original acts by.
enum class OriginalEffect {
  off,
  constant,  ///< the shot's own gravity; damping
  force,     ///< of the world's gravity; drag by k1 and k2. It does nothing in motion `velocity`, which knows no force
};

[[nodiscard]] std::string_view name(OriginalEffect effect);

class Launcher {
 public:
  /// The original's four shots, the other presets, and the shots of a scenario, which come first to hand.
  /// `version`: to count on from that of a launcher whose place this one takes.
  explicit Launcher(const Scenario& scenario, std::uint64_t version = 0);

  [[nodiscard]] std::span<const ShotType> types() const { return types_; }
  [[nodiscard]] std::size_t type() const { return type_; }
  void select(std::size_t type);
  bool select(std::string_view name);
  void next_type() { select((type_ + 1) % types_.size()); }

  /// What will be fired. Edits of it hold until another type is chosen.
  [[nodiscard]] const ScenarioShot& shot() const { return shot_; }
  void set_shot(const ScenarioShot& shot);
  /// Counts the changes, for those who keep what they made from it.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  /// Whether the settings of the original are in force: one of its three shots, on its loop.
  [[nodiscard]] bool is_original() const;
  [[nodiscard]] Motion original_motion() const { return motion_; }
  [[nodiscard]] OriginalEffect original_gravity() const { return gravity_; }
  [[nodiscard]] OriginalEffect original_drag() const { return drag_; }

  // The original's settings, each the next of its values.
  void cycle_elevation();
  void cycle_motion();
  void cycle_gravity();
  void cycle_drag();
  /// Turns the barrel, and keeps the speed [rad]. A zero range stays: the barrel is raised above where that puts it.
  void turn(double right, double up) { point(azimuth() + right, elevation() + up); }
  /// Points the barrel as turn() does, to angles that stay as they are given where they can be [rad].
  void point(double azimuth, double elevation);
  /// Changes the speed, along the barrel as it is [m/s].
  void set_speed(double speed);
  /// Elevation of the barrel above that of the zero range [rad].
  [[nodiscard]] double raised() const { return is_zeroed() ? shot_.launch.sight.dial : 0; }
  [[nodiscard]] bool is_zeroed() const { return shot_.launch.sight.zero_range > 0; }
  /// Takes the place of another launcher, as of its next version.
  void bring_back(const Launcher& from);

  /// "e = 2 (5.7 deg)" or "10.0 deg".
  [[nodiscard]] std::string elevation_text() const;
  /// The original's elevation setting, while it is in force.
  [[nodiscard]] std::optional<int> elevation_setting() const;
  [[nodiscard]] double elevation() const;  // [rad]
  [[nodiscard]] double azimuth() const;    // [rad]
  [[nodiscard]] double speed() const;      // [m/s]

 private:
  template <class Rung>
  void cycle(Rung Fidelity::*of_effect) {
    Rung& rung = shot_.projectile.fidelity.*of_effect;
    rung = static_cast<Rung>((static_cast<std::size_t>(rung) + 1) % names_of<Rung>().size());
    ++version_;
  }
  /// Forward and upward parts of the velocity of an original shot, or of the acceleration that pushes it.
  [[nodiscard]] Vec3d original_start() const;
  [[nodiscard]] Vec3d original_push() const;  // [N]
  [[nodiscard]] bool is_pushed() const;       // by it, and by nothing that was set by hand
  void push();
  void set_original_elevation(int setting);
  void put_original();
  void follow_hand();
  void use_angles();

  std::vector<ShotType> types_;
  std::size_t type_ = 0;
  int setting_ = 2;
  Motion motion_ = Motion::velocity;
  OriginalEffect gravity_ = OriginalEffect::constant, drag_ = OriginalEffect::constant;
  ScenarioShot shot_;
  std::uint64_t version_ = 0;
};

}  // namespace physim::client
