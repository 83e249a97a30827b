// What hands did, frame by frame: nothing is lost, and a frame can tell all that it gets apart.
#include <gtest/gtest.h>

#include <string>

#include "simclient/core/input_queue.hpp"

namespace physim::client {
namespace {

constexpr int kBackspace = 259, kEnter = 257, kShift = 340;

/// "p": a key goes down, "r": up; "t": its text; "b": a mouse button, "m": the mouse moves.
void push(InputQueue& queue, char what, int code) {
  using Kind = InputEvent::Kind;
  const Kind kind = what == 'p'   ? Kind::press
                    : what == 'r' ? Kind::release
                    : what == 't' ? Kind::text
                    : what == 'b' ? Kind::button
                                  : Kind::other;
  queue.push({.kind = kind,
              .code = code,
              .writes = code > ' ' && code < 256,
              .modifies = code == kShift,
              .to_panels = {},
              .to_client = {}});
}

void type(InputQueue& queue, char letter) {
  for (const char what : {'p', 't', 'r'}) push(queue, what, letter);
}
void press(InputQueue& queue, int key) {
  for (const char what : {'p', 'r'}) push(queue, what, key);
}

/// How many events each frame takes.
std::vector<std::size_t> frames(InputQueue& queue) {
  std::vector<std::size_t> counts;
  while (!queue.is_empty()) counts.push_back(queue.take().size());
  return counts;
}

TEST(InputQueue, AKeyIsDownForAFrameHoweverShortItWas) {
  InputQueue queue;
  press(queue, kBackspace);
  press(queue, kBackspace);
  EXPECT_EQ(frames(queue), (std::vector<std::size_t>{1, 1, 1, 1}));
}

TEST(InputQueue, LettersNeedNoFrameOfTheirOwn) {
  InputQueue queue;
  push(queue, 'p', kShift);
  for (const char letter : std::string("2600ft/s")) type(queue, letter);
  EXPECT_EQ(frames(queue), std::vector<std::size_t>{25});
}

TEST(InputQueue, TextAndTheKeysThatEditItKeepTheirOrder) {
  InputQueue queue;
  type(queue, 'a');
  press(queue, kBackspace);
  type(queue, 'b');
  press(queue, kEnter);
  std::string order;
  for (std::size_t frame = 0; !queue.is_empty(); ++frame) {
    bool has_text = false, has_command = false;
    for (const InputEvent& event : queue.take()) {
      has_text |= event.kind == InputEvent::Kind::text;
      has_command |= event.kind == InputEvent::Kind::press && !event.writes;
      if (event.kind == InputEvent::Kind::text || (event.kind == InputEvent::Kind::press && !event.writes))
        order += event.code < 256 ? static_cast<char>(event.code) : event.code == kEnter ? '!' : '<';
    }
    EXPECT_FALSE(has_text && has_command) << "frame " << frame;
  }
  EXPECT_EQ(order, "a<b!");
}

TEST(InputQueue, AClickIsSeenBeforeWhatFollowsIt) {
  InputQueue queue;
  push(queue, 'm', 0);
  push(queue, 'b', 0);
  push(queue, 'b', 0);
  push(queue, 'm', 0);
  type(queue, 'x');
  EXPECT_EQ(frames(queue), (std::vector<std::size_t>{2, 1, 4}));
}

}  // namespace
}  // namespace physim::client
