// Neighbours: the paths near a flown one, computed from it without flying again.
//
// A launch velocity that differs by c gives a path X(t) + d(t) with
//   d'' = m(X + d, V + d') - m(X, V),  d(0) = 0,  d'(0) = c,
// where X, V is the flown path, taken from its dense output, and m a simple model of what changes from path to path:
// drag k(|u|) u along the air velocity u, its rate k [1/s] read from the flown path itself and scaled with the density
// of the air, and the pull of a round Earth. What m leaves out (lift, spin, thrust, the turn of the Earth) is in X
// already, and its change from path to path is small. So neighbours are exact at c = 0 and nearly so around it; three
// more paths next to X + d give the sensitivity of places to the launch velocity. After a second flight the error that
// the model made in foretelling it, e(t) for a change c, corrects the neighbours in that direction: d + e (c . change)
// / c^2, as Broyden's method does (C. G. Broyden, "A class of methods for solving nonlinear simultaneous equations",
// Mathematics of Computation 19 (1965) 577-593), but at all times at once.
#pragma once

#include <span>
#include <vector>

#include "model/body.hpp"
#include "physim/solve.hpp"

namespace physim {

class Neighbours {
 public:
  /// `conditions` are those of the flight; its air and its wind are read. The caller keeps them as long as this.
  Neighbours(const Flight& flight, const Environment& environment, const Conditions<double>& conditions);

  /// Takes over what a flight before this one, flown a little differently, shows of the error of the model: the
  /// distance between what its neighbours were and what was flown then. Call before the first move.
  void learn_from(Neighbours& before);

  /// Moves on to the neighbour with a launch velocity that differs from the flown one by a change [m/s].
  void move_to(const Vec3d& change);
  /// The launch velocity of the neighbour [m/s].
  [[nodiscard]] Vec3d launch_velocity() const { return launch_velocity_ + change_; }
  [[nodiscard]] const Vec3d& flown_velocity() const { return launch_velocity_; }

  /// Times between which the neighbour was computed, from 0 to the end of the flight [s].
  [[nodiscard]] std::span<const double> times() const { return times_; }
  /// The launch velocity with which a neighbour would be at a place at a time [m/s].
  [[nodiscard]] Vec3d required_velocity(const Vec3d& place, double time) const;

 private:
  struct Offset {
    Vec3d x, v;
  };
  /// The path next to the flown one, and those that start a little faster along x, y and z.
  struct Node {
    Offset path[4];
  };
  struct Known {
    double time;
    Vec3d x, v;
  };

  void learn_drag(const Flight& flight, std::span<const double> times);
  [[nodiscard]] Vec3d wind_at(double time, const Vec3d& x) const;
  void spread_rate(double speed0, double rate0, double speed1, double rate1);
  [[nodiscard]] double drag_rate(double speed) const;
  [[nodiscard]] Vec3d pull(double time, const Vec3d& x, const Vec3d& v) const;
  [[nodiscard]] Node rates(const Known& known, const Node& node) const;
  [[nodiscard]] Node stepped(const Node& from, const Known& k0, const Known& k1, const Known& k2, double h) const;
  [[nodiscard]] Node between(double time) const;
  [[nodiscard]] Vec3d error_at(double time) const;

  Flight flight_;
  const Conditions<double>* conditions_;
  Body<double> launched_{};  // what wind reads of a body: launched at time 0
  Vec3d launch_velocity_, change_;
  bool wind_varies_ = false;
  Vec3d wind_;             // where it does not vary [m/s]
  Vec3d plane_;            // normal of the plane that a planar flight is confined to; 0: none
  double per_height_ = 0;  // decay of the air's density with height [1/m]
  double radius_ = 0;      // of a round Earth, 0: flat [m]
  double gravity_ = 0;     // at its surface [m/s^2]
  double most_speed_ = 1;
  std::vector<double> rate_;  // of drag, at even speeds from 0 to most_speed_ [1/s]
  std::vector<double> times_;
  std::vector<Known> known_;  // at the times and half way between them
  Vec3d changes_[4];          // of launch velocity, of the paths of a node
  std::vector<Node> nodes_;   // at the times
  std::vector<Vec3d> error_;  // of the model at the times, for the change error_of_
  Vec3d error_of_;
};

}  // namespace physim
