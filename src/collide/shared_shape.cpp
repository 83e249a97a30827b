#include "collide/shared_shape.hpp"

#include <algorithm>

#include "base/archive.hpp"
#include "base/ieee_mode.hpp"
#include "collide/content.hpp"

namespace physim {
namespace {

Error no_surface() {
  return {"is neither a mesh nor a height field", "shape", "particles come out of surfaces made of triangles"};
}

std::shared_ptr<const SharedShape::Content> content_of(std::shared_ptr<const collide::Shape> shape) {
  auto content = std::make_shared<SharedShape::Content>();
  content->shape = std::move(shape);
  PHYSIM_ASSERT(content->mesh() || content->field());
  return content;
}

}  // namespace

Result<SharedShape> SharedShape::make(const ShapeDef& shape) {
  const IeeeMode mode;
  std::shared_ptr<const collide::Shape> prepared;
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    Result<collide::Mesh> made = collide::Mesh::make({mesh->vertices, mesh->triangles, {}}, 0);
    if (!made) return made.error();
    prepared = std::make_shared<const collide::Shape>(std::move(*made));
  } else if (const auto* field = std::get_if<HeightFieldShape>(&shape)) {
    Result<collide::HeightField> made = collide::HeightField::make(*field);
    if (!made) return made.error();
    prepared = std::make_shared<const collide::Shape>(std::move(*made));
  } else {
    return no_surface();
  }
  SharedShape shared;
  shared.content_ = content_of(std::move(prepared));
  return shared;
}

Result<SharedShape> SharedShape::of(const Scene& scene, ShapeId shape) {
  const collide::SceneContent::ShapeSlot* slot = scene.impl_->find(shape);
  if (!slot) return Error{"is no shape of this scene", "shape", "add_shape() gives them"};
  const bool is_surface =
      std::holds_alternative<collide::Mesh>(*slot->shape) || std::holds_alternative<collide::HeightField>(*slot->shape);
  if (!is_surface) return no_surface();
  SharedShape shared;
  shared.content_ = content_of(slot->shape);
  return shared;
}

ShapeDef SharedShape::definition() const {
  if (!content_) return PlaneShape{};
  ShapeDef def = collide::definition_of(*content_->shape);
  if (auto* mesh = std::get_if<MeshShape>(&def)) mesh->materials.clear();
  return def;
}

std::uint64_t SharedShape::hash() const {
  if (!content_) return 0;
  std::uint64_t hash = content_->hash_of.load(std::memory_order_relaxed);
  if (hash != 0) return hash;
  hash = std::max<std::uint64_t>(hash_of(definition()), 1);
  content_->hash_of.store(hash, std::memory_order_relaxed);  // whoever else asks finds the same one
  return hash;
}

bool SharedShape::operator==(const SharedShape& other) const {
  if (content_ == other.content_) return true;
  if (!content_ || !other.content_) return false;
  return content_->shape == other.content_->shape || (hash() == other.hash() && save() == other.save());
}

std::vector<std::byte> SharedShape::save() const {
  std::vector<std::byte> bytes;
  if (content_) Writer(bytes).write(definition());
  return bytes;
}

Result<SharedShape> SharedShape::load(std::span<const std::byte> save) {
  ShapeDef def;
  Reader reader(save);
  reader(def);
  if (!reader.complete()) return Error{"these bytes are no shape", "save", "SharedShape::save() makes them"};
  return make(def);
}

}  // namespace physim
