#include "contenders.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physim/flight.hpp"

namespace physim::bench {

Tolerance tolerance_of(const Contender& contender, double setting) {
  Tolerance tolerance;
  if (contender.by_pilot)
    tolerance.position_error = setting;
  else
    tolerance.relative = tolerance.absolute = setting;
  return tolerance;
}

Contender peer(std::string name, std::string kernel, void (*fly)(PeerTask&), const PeerModel& model) {
  Contender contender{std::move(name), std::move(kernel), true};
  contender.fly = [fly, &model](const ShotSet& set, std::size_t count, double setting, Vec3d* ends) {
    std::vector<PeerEnd> flown(count);
    PeerTask task{&model, kRange, setting, std::span(set.peer_shots).first(count), flown.data(), 0, 0};
    fly(task);
    if (ends)
      for (std::size_t i = 0; i < count; ++i)
        ends[i] = {flown[i].position[0], flown[i].position[1], flown[i].position[2]};
    return Work{task.steps, task.steps, task.evaluations};
  };
  return contender;
}

namespace {

/// Memory that columns of a run take, used again by the next.
struct Columns {
  std::vector<double> speed, elevation, time, drop, windage, at_end;
  const Launch* of = nullptr;  // whose launches stand in the columns

  /// Filled once for each set, not in every turn: who has columns has them.
  LaunchColumns launches(std::span<const Launch> from) {
    if (of != from.data() || speed.size() != from.size()) {
      speed.clear(), elevation.clear();
      for (const Launch& launch : from) speed.push_back(launch.speed), elevation.push_back(launch.elevation);
      of = from.data();
    }
    return {.speed = speed, .elevation = elevation};
  }
  /// Time, drop, windage and speed at the range line.
  EndColumns ends(std::size_t count) {
    for (auto* column : {&time, &drop, &windage, &at_end}) column->resize(count);
    return {.time = time, .speed = at_end, .drop = drop, .windage = windage};
  }
};

Contender columns(Contender contender, const Fidelity& fidelity) {
  const Contender kind = contender;
  const Contender rows = batch(kind.name, kind.kernel, fidelity, BatchOf::launches);
  contender.fly = [kind, rows, fidelity, memory = Columns{}](const ShotSet& set, std::size_t count, double setting,
                                                             Vec3d* ends) mutable {
    if (ends) return rows.fly(set, count, setting, ends);  // the same numbers
    use_kernel(kind.kernel);
    const ColumnsResult told =
        fly_columns(set.shots[0].projectile, memory.launches(std::span(set.launches).first(count)), bench_environment(),
                    fidelity, tolerance_of(kind, setting), bench_until(), memory.ends(count));
    use_kernel("");
    return told.refused == 0 && count <= 200 ? rows.fly(set, count, setting, nullptr) : Work{};
  };
  return contender;
}

}  // namespace

Contender batch(std::string name, std::string kernel, const Fidelity& fidelity, BatchOf what) {
  Contender contender{std::move(name), std::move(kernel)};
  contender.by_pilot = fidelity.integrator == Integrator::rk4;
  if (fidelity.precision == Precision::float32) contender.tightest = 5e-7;
  if (what == BatchOf::columns) return columns(std::move(contender), fidelity);
  const Contender kind = contender;
  contender.fly = [kind, fidelity, what, result = BatchResult{}](const ShotSet& set, std::size_t count, double setting,
                                                                 Vec3d* ends) mutable {
    use_kernel(kind.kernel);
    const Tolerance tolerance = tolerance_of(kind, setting);
    if (what == BatchOf::launches)
      fly_batch(set.shots[0].projectile, std::span(set.launches).first(count), bench_environment(), fidelity, tolerance,
                bench_until(), result);
    else
      fly_batch(std::span(set.shots).first(count), bench_environment(), fidelity, tolerance, bench_until(), result);
    Work work;
    for (std::size_t i = 0; i < count; ++i) {
      work.steps += result.shots[i].cost.steps;
      work.tries += result.shots[i].cost.steps + result.shots[i].cost.rejected;
      work.evaluations += result.shots[i].cost.evaluations;
      if (ends) ends[i] = result.shots[i].position;
    }
    use_kernel("");
    return work;
  };
  return contender;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Vec3d kNowhere{kNan, kNan, kNan};  // of a flight that misses the range line

Contender single_flights(std::string name, const Fidelity& fidelity) {
  Contender contender{std::move(name), kernels().front()};  // of its steps
  const Contender kind = contender;
  contender.fly = [kind, fidelity](const ShotSet& set, std::size_t count, double setting, Vec3d* ends) {
    use_kernel(kind.kernel);
    Work work;
    const Environment environment = bench_environment();
    const Until until = bench_until();
    const Tolerance tolerance = tolerance_of(kind, setting);
    std::vector<Vec3d> places(ends ? 0 : count);
    Vec3d* const into = ends ? ends : places.data();  // the place is taken in every turn, as of peers
    for (std::size_t i = 0; i < count; ++i) {
      const Flight flight = fly(set.shots[0].projectile, set.launches[i], environment, fidelity, tolerance, until);
      work.steps += flight.cost().steps;
      work.tries += flight.cost().steps + flight.cost().rejected;
      work.evaluations += flight.cost().evaluations;
      // The crossing of the range line, which ends it.
      into[i] = flight.outcome() == Outcome::reached_range ? flight.events().back().position : kNowhere;
    }
    use_kernel("");
    return work;
  };
  return contender;
}

Miss miss(const Contender& contender, const ShotSet& set, std::size_t count, double setting) {
  std::vector<Vec3d> ends(count);
  contender.fly(set, count, setting, ends.data());
  Miss all;
  for (std::size_t i = 0; i < count; ++i) {
    const double error = length(ends[i] - set.reference[i]);
    all.worst = std::isfinite(error) ? std::max(all.worst, error) : INFINITY;
    all.rms += error * error / static_cast<double>(count);
  }
  all.rms = std::sqrt(all.rms);
  return all;
}

Calibration calibrate(const Contender& contender, const ShotSet& probes, double target, int per_decade) {
  const auto error_at = [&](double setting) { return miss(contender, probes, probes.shots.size(), setting).worst; };
  const double start = contender.by_pilot ? 0.03 * target : std::max(contender.tightest, 1e-8 * target);
  // Pilot flights keep their error in time, too, and between steps, where a range line does not look.
  const double loosest = contender.by_pilot ? 1e5 * target : 0.1;
  Calibration best;
  // From the tight end to the loose one, up to the first that misses.
  for (int i = 0;; ++i) {
    const double setting = start * std::pow(10.0, static_cast<double>(i) / per_decade);
    if (setting > loosest) return best;
    const double error = error_at(setting);
    if (error > target) return best.reached ? best : Calibration{setting, error, false};
    best = {setting, error, true};
  }
}

}  // namespace physim::bench
