// Questions about segments that go through a scene in turn: each stops at every look into a large mesh, asks for what
// it looks at next to be brought from memory, and others have their turn meanwhile.
//
// A Question has
//   kWhich                       which things it asks about
//   scene(), filter()            what is asked, and by what
//   asked()                      the segment; in the frame of the scene with a reach that answers shorten:
//   segment()
//   at_rest(index), at_mover(index)   looks at a thing, whole
//   step(mesh, index)            goes on in a large mesh: false where it is through
//   leaves(mesh, index)          it is through
//   end()                        it is at its end
#pragma once

#include <algorithm>

#include "collide/cast.hpp"

namespace physim::collide {

template <class Question>
class CastInTurn {
 public:
  Question question;

  /// Once the question is put. False where it is at its end already.
  bool begin() {
    const SceneContent& scene = question.scene();
    boundless_along(
        scene, Question::kWhich, question.segment(), [this](std::uint32_t index, Segment&) { question.at_rest(index); },
        [this](std::uint32_t index, Segment&) { question.at_mover(index); });
    const BoxTest test(question.segment());
    recent_ = 0;
    scene.resting.along_recent(question.segment(), test, [this](std::uint32_t index, Segment&) {
      if (recent_ < kRecent && question.scene().large_mesh(index))
        recent_meshes_[recent_++] = index;
      else
        question.at_rest(index);
    });
    std::reverse(recent_meshes_, recent_meshes_ + recent_);
    things_.begin(scene.resting, question.segment(), test);
    return go_on();
  }
  /// False where it is at its end.
  PHYSIM_INLINE bool step() {
    if (question.step(mesh_, thing_)) return true;
    question.leaves(mesh_, thing_);
    return go_on();
  }

 private:
  static constexpr std::size_t kRecent = 4;

  /// To the next large mesh, past all else.
  bool go_on() {
    const SceneContent& scene = question.scene();
    while (true) {
      thing_ = recent_ > 0 ? recent_meshes_[--recent_] : things_.next(scene.resting, question.segment());
      if (thing_ == Tree::kNone) break;
      const SceneContent::InstanceSlot& slot = scene.instances[thing_];
      const Mesh* mesh = scene.large_mesh(thing_);
      if (!mesh)
        question.at_rest(thing_);
      else if (slot.is_asked(question.filter()) && mesh_.begin(*mesh, slot.placement.inside(question.segment())))
        return true;
    }
    if (Question::kWhich != Which::resting)
      movers_along(scene, question.segment(), question.asked().time, question.asked().time + question.asked().duration,
                   [this](std::uint32_t index, Segment&) { question.at_mover(index); });
    question.end();
    return false;
  }

  std::uint32_t thing_;                   // whose mesh it is on its way through
  std::uint32_t recent_meshes_[kRecent];  // that came lately and are yet to be looked at, the first one last
  std::size_t recent_;                    // how many of those
  RestingThings::Walk things_;
  Mesh::Walk mesh_;
};

/// Several questions at a time, which go on in turn. put_next(cast) puts the next one to a cast and begins it; false
/// where there is none any more.
template <class Question, class PutNext>
void cast_in_turn(const PutNext& put_next) {
  constexpr std::size_t kTurns = 8;  // so many wait for the memory while one has its turn
  using Cast = CastInTurn<Question>;
  Cast casts[kTurns];
  Cast* active[kTurns];
  std::size_t count = 0;
  for (Cast& cast : casts)
    if (put_next(cast)) active[count++] = &cast;
  while (count > 0)
    for (std::size_t i = 0; i < count;)
      if (active[i]->step() || put_next(*active[i]))
        ++i;
      else
        active[i] = active[--count];
}

}  // namespace physim::collide
