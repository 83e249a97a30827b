// The step of a fixed-step integrator, found by pilot flights.
#include "flight/pilot.hpp"

#include <algorithm>
#include <cmath>

#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "collide/contact_rules.hpp"
#include "flight/flight_record.hpp"
#include "math/elementary.hpp"
#include "model/acceleration.hpp"
#include "physim/names.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"
#include "solve/take_step.hpp"

namespace physim {
namespace {

constexpr double kSmallestStep = 1e-7;  // [s]
constexpr double kMostWork = 1e6;       // steps of all pilot flights of a shot
constexpr double kSurelyTooMuch = 1e9;  // the error of a flight that cannot be compared [m]

/// A flight close to exact, and what it takes to compare others with it.
class Reference {
 public:
  explicit Reference(std::shared_ptr<const FlightRecord> record) : record_(std::move(record)) {
    const auto& nodes = record_->path.nodes;
    PHYSIM_ASSERT(!nodes.empty());
    for (const Node& node : nodes) fastest_ = std::max(fastest_, length(node.y.v));
    const std::size_t stride = 1 + nodes.size() / kMostPieces;
    for (std::size_t i = 0; i + 1 < nodes.size(); i += stride) {
      const double start = nodes[i].t, end = nodes[std::min(i + stride, nodes.size() - 1)].t;
      for (int part = 1; part <= kParts; ++part) {
        const double time = start + (end - start) * part / kParts;
        if (time < duration()) times_.push_back(time), places_.push_back(record_->state(time).x);
      }
    }
  }

  [[nodiscard]] double duration() const { return record_->duration; }

  /// How far another flight of the shot is from it: in place at equal times, and in time where it ends [m].
  [[nodiscard]] double distance_to(const FlightRecord& other) const {
    if (other.outcome != record_->outcome) return kSurelyTooMuch;
    const double common = std::min(duration(), other.duration);
    double largest = std::abs(duration() - other.duration) * fastest_;
    const auto compare_at = [&](double time, const Vec3d& place) {
      const double apart = length(place - other.state(time).x);
      largest = std::isfinite(apart) ? std::max(largest, apart) : kSurelyTooMuch;
    };
    compare_at(common, record_->state(common).x);
    for (std::size_t i = 0; i < times_.size() && times_[i] < common; ++i) compare_at(times_[i], places_[i]);
    return largest;
  }

 private:
  static constexpr std::size_t kMostPieces = 200;
  static constexpr int kParts = 3;

  std::shared_ptr<const FlightRecord> record_;
  std::vector<double> times_;  // closest together where the flight changes fastest
  std::vector<Vec3d> places_;  // then [m]
  double fastest_ = 0;         // [m/s]
};

PHYSIM_COLD Result<Reference> fly_reference(const ProjectileDef& projectile, const Launch& launch,
                                            const Environment& environment, const Fidelity& fidelity,
                                            const Tolerance& tolerance, const Until& until, double error_allowed) {
  Fidelity exact = fidelity;
  exact.integrator = Integrator::dop853;
  exact.precision = Precision::float64;
  Tolerance tight = tolerance;
  tight.relative = tight.absolute = clamp(1e-8 * error_allowed, 1e-13, 1e-9);
  auto record = record_flight(projectile, launch, environment, exact, tight, until);
  if (record->error) return *record->error;
  if (record->outcome == Outcome::step_limit)
    return Error{"the pilot flight took all steps allowed", "tolerance.max_steps", "allow more, or give a step"};
  if (!ended_as_planned(record->outcome))
    return Error{"the pilot flight ended as " + std::string(name(record->outcome)), "launch",
                 "check the figures of projectile and launch, or give a step"};
  return Reference(std::move(record));
}

/// Pilot flights end at their first contact: what is right up to there is right behind it, and bounces part paths.
Until up_to_contact(Until until) {
  if (until.contact.collision.on_hit == OnHit::pass) until.scene = nullptr;
  until.contact.collision.on_hit = OnHit::stop;
  return until;
}

}  // namespace

PHYSIM_COLD Result<PilotStep> step_within(const ProjectileDef& projectile, const Launch& launch,
                                          const Environment& environment, const Fidelity& fidelity,
                                          const Tolerance& tolerance, const Until& asked, double error_allowed,
                                          double longest) {
  PHYSIM_ASSERT(error_allowed > 0 && longest > 0);
  Until until = up_to_contact(asked);
  const auto fly_exact = [&] {
    return fly_reference(projectile, launch, environment, fidelity, tolerance, until, error_allowed);
  };
  auto reference = fly_exact();
  // A flight that begins with a contact does not measure steps: they are measured in a flight through the air.
  const bool goes_on = until.scene && !ends_flights(asked.contact.collision.on_hit);
  constexpr double kLongEnough = 1;  // to measure steps [s]
  if (reference && goes_on && reference->duration() < kLongestPart) {
    until.scene = nullptr;
    until.time = std::min(until.time, kLongEnough);
    reference = fly_exact();
  }
  if (!reference) return reference.error();
  // What ends where it begins takes any step.
  if (reference->duration() == 0) return PilotStep{std::isfinite(longest) ? longest : kFrame, 0};
  const double order = order_of(fidelity.integrator);
  Fidelity coarse = fidelity;
  coarse.precision = Precision::float64;
  const auto error_at = [&](double step) {
    Tolerance fixed = tolerance;
    fixed.step = step;
    return reference->distance_to(*record_flight(projectile, launch, environment, coarse, fixed, until));
  };
  const double shortest =
      std::max(kSmallestStep, reference->duration() / (0.9 * static_cast<double>(tolerance.max_steps)));
  PilotStep nearest{0, kSurelyTooMuch};
  double step = std::max(std::min(reference->duration() / 4, longest), shortest);
  for (double work = 0; work < kMostWork;) {
    // Two steps are tried, so that an error which happens to pass through zero is not taken for a small one.
    const double error = std::max(error_at(step), error_at(0.8 * step));
    if (error < nearest.reached) nearest = {step, error};
    if (error <= error_allowed || step == shortest) break;
    const double factor = 0.95 * pow(error_allowed / error, 1 / order);
    step = std::max(step * std::clamp(factor, 0.1, 0.9), shortest);
    work += 2.25 * reference->duration() / step;  // what the next two flights will take
  }
  if (nearest.reached < kSurelyTooMuch) return nearest;
  return Error{"no step above " + short_text(shortest) + " s flies the shot as it should", "tolerance.step",
               "give a step, allow more steps, or use an adaptive integrator"};
}

// ------------------------------------------------------------------------------------------- frames
namespace {

/// |drag| / |velocity through the air| at a speed along y: the rate at which drag takes velocity away [1/s].
double decay(const Cohort& cohort, const Body<double>& body, const Rotor<double>& rotor, const Vec3d& place,
             double speed) {
  PHYSIM_ASSERT(speed > 0);
  State<double> s{place, {0, -speed, 0}};
  s.v += s.v - air_velocity(cohort.conditions, body, 0.0, s);
  return length(accelerations_of(cohort.conditions, body, rotor, 0, s, rotor.launch).drag) / speed;
}

}  // namespace

bool steps_by_frames(const Fidelity& granted) { return !steps_itself(granted) && order_of(granted.integrator) == 1; }

double frame_step(const Cohort& cohort, const Body<double>& body, const Rotor<double>& rotor, const Until& until) {
  const Conditions<double>& c = cohort.conditions;
  const auto decay_at = [&](const Vec3d& place, double speed) { return decay(cohort, body, rotor, place, speed); };
  const State<double>& launch = body.launch;
  const double speed = length(air_velocity(c, body, 0.0, launch));
  const double at_launch = speed > 0 ? decay_at(launch.x, speed) : 0;
  // In a fall's terminal speed v drag is the weight, a decay of g / v; with drag k v^2, sqrt(g k).
  const double probe = 10;
  const Vec3d lowest{launch.x.x, until.ground ? std::min(launch.x.y, *until.ground) : launch.x.y, launch.x.z};
  const double in_fall = sqrt(length(weight_per_mass(c, body, lowest)) * decay_at(lowest, probe) / probe);
  // The original loop feels the forces of the frame before, and oscillates sooner.
  const double part = is_classic(c.fidelity) ? 0.25 : 0.5;
  const double step = part / std::max({at_launch, in_fall, 1.0});
  return std::min(kFrame, std::max(kSmallestStep, step));
}

FidelityNote note_of_step(const PilotStep& found, double error_allowed) {
  return {"tolerance.position_error", short_text(error_allowed), short_text(found.reached),
          "steps of " + short_text(found.step) +
              " s come no nearer within tolerance.max_steps; allow a larger error, "
              "or use an adaptive integrator"};
}

Result<double> pilot_step(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                          const Fidelity& fidelity, const Tolerance& tolerance, const Until& until) {
  const IeeeMode mode;
  if (const Status status = check(tolerance, fidelity); !status) return status.error();
  const Fidelity granted = grant(fidelity, projectile, environment).fidelity;
  const auto found = step_within(projectile, launch, environment, granted, tolerance, until, tolerance.position_error);
  if (!found) return found.error();
  if (found->reached <= tolerance.position_error) return found->step;
  const FidelityNote note = note_of_step(*found, tolerance.position_error);
  return Error{"a position error of " + note.asked + " m cannot be kept, " + note.granted + " m were reached",
               note.effect, note.reason};
}

std::optional<double> step_given(const Fidelity& granted, const Tolerance& tolerance) {
  if (steps_itself(granted)) return 0.0;
  if (tolerance.step > 0) return tolerance.step;
  return std::nullopt;
}

}  // namespace physim
