// What is met, many times over: casts, impacts in worlds, sparks of hits. Each part prints what it tried and what was
// wrong, and says how much that was.
#pragma once

namespace physim::test {

/// So many casts for each shape and place, beside signed distances in long double; a hundred times as many rays
/// out of closed meshes.
long wrong_casts(long count, long seed);
/// So many flights at thin things, and as many past them.
long wrong_impacts(long count, long seed);
/// So many hits of a wall, each of which sets off a spark, at five frame rates.
/// So many points and balls onto seams of floors, for each pair of bodies.
long wrong_seams(long count, long seed);
long wrong_sparks(long count);

}  // namespace physim::test
