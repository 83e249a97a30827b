// Equations, symbols and Source: model/acceleration.hpp.
#include "model/acceleration.hpp"

namespace physim {

PHYSIM_COLD Accelerations accelerations_of(const Conditions<double>& c, const Body<double>& b,
                                           const Rotor<double>& rotor, double t, const State<double>& s,
                                           const Turn<double>& turn) {
  const Fidelity& f = c.fidelity;
  Ledger ledger;
  Turn<double> slope;
  if (turns(f))
    sum_effects(c, b, rotor, t, s, turn, slope, ledger);
  else if (is_classic(f))
    sum_effects(c, b, t, s, OriginalInAir{}, ledger);
  else
    sum_effects(c, b, t, s, PointInAir{}, ledger);
  return ledger;
}

Vec3d nose_of(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double t,
              const State<double>& s, const Turn<double>& turn) {
  if (turns(c.fidelity) && !is_in_repose(c.fidelity)) return forward(c.fidelity, turn);
  const Vec3d along = nose_in_air(b, air_velocity(c, b, t, s));
  if (!turns(c.fidelity)) return along;
  Sum<double> sum;
  return yawed_axis(along, sum_reposed(c, b, rotor, t, s, turn.h.x, sum).yaw);
}

}  // namespace physim
