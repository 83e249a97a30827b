#include "world/core/recorder.hpp"

#include <limits>

#include "physim/result.hpp"
#include "physim/world.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

constexpr std::size_t kTogether = 1 << 16;  // [bytes]

}  // namespace

thread_local const Gate* Gate::in_question = nullptr;
Gate::Gate() = default;
Gate::~Gate() = default;

Recorder::Recorder(Gate& gate, RecordSink sink, const RecordOptions& options, std::size_t together)
    : gate_(gate), sink_(std::move(sink)), options_(options), together_(together) {}

/// What a sink refers to may have ended before its world: it is called only if its owner declared that it outlives it.
Recorder::~Recorder() {
  if (options_.complete_at_end) static_cast<void>(finish());
}

void Recorder::attach(World& world, std::unique_ptr<Recorder> recorder) {
  recorder->first_moment = world.impl().moments;
  world.impl().recorder = std::move(recorder);
}

void Recorder::begin(const WorldDef& def, const std::vector<std::byte>& save) {
  const auto magic = std::as_bytes(std::span(kRecordingMagic));
  bytes_.assign(magic.begin(), magic.end());
  Writer(bytes_).write(kRecordingFormat);
  chain_ = 0;
  frame(Call::begin, std::string(kVersion), options_.hash_every, def, save);
  flush();
}

void Recorder::open_frame(Call call) {
  open_ = bytes_.size();
  Writer writer(bytes_);
  writer.number(static_cast<std::uint64_t>(call), 1);
  writer.number(0, kFrameHead - 1);
}

void Recorder::close_frame() {
  PHYSIM_ASSERT(bytes_.size() >= open_ + kFrameHead);
  const std::size_t length = bytes_.size() - open_ - kFrameHead;
  if (length > std::numeric_limits<std::uint32_t>::max()) return fail({"a call is too long for it", "recording", ""});
  for (std::size_t i = 1; i < kFrameHead; ++i) bytes_[open_ + i] = static_cast<std::byte>(length >> (8 * (i - 1)));
  chain_ = chain(chain_, std::span(bytes_).subspan(open_));
  Writer(bytes_).number(check_sum(chain_), kCheckSum);
  if (bytes_.size() >= together_) flush();
}

Status Recorder::hand_over(std::span<const std::byte> bytes) {
  const Inside inside(gate_);
  try {
    return sink_(bytes);
  } catch (...) {
    return Error{"its sink threw something", "recording", "sinks return their errors"};
  }
}

void Recorder::flush() {
  if (!is_good() || bytes_.empty()) return;
  status_ = hand_over(bytes_);
  bytes_.clear();
}

void Recorder::fail(Error why) {
  if (status_) status_ = std::move(why);
  bytes_.clear();
}

Status Recorder::finish() {
  if (finished_) return status_;
  frame(Call::end);
  flush();
  finished_ = true;
  if (status_) status_ = hand_over({});
  return status_;
}

// --------------------------------------------------------------------------------------------- of a world
Status World::record(RecordSink sink, const RecordOptions& options) {
  WorldImpl& w = impl();
  if (w.is_closed()) return from_inside();
  if (!sink) return Error{"there is nothing to record into", "sink", "give a function that takes bytes"};
  if (w.recorder) return Error{"a recording is under way", "world", "stop_recording() ends it"};
  std::vector<std::byte> begun;
  if (options.from_now) {
    auto saved = save();
    if (!saved) return saved.error();
    begun = std::move(*saved);
  } else if (!w.registry.is_new() || hash() != World(w.def).hash()) {
    return Error{"something was done to this world already", "world",
                 "record() comes first, right after create(), or begins with a save: RecordOptions::from_now"};
  }
  const std::shared_ptr<WorldImpl> keep = impl_;
  auto recorder = std::make_unique<Recorder>(w, std::move(sink), options, kTogether);
  recorder->begin(w.def, begun);
  if (w.hit_asking.has_function()) recorder->frame(Call::set_hit_function, true);
  if (!recorder->is_good()) return recorder->finish();
  recorder->first_moment = w.moments;
  w.recorder = std::move(recorder);
  return {};
}

Status World::stop_recording() {
  WorldImpl& w = impl();
  if (w.is_closed()) return from_inside();
  if (!w.recorder) return Error{"there is no recording under way", "world", "record() begins one"};
  const std::shared_ptr<WorldImpl> keep = impl_;
  Status status = w.recorder->finish();
  w.recorder.reset();
  return status;
}

bool World::is_recording() const { return impl().recorder && impl().recorder->is_good(); }

RecordSink record_into(std::vector<std::byte>& bytes) {
  return [&bytes](std::span<const std::byte> more) -> Status {
    bytes.insert(bytes.end(), more.begin(), more.end());
    return {};
  };
}

}  // namespace physim
