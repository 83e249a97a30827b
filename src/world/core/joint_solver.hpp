// What joints do to the ends of a step that was flown without them.
//
// A net of rods, cables, springs and planes holds bodies. Each flew its step as if alone, from `start` to x and v. What
// the net did meanwhile is found at once for all of its rows, by RATTLE (Andersen 1983, J. Comput. Phys. 52, 24-34;
// Hairer, Lubich & Wanner 2006, Geometric Numerical Integration, VII.1.3): an impulse q/h along each row's direction
// n0 at the start of the step moves its ends apart by w n0 q (w: one over their masses) and changes their velocities by
// w n0 q/h, so that lengths are kept; then impulses along the directions n1 at its end take away the speed at which
// rods would become longer or shorter. So free bodies that a net joins keep their momentum and their angular momentum,
// and in a uniform field energy only swings by terms in h^2.
//
//   rods             l(q) = l0                              the distance at the start of the step
//   taut cables      l(q) <= l0, q <= 0, one of them equal  (a linear complementarity problem)
//   planes           l(q) >= l,  q >= 0, one of them equal
//   guides           l(q) = l                               a direction that is given, and may turn
//   springs          q = -(h^2/2) F,  F = k ((l0 + l(q))/2 - L) + c (l(q) - l0)/h    (any k, any h)
//
// A spring's impulse, 2 q/h, goes along (r0 + r1)/(l0 + l1), r from one end to the other: its work is what the spring
// gives, to rounding, and it turns nothing (a discrete gradient: Gonzalez 1996, J. Nonlinear Sci. 6, 449-467).
//
// A body bounces where its net brings it to a plane, with its speed there: the step is taken in parts, up to that
// moment and from there.
//
// A cable that was slack when the step began and is too long at its end came taut: the step is taken in parts, up to
// that moment and from there (world/couple/joint_parts.cpp). There the speed at which its ends part is turned around by
// its restitution. What is wrong with lengths before a step (rounding, or ends that a call has put elsewhere) is put
// right by moves that give no speed.
//
// What nothing moves may move: a fixed end that goes on its way, and directions that turn. Their velocities stand in
// the equations of speeds, and what they do work on gains that energy.
//
// The steps of Newton's method are solved directly (J1 M^-1 J0^T, factored within its envelope, rows of a net in the
// order in which a breadth-first search finds them: Cuthill & McKee 1969), so a long chain costs as much as its rows
// are many and is as stiff as a short one. Which cables pull follows from block pivoting (Judice & Pires 1994,
// Computers Ops Res. 21, 587-596); its last resort is Murty's rule. Rows that others imply already take no part.
//
// A light body between rods that hold a heavy one swings across them fast: such steps are taken in parts that are short
// beside that (1000 kg on ten links of a gram: some hundreds of parts of 1/60 s). A net with springs that is not solved
// in one step, or that turns a spring by a quarter of a turn or more, is taken in parts that are short beside the swing
// of its springs.
//
// Error: of order h^2 in place and time over a fixed span. Wrong: where a net of rods turns by a quarter of a turn or
// more within a step. Then, where the rounds do not suffice, and where the net would gain more than a fiftieth of the
// energy of its motion in a step, lengths are put right without a speed: springs do not act in that step or part, and
// the energy that the net gains by that is taken from the motion about its centre of mass.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "physim/math.hpp"

namespace physim {

/// A body that rows end at, or a fixed point.
struct NetBody {
  Vec3d start{};                        // where it was when the step began [m]
  Vec3d start_velocity{};               // [m/s]
  Vec3d x{};                            // place after its flight alone; then the held place [m]
  Vec3d v{};                            // velocity after its flight alone; then the held velocity [m/s]
  Vec3d mobility{};                     // one over its mass, along each axis; 0: nothing moves it [1/kg]
  double spacing = 0;                   // of the numbers that keep its place [m]
  bool is_carried = false;              // a point that goes on its way, whatever it holds
  std::optional<Vec3d> acceleration{};  // of a flight alone that bounces, between its bounces [m/s^2]
};

/// A plane at rest that a body bounces off: one of its flight alone, or one that only its net brings it to.
struct NetBounce {
  std::uint32_t body = 0;
  Vec3d place{};           // of the body where it touches the plane [m]
  Vec3d normal{};          // towards the body [-]
  double restitution = 0;  // [-]
  double speed = 1;        // with which it came along the normal in its flight alone [m/s]
  Vec3d across{};          // by which its velocity changed across the normal then [m/s]
  double rubbed = 0;       // of a ball: what that took of the square of its velocity, its spin may have [m2/s2]
  bool is_over = false;    // it has met it in the step at hand
};

/// What holds two bodies.
struct NetRow {
  bool pulls = true;        // it keeps its ends from being farther apart than its length
  bool pushes = true;       // ... and from being nearer; one that does neither is a spring
  bool has_normal = false;  // of a plane or a guide: its direction is given
  std::uint32_t a = 0;      // bodies
  std::uint32_t b = 0;
  double length = 0;       // [m]
  double restitution = 0;  // of cables [-]
  double stiffness = 0;    // of springs [N/m]
  double damping = 0;      // of springs [kg/s]
  Vec3d start_normal{};    // of planes, that a is outside of, and guides, when the step begins [-]
  Vec3d normal{};          // ... at its end: dot(normal, a - b) >= length, of guides = length [-]
  Vec3d normal_rate{};     // at which it changes then [1/s]

  [[nodiscard]] bool is_rod() const { return pulls && pushes; }
  [[nodiscard]] bool is_cable() const { return pulls && !pushes; }
  [[nodiscard]] bool is_spring() const { return !pulls && !pushes; }
  [[nodiscard]] bool only_pushes() const { return pushes && !pulls; }

  // What was found.
  double impulse = 0;      // with which it pulled its ends together [N s]
  double speed = 0;        // at which they parted when it came taut [m/s]
  bool came_taut = false;  // in this step
  void forget() { impulse = speed = 0, came_taut = false; }
};

struct NetReport {
  std::uint32_t rounds = 0;
  double residual = 0;  // the farthest that a row is from what it keeps [m]
  bool solved = true;
  bool is_rough = false;  // not solved, or a spring turned by a quarter of a turn or more
};

/// What a part of a step is.
struct NetPart {
  double h;                // its length [s]
  double step;             // length of the whole step [s]
  bool comes_taut = true;  // false: cables that are slack stay so, however long they become
};

/// What the searches of a net may cost in a step, in multiplications: rows that contradict each other are searched long
/// and in vain, and no step may take long. Where it is spent, lengths are put right without a speed, as where the
/// rounds do not suffice, the rest of the step is one part, and no row comes taut within it.
class NetEffort {
 public:
  explicit NetEffort(std::size_t rows) : left_(kBase + kEachRow * static_cast<double>(rows)) {}

  [[nodiscard]] bool suffices(double work) const { return work < left_; }
  [[nodiscard]] bool is_spent() const { return !suffices(0); }
  /// What a part took; if it was solved, a quarter of it counts.
  void take(double work, bool solved) { left_ -= solved ? work * kSolved : work; }

 private:
  static constexpr double kBase = 8e6;
  static constexpr double kEachRow = 1e4;
  static constexpr double kSolved = 1.0 / 4;  // [-]

  double left_;
};

/// Holds the bodies of one net at the end of a part of a step. Rows are in an order in which neighbours are near.
NetReport hold_part(std::span<NetBody> bodies, std::span<NetRow> rows, const NetPart& part, NetEffort& effort);
/// Holds them at the end of a step of h [s], which is cut where cables come taut, and where it is too long for the net
/// (world/couple/joint_parts.cpp), and where bodies bounce.
NetReport hold_net(std::span<NetBody> bodies, std::span<NetRow> rows, std::span<NetBounce> bounces, double h,
                   NetEffort& effort);

}  // namespace physim
