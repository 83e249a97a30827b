// Replay: the recorded calls are made again, on a world that is recorded again; the two recordings must be equal, frame
// by frame. So ids, hashes, and the number of steps are compared without a word about them.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <utility>

#include "base/written_by.hpp"
#include "physim/world.hpp"
#include "world/core/recorder.hpp"
#include "world/couple/world_impl.hpp"
#include "world/journal/save.hpp"

namespace physim {
namespace {

constexpr std::size_t kHead = sizeof kRecordingMagic + sizeof kRecordingFormat;
constexpr std::uint64_t kFirstApart = 60;                 // steps
constexpr std::size_t kMostKept = std::size_t{64} << 20;  // of keyframes [bytes]

Error damaged(std::size_t place, const std::string& message) {
  return {message, "byte " + std::to_string(place), "take another copy of it"};
}

/// A frame in the bytes of a recording.
struct Frame {
  Call call = Call::end;
  std::size_t place = 0;
  std::span<const std::byte> content;
  std::uint64_t chained = 0;  // check sum of all frames up to this one

  [[nodiscard]] std::size_t next() const { return place + kFrameHead + content.size() + kCheckSum; }
};

/// Walks the frames of a recording.
class Frames {
 public:
  explicit Frames(std::span<const std::byte> bytes) : bytes_(bytes) {}

  /// The next frame; nothing where there is no whole one any more.
  Result<std::optional<Frame>> next() {
    std::uint64_t call = 0, length = 0, sum = 0;
    Reader head(bytes_.subspan(at_));
    head.number(call, 1);
    head.number(length, kFrameHead - 1);
    if (!head.good() || bytes_.size() - at_ < kFrameHead + length + kCheckSum) {
      if (head.good() && is_damaged_length()) return damaged(at_, "the recording is damaged here");
      return std::optional<Frame>();
    }
    const std::size_t size = kFrameHead + static_cast<std::size_t>(length);
    Reader(bytes_.subspan(at_ + size)).number(sum, kCheckSum);
    chain_ = chain(chain_, bytes_.subspan(at_, size));
    if (check_sum(chain_) != sum || call >= kCalls) return damaged(at_, "the recording is damaged here");
    Frame frame{static_cast<Call>(call), at_, bytes_.subspan(at_ + kFrameHead, size - kFrameHead), chain_};
    at_ = frame.next();
    return std::optional(frame);
  }
  void start() { at_ = kHead; }
  [[nodiscard]] std::size_t place() const { return at_; }

 private:
  /// True if a frame that extends beyond the recording is whole with one byte of its length changed: then the recording
  /// is damaged, not cut.
  [[nodiscard]] bool is_damaged_length() const {
    constexpr std::size_t kLongestTried = 1u << 20;  // of frames that are tried [bytes]
    const auto rest = bytes_.subspan(at_, std::min(bytes_.size() - at_, kFrameHead + kLongestTried + kCheckSum));
    std::vector<std::byte> frame(rest.begin(), rest.end());
    for (std::size_t i = 1; i < kFrameHead; ++i) {
      for (unsigned value = 0; value < 256; ++value) {
        frame[i] = static_cast<std::byte>(value);
        std::uint64_t length = 0, sum = 0;
        Reader(std::span(frame).subspan(1)).number(length, kFrameHead - 1);
        if (length > kLongestTried || rest.size() < kFrameHead + length + kCheckSum) continue;
        const std::size_t size = kFrameHead + static_cast<std::size_t>(length);
        Reader(rest.subspan(size)).number(sum, kCheckSum);
        if (check_sum(chain(chain_, std::span(frame).first(size))) == sum) return true;
      }
      frame[i] = rest[i];
    }
    return false;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::uint64_t chain_ = 0;
};

Status check_head(std::span<const std::byte> bytes) {
  const std::size_t known = std::min(bytes.size(), sizeof kRecordingMagic);
  if (known == 0 || std::memcmp(bytes.data(), kRecordingMagic, known) != 0)
    return Error{"this is not a recording", "byte 0", "World::record() makes them, and `physim run --record`"};
  std::uint64_t format = 0;
  Reader reader(bytes.subspan(known));
  reader.number(format, sizeof kRecordingFormat);
  if (!reader.good()) return Error{"the recording ends in its head", "byte " + std::to_string(bytes.size()), ""};
  if (format == kRecordingFormat) return {};
  const std::size_t begin = std::min(bytes.size(), kHead + kFrameHead);  // the first frame begins with the version
  return of_other_format("recording", "byte " + std::to_string(known), format, kRecordingFormat,
                         version_at(bytes.subspan(begin)));
}

/// What is known of a recording before it is played.
struct Survey {
  FunctionCounts functions;
  std::uint64_t snapshots = 0;
  Moments* moments = nullptr;
};

/// How a call is read, and how it is made.
struct Handler {
  bool (*check)(std::span<const std::byte> content, Survey& survey);
  void (*make)(Reader& reader, World& world, Moments& moments);
};

template <Call call>
bool check_call(std::span<const std::byte> content, Survey& survey) {
  Reader reader(content);
  ArgumentsOf<call> arguments{};
  std::apply([&](auto&... a) { reader(a...); }, arguments);
  survey.functions += reader.functions_used();
  if constexpr (call == Call::snapshot) return reader.complete() && std::get<0>(arguments) == ++survey.snapshots;
  if constexpr (call == Call::restore) {
    const std::uint64_t number = std::get<0>(arguments);
    if (number == 0 || number > survey.snapshots) return false;
    survey.moments->expect_restore(number);
  }
  return reader.complete();
}

template <Call call>
void make_call(Reader& reader, World& world, Moments& moments) {
  ArgumentsOf<call> arguments{};
  std::apply([&](auto&... a) { reader(a...); }, arguments);
  std::apply([&](auto&... a) { kAgain<call>(world, moments, a...); }, arguments);
}

constexpr std::array<Handler, kCalls> kHandlers = {{
    {nullptr, nullptr},  // begin
    {nullptr, nullptr},  // end
    {nullptr, nullptr},  // stepped
    {nullptr, nullptr},  // returned
    {nullptr, nullptr},  // answered
#define PHYSIM_CALL(name, ...) {check_call<Call::name>, make_call<Call::name>},
#include "world/core/recorded_calls.hpp"
#undef PHYSIM_CALL
}};

bool is_call(Call call) { return kHandlers[static_cast<std::size_t>(call)].check != nullptr; }

std::uint64_t number_in(std::span<const std::byte> content) {
  std::uint64_t x = 0;
  Reader(content).number(x, 8);
  return x;
}

std::string hex(std::uint64_t x) {
  char text[19];
  std::snprintf(text, sizeof text, "0x%016llx", static_cast<unsigned long long>(x));
  return text;
}

}  // namespace

struct Replay::Impl {
  std::vector<std::byte> bytes;
  ReplayOptions options;
  ReplayReport report;
  WorldDef def;
  bool is_inside = false;  // of next()
  RecordOptions record;
  std::size_t end = 0;    // of the last whole frame
  std::size_t at = 0;     // the next frame
  Call call = Call::end;  // at hand
  Moments moments;
  FunctionCounts functions;  // that were read
  World world;
  Recorder* recorder = nullptr;  // of the world
  std::vector<std::uint64_t> hashes;

  /// A world to go back to: where the recording begins, or on the way.
  struct Keyframe {
    ReplayReport report;
    std::size_t at = 0;           // the next frame
    std::uint64_t chained = 0;    // check sum of all frames up to there
    FunctionCounts functions;     // that were read
    std::vector<std::byte> save;  // empty: a new world
  };
  Keyframe beginning;
  Moments first_moments;              // as they are at the beginning
  std::vector<Keyframe> keyframes;    // in their order
  std::uint64_t apart = kFirstApart;  // steps between two
  bool has_snapshots = false;         // the recording restores snapshots, which belong to one world

  Impl(std::vector<std::byte> recording, const ReplayOptions& how) : bytes(std::move(recording)), options(how) {
    moments.hits = options.hit_function = [this](const HitBatch& batch) { answer(batch); };
  }
  ~Impl() { at = end; }  // the recorder's own end, as its world goes, is compared with nothing
  Status survey();
  Status read_begin(const Frame& frame);
  Status resume(const Keyframe& from);
  void keep();
  [[nodiscard]] const Keyframe& last_before(std::uint64_t steps) const;
  Status compare(std::span<const std::byte> frame);
  void count_spawned(std::span<const std::byte> returned);
  void answer(const HitBatch& batch) const;
  void differ(std::span<const std::byte> frame);
  [[nodiscard]] Frame frame_at(std::span<const std::byte> from, std::size_t place) const;
  void make_next();
};

// --------------------------------------------------------------------------------------------- before it is played
Status Replay::Impl::read_begin(const Frame& frame) {
  Reader reader(frame.content, options);
  reader(report.made_by, record.hash_every, def, beginning.save);
  if (frame.call != Call::begin || !reader.complete())
    return damaged(frame.place, "the recording has no beginning" + by_another_version(report.made_by));
  beginning.functions = reader.functions_used();
  if (!beginning.save.empty()) {
    const Result<FunctionCounts> found = functions_of(beginning.save);
    if (!found) return damaged(frame.place, "the save that it begins with: " + found.error().message);
    beginning.functions = *found;
  }
  beginning.chained = frame.chained;
  beginning.at = end = frame.next();
  return {};
}

/// Looks at every frame.
Status Replay::Impl::survey() {
  if (Status status = check_head(bytes); !status) return status;
  Frames frames(bytes);
  frames.start();
  Survey found;
  found.moments = &moments;
  for (bool first = true;; first = false) {
    const auto frame = frames.next();
    if (!frame) return frame.error();
    if (!*frame) break;
    const Frame& f = **frame;
    const Handler& handler = kHandlers[static_cast<std::size_t>(f.call)];
    if (first) {
      if (Status status = read_begin(f); !status) return status;
      continue;
    }
    const bool known = handler.check ? handler.check(f.content, found) : f.call != Call::begin;
    if (!known || report.complete)
      return damaged(f.place, "what stands here makes no sense" + by_another_version(report.made_by));
    report.complete = f.call == Call::end;
    end = f.next();
  }
  if (end == 0) return Error{"the recording ends before its world is told", "byte " + std::to_string(bytes.size()), ""};
  if (report.complete && end != bytes.size()) return damaged(end, "something follows the end of the recording");
  report.bytes = end;
  beginning.report = report;
  first_moments = moments;
  has_snapshots = found.snapshots > 0;
  found.functions += beginning.functions;
  return check_given(found.functions, options, "the recording");
}

// --------------------------------------------------------------------------------------------- while it is played
/// Goes on from a world that was kept.
Status Replay::Impl::resume(const Keyframe& from) {
  Result<World> made = from.save.empty() ? World::create(def) : World::load(from.save, options);
  if (!made) return made.error();
  report = from.report;
  functions = from.functions;
  moments = first_moments;
  hashes.clear();
  at = end;  // the end of the recorder that goes is compared with nothing
  world = std::move(*made);
  at = from.at;
  const auto sink = [this](std::span<const std::byte> frame) { return compare(frame); };
  auto again = std::make_unique<Recorder>(Recorder::parts_of(world), sink, record, 0);
  again->go_on(from.chained, report.steps);
  recorder = again.get();
  Recorder::attach(world, std::move(again));
  return {};
}

Frame Replay::Impl::frame_at(std::span<const std::byte> from, std::size_t place) const {
  std::uint64_t kind = 0, length = 0;
  Reader head(from.subspan(place));
  head.number(kind, 1);
  head.number(length, kFrameHead - 1);
  return {static_cast<Call>(kind), place, from.subspan(place + kFrameHead, static_cast<std::size_t>(length)), 0};
}

/// One frame of the replay, against that of the recording.
Status Replay::Impl::compare(std::span<const std::byte> frame) {
  if (frame.empty() || report.difference || at == end) return {};
  if (end - at < frame.size() || !std::equal(frame.begin(), frame.end(), bytes.begin() + static_cast<long>(at)))
    return differ(frame), Status();
  const Frame same = frame_at(bytes, at);
  at += frame.size();
  if (same.call == Call::stepped) {
    ++report.hashes;
    hashes.push_back(number_in(same.content));
  } else if (same.call == Call::returned) {
    count_spawned(same.content);
  }
  return {};
}

void Replay::Impl::count_spawned(std::span<const std::byte> returned) {
  std::vector<ProjectileId> ids(1);
  Reader reader(returned);
  if (call == Call::spawn_many)
    reader(ids);
  else if (call == Call::spawn || call == Call::spawn_def)
    reader(ids[0]);
  report.spawned += static_cast<std::uint64_t>(std::count_if(ids.begin(), ids.end(), [](auto id) { return bool(id); }));
}

/// As was recorded; about other hits there is nothing, and the frame that is written of that differs.
void Replay::Impl::answer(const HitBatch& batch) const {
  if (at == end || report.difference) return;
  const Frame frame = frame_at(bytes, at);
  std::vector<HitAnswer> answers;
  Reader reader(frame.content);
  if (frame.call == Call::answered) reader(answers);
  if (reader.complete() && answers.size() == batch.answers.size()) std::ranges::copy(answers, batch.answers.begin());
}

void Replay::Impl::differ(std::span<const std::byte> replayed) {
  const Frame now = frame_at(replayed, 0);
  const Frame then = frame_at(bytes, at);
  ReplayDifference& d = report.difference.emplace();
  d.step = recorder->steps();
  d.time = world.time();
  d.call = name(call);
  d.place = at;
  if (now.call == Call::stepped && then.call == Call::stepped) {
    d.recorded_hash = number_in(then.content);
    d.replayed_hash = number_in(now.content);
    d.what = "the hash is " + hex(d.replayed_hash) + ", and " + hex(d.recorded_hash) + " was recorded";
  } else if (now.call == Call::stepped) {
    d.what = "it took a step that was not recorded";
  } else if (now.call == Call::returned && then.call == Call::returned) {
    d.what = "it handed out another id than the one recorded";
  } else if (now.call == Call::answered) {
    d.what = "it asked about other hits than those recorded";
  } else {
    d.what = "it did not do what was recorded";
  }
}

void Replay::Impl::make_next() {
  hashes.clear();
  const Frame frame = frame_at(bytes, at);
  call = frame.call;
  if (is_call(call)) {
    Reader reader(frame.content, options, functions);
    kHandlers[static_cast<std::size_t>(call)].make(reader, world, moments);
    functions += reader.functions_used();
    ++report.calls;
    if (call == Call::restore) ++report.restores;
  } else if (call == Call::end) {
    at = end;
  } else {
    report.difference = ReplayDifference{recorder->steps(), world.time(), std::string(name(call)), "", 0, 0, at};
    report.difference->what = "the recording has more of the call before than the replay";
  }
  report.steps = recorder->steps();
}

// --------------------------------------------------------------------------------------------- going back
/// Keeps the world as it is, if the last one kept is far enough behind.
void Replay::Impl::keep() {
  const bool is_whole = !has_snapshots && functions == FunctionCounts{} && !report.difference;
  const std::uint64_t last = keyframes.empty() ? 0 : keyframes.back().report.steps;
  if (!is_whole || report.steps < last + apart) return;
  Result<std::vector<std::byte>> saved = world.save();
  if (!saved) return;
  keyframes.push_back({report, at, recorder->chained(), functions, std::move(*saved)});
  std::size_t bytes_kept = 0;
  for (const Keyframe& k : keyframes) bytes_kept += k.save.size();
  if (bytes_kept <= kMostKept) return;
  apart *= 2;
  std::vector<Keyframe> fewer;
  for (std::size_t i = 1; i < keyframes.size(); i += 2) fewer.push_back(std::move(keyframes[i]));
  keyframes = std::move(fewer);
}

const Replay::Impl::Keyframe& Replay::Impl::last_before(std::uint64_t steps) const {
  const Keyframe* last = &beginning;
  for (const Keyframe& k : keyframes)
    if (k.report.steps <= steps) last = &k;
  return *last;
}

// --------------------------------------------------------------------------------------------- public
Replay::Replay(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Replay::Replay(Replay&&) noexcept = default;
Replay& Replay::operator=(Replay&&) noexcept = default;
Replay::~Replay() = default;

Result<Replay> Replay::open(std::vector<std::byte> recording, const ReplayOptions& options) {
  auto impl = std::make_unique<Impl>(std::move(recording), options);
  if (Status status = impl->survey(); !status) return status.error();
  impl->def.threading = options.threading;
  // Else a call that was recorded gives it.
  if (!impl->beginning.functions.hit_function) impl->options.hit_function = {};
  if (Status status = impl->resume(impl->beginning); !status) return status.error();
  return Replay(std::move(impl));
}

bool Replay::next() {
  Impl& r = *impl_;
  if (r.is_inside || r.at >= r.end || r.report.difference) return false;  // inside: a custom force asks
  r.is_inside = true;
  r.make_next();
  r.is_inside = false;
  return r.at < r.end ? !r.report.difference : r.call != Call::end && !r.report.difference;
}

bool Replay::next_frame() {
  const std::uint64_t before = impl_->report.steps;
  while (impl_->report.steps == before)
    if (!next()) return impl_->report.steps != before && !impl_->report.difference;
  return true;
}

bool Replay::seek(std::uint64_t steps) {
  Impl& r = *impl_;
  if (r.is_inside) return false;
  const bool is_before = steps < r.report.steps || (steps == 0 && r.report.calls > 0);
  if (is_before && !r.resume(r.last_before(steps))) return false;
  while (r.report.steps < steps) {
    r.keep();
    if (!next_frame()) return false;
  }
  return true;
}

const World& Replay::world() const { return impl_->world; }
const ReplayReport& Replay::report() const { return impl_->report; }
std::span<const std::uint64_t> Replay::hashes() const { return impl_->hashes; }

Result<ReplayReport> replay(std::span<const std::byte> recording, const ReplayOptions& options) {
  Result<Replay> opened = Replay::open({recording.begin(), recording.end()}, options);
  if (!opened) return opened.error();
  Replay& player = *opened;
  while (player.next()) continue;
  return player.report();
}

}  // namespace physim
