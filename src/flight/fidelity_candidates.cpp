#include "flight/fidelity_candidates.hpp"

#include <algorithm>

#include "model/ladder.hpp"
#include "solve/take_step.hpp"

namespace physim {
namespace {

/// Coriolis over a flat Earth is a lower rung of an Earth that turns, and none of a sphere at rest.
std::vector<EarthModel> earths(EarthModel truth) {
  std::vector<EarthModel> list;
  for (const EarthModel earth : rungs_between(EarthModel::flat, truth))
    if (earth == truth || (!is_round(earth) && (is_turning(truth) || !is_turning(earth)))) list.push_back(earth);
  return list;
}

/// The integrator that comes closest to the truth.
constexpr Integrator kTruest = all_rungs<Integrator>().back();

}  // namespace

FidelityLadder::FidelityLadder(const ProjectileDef& projectile, const Environment& environment, const Purpose& purpose)
    : projectile_(projectile), environment_(environment), purpose_(purpose), truth_(purpose.truth) {
  truth_.integrator = kTruest;
  truth_.precision = Precision::float64;
  truth_.tolerance = 0;  // the purpose has one
  truth_ = grant(truth_, projectile, environment).fidelity;
  truth_ = without_idle_rungs(truth_);
}

bool FidelityLadder::granted_as_asked(const Fidelity& f) const {
  return grant(f, projectile_, environment_).fidelity == f;
}

/// Where nothing reads air or wind they are on their lowest rung, and damping that keeps all velocity is no drag. Drag
/// by k1 and k2 takes them from the air at the origin where they are not given; spin drift needs air to be granted.
Fidelity FidelityLadder::without_idle_rungs(Fidelity f) const {
  if (f.drag == DragModel::damping && projectile_.drag.damping == 1) f.drag = DragModel::off;
  if (f.drag != DragModel::equation && !turns(f)) {
    const bool reads_air = f.drag == DragModel::linear_quadratic || f.rotation != RotationModel::none;
    f.air = lower_of(f.air, reads_air ? AirModel::constant : AirModel::vacuum);
  }
  if (f.drag == DragModel::off && !turns(f)) f.wind = WindModel::off;
  if (f.rotation != RotationModel::spin_drift || f.wind == WindModel::off) f.aerodynamic_jump = false;
  return f;
}

std::vector<Lowered> FidelityLadder::lowered() const {
  std::vector<Lowered> list;
  const auto add = [&](const char* effect, const auto& low, auto Fidelity::*field) {
    Fidelity f = truth_;
    f.*field = low;
    const bool idle = !(without_idle_rungs(f).*field == low);  // the same as a lower rung
    f = without_idle_rungs(f);
    if (!idle && !(f == truth_) && granted_as_asked(f)) list.push_back({effect, f});
  };
  for (const DragModel drag : rungs_between(DragModel::off, truth_.drag)) add("drag", drag, &Fidelity::drag);
  if (truth_.drag == DragModel::equation)
    for (const AirModel air : rungs_between(AirModel::constant, truth_.air)) add("air", air, &Fidelity::air);
  for (const WindModel wind : rungs_between(WindModel::off, truth_.wind)) add("wind", wind, &Fidelity::wind);
  for (const GravityModel gravity : rungs_between(GravityModel::constant, truth_.gravity))
    add("gravity", gravity, &Fidelity::gravity);
  for (const EarthModel earth : earths(truth_.earth)) add("earth", earth, &Fidelity::earth);
  for (const RotationModel rotation : rungs_between(RotationModel::none, truth_.rotation))
    add("rotation", rotation, &Fidelity::rotation);
  return list;
}

bool FidelityLadder::shares(const Fidelity& f, const Lowered& lowered) const {
  const Fidelity& l = lowered.fidelity;
  const std::string& effect = lowered.effect;
  if (effect == "drag") return f.drag == l.drag;
  if (effect == "air") return f.drag == DragModel::equation && f.air == l.air;
  if (effect == "wind") return f.drag != DragModel::off && f.wind == l.wind;
  if (effect == "gravity") return f.gravity == l.gravity;
  if (effect == "earth") return f.earth == l.earth;
  PHYSIM_ASSERT(effect == "rotation");
  return f.rotation == l.rotation;
}

std::vector<Fidelity> FidelityLadder::models() const {
  std::vector<Fidelity> list;
  const auto add = [&](Fidelity f) {
    f = without_idle_rungs(f);
    if (granted_as_asked(f) && std::find(list.begin(), list.end(), f) == list.end()) list.push_back(f);
  };
  Fidelity f = truth_;
  for (const RotationModel rotation : rungs_between(RotationModel::none, truth_.rotation))
    for (const EarthModel earth : earths(truth_.earth))
      for (const GravityModel gravity : rungs_between(GravityModel::constant, truth_.gravity))
        for (const DragModel drag : rungs_between(DragModel::off, truth_.drag))
          for (const AirModel air : rungs_between(AirModel::constant, truth_.air))
            for (const WindModel wind : rungs_between(WindModel::off, truth_.wind)) {
              f.rotation = rotation, f.earth = earth, f.gravity = gravity;
              f.drag = drag, f.air = air, f.wind = wind;
              add(f);
            }
  return list;
}

std::vector<Stepper> FidelityLadder::steppers(double longest) const {
  std::vector<Stepper> list;
  const auto add = [&](Motion motion, Integrator integrator, double step) {
    if (level(motion) < level(purpose_.least_motion) || level(motion) > level(truth_.motion)) return;
    const bool exact = integrator == kTruest;  // wasted on float32
    for (const Precision precision : rungs_between(purpose_.least_precision, Precision::float64))
      if (!(exact && precision == Precision::float32)) list.push_back({motion, integrator, precision, step});
  };
  PHYSIM_ASSERT(longest > 0 && purpose_.step >= 0);
  constexpr int kFewest = 4, kMost = 1 << 16;  // free steps in a flight
  std::vector<double> steps = {purpose_.step};
  if (purpose_.step == 0) steps.clear();
  for (int n = kFewest; purpose_.step == 0 && n <= kMost; n *= 2) steps.push_back(longest / n);
  add(Motion::closed_form, Integrator::semi_implicit_euler, 0);
  const std::vector<double> chosen = {0};  // adaptive ones choose their steps
  for (const bool adaptive : {false, true})
    for (const Integrator integrator : all_rungs<Integrator>()) {
      if (!row(integrator).is_candidate || is_adaptive(integrator) != adaptive) continue;
      for (const double step : adaptive ? chosen : steps)
        for (const Motion motion : {Motion::velocity, Motion::force}) add(motion, integrator, step);
    }
  return list;
}

std::optional<Fidelity> FidelityLadder::combine(const Fidelity& models, const Stepper& stepper) const {
  Fidelity f = models;
  f.motion = stepper.motion;
  f.integrator = stepper.integrator;
  f.precision = stepper.precision;
  return granted_as_asked(f) ? std::optional(f) : std::nullopt;
}

}  // namespace physim
