// Recorder: writes the calls of a world to a sink, as frames. Recorded: a call under way.
//
// A recording is its magic and format, then frames: what it is (1 byte), the length of its content (4), the content,
// and a check sum (4) of all frames up to here, which detects any damage and its place. First comes `begin`. A call is
// written before it is made, its steps and what it hands out after: a program that dies in a call leaves that call
// behind.
#pragma once

#include <memory>
#include <utility>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "world/core/calls.hpp"

namespace physim {

inline constexpr std::size_t kFrameHead = 5;  // [bytes]
inline constexpr std::size_t kCheckSum = 4;   // [bytes]

/// The check sum of all frames up to and including one more.
[[nodiscard]] inline std::uint64_t chain(std::uint64_t before, std::span<const std::byte> frame) {
  Hash hash(before);
  hash.add(frame);
  return hash.value();
}
/// The part of it that is written.
[[nodiscard]] inline std::uint32_t check_sum(std::uint64_t chained) {
  return static_cast<std::uint32_t>(chained ^ chained >> 32);
}

class Recorder;

/// What every call that changes a world passes: its recording, and whether one of its own callbacks runs.
struct Gate : std::enable_shared_from_this<Gate> {
  bool is_inside = false;  // a step, or the sink of the recording
  bool asks = false;       // calls between steps, too, may ask a function of the user's
  std::unique_ptr<Recorder> recorder;
  /// The world with forces or an engine that this thread calls between steps, as accelerations() and predict() do.
  static thread_local const Gate* in_question;

  Gate();
  /// Nothing may be changed now.
  [[nodiscard]] bool is_closed() const { return is_inside || in_question == this; }
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;
  ~Gate();
};

/// As long as it lives calls that change the world are refused.
class Inside {
 public:
  explicit Inside(Gate& gate) : gate_(gate), before_(std::exchange(gate.is_inside, true)) {}
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  ~Inside() { gate_.is_inside = before_; }

 private:
  Gate& gate_;
  bool before_;
};

[[nodiscard]] inline Error from_inside() {
  return {"was called from inside the world's own step or recording", "world", "call it after the step"};
}

class Recorder {
 public:
  /// `together`: frames are handed to the sink once they have this number of bytes [bytes].
  Recorder(Gate& gate, RecordSink sink, const RecordOptions& options, std::size_t together);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();

  /// The parts of a world that is to be recorded.
  [[nodiscard]] static WorldImpl& parts_of(World& world) { return world.impl(); }
  /// Makes a world's recorder.
  static void attach(World& world, std::unique_ptr<Recorder> recorder);

  /// `save`: of the world where it is not new.
  void begin(const WorldDef& def, const std::vector<std::byte>& save);
  /// Continues a recording whose frames have this check sum, after `steps` steps.
  void go_on(std::uint64_t chained, std::uint64_t steps) {
    chain_ = chained;
    steps_ = steps;
  }
  [[nodiscard]] std::uint64_t chained() const { return chain_; }
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

  /// False where it is not written: with what is no value of its type, or into no good recording.
  template <class... T>
  bool frame(Call call, const T&... values) {
    if (!is_good()) return false;
    try {
      open_frame(call);
      Writer writer(bytes_);
      writer.write(values...);
      was_writable_ = writer.good();
      if (!was_writable_) return bytes_.resize(open_), false;
      close_frame();
    } catch (...) {
      fail({"no memory left for it", "recording", ""});
    }
    return is_good();
  }
  /// Whether what the last frame was asked to hold can be written.
  [[nodiscard]] bool was_writable() const { return was_writable_; }
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

  Status hand_over(std::span<const std::byte> bytes);

  Gate& gate_;
  RecordSink sink_;
  RecordOptions options_;
  std::size_t together_;
  std::vector<std::byte> bytes_;
  std::size_t open_ = 0;  // where the frame at hand begins
  std::uint64_t chain_ = 0;
  std::uint64_t steps_ = 0;
  int depth_ = 0;
  bool was_writable_ = true;
  bool finished_ = false;
  Status status_;
};

/// A call that changes a world, from its first line to its end; all that it computes, it computes in
/// IeeeMode.
///   const Recorded<Call::despawn> call(world, id);
///   if (call.is_refused()) return call.refusal();
/// The world's parts stay as long as it, whatever a callback does to the world.
template <Call name>
class Recorded {
 public:
  template <class... T>
  explicit Recorded(Gate& gate, const T&... arguments) : is_refused_(gate.is_closed()) {
    static_assert(std::is_same_v<std::tuple<typename RecordedAs<T>::Type...>, ArgumentsOf<name>>,
                  "recorded_calls.hpp says otherwise");
    if (is_refused_) return;
    if (gate.recorder || gate.asks || kSteps) keep_ = gate.shared_from_this();
    recorder_ = gate.recorder.get();
    if (recorder_ && recorder_->enter()) begin(arguments...);
  }
  Recorded(const Recorded&) = delete;
  Recorded& operator=(const Recorded&) = delete;
  ~Recorded() {
    if (!recorder_) return;
    if (kSteps && recorder_->is_outermost()) recorder_->flush();
    recorder_->leave();
  }

  /// It comes from inside the world's own step or recording, or the recording cannot hold what it was given: nothing
  /// may be changed. Even a call that the world refuses may leave something, such as the kind of a bad launch.
  [[nodiscard]] bool is_refused() const { return is_refused_; }
  [[nodiscard]] Error refusal() const {
    if (!is_unwritable_) return from_inside();
    return {"was given an enumerator that there is not", "world", "a recording could not hold the call"};
  }
  /// What the call hands out, such as an id: a replay must hand out the same.
  template <class T>
  const T& returns(const T& value) const {
    if (is_written_ && recorder_->is_outermost()) recorder_->frame(Call::returned, value);
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
    is_written_ = recorder_->frame(name, arguments...);
    is_unwritable_ = !is_written_ && !recorder_->was_writable();
    is_refused_ = is_unwritable_;
    // Calls that step may take long, or bring down a program that was on its way there.
    if constexpr (kSteps) recorder_->flush();
  }

  static constexpr bool kSteps = name == Call::step || name == Call::advance || name == Call::single_step;

  IeeeMode mode_;
  std::shared_ptr<Gate> keep_;
  Recorder* recorder_ = nullptr;
  bool is_refused_;
  bool is_unwritable_ = false;
  bool is_written_ = false;
};

}  // namespace physim
