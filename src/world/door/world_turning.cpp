// Orientations that are shown and move nothing.
#include "model/turning.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {

void WorldImpl::turn(double dt) {
  for (auto& [index, turning] : state.extras.turning) {
    const Slot& slot = state.slots[index];
    if (slot.is(kStill)) continue;
    const BodyDef& body = registry.kind(slot.kind).body;
    turning.angular_velocity =
        component_product(turning.angular_velocity, state.extras.turns(index, body.frozen_rotation));
    turning = turned(turning, body.angular_drag, dt);
  }
}

}  // namespace physim
