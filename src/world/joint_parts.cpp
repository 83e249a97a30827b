// A step of a net in parts that are short enough for it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "world/joint_solver.hpp"

namespace physim {
namespace {

/// In how many parts a step of a net is taken. A light body between two rods that hold a heavy one swings across them
/// at the root of w T (1/L + 1/L'), with w one over its mass and T what pulls at the rods; steps that are long beside
/// that would throw it about. What pulls is three times the weights of all: as much as at the lowest point of a
/// pendulum that came down from the level.
std::uint32_t parts_of_step(std::span<const NetBody> bodies, std::span<const NetRow> rows, double h) {
  constexpr double kSlow = 4, kTurnOfPart = 4.0 / 3, kMostParts = 1000;  // [rad], [rad], [-]
  std::vector<double> bends(bodies.size());                              // by body, sum of 1/L [1/m]
  for (const NetRow& row : rows) {
    const bool holds = row.kind == NetRow::Kind::rod || row.kind == NetRow::Kind::cable;
    if (holds && row.length > 0) bends[row.a] += 1 / row.length, bends[row.b] += 1 / row.length;
  }
  double pull = 0, swings = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const NetBody& body = bodies[i];
    const double w = std::max(std::max(body.mobility.x, body.mobility.y), body.mobility.z);
    if (!(w > 0)) continue;
    pull += 3 / w * length(body.v - body.start_velocity) / h;
    swings = std::max(swings, w * bends[i]);
  }
  const double turns = h * std::sqrt(pull * swings);
  return turns > kSlow ? static_cast<std::uint32_t>(std::min(std::ceil(turns / kTurnOfPart), kMostParts)) : 1;
}

}  // namespace

NetReport hold_net(std::span<NetBody> bodies, std::span<NetRow> rows, double h) {
  const std::uint32_t parts = parts_of_step(bodies, rows, h);
  if (parts == 1) return hold_part(bodies, rows, h);
  // Each part begins where the net left off in the last one, and is flown with the mean acceleration of the step.
  const double part = h / parts;
  PHYSIM_ASSERT(part > 0);
  const std::vector<NetBody> flown(bodies.begin(), bodies.end());
  NetReport all;
  std::vector<NetRow> found(rows.begin(), rows.end());
  for (NetBody& body : bodies) body.x = body.start, body.v = body.start_velocity;
  for (NetRow& row : found) row.impulse = 0, row.came_taut = false;
  for (std::uint32_t k = 0; k < parts; ++k) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      NetBody& body = bodies[i];
      const NetBody& alone = flown[i];
      const Vec3d a = (alone.v - alone.start_velocity) * (1 / h);
      const Vec3d beside = alone.x - alone.start - (alone.v + alone.start_velocity) * (0.5 * h);
      body.start = body.x, body.start_velocity = body.v;
      body.x += body.v * part + a * (0.5 * part * part) + beside * (1.0 / parts);
      body.v += a * part;
    }
    const NetReport report = hold_part(bodies, rows, part);
    all.rounds += report.rounds;
    all.residual = std::max(all.residual, report.residual);
    all.solved = all.solved && report.solved;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      found[i].impulse += rows[i].impulse;
      if (rows[i].came_taut) found[i].came_taut = true, found[i].speed = std::max(found[i].speed, rows[i].speed);
    }
  }
  std::ranges::copy(found, rows.begin());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i].start = flown[i].start, bodies[i].start_velocity = flown[i].start_velocity;
  return all;
}

}  // namespace physim
