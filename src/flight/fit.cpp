// fit_drag(): drag and muzzle speed from measurements.
//
// The unknowns are p = (ln s, v / v0 - 1): scale of the drag, muzzle speed. Least squares of the residuals over their
// errors by the method of Gauss and Newton, the derivatives by differences; a step that makes things worse is halved.
// Standard errors: the diagonal of S (J^T J)^-1 with S = sum of squares / (figures - unknowns).
// Source: P. R. Bevington, D. K. Robinson, Data Reduction and Error Analysis for the Physical Sciences (3rd ed., 2003),
// ch. 8.
#include "physim/solve.hpp"

#include <algorithm>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/step_budget.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "prepare/check.hpp"

namespace physim {
namespace {

constexpr double kMostScale = 1000;  // and least: its inverse

struct Unknowns {
  double log_scale = 0;
  double speed = 0;  // relative to the given one, less 1
};

/// What may be measured at a range.
struct Figure {
  const char* name;
  std::optional<double> Measurement::*measured;
  double Sample::*computed;
  double FitOptions::*error;
};
constexpr Figure kFigures[] = {{"speed", &Measurement::speed, &Sample::speed, &FitOptions::speed_error},
                               {"drop", &Measurement::drop, &Sample::drop, &FitOptions::drop_error},
                               {"time", &Measurement::time, &Sample::time, &FitOptions::time_error}};

ProjectileDef scaled(const ProjectileDef& projectile, double scale) {
  PHYSIM_ASSERT(scale > 0);
  ProjectileDef p = projectile;
  DragDef& d = p.drag;
  d.ballistic_coefficient /= scale;
  for (BallisticBand& band : d.bands) band.ballistic_coefficient /= scale;
  if (d.ballistic_coefficient == 0 && d.bands.empty()) d.form_factor *= scale;
  d.k1 *= scale;
  d.k2 *= scale;
  if (d.damping < 1) d.damping = pow(d.damping, scale);
  return p;
}

/// The residuals of one guess, over their errors; empty where its flight does not get to all measurements.
struct Trial {
  std::vector<double> off;
  double squares = kInfinity;
};

class Fitter {
 public:
  Fitter(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
         const Fidelity& fidelity, std::span<const Measurement> measurements, const FitOptions& options)
      : projectile_(projectile),
        launch_(launch),
        environment_(environment),
        fidelity_(fidelity),
        measurements_(measurements),
        options_(options) {
    for (const Measurement& m : measurements) farthest_ = max(farthest_, m.range);
  }

  Result<Fit> run() {
    Unknowns p = best_guess();
    if (error_) return *error_;
    Trial now = try_out(p);
    if (now.off.empty())
      return Error{"no scale of the drag lets the shot get to " + short_text(farthest_) + " m", "measurements",
                   "check speed, elevation and ranges"};
    for (int i = 0; i < 40; ++i) {
      const Slopes slopes = slopes_at(p, now);
      if (error_) return *error_;
      if (!(slopes.drag_drag > 1e-12))
        return Error{"the measurements do not depend on drag", "measurements",
                     "measure farther from the muzzle, on a rung and in an environment with drag"};
      const double determinant = slopes.determinant();
      if (!(determinant > 1e-12 * slopes.drag_drag * slopes.speed_speed) && options_.muzzle_speed)
        return Error{"the measurements do not tell drag and muzzle speed apart", "measurements",
                     "measure at two ranges at least, or give the muzzle speed"};
      const double moved = improve(p, now, slopes);
      if (error_) return *error_;
      if (abs(p.log_scale) > log(kMostScale)) return beyond(p);
      if (moved < 1e-10) break;
    }
    return result(p, now);
  }

 private:
  /// Sums over the figures of products of derivatives and residuals.
  struct Slopes {
    double drag_drag = 0, drag_speed = 0, speed_speed = 0, drag_off = 0, speed_off = 0;
    bool with_speed = false;
    [[nodiscard]] double determinant() const {
      return with_speed ? drag_drag * speed_speed - drag_speed * drag_speed : drag_drag;
    }
  };

  Flight fly_as(const Unknowns& p) {
    const Until until{.ground = std::nullopt, .time = 600, .range = farthest_ * (1 + 1e-9)};
    ++flights_;
    Flight flight =
        fly(scaled(projectile_, exp(p.log_scale)), launch_as(p), environment_, fidelity_, tolerance_, until);
    if (!flight.error()) tolerance_.step = flight.step();  // pilot flights find it once; 0 of what steps itself
    budget_.spend(flight);
    if (budget_.is_spent()) error_ = StepBudget::error("the fit");
    return flight;
  }

  [[nodiscard]] Launch launch_as(const Unknowns& p) const {
    Launch launch = launch_;
    if (launch.velocity) launch.velocity = *launch.velocity * (1 + p.speed);
    launch.speed *= 1 + p.speed;
    return launch;
  }

  Trial try_out(const Unknowns& p) {
    const Flight flight = fly_as(p);
    if (flight.error()) {
      // A zero may be out of reach for a guess; for the given drag it is the caller's mistake.
      if (p.log_scale == 0 && p.speed == 0) error_ = flight.error();
      return {};
    }
    Trial trial;
    trial.squares = 0;
    for (const Measurement& m : measurements_) {
      const Result<Sample> there = flight.at_range(m.range);
      if (!there) return {};
      for (const Figure& figure : kFigures) {
        if (!(m.*figure.measured)) continue;
        trial.off.push_back(((*there).*figure.computed - *(m.*figure.measured)) / options_.*figure.error);
        trial.squares += trial.off.back() * trial.off.back();
      }
    }
    return trial;
  }

  /// The best of scales a factor of two apart, from the given drag outwards.
  Unknowns best_guess() {
    Unknowns best;
    double least = kInfinity;
    for (const int power : {0, -1, 1, -2, 2, -3, 3, -4, 4, -6, 6}) {
      const Unknowns p{.log_scale = power * log(2.0)};
      const Trial trial = try_out(p);
      if (error_) return best;
      if (trial.squares < least) least = trial.squares, best = p;
    }
    return best;
  }

  Slopes slopes_at(const Unknowns& p, const Trial& now) {
    constexpr double kStep = 1e-4;
    Slopes s{.with_speed = options_.muzzle_speed};
    const Trial more_drag = try_out({p.log_scale - kStep, p.speed});  // less drag gets as far
    const Trial faster = options_.muzzle_speed ? try_out({p.log_scale, p.speed + kStep}) : Trial{};
    for (std::size_t i = 0; i < now.off.size() && i < more_drag.off.size(); ++i) {
      const double by_drag = (now.off[i] - more_drag.off[i]) / kStep;
      const double by_speed = i < faster.off.size() ? (faster.off[i] - now.off[i]) / kStep : 0;
      s.drag_drag += by_drag * by_drag;
      s.drag_speed += by_drag * by_speed;
      s.speed_speed += by_speed * by_speed;
      s.drag_off += by_drag * now.off[i];
      s.speed_off += by_speed * now.off[i];
    }
    return s;
  }

  /// A step of Gauss and Newton, halved until it helps; returns how far it went.
  double improve(Unknowns& p, Trial& now, const Slopes& s) {
    PHYSIM_ASSERT(!now.off.empty() && s.drag_drag > 0);
    const double d = s.determinant();
    double drag = s.with_speed ? -(s.drag_off * s.speed_speed - s.speed_off * s.drag_speed) / d : -s.drag_off / d;
    double speed = s.with_speed ? -(s.speed_off * s.drag_drag - s.drag_off * s.drag_speed) / d : 0;
    drag = clamp(drag, -1.0, 1.0);
    speed = clamp(speed, -0.2, 0.2);
    for (int i = 0; i < 30; ++i, drag *= 0.5, speed *= 0.5) {
      const Unknowns next{p.log_scale + drag, p.speed + speed};
      Trial trial = try_out(next);
      if (!(trial.squares < now.squares)) continue;
      p = next;
      now = std::move(trial);
      return max(abs(drag), abs(speed));
    }
    return 0;
  }

  [[nodiscard]] Error beyond(const Unknowns& p) const {
    return {p.log_scale < 0 ? "the measurements ask for less than a thousandth of the drag"
                            : "the measurements ask for more than a thousand times the drag",
            "measurements", "check their units, the muzzle speed and the projectile's figures"};
  }

  Result<Fit> result(const Unknowns& p, const Trial& now) {
    Fit fit;
    fit.scale = exp(p.log_scale);
    fit.projectile = scaled(projectile_, fit.scale);
    fit.launch = launch_as(p);
    const std::size_t unknowns = options_.muzzle_speed ? 2 : 1;
    fit.rms = sqrt(now.squares / static_cast<double>(now.off.size()));
    if (now.off.size() > unknowns) {
      const Slopes s = slopes_at(p, now);
      const double variance = now.squares / static_cast<double>(now.off.size() - unknowns) / s.determinant();
      const double muzzle = launch_.velocity ? length(*launch_.velocity) : launch_.speed;
      fit.scale_error = fit.scale * sqrt(variance * (s.with_speed ? s.speed_speed : 1));
      fit.muzzle_speed_error = s.with_speed ? muzzle * sqrt(variance * s.drag_drag) : 0;
    }
    auto off = now.off.begin();
    for (std::size_t i = 0; i < measurements_.size(); ++i)
      for (const Figure& figure : kFigures)
        if (const auto measured = measurements_[i].*figure.measured)
          fit.residuals.push_back({i, figure.name, *measured, *measured + *off++ * options_.*figure.error});
    PHYSIM_ASSERT(off == now.off.end());
    fit.flights = flights_;
    return fit;
  }

  ProjectileDef projectile_;
  Launch launch_;
  Environment environment_;
  Fidelity fidelity_;
  std::span<const Measurement> measurements_;
  FitOptions options_;
  double farthest_ = 0;
  std::int64_t flights_ = 0;
  StepBudget budget_;
  Tolerance tolerance_;
  std::optional<Error> error_;
};

Status check(std::span<const Measurement> measurements, const FitOptions& options) {
  Checker c;
  c.positive(options.speed_error, "options.speed_error").positive(options.drop_error, "options.drop_error");
  c.positive(options.time_error, "options.time_error");
  c.require(!measurements.empty(), "measurements", "are none", "give a range with a speed, a drop or a time");
  std::size_t figures = 0;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const Measurement& m = measurements[i];
    const std::string place = "measurements[" + std::to_string(i) + "]";
    c.not_negative(m.range, place + ".range", "along the line of sight");
    if (m.speed) c.positive(*m.speed, place + ".speed", "in m/s");
    if (m.drop) c.is_number(*m.drop, place + ".drop");
    if (m.time) c.not_negative(*m.time, place + ".time", "in s");
    c.require(m.speed || m.drop || m.time, place, "has no figure", "give a speed, a drop or a time");
    if (m.range > 0) figures += std::size_t(m.speed.has_value()) + m.drop.has_value() + m.time.has_value();
  }
  const std::size_t unknowns = options.muzzle_speed ? 2 : 1;
  c.require(figures > 0, "measurements", "lie at the muzzle, all of them", "drag shows farther out");
  c.require(figures >= unknowns, "measurements", "are fewer than the unknowns",
            "two figures at least where drag and muzzle speed are fitted");
  return c.status();
}

/// Speeds that rise by far more than their error where the fitted flight slows down are no measurements of it.
Status check_sense(std::span<const Measurement> measurements, const Fit& fit, const FitOptions& options) {
  std::vector<const FitResidual*> speeds;
  for (const FitResidual& r : fit.residuals)
    if (r.quantity == "speed") speeds.push_back(&r);
  std::sort(speeds.begin(), speeds.end(), [&](const FitResidual* a, const FitResidual* b) {
    return measurements[a->measurement].range < measurements[b->measurement].range;
  });
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    const FitResidual &a = *speeds[i - 1], &b = *speeds[i];
    const double excess = (b.measured - a.measured) - max(0.0, b.computed - a.computed);
    if (excess > max(10 * options.speed_error, 0.05 * a.measured))
      return Error{"the speed rises from " + short_text(a.measured) + " to " + short_text(b.measured) + " m/s",
                   "measurements[" + std::to_string(b.measurement) + "].speed",
                   "no flight of this projectile does that; check the ranges"};
  }
  return {};
}

}  // namespace

Result<Fit> fit_drag(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                     const Fidelity& fidelity, std::span<const Measurement> measurements, const FitOptions& options) {
  const IeeeMode mode;
  if (const Status status = check(measurements, options); !status) return status.error();
  Result<Fit> fit = Fitter(projectile, launch, environment, fidelity, measurements, options).run();
  if (!fit) return fit;
  if (const Status status = check_sense(measurements, *fit, options); !status) return status.error();
  return fit;
}

}  // namespace physim
