// A ball that touches two surfaces at once: in a groove, or on a floor along a wall.
//
// What it models: a hard ball that both surfaces keep out, each with Coulomb friction at its point of contact and with
// a
//   resistance to rolling. What friction at one does to the spin makes slip at the other, so neither can be looked at
//   alone: the ball may roll in a groove, slide on the floor and rub at the wall, or leave one of both.
// When to use it: over times in which both surfaces are planes that move evenly.
// When it is wrong: as model/ball_rolling.hpp; bounces, which are over before.
// Symbols: n_i unit normals towards the ball; u_i velocities of the surfaces [m/s]; v velocity [m/s], w spin [rad/s], r
//   radius [m], k moment of inertia over m r^2 [-]; a acceleration by everything but the surfaces [m/s^2]; N_i and J_i
//   impulses over mass along n_i and across it, in a part dt of the time [m/s]; mu_i friction, c_i rolling resistance
//   [-]; slip s_i = v - u_i - r w x n_i, across n_i [m/s].
// Equations: dv = a dt + sum (N_i n_i + J_i);  dw = -sum n_i x J_i / (k r), less c_i N_i / (k r) against what of w is
//   across n_i;  N_i >= 0 and (v - u_i) . n_i >= 0, one of them 0;  |J_i| <= mu_i N_i, s_i = 0 or J_i = -mu_i N_i s_i /
//   |s_i|. All hold at the end of each of kParts equal parts, to what sweeps over both surfaces leave (projected
//   Gauss-Seidel, from the impulses of the part before). Error: a slip that turns is held for a part: of order dt.
// Source: J. J. Moreau, "Unilateral contact and dry friction in finite freedom dynamics", CISM 302 (1988) 1-82; M.
// Jean,
//   "The non-smooth contact dynamics method", Comput. Methods Appl. Mech. Eng. 177 (1999) 235-257.
#pragma once

#include <array>

#include "model/ball_rolling.hpp"

namespace physim {

/// One of the two surfaces.
struct BallFace {
  Vec3d normal;    // towards the ball [-]
  Vec3d velocity;  // of what keeps the ball out [m/s]
  Vec3d runs;      // of its surface over that [m/s]
  BallGrip grip;
};

/// Motion of a ball along both of two surfaces for a time.
inline BallWay moved_between(BallMotion motion, const Vec3d& a, const std::array<BallFace, 2>& faces, const Ball& ball,
                             double time) {
  PHYSIM_ASSERT(time >= 0 && ball.radius > 0 && ball.inertia > 0);
  constexpr int kParts = 32, kSweeps = 24;
  const double dt = time / kParts;
  const Vec3d &n0 = faces[0].normal, &n1 = faces[1].normal;
  const double c = dot(n0, n1);
  std::array<double, 2> normal{};   // N
  std::array<Vec3d, 2> friction{};  // J
  const auto turn = [&](const BallFace& face, const Vec3d& along) {
    return component_product(ball.turns, cross(along, face.normal)) * (1 / (ball.inertia * ball.radius));
  };
  const auto press = [&](double on_0, double on_1) {
    motion.velocity += n0 * (on_0 - normal[0]) + n1 * (on_1 - normal[1]);
    normal = {on_0, on_1};
  };
  // Both N at once: of steep grooves one after the other would come near slowly.
  const auto keep_out = [&] {
    const double w0 = dot(motion.velocity - faces[0].velocity, n0) - normal[0] - c * normal[1];
    const double w1 = dot(motion.velocity - faces[1].velocity, n1) - normal[1] - c * normal[0];
    const double on_0 = (c * w1 - w0) / (1 - c * c), on_1 = (c * w0 - w1) / (1 - c * c);
    if (on_0 > 0 && on_1 > 0) return press(on_0, on_1);
    const double alone = max(-w0, 0.0);
    return w1 + c * alone >= 0 ? press(alone, 0) : press(0, max(-w1, 0.0));
  };
  const auto rub = [&](std::size_t i) {
    const BallFace& face = faces[i];
    const Vec3d relative = motion.velocity - face.velocity - face.runs;
    const Vec3d slip =
        relative - face.normal * dot(relative, face.normal) - cross(motion.spin, face.normal) * ball.radius;
    const double size = length(slip);
    const double gives = size > 0 ? 1 + ball.free_part(cross(face.normal, slip * (1 / size))) / ball.inertia : 1;
    Vec3d along = friction[i] - slip * (1 / gives);
    const double most = face.grip.friction * normal[i], wanted = length(along);
    if (wanted > most) along = along * (most / wanted);
    motion.velocity += along - friction[i];
    motion.spin += turn(face, along - friction[i]);
    friction[i] = along;
  };
  const auto resist = [&](std::size_t i) {
    const Vec3d& n = faces[i].normal;
    const Vec3d rolls = motion.spin - n * dot(motion.spin, n);
    const double rate = length(rolls);
    const double lost = faces[i].grip.rolling_resistance * normal[i] / (ball.inertia * ball.radius);
    if (rate > 0) motion.spin -= rolls * min(lost / rate, 1.0);
  };
  Vec3d way{};
  for (int part = 0; part < kParts; ++part) {
    const Vec3d before = motion.velocity;
    motion.velocity += a * dt + n0 * normal[0] + n1 * normal[1] + friction[0] + friction[1];
    motion.spin += turn(faces[0], friction[0]) + turn(faces[1], friction[1]);
    for (int sweep = 0; sweep < kSweeps; ++sweep) keep_out(), rub(0), rub(1);
    keep_out();
    resist(0), resist(1);
    way += (before + motion.velocity) * (0.5 * dt);
  }
  return {time, way, motion};
}

}  // namespace physim
