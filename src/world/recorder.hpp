// Recorder: writes the calls of a world to a sink, as frames. Recorded: a call under way.
//
// A recording is its magic and format, then frames: what it is (1 byte), the length of its content (4), the content,
// and a check sum (4) of all frames so far, which tells any damage and where it is. First comes `begin`. A call is
// written before it is made, its steps and what it hands out after: a program that dies in a call leaves that call
// behind.
#pragma once

#include <memory>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "world/calls.hpp"

namespace physim {

inline constexpr std::size_t kFrameHead = 5;  // [bytes]
inline constexpr std::size_t kCheckSum = 4;   // [bytes]

/// The check sum of all frames so far after one more.
[[nodiscard]] inline std::uint64_t chain(std::uint64_t before, std::span<const std::byte> frame) {
  Hash hash(before);
  hash.add(frame);
  return hash.value();
}
/// The part of it that is written.
[[nodiscard]] inline std::uint32_t check_sum(std::uint64_t chained) {
  return static_cast<std::uint32_t>(chained ^ chained >> 32);
}

class Recorder {
 public:
  /// `together`: frames are handed to the sink when there are so many bytes of them [bytes].
  Recorder(RecordSink sink, const RecordOptions& options, std::size_t together);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder() { static_cast<void>(finish()); }

  /// Makes a world's recorder. A replay goes on with the check sum of the recording's `begin`.
  static void attach(World& world, std::unique_ptr<Recorder> recorder);

  void begin(const WorldDef& def);
  void go_on(std::uint64_t chained) { chain_ = chained; }
  /// Completes the recording, once; what went wrong with it.
  Status finish();
  [[nodiscard]] bool is_good() const { return !finished_ && status_; }

  /// Calls may make other calls, which are not recorded. Every enter has its leave.
  bool enter() { return depth_++ == 0; }
  void leave() {
    PHYSIM_ASSERT(depth_ > 0);
    --depth_;
  }
  [[nodiscard]] bool is_outermost() const { return depth_ == 1; }

  template <class... T>
  void frame(Call call, const T&... values) {
    if (!is_good()) return;
    try {
      open_frame(call);
      Writer(bytes_).write(values...);
      close_frame();
    } catch (...) {
      fail({"no memory left for it", "recording", ""});
    }
  }
  /// A step was taken. `hash` gives that of the world, where it is asked for.
  template <class F>
  void stepped(const F& hash) {
    ++steps_;
    if (options_.hash_every == 0 || steps_ % options_.hash_every != 0 || !is_good()) return;
    try {
      frame(Call::stepped, std::uint64_t{hash()});
    } catch (...) {
      fail({"no memory left for it", "recording", ""});
    }
  }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  /// Hands what there is to the sink.
  void flush();
  void fail(Error why);

  std::uint64_t first_moment = 0;  // snapshots taken before the recording have this number or lower ones

 private:
  void open_frame(Call call);
  void close_frame();

  RecordSink sink_;
  RecordOptions options_;
  std::size_t together_;
  std::vector<std::byte> bytes_;
  std::size_t open_ = 0;  // where the frame at hand begins
  std::uint64_t chain_ = 0;
  std::uint64_t steps_ = 0;
  int depth_ = 0;
  bool finished_ = false;
  Status status_;
};

/// A call that changes a world, from its first line to its end; all that it computes, it computes in IeeeMode.
///   const Recorded<Call::despawn> call(impl_->recorder, id);
template <Call name>
class Recorded {
 public:
  template <class... T>
  explicit Recorded(const std::unique_ptr<Recorder>& recorder, const T&... arguments) : recorder_(recorder.get()) {
    static_assert(std::is_same_v<std::tuple<typename RecordedAs<T>::Type...>, ArgumentsOf<name>>,
                  "recorded_calls.hpp says otherwise");
    if (recorder_ && recorder_->enter()) begin(arguments...);
  }
  Recorded(const Recorded&) = delete;
  Recorded& operator=(const Recorded&) = delete;
  ~Recorded() {
    if (recorder_) recorder_->leave();
  }

  /// What the call hands out, such as an id: a replay must hand out the same.
  template <class T>
  const T& returns(const T& value) const {
    if (recorder_ && recorder_->is_outermost()) recorder_->frame(Call::returned, value);
    return value;
  }
  template <class T>
  const Result<T>& returns(const Result<T>& value) const {
    if (value) returns(*value);
    return value;
  }

 private:
  template <class... T>
  [[gnu::noinline]] void begin(const T&... arguments) {
    recorder_->frame(name, arguments...);
    // Calls that step may take long, or bring down a program that was on its way there.
    constexpr bool steps = name == Call::step || name == Call::advance || name == Call::single_step;
    if constexpr (steps) recorder_->flush();
  }

  IeeeMode mode_;
  Recorder* recorder_;
};

}  // namespace physim
