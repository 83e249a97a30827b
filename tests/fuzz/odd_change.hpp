// A random change of one projectile of a world.
#pragma once

#include "fuzz/odd_input.hpp"

namespace physim::test {

/// One random call that changes a projectile.
inline void change_oddly(Projectile q, Odd& r) {
  switch (r.below(22)) {
    case 0: return void(q.despawn());
    case 1: return void(q.set_position(r.vector3(30)));
    case 2: return void(q.set_velocity(r.vector3(90)));
    case 3: return void(q.set_state({r.vector3(30), r.vector3(90)}));
    case 4: return void(q.apply_impulse(r.vector3(3)));
    case 5: return void(q.set_angular_velocity(r.vector3(30)));
    case 6: return void(q.set_fidelity(r.fidelity()));
    case 7: {
      BodyDef body = r.one_in(5) ? r.body() : q.body();
      body.gravity_scale = r.number(0, 2), body.frozen = r.axes(), body.kinematic = r.one_in(3),
      body.smoothing = r.any<Smoothing>();
      return void(q.set_body(body));
    }
    case 8: return void(q.set_gravity_scale(r.number(0, 2)));
    case 9: return void(q.set_use_gravity(r.coin()));
    case 10: return void(q.set_kinematic(r.one_in(3)));
    case 11: return void(q.set_frozen(r.axes(), r.axes()));
    case 12: return void(q.set_can_sleep(r.coin()));
    case 13: return void(r.coin() ? q.sleep() : q.wake());
    case 14: return void(q.set_smoothing(r.any<Smoothing>()));
    case 15: return void(q.set_user_data(r.bits()));
    case 16: return void(r.coin() ? q.set_layers(r.count(7)) : q.set_colour(r.bits()));
    case 17: return void(q.set_mass(r.one_in(4) ? -r.number(0, 9) : r.number(0, 9)));
    case 18: return void(q.set_damping(r.number(0, 1.2)));
    case 19: return void(q.set_drag(r.projectile().drag));
    case 20: {
      ProjectileDef p = r.projectile();
      if (const ProjectileDef* now = q.definition(); now && !r.one_in(5)) {
        const DragDef drag = p.drag;
        p = *now, p.drag = drag, p.mass = r.number(0, 9), p.diameter = r.number(0, 0.3);
      }
      return void(q.set_projectile(p));
    }
    default: return void(q.set_label(r.text()));
  }
}

}  // namespace physim::test
