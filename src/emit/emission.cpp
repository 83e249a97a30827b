#include "emit/emission.hpp"

#include <algorithm>

#include "emit/newborn_pack.hpp"
#include "emit/parts.hpp"

namespace physim {
namespace {

/// A number of a particle's own, drawn only where it is asked for.
auto drawing(ParticleChance& chance, Draw what) {
  return [&chance, what] { return chance(what); };
}

}  // namespace

EmitStart::EmitStart(const EmitterDef& def)
    : lifetime(def.start.lifetime),
      speed(def.start.speed),
      size(def.start.size),
      size_y(def.start.size_y),
      size_z(def.start.size_z),
      rotation(def.start.rotation),
      rotation_y(def.start.rotation_y),
      rotation_z(def.start.rotation_z),
      gravity(def.start.gravity),
      colour(def.start.colour) {}

EmitLife::EmitLife(const EmitterDef& def)
    : size(def.life.size),
      turn(def.life.turn),
      colour(def.life.colour),
      size_by_speed(def.life.size_by_speed),
      colour_by_speed(def.life.colour_by_speed) {}

EmitWhen::EmitWhen(const EmitterDef& def, std::uint64_t seed) : delay(def.cycle.delay), rate(def, seed) {
  for (std::size_t i = 0; i < def.bursts.size(); ++i) bursts.emplace_back(def, i, seed);
}

Emission::Parts::Parts(const EmitterDef& of, std::uint64_t drawn_by)
    : def(of),
      seed(drawn_by),
      when(of, drawn_by),
      outlets(of.from),
      gun(of.gun),
      rain(of, drawn_by),
      start(of),
      life(of),
      flight(of.flight, drawn_by) {
  for (const SubEmitter& sub : of.subs) sub_counts.emplace_back(sub.count);
}

Emission::Emission(const EmitterDef& def, std::uint64_t seed) : parts_(std::make_unique<const Parts>(def, seed)) {}
Emission::~Emission() = default;

const EmitterDef& Emission::def() const { return parts_->def; }
std::uint64_t Emission::seed() const { return parts_->seed; }
const FlightLaw& Emission::flight() const { return parts_->flight; }
const Rain& Emission::rain() const { return parts_->rain; }

Newborn Emission::newborn(const Birth& birth) const {
  const Parts& p = *parts_;
  ParticleChance chance(p.seed, birth.number);
  Outlet out = p.outlets.at(birth, chance);
  if (birth.is_round) out = p.gun.aimed(out, birth.round, chance);
  Newborn born{.place = out.place, .direction = out.direction};
  born.speed = p.start.speed.at(birth.phase, drawing(chance, Draw::speed));
  born.lifetime = p.start.lifetime.at(birth.phase, drawing(chance, Draw::lifetime));
  born.gravity = p.start.gravity.at(birth.phase, drawing(chance, Draw::gravity));
  born.tracer = birth.is_round && p.gun.is_tracer(birth.round);
  PHYSIM_ASSERT(born.lifetime > 0);
  return born;
}

bool Emission::leaves_gravity() const { return parts_->start.gravity.is(1); }

void Emission::newborns(NewbornPack& pack) const {
  PHYSIM_ASSERT(leaves_gravity());
  const Parts& p = *parts_;
  PackChance<Draw, EmitStream::particle, NewbornPack::kLanes> chance(p.seed, pack.number, &particle_kernel(),
                                                                     pack.count);
  p.outlets.at_each(pack, chance);
  draw_each(p.start.speed, pack.phase, pack.speed, chance, Draw::speed);
  draw_each(p.start.lifetime, pack.phase, pack.lifetime, chance, Draw::lifetime);
  PHYSIM_ASSERT(std::all_of(pack.lifetime.begin(), pack.lifetime.begin() + static_cast<std::ptrdiff_t>(pack.count),
                            [](double lifetime) { return lifetime > 0; }));
}

std::uint32_t Emission::fired_by(std::size_t sub, std::uint64_t number, std::uint64_t nth) const {
  const Parts& p = *parts_;
  PHYSIM_ASSERT(sub < p.sub_counts.size());
  const double probability = p.def.subs[sub].probability;
  const EmitNumber& count = p.sub_counts[sub];
  const bool sure = probability == 1;
  PhiloxCounter words{};
  if (!sure || count.is_drawn())
    words = emit_words(p.seed, EmitStream::sub, static_cast<std::uint32_t>(sub), number, nth);
  if (!sure && open_unit(words[0]) >= probability) return 0;
  return whole_count(count.plain([&words] { return open_unit(words[1]); }));
}

}  // namespace physim
