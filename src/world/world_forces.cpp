// Force generators of a world.
#include "world/world_impl.hpp"

namespace physim {

bool World::Impl::feels_forces(std::uint32_t) const { return false; }
void World::Impl::update_forced(std::uint32_t) {}
void World::Impl::end_generators() {}
Vec3d World::Impl::generator_force(std::uint32_t) const { return {}; }
void World::Impl::step_forced(double) {}

}  // namespace physim
