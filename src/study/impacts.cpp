#include "study/impacts.hpp"

#include "base/assert.hpp"
#include "collide/seen_hit.hpp"
#include "model/earth.hpp"
#include "model/motor.hpp"
#include "model/motor_table.hpp"
#include "physim/scene.hpp"
#include "prepare/grant.hpp"
#include "study/quantities.hpp"

namespace physim {
namespace {

ShotImpact impact_of(const Vec3d& velocity, const Vec3d& normal, double mass) {
  const double speed = length(velocity);
  return {speed, obliquity_of(velocity, normal), 0.5 * mass * speed * speed};
}

}  // namespace

double part_of(const ShotImpact& impact, StudyQuantity quantity) {
  PHYSIM_ASSERT(is_of_impact(quantity));
  if (quantity == StudyQuantity::impact_speed) return impact.speed;
  return quantity == StudyQuantity::obliquity ? impact.obliquity : impact.energy;
}

MassInFlight::MassInFlight(const ProjectileDef& projectile, const Fidelity& granted) : mass_(projectile.mass) {
  if (!has_motor(projectile) || !flies_motors(granted)) return;
  MotorPool pool;
  pool.add(projectile.motor, {}, {}, 1);
  for (const MotorPiece& piece : pool.pieces()) pieces_.push_back(piece.burn);
}

double MassInFlight::at(double time) const {
  if (pieces_.empty()) return mass_;
  Body<double> body{};
  body.mass = mass_;
  for (const Burn<double>& piece : pieces_) {
    body.burn = piece;
    if (time < piece.end) break;
  }
  return mass_at(body, time);
}

Impacts::Impacts(const Study& study, const Fidelity& granted)
    : scene_(study.scene), scene_time_(study.until.contact.scene_time), radius_(study.until.contact.collision.radius) {
  earth_.fidelity = granted;
  prepare_earth(study.environment, granted, earth_);
}

ShotImpact Impacts::on_ground(const Vec3d& place, const Vec3d& velocity, double mass) const {
  return impact_of(velocity, vertical_at(earth_, place), mass);
}

ShotImpact Impacts::first_of(const Flight& flight) const {
  for (const Event& event : flight.events()) {
    if (event.kind != EventKind::hit || event.reason == Reason::inside) continue;
    PHYSIM_ASSERT(scene_ != nullptr);
    const Vec3d surface = surface_velocity(*scene_, event, radius_, scene_time_ + event.time);
    return impact_of(event.velocity - surface, event.normal, flight.at(event.time).mass);
  }
  const Sample end = flight.end();
  if (flight.outcome() != Outcome::landed) return kNoImpact;
  return on_ground(end.position, end.velocity, end.mass);
}

}  // namespace physim
