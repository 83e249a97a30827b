#include "world/core/emitters.hpp"

#include <algorithm>
#include <cmath>

#include "base/archive.hpp"

namespace physim {

std::uint32_t Emitters::add() {
  ++added_;
  std::uint32_t index = size();
  if (!free_.empty()) {
    index = free_.back();
    free_.pop_back();
  } else {
    all_.emplace_back();
  }
  const std::uint32_t generation = all_[index].generation + 1;
  all_[index] = {};
  all_[index].generation = generation;
  all_[index].active = true;
  return index;
}

void Emitters::erase(std::uint32_t index) {
  const std::uint32_t generation = (*this)[index].generation;
  PHYSIM_ASSERT(all_[index].active);
  all_[index] = {};
  all_[index].generation = generation;
  free_.push_back(index);
  for (std::size_t slot = 0; slot < particles_.size(); ++slot)
    if (emitter_of_[slot] == index) particles_[slot] = {}, emitter_of_[slot] = 0;
}

void Emitters::join(ProjectileId id, const Particle& particle, double birth, double seen) {
  PHYSIM_ASSERT(id && particle.emitter > 0 && particle.dies >= birth);
  resume(id, particle);
  const Emitter& emitter = (*this)[particle.emitter];
  if (std::isfinite(particle.dies) && particle.dies > seen) lives.add(particle.dies, id);
  each_age(emitter.def().subs, birth, [&](double then) {
    if (then > seen && then <= particle.dies) ages.add(then, id);
  });
}

void Emitters::resume(ProjectileId id, const Particle& particle) {
  if (particles_.size() <= id.index) {
    particles_.resize(std::max<std::size_t>(id.index + 1, particles_.size() * 2));
    spans_.resize(particles_.size());
    emitter_of_.resize(particles_.size());
  }
  particles_[id.index] = particle;
  spans_[id.index] = {particle.number, particle.dies};
  emitter_of_[id.index] = particle.emitter;
  Emitter& emitter = (*this)[particle.emitter];
  emitter.bequeaths = emitter.bequeaths || particle.size != 1 || particle.colour != 0xffffffff;
  ++emitter.counts.alive;
  if (emitter.def().when_full != WhenFull::replace_oldest) return;
  emitter.by_age.push_back({id, particle.number});
  constexpr std::size_t kFew = 1024;
  if (emitter.by_age.size() <= 2 * std::size_t{emitter.counts.alive} + kFew) return;
  std::erase_if(emitter.by_age, [&](const Aged& aged) { return is_gone(aged, particle.emitter); });
  emitter.oldest = 0;
}

void Emitters::leave_emitter(std::uint32_t slot, EmitterCount why) {
  EmitterCounts& counts = (*this)[emitter_of(slot)].counts;
  PHYSIM_ASSERT(counts.alive > 0);
  --counts.alive;
  ++(counts.*why);
  particles_[slot] = {};
  emitter_of_[slot] = 0;
}

bool Emitters::is_gone(const Aged& aged, std::uint32_t emitter) const {
  const Particle* now = particle(aged.id.index);
  return !now || now->emitter != emitter || now->number != aged.number;
}

ProjectileId Emitters::oldest(std::uint32_t index) {
  Emitter& emitter = (*this)[index];
  PHYSIM_ASSERT(emitter.oldest <= emitter.by_age.size());
  for (; emitter.oldest < emitter.by_age.size(); ++emitter.oldest)
    if (!is_gone(emitter.by_age[emitter.oldest], index)) return emitter.by_age[emitter.oldest].id;
  return {};
}

std::size_t Emitters::bytes() const {
  std::size_t sum = particles_.capacity() * (sizeof(Particle) + sizeof(ParticleSpan) + sizeof(std::uint32_t)) +
                    all_.capacity() * sizeof(Emitter) + lives.bytes() + ages.bytes() +
                    free_.capacity() * sizeof(std::uint32_t);
  for (const Emitter& emitter : all_)
    sum += emitter.by_age.capacity() * sizeof(Aged) + emitter.trails.bytes() + emitter.lead.bytes();
  return sum;
}

double Emitter::counted_from() const {
  return began + Timeline(*emission).span(timeline.play).first / def().cycle.rate;
}

void Emitter::leave_lead(double now) {
  double counted = travelled;
  lead.stop(now, counted_from(), counted);
  if (plays) travelled = counted;
}

namespace {

void add_place(Hash& hash, const Transform& at) {
  for (const double x : {at.position.x, at.position.y, at.position.z}) hash.add(x);
  for (const double x : {at.rotation.w, at.rotation.x, at.rotation.y, at.rotation.z}) hash.add(x);
}

void add_emitter(Hash& hash, const Emitter& e) {
  hash.add(e.generation, static_cast<std::uint32_t>(e.active) | static_cast<std::uint32_t>(e.plays) << 1 |
                             static_cast<std::uint32_t>(e.to.has_value()) << 2);
  if (!e.active) return;
  hash.add(e.hash);
  hash.add(e.began);
  hash.add(hash_of(e.timeline));
  hash.add(e.plays_before);
  hash.add(e.born);
  hash.add(e.travelled);
  if (e.first != 0) hash.add(e.first);
  if (e.rain.about) {
    for (const double x : {e.rain.about->x, e.rain.about->y, e.rain.about->z, e.rain.due}) hash.add(x);
  }
  if (e.launch) hash.add(e.launch->time);
  hash.add(e.metre);
  add_place(hash, e.at);
  if (e.to) add_place(hash, *e.to);
  for (const MotionKey& key : e.lead.keys()) {
    hash.add(key.time);
    add_place(hash, {key.position, key.rotation, 1});
  }
}

}  // namespace

void Emitters::add_to(Hash& hash, const SlotTable& slots) const {
  if (empty()) return;
  std::uint64_t ends = 0;  // of particles of removed emitters
  for (const Due& due : lives.all())
    if (!particle(due.id.index) && slots.find(due.id)) ends += hash_of(due.time, due.id.index);
  hash.add(ends);
  hash.add(added_);
  for (const Emitter& emitter : all_) add_emitter(hash, emitter);
  for (const std::uint32_t index : free_) hash.add(std::uint64_t{index});
  each_particle([&hash](std::uint32_t slot, const Particle& p) {
    hash.add(slot, p.emitter);
    hash.add(p.number);
    hash.add(p.dies);
    hash.add(p.phase);
    hash.add(p.size);
    hash.add(p.events, p.colour);
  });
}

bool Emitters::restore(std::vector<Emitter> all, std::vector<std::uint32_t> free, std::uint64_t added) {
  std::vector<bool> is_free(all.size());
  for (const std::uint32_t index : free) {
    if (index == 0 || index >= all.size() || is_free[index] || all[index].active) return false;
    is_free[index] = true;
  }
  for (std::size_t i = 1; i < all.size(); ++i)
    if (!all[i].active && !is_free[i]) return false;
  all_ = std::move(all);
  free_ = std::move(free);
  added_ = added;
  return true;
}

}  // namespace physim
