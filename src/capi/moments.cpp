// Snapshots, saves and recordings of worlds.
#include "capi/objects.hpp"
#include "capi/parts.hpp"
#include "physim/scenario.hpp"

namespace physim::capi {
namespace {

constexpr char kRunMagic[] = "PHYSIMW";  // of the saves of worlds that fire by themselves

Result<std::vector<std::byte>> saved(const Kept& kept) {
  if (kept.kind == Stands<physim_world>::kName) {
    const auto world = std::static_pointer_cast<WorldObject>(kept.object);
    return world->run ? world->run->save() : std::as_const(*world).world().save();
  }
  if (kept.kind == Stands<physim_scene>::kName) return std::static_pointer_cast<SceneObject>(kept.object)->scene.save();
  if (kept.kind == Stands<physim_part>::kName)
    return save_part(std::static_pointer_cast<PartObject>(kept.object)->part);
  PHYSIM_UNREACHABLE();
}

/// Keeps the bytes of a recording; one that memory runs out for ends, and not the step that writes it.
RecordSink sink_into(std::vector<std::byte>& recording) {
  return [&recording](std::span<const std::byte> piece) -> Status {
    try {
      recording.insert(recording.end(), piece.begin(), piece.end());
    } catch (const std::bad_alloc&) {
      return Error{"memory ran out", "recording", ""};
    }
    return {};
  };
}

physim_replay_info info_of(const Replay& replay) {
  const ReplayReport& report = replay.report();
  physim_replay_info out{.size = 0,
                         .agrees = !report.difference,
                         .complete = report.complete,
                         .reserved = 0,
                         .calls = report.calls,
                         .steps = report.steps,
                         .hashes = report.hashes,
                         .hash = replay.world().hash(),
                         .difference = {}};
  if (report.difference) put_text(out.difference, sizeof out.difference, report.difference->what);
  return out;
}

/// Opens the recording of a call.
Result<Replay> opened(const void* recording, std::size_t size, const physim_functions& functions) {
  const auto* first = static_cast<const std::byte*>(recording);
  return Replay::open({first, first + size}, options_of(functions));
}

}  // namespace

LoadOptions options_of(const physim_functions& functions) {
  LoadOptions options;
  PHYSIM_ASSERT(functions.forces == 0 || functions.force != nullptr);
  for (std::uint32_t i = 0; i < functions.forces; ++i)
    options.custom_forces.push_back(
        force_of(functions.force[i], functions.force_user != nullptr ? functions.force_user[i] : nullptr));
  if (functions.wind != nullptr) options.wind_fields.push_back(wind_of(functions.wind, functions.wind_user));
  if (functions.field != nullptr) options.force_fields.push_back(field_of(functions.field, functions.field_user));
  if (functions.engine != nullptr) options.engine_queries.push_back(engine_of(functions.engine, functions.engine_user));
  options.hit_function = hit_of(functions.hit, functions.hit_user);
  return options;
}

void need_functions(Call& call, const physim_functions& functions) {
  call.need_rows(functions.force, functions.forces, "functions.force");
  for (std::uint32_t i = 0; call.ok() && i < functions.forces; ++i)
    call.need(functions.force[i] != nullptr, "functions.force", "has one that is null");
}

}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

physim_result physim_bytes_data(const physim_bytes* bytes, const void** data, size_t* size) {
  return guarded([&](Call& call) {
    const auto of = call.find(bytes, "bytes");
    call.need(data, "data");
    call.need(size, "size");
    if (call.ok()) *data = of->bytes.data(), *size = of->bytes.size();
  });
}

physim_result physim_save(const void* handle, physim_bytes** bytes) {
  return guarded([&](Call& call) {
    const Kept from = kept(number_of(handle));
    call.need(bytes, "bytes");
    if (!call.ok()) return;
    if (from.object == nullptr) return call.fail_to_find(handle, from, "handle", "physim_world");
    const bool can_be = from.kind == Stands<physim_world>::kName || from.kind == Stands<physim_scene>::kName ||
                        from.kind == Stands<physim_part>::kName;
    if (!can_be) return call.fail_to_find(handle, from, "handle", "worlds, scenes and parts of studies can be saved");
    if (from.kind == Stands<physim_world>::kName)
      call.look_at(std::static_pointer_cast<WorldObject>(from.object), false);
    if (!call.ok()) return;
    Result<std::vector<std::byte>> made = saved(from);
    if (call.take(made)) call.give(bytes, std::make_shared<Bytes>(Bytes{std::move(*made)}));
  });
}

physim_result physim_world_snapshot(const physim_world* world, physim_snapshot** snapshot) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(snapshot, "snapshot");
    if (!call.ok()) return;
    auto made = std::make_shared<SnapshotObject>();
    if (of->run)
      made->of_run = of->run->snapshot();
    else
      made->of_world = of->world().snapshot();
    if (!made->of_run && !made->of_world) return call.fail(PHYSIM_REFUSED, "the world is inside a step", "world");
    call.give(snapshot, std::move(made));
  });
}

physim_result physim_world_restore(physim_world* world, const physim_snapshot* snapshot) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(snapshot, "snapshot");
    if (!call.ok()) return;
    if (!into->run) return static_cast<void>(call.take(into->own.restore(from->of_world)));
    if (!from->of_run || !into->run->restore(from->of_run))
      call.fail(PHYSIM_REFUSED, "the snapshot is of another world", "snapshot");
  });
}

physim_result physim_world_load(const void* data, size_t size, const physim_def* def, const physim_functions* functions,
                                physim_world** world) {
  return guarded([&](Call& call) {
    const auto from = call.find_or_null(def, "def");
    const physim_functions given = call.read(functions, "functions");
    call.need(data, "data");
    call.need(world, "world");
    if (call.ok()) need_functions(call, given);
    if (!call.ok()) return;
    const std::span<const std::byte> bytes(static_cast<const std::byte*>(data), size);
    auto made = std::make_shared<WorldObject>();
    const bool of_run = size >= sizeof kRunMagic && std::memcmp(data, kRunMagic, sizeof kRunMagic - 1) == 0;
    if (of_run && from == nullptr)
      return call.fail(PHYSIM_REFUSED, "this world fires by itself", "def", "give the def that it was made of");
    if (!of_run) {
      Result<World> loaded = World::load(bytes, options_of(given));
      if (call.take(loaded)) made->own = std::move(*loaded), call.give(world, std::move(made));
      return;
    }
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    Result<WorldRun> loaded = WorldRun::load((*checked)->scenario, bytes);
    if (!call.take(loaded)) return;
    made->run.emplace(std::move(*loaded));
    if (call.take(add_things(*made, (*checked)->scenario))) call.give(world, std::move(made));
  });
}

physim_result physim_world_record(physim_world* world, uint32_t hash_every) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    if (!call.ok()) return;
    if (into->world().is_recording()) return call.fail(PHYSIM_REFUSED, "it is recording already", "world");
    into->recording.clear();
    const auto record = [&](bool from_now) {
      return into->world().record(sink_into(into->recording), {.hash_every = hash_every, .from_now = from_now});
    };
    if (!record(false)) call.take(record(true));
  });
}

physim_result physim_world_stop_recording(physim_world* world, physim_bytes** recording) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(recording, "recording");
    if (call.ok() && call.take(into->world().stop_recording()))
      call.give(recording, std::make_shared<Bytes>(Bytes{std::move(into->recording)}));
  });
}

physim_result physim_replay(const void* recording, size_t size, const physim_functions* functions,
                            physim_replay_info* info) {
  return guarded([&](Call& call) {
    const physim_functions given = call.read(functions, "functions");
    call.need(recording, "recording");
    call.need_struct(info, "info");
    if (call.ok()) need_functions(call, given);
    if (!call.ok()) return;
    Result<Replay> replay = opened(recording, size, given);
    if (!call.take(replay)) return;
    while (replay->next()) continue;
    PHYSIM_ASSERT(replay->report().bytes <= size);
    call.write(info, info_of(*replay));
  });
}

physim_result physim_replay_open(const void* recording, size_t size, const physim_functions* functions,
                                 physim_world** world) {
  return guarded([&](Call& call) {
    const physim_functions given = call.read(functions, "functions");
    call.need(recording, "recording");
    call.need(world, "world");
    if (call.ok()) need_functions(call, given);
    if (!call.ok()) return;
    Result<Replay> replay = opened(recording, size, given);
    if (!call.take(replay)) return;
    auto made = std::make_shared<WorldObject>();
    made->replay.emplace(std::move(*replay));
    call.give(world, std::move(made));
  });
}

namespace {

/// Moves a world by its recording: `move` says whether it got there.
template <class Move>
physim_result move_replay(physim_world* world, int32_t* there, physim_replay_info* info, const Move& move) {
  return guarded([&](Call& call) {
    const Kept found = kept(number_of(world));
    if (found.kind != Stands<physim_world>::kName)
      return call.fail_to_find(world, found, "world", Stands<physim_world>::kName);
    const auto of = std::static_pointer_cast<WorldObject>(found.object);
    call.look_at(of, false);
    if (info != nullptr) call.need_struct(info, "info");
    if (!call.ok()) return;
    if (!of->replay) return call.fail(PHYSIM_REFUSED, "no recording moves this world", "world", "physim_replay_open()");
    call.will_change(of);
    const bool is_there = move(*of->replay);
    if (there != nullptr) *there = is_there;
    if (info != nullptr) call.write(info, info_of(*of->replay));
  });
}

}  // namespace

physim_result physim_replay_next(physim_world* world, uint64_t frames, int32_t* more, physim_replay_info* info) {
  return move_replay(world, more, info, [&](Replay& replay) {
    bool goes_on = frames > 0 || replay.next();
    for (std::uint64_t i = 0; goes_on && i < frames; ++i) goes_on = replay.next_frame();
    return goes_on;
  });
}

physim_result physim_replay_seek(physim_world* world, uint64_t steps, int32_t* there, physim_replay_info* info) {
  return move_replay(world, there, info, [&](Replay& replay) { return replay.seek(steps); });
}
