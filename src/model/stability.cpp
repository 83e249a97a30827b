// Equations, symbols and Source: model/stability.hpp.
#include "model/stability.hpp"

#include "math/vec3.hpp"
#include "model/attitude.hpp"

namespace physim {

std::optional<Stability> stability_of(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& r,
                                      double time, const State<double>& s, const Turn<double>& t) {
  PHYSIM_ASSERT(turns(c.fidelity));
  const Vec3d u = air_velocity(c, b, time, s);
  const AirState<double> air = air_state(c, b, s.x);
  const double speed = length(u);
  if (!c.has_aero || speed == 0 || air.density == 0) return std::nullopt;
  const double mach = speed * air.per_sound_speed;
  const AeroCoefficients<double> k = aero_coefficients(c, r, mach, 0.0);
  if (k.pitching == 0) return std::nullopt;
  const double spin = spin_of(c.fidelity, r, t);
  const double across = r.moments.y;
  const double momentum = r.moments.x * spin;
  Stability out;
  out.gyroscopic = momentum * momentum / (4 * air.density * across * r.moment_scale * speed * speed * k.pitching);
  // All over rho S d V / 2m: force_scale is S / 2m, the other scales hold k, which is in the coefficients here.
  const double cd = c.fidelity.drag == DragModel::equation
                        ? length(drag_equation(c, b, air, u)) / (air.density * speed * speed * r.force_scale)
                        : 0.0;
  const double magnus = k.magnus_moment * r.magnus_moment_scale / (r.force_scale * r.moments.x);
  const double damping = k.pitch_damping * r.pitch_scale / (r.force_scale * across);
  const double below = k.lift - cd - damping;
  if (below != 0) out.dynamic = 2 * (k.lift + magnus) / below;
  return out;
}

}  // namespace physim
