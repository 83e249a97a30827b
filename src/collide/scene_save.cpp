// Saves of scenes: what they hold as bytes, and back.
//
// A save is its magic and format, the length of what follows (8 bytes), that, and a check sum of it (8). What follows
// begins with the version that wrote it.
#include <algorithm>
#include <cstring>
#include <string>

#include "base/archive.hpp"
#include "base/ieee_mode.hpp"
#include "base/written_by.hpp"
#include "collide/content.hpp"
#include "physim/scene.hpp"

namespace physim {

namespace collide {
namespace {

constexpr char kSceneMagic[8] = {'P', 'H', 'Y', 'S', 'I', 'M', 'C', '\n'};
constexpr std::uint32_t kSceneFormat = 5;
constexpr std::uint32_t kEngineFormat = 6;     // likewise, with the skin of an engine behind it
constexpr std::uint32_t kNamelessFormats = 2;  // lower by so much: the same without a version; they are read, too
constexpr std::uint32_t kSurfaceFormats = 2;   // higher by so much: with rules of combination and conveyors
constexpr std::size_t kSceneHead = sizeof kSceneMagic + sizeof kSceneFormat + 8, kSceneSum = 8;

struct SavedShape {
  std::uint32_t generation = 0;
  std::optional<ShapeDef> shape;  // none: the slot is free
};
struct SavedInstance {
  std::uint32_t generation = 0;
  std::optional<InstanceDef> instance;
};
struct SavedScene {
  std::vector<Material> materials;
  std::vector<SavedShape> shapes;
  std::vector<SavedInstance> instances;
  std::vector<std::uint32_t> free_shapes, free_instances;
  std::uint64_t changes = 0;
  double covered_from = 0, covered_to = 0;
};

Error not_a_scene(const std::string& message) { return {message, "save", "Scene::save() makes them"}; }

std::vector<SavedInstance> saved_instances(const SceneContent& scene) {
  std::vector<SavedInstance> list;
  for (const SceneContent::InstanceSlot& slot : scene.instances)
    list.push_back({slot.generation, slot.alive ? std::optional(slot.def) : std::nullopt});
  return list;
}

std::uint64_t sum_of_bytes(std::span<const std::byte> bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

/// Whether a list names each free slot once.
template <class Slots, class IsFree>
bool names_free(const std::vector<std::uint32_t>& list, const Slots& slots, const IsFree& is_free) {
  std::vector<bool> named(slots.size(), false);
  for (const std::uint32_t index : list) {
    if (index == 0 || index >= slots.size() || named[index] || !is_free(slots[index])) return false;
    named[index] = true;
  }
  for (std::size_t i = 1; i < slots.size(); ++i)
    if (is_free(slots[i]) && !named[i]) return false;
  return !slots.empty() && is_free(slots[0]);
}

/// Puts together what a save holds; each part is checked as it would be if it were added.
class SceneLoading {
 public:
  SceneLoading(SavedScene& saved, SceneContent& scene) : saved_(saved), scene_(scene) {}

  Status run() {
    const bool frees =
        names_free(saved_.free_shapes, saved_.shapes, [](const SavedShape& s) { return !s.shape; }) &&
        names_free(saved_.free_instances, saved_.instances, [](const SavedInstance& s) { return !s.instance; });
    const bool times =
        saved_.covered_from >= -kLatest && saved_.covered_from <= saved_.covered_to && saved_.covered_to <= kLatest;
    if (!frees || !times || saved_.materials.empty()) return not_a_scene("the save makes no sense");
    for (const Material& material : saved_.materials)
      if (auto status = check_material(material); !status) return status;
    scene_.materials = std::move(saved_.materials);
    scene_.covered_from = saved_.covered_from;
    scene_.covered_to = saved_.covered_to;
    scene_.shapes.resize(saved_.shapes.size());
    for (const bool compounds : {false, true})
      if (auto status = shapes(compounds); !status) return status;
    if (auto status = instances(); !status) return status;
    scene_.free_shapes = std::move(saved_.free_shapes);
    scene_.free_instances = std::move(saved_.free_instances);
    scene_.changes = saved_.changes;
    return {};
  }

 private:
  /// Compounds come when their parts are there.
  Status shapes(bool compounds) {
    for (std::size_t i = 0; i < saved_.shapes.size(); ++i) {
      SceneContent::ShapeSlot& slot = scene_.shapes[i];
      slot.generation = saved_.shapes[i].generation;
      const auto& def = saved_.shapes[i].shape;
      if (!def || std::holds_alternative<CompoundShape>(*def) != compounds) continue;
      std::vector<std::uint32_t> parts;
      auto shape = scene_.prepare(*def, parts);
      if (!shape) return shape.error();
      scene_.put(slot, std::move(*shape), std::move(parts));
    }
    return {};
  }
  Status instances() {
    PHYSIM_ASSERT(scene_.alive == 0 && scene_.movers.empty());
    scene_.instances.resize(saved_.instances.size());
    for (std::uint32_t i = 0; i < saved_.instances.size(); ++i) {
      scene_.instances[i].generation = saved_.instances[i].generation;
      const auto& def = saved_.instances[i].instance;
      if (!def) continue;
      auto path = scene_.check(*def);
      if (!path) return path.error();
      scene_.put(i, *def, std::move(*path));
    }
    return {};
  }

  SavedScene& saved_;
  SceneContent& scene_;
};

/// What stands between head and check sum, and its format.
struct SceneBytes {
  std::span<const std::byte> content;
  std::uint64_t format = 0;

  [[nodiscard]] bool has_version() const { return format >= kSceneFormat; }
  [[nodiscard]] bool has_surfaces() const { return format >= kSceneFormat + kSurfaceFormats; }
  [[nodiscard]] bool has_engine() const { return (kEngineFormat - format) % 2 == 0; }
};
Result<SceneBytes> scene_bytes(std::span<const std::byte> save) {
  if (save.size() < sizeof kSceneMagic || std::memcmp(save.data(), kSceneMagic, sizeof kSceneMagic) != 0)
    return not_a_scene("this is not the save of a scene");
  Reader head(save.subspan(sizeof kSceneMagic));
  std::uint64_t format = 0, length = 0, sum = 0;
  head.number(format, sizeof kSceneFormat);
  head.number(length, 8);
  if (head.good() && (format + kNamelessFormats < kSceneFormat || format > kEngineFormat + kSurfaceFormats))
    return of_other_format("save", "save", format, kSceneFormat, version_at(save.subspan(kSceneHead)));
  if (save.size() < kSceneHead + kSceneSum || length != save.size() - kSceneHead - kSceneSum)
    return not_a_scene("the save was cut, or something follows it");
  const auto content = save.subspan(kSceneHead, static_cast<std::size_t>(length));
  Reader(save.subspan(kSceneHead + content.size())).number(sum, kSceneSum);
  if (sum != sum_of_bytes(content)) return not_a_scene("the save is damaged");
  return SceneBytes{content, format};
}

}  // namespace
}  // namespace collide

std::vector<std::byte> Scene::save() const {
  collide::SavedScene saved{impl_->materials,
                            {},
                            collide::saved_instances(*impl_),
                            impl_->free_shapes,
                            impl_->free_instances,
                            impl_->changes,
                            impl_->covered_from,
                            impl_->covered_to};
  for (const Impl::ShapeSlot& slot : impl_->shapes)
    saved.shapes.push_back(
        {slot.generation, slot.shape ? std::optional(collide::definition_of(*slot.shape)) : std::nullopt});
  std::vector<std::byte> content, bytes;
  const bool has_surfaces =
      impl_->conveyors > 0 || impl_->one_ways > 0 || impl_->tells_stay > 0 ||
      std::ranges::any_of(impl_->materials, [](const Material& material) { return material.combine != CombineDef{}; });
  Writer of_content(content);
  if (!has_surfaces) of_content.leave_out_surfaces();
  of_content.write(std::string(kVersion), saved);
  if (impl_->engine) Writer(content).write(skin());
  for (const char c : collide::kSceneMagic) bytes.push_back(static_cast<std::byte>(c));
  Writer writer(bytes);
  const std::uint32_t format = impl_->engine ? collide::kEngineFormat : collide::kSceneFormat;
  writer.number(has_surfaces ? format + collide::kSurfaceFormats : format, sizeof format);
  writer.number(content.size(), 8);
  bytes.insert(bytes.end(), content.begin(), content.end());
  writer.number(collide::sum_of_bytes(content), collide::kSceneSum);
  return bytes;
}

Result<Scene> Scene::load(std::span<const std::byte> save, const EngineQuery& query) {
  const IeeeMode mode;
  const auto bytes = collide::scene_bytes(save);
  if (!bytes) return bytes.error();
  const bool has_engine = bytes->has_engine();
  collide::SavedScene saved;
  EngineScene engine{has_engine ? query : EngineQuery{}};
  std::string made_by;
  Reader reader(bytes->content);
  if (bytes->has_version()) reader(made_by);
  if (!bytes->has_surfaces()) reader.leave_out_surfaces();
  reader(saved);
  if (has_engine) reader(engine.skin);
  if (!reader.complete()) return collide::not_a_scene("the save makes no sense" + by_another_version(made_by));
  if (has_engine && !query)
    return Error{"the scene has an engine, and no function was given", "query", "no file holds functions: give it"};
  Scene scene;
  if (auto status = scene.set_engine(engine); !status) return status.error();
  if (auto status = collide::SceneLoading(saved, *scene.impl_).run(); !status) return status.error();
  return scene;
}

std::uint64_t Scene::hash() const {
  Hasher hasher;
  hasher.add(impl_->materials);
  hasher.count(impl_->instances.size());
  for (const Impl::InstanceSlot& slot : impl_->instances) {  // where they stand: definitions are not copied
    hasher.add(slot.generation, slot.alive);
    if (slot.alive) hasher.add(slot.def);
  }
  hasher.add(impl_->free_shapes, impl_->free_instances);
  for (const Impl::ShapeSlot& slot : impl_->shapes) {
    std::uint64_t hash = 0;
    if (slot.shape && (hash = slot.hash->load(std::memory_order_relaxed)) == 0) {
      hash = std::max<std::uint64_t>(hash_of(collide::definition_of(*slot.shape)), 1);
      slot.hash->store(hash, std::memory_order_relaxed);  // whoever else asks finds the same one
    }
    hasher.add(slot.generation, hash);
  }
  if (impl_->engine) hasher.add(skin());
  return hasher.value();
}

}  // namespace physim
