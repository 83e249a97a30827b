#include "collide/clear_batch.hpp"

#include "collide/cast_crowd.hpp"
#include "collide/cast_field.hpp"
#include "collide/clear_look.hpp"

namespace physim::collide {
namespace {

/// How far along a segment nothing that rests can be touched.
class ClearPart {
 public:
  static constexpr Which kWhich = Which::resting;
  static constexpr Asks kAsks = Asks::clear_part;

  /// False where it makes no sense.
  bool put(const SceneContent& scene, ClearQuery& query) {
    const SceneSegment& asked = query.segment;
    scene_ = &scene;
    query_ = &query;
    filter_ = {.layers = query.layers};
    segment_ = {asked.from, asked.to - asked.from, asked.radius, 1};
    query.part = 0;
    return is_sound(asked);
  }
  [[nodiscard]] const SceneContent& scene() const { return *scene_; }
  [[nodiscard]] const SceneFilter& filter() const { return filter_; }
  [[nodiscard]] const SceneSegment& asked() const { return query_->segment; }
  [[nodiscard]] Segment& segment() { return segment_; }
  void at_rest(std::uint32_t index) { look().at_rest(index, segment_); }
  void at_mover(std::uint32_t) {}
  void leaves(std::uint32_t index, const Segment& inside) {
    ClearLook::shorten(scene_->instances[index], inside.reach, segment_);
  }
  void end() { query_->part = std::max(0.0, segment_.reach); }

 private:
  [[nodiscard]] ClearLook look() const { return {*scene_, query_->segment, filter_}; }

  const SceneContent* scene_;
  ClearQuery* query_;
  SceneFilter filter_;
  Segment segment_;
};

void clear_of_field_alone(const SceneContent& scene, std::span<ClearQuery> queries) {
  for (ClearQuery& query : queries) {
    const SceneSegment& asked = query.segment;
    Segment segment{asked.from, asked.to - asked.from, asked.radius, 1};
    query.part = 0;
    if (!is_sound(asked)) continue;
    ClearLook{scene, asked, {.layers = query.layers}}.at_rest(scene.fields[0], segment);
    query.part = std::max(0.0, segment.reach);
  }
}

}  // namespace

void clear_parts(const SceneContent& scene, std::span<ClearQuery> queries) {
  std::size_t next = 0;
  PHYSIM_ASSERT(!scene.engine);  // nobody knows how far its things are
  if (is_field_alone(scene)) return clear_of_field_alone(scene, queries);
  CastCrowd<ClearPart> crowd;
  crowd.cast([&](ClearPart& question) {
    while (next < queries.size())
      if (question.put(scene, queries[next++])) return true;
    return false;
  });
}

}  // namespace physim::collide
