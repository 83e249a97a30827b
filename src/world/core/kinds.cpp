#include "world/core/kinds.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace physim {
namespace {

/// Memory of a definition beside its struct: what its lists take, roughly [bytes].
std::size_t list_bytes(const ProjectileDef& p) {
  return (p.drag.curve.capacity() + p.motor.drag_curve.capacity()) * sizeof(DragPoint) +
         p.motor.thrust.capacity() * sizeof(ThrustPoint) + p.magnus.table.capacity() * sizeof(MagnusPoint) +
         p.aero.drag_yaw.capacity() * 10 * sizeof(AeroPoint);
}

}  // namespace

std::uint32_t Kinds::find(std::uint64_t hash, const ProjectileDef& projectile, const BodyDef& body) const {
  const auto [from, to] = by_hash_.equal_range(hash);
  for (auto at = from; at != to; ++at)
    if (is(at->second, projectile, body)) return at->second;
  return 0;
}

std::uint32_t Kinds::add(Kind kind) {
  auto index = static_cast<std::uint32_t>(all_.size() + 1);
  if (kind.number == 0) kind.number = ++last_number_;
  meet_others_ = meet_others_ || kind.body.collision.others != 0;
  if (free_.empty()) {
    all_.push_back(std::make_unique<Kind>(std::move(kind)));
  } else {
    index = free_.back();
    all_[index - 1] = std::make_unique<Kind>(std::move(kind));
    free_.pop_back();
  }
  remember(index);
  if (!(*this)[index].stays) become_idle(index);
  return index;
}

void Kinds::remember(std::uint32_t index) {
  Kind& kind = (*this)[index];
  kind.forgotten = false;
  by_number_.emplace(kind.number, index);
  by_hash_.emplace(kind.hash, index);
}

void Kinds::become_idle(std::uint32_t index) {
  Kind& kind = (*this)[index];
  PHYSIM_ASSERT(!kind.stays && kind.alive == 0 && kind.idle_since == 0);
  kind.idle_since = ++idle_turns_;
  idle_.push_back({index, kind.idle_since});
  ++idle_count_;
}

void Kinds::become_busy(Kind& kind) {
  if (kind.idle_since == 0) return;
  PHYSIM_ASSERT(idle_count_ > 0);
  kind.idle_since = 0;
  --idle_count_;
  if (idle_.size() > 2 * kMostIdleKinds + 2 * idle_count_)
    std::erase_if(idle_, [this](const Idle& i) { return is_stale(i); });
}

void Kinds::keep(std::uint32_t index) {
  Kind& kind = (*this)[index];
  kind.stays = true;
  become_busy(kind);
}

void Kinds::forget_idle(const Living& living) {
  while (idle_count_ > kMostIdleKinds) {
    const Idle first = idle_.front();
    idle_.pop_front();
    if (!is_stale(first)) forget(first.index);
  }
  if (forgotten_.size() >= look_at_) let_go(living);
}

void Kinds::forget(std::uint32_t index) {
  Kind& kind = (*this)[index];
  PHYSIM_ASSERT(kind.alive == 0 && !kind.forgotten);
  kind.idle_since = 0;
  --idle_count_;
  kind.forgotten = true;
  by_number_.erase(kind.number);
  const auto [from, to] = by_hash_.equal_range(kind.hash);
  by_hash_.erase(std::find_if(from, to, [index](const auto& each) { return each.second == index; }));
  forgotten_.push_back(index);
}

void Kinds::let_go(const Living& living) {
  std::erase_if(forgotten_, [&](std::uint32_t index) {
    const Kind& kind = (*this)[index];
    if (!kind.forgotten) return true;  // a restore brought it back
    if (living.has_one(kind.born, kind.last_needed)) return false;
    all_[index - 1].reset();
    free_.push_back(index);
    return true;
  });
  look_at_ = 2 * forgotten_.size() + 64;
}

// --------------------------------------------------------------------------------------------------- moments
void Kinds::begin_recount() {
  each([](Kind& kind) {
    kind.idle_since = kind.alive > 0 ? 1 : 0;  // for end_recount(): it was there
    kind.alive = 0;
  });
}

/// In order of numbers, so that a replay, which has its kinds elsewhere, does the same.
void Kinds::end_recount(std::uint64_t moment) {
  std::vector<std::uint32_t> by_age;
  for (std::uint32_t index = 1; index <= all_.size(); ++index)
    if (all_[index - 1]) by_age.push_back(index);
  std::ranges::sort(by_age, {}, [this](std::uint32_t index) { return (*this)[index].number; });
  idle_.clear();
  idle_count_ = 0;
  for (const std::uint32_t index : by_age) {
    Kind& kind = (*this)[index];
    if (kind.idle_since != 0) kind.last_needed = moment;
    kind.idle_since = 0;
    if (kind.forgotten && kind.alive > 0) remember(index);
    if (!kind.forgotten && !kind.stays && kind.alive == 0) become_idle(index);
  }
}

std::vector<const Kind*> Kinds::known() const {
  std::vector<const Kind*> kinds;
  for (const auto& kind : all_)
    if (kind && !kind->forgotten) kinds.push_back(kind.get());
  std::ranges::sort(kinds, {}, &Kind::number);
  return kinds;
}

std::vector<std::uint32_t> Kinds::idle_numbers() const {
  std::vector<std::uint32_t> numbers;
  for (const Idle& idle : idle_)
    if (!is_stale(idle)) numbers.push_back((*this)[idle.index].number);
  return numbers;
}

void Kinds::go_on_from(std::uint32_t last_number, const std::vector<std::uint32_t>& idle) {
  last_number_ = last_number;
  for (const std::uint32_t number : idle) {
    const std::uint32_t index = find(KindId{number});
    if (index == 0 || (*this)[index].stays || (*this)[index].alive > 0) continue;
    become_busy((*this)[index]);
    become_idle(index);  // in their order
  }
}

std::size_t Kinds::bytes() const {
  constexpr std::size_t kNode = 48;  // of a table
  std::size_t bytes = all_.capacity() * sizeof(all_[0]) + (by_number_.size() + by_hash_.size()) * kNode;
  for (const auto& kind : all_) {
    if (!kind) continue;
    bytes += sizeof(Kind) + 2 * list_bytes(kind->projectile);
    for (const Prepared& rung : kind->rungs)
      bytes += sizeof(Prepared) + (rung.rotor ? sizeof(*rung.rotor) : 0) +
               (rung.equivalent_drag ? sizeof(*rung.equivalent_drag) : 0);
  }
  return bytes;
}

}  // namespace physim
