#include "emit/flight_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "emit/pack_chance.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

auto drawn_as(FlightChance& chance, FlightDraw what) {
  return [&chance, what] { return chance(what); };
}

CurlNoise swirls_of(const ParticleFlight& def, std::uint64_t seed) {
  std::array<std::uint32_t, CurlNoise::kMostOctaves> seeds{};
  for (std::uint32_t k = 0; k < def.noise_octaves; ++k) seeds[k] = emit_words(seed, EmitStream::noise, k, 0, 0)[0];
  return {seeds, def.noise_size, def.noise_rate, def.noise_octaves, def.noise_gain};
}

}  // namespace

FlightLaw::FlightLaw(const ParticleFlight& def, std::uint64_t seed)
    : seed_(seed),
      drag_(def.drag),
      gravity_(def.gravity),
      limit_(def.limit),
      noise_(def.noise),
      velocity_{EmitNumber(def.velocity_x), EmitNumber(def.velocity_y), EmitNumber(def.velocity_z)},
      force_{EmitNumber(def.force_x), EmitNumber(def.force_y), EmitNumber(def.force_z)},
      drag_by_speed_(def.drag_by_speed),
      fast_(def.fast),
      limit_rate_(def.limit_rate) {
  if (!noise_.is(0)) swirls_ = swirls_of(def, seed);
}

bool FlightLaw::acts() const {
  return !drag_.is(0) || scales_gravity() || !limit_.is(kInfinity) || swirls_ || adds_velocity() || has_force();
}
bool FlightLaw::adds_velocity() const { return !velocity_.are_zero(); }
bool FlightLaw::has_force() const { return !force_.are_zero(); }
bool FlightLaw::is_drag_by_age() const {
  const bool is_other = scales_gravity() || !limit_.is(kInfinity) || swirls_ || adds_velocity() || has_force();
  return !drag_.is(0) && !(fast_ > 0) && !is_other;
}

template <std::size_t N>
void FlightLaw::accelerate(const FlightPack<N>& p, const ParticleKernel* kernel, typename FlightPack<N>::Vectors& sum,
                           typename FlightPack<N>::Column& drag_rate) const {
  typename FlightPack<N>::Column x, speed{}, k, rate{};
  typename FlightPack<N>::Vectors a{};  // apart from what is read: compilers see that nothing overlaps
  for (std::size_t i = 0; i < N; ++i) x[i] = part_of_life(p.time[i], p.birth[i], p.span[i]);
  const bool reads_speed = fast_ > 0 || !limit_.is(kInfinity);
  for (std::size_t i = 0; i < N && reads_speed; ++i)
    speed[i] = std::sqrt(p.v[0][i] * p.v[0][i] + p.v[1][i] * p.v[1][i] + p.v[2][i] * p.v[2][i]);
  PackChance<FlightDraw, EmitStream::flight, N> chance(seed_, p.number, kernel);
  if (!drag_.is(0)) {
    draw_each(drag_, x, k, chance, FlightDraw::drag);
    if (fast_ > 0)
      for (std::size_t i = 0; i < N; ++i) k[i] *= drag_by_speed_(std::min(speed[i] / fast_, 1.0));
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < N; ++i) a[axis][i] -= p.v[axis][i] * k[i];
    rate = k;
  }
  if (!limit_.is(kInfinity)) {
    draw_each(limit_, x, k, chance, FlightDraw::limit);
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < N; ++i)
        if (speed[i] > k[i]) a[axis][i] -= p.v[axis][i] * (limit_rate_ * (1 - k[i] / speed[i]));
    for (std::size_t i = 0; i < N; ++i)
      if (speed[i] > k[i]) rate[i] += limit_rate_ * (1 - k[i] / speed[i]);
  }
  if (scales_gravity()) {
    draw_each(gravity_, x, k, chance, FlightDraw::gravity);
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < N; ++i) a[axis][i] += p.gravity[axis][i] * (k[i] - 1);
  }
  if (has_force()) {
    constexpr FlightDraw kDraws[] = {FlightDraw::force_x, FlightDraw::force_y, FlightDraw::force_z};
    const EmitNumber* const forces[] = {&force_.x, &force_.y, &force_.z};
    for (int axis = 0; axis < 3; ++axis) {
      draw_each(*forces[axis], x, k, chance, kDraws[axis]);
      for (std::size_t i = 0; i < N; ++i) a[axis][i] += k[i] * (1 / p.mass[i]);
    }
  }
  if (swirls_) {
    draw_each(noise_, x, k, chance, FlightDraw::noise);
    for (std::size_t i = 0; i < N; ++i) {
      const Vec3d swirl = swirls_->at({p.x[0][i], p.x[1][i], p.x[2][i]}, p.time[i]) * k[i];
      a[0][i] += swirl.x, a[1][i] += swirl.y, a[2][i] += swirl.z;
    }
  }
  sum = a;
  drag_rate = rate;
}

void FlightLaw::accelerations(const FlightPack<kPack>& pack, FlightPack<kPack>::Vectors& a,
                              FlightPack<kPack>::Column& drag_rate) const {
  accelerate(pack, &particle_kernel(), a, drag_rate);
}

void FlightLaw::drag_rates(const ParticleKernel& kernel, const std::uint64_t* number, const double* birth,
                           const double* span, double time, double* rate) const {
  PHYSIM_ASSERT(is_drag_by_age());
  std::array<double, kPack> x;
  kernel.part_of_life(time, birth, span, x.data());
  if (!drag_.is_drawn()) return kernel.number(drag_.job(x.data(), nullptr, rate));
  std::array<std::uint64_t, kPack> numbers;
  std::copy_n(number, kPack, numbers.begin());
  PackChance<FlightDraw, EmitStream::flight, kPack> chance(seed_, numbers, &kernel);
  kernel.number(drag_.job(x.data(), chance.words(FlightDraw::drag).data(), rate));
}

Vec3d FlightLaw::acceleration(const InFlight& particle, double time, const FlightState& s, double* drag_rate) const {
  PHYSIM_ASSERT(s.mass > 0);
  const auto alone = [](const Vec3d& v) { return FlightPack<1>::Vectors{{{v.x}, {v.y}, {v.z}}}; };
  const FlightPack<1> pack{{particle.number}, {particle.birth}, {particle.span},  {time},
                           alone(s.x),        alone(s.v),       alone(s.gravity), {s.mass}};
  FlightPack<1>::Vectors a;
  FlightPack<1>::Column rate;
  accelerate(pack, nullptr, a, rate);
  if (drag_rate) *drag_rate = rate[0];
  return {a[0][0], a[1][0], a[2][0]};
}

Vec3d FlightLaw::added_velocity(const InFlight& particle, double time) const {
  const double x = part_of_life(time, particle.birth, particle.span);
  FlightChance chance(seed_, particle.number);
  return {velocity_.x.at(x, drawn_as(chance, FlightDraw::velocity_x)),
          velocity_.y.at(x, drawn_as(chance, FlightDraw::velocity_y)),
          velocity_.z.at(x, drawn_as(chance, FlightDraw::velocity_z))};
}

Vec3d FlightLaw::velocity_rate(const InFlight& particle, double time) const {
  const double x = part_of_life(time, particle.birth, particle.span);
  FlightChance chance(seed_, particle.number);
  const Vec3d slope{velocity_.x.slope(x, drawn_as(chance, FlightDraw::velocity_x)),
                    velocity_.y.slope(x, drawn_as(chance, FlightDraw::velocity_y)),
                    velocity_.z.slope(x, drawn_as(chance, FlightDraw::velocity_z))};
  return slope * (1 / particle.span);
}

}  // namespace physim
