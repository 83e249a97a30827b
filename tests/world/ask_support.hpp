// Hits that ask: what tests of them share.
#pragma once

#include "random_shots.hpp"
#include "scene_support.hpp"

namespace physim::test_ask {

using test::kNan;
using test::same_bits;
using test_scene::in_the_open;
using test_scene::put;
using test_scene::room;

inline HitFunction always(const HitAnswer& answer) {
  return [answer](const HitBatch& batch) { std::ranges::fill(batch.answers, answer); };
}
/// What follows from the question alone, and differs from hit to hit.
inline void answer_by_place(const HitBatch& batch) {
  constexpr OnHit kAll[] = {OnHit::bounce, OnHit::impact, OnHit::bounce, OnHit::pass,
                            OnHit::bounce, OnHit::stick,  OnHit::bounce, OnHit::stop};
  for (std::size_t i = 0; i < batch.questions.size(); ++i) {
    const HitQuestion& q = batch.questions[i];
    batch.answers[i].then = kAll[static_cast<std::size_t>(std::abs(q.position.x + q.position.z) * 1000) % 8];
  }
}

inline void expect_same(const World& one, const World& other, std::size_t& hits) {
  ASSERT_EQ(one.events().size(), other.events().size()) << "at " << one.time() << " s";
  for (std::size_t k = 0; k < one.events().size(); ++k) {
    const Event &a = one.events()[k], &b = other.events()[k];
    ASSERT_EQ(a.kind, b.kind);
    ASSERT_EQ(a.id, b.id);
    ASSERT_EQ(a.reason, b.reason);
    ASSERT_EQ(a.instance, b.instance);
    ASSERT_EQ(a.primitive, b.primitive);
    ASSERT_EQ(a.other, b.other);
    ASSERT_TRUE(same_bits(a.time, b.time) && same_bits(a.value, b.value) && same_bits(a.energy, b.energy));
    ASSERT_TRUE(same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity));
    ASSERT_TRUE(same_bits(a.normal, b.normal));
    hits += a.kind == EventKind::hit && a.instance ? 1 : 0;
  }
  const std::vector<ProjectileId> ids = one.ids();
  ASSERT_EQ(ids, other.ids());
  for (const ProjectileId id : ids) {
    ASSERT_TRUE(same_bits(one[id].position(), other[id].position()));
    ASSERT_TRUE(same_bits(one[id].velocity(), other[id].velocity()));
    ASSERT_TRUE(same_bits(one[id].angular_velocity(), other[id].angular_velocity()));
    ASSERT_EQ(one[id].status(), other[id].status());
  }
}

}  // namespace physim::test_ask
