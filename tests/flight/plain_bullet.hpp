// The bullet of tests of known rungs: a point mass with a drag curve.
#pragma once

#include "physim/projectile.hpp"

namespace physim::test {

inline ProjectileDef plain_bullet() {
  return {.mass = 0.0109, .diameter = 7.82e-3, .drag = {.table = DragTable::g7, .ballistic_coefficient = 153}};
}

}  // namespace physim::test
