// Pairs: projectiles that meet each other inside a step.
//
// All fly their step as if alone. Then the paths that were flown are searched for the first touch of two of them; both
// part as their restitution and friction say, and fly the rest of the step again, with their own models, from there
// on; their earlier events of the rest are dropped. This repeats until no two touch any more. Meetings are taken
// in order of time; those that fall on one moment and share a projectile are solved together, so that no order counts.
// Nothing depends on threads, packs or the order of rows, and nothing is kept from step to step.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "collide/bvh.hpp"
#include "collide/pair_path.hpp"
#include "world/step/settle.hpp"

namespace physim {

/// One that meets others, in the step at hand.
struct Collider {
  std::uint32_t slot = 0;
  std::uint16_t cohort = 0;
  std::uint32_t row = 0;
  const Kind* kind = nullptr;
  std::uint32_t layers = 0;  // its own
  Vec3d mobility;            // one over its mass along each axis; 0 where nothing moves it [1/kg]
  double spacing = 0;        // of its row's numbers, times their size [-]
  std::vector<collide::Knot> path;
  std::vector<Trace> traces;  // of a step in which it touched something
  Vec3d ahead{};              // by how much it moves faster at the end of the path than its row says [m/s]
  collide::Bounds box;        // of its path, as wide as the projectile
  double since = 0;           // its path counts from then on [s into the step]
  std::uint32_t version = 0;  // of its path
  int hits = 0;
  Rest rested{};  // before the step
  bool sleeps = false;
  bool flies = false;           // its row is stepped
  bool is_roused = false;       // it slept when the step began
  std::optional<Vec3d> free{};  // of one that lies on others: its acceleration without them [m/s^2]
  bool is_gone = false;         // at the end of its path
  bool is_new = false;          // its path is another one than it flew alone
};

/// How a projectile is put after a step, for what lies on it.
struct PutAfter {
  std::uint32_t slot;
  BodyState state;
};

/// One of a pile: of those that lie on each other at the end of a step.
struct Piled {
  std::uint32_t slot;
  std::uint32_t pile;  // the same for all of it
  Rest rested;         // before the step
  bool is_carried;     // it lies on what moves, too
};

/// Memory that steps use again and again.
struct PairScratch {
  bool used = false;                        // in the step at hand
  std::vector<std::optional<Rows>> before;  // by cohort: rows at the start of the step
  std::vector<Collider> colliders;          // in order of slots
  Chunk chunk;                              // events and changes since the first meetings
  std::vector<PutAfter> put;
  std::vector<Piled> piled;              // by pile
  std::vector<std::uint32_t> disturbed;  // sleepers that wake at the end of the step
};

struct WorldImpl;

/// Whether each of two, which have layers, wants those of the other.
[[nodiscard]] inline bool meet_by_layers(const CollisionDef& a, std::uint32_t layers_a, const CollisionDef& b,
                                         std::uint32_t layers_b) {
  return (a.others & layers_b) != 0 && (b.others & layers_a) != 0;
}

/// Before a step: finds which projectiles meet others, and their rows.
void begin_pairs(WorldImpl& world);
/// After it, before what follows from it: lets them meet.
void meet_pairs(WorldImpl& world, const SettleContext& context);
/// For each that is in a pair: the first of its group, which pairs join.
[[nodiscard]] std::map<std::uint32_t, std::uint32_t> groups_of(
    const std::set<std::pair<std::uint32_t, std::uint32_t>>& pairs);
/// Behind that: those of a pile rest together, and if all have done so for long enough, all sleep.
void rest_piles(WorldImpl& world);

}  // namespace physim
