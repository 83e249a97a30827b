#include "collide/engine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.hpp"
#include "base/restored.hpp"
#include "collide/question.hpp"
#include "math/vec3.hpp"

namespace physim::collide {
namespace {

constexpr double kReach = 30;  // a segment is cast so many skins longer, and a hit moved back by as many at most

/// The engine that this thread asks at the moment: what it asks meanwhile is not handed to it again.
thread_local const Engine* in_question = nullptr;

[[nodiscard]] double length_of(const SceneSegment& s) { return length(s.to - s.from); }

/// With its normal towards who meets it.
[[nodiscard]] Vec3d facing(const SceneHit& hit) { return hit.entering || hit.starts_inside ? hit.normal : -hit.normal; }

/// The hit on the surface one skin in front of the one that the engine met on a longer segment; its part is beyond 1
/// where the segment ends before. What starts within the skin is met as soon as it comes a little nearer, and put back
/// to where the skin begins: rounding must not add up.
[[nodiscard]] SceneHit with_skin(SceneHit hit, const SceneSegment& asked, double longer, double skin) {
  const Vec3d way = asked.to - asked.from;
  const double far = length(way);
  if (hit.starts_inside) {
    hit.part = 0;
    hit.position = asked.from;
    hit.time = asked.time;
    return hit;
  }
  const double closing = -dot(facing(hit), way - hit.velocity * asked.duration);  // over the segment [m]
  if (!(closing > 0)) return {};                                                  // it moves away, or along
  constexpr double kNearer = 1e-3;
  const double touched = hit.part * (longer / far);
  const double outside = touched - std::min(skin / closing, kReach * skin / far);
  hit.part = std::max(outside, std::min(touched, kNearer * skin / closing));
  const double inside = std::max(skin - (touched - hit.part) * closing, 0.0);
  hit.position = asked.from + way * hit.part + facing(hit) * inside;
  hit.time = asked.time + asked.duration * hit.part;
  return hit;
}

}  // namespace

bool Engine::is_answered(const EngineBatch& batch) const {
  const Restored<const Engine*> asking(in_question, this);
  calls_.fetch_add(1, std::memory_order_relaxed);
  segments_.fetch_add(batch.segments.size(), std::memory_order_relaxed);
  try {
    def_.query(batch);
    return true;
  } catch (...) {
    std::ranges::fill(batch.hits, SceneHit{});
    return false;
  }
}

/// One call; where it throws, one for each segment.
void Engine::ask(std::span<const SceneSegment> segments, std::uint32_t layers, std::span<SceneHit> hits) const {
  PHYSIM_ASSERT(segments.size() == hits.size());
  if (segments.empty() || in_question == this) return;
  if (!is_answered({segments, layers, hits}))
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (!is_answered({segments.subspan(i, 1), layers, hits.subspan(i, 1)}))
        refused_.fetch_add(1, std::memory_order_relaxed);
  for (SceneHit& hit : hits)
    if (hit.instance.index != 0 && !makes_sense(hit)) hit = {}, refused_.fetch_add(1, std::memory_order_relaxed);
}

/// Whether it is a hit; what is known of every one is put right.
bool Engine::makes_sense(SceneHit& hit) const {
  const double size = length(hit.normal);
  if (!(hit.part >= 0 && hit.part <= 1 && size > 1e-6 && size < 1e6 && length(hit.velocity) <= 1e9)) return false;
  hit.normal = hit.normal * (1 / size);
  hit.instance.generation = kEngineGeneration;
  return true;
}

void Engine::first_hits(std::span<const SceneSegment> segments, std::uint32_t layers, std::span<SceneHit> into) const {
  PHYSIM_ASSERT(segments.size() == into.size());
  if (layers == 0) return;
  std::vector<SceneSegment> longer;
  std::vector<std::size_t> whose;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    SceneSegment s = segments[i];
    const double far = is_sound(s) ? length_of(s) : 0;
    if (!(far > 0)) continue;
    s.to += (s.to - s.from) * (kReach * def_.skin / far);
    longer.push_back(s);
    whose.push_back(i);
  }
  std::vector<SceneHit> hits(longer.size());
  ask(longer, layers, hits);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (!hits[k]) continue;
    SceneHit& best = into[whose[k]];
    const SceneHit hit = with_skin(hits[k], segments[whose[k]], length_of(longer[k]), def_.skin);
    if (hit && hit.part <= 1 && (!best || hit.part < best.part)) best = hit;
  }
}

namespace {

/// So near to each other, surfaces are one; so far behind one the next question starts [m].
double apart_at(const Vec3d& x, double skin) {
  return std::max(0.1 * skin, 1e-15 * (std::abs(x.x) + std::abs(x.y) + std::abs(x.z)));
}

}  // namespace

/// One piece of a segment, from one of its ends: each surface is asked about from behind the one before.
struct Engine::March {
  SceneSegment rest;  // that is still to be asked about
  Vec3d along;        // of length one
  std::vector<SceneHit> met{};
  bool goes_on = true;

  void take(const SceneHit& hit, double skin) {
    goes_on = hit && !hit.starts_inside;
    if (!goes_on) return;
    const Vec3d at = rest.from + (rest.to - rest.from) * hit.part;
    if (dot(facing(hit), along) <= 0) met.push_back(hit), met.back().position = at;
    rest.from = at + along * apart_at(at, skin);
    goes_on = dot(rest.to - rest.from, along) > 0;
  }
};

/// In pieces, the nearest ones short, and each from both ends: solids are met from outside alone, and an engine's
/// numbers are the better the shorter a segment is.
std::vector<Engine::March> Engine::marches_along(const SceneSegment& segment, double far) {
  PHYSIM_ASSERT(far > 0);
  constexpr double kFirst = 1, kLonger = 10;  // [m], [-]
  const Vec3d along = (segment.to - segment.from) * (1 / far);
  std::vector<March> marches;
  double begin = 0;
  for (double end = kFirst; begin < far; begin = end, end *= kLonger) {
    SceneSegment piece{segment.from + along * begin, end < far ? segment.from + along * end : segment.to};
    piece.time = segment.time + segment.duration * (begin / far);
    marches.push_back({piece, along});
    std::swap(piece.from, piece.to);
    marches.push_back({piece, -along});
  }
  return marches;
}

/// All of them side by side, so that each round is one call.
void Engine::march(std::vector<March>& marches, std::uint32_t layers) const {
  constexpr int kMostSurfaces = 64;  // in a piece, from one end
  std::vector<SceneSegment> asked;
  std::vector<March*> whose;
  std::vector<SceneHit> answers;
  for (int round = 0; round < kMostSurfaces; ++round) {
    asked.clear(), whose.clear();
    for (March& m : marches)
      if (m.goes_on) asked.push_back(m.rest), whose.push_back(&m);
    if (asked.empty()) return;
    answers.assign(asked.size(), {});
    ask(asked, layers, answers);
    for (std::size_t i = 0; i < answers.size(); ++i) whose[i]->take(answers[i], def_.skin);
  }
}

void Engine::all_hits(const SceneSegment& segment, std::uint32_t layers, std::vector<SceneHit>& hits) const {
  const double far = is_sound(segment) ? length_of(segment) : 0;
  if (!(far > 0) || layers == 0) return;
  std::vector<March> marches = marches_along(segment, far);
  march(marches, layers);
  const Vec3d along = (segment.to - segment.from) * (1 / far);
  const auto own = static_cast<std::ptrdiff_t>(hits.size());
  for (const bool forwards : {true, false})
    for (std::size_t m = forwards ? 0 : 1; m < marches.size(); m += 2)
      for (SceneHit& hit : marches[m].met) {
        const bool is_known = std::any_of(hits.begin() + own, hits.end(), [&](const SceneHit& other) {
          return other.instance == hit.instance &&
                 length(other.position - hit.position) <= 2 * apart_at(hit.position, def_.skin);
        });
        if (is_known) continue;  // from the other side, or by two pieces
        if (!forwards) hit.entering = !hit.entering;
        hit.part = std::clamp(dot(hit.position - segment.from, along) / far, 0.0, 1.0);
        hit.time = segment.time + segment.duration * hit.part;
        hits.push_back(hit);
      }
}

}  // namespace physim::collide
