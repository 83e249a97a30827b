// Bodies: what a projectile looks like, made in code: its form by what it is, its mesh, and its attitude.
#pragma once

#include <span>

#include "physim/projectile.hpp"
#include "physim/world.hpp"
#include "simclient/core/lit_vertex.hpp"

namespace physim::client {

enum class BodyShape {
  ball,
  bullet,
  shell,
  arrow,
  rocket,
  golf_ball,
  baseball,
  football,
  tennis_ball,
  shuttlecock,
  brick
};
inline constexpr std::size_t kBodyShapes = 11;

/// The shape of a projectile and its extent along body axes: x forward, y up, z right.
struct BodyLook {
  BodyShape shape = BodyShape::ball;
  Vec3d size;  // [m]
};

/// By its motor, its inertia, its data of drag and spin, its size and mass; and by words in its name.
[[nodiscard]] BodyLook look_of(const ProjectileDef& projectile);

/// The triangles of a shape, three corners each, within +-0.5 along each axis. Opacity 254 stands for the colour of the
/// projectile's track. A plain ball has none: it is drawn as a disc that is shaded.
[[nodiscard]] std::span<const LitVertex> mesh_of(BodyShape shape);

/// The rotation about an axis of length one [rad].
[[nodiscard]] Quatd turn_about(const Vec3d& axis, double angle);
/// Nose along a way, with the right side level; the identity for none.
[[nodiscard]] Quatd nose_along(const Vec3d& way);
/// Angular velocity of a ball in W, by its spin and the direction in which it was launched [rad/s].
[[nodiscard]] Vec3d spin_in_world(const Launch& launch);

}  // namespace physim::client
