// What a save holds: the parts of a world as plain values. Their members are the format: raise kSaveFormat
// (include/physim/world.hpp) where one changes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "world/core/state.hpp"

namespace physim {

struct SavedRung {
  Fidelity asked;
  std::optional<FidelityNote> chosen;
};

struct SavedKind {
  std::uint32_t number = 0;
  bool stays = false;
  ProjectileDef projectile;
  BodyDef body;
  std::vector<SavedRung> rungs;
};

/// A slot; where it is free, only what became of its projectile.
struct SavedSlot {
  std::uint32_t generation = 0;
  std::uint32_t flags = 0;
  std::uint32_t kind = 0;  // its number
  std::uint32_t rung = 0;
  double birth = 0;             // [s]
  std::uint32_t rest_step = 0;  // of Rest
  std::uint32_t rest_time = 0;  // its bits
  std::vector<double> numbers;  // of its row, see Placement::saved_numbers()
};

struct SavedOwn {
  std::uint32_t slot = 0;
  Own own;
};
struct SavedTags {
  std::uint32_t slot = 0;
  Tags tags;
};
struct SavedTurning {
  std::uint32_t slot = 0;
  Turning turning;
};

struct SavedEmitter {
  std::uint32_t generation = 0;
  bool active = false;
  EmitterDef def;
  std::uint64_t seed = 0;
  bool plays = false;
  double began = 0;  // [s]
  TimelineState timeline;
  std::uint64_t plays_before = 0;
  std::uint64_t born = 0;
  double travelled = 0;  // [m]
  std::uint64_t metre = 0;
  std::uint64_t first = 0;
  RainState rain;
  std::optional<FollowedLaunch> launch;
  std::vector<SavedTrail> trails;
  Transform at;
  std::optional<Transform> to;
  std::vector<MotionKey> lead;  // where its legs begin and end
  EmitterCounts counts;
};
struct SavedParticle {
  std::uint32_t slot = 0;
  Particle particle;
};
struct SavedEmitters {
  std::vector<SavedEmitter> all;    // from index 1 on
  std::vector<std::uint32_t> free;  // places, in the order in which they were left
  std::uint64_t added = 0;
  std::vector<SavedParticle> particles;
  std::vector<Due> lives;
  std::vector<Due> ages;
};

struct SavedJoint {
  std::uint32_t generation = 0;
  bool active = false;
  Joint def;
  double tension = 0;  // [N]
  bool is_taut = false;
  double force = 0;  // [N]
};

struct SavedWorld {
  std::string made_by;  // version of the library; first in every format, so that a refusal can name it
  WorldDef def;
  std::vector<Environment> environments;
  std::vector<SavedKind> kinds;
  std::uint32_t last_number = 0;
  std::vector<std::uint32_t> idle;  // kinds, by number
  Clock clock;
  std::vector<SavedSlot> slots;
  std::vector<std::uint32_t> free;    // slots, in the order in which they are used again
  std::vector<std::uint32_t> by_age;  // slots in pools that replace, the oldest first
  std::vector<SavedOwn> own;
  std::vector<SavedTags> tags;
  std::vector<SavedTurning> turning;
  std::vector<Due> launches;
  std::vector<Due> old_age;
  std::vector<Generator> generators;
  std::vector<std::uint32_t> free_generators;
  std::vector<std::uint32_t> order_of_generators;
  WorldCounters counters;
  Vec3d observer;
  DetailRule detail;
  std::optional<Scene> scene;
  SavedEmitters emitters;
  std::vector<SavedJoint> joints;          // from index 1 on
  std::vector<std::uint32_t> free_joints;  // places, in the order in which they were left
};

}  // namespace physim
