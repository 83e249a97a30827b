// Questions about many segments at once: first all of them go through the tree of things, then through the trees of the
// meshes that they come to, node by node in no order (box_job.hpp). Whatever else they meet is asked one by one.
//
// A crowd is some 75 kB, half of which are pairs that wait. It lies on the stack, of which threads have 8 MB on Linux
// and half a megabyte on macOS, and is set to nothing: so whoever asks needs no memory, and may do so from any number
// of threads.
//
// A Question has
//   kWhich                       which things it asks about
//   scene(), filter()            what is asked, and by what
//   asked()                      the segment; in the frame of the scene with a reach that answers shorten:
//   segment()
//   at_rest(index), at_mover(index)   looks at a thing, whole
//   kAsks                        what it wants to know of the triangles of meshes; where that is what it meets first,
//   look(mesh, index, first, end, inside)   looks at some of them, which may shorten the reach of the segment in their
//                                frame
//   pass(mesh, index, triangle, t, inside)   likewise, of a point, the line of which passes a triangle at t
//   leaves(index, inside)        it is through the mesh
//   end()                        it is at its end
#pragma once

#include <algorithm>
#include <array>

#include "base/unset.hpp"
#include "collide/box_job.hpp"
#include "collide/cast.hpp"

namespace physim::collide {

/// Rays on their way through trees, and the pairs of them that wait.
template <class Cast>
class RayCrowd {
 public:
  static constexpr std::uint32_t kMost = 64, kMostItems = 8 * kMost;

  [[nodiscard]] bool is_full() const { return count_ == kMost; }
  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// What a ray is cast for.
  [[nodiscard]] Cast& cast(std::uint32_t ray) { return (*casts_)[ray]; }
  [[nodiscard]] Cast* casts() { return &(*casts_)[0]; }
  /// What the next one will be cast for.
  [[nodiscard]] Cast& next() {
    PHYSIM_ASSERT(!is_full());
    return (*casts_)[count_];
  }
  /// Puts the next one into a tree, for a segment; false where that passes the tree.
  PHYSIM_INLINE bool add(const Bvh& tree, const Segment& segment) {
    PHYSIM_ASSERT(!is_full());
    TreeRay& ray = (*rays_)[count_];
    const double base = tree.begin(segment, ray);
    if (base == kInfinity) return false;
    ray.nodes = tree.nodes();
    (*bases_)[count_] = base;
    ray_[waiting_] = count_++;
    child_[waiting_++] = 0;
    return true;
  }
  PHYSIM_INLINE void set_reach(std::uint32_t ray, double reach) { (*rays_)[ray].set_reach(reach, (*bases_)[ray]); }
  /// Takes all of them to their ends: calls take(items) for pairs of a ray and a child with items that it meets.
  template <class Take>
  void walk(const BoxKernel& kernel, const Take& take) {
    std::uint32_t from_ray[kMost], from_child[kMost], item_ray[kMostItems + 8], item_child[kMostItems + 8];
    while (waiting_ > 0) {
      const std::size_t most = std::max<std::size_t>(1, (kRoom - kReserve - std::min(kRoom - kReserve, waiting_)) / 8);
      const std::size_t some = std::min({waiting_, most, std::size_t{kMost}});
      waiting_ -= some;
      std::copy_n(ray_ + waiting_, some, from_ray);
      std::copy_n(child_ + waiting_, some, from_child);
      BoxJob job{&(*rays_)[0], {from_ray, from_child, some}, {ray_, child_, waiting_}, {item_ray, item_child, 0}};
      kernel.enter(job);
      waiting_ = job.nodes.count;
      PHYSIM_ASSERT(waiting_ + 8 <= kRoom && job.items.count <= kMostItems);
      take(job.items);
    }
    count_ = 0;
  }

 private:
  // A pair leaves seven more on each level below it. Pairs are looked at one by one where the reserve for that begins.
  static constexpr std::size_t kReserve = 7 * Bvh::kMostLevels + 16, kRoom = 2048;

  std::uint32_t count_ = 0;
  std::size_t waiting_ = 0;
  Unset<std::array<TreeRay, kMost>> rays_;
  Unset<std::array<double, kMost>> bases_;
  Unset<std::array<Cast, kMost>> casts_;
  std::uint32_t ray_[kRoom], child_[kRoom];
};

enum class Asks { first_hit, clear_part };

template <class Question>
class CastCrowd {
 public:
  /// put_next(question) puts the next one; false where there is none any more.
  template <class PutNext>
  void cast(const PutNext& put_next) {
    bool some = true;
    while (some) {
      std::uint32_t count = 0;
      while (count < kMost && (some = put_next((*questions_)[count]))) begin(count++);
      things_.walk(kernel_, [this](const BoxPairs& items) { come_to(items); });
      walk_meshes();
      for (std::uint32_t i = 0; i < count; ++i) end((*questions_)[i]);
    }
  }

 private:
  static constexpr std::uint32_t kMost = RayCrowd<std::uint32_t>::kMost;

  void begin(std::uint32_t number) {
    Question& question = (*questions_)[number];
    const SceneContent& scene = question.scene();
    boundless_along(
        scene, Question::kWhich, question.segment(), [&](std::uint32_t index, Segment&) { question.at_rest(index); },
        [&](std::uint32_t index, Segment&) { question.at_mover(index); });
    if (scene.resting.tree().is_empty()) return;
    things_.next() = number;
    things_.add(scene.resting.tree(), question.segment());
  }
  void come_to(std::uint32_t number, std::uint32_t index) {
    Question& question = (*questions_)[number];
    const SceneContent::InstanceSlot& slot = question.scene().instances[index];
    const Mesh* mesh = std::get_if<Mesh>(slot.shape.get());
    if (!mesh) return question.at_rest(index);
    if (!slot.is_asked(question.filter())) return;
    if (meshes_.is_full()) walk_meshes();
    MeshRay& in = meshes_.next();
    in.segment = slot.placement.inside(question.segment());
    in.vertices = mesh->vertices();
    in.corners = &mesh->corners(0);
    in.mesh = mesh;
    in.question = number;
    in.thing = index;
    meshes_.add(mesh->tree(), in.segment);
  }
  void come_to(const BoxPairs& items) {
    const SceneContent& scene = (*questions_)[0].scene();
    const auto for_things = [&](const auto& call) {
      for (std::size_t i = 0; i < items.count; ++i) {
        const BvhChild child(items.child[i]);
        for (std::uint32_t place = child.first(); place < child.end(); ++place)
          if (const std::uint32_t thing = scene.resting.thing(place); thing != RestingThings::kNone)
            call(items.ray[i], thing);
      }
    };
    for_things([&](std::uint32_t, std::uint32_t thing) { scene.instances[thing].prefetch(); });
    for_things([&](std::uint32_t ray, std::uint32_t thing) { come_to(things_.cast(ray), thing); });
  }
  void walk_meshes() {
    const std::uint32_t count = meshes_.count();
    meshes_.walk(kernel_, [this](BoxPairs& items) {
      const auto for_items = [&](const auto& call) {
        for (std::size_t i = 0; i < items.count; ++i) call(items.ray[i], BvhChild(items.child[i]));
      };
      for_items([&](std::uint32_t ray, BvhChild child) {
        meshes_.cast(ray).mesh->prefetch_triangles(child.first(), child.end());
      });
      for_items([&](std::uint32_t ray, BvhChild child) {
        meshes_.cast(ray).mesh->prefetch_corners(child.first(), child.end());
      });
      if constexpr (Question::kAsks == Asks::clear_part)
        kernel_.clear({meshes_.casts(), items});
      else
        pass(items);
      for_items([&](std::uint32_t ray, BvhChild child) {
        MeshRay& in = meshes_.cast(ray);
        if constexpr (Question::kAsks == Asks::first_hit)
          (*questions_)[in.question].look(*in.mesh, in.thing, child.first(), child.end(), in.segment);
        meshes_.set_reach(ray, in.segment.reach);
      });
    });
    for (std::uint32_t i = 0; i < count; ++i) {
      const MeshRay& in = meshes_.cast(i);
      (*questions_)[in.question].leaves(in.thing, in.segment);
    }
  }
  /// Looks at the triangles of points, and leaves those of spheres.
  void pass(BoxPairs& items) {
    std::uint32_t ray[kMost], child[kMost];
    BoxPairs points{ray, child, 0};
    std::size_t spheres = 0;
    for (std::size_t i = 0; i < items.count; ++i) {
      const bool is_sphere = meshes_.cast(items.ray[i]).segment.radius > 0;
      const BoxPairs& into = is_sphere ? items : points;
      std::size_t& count = is_sphere ? spheres : points.count;
      into.ray[count] = items.ray[i];
      into.child[count++] = items.child[i];
      if (points.count == kMost) pass_points(points);
    }
    items.count = spheres;
    pass_points(points);
  }
  void pass_points(BoxPairs& points) {
    PassedTriangle passed[BvhChild::kMostItems * kMost + 1];
    TriangleJob job{meshes_.casts(), points, passed, 0};
    kernel_.pass(job);
    PHYSIM_ASSERT(job.count <= BvhChild::kMostItems * points.count);
    for (std::size_t i = 0; i < job.count; ++i) {
      MeshRay& in = meshes_.cast(passed[i].ray);
      (*questions_)[in.question].pass(*in.mesh, in.thing, passed[i].place, passed[i].t, in.segment);
      meshes_.set_reach(passed[i].ray, in.segment.reach);
    }
    points.count = 0;
  }
  void end(Question& question) {
    const SceneContent& scene = question.scene();
    const SceneSegment& asked = question.asked();
    if (Question::kWhich != Which::resting)
      movers_along(scene, question.segment(), asked.time, asked.time + asked.duration,
                   [&](std::uint32_t index, Segment&) { question.at_mover(index); });
    question.end();
  }

  const BoxKernel& kernel_ = box_kernel();
  Unset<std::array<Question, kMost>> questions_;
  RayCrowd<std::uint32_t> things_;  // of questions
  RayCrowd<MeshRay> meshes_;
};

}  // namespace physim::collide
