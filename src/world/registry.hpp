// What a world knows and never forgets: its environments, its kinds of projectiles on the rungs they were asked for,
// and the cohorts that they belong to. It only grows, so that snapshots need not hold it.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "physim/world_def.hpp"
#include "prepare/cohort.hpp"
#include "prepare/equivalent_drag.hpp"
#include "world/check.hpp"
#include "world/fields.hpp"
#include "world/live.hpp"

namespace physim {

inline constexpr std::size_t kMostCohorts = 65535;
inline constexpr std::size_t kMostKinds = 1u << 20;
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
inline constexpr unsigned kVariants = 16u << kOwnParts.size();
inline constexpr std::uint16_t kNoCohort = 0xffff;

/// A kind on one rung.
struct Prepared {
  Fidelity asked;
  std::optional<FidelityNote> chosen;  // why, where it was not asked for by name
  FidelityInUse in_use;
  Features features;
  Body<double> body;                                // of everything but the launch
  Rotor<double> rotor;                              // the same, of rungs that turn
  std::unique_ptr<EquivalentDrag> equivalent_drag;  // where k2 is that of the drag equation at launch
  std::uint16_t cohort[kVariants];
};

struct Kind {
  ProjectileDef projectile;
  BodyDef body;
  ProjectileDef flown;         // the projectile with its drag scaled as its body says: what the models are given
  std::uint32_t flags = 0;     // SlotFlags that its body sets
  std::deque<Prepared> rungs;  // the first is its own
};

/// Equal rungs, environment and rules: stepped together.
struct WorldCohort {
  CohortKey key;
  Conditions<double> conditions;
  Conditions<float> conditions_float;
  RowLayout layout;
  Course<float> course_float;
  Course<double> course_double;

  template <class S>
  [[nodiscard]] const Course<S>& course() const {
    if constexpr (sizeof(S) == 4) return course_float;
    if constexpr (sizeof(S) == 8) return course_double;
  }
};

class Registry {
 public:
  explicit Registry(const WorldDef& def) : def_(def), environments_{def.environment} {}

  [[nodiscard]] Result<KindId> add_kind(const ProjectileDef& projectile, const BodyDef& body);
  [[nodiscard]] const Kind& kind(std::uint32_t index) const {
    PHYSIM_ASSERT(has_kind({index}));
    return kinds_[index - 1];
  }
  [[nodiscard]] Kind& kind(std::uint32_t index) { return const_cast<Kind&>(std::as_const(*this).kind(index)); }
  [[nodiscard]] bool has_kind(KindId id) const { return id.index > 0 && id.index <= kinds_.size(); }

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
  /// Back to what they were. Kinds that fly in one that is not there then have none until it is added again.
  void restore_environments(const std::vector<Environment>& then);
  [[nodiscard]] bool has_environment_of(KindId id) const {
    return has_kind(id) && kind(id.index).body.environment < environments_.size();
  }
  [[nodiscard]] const std::vector<Environment>& environments() const { return environments_; }

 private:
  std::uint16_t find_or_add(const CohortKey& key);
  void prepare(Kind& kind, Prepared& rung);
  void prepare(WorldCohort& cohort);
  void point_to_tables(WorldCohort& cohort);

  /// The tables of one interpolation, shared by all cohorts.
  [[nodiscard]] TablePool& tables(Interpolation i) { return tables_[static_cast<unsigned>(i)]; }

  WorldDef def_;
  std::vector<Environment> environments_;
  std::deque<Kind> kinds_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> kind_by_hash_;
  std::uint32_t last_given_ = 0;  // kind that add_kind() gave last
  std::deque<WorldCohort> cohorts_;
  TablePool tables_[3];
};

}  // namespace physim
