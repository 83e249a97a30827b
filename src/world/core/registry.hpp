// What a world knows: its environments, its kinds of projectiles, and the cohorts that they belong to. What a snapshot
// needs of it stays, so that snapshots need not hold it.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <utility>

#include "world/core/check.hpp"
#include "world/core/fields.hpp"
#include "world/core/kinds.hpp"
#include "world/core/static_rungs.hpp"

namespace physim {

inline constexpr std::size_t kMostCohorts = 65535;
inline constexpr std::size_t kMostRungs = 4096;  // of one kind

/// Rules that a whole cohort shares.
struct CohortRules {
  DespawnRules despawn;
  double sleep_speed = 0;  // 0: never sleeps [m/s]
  double sleep_time = 0;   // [s]

  bool operator==(const CohortRules&) const = default;
};

struct CohortKey {
  std::uint32_t environment = 0;
  Fidelity fidelity;
  Features features;
  bool launch_place = false;  // a rule asks how far a projectile is from there
  bool meets = false;         // things of the scene
  CohortRules rules;
  bool forced = false;  // generators act on it
  bool still = false;   // asleep, kinematic, pending or stuck: not stepped

  bool operator==(const CohortKey&) const = default;
};

/// What may differ between projectiles of one kind and rung: which of its cohorts they are in.
struct Variant {
  bool forced = false;
  bool still = false;
  bool sleepless = false;
  bool railed = false;  // started on a rail
  unsigned own = 0;     // a bit for each of kOwnParts in which it differs

  [[nodiscard]] unsigned index() const {
    return (forced ? 1u : 0) | (still ? 2u : 0) | (sleepless ? 4u : 0) | (railed ? 8u : 0) | own << 4;
  }
};
/// Equal rungs, environment and rules: stepped together.
struct WorldCohort {
  CohortKey key;
  ProfileTables profiles;
  Conditions<double> conditions;
  Conditions<float> conditions_float;
  RowLayout layout;
  std::int8_t static_rung = kNoStaticRung;  // index in kStaticRungs
  double most_radius = 0;                   // with which any kind that is in it meets things [m]
  Course<float> course_float;
  Course<double> course_double;

  /// Features of its conditions, but for what pushes forced rows.
  [[nodiscard]] Features features() const {
    Features features = conditions;
    features.has_applied = key.features.has_applied;
    return features;
  }
  /// True if forces are evaluated once in a step, and rows keep nothing but place and velocity: they may step in parts.
  [[nodiscard]] bool steps_plainly() const {
    const Fidelity& f = conditions.fidelity;
    return is_first_order(conditions) && f.motion != Motion::closed_form && f.earth == EarthModel::flat && !f.planar &&
           f.rotation == RotationModel::none && features() == Features{};
  }
  template <class S>
  [[nodiscard]] const Course<S>& course() const {
    if constexpr (sizeof(S) == 4) return course_float;
    if constexpr (sizeof(S) == 8) return course_double;
  }
};

/// A projectile with `scale` times the drag, on every rung.
[[nodiscard]] Result<ProjectileDef> with_drag_scaled(ProjectileDef projectile, double scale);

class Registry {
 public:
  explicit Registry(const WorldDef& def) : def_(def), environments_{def.environment} {}

  /// The index of a kind of these definitions, of one that there is already where it is. Indices are for the world
  /// alone: they are used again where kinds were let go.
  [[nodiscard]] Result<std::uint32_t> find_or_add_kind(const ProjectileDef& projectile, const BodyDef& body,
                                                       std::uint64_t moment);
  /// Adds a kind from a save, with all that is prepared for it except for flights in a removed environment.
  void add_saved_kind(Kind kind);
  [[nodiscard]] const Kind& kind(std::uint32_t index) const { return kinds[index]; }
  [[nodiscard]] Kind& kind(std::uint32_t index) { return kinds[index]; }
  [[nodiscard]] bool has_kind(KindId id) const { return kinds.find(id) != 0; }

  /// The kind on a rung; nothing where there are too many already. `why` says how the rung was chosen, if it was.
  std::optional<std::uint16_t> rung(std::uint32_t kind, const Fidelity& asked, const FidelityNote* why = nullptr);
  /// The cohort of a kind on a rung; kNoCohort where there are too many.
  std::uint16_t cohort(std::uint32_t kind, std::uint16_t rung, const Variant& variant);

  [[nodiscard]] std::size_t cohorts() const { return cohorts_.size(); }
  [[nodiscard]] const WorldCohort& cohort(std::uint16_t index) const {
    PHYSIM_ASSERT(index < cohorts_.size());
    return cohorts_[index];
  }

  [[nodiscard]] Result<std::uint32_t> add_environment(const Environment& environment);
  Status set_environment(std::uint32_t index, const Environment& environment);
  /// Whether there is a scene: kinds that meet its things go to other cohorts then.
  void meet_scene(bool there);
  /// Back to what they were. Kinds that fly in one that is not there then have none until it is added again.
  void restore_environments(const std::vector<Environment>& then);
  [[nodiscard]] bool has_environment_of(const Kind& k) const { return k.body.environment < environments_.size(); }
  [[nodiscard]] const std::vector<Environment>& environments() const { return environments_; }
  [[nodiscard]] bool is_new() const { return kinds.is_new(); }
  [[nodiscard]] std::size_t bytes() const;
  /// The tables of one interpolation, shared by all cohorts.
  [[nodiscard]] const TablePool& tables(Interpolation i) const { return tables_[static_cast<unsigned>(i)]; }

  Kinds kinds;

 private:
  std::uint16_t find_or_add(const CohortKey& key);
  void prepare(Kind& kind, Prepared& rung);
  void prepare(WorldCohort& cohort);
  void point_to_tables(WorldCohort& cohort);

  [[nodiscard]] TablePool& tables(Interpolation i) { return tables_[static_cast<unsigned>(i)]; }

  WorldDef def_;
  std::vector<Environment> environments_;
  bool has_scene_ = false;
  std::uint32_t last_given_ = 0;  // number of the kind that was found last
  std::deque<WorldCohort> cohorts_;
  TablePool tables_[3];
  std::shared_ptr<TablePool> equivalent_[3];  // of EquivalentDrags, by interpolation
};

}  // namespace physim
