// Calls about generators and level of detail, until they are there.
#include "world/world_impl.hpp"

namespace physim {

ForceId World::add_force(const ForceDef& force) {
  const Recorded<Call::add_force> call(impl_->recorder, force);
  impl_->refuse({"there are no generators yet", "force", ""});
  return call.returns(ForceId{});
}
ForceId World::add_force(ProjectileId id, ForceLaw law, double duration) {
  const Recorded<Call::add_force_on> call(impl_->recorder, id, law, duration);
  impl_->refuse({"there are no generators yet", "force", ""});
  return call.returns(ForceId{});
}
bool World::remove_force(ForceId force) {
  const Recorded<Call::remove_force> call(impl_->recorder, force);
  return impl_->refuse({"there are no generators yet", "force", ""});
}
bool World::remove_force(ForceId force, ProjectileId id) {
  const Recorded<Call::remove_force_from> call(impl_->recorder, force, id);
  return impl_->refuse({"there are no generators yet", "force", ""});
}
bool World::is_active(ForceId) const { return false; }
std::size_t World::force_count() const { return 0; }

void World::set_detail(const DetailRule& rule) {
  const Recorded<Call::set_detail> call(impl_->recorder, rule);
  if (!check(rule)) impl_->state.detail = rule;
}

}  // namespace physim
