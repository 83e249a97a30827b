#include "world/step/kind_drag.hpp"

#include "model/acceleration.hpp"
#include "prepare/conditions.hpp"
#include "prepare/launch.hpp"

namespace physim {
namespace {

Fidelity drag_alone() {
  return {.integrator = Integrator::rk4,
          .gravity = GravityModel::off,
          .drag = DragModel::equation,
          .air = AirModel::constant,
          .wind = WindModel::off};
}

}  // namespace

KindDrag::KindDrag() : conditions_(prepare_conditions({}, drag_alone())) {}

std::uint32_t KindDrag::add(const ProjectileDef& projectile) {
  bodies_.push_back(prepare_body(projectile, {}, 0, pool_, conditions_));
  pool_.point(conditions_);
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

Vec3d KindDrag::force(std::uint32_t index, double mass, double density, const Vec3d& u) const {
  const AirState<double> air{density, conditions_.air.common.per_sound_speed};
  return drag_equation(conditions_, bodies_[index], air, u) * mass;
}

}  // namespace physim
