// The nine standard drag functions, Cd by Mach number, point for point as published: data/drag/*.csv, which CMake makes
// into arrays (cmake/data.cmake).
//
// What it models: drag coefficients [-] of the projectiles of the Gavre Commission and their successors: G1 (Ingalls),
//   G2 (Aberdeen J), G5 (short 7.5 degree boat tail), G6 (flat base), G7 (long boat tail), G8 (flat base, 10 calibre
//   secant ogive), GI (Ingalls' original table), GS (sphere), RA4 (.22 rimfire).
// When it is wrong: a real projectile has its own curve; its form factor against these changes with Mach number.
// Source: U.S. Army Ballistic Research Laboratory, as tabulated by R. L. McCoy, Modern Exterior Ballistics (1999),
//   ch. 6, and by the Sierra and JBM exterior-ballistics tables.
#include "model/drag_tables.hpp"

namespace physim {

std::span<const DragPoint> drag_points(DragTable table) {
  switch (table) {
    case DragTable::g1: return kDragG1;
    case DragTable::g2: return kDragG2;
    case DragTable::g5: return kDragG5;
    case DragTable::g6: return kDragG6;
    case DragTable::g7: return kDragG7;
    case DragTable::g8: return kDragG8;
    case DragTable::gi: return kDragGI;
    case DragTable::gs: return kDragGS;
    case DragTable::ra4: return kDragRA4;
    case DragTable::constant:
    case DragTable::sphere:
    case DragTable::custom: break;
  }
  return {};
}

}  // namespace physim
