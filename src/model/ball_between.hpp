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

/// A ball along both of two surfaces.
class BallBetween {
 public:
  BallBetween(const BallMotion& motion, const std::array<BallFace, 2>& faces, const Ball& ball)
      : motion_(motion), faces_(faces), ball_(ball), c_(dot(faces[0].normal, faces[1].normal)) {
    PHYSIM_ASSERT(ball.radius > 0 && ball.inertia > 0);
  }

  /// Its motion for a time.
  BallWay run(const Vec3d& a, double time) {
    PHYSIM_ASSERT(time >= 0);
    constexpr int kParts = 32;
    const double dt = time / kParts;
    Vec3d way{};
    for (int part = 0; part < kParts; ++part) {
      const Vec3d before = motion_.velocity;
      motion_.velocity += a * dt;
      for (std::size_t i = 0; i < faces_.size(); ++i) begin_with_last(i);
      find_impulses();
      way += (before + motion_.velocity) * (0.5 * dt);
    }
    return {time, way, motion_};
  }

 private:
  struct Impulse {
    double normal = 0;  // N
    Vec3d friction{};   // J
    Vec3d torque{};     // of rolling resistance, over the moment of inertia [rad/s]
  };

  void find_impulses() {
    constexpr int kSweeps = 24;
    constexpr double kNear = 1e-15;  // of the motion: what a sweep changes then is rounding [-]
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      const BallMotion was = motion_;
      keep_out();
      for (std::size_t i = 0; i < faces_.size(); ++i) rub(i), resist(i);
      const double changed = length(motion_.velocity - was.velocity) + ball_.radius * length(motion_.spin - was.spin);
      if (changed <= kNear * (length(motion_.velocity) + ball_.radius * length(motion_.spin))) break;
    }
    keep_out();
  }
  /// A part begins with the impulses of the part before.
  void begin_with_last(std::size_t i) {
    const Impulse& last = impulses_[i];
    motion_.velocity += faces_[i].normal * last.normal + last.friction;
    motion_.spin += turn(i, last.friction) + component_product(ball_.turns, last.torque);
  }
  /// The spin that an impulse across a normal gives.
  [[nodiscard]] Vec3d turn(std::size_t i, const Vec3d& friction) const {
    return component_product(ball_.turns, cross(friction, faces_[i].normal)) * (1 / (ball_.inertia * ball_.radius));
  }
  /// Finds both N at once: in steep grooves one after the other would come near slowly.
  void keep_out() {
    const double now_0 = impulses_[0].normal, now_1 = impulses_[1].normal;
    const double w_0 = dot(motion_.velocity - faces_[0].velocity, faces_[0].normal) - now_0 - c_ * now_1;
    const double w_1 = dot(motion_.velocity - faces_[1].velocity, faces_[1].normal) - now_1 - c_ * now_0;
    const double on_0 = (c_ * w_1 - w_0) / (1 - c_ * c_), on_1 = (c_ * w_0 - w_1) / (1 - c_ * c_);
    if (on_0 > 0 && on_1 > 0) return press(on_0, on_1);
    const double alone = max(-w_0, 0.0);
    return w_1 + c_ * alone >= 0 ? press(alone, 0) : press(0, max(-w_1, 0.0));
  }
  void press(double on_0, double on_1) {
    motion_.velocity +=
        faces_[0].normal * (on_0 - impulses_[0].normal) + faces_[1].normal * (on_1 - impulses_[1].normal);
    impulses_[0].normal = on_0, impulses_[1].normal = on_1;
  }
  void rub(std::size_t i) {
    const BallFace& face = faces_[i];
    Impulse& impulse = impulses_[i];
    const Vec3d &n = face.normal, relative = motion_.velocity - face.velocity - face.runs;
    const Vec3d slip = relative - n * dot(relative, n) - cross(motion_.spin, n) * ball_.radius;
    const double size = length(slip);
    const double gives = size > 0 ? 1 + ball_.free_part(cross(n, slip * (1 / size))) / ball_.inertia : 1;
    const Vec3d friction = within(impulse.friction - slip * (1 / gives), face.grip.friction * impulse.normal);
    motion_.velocity += friction - impulse.friction;
    motion_.spin += turn(i, friction - impulse.friction);
    impulse.friction = friction;
  }
  void resist(std::size_t i) {
    const BallFace& face = faces_[i];
    Impulse& impulse = impulses_[i];
    const double most = face.grip.rolling_resistance * impulse.normal / (ball_.inertia * ball_.radius);
    const Vec3d rolls = motion_.spin - face.normal * dot(motion_.spin, face.normal);
    const Vec3d torque = within(impulse.torque - rolls, most);
    motion_.spin += component_product(ball_.turns, torque - impulse.torque);
    impulse.torque = torque;
  }
  /// A vector, cut to a length.
  [[nodiscard]] static Vec3d within(const Vec3d& v, double most) {
    const double wanted = length(v);
    return wanted > most ? v * (most / wanted) : v;
  }

  BallMotion motion_;
  const std::array<BallFace, 2>& faces_;
  const Ball& ball_;
  double c_;  // cosine between both normals [-]
  std::array<Impulse, 2> impulses_{};
};

/// Motion of a ball along both of two surfaces for a time.
inline BallWay moved_between(const BallMotion& motion, const Vec3d& a, const std::array<BallFace, 2>& faces,
                             const Ball& ball, double time) {
  return BallBetween(motion, faces, ball).run(a, time);
}

}  // namespace physim
