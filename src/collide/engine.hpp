// An engine that answers beside a scene's own things: what it is asked, and what of its answers is believed.
//
// The skin. An engine in single precision knows its surfaces to some micrometres, and a ray that starts so much behind
// one has passed it. So each surface is met one skin in front of where the engine has it: a segment is cast somewhat
// longer than it is, and a hit is moved back along it by skin / cosine, the way on which the gap to a flat surface
// closes by one skin. What flew, lies or slides is then always a skin away, and rounding leaves it outside.
#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "physim/scene.hpp"

namespace physim::collide {

class Engine {
 public:
  explicit Engine(const EngineScene& def) : def_(def) {}
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  ~Engine() = default;

  [[nodiscard]] const EngineScene& def() const { return def_; }
  [[nodiscard]] EngineCounters counters() const { return {calls_.load(), segments_.load(), refused_.load()}; }

  /// What segments meet first, in one call; `into` keeps what is met before. Segments that make no sense, or have no
  /// length, meet nothing.
  void first_hits(std::span<const SceneSegment> segments, std::uint32_t layers, std::span<SceneHit> into) const;
  /// Adds what the points of a segment meet, in and out, to `hits`, by part.
  void all_hits(const SceneSegment& segment, std::uint32_t layers, std::vector<SceneHit>& hits) const;

 private:
  struct March;
  [[nodiscard]] static std::vector<March> marches_along(const SceneSegment& segment, double far);
  void march(std::vector<March>& marches, std::uint32_t layers) const;
  void ask(std::span<const SceneSegment> segments, std::uint32_t layers, std::span<SceneHit> hits) const;
  bool is_answered(const EngineBatch& batch) const;
  [[nodiscard]] bool makes_sense(SceneHit& hit) const;

  EngineScene def_;
  mutable std::atomic<std::uint64_t> calls_{0}, segments_{0}, refused_{0};
};

}  // namespace physim::collide
