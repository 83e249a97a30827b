#include "emit/flight_law.hpp"

#include <algorithm>

#include "math/vec3.hpp"

namespace physim {
namespace {

/// Which part of its life is over.
double part_of_life(const InFlight& particle, double time) {
  PHYSIM_ASSERT(particle.span > 0);
  return std::clamp((time - particle.birth) / particle.span, 0.0, 1.0);
}

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

double FlightLaw::drag_at(double x, double speed, FlightChance& chance) const {
  const double drag = drag_.at(x, drawn_as(chance, FlightDraw::drag));
  return fast_ > 0 ? drag * drag_by_speed_(std::min(speed / fast_, 1.0)) : drag;
}

Vec3d FlightLaw::acceleration(const InFlight& particle, double time, const FlightState& s) const {
  PHYSIM_ASSERT(s.mass > 0);
  const double x = part_of_life(particle, time), speed = length(s.v);
  FlightChance chance(seed_, particle.number);
  Vec3d a{};
  if (!drag_.is(0)) a -= s.v * drag_at(x, speed, chance);
  if (!limit_.is(kInfinity)) {
    const double limit = limit_.at(x, drawn_as(chance, FlightDraw::limit));
    if (speed > limit) a -= s.v * (limit_rate_ * (1 - limit / speed));
  }
  if (scales_gravity()) a += s.gravity * (gravity_.at(x, drawn_as(chance, FlightDraw::gravity)) - 1);
  if (has_force()) {
    const Vec3d force{force_.x.at(x, drawn_as(chance, FlightDraw::force_x)),
                      force_.y.at(x, drawn_as(chance, FlightDraw::force_y)),
                      force_.z.at(x, drawn_as(chance, FlightDraw::force_z))};
    a += force * (1 / s.mass);
  }
  if (swirls_) a += swirls_->at(s.x, time) * noise_.at(x, drawn_as(chance, FlightDraw::noise));
  return a;
}

Vec3d FlightLaw::added_velocity(const InFlight& particle, double time) const {
  const double x = part_of_life(particle, time);
  FlightChance chance(seed_, particle.number);
  return {velocity_.x.at(x, drawn_as(chance, FlightDraw::velocity_x)),
          velocity_.y.at(x, drawn_as(chance, FlightDraw::velocity_y)),
          velocity_.z.at(x, drawn_as(chance, FlightDraw::velocity_z))};
}

Vec3d FlightLaw::velocity_rate(const InFlight& particle, double time) const {
  const double x = part_of_life(particle, time);
  FlightChance chance(seed_, particle.number);
  const Vec3d slope{velocity_.x.slope(x, drawn_as(chance, FlightDraw::velocity_x)),
                    velocity_.y.slope(x, drawn_as(chance, FlightDraw::velocity_y)),
                    velocity_.z.slope(x, drawn_as(chance, FlightDraw::velocity_z))};
  return slope * (1 / particle.span);
}

}  // namespace physim
