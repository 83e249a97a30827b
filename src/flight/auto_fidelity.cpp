// cheapest_within(): flies the truth, then the truth with one rung lowered at a time, then candidates from cheap to
// dear, until one stays within the error.
//
// A candidate is left out unflown where one of its rungs, lowered alone, is off by more than the error: errors that
// cancel are luck, not accuracy. What is left out at an error is left out at every smaller one, and costs do not depend
// on the error, so a smaller error never gets a cheaper answer.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/fidelity_candidates.hpp"
#include "flight/flight_record.hpp"
#include "flight/step_budget.hpp"
#include "model/ladder.hpp"
#include "physim/names.hpp"
#include "prepare/check.hpp"
#include "prepare/fidelity_cost.hpp"

namespace physim {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();
constexpr double kTruthTolerance = 1e-13, kDoubtTolerance = 1e-12;  // of the truth, and of the flight that doubts it
constexpr int kSamples = 499;             // of a flight; a prime, so that times are not round and show their rounding
constexpr int kLateSamples = 16;          // of a flight that lands after the true one
constexpr double kLate = 1.5;             // times the true flight: a longer flight is wrong
constexpr double kMostSteps = 1e6;        // of a flight
constexpr double kClosedFormAnswers = 8;  // taken from a closed form where steps are free

std::string work_text() { return std::to_string(kMostSearchSteps / 1'000'000) + " million steps"; }

/// A true flight. One that has landed stays where it landed.
struct TruePath {
  Launch launch;
  bool landed = false;
  double duration = 0;
  std::vector<Vec3d> position;  // kSamples + 1, from launch to end
};

/// What a flight was found to be.
struct Measured {
  double error = 0;  // [m]
  double steps = 0;  // tried, in all flights
};

double sample_time(const TruePath& path, int i) { return path.duration * i / kSamples; }

Status check_purpose(const Purpose& p) {
  Checker c;
  c.positive(p.error, "purpose.error", "in m, such as 0.01");
  c.positive(p.time, "purpose.time", "in s, the time of flight");
  c.not_negative(p.step, "purpose.step", "in s, such as 1/60; 0: steps are free");
  c.require(!(p.step > 0 && p.time / p.step > kMostSteps), "purpose.step",
            "must be at least a millionth of the time, not " + short_text(p.step), "0: steps are free");
  if (p.ground && !std::isfinite(*p.ground))
    c.require(false, "purpose.ground", "must be a finite number, not " + short_text(*p.ground), "none: no ground");
  if (!c.status_so_far()) return c.status();
  if (level(p.least_motion) > level(p.truth.motion))
    return Error{"is more than the truth has, '" + std::string(name(p.truth.motion)) + "'", "purpose.least_motion",
                 "raise purpose.truth.motion"};
  return check(p.tolerance, p.truth);
}

/// With which fly() steps as a purpose says.
Tolerance tolerance_for(const Purpose& purpose, double step) {
  PHYSIM_ASSERT(step >= 0);
  Tolerance t = purpose.tolerance;
  t.step = step;
  if (purpose.step > 0) t.max_step = std::min(t.max_step, purpose.step);
  t.max_steps = std::max(t.max_steps, static_cast<std::int64_t>(4 * kMostSteps));
  return t;
}

class Search {
 public:
  Search(const ProjectileDef& projectile, std::span<const Launch> launches, const Environment& environment,
         const Purpose& purpose)
      : projectile_(projectile),
        launches_(launches),
        environment_(environment),
        purpose_(purpose),
        ladder_(projectile, environment, purpose) {
    answer_.purpose = purpose;
  }

  Result<AutoFidelity> run() {
    for (const Launch& launch : launches_)
      if (Status status = fly_truth(launch); !status) return status.error();
    if (total_time_ == 0)
      return Error{"the flight ends where it begins", "launch", "launch it above purpose.ground, or upwards"};
    if (purpose_.error <= 2 * answer_.truth_error) return too_small();
    const Measured of_truth = measure(ladder_.truth(), tolerance_for(purpose_, 0));
    if (is_used_up()) return takes_too_long();
    truth_steps_ = of_truth.steps;
    answer_.error = of_truth.error;
    answer_.truth_cost = cost(ladder_.truth(), truth_steps_);
    for (const Lowered& lowered : ladder_.lowered()) lower_models(lowered);
    for (const Stepper& stepper : ladder_.steppers(answer_.time)) {
      steppers_.push_back({stepper, std::nullopt});
      if (is_adaptive(stepper.integrator)) lower_stepper(steppers_.size() - 1);  // counts the steps it takes
    }
    return choose();
  }

 private:
  struct LoweredTrial {
    Lowered lowered;
    double error;
  };
  struct StepperTrial {
    Stepper stepper;
    std::optional<Measured> measured;  // none: not flown yet
  };
  struct Candidate {
    Fidelity fidelity;
    std::size_t stepper;
    double cost;
  };

  [[nodiscard]] Until until(double time) const { return {.ground = purpose_.ground, .time = time}; }

  /// The true flight of a launch, and by how much a second one at a looser tolerance doubts it.
  Status fly_truth(const Launch& launch) {
    Tolerance tight{.relative = kTruthTolerance, .absolute = kTruthTolerance};
    tight.max_steps = work_left_;
    const Flight flight = fly(projectile_, launch, environment_, ladder_.truth(), tight, until(purpose_.time));
    if (flight.error()) return *flight.error();
    use_up(flight);
    if (is_used_up()) return takes_too_long();
    const Outcome outcome = flight.outcome();
    if (outcome != Outcome::landed && outcome != Outcome::time_limit && outcome != Outcome::left_domain)
      return Error{"the true flight ended as " + std::string(name(outcome)), "launch",
                   "check the figures of projectile and launch"};
    TruePath path{launch, outcome == Outcome::landed, flight.duration(), {}};
    double farthest = 0;
    for (int i = 0; i <= kSamples; ++i) {
      path.position.push_back(flight.at(sample_time(path, i)).position);
      farthest = std::max(farthest, length(path.position.back()));
    }
    tight.relative = tight.absolute = kDoubtTolerance;
    const double doubt = measure(path, ladder_.truth(), tight).error + 8 * kRounding * farthest;
    answer_.truth_error = std::max(answer_.truth_error, doubt);
    answer_.time = std::max(answer_.time, path.duration);
    total_time_ += path.duration;
    paths_.push_back(std::move(path));
    return {};
  }

  [[nodiscard]] Measured measure(const TruePath& path, const Fidelity& fidelity, Tolerance tolerance) {
    PHYSIM_ASSERT(path.position.size() == kSamples + 1);
    if (path.duration == 0) return {};
    if (is_used_up()) return {kInfinity, 0};
    const double end = path.landed ? kLate * path.duration : path.duration;
    tolerance.max_steps = std::min(tolerance.max_steps, work_left_);
    const Flight flight = fly(projectile_, path.launch, environment_, fidelity, tolerance, until(end));
    use_up(flight);
    if (flight.error() || !(ended_as_planned(flight.outcome()) || flight.outcome() == Outcome::left_domain))
      return {kInfinity, 0};
    Measured m{0, static_cast<double>(flight.cost().steps + flight.cost().rejected)};
    const auto compare = [&](double time, const Vec3d& truth) {
      const double miss = length(flight.at(time).position - truth);
      m.error = miss <= m.error ? m.error : miss == miss ? miss : kInfinity;
    };
    for (int i = 0; i <= kSamples; ++i) compare(sample_time(path, i), path.position[static_cast<std::size_t>(i)]);
    const double late = flight.duration() - path.duration;
    for (int i = 1; late > 0 && i <= kLateSamples; ++i)
      compare(path.duration + late * i / kLateSamples, path.position.back());
    return m;
  }

  void use_up(const Flight& flight) {
    if (!flight.error()) work_left_ -= flight.cost().steps + flight.cost().rejected;
  }
  [[nodiscard]] bool is_used_up() const { return work_left_ <= 0; }

  /// The worst error and all steps of all launches.
  [[nodiscard]] Measured measure(const Fidelity& fidelity, const Tolerance& tolerance) {
    Measured all;
    for (const TruePath& path : paths_) {
      const Measured m = measure(path, fidelity, tolerance);
      all.error = std::max(all.error, m.error);
      all.steps += m.steps;
    }
    return all;
  }

  [[nodiscard]] bool keeps(double error) const { return error + answer_.truth_error <= purpose_.error; }
  [[nodiscard]] double cost(const Fidelity& fidelity, double steps) const {
    PHYSIM_ASSERT(total_time_ > 0 && steps >= 0);
    return step_cost(fidelity, projectile_, environment_) * steps / total_time_;
  }
  void note_trial(const Fidelity& fidelity, double step, double error, double cost, std::string lowered) {
    answer_.trials.push_back({fidelity, step, error, cost, std::move(lowered), keeps(error)});
  }

  /// With tight steps, so that the error is that of the models alone.
  void lower_models(const Lowered& lowered) {
    const Measured m = measure(lowered.fidelity, {.relative = kDoubtTolerance, .absolute = kDoubtTolerance});
    lowered_.push_back({lowered, m.error});
    note_trial(lowered.fidelity, 0, m.error, cost(lowered.fidelity, truth_steps_), lowered.effect);
  }

  /// The truth's models, stepped in this way. Motions step alike, so one trial serves them all.
  void lower_stepper(std::size_t index) {
    PHYSIM_ASSERT(index < steppers_.size());
    StepperTrial& trial = steppers_[index];
    Stepper stepper = trial.stepper;
    stepper.motion = purpose_.truth.motion;
    const auto fidelity = ladder_.combine(ladder_.truth(), stepper);
    for (const StepperTrial& other : steppers_) {
      const Stepper& s = other.stepper;
      const bool alike =
          s.integrator == stepper.integrator && s.precision == stepper.precision && s.step == stepper.step;
      if (alike && s.motion != Motion::closed_form && other.measured) trial.measured = other.measured;
    }
    if (trial.measured) return;
    trial.measured = fidelity ? measure(*fidelity, tolerance_for(purpose_, stepper.step)) : Measured{0, 0};
    if (fidelity)
      note_trial(*fidelity, stepper.step, trial.measured->error, cost(*fidelity, steps_of(trial)), "integrator");
  }

  /// Steps of all flights. A candidate is taken to need as many as the truth's models do, so that what it costs is
  /// known before it flies.
  [[nodiscard]] double steps_of(const StepperTrial& trial) const {
    const Stepper& s = trial.stepper;
    if (s.motion == Motion::closed_form && purpose_.step == 0)
      return kClosedFormAnswers * static_cast<double>(paths_.size());
    if (s.motion == Motion::closed_form) return total_time_ / purpose_.step;
    PHYSIM_ASSERT(s.step > 0 || trial.measured);
    return s.step > 0 ? total_time_ / s.step : trial.measured->steps;
  }

  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::vector<Candidate> list;
    for (const Fidelity& models : ladder_.models()) {
      const bool hopeless = std::any_of(lowered_.begin(), lowered_.end(), [&](const LoweredTrial& trial) {
        return !keeps(trial.error) && ladder_.shares(models, trial.lowered);
      });
      if (hopeless) continue;
      for (std::size_t i = 0; i < steppers_.size(); ++i)
        if (const auto fidelity = ladder_.combine(models, steppers_[i].stepper))
          list.push_back({*fidelity, i, cost(*fidelity, steps_of(steppers_[i]))});
    }
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
    return list;
  }

  Result<AutoFidelity> choose() {
    for (const Candidate& candidate : candidates()) {
      if (is_used_up()) return grant_truth();
      const std::size_t index = candidate.stepper;
      const Stepper stepper = steppers_[index].stepper;
      if (stepper.motion != Motion::closed_form) {  // which has no error
        if (!steppers_[index].measured) lower_stepper(index);
        if (!keeps(steppers_[index].measured->error)) continue;
      }
      const Measured m = measure(candidate.fidelity, tolerance_for(purpose_, stepper.step));
      note_trial(candidate.fidelity, stepper.step, m.error, candidate.cost, "");
      if (!keeps(m.error)) continue;
      PHYSIM_ASSERT(m.error <= purpose_.error);
      answer_.fidelity = candidate.fidelity;
      answer_.step = stepper.step;
      answer_.error = m.error;
      answer_.cost = candidate.cost;
      return std::move(answer_);
    }
    return is_used_up() ? grant_truth() : none_comes_so_near();
  }

  /// Where the search ends before it has found something cheaper.
  Result<AutoFidelity> grant_truth() {
    if (!keeps(answer_.error)) return none_comes_so_near();
    answer_.fidelity = ladder_.truth();
    answer_.step = 0;
    answer_.cost = answer_.truth_cost;
    answer_.ended_early = true;
    return std::move(answer_);
  }

  [[nodiscard]] Error too_small() const {
    return Error{"the truth itself is known to " + length_text(answer_.truth_error) + " only", "purpose.error",
                 "ask for at least " + length_text(4 * answer_.truth_error)};
  }
  [[nodiscard]] static Error takes_too_long() {
    return Error{"the true flight takes more than " + work_text(), "purpose.time",
                 "shorten it, or look at mass, diameter and drag: is it so light?"};
  }
  [[nodiscard]] Error none_comes_so_near() const {
    double nearest = kInfinity;
    for (const FidelityTrial& trial : answer_.trials)
      if (trial.lowered.empty() || trial.lowered == "integrator") nearest = std::min(nearest, trial.error);
    return Error{"no fidelity comes within " + length_text(purpose_.error) + " of the truth", "purpose.error",
                 "the nearest is " + length_text(nearest) + " off; allow more, or tighten purpose.tolerance"};
  }

  const ProjectileDef& projectile_;
  std::span<const Launch> launches_;
  const Environment& environment_;
  const Purpose& purpose_;
  FidelityLadder ladder_;
  std::vector<TruePath> paths_;
  double total_time_ = 0;
  double truth_steps_ = 0;
  std::int64_t work_left_ = kMostSearchSteps;  // steps
  std::vector<LoweredTrial> lowered_;
  std::vector<StepperTrial> steppers_;
  AutoFidelity answer_;
};

}  // namespace

Result<AutoFidelity> cheapest_within(const ProjectileDef& projectile, std::span<const Launch> launches,
                                     const Environment& environment, const Purpose& purpose) {
  const IeeeMode mode;
  if (launches.empty()) return Error{"there is no launch", "launches", "give at least one"};
  for (const Status& status : {check_purpose(purpose), check(projectile), check(environment)})
    if (!status) return status.error();
  return Search(projectile, launches, environment, purpose).run();
}

Result<AutoFidelity> cheapest_within(const ProjectileDef& projectile, const Launch& launch,
                                     const Environment& environment, const Purpose& purpose) {
  return cheapest_within(projectile, std::span(&launch, 1), environment, purpose);
}

Tolerance AutoFidelity::tolerance() const {
  const IeeeMode mode;
  return tolerance_for(purpose, step);
}

std::string AutoFidelity::explanation() const {
  const IeeeMode mode;
  const std::string promise = "within " + length_text(purpose.error) + " over " + rounded_text(time) + " s";
  const std::string found = ": measured " + length_text(error);
  if (ended_early) return "the reference itself, " + promise + found + ": the search took all its " + work_text();
  if (cost >= truth_cost) return "nothing cheaper than the reference stays " + promise + found;
  return "the cheapest " + promise + found + ", " + rounded_text(truth_cost / cost) +
         " times cheaper than the reference";
}

FidelityNote AutoFidelity::note() const {
  const Fidelity& f = fidelity;
  std::string granted(f.motion == Motion::closed_form ? name(f.motion) : name(f.integrator));
  if (step > 0) granted += " at " + rounded_text(step) + " s";
  granted += ", drag " + std::string(name(f.drag));
  return {"fidelity", "cheapest_within " + length_text(purpose.error), granted, explanation()};
}

Flight fly_chosen(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                  const AutoFidelity& chosen, const Until& until) {
  const IeeeMode mode;
  auto record = record_flight(projectile, launch, environment, chosen.fidelity, chosen.tolerance(), until);
  record->cohort.in_use.notes.push_back(chosen.note());
  return Flight(record);
}

Flight fly_within(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                  const Purpose& purpose, const Until& until) {
  const IeeeMode mode;
  const auto chosen = cheapest_within(projectile, launch, environment, purpose);
  if (chosen) return fly_chosen(projectile, launch, environment, *chosen, until);
  auto refused = std::make_shared<FlightRecord>();
  refused->error = chosen.error();
  return Flight(refused);
}

}  // namespace physim
