// FlightRecord: a computed trajectory with everything needed to answer questions about it.
#pragma once

#include "base/near_list.hpp"
#include "flight/known_step.hpp"
#include "model/attitude.hpp"
#include "model/sight.hpp"
#include "model/spin_drift.hpp"
#include "prepare/cohort.hpp"

namespace physim {

/// The dense output of a whole flight.
struct TurnPath {
  std::vector<TurnNode> nodes;
  std::vector<Turn<double>> coefficients;
};
/// How many nodes flights of small arms at a millimetre have, and some more.
inline constexpr std::size_t kNearNodes = 17;
using NodeList = NearList<Node, kNearNodes>;

struct FlownPath {
  NearRoom<Node, kNearNodes> room;                 // of the first nodes
  NodeList nodes{NodeList::allocator_type(room)};  // at both ends of every step; the last may lie beyond the end
  std::vector<State<double>> coefficients;         // of the interpolants, step by step
  std::vector<KeptStep> kept;                      // in their place, where they are made when they are asked for
  std::optional<TurnPath> turn;                    // where the rotation is flown
  std::vector<Vec3d> pushes;                       // by generators at the nodes; empty: none pushes [m/s^2]
};

/// What is flown from one contact to the next, or along a surface. Its last node may lie beyond its end.
struct FlightLeg {
  std::size_t first_node = 0;
  double begins = 0;        // since the flight began [s]
  double clock = 0;         // what closed forms count their time from: the leg's clock + time [s]
  std::size_t body = 0;     // in FlightRecord::bodies
  bool on_surface = false;  // straight on between its two nodes
};

struct FlightRecord {
  /// Its numbers are not set to zero first: they are many, and those that are read are prepared.
  FlightRecord() { rotor.launch = {}; }                                                         // NOLINT
  explicit FlightRecord(const ProjectileDef& flies) : projectile(flies) { rotor.launch = {}; }  // NOLINT

  Outcome outcome = Outcome::refused;
  std::optional<Error> error;
  ProjectileDef projectile;
  Environment environment;  // what keep() takes of it
  Cohort cohort;
  Body<double> body;
  Rotor<double> rotor;  // of rungs that turn; else its launch alone is set
  SightFrame sight;
  SpinDrift drift;
  double elevation = 0;
  double step = 0;
  double duration = 0;
  bool has_own_force = false;  // beside what pushes it: ProjectileDef::force, or others of its cohort have one
  double clock = 0;            // time since launch, as the models count it, where the record begins [s]
  bool is_framed = false;      // by frames of a world: closed forms are read at nodes, on a clock rounded as theirs
  FlownPath path;
  std::vector<FlightLeg> legs;       // none: one, from the launch on
  std::vector<Body<double>> bodies;  // of the legs
  std::vector<Event> events;
  FlightCost cost;

  /// Where it was flown: what EarthFrames need of it, and the functions that its conditions point to.
  void keep(const Environment& where) {
    environment.altitude = where.altitude;
    environment.gravity = where.gravity;
    environment.earth = where.earth;
    environment.wind.field = where.wind.field;
    environment.force = where.force;
  }

  /// The leg that a time lies in, and its nodes.
  struct LegPart {
    FlightLeg leg;
    std::size_t number;
    std::size_t end_node;
    double end;  // [s]
  };
  [[nodiscard]] LegPart leg(std::size_t number) const;
  [[nodiscard]] LegPart leg_at(double time) const;
  [[nodiscard]] const Body<double>& body_of(const LegPart& part) const {
    return bodies.empty() ? body : bodies[part.leg.body];
  }
  /// Times of the nodes, within their legs and the flight [s].
  [[nodiscard]] std::vector<double> node_times() const;
  /// From the first contact on the drift is in the path itself.
  [[nodiscard]] const SpinDrift& drift_at(double time) const;

  /// State on the flown path, without spin drift, 0 <= time <= duration.
  [[nodiscard]] State<double> state(double time) const;
  /// All zero where the rotation is not flown.
  [[nodiscard]] Turn<double> turn(double time) const;
  /// By the models. The total of the classic loop is its register: the sum where the frame before began.
  [[nodiscard]] Accelerations accelerations_at(double time) const;
  /// ... where body and state of that time are known.
  [[nodiscard]] Accelerations accelerations_of_body(double time, const Body<double>& at, const State<double>& s) const;
  /// The body at a time: that of its leg, or, when its motor and its rail have changed it or something pushes it, a
  /// copy in `changed`.
  [[nodiscard]] const Body<double>& body_at(double time, Body<double>& changed) const;
  /// With spin drift.
  [[nodiscard]] State<double> shown(double time) const;
};

/// fly(), its record still open to additions.
[[nodiscard]] std::shared_ptr<FlightRecord> record_flight(const ProjectileDef& projectile, const Launch& launch,
                                                          const Environment& environment, const Fidelity& fidelity,
                                                          const Tolerance& tolerance, const Until& until);

/// Adds spin drift to a state of the flown path.
[[nodiscard]] State<double> with_drift(const State<double>& s, const SpinDrift& drift, const Vec3d& right, double time);

}  // namespace physim
