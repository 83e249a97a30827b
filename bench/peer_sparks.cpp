// Sparks as a careful game programmer writes them: a column for each number, one loop that the compiler turns into
// vectors, births at their own moments inside of the frame, deaths by moving the last one into the gap, looks from
// small tables. Single precision; the same forces and the same integrator as the game preset.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "world_peers.hpp"

namespace physim::bench {
namespace {

constexpr int kTable = 256;  // points of a look over a life

class PlainLoop final : public PeerSparks {
 public:
  PlainLoop(const PeerPhysics& physics, const PeerSpray& spray, std::size_t room) : physics_(physics), spray_(spray) {
    for (auto& column : state_) column.resize(room);
    size_of_.resize(room);
    colour_of_.resize(room);
    for (int i = 0; i < kTable; ++i) {
      const float x = static_cast<float>(i) / (kTable - 1);
      size_[i] = 1 - x * x * (3 - 2 * x);
      const auto part = [x](float from, float to) { return static_cast<std::uint32_t>(from + (to - from) * x); };
      colour_[i] = part(255, 255) << 24 | part(240, 40) << 16 | part(160, 0) << 8 | part(255, 0);
    }
  }

  void step(float dt) override {
    fly(dt);
    bury();
    owed_ += spray_.per_second * dt;
    const auto births = static_cast<std::size_t>(owed_);
    for (std::size_t i = 0; i < births; ++i) bear(dt * static_cast<float>(i) / static_cast<float>(births));
    owed_ -= static_cast<float>(births);
  }
  void emit(std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) bear(0);
  }
  void look() override {
    const float* age = state_[kAge].data();
    const float* life = state_[kLife].data();
    const float* born = state_[kSize].data();
    for (std::size_t i = 0; i < count_; ++i) {
      const int at = static_cast<int>(std::min(age[i] / life[i], 1.0f) * (kTable - 1));
      size_of_[i] = born[i] * size_[at];
      colour_of_[i] = colour_[at];
    }
  }
  [[nodiscard]] std::size_t size() const override { return count_; }

 private:
  enum Column { kX, kY, kZ, kU, kV, kW, kAge, kLife, kSize, kColumns };

  void fly(float dt) {
    float *x = state_[kX].data(), *y = state_[kY].data(), *z = state_[kZ].data(), *u = state_[kU].data(),
          *v = state_[kV].data(), *w = state_[kW].data(), *age = state_[kAge].data();
    const float k1 = physics_.k1 / physics_.mass, k2 = physics_.k2 / physics_.mass;
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
    for (std::size_t i = 0; i < count_; ++i) {
      const float drag = k1 + k2 * std::sqrt(u[i] * u[i] + v[i] * v[i] + w[i] * w[i]);
      u[i] -= drag * u[i] * dt;
      v[i] -= (drag * v[i] + physics_.gravity) * dt;
      w[i] -= drag * w[i] * dt;
      x[i] += u[i] * dt;
      y[i] += v[i] * dt;
      z[i] += w[i] * dt;
      age[i] += dt;
    }
  }
  void bury() {
    const float* age = state_[kAge].data();
    const float* life = state_[kLife].data();
    for (std::size_t i = 0; i < count_;) {
      if (age[i] < life[i]) {
        ++i;
        continue;
      }
      --count_;
      for (auto& column : state_) column[i] = column[count_];
    }
  }
  /// `left` of the frame is flown at once.
  void bear(float left) {
    if (count_ == state_[kX].size()) return;
    const float turn = 6.2831853f * random(), tilt = spray_.half_angle * std::sqrt(random());
    const float speed = spray_.slowest + (spray_.fastest - spray_.slowest) * random();
    const float u = speed * std::sin(tilt) * std::cos(turn), w = speed * std::sin(tilt) * std::sin(turn);
    const float v = speed * std::cos(tilt) - physics_.gravity * left;
    const float life = spray_.shortest + (spray_.longest - spray_.shortest) * random();
    const std::size_t i = count_++;
    const std::array<float, kColumns> born{u * left, v * left, w * left, u, v, w, left, life, 0.5f + random()};
    for (int column = 0; column < kColumns; ++column) state_[column][i] = born[column];
  }
  float random() {  // xorshift32
    seed_ ^= seed_ << 13;
    seed_ ^= seed_ >> 17;
    seed_ ^= seed_ << 5;
    return static_cast<float>(seed_ >> 8) * (1.0f / 16777216);
  }

  PeerPhysics physics_;
  PeerSpray spray_;
  std::array<std::vector<float>, kColumns> state_;
  std::vector<float> size_of_;
  std::vector<std::uint32_t> colour_of_;
  std::array<float, kTable> size_{};
  std::array<std::uint32_t, kTable> colour_{};
  std::size_t count_ = 0;
  float owed_ = 0;
  std::uint32_t seed_ = 2463534242u;
};

}  // namespace

std::unique_ptr<PeerSparks> plain_loop(const PeerPhysics& physics, const PeerSpray& spray, std::size_t room) {
  return std::make_unique<PlainLoop>(physics, spray, room);
}

}  // namespace physim::bench
