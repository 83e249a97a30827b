// Bytes that this library wrote: saves of worlds and scenes, recordings, parts of studies. Check sums are put right, so
// that what they guard is reached.
#include <algorithm>

#include "base/archive.hpp"
#include "fuzz/covered/target.hpp"
#include "physim/physim.h"
#include "physim/world.hpp"

namespace physim::test {
namespace {

constexpr char kSceneMagic[8] = {'P', 'H', 'Y', 'S', 'I', 'M', 'C', '\n'};
constexpr std::size_t kHead = 8 + 4 + 8, kSum = 8;  // of saves: magic, format, length
constexpr std::size_t kMostRows = 200;              // of worlds that are stepped

std::uint64_t sum_of(std::span<const std::byte> bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

/// A save of a content that follows its format.
Bytes sealed(const char* magic, std::span<const std::byte> format_and_content) {
  const std::size_t format = std::min<std::size_t>(format_and_content.size(), 4);
  const auto content = format_and_content.subspan(format);
  Bytes bytes = bytes_of(std::string(magic, 8));
  bytes.insert(bytes.end(), format_and_content.begin(), format_and_content.begin() + std::ptrdiff_t(format));
  bytes.resize(12);
  Writer writer(bytes);
  writer.number(content.size(), 8);
  bytes.insert(bytes.end(), content.begin(), content.end());
  writer.number(sum_of(content), kSum);
  return bytes;
}

/// What `sealed()` makes a save of.
Bytes opened(const physim_bytes* save) {
  const void* data = nullptr;
  std::size_t size = 0;
  claim(physim_bytes_data(save, &data, &size) == PHYSIM_OK && size > kHead + kSum, "a save has bytes");
  const auto* first = static_cast<const std::byte*>(data);
  Bytes bytes(first + 8, first + 12);
  bytes.insert(bytes.end(), first + kHead, first + size - kSum);
  return bytes;
}

struct Freed {
  const void* handle;
  ~Freed() { claim(physim_free(handle) == PHYSIM_OK, "what was made is freed"); }
};

void refused() { claim(*physim_last_error() != '\0', "a refusal says why"); }

/// Steps a world, reads it, and takes it through another save.
void use(physim_world* world) {
  physim_world_info info{};
  info.size = sizeof info;
  claim(physim_world_read(world, &info) == PHYSIM_OK, "a world that was loaded is read");
  for (int i = 0; i < 3 && info.projectiles <= kMostRows; ++i) {
    if (physim_world_step(world, 1, 1.0 / 60) != PHYSIM_OK) refused();
    claim(physim_world_read(world, &info) == PHYSIM_OK, "a world that was stepped is read");
  }
  physim_bytes* save = nullptr;
  if (physim_save(world, &save) != PHYSIM_OK) return refused();
  const Freed freed{save};
  const void* data = nullptr;
  std::size_t size = 0;
  claim(physim_bytes_data(save, &data, &size) == PHYSIM_OK, "a save has bytes");
  physim_world* again = nullptr;
  claim(physim_world_load(data, size, nullptr, nullptr, &again) == PHYSIM_OK, "what was saved is loaded");
  const Freed freed_again{again};
  std::uint64_t before = 0, after = 0;
  claim(physim_world_hash(world, &before) == PHYSIM_OK && physim_world_hash(again, &after) == PHYSIM_OK &&
            before == after,
        "it is the same world");
}

void load_world(std::span<const std::byte> bytes) {
  const Bytes save = sealed(kSaveMagic, bytes);
  physim_world* world = nullptr;
  if (physim_world_load(save.data(), save.size(), nullptr, nullptr, &world) != PHYSIM_OK) return refused();
  const Freed freed{world};
  use(world);
}

void load_scene(std::span<const std::byte> bytes) {
  const Bytes save = sealed(kSceneMagic, bytes);
  physim_scene* scene = nullptr;
  if (physim_scene_load(save.data(), save.size(), nullptr, &scene) != PHYSIM_OK) return refused();
  const Freed freed{scene};
  const physim_segment ways[] = {{{-100, 1, 0}, {100, 1, 0.5}, 0, 0, 0}, {{0, 50, 0}, {0, -50, 1}, 0.2, 1, 0.5}};
  physim_hit hits[2];
  if (physim_scene_cast(scene, ways, 2, ~0U, hits, sizeof hits[0], nullptr) != PHYSIM_OK) refused();
  physim_bytes* again = nullptr;
  if (physim_save(scene, &again) != PHYSIM_OK) return refused();
  const Freed freed_again{again};
  const Bytes same = sealed(kSceneMagic, opened(again));
  physim_scene* other = nullptr;
  claim(physim_scene_load(same.data(), same.size(), nullptr, &other) == PHYSIM_OK, "a scene that was saved is loaded");
  const Freed freed_other{other};
}

/// Frames of a recording without their check sums: call, length in 4 bytes, content.
void replay(std::span<const std::byte> bytes) {
  Bytes recording = bytes_of(std::string(kRecordingMagic, 8));
  Writer writer(recording);
  writer.number(kRecordingFormat, sizeof kRecordingFormat);
  std::uint64_t chained = 0;
  while (bytes.size() >= 5) {
    std::uint64_t length = 0;
    Reader(bytes.subspan(1)).number(length, 4);
    length = std::min<std::uint64_t>(length, bytes.size() - 5);
    const std::size_t begin = recording.size();
    recording.push_back(bytes[0]);
    writer.number(length, 4);
    const auto content = bytes.subspan(5, static_cast<std::size_t>(length));
    recording.insert(recording.end(), content.begin(), content.end());
    Hash hash(chained);
    hash.add(std::span<const std::byte>(recording).subspan(begin));
    chained = hash.value();
    writer.number(static_cast<std::uint32_t>(chained ^ chained >> 32), 4);
    bytes = bytes.subspan(5 + content.size());
  }
  physim_world* world = nullptr;
  if (physim_replay_open(recording.data(), recording.size(), nullptr, &world) != PHYSIM_OK) return refused();
  const Freed freed{world};
  std::int32_t more = 1;
  for (int i = 0; i < 100 && more != 0; ++i)
    if (physim_replay_next(world, 0, &more, nullptr) != PHYSIM_OK) return refused();
  std::int32_t there = 0;
  if (physim_replay_seek(world, 1, &there, nullptr) != PHYSIM_OK) refused();
  if (physim_replay_seek(world, 0, &there, nullptr) != PHYSIM_OK) refused();
}

Bytes without_sums(const physim_bytes* recording) {
  const void* data = nullptr;
  std::size_t size = 0;
  claim(physim_bytes_data(recording, &data, &size) == PHYSIM_OK, "a recording has bytes");
  std::span<const std::byte> rest(static_cast<const std::byte*>(data), size);
  rest = rest.subspan(12);
  Bytes frames;
  while (rest.size() >= 5) {
    std::uint64_t length = 0;
    Reader(rest.subspan(1)).number(length, 4);
    const auto frame = rest.first(5 + static_cast<std::size_t>(length));
    frames.insert(frames.end(), frame.begin(), frame.end());
    rest = rest.subspan(frame.size() + 4);
  }
  return frames;
}

void load_part(std::span<const std::byte> bytes) {
  Bytes part(bytes.begin(), bytes.end());
  Writer(part).number(hash_of(part), 8);
  physim_part *loaded = nullptr, *joined = nullptr;
  if (physim_part_load(part.data(), part.size(), &loaded) != PHYSIM_OK) return refused();
  const Freed freed{loaded};
  if (physim_part_join(loaded, loaded, &joined) != PHYSIM_OK) return refused();
  const Freed freed_too{joined};
  physim_bytes* saved = nullptr;
  if (physim_save(joined, &saved) != PHYSIM_OK) return refused();
  const Freed freed_bytes{saved};
  static physim_study* const study = [] {
    physim_def* def = nullptr;
    physim_study* made = nullptr;
    claim(physim_def_create(scenario_texts().front().c_str(), nullptr, &def) == PHYSIM_OK, "a scenario is read");
    return physim_study_create(def, nullptr, &made) == PHYSIM_OK ? made : nullptr;
  }();
  physim_figures* figures = nullptr;
  if (study && physim_study_figures(study, loaded, 1, &figures) == PHYSIM_OK) physim_free(figures);
}

// ------------------------------------------------------------------------------------------------------------- seeds

/// Calls `look(def)` with each scenario that is read.
template <class F>
void each_scenario(const F& look) {
  for (const std::string& text : scenario_texts()) {
    physim_def* def = nullptr;
    if (physim_def_create(text.c_str(), PHYSIM_SOURCE_DIR "/scenarios/fuzz.toml", &def) != PHYSIM_OK) continue;
    const Freed freed{def};
    look(def);
  }
}

/// A world with all kinds, emitters and forces of a def, recorded, after some steps.
void play(const physim_def* def, std::vector<Bytes>& saves, std::vector<Bytes>& recordings) {
  physim_world* world = nullptr;
  if (physim_world_create(def, PHYSIM_FIRE_NOTHING, &world) != PHYSIM_OK) return;
  const Freed freed{world};
  claim(physim_world_record(world, 2) == PHYSIM_OK, "a world is recorded");
  for (const char* number : {"1", "2", "3"}) {
    std::uint32_t kind = 0;
    physim_id ids[3]{}, id{};
    if (physim_world_add_kind(world, def, number, 0, 0, &kind) == PHYSIM_OK)
      physim_world_spawn(world, kind, 3, nullptr, ids, nullptr);
    physim_world_add_emitter(world, def, number, nullptr, &id);
    physim_world_add_force(world, def, number, ids, 1, &ids[1], &id);
    physim_joint joint{};
    joint.size = sizeof joint;
    joint.a = ids[0], joint.b = ids[2];
    physim_world_add_joint(world, &joint, &id);
  }
  physim_world_step(world, 12, 1.0 / 60);
  physim_bytes* bytes = nullptr;
  if (physim_save(world, &bytes) == PHYSIM_OK) {
    const Freed freed_bytes{bytes};
    if (Bytes save = opened(bytes); save.size() < 40000) saves.push_back(std::move(save));
  }
  if (physim_world_stop_recording(world, &bytes) == PHYSIM_OK) {
    const Freed freed_bytes{bytes};
    if (Bytes frames = without_sums(bytes); frames.size() < 40000) recordings.push_back(std::move(frames));
  }
}

std::vector<Bytes> worlds_to_begin_with() {
  std::vector<Bytes> saves, recordings;
  each_scenario([&](const physim_def* def) { play(def, saves, recordings); });
  return saves;
}
std::vector<Bytes> recordings_to_begin_with() {
  std::vector<Bytes> saves, recordings;
  each_scenario([&](const physim_def* def) { play(def, saves, recordings); });
  return recordings;
}
std::vector<Bytes> scenes_to_begin_with() {
  std::vector<Bytes> saves;
  each_scenario([&](const physim_def* def) {
    physim_scene* scene = nullptr;
    if (physim_scene_create(def, &scene) != PHYSIM_OK) return;
    const Freed freed{scene};
    physim_bytes* bytes = nullptr;
    if (physim_save(scene, &bytes) != PHYSIM_OK) return;
    const Freed freed_bytes{bytes};
    if (Bytes save = opened(bytes); save.size() < 40000) saves.push_back(std::move(save));
  });
  return saves;
}
std::vector<Bytes> parts_to_begin_with() {
  std::vector<Bytes> parts;
  each_scenario([&](const physim_def* def) {
    physim_study* study = nullptr;
    physim_part* part = nullptr;
    physim_bytes* bytes = nullptr;
    if (parts.size() == 4 || physim_study_create(def, nullptr, &study) != PHYSIM_OK) return;
    const Freed freed{study};
    if (physim_study_fly(study, 0, 1, nullptr, &part) != PHYSIM_OK) return;
    const Freed freed_part{part};
    if (physim_save(part, &bytes) != PHYSIM_OK) return;
    const Freed freed_bytes{bytes};
    const void* data = nullptr;
    std::size_t size = 0;
    claim(physim_bytes_data(bytes, &data, &size) == PHYSIM_OK && size > 8, "a part has bytes");
    const auto* first = static_cast<const std::byte*>(data);
    parts.emplace_back(first, first + size - 8);
  });
  return parts;
}

}  // namespace

const Target kSaves{"saves", load_world, worlds_to_begin_with};
const Target kScenes{"scenes", load_scene, scenes_to_begin_with};
const Target kRecordings{"recordings", replay, recordings_to_begin_with};
const Target kParts{"parts", load_part, parts_to_begin_with};

}  // namespace physim::test
