// Input queue: what hands did, handed on so that each frame can tell it apart.
//
// Panels look at keys and buttons once in a frame: one that is pressed and released between two frames was never down,
// and of two keys nobody knows which was first. So an event that a frame could not tell from those before it waits for
// the next frame, and all after it.
#pragma once

#include <deque>
#include <functional>
#include <set>
#include <vector>

namespace physim::client {

struct InputEvent {
  enum class Kind { press, release, repeat, text, button, other };

  Kind kind = Kind::other;  // press, release and repeat: of a key; other: the mouse moves, its wheel turns
  int code = 0;             // of the key or button
  bool writes = false;      // a key whose press comes with a text, which is all that panels look at
  bool modifies = false;    // Shift, Ctrl, ...: a key that changes what others do
  std::function<void()> to_panels, to_client;
};

class InputQueue {
 public:
  void push(InputEvent event) { waiting_.push_back(std::move(event)); }
  /// What a frame can take, in order; the rest waits.
  [[nodiscard]] std::vector<InputEvent> take();
  [[nodiscard]] bool is_empty() const { return waiting_.empty(); }

 private:
  /// What a frame has taken so far.
  struct Frame {
    std::set<int> keys;  // that changed
    bool has_button = false, has_text = false, has_command = false;
  };
  [[nodiscard]] static bool fits(const Frame& frame, const InputEvent& event);

  std::deque<InputEvent> waiting_;
};

}  // namespace physim::client
