// The shots of a batch, prepared and sorted into groups that fly together: those with equal granted rungs.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "flight/batch_job.hpp"
#include "flight/shot_list.hpp"
#include "model/spin_drift.hpp"
#include "prepare/cohort.hpp"

namespace physim {

/// Whether the granted rungs move a flight aside by its spin afterwards.
[[nodiscard]] inline bool drifts(const Fidelity& granted) { return granted.rotation == RotationModel::spin_drift; }

/// Shots with equal granted rungs, gathered until they fly.
struct ShotGroup {
  Cohort cohort;
  std::optional<double> step;
  std::vector<std::uint32_t> shots;
  Body<double> common{};                            // what all bodies have ...
  PartSet own = PartSet::all();                     // ... but for these parts ...
  std::vector<double> own_numbers;                  // ... of which those gathered are here, with all between them
  std::vector<Rotor<double>> rotors;                // of rungs that turn
  std::vector<std::pair<SpinDrift, Vec3d>> drifts;  // of the rung of that name, and where they point
  std::vector<Turn<double>> turned;                 // how they turn at their ends
  std::vector<RawEvent> events;

  void add(std::uint32_t shot, const Body<double>& body);
  [[nodiscard]] Body<double> body(std::size_t i) const;
  [[nodiscard]] unsigned own_stride() const { return own_stride_; }
  /// The features of its cohort when its shots were gathered.
  [[nodiscard]] const Features& features() const { return features_; }
  void clear();

 private:
  void begin();

  Features features_;
  unsigned own_stride_ = 0;  // numbers of each shot in own_numbers
};

/// A projectile checked and prepared; each of its shots writes its launch over that of the one before.
struct ShotKind {
  const ProjectileDef* projectile = nullptr;
  Status status;
  ShotGroup* group = nullptr;
  Body<double> body;
  Rotor<double> rotor;  // of rungs that turn
};

/// A drag curve that many projectiles may have as their own, looked at once.
struct KnownCurve {
  std::vector<DragPoint> points;        // right ones
  std::optional<bool> overshoots = {};  // its spline, where that was asked
};

/// What becomes of a shot.
enum class ShotState {
  refused,
  over,   // ends where it begins
  alone,  // drag slows it so fast that a frame is too long: it has its own step, and no place in a pack
  flies,
};

/// Prepares shots one by one. Not for several threads: each has its own.
class ShotGroups {
 public:
  explicit ShotGroups(const BatchTask& task) : task_(task), projectiles_(task.shots), environments_(task) {}

  /// What else is known of the shot stands in kind(), launch(), environment(), refusal() and outcome() until the next.
  [[nodiscard]] ShotState prepare(std::size_t shot);
  [[nodiscard]] const ShotKind& kind() const { return kind_; }
  [[nodiscard]] const Launch& launch() const { return *launch_; }
  [[nodiscard]] const Environment& environment() const { return *environment_; }
  [[nodiscard]] const Error& refusal() const { return refusal_.error(); }
  [[nodiscard]] Outcome outcome() const { return outcome_; }

  [[nodiscard]] ShotGroup& group_of(const ProjectileDef& projectile) {
    return group_of(projectile, known_curve(projectile.drag));
  }
  [[nodiscard]] std::deque<ShotGroup>& all() { return groups_; }
  /// What of a body may be a shot's own.
  [[nodiscard]] PartSet parts_of_shots() const;

 private:
  ShotKind& kind_of(std::size_t shot);
  [[nodiscard]] Status look_at(std::size_t shot, const ProjectileDef& projectile);
  [[nodiscard]] Status look_at_drag(std::size_t shot) const;
  [[nodiscard]] KnownCurve* known_curve(const DragDef& drag);
  [[nodiscard]] Status look_at_projectile(const ProjectileDef& projectile, KnownCurve*& curve);
  [[nodiscard]] unsigned grant_key(const ProjectileDef& projectile, KnownCurve* curve) const;
  [[nodiscard]] ShotGroup& group_of(const ProjectileDef& projectile, KnownCurve* curve);
  [[nodiscard]] ShotState refuse(Status why);

  const BatchTask& task_;
  std::deque<ShotGroup> groups_;
  static constexpr std::size_t kMostKnownCurves = 64;
  std::vector<KnownCurve> known_curves_;
  std::array<ShotGroup*, 8192> group_by_key_{};
  ShotKind kind_;
  ShotProjectiles projectiles_;
  Launch scratch_;
  const Launch* launch_ = nullptr;
  ShotEnvironments environments_;
  const Environment* environment_ = nullptr;
  Status refusal_;
  Outcome outcome_ = Outcome::refused;
};

}  // namespace physim
