// Emitters: what a world keeps of its emitters and of the particles that they fired.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "base/prefetch.hpp"
#include "collide/path.hpp"
#include "emit/emission.hpp"
#include "emit/odometer.hpp"
#include "emit/timeline.hpp"
#include "world/core/emitter_lead.hpp"
#include "world/core/schedule.hpp"
#include "world/core/trails.hpp"

namespace physim {

/// A particle, beside what every projectile has. Nothing of how it looks: that follows from its number.
struct Particle {
  std::uint32_t emitter = 0;          // index; 0: no emitter
  std::uint32_t events = 0;           // those checked for sub-emitters
  std::uint64_t number = 0;           // among those of its emitter
  double phase = 0;                   // of the cycle at its birth
  double dies = 0;                    // [s]
  double size = 1;                    // inherited, times its own
  std::uint32_t colour = 0xffffffff;  // inherited, times its own
  std::uint32_t depth = 0;            // births at its own moment that led to it
};

/// What is read of every particle that is shown or driven, apart from all else that is kept of it: few bytes.
struct ParticleSpan {
  std::uint64_t number = 0;  // as Particle has it
  double dies = 0;           // as Particle has it [s]
};

/// A particle that is emitted among others.
struct Joining {
  ProjectileId id;
  std::uint64_t number = 0;  // as Particle has it
  double phase = 0;          // as Particle has it
  double dies = 0;           // as Particle has it [s]
  double birth = 0;          // [s]
};

/// Why a particle went, as EmitterCounts has it.
using EmitterCount = std::uint64_t EmitterCounts::*;

/// A particle among those of its emitter, in order of births.
struct Aged {
  ProjectileId id;
  std::uint64_t number = 0;
};

/// Calls f with each time at which sub-emitters wait for an age, once.
template <class F>
void each_age(const std::vector<SubEmitter>& subs, double birth, const F& f) {
  for (auto sub = subs.begin(); sub != subs.end(); ++sub) {
    const auto is_then = [&](const SubEmitter& s) {
      return s.on == SubEvent::age && birth + s.age == birth + sub->age;
    };
    if (sub->on == SubEvent::age && std::find_if(subs.begin(), sub, is_then) == sub) f(birth + sub->age);
  }
}

// A candidate of rain that lacks no more than this has fallen: at a frame's end some frame rates would have one and
// others not, as the ways of a viewer are rounded.
inline constexpr double kRainRounding = 1e-9;

/// The progress of a box of rain.
struct RainState {
  std::optional<Vec3d> about{};  // its middle where it is full of rain; none: it is empty [m]
  double due = 0;                // elapsed part of the next candidate, -kRainRounding to 1
};

/// Where and when a projectile that flies by its closed form set out: its way since then does not depend on frames.
struct FollowedLaunch {
  ProjectileId id;
  Vec3d position;   // [m]
  Vec3d velocity;   // [m/s]
  double time = 0;  // as it was first seen [s]
};

/// An emitter and its progress.
struct Emitter {
  std::uint32_t generation = 0;
  bool active = false;
  std::shared_ptr<const Emission> emission;
  std::shared_ptr<const collide::Path> path;  // of its motion; null: it has none
  std::shared_ptr<const Odometer> odometer;   // along the path; null: distances do not count
  std::uint64_t hash = 0;                     // of definition and seed
  bool drives = false;                        // acts on the flight of its particles
  bool bequeaths = false;                     // some of its particles inherited a size or a colour
  bool plays = false;
  double began = 0;  // to play [s]
  TimelineState timeline;
  std::uint64_t plays_before = 0;
  std::uint64_t born = 0;       // the number of the next particle
  double travelled = 0;         // since it began, where calls or a projectile move it [m]
  std::uint64_t metre = 0;      // births by distance since it began
  Transform at;                 // where it stands, rotation of length one
  std::optional<Transform> to;  // where it goes in the next step
  EmitterLead lead;             // the legs that it is on, and those that follow
  EmitterCounts counts;
  std::uint64_t first = 0;  // the number of the first particle since it began
  RainState rain;
  std::optional<FollowedLaunch> launch;  // of the projectile that it follows
  Trails trails;
  std::vector<Aged> by_age;  // its particles, where the oldest makes room; some are gone
  std::size_t oldest = 0;    // in by_age

  [[nodiscard]] const EmitterDef& def() const { return emission->def(); }
  /// Where a motion or legs of lead_emitter() have it at a time, and how it moves.
  [[nodiscard]] std::optional<MotionState> on_way(double time) const {
    if (path) return path->at(time);
    return lead.empty() ? std::nullopt : std::optional(lead.at(time));
  }
  /// From when on metres count: from its first cycle on [s].
  [[nodiscard]] double counted_from() const;
  /// Ends its legs where it is now.
  void leave_lead(double now);
};

class Emitters {
 public:
  /// Whether there never was any: one that was removed keeps its place while its particles live.
  [[nodiscard]] bool empty() const { return all_.size() == 1; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(all_.size()); }
  [[nodiscard]] Emitter& operator[](std::uint32_t index) {
    PHYSIM_ASSERT(index > 0 && index < all_.size());
    return all_[index];
  }
  [[nodiscard]] const Emitter& operator[](std::uint32_t index) const {
    PHYSIM_ASSERT(index > 0 && index < all_.size());
    return all_[index];
  }
  [[nodiscard]] Emitter* find(EmitterId id) {
    if (id.index == 0 || id.index >= all_.size()) return nullptr;
    Emitter& e = all_[id.index];
    return e.active && e.generation == id.generation ? &e : nullptr;
  }
  [[nodiscard]] const Emitter* find(EmitterId id) const { return const_cast<Emitters*>(this)->find(id); }
  /// How many were added in total, removed ones included.
  [[nodiscard]] std::uint64_t added() const { return added_; }
  [[nodiscard]] EmitterId id_of(std::uint32_t index) const { return {index, (*this)[index].generation}; }

  /// A place for one more, active.
  std::uint32_t add();
  /// Removes it; its particles have no emitter, but their lives end as they would.
  void erase(std::uint32_t index);

  /// The particle of a slot; null: no emitter fired it.
  [[nodiscard]] Particle* particle(std::uint32_t slot) {
    if (slot >= emitter_of_.size() || emitter_of_[slot] == 0) return nullptr;
    PHYSIM_ASSERT(particles_[slot].emitter == emitter_of_[slot]);
    return &particles_[slot];
  }
  [[nodiscard]] const Particle* particle(std::uint32_t slot) const {
    return const_cast<Emitters*>(this)->particle(slot);
  }
  /// The emitter of the particle of a slot; 0: none.
  [[nodiscard]] std::uint32_t emitter_of(std::uint32_t slot) const {
    return slot < emitter_of_.size() ? emitter_of_[slot] : 0;
  }
  /// The number and the end of life of the particle in a slot.
  [[nodiscard]] const ParticleSpan& span(std::uint32_t slot) const {
    PHYSIM_ASSERT(slot < emitter_of_.size());
    PHYSIM_ASSERT(emitter_of_[slot] != 0 && spans_[slot].number == particles_[slot].number);
    return spans_[slot];
  }
  /// Before what is kept of a slot's particle is read: such slots lie all over the memory.
  void prefetch(std::uint32_t slot) const {
    prefetch_span(slot);
    if (slot < emitter_of_.size()) prefetch_at(&particles_[slot]);
  }
  /// Prefetches number, emitter and end of life of a slot's particle.
  void prefetch_span(std::uint32_t slot) const {
    if (slot >= emitter_of_.size()) return;
    prefetch_at(&emitter_of_[slot]);
    prefetch_at(&spans_[slot]);
  }
  /// What acts on the flight of a slot's particle; null: nothing of its emitter.
  [[nodiscard]] const FlightLaw* law_of(std::uint32_t slot) const {
    const std::uint32_t emitter = emitter_of(slot);
    return emitter != 0 && (*this)[emitter].drives ? &(*this)[emitter].emission->flight() : nullptr;
  }
  /// Whether an emitter acts on any flight.
  [[nodiscard]] bool drive_any() const {
    return std::ranges::any_of(all_, [](const Emitter& e) { return e.drives; });
  }
  /// Adds a particle. The caller has handled what happens to it up to `seen` [s].
  void join(ProjectileId id, const Particle& particle, double birth, double seen);
  /// Adds `count` particles of an emitter, none with a pending age: one(i) gives each, all else is as `like`
  /// has it.
  template <class F>
  void join_each(const Particle& like, std::size_t count, double seen, const F& one) {
    if (count == 0) return;
    Emitter& emitter = (*this)[like.emitter];
    const bool is_plain = emitter.def().when_full != WhenFull::replace_oldest;
    Particle particle = like;
    for (std::size_t i = 0; i < count; ++i) {
      const Joining joining = one(i);
      particle.number = joining.number, particle.phase = joining.phase, particle.dies = joining.dies;
      if (!is_plain || joining.id.index >= particles_.size()) {
        join(joining.id, particle, joining.birth, seen);
        continue;
      }
      particles_[joining.id.index] = particle;
      spans_[joining.id.index] = {joining.number, joining.dies};
      emitter_of_[joining.id.index] = like.emitter;
      ++emitter.counts.alive;
      if (std::isfinite(joining.dies) && joining.dies > seen) lives.add(joining.dies, joining.id);
    }
    emitter.bequeaths = emitter.bequeaths || like.size != 1 || like.colour != 0xffffffff;
  }
  /// It is gone, for that reason; nothing where no emitter fired it.
  void leave(std::uint32_t slot, EmitterCount why) {
    if (emitter_of(slot) != 0) leave_emitter(slot, why);
  }
  /// The oldest particle of an emitter that lets it make room.
  [[nodiscard]] ProjectileId oldest(std::uint32_t index);
  /// Calls f with the slot and the particle of each one alive, in order of slots.
  template <class F>
  void each_particle(const F& f) const {
    for (std::uint32_t slot = 1; slot < particles_.size(); ++slot)
      if (emitter_of_[slot] != 0) f(slot, particles_[slot]);
  }
  /// As each_particle(), of one emitter.
  template <class F>
  void each_particle_of(std::uint32_t index, const F& f) const {
    for (std::uint32_t slot = 1; slot < emitter_of_.size(); ++slot)
      if (emitter_of_[slot] == index) f(slot, particles_[slot]);
  }

  Schedule lives;  // when they end
  Schedule ages;   // when sub-emitters fire at them

  [[nodiscard]] std::size_t bytes() const;
  void add_to(Hash& hash, const SlotTable& slots) const;

  // ------------------------------------------------------------------------------------------- as a save tells it
  [[nodiscard]] const std::vector<Emitter>& all() const { return all_; }  // the first is unused
  [[nodiscard]] const std::vector<std::uint32_t>& free() const { return free_; }
  /// False where that makes no sense. Particles join afterwards, in order of their births.
  bool restore(std::vector<Emitter> all, std::vector<std::uint32_t> free, std::uint64_t added);
  /// Adds one that was emitted before; in order of births.
  void resume(ProjectileId id, const Particle& particle);

 private:
  [[nodiscard]] bool is_gone(const Aged& aged, std::uint32_t emitter) const;
  void leave_emitter(std::uint32_t slot, EmitterCount why);

  std::vector<Emitter> all_{1};  // 0 is unused
  std::uint64_t added_ = 0;
  std::vector<std::uint32_t> free_;
  std::vector<Particle> particles_;        // by slot
  std::vector<ParticleSpan> spans_;        // by slot
  std::vector<std::uint32_t> emitter_of_;  // by slot, for searches: 0 if it has no emitter
};

}  // namespace physim
