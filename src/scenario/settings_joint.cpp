// Settings of [[joint]]: the members of Joint, with the names of shots for its ends.
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

#define PHYSIM_JOINT(...) PHYSIM_ROW("joint", joint, __VA_ARGS__)
/// A row of what a joint is in the library, under its name there.
#define PHYSIM_JOINT_DEF(field, ...) setting("joint." #field, PHYSIM_FIELD(joint->def.field), __VA_ARGS__)

constexpr Range kHalfTurns = {.low = -2 * kRightAngle, .high = 2 * kRightAngle, .words = "-180 .. 180 deg"};

constexpr Entry kJointSettings[] = {
    setting("joint", PHYSIM_FIELD(scenario->joints),
            "rods, cables, springs, hinges and sliders that hold shots to each other or to points, from the start",
            at_most(10000)),
    PHYSIM_JOINT(name, "in messages; default: joint-1, joint-2, ..."),
    PHYSIM_JOINT_DEF(kind,
                     "rods pull and push, cables only pull, springs give, hinges turn and sliders go about an axis"),
    PHYSIM_JOINT(a, "name of the shot at one end, fired once", kRequired),
    PHYSIM_JOINT(b, "name of the shot at the other end, fired once; empty: a point"),
    PHYSIM_JOINT_DEF(point, "of the world, where there is no b", Quantity::length),
    PHYSIM_JOINT_DEF(length,
                     "of a rod, a taut cable, a spring at rest (alone it may be 0), radius of a hinge; launch: as far "
                     "as its ends are apart then",
                     Quantity::length, between(0, 1e15), absent("launch")),
    PHYSIM_JOINT_DEF(restitution, "of a cable: speed kept when it comes taut", between(0, 1)),
    PHYSIM_JOINT_DEF(stiffness, "of a spring: force for each metre of stretch", Quantity::stiffness, at_least(0)),
    PHYSIM_JOINT_DEF(damping, "of a spring: of the rate at which its length changes", Quantity::linear_drag,
                     at_least(0)),
    PHYSIM_JOINT_DEF(break_force, "it ends if it pulls or pushes with more, on the mean of a step; never: it holds",
                     Quantity::force, Range{.low = 0, .low_open = true}, absent("never")),
    PHYSIM_JOINT_DEF(velocity, "of a point of the world: it goes on straight", Quantity::speed),
    PHYSIM_JOINT(thing, "name of the thing that takes the point along, which is in its frame then; empty: the world"),
    PHYSIM_JOINT_DEF(axis, "direction of a hinge or slider, in the frame of its point"),
    PHYSIM_JOINT_DEF(reference,
                     "direction of angle 0 of a hinge, in the frame of its point; 0, 0, 0: where a is first"),
    PHYSIM_JOINT_DEF(low_angle, "a hinge stops there; free: at -180 deg, or nowhere if both are", Quantity::angle,
                     kHalfTurns, absent("free")),
    PHYSIM_JOINT_DEF(high_angle, "... and there; free: at 180 deg, or nowhere if both are", Quantity::angle, kHalfTurns,
                     absent("free")),
    PHYSIM_JOINT_DEF(low, "a slider stops there on its axis, from b or the point; free: it goes on", Quantity::length,
                     between(-1e15, 1e15), absent("free")),
    PHYSIM_JOINT_DEF(high, "... and there", Quantity::length, between(-1e15, 1e15), absent("free")),
};

}  // namespace

std::span<const Entry> joint_settings() { return kJointSettings; }

}  // namespace physim
