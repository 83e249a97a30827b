#include "world_bench.hpp"

#include <cmath>

#include "physim/units.hpp"

namespace physim::bench {

using namespace physim::units;

namespace {

constexpr double kK1 = 2e-5;    // [kg/s]
constexpr double kK2 = 1.2e-5;  // the drag of a .308 bullet at half the speed of sound [kg/m]

}  // namespace

ProjectileDef world_bullet(const Fidelity& fidelity) {
  ProjectileDef p;
  p.name = ".308 168 gr";
  p.mass = 168_gr;
  p.diameter = 7.82_mm;
  p.drag.table = DragTable::g7;
  p.drag.ballistic_coefficient = 0.218_lb_in2;
  p.drag.damping = 0.9;
  p.drag.k1 = kK1;
  p.drag.k2 = kK2;
  p.fidelity = fidelity;
  return p;
}

PeerPhysics peer_physics() {
  const ProjectileDef p = world_bullet({});
  return {static_cast<float>(Environment().gravity.acceleration), static_cast<float>(p.mass),
          static_cast<float>(p.diameter / 2), static_cast<float>(kK1), static_cast<float>(kK2)};
}

Launch volley_launch(std::size_t i) {
  const double turn = 0.618034 * static_cast<double>(i);  // golden ratio: evenly spread, never twice the same
  const double part = turn - std::floor(turn);
  Launch launch;
  launch.position = {static_cast<double>(i % 1000), 100, static_cast<double>(i / 1000)};
  launch.velocity = Vec3d{600 + 200 * part, 200 - 100 * part, 40 * (part - 0.5)};
  return launch;
}

std::vector<Launch> volley(std::size_t count) {
  std::vector<Launch> launches;
  for (std::size_t i = 0; i < count; ++i) launches.push_back(volley_launch(i));
  return launches;
}

std::vector<PeerProjectile> peer_volley(std::size_t count) {
  std::vector<PeerProjectile> list;
  for (const Launch& l : volley(count)) {
    const Vec3d& v = *l.velocity;
    list.push_back(
        {{static_cast<float>(l.position.x), static_cast<float>(l.position.y), static_cast<float>(l.position.z)},
         {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}});
  }
  return list;
}

WorldDef free_flight() {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  def.threading.threads = 1;
  return def;
}

World world_of(const WorldDef& def, std::span<const Fidelity> fidelities, std::size_t count) {
  World world = std::move(World::create(def).value());
  std::vector<KindId> kinds;
  for (const Fidelity& f : fidelities) {
    kinds.push_back(*world.add_kind(world_bullet(f)));
    world.reserve(kinds.back(), count / fidelities.size() + 1);
  }
  for (std::size_t i = 0; i < count; ++i) world.spawn(kinds[i % kinds.size()], volley_launch(i));
  return world;
}

Fidelity curve_fidelity(Integrator integrator) {
  Fidelity f = Fidelity::game();
  f.integrator = integrator;
  f.drag = DragModel::equation;
  f.air = AirModel::isa;
  return f;
}

std::vector<Fidelity> sixteen_fidelities() {
  std::vector<Fidelity> list;
  for (const Integrator i : {Integrator::semi_implicit_euler, Integrator::explicit_euler})
    for (const DragModel d : {DragModel::off, DragModel::damping, DragModel::linear_quadratic, DragModel::equation})
      for (const GravityModel g : {GravityModel::constant, GravityModel::inverse_square}) {
        Fidelity f = curve_fidelity(i);
        f.drag = d;
        f.gravity = g;
        list.push_back(f);
      }
  return list;
}

std::vector<double> each_ns(const std::vector<double>& seconds, double count) {
  std::vector<double> list;
  for (const double s : seconds) list.push_back(1e9 * s / count);
  return list;
}

Cell nanoseconds(double value) { return fixed(value, value < 10 ? 2 : value < 100 ? 1 : 0); }

Cell quartiles(const std::vector<double>& values) {
  return nanoseconds(quantile(values, 0.25)).text + " .. " + nanoseconds(quantile(values, 0.75)).text;
}

}  // namespace physim::bench
