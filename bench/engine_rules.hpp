// What engines do to a velocity in a step, by their documentation: gravity and linear damping, which means
// dv/dt = a - c v. Each rule takes one component of the velocity [m/s], the acceleration a [m/s^2], the damping c [1/s]
// and the step h [s], and gives the velocity that the place then moves by.
//
// Unity (PhysX): docs.unity3d.com/ScriptReference/Rigidbody-linearDamping.html; gravity comes first. Unity 2D:
//   .../Rigidbody2D-linearDamping.html. Both by steps of 0.02 s: .../MonoBehaviour.FixedUpdate.html.
// Jolt: github.com/jrouwe/JoltPhysics, MotionProperties::ApplyForceTorqueAndDragInternal().
// Godot: docs.godotengine.org, ProjectSettings physics/3d/default_linear_damp and physics_ticks_per_second (60);
// gravity
//   comes after the damping in its own 3D physics (GodotBody3D::integrate_forces()).
// Box2D 3: github.com/erincatto/box2d, src/solver.c, in four sub-steps of a frame (b2World_Step()); gravity comes
// after.
#pragma once

namespace physim::bench {

enum class EngineRule { unity, unity_2d, jolt, godot, box2d };

/// 1 - c h, and 0 where a step is longer than the damping lets anything move.
template <class S>
S kept(S c, S h) {
  return c * h < 1 ? 1 - c * h : S(0);
}

template <EngineRule kRule, class S>
S velocity_after(S v, S a, S c, S h) {
  switch (kRule) {
    case EngineRule::unity:
    case EngineRule::jolt: return (v + a * h) * kept(c, h);
    case EngineRule::unity_2d: return (v + a * h) * (1 / (1 + c * h));
    case EngineRule::godot: return v * kept(c, h) + a * h;
    case EngineRule::box2d: return v * (1 / (1 + c * h)) + a * h;
  }
  return v;
}

/// Sub-steps of a step.
constexpr int sub_steps(EngineRule rule) { return rule == EngineRule::box2d ? 4 : 1; }

}  // namespace physim::bench
