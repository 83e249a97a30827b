// The things of a world, changed by random calls.
#pragma once

#include <cmath>
#include <vector>

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
  explicit OddScene(Odd& r) : r_(r) {}

  /// One random call.
  void act(World& w) {
    if (w.scene() == nullptr && !r_.one_in(6)) {
      Scene scene;
      static_cast<void>(scene.add_material(r_.material()));
      if (auto shape = scene.add_shape(r_.shape()))
        static_cast<void>(scene.add({.shape = *shape, .transform = r_.transform(), .sensor = r_.one_in(5)}));
      return void(w.set_scene(scene));
    }
    switch (r_.below(10)) {
      case 0: return void(r_.one_in(5) && w.remove_scene());
      case 1: return void(w.add_material(r_.material()));
      case 2:
      case 3:
        if (auto shape = w.add_shape(r_.shape())) shapes_.push_back(*shape);
        return;
      case 4: return void(w.remove_shape(some_shape()));
      case 5: return void(w.remove_instance(some_thing()));
      case 6: return void(w.move_instance(some_thing(), r_.transform()));
      case 7: return void(w.set_instance_motion(some_thing(), r_.motion()));
      case 8: return void(w.set_instance_layers(some_thing(), r_.count(3)));
      default:
        if (auto added = w.add_instance(thing())) things_.push_back(*added);
    }
  }

 private:
  [[nodiscard]] ShapeId some_shape() {
    return shapes_.empty() ? ShapeId{r_.count(3), 1} : shapes_[static_cast<std::size_t>(r_.below(int(shapes_.size())))];
  }
  [[nodiscard]] InstanceId some_thing() {
    return things_.empty() ? InstanceId{r_.count(3), 1}
                           : things_[static_cast<std::size_t>(r_.below(int(things_.size())))];
  }
  [[nodiscard]] InstanceDef thing() {
    return {.shape = some_shape(),
            .transform = r_.transform(),
            .material = {r_.count(2)},
            .layers = r_.count(3),
            .sensor = r_.one_in(4),
            .name = r_.text(),
            .motion = r_.one_in(3) ? r_.motion() : SceneMotion{}};
  }

  Odd& r_;
  std::vector<ShapeId> shapes_;
  std::vector<InstanceId> things_;
};

}  // namespace physim::test
