// A flight as SceneContacts (collide/scene_contact.hpp) wants it: what meets things, and what is kept of it.
#pragma once

#include <algorithm>
#include <vector>

#include "collide/scene_contact.hpp"
#include "flight/under_way.hpp"
#include "math/numbers.hpp"
#include "solve/lane_motion.hpp"
#include "solve/march.hpp"

namespace physim {

/// A way along a surface, between two times since the flight began [s].
struct Slide {
  State<double> from;
  double begin;
  State<double> to;
  double end;
};

/// A step in which a flight may meet things. Times into it are called passed, those since the flight began times.
struct MeetingStep {
  double begins = 0;       // since the flight began [s]
  double scene_time = 0;   // of the scene then [s]
  double length = 0;       // [s]
  double ends = 0;         // since the flight began [s]
  std::uint64_t draw = 0;  // number of the step, for what is left to chance
};

template <class S>
class MeetingLane final : public ContactHost {
 public:
  MeetingLane(const FlightRecord& record, March<S>& march, const Obstacles& obstacles)
      : record_(record), march_(march), from_(obstacles), shown_(obstacles.shown_spin) {}

  void begin(const MeetingStep& step) {
    PHYSIM_ASSERT(step.length >= 0 && step.ends >= step.begins);
    step_ = step;
  }
  [[nodiscard]] const MeetingStep& step() const { return step_; }
  /// The march's clock when the step begins.
  void put_clock(S clock) { clock_ = clock; }

  // ------------------------------------------------------------------------------------------- as SceneContacts asks
  [[nodiscard]] const Scene* scene() const override {
    return from_.contact.collision.layers == 0 ? nullptr : from_.scene;
  }
  [[nodiscard]] Precision precision() const override { return conditions().fidelity.precision; }
  [[nodiscard]] const CollisionDef& collision() const override { return from_.contact.collision; }
  [[nodiscard]] OwnSurface surface() const override { return OwnSurface::of(from_.contact); }
  [[nodiscard]] Vec3d turns() const override { return from_.turns; }
  [[nodiscard]] double scene_time() const override { return step_.scene_time; }
  [[nodiscard]] double step_length() const override { return step_.length; }
  [[nodiscard]] Vec3d spin(double passed) const override {
    return spin_of_lane(conditions(), march_.lanes, clock_, passed).value_or(shown_);
  }
  void put_spin(const Vec3d& spin, double passed) override {
    if (spin == this->spin(passed)) return;
    if (!put_spin_of_lane(conditions(), march_.lanes, clock_, passed, spin)) shown_ = spin;
  }
  [[nodiscard]] Vec3d acceleration_at(const State<double>& s, double passed) const override {
    return acceleration_of_lane(conditions(), march_.lanes, march_.course().body, static_cast<double>(clock_) + passed,
                                s);
  }
  [[nodiscard]] Vec3d kept(const Vec3d& v) const override { return kept_of_lane(conditions(), march_.lanes, v); }
  [[nodiscard]] Impact impact(int hits) const override {
    Impact impact;
    impact.mass = record_.projectile.mass;
    impact.diameter = record_.projectile.diameter;
    impact.length = record_.projectile.length;
    impact.seed = from_.contact.seed;
    impact.projectile = from_.number;
    impact.hit = hit_number(step_.draw, hits);
    return impact;
  }
  /// A contact that continues, of what lies on a surface, is no further hit.
  void tell(EventKind kind, Reason reason, double passed, const State<double>& s, const SceneHit& hit = {},
            double depth = 0, double energy = 0) override {
    constexpr double kAtOnce = 0.05;  // of the longest part
    const double time = time_of(passed);
    const bool goes_on = kind == EventKind::hit && hit.instance == slid_on_ &&
                         time - slid_until_ < kAtOnce * std::min(step_.length, kLongestPart);
    if (kind == EventKind::hit) touched_ = hit.instance;
    if (goes_on) return;
    told.push_back(event_of(kind, reason, s, hit, depth, energy));
    told.back().time = time;
  }
  void slid(const State<double>& from, double begin, const State<double>& to, double end) override {
    PHYSIM_ASSERT(end >= begin);
    slides.push_back({held(from), time_of(begin), held(to), time_of(end)});
    slid_on_ = touched_;
    slid_until_ = time_of(end);
  }

  /// A time into the step as one since the flight began: at the end of a frame, a whole number of frames [s].
  [[nodiscard]] double time_of(double passed) const {
    return passed == step_.length ? step_.ends : step_.begins + passed;
  }

  std::vector<Event> told;    // in order of time
  std::vector<Slide> slides;  // of the contact at hand

 private:
  /// As its numbers hold it.
  [[nodiscard]] static State<double> held(const State<double>& s) {
    return {vec_cast<double>(vec_cast<S>(s.x)), vec_cast<double>(vec_cast<S>(s.v))};
  }
  [[nodiscard]] const Conditions<double>& conditions() const { return record_.cohort.conditions; }

  const FlightRecord& record_;
  March<S>& march_;
  const Obstacles& from_;
  MeetingStep step_;
  S clock_{};
  Vec3d shown_;  // its spin, where the rung flies none [rad/s]
  InstanceId touched_, slid_on_;
  double slid_until_ = 0;
};

}  // namespace physim
