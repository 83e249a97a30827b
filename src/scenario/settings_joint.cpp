// Settings of [[joint]]: the members of Joint, with the names of shots for its ends.
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

#define PHYSIM_JOINT(...) PHYSIM_ROW("joint", joint, __VA_ARGS__)
/// A row of what a joint is in the library, under its name there.
#define PHYSIM_JOINT_DEF(field, ...) setting("joint." #field, PHYSIM_FIELD(joint->def.field), __VA_ARGS__)

constexpr Entry kJointSettings[] = {
    setting("joint", PHYSIM_FIELD(scenario->joints),
            "rods, cables and springs that hold shots to each other or to points, from the start", at_most(10000)),
    PHYSIM_JOINT(name, "in messages; default: joint-1, joint-2, ..."),
    PHYSIM_JOINT_DEF(kind, "rods pull and push, cables only pull, springs give"),
    PHYSIM_JOINT(a, "name of the shot at one end, fired once", kRequired),
    PHYSIM_JOINT(b, "name of the shot at the other end, fired once; empty: a point"),
    PHYSIM_JOINT_DEF(point, "of the world, where there is no b", Quantity::length),
    PHYSIM_JOINT_DEF(length,
                     "of a rod, of a taut cable, of a spring at rest; launch: as far as its ends are apart then",
                     Quantity::length, Range{.low = 0, .high = 1e15, .low_open = true}, absent("launch")),
    PHYSIM_JOINT_DEF(restitution, "of a cable: speed kept when it comes taut", between(0, 1)),
    PHYSIM_JOINT_DEF(stiffness, "of a spring: force for each metre of stretch", Quantity::stiffness, at_least(0)),
    PHYSIM_JOINT_DEF(damping, "of a spring: of the rate at which its length changes", Quantity::linear_drag,
                     at_least(0)),
    PHYSIM_JOINT_DEF(break_force, "it ends if it pulls or pushes with more, on the mean of a step; never: it holds",
                     Quantity::force, Range{.low = 0, .low_open = true}, absent("never")),
    PHYSIM_JOINT_DEF(velocity, "of a point of the world: it goes on straight", Quantity::speed),
    PHYSIM_JOINT(thing, "name of the thing that takes the point along, which is in its frame then; empty: the world"),
};

}  // namespace

std::span<const Entry> joint_settings() { return kJointSettings; }

}  // namespace physim
