#include "simclient/core/input_queue.hpp"

namespace physim::client {

bool InputQueue::fits(const Frame& frame, const InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::press:
      if (event.writes || event.modifies) return !frame.has_button && frame.keys.count(event.code) == 0;
      return !frame.has_button && !frame.has_text && !frame.has_command && frame.keys.count(event.code) == 0;
    case InputEvent::Kind::release: return frame.keys.count(event.code) == 0;
    case InputEvent::Kind::text: return !frame.has_button && !frame.has_command;
    case InputEvent::Kind::button: return !frame.has_button && frame.keys.empty() && !frame.has_text;
    case InputEvent::Kind::repeat:
    case InputEvent::Kind::other: return !frame.has_button;
  }
  return true;
}

std::vector<InputEvent> InputQueue::take() {
  std::vector<InputEvent> taken;
  Frame frame;
  while (!waiting_.empty() && fits(frame, waiting_.front())) {
    const InputEvent& next = taken.emplace_back(std::move(waiting_.front()));
    waiting_.pop_front();
    const bool is_key = next.kind == InputEvent::Kind::press || next.kind == InputEvent::Kind::release;
    if (is_key && !next.writes) frame.keys.insert(next.code);
    frame.has_button |= next.kind == InputEvent::Kind::button;
    frame.has_text |= next.kind == InputEvent::Kind::text;
    frame.has_command |= next.kind == InputEvent::Kind::press && !next.writes && !next.modifies;
  }
  return taken;
}

}  // namespace physim::client
