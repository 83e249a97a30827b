// Equations, symbols and Source: emit/gun.hpp.
#include "emit/gun.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/elementary.hpp"
#include "math/normal.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

constexpr double kFarthestOff = 3;  // a line never points straight backwards [rad]

}  // namespace

LineFrame LineFrame::along(const Vec3d& line) {
  PHYSIM_ASSERT(line.x > -1 && std::abs(length_squared(line) - 1) < 1e-9);
  const double s = 1 / (1 + line.x), across = -line.y * line.z * s;
  return {{line, {-line.y, 1 - line.y * line.y * s, across}, {-line.z, across, 1 - line.z * line.z * s}}};
}

Gun::Gun(const GunDef& def) : def_(def), up_(def.recoil_up), right_(def.recoil_right) {
  for (const Barrel& barrel : def.barrels) {
    Muzzle& muzzle = muzzles_.emplace_back(Muzzle{barrel.position, {}});
    if (def.convergence > 0)
      muzzle.frame = LineFrame::along(normalized(Vec3d{def.convergence, 0, 0} - barrel.position));
  }
  if (def.rounds_per_minute == 0) return;
  rounds_ = std::numeric_limits<std::uint64_t>::max();
  if (def.magazine == 0) return;
  if (def.magazines > 0) rounds_ = std::uint64_t{def.magazine} * def.magazines;
  const bool burst_over = def.burst_rounds > 0 && def.magazine % def.burst_rounds == 0;
  const double soonest = 60 / def.rounds_per_minute + (burst_over ? def.burst_pause : 0);
  magazine_time_ = in_magazine(def.magazine - 1) + std::max(def.reload, soonest);
}

double Gun::in_magazine(std::uint64_t round) const {
  PHYSIM_ASSERT(def_.rounds_per_minute > 0);
  const double time = static_cast<double>(round) * 60 / def_.rounds_per_minute;
  if (def_.burst_rounds == 0) return time;
  return time + static_cast<double>(round / def_.burst_rounds) * def_.burst_pause;
}

double Gun::time_of(std::uint64_t round) const {
  PHYSIM_ASSERT(round < rounds_);
  if (def_.magazine == 0) return in_magazine(round);
  return static_cast<double>(round / def_.magazine) * magazine_time_ + in_magazine(round % def_.magazine);
}

bool Gun::is_tracer(std::uint64_t round) const {
  return def_.tracer_every > 0 && round % def_.tracer_every == def_.tracer_every - 1;
}

double Gun::place_in_burst(std::uint64_t round) const {
  std::uint64_t of = def_.magazine;
  if (of > 0) round %= of;
  if (def_.burst_rounds > 0) of = def_.burst_rounds, round %= of;
  return of < 2 ? 0 : static_cast<double>(round) / static_cast<double>(of - 1);
}

Outlet Gun::aimed(const Outlet& from, std::uint64_t round, ParticleChance& chance) const {
  double up = 0, right = 0;
  if (def_.recoil != 0) {
    const double x = place_in_burst(round);
    if (!up_.is_one()) up = def_.recoil * up_(x);
    if (!right_.is_one()) right = def_.recoil * right_(x);
  }
  if (def_.dispersion > 0) {
    up += def_.dispersion * normal_quantile(chance(Draw::up));
    right += def_.dispersion * normal_quantile(chance(Draw::right));
  }
  Outlet out = from;
  if (const double off = std::sqrt(up * up + right * right); off > 0) {
    const SinCos<double> turn = sincos(std::min(off, kFarthestOff));
    const LineFrame line = LineFrame::along({turn.cos, turn.sin * (up / off), turn.sin * (right / off)});
    out = {line.turned(out.place), line.turned(out.direction)};
  }
  if (muzzles_.empty()) return out;
  const Muzzle& muzzle = muzzles_[round % muzzles_.size()];
  return {muzzle.position + muzzle.frame.turned(out.place), muzzle.frame.turned(out.direction)};
}

}  // namespace physim
