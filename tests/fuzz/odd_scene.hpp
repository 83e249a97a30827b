// The things of a world, changed by random calls.
#pragma once

#include "fuzz/odd_input.hpp"

namespace physim::test {

/// Says something about hits, and what nobody should; it follows from the hit alone.
inline void answer_oddly(const HitBatch& batch) {
  for (std::size_t i = 0; i < batch.questions.size(); ++i) {
    const HitQuestion& q = batch.questions[i];
    const int what = static_cast<int>(std::abs(std::fmod(q.position.x * 977, 32)));
    if (what == 31) throw what;
    batch.answers[i].then = static_cast<OnHit>(what % 8);  // two of them are none
    if (what >= 16) batch.answers[i].velocity = q.velocity * (what % 3 - 1.0);
    if (what == 30) batch.answers[i].velocity = Vec3d{std::nan(""), 0, 0};
  }
}

class OddScene {
 public:
  /// One random call.
  void act(World& w, Odd& r) {
    if (w.scene() == nullptr && !r.one_in(6)) {
      Scene scene;
      static_cast<void>(scene.add_material(r.material()));
      if (auto shape = scene.add_shape(r.shape()))
        static_cast<void>(scene.add({.shape = *shape, .transform = r.transform(), .sensor = r.one_in(5)}));
      return void(w.set_scene(scene));
    }
    switch (r.below(10)) {
      case 0: return void(r.one_in(5) && w.remove_scene());
      case 1: return void(w.add_material(r.material()));
      case 2:
      case 3:
        if (auto shape = w.add_shape(r.shape())) shapes_.push_back(*shape);
        return;
      case 4: return void(w.remove_shape(some_shape(r)));
      case 5: return void(w.remove_instance(some_thing(r)));
      case 6: return void(w.move_instance(some_thing(r), r.transform()));
      case 7: return void(w.set_instance_motion(some_thing(r), r.motion()));
      case 8: return void(w.set_instance_layers(some_thing(r), r.count(3)));
      default:
        if (auto added = w.add_instance(thing(r))) things_.push_back(*added);
    }
  }

 private:
  [[nodiscard]] ShapeId some_shape(Odd& r) {
    return shapes_.empty() ? ShapeId{r.count(3), 1} : shapes_[static_cast<std::size_t>(r.below(int(shapes_.size())))];
  }
  [[nodiscard]] InstanceId some_thing(Odd& r) {
    return things_.empty() ? InstanceId{r.count(3), 1}
                           : things_[static_cast<std::size_t>(r.below(int(things_.size())))];
  }
  [[nodiscard]] InstanceDef thing(Odd& r) {
    return {.shape = some_shape(r),
            .transform = r.transform(),
            .material = {r.count(2)},
            .layers = r.count(3),
            .sensor = r.one_in(4),
            .name = r.text(),
            .motion = r.one_in(3) ? r.motion() : SceneMotion{}};
  }

  std::vector<ShapeId> shapes_;
  std::vector<InstanceId> things_;
};

}  // namespace physim::test
