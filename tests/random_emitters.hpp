// Random emitters of every row, for golden hashes and random sessions.
#pragma once

#include "random_shots.hpp"

namespace physim::test {

inline Curve random_curve(Random& r) {
  Curve curve;
  double at = r.in(0, 0.3);
  for (int i = 0, n = r.below(4); i < n; ++i, at += r.in(0.05, 0.2)) curve.push_back({at, r.in(0.1, 2)});
  return curve;
}

inline DrawnNumber random_number(Random& r, double low, double high) {
  DrawnNumber number{r.in(low, high)};
  const int kind = r.below(4);
  if (kind > 0) number.to = r.in(low, high);
  if (kind > 1) number.curve = random_curve(r);
  if (kind > 2) number.to_curve = random_curve(r);
  return number;
}

inline DrawnColour random_colour(Random& r) {
  DrawnColour colour{.colour = static_cast<std::uint32_t>(r.in(0, 4e9))};
  if (r.one_in(2)) colour.to = static_cast<std::uint32_t>(r.in(0, 4e9));
  if (r.one_in(2)) colour.gradient = {{0, 0xff0000ff}, {r.in(0.1, 0.9), 0x80ff2010}, {1, 0x10ff80ff}};
  return colour;
}

inline void add_moments(Random& r, EmitterDef& def) {
  def.cycle = {
      .duration = r.in(0.1, 1), .looping = !r.one_in(4), .delay = random_number(r, 0, 0.2), .rate = r.in(0.5, 2)};
  def.cycle.plays = !r.one_in(4);
  if (r.one_in(4)) def.cycle.stop = StopAction::remove;
  def.per_second = r.one_in(3) ? DrawnNumber{0} : random_number(r, 5, 80);
  if (r.one_in(3)) def.per_metre = r.in(0.2, 4);
  if (r.one_in(3))
    def.bursts = {{.time = r.in(0, 0.3),
                   .count = random_number(r, 0, 6),
                   .cycles = static_cast<std::uint32_t>(r.below(4)),
                   .interval = r.in(0.02, 0.2),
                   .probability = r.in(0.2, 1)}};
  if (!r.one_in(3)) return;
  def.gun = {.rounds_per_minute = r.in(100, 4000), .dispersion = r.in(0, 0.05)};
  if (r.one_in(2))
    def.gun.burst_rounds = 3, def.gun.burst_pause = 0.1, def.gun.recoil = 0.1, def.gun.recoil_up = {{0, 0}, {1, 1}};
  if (r.one_in(2)) def.gun.tracer_every = 2, def.gun.tracer = def.kind;
  if (r.one_in(2)) def.gun.barrels = {{r.vector(0.5)}, {r.vector(0.5)}}, def.gun.convergence = 100;
}

inline SceneMotion random_emitter_motion(Random& r) {
  if (r.one_in(3)) return SteadyMotion{.velocity = r.vector(30), .angular_velocity = r.vector(3)};
  if (!r.one_in(2)) return AtRest{};
  KeyedMotion keyed{.keys = {}, .curve = r.one_in(2) ? MotionCurve::smooth : MotionCurve::straight};
  for (int i = 0; i < 4; ++i) {
    const Vec3d position = r.vector(8), velocity = r.vector(15);
    keyed.keys.push_back({0.3 * i, position, {1, r.in(-1, 1), 0, 0}, velocity});
  }
  return keyed;
}

/// What acts on the flight, for kinds in motion `force`.
inline ParticleFlight random_flight(Random& r) {
  const IeeeMode mode;
  ParticleFlight flight;
  if (r.one_in(2)) flight.drag = random_number(r, 0, 3);
  if (r.one_in(2)) flight.fast = 30, flight.drag_by_speed = {{0, 0.5}, {1, 2}};
  if (r.one_in(2)) flight.gravity = random_number(r, -1, 2);
  if (r.one_in(3)) flight.velocity_x = random_number(r, -5, 5);
  if (r.one_in(3)) flight.velocity_y = random_number(r, -5, 5);
  if (r.one_in(3)) flight.velocity_z = random_number(r, -5, 5);
  if (r.one_in(3)) flight.force_x = random_number(r, -1e-3, 1e-3);
  if (r.one_in(3)) flight.force_y = random_number(r, -1e-3, 1e-3);
  if (r.one_in(3)) flight.force_z = random_number(r, -1e-3, 1e-3);
  if (r.one_in(3)) flight.limit = random_number(r, 1, 30), flight.limit_rate = r.in(0, 9);
  if (!r.one_in(2)) return flight;
  flight.noise = random_number(r, 0, 20);
  flight.noise_size = r.in(0.2, 4);
  flight.noise_rate = r.one_in(2) ? r.unit() : 0;
  flight.noise_octaves = static_cast<std::uint32_t>(1 + r.below(4));
  flight.noise_gain = r.unit();
  return flight;
}

/// Out of a mesh or terrain, as rain, or with trails.
inline void add_shapes(Random& r, EmitterDef& def) {
  if (r.one_in(3)) {
    MeshShape mesh;
    for (int i = 0; i < 5; ++i) mesh.vertices.push_back(r.vector(2));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 3, 4}, {4, 1, 0}};
    HeightFieldShape field{4, 3, 1, 2, {}};
    for (int i = 0; i < 12; ++i) field.heights.push_back(r.in(0, 3));
    def.from.shape = static_cast<EmitShape>(8 + r.below(4));
    const bool is_field = def.from.shape == EmitShape::terrain;
    const auto shape = is_field ? SharedShape::make(field) : SharedShape::make(mesh);
    def.from.surface = {.scale = r.in(0.2, 2), .along = static_cast<EmitAlong>(r.below(3)), .high_x = r.in(0.5, 4)};
    if (shape) def.from.surface.shape = *shape;
  }
  if (r.one_in(4)) {
    def.rain = {.density = r.in(0.02, 0.1), .size = {r.in(3, 9), r.in(3, 9), r.in(3, 9)}, .drift = r.vector(5)};
    def.rain.shelter = r.one_in(2) ? 20 : 0;
    def.inherit_velocity = 0;
  }
  if (r.one_in(3)) def.trail = {.points = 8, .time = r.in(0.1, 1), .distance = r.in(0, 1)};
}

/// One that fires `kind`; `others` are emitters of the same world that it may set off.
inline EmitterDef random_emitter(Random& r, KindId kind, std::span<const EmitterId> others) {
  const IeeeMode mode;
  EmitterDef def{.kind = kind};
  if (r.one_in(2)) def.seed = static_cast<std::uint64_t>(r.below(1000));
  def.position = r.vector(20);
  def.position.y = r.in(0, 20);
  def.rotation = {1, r.in(-1, 1), r.in(-1, 1), r.in(-1, 1)};
  add_moments(r, def);
  def.motion = random_emitter_motion(r);
  def.inherit_velocity = r.one_in(2) ? r.unit() : 0;
  def.from = {.shape = static_cast<EmitShape>(r.below(8)), .radius = r.in(0.2, 2), .angle = r.in(0, 1.2)};
  def.from.thickness = r.unit();
  def.from.arc = r.in(1, 6);
  def.from.arc_mode = static_cast<ArcMode>(r.below(4));
  def.from.randomise = r.one_in(2) ? r.unit() : 0;
  def.start.lifetime = r.one_in(5) ? DrawnNumber{kInfinity} : random_number(r, 0.05, 1.5);
  def.start.speed = random_number(r, 0, 40);
  def.start.size = random_number(r, 0.1, 2);
  def.start.rotation = random_number(r, -3, 3);
  def.start.flipped = r.unit();
  def.start.colour = random_colour(r);
  if (r.one_in(3)) def.start.gravity = random_number(r, -1, 2);
  def.life.size = random_number(r, 0.2, 1);
  def.life.turn = random_number(r, -3, 3);
  def.life.colour = random_colour(r);
  if (r.one_in(3))
    def.life.fast = 30, def.life.size_by_speed = {{0, 1}, {1, 2}}, def.life.colour_by_speed = {{0, 0xff}, {1, 0xffff}};
  add_shapes(r, def);
  def.maximum = static_cast<std::uint32_t>(1 + r.below(60));
  if (r.one_in(2)) def.when_full = WhenFull::replace_oldest;
  for (const EmitterId other : others) {
    if (!r.one_in(3)) continue;
    SubEmitter sub{.on = static_cast<SubEvent>(r.below(10)),
                   .emitter = other,
                   .count = {r.in(0, 3)},
                   .probability = r.unit(),
                   .age = r.in(0.01, 0.5),
                   .axis = static_cast<SubAxis>(r.below(3)),
                   .inherit_velocity = r.unit(),
                   .inherit_colour = r.one_in(2),
                   .inherit_size = r.one_in(2)};
    def.subs.push_back(sub);
  }
  return def;
}

}  // namespace physim::test
