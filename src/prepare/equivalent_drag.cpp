// The drag equation, evaluated for one state.
#include "prepare/equivalent_drag.hpp"

#include "model/acceleration.hpp"
#include "prepare/projectile.hpp"

namespace physim {
namespace {

constexpr double kFall =
    30;  // what starts at rest in the air gets the drag coefficient of this speed, a fall of 50 m [m/s]

}  // namespace

EquivalentDrag::EquivalentDrag(const ProjectileDef& p, const Body<double>& b, const Conditions<double>& c,
                               std::shared_ptr<TablePool> pool, ProfileTables profiles)
    : body_(b), profiles_(std::move(profiles)), conditions_(c), pool_(std::move(pool)) {
  conditions_.fidelity.drag = DragModel::equation;
  prepare_curve(p, *pool_, conditions_, body_);
}

double EquivalentDrag::k2_per_mass(const State<double>& s, double birth) {
  PHYSIM_ASSERT(!pool_->rows().empty() && conditions_.fidelity.drag == DragModel::equation);
  pool_->point(conditions_);
  const Vec3d u = air_velocity(conditions_, body_, birth, s);
  const double speed = length(u);
  const Vec3d probe = speed > 0 ? u : Vec3d{0, -kFall, 0};
  const double square = speed > 0 ? speed * speed : kFall * kFall;
  return length(drag_equation(conditions_, body_, air_state(conditions_, body_, s.x), probe)) / square;
}

}  // namespace physim
