#include "emit/emission.hpp"

#include <algorithm>

#include "emit/parts.hpp"

namespace physim {
namespace {

/// A number of a particle's own, drawn only where it is asked for.
auto drawing(ParticleChance& chance, Draw what) {
  return [&chance, what] { return chance(what); };
}

double of_size(const EmitStart& start, const EmitLife& life, double phase, double x, ParticleChance& chance) {
  return start.size.at(phase, drawing(chance, Draw::size)) * life.size.at(x, drawing(chance, Draw::life_size));
}

/// By how much a particle has turned since its birth. Its curve goes over `span` [s].
double turned(const EmitNumber& turn, double age, double span, ParticleChance& chance) {
  PHYSIM_ASSERT(span > 0 && span < kInfinity);
  return span * turn.integral(age / span, drawing(chance, Draw::life_turn));
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

Look Emission::look(std::uint64_t number, double phase, double lifetime, double age, double speed) const {
  const Parts& p = *parts_;
  const EmitStart& start = p.start;
  PHYSIM_ASSERT(lifetime > 0 && age >= 0 && speed >= 0);
  ParticleChance chance(p.seed, number);
  const double span = lifetime < kInfinity ? lifetime : 1;  // [s]
  const double x = std::min(age / span, 1.0);
  const double fast = p.def.life.fast;
  const double hurry = fast > 0 ? std::min(speed / fast, 1.0) : 0;

  double size = of_size(start, p.life, phase, x, chance);
  if (fast > 0) size *= p.life.size_by_speed(hurry);
  Look look;
  look.size = {size, size * start.size_y.at(phase, drawing(chance, Draw::size_y)),
               size * start.size_z.at(phase, drawing(chance, Draw::size_z))};

  look.rotation = {start.rotation.at(phase, drawing(chance, Draw::rotation)) + turned(p.life.turn, age, span, chance),
                   start.rotation_y.at(phase, drawing(chance, Draw::rotation_y)),
                   start.rotation_z.at(phase, drawing(chance, Draw::rotation_z))};
  const double flipped = p.def.start.flipped;
  if (flipped > 0 && chance(Draw::flipped) < flipped) look.rotation = -look.rotation;

  const bool by_speed = fast > 0 && !p.life.colour_by_speed.is_white();
  if (start.colour.is_white() && p.life.colour.is_white() && !by_speed) return look;
  Rgba colour = p.life.colour.at(x, drawing(chance, Draw::life_colour));
  if (!start.colour.is_white()) colour = times(start.colour.at(phase, drawing(chance, Draw::colour)), colour);
  if (by_speed) colour = times(colour, p.life.colour_by_speed(hurry));
  look.colour = colour.packed();
  return look;
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
