// Rollback netcode: play on with a guess of what the other player does; when the truth arrives, go back, and again.
//
// Two machines run the same world. Inputs of the other machine arrive `kDelay` frames late. Each machine predicts that
// the other does nothing, keeps a snapshot of every frame that is not yet sure, and when an input comes that it had not
// predicted, restores the frame it belongs to and steps again to the present. Nothing but inputs is ever sent; the
// hashes tell that both machines see the same world, bit for bit.
#include <array>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;

namespace {

constexpr int kFrames = 300, kDelay = 8, kPlayers = 2;
constexpr double kFrame = 1.0 / 60;

struct Input {
  bool fire = false;
  double elevation = 0;  // [rad]
};

/// What a player really does: here a fixed script, in a game the keyboard.
Input script(int player, int frame) {
  return {(frame * 7 + player * 11) % 23 == 0, 0.3 + 0.01 * (frame % 40) + 0.1 * player};
}

class Machine {
 public:
  explicit Machine(int player) : player_(player) {
    shell_ = *world_.add_kind({.name = "shell", .mass = 5, .diameter = 0.09, .fidelity = Fidelity::game()});
  }

  /// One frame: what arrived of the other player, and what this one does.
  void frame(int now, Input own, const Input* arrived) {
    inputs_[player_][now] = own;
    if (arrived) learn(now - kDelay, *arrived);
    advance(now);
  }
  /// The rest of the other player's inputs, after the last frame.
  void learn(int frame, Input truth) {
    Input& guess = inputs_[1 - player_][frame];
    const bool guessed_right = guess.fire == truth.fire;
    guess = truth;
    if (guessed_right) return;
    world_.restore(snapshots_[frame % kDelay]);  // the world as it was before that frame
    const int present = next_;
    for (next_ = frame; next_ < present;) advance(next_);
    rolled_back_ += present - frame;
  }

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] int rolled_back() const { return rolled_back_; }

 private:
  void advance(int frame) {
    snapshots_[frame % kDelay] = world_.snapshot();
    for (int player = 0; player < kPlayers; ++player) {
      const Input& input = inputs_[player][frame];
      const double x = player == 0 ? 0 : 500, azimuth = player == 0 ? 0 : 3.14159265358979;
      if (input.fire)
        world_.spawn(shell_, {.position = {x, 2, 0}, .speed = 90, .elevation = input.elevation, .azimuth = azimuth});
    }
    world_.step(kFrame);
    next_ = frame + 1;
  }

  int player_;
  World world_;
  KindId shell_;
  std::array<std::array<Input, kFrames>, kPlayers> inputs_;  // as known or predicted so far: predicted is doing nothing
  std::array<Snapshot, kDelay> snapshots_;                   // of the frames that may still turn out otherwise
  int next_ = 0;
  int rolled_back_ = 0;
};

}  // namespace

int main() {
  Machine left(0), right(1);
  for (int now = 0; now < kFrames; ++now) {
    const int then = now - kDelay;
    const Input of_left = script(0, then), of_right = script(1, then);
    left.frame(now, script(0, now), then >= 0 ? &of_right : nullptr);
    right.frame(now, script(1, now), then >= 0 ? &of_left : nullptr);
  }
  for (int frame = kFrames - kDelay; frame < kFrames; ++frame) {  // what was still on its way
    left.learn(frame, script(1, frame));
    right.learn(frame, script(0, frame));
  }
  const bool agree = left.world().hash() == right.world().hash();
  std::printf("%d frames, %zu shells in flight; rolled back %d and %d frames; %s\n", kFrames, left.world().size(),
              left.rolled_back(), right.rolled_back(), agree ? "both worlds are equal" : "the worlds differ");
  return agree && left.world().size() > 0 && left.rolled_back() > 0 ? 0 : 1;
}
