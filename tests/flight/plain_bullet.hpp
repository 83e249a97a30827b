// The bullet of tests of known rungs: a point mass with a drag curve.
#pragma once

#include "physim/projectile.hpp"

namespace physim::test {

inline ProjectileDef plain_bullet() {
  ProjectileDef p;
  p.mass = 0.0109;
  p.diameter = 7.82e-3;
  p.drag.table = DragTable::g7;
  p.drag.ballistic_coefficient = 153;
  return p;
}

}  // namespace physim::test
