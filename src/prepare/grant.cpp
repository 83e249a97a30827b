// Decides what of an asked fidelity can be had, and says why where it is less.
#include "prepare/grant.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "model/attitude.hpp"
#include "model/drag_curves.hpp"
#include "model/ladder.hpp"
#include "model/sight.hpp"
#include "model/spin_drift.hpp"
#include "physim/names.hpp"
#include "prepare/conditions.hpp"
#include "prepare/launch.hpp"
#include "solve/take_step.hpp"

namespace physim {
namespace {

class Granting {
 public:
  Granting(const Fidelity& asked, const ProjectileDef& projectile, const Environment& environment)
      : f_(asked), projectile_(projectile), environment_(environment) {}

  FidelityInUse run() {
    by_environment();
    by_motion();
    by_integrator();
    by_functions();
    by_earth();
    by_data();
    by_projectile();
    by_rotation();
    by_jump();
    if (is_chosen_by_rotation(f_.integrator))
      f_.integrator = f_.rotation == RotationModel::rigid_body ? kBodyIntegrator : kPointIntegrator;
    PHYSIM_ASSERT(!turns(f_) || flies_motors(f_));
    return {f_, std::move(notes_)};
  }

 private:
  template <class Enum>
  void set(const char* effect, Enum& field, Enum granted, const char* reason) {
    if (field == granted) return;
    PHYSIM_ASSERT(level(granted) < level(field));
    note(effect, name(field), name(granted), reason);
    field = granted;
  }

  template <class Enum>
  void remark(const char* effect, Enum value, const char* reason) {
    note(effect, name(value), name(value), reason);
  }

  PHYSIM_COLD void note(const char* effect, std::string_view asked, std::string_view granted, const char* reason) {
    notes_.push_back({effect, std::string(asked), std::string(granted), reason});
  }

  void by_environment() {
    set("gravity", f_.gravity, lower_of(f_.gravity, environment_.gravity.model),
        "the environment's gravity field is simpler");
    set("air", f_.air, lower_of(f_.air, environment_.atmosphere.model), "the environment's air is simpler");
    const Wind& wind = environment_.wind;
    const bool varies = wind.field || !wind.profile.empty();
    if (!varies) f_.wind = lower_of(f_.wind, WindModel::constant);  // nothing is lost: no note
    if (!varies && wind.velocity == Vec3d{}) f_.wind = WindModel::off;
    const Atmosphere& air = environment_.atmosphere;
    if (f_.air == AirModel::isa && (air.density || air.sound_speed))
      remark("air", f_.air, "density and sound_speed are for constant and exponential air");
    const bool empty = f_.air == AirModel::vacuum || (f_.air != AirModel::isa && air.density == 0.0);
    if (empty && (f_.rotation == RotationModel::spin_drift || f_.rotation == RotationModel::magnus || is_in_repose(f_)))
      set("rotation", f_.rotation, RotationModel::none, "there is no air");
    if (f_.air == AirModel::vacuum && f_.drag == DragModel::equation)
      set("drag", f_.drag, DragModel::off, "there is no air");
  }

  void by_motion() {
    if (f_.motion == Motion::closed_form) {
      const bool linear = f_.drag == DragModel::linear_quadratic && projectile_.drag.k2 == 0 && projectile_.drag.k1 > 0;
      if (row(f_.drag).is_force && !linear)
        set("drag", f_.drag, projectile_.drag.damping < 1 ? DragModel::damping : DragModel::off,
            "a closed form exists only in vacuum or with drag linear in velocity");
      limit_to_constants("the closed form knows only constant gravity over a flat Earth");
      set("wind", f_.wind, lower_of(f_.wind, WindModel::constant), "the closed form knows only constant wind");
    }
    if (f_.motion == Motion::velocity) {
      set("drag", f_.drag, lower_of(f_.drag, DragModel::damping), "motion 'velocity' knows no drag force");
      limit_to_constants("motion 'velocity' knows only constant gravity over a flat Earth");
    }
    if (f_.motion != Motion::force && projectile_.force != Vec3d{})
      remark("motion", f_.motion, "the applied force is left out: only motion 'force' knows forces");
    if (f_.motion != Motion::force && has_motor(projectile_))
      remark("motion", f_.motion, "the motor is left out: only motion 'force' knows forces");
  }

  void by_integrator() {
    const bool classic = is_classic(f_);
    if (classic && f_.motion == Motion::force && has_motor(projectile_))
      remark("integrator", f_.integrator, "the motor is left out: the original loop knows none");
    if (classic) limit_to_constants("the original loop knows only constant gravity over a flat Earth");
    if (classic && f_.drag == DragModel::damping)
      set("wind", f_.wind, WindModel::off, "the original's damping is against still air");
    if (f_.original_one_shot_forces && !classic) {
      note("original_one_shot_forces", "true", "false", "only the original loop has one-shot forces");
      f_.original_one_shot_forces = false;
    }
  }

  [[nodiscard]] bool is_flattened() const { return row(f_.gravity).field == GravityField::flattened; }

  /// The gravity that the Earth can have, after its shape is settled.
  void by_earth() {
    const bool own = has_own_gravity(environment_);
    if (is_flattened() && own)
      set("gravity", f_.gravity, GravityModel::inverse_square,
          "the environment gives its own acceleration or radius, and no flattening goes with them");
    if (is_flattened() && is_sphere(f_.earth))
      set("gravity", f_.gravity, GravityModel::inverse_square,
          "a spherical Earth has the field of a point mass; the flattened one's goes with earth 'ellipsoid'");
    if (is_flattened() && !is_round(f_.earth))
      remark("gravity", f_.gravity, "over a flat Earth it is the weight at the origin's latitude, falling with height");
    if (f_.gravity == GravityModel::inverse_square && is_turning(f_.earth) && is_round(f_.earth) && !own)
      remark("gravity", f_.gravity,
             "the Earth's own GM is used: the standard's g contains the centrifugal acceleration, which is added here");
  }

  /// What an automatic rotation becomes, after motion, integrator and air are settled: the truest model that nothing
  /// refuses.
  void by_data() {
    if (f_.rotation != RotationModel::automatic && f_.rotation != RotationModel::automatic_point) return;
    const ProjectileDef& p = projectile_;
    const bool turns_bodies = f_.rotation == RotationModel::automatic;
    const bool has_air =
        f_.air != AirModel::vacuum && !(f_.air != AirModel::isa && environment_.atmosphere.density == 0.0);
    const bool equation = f_.drag == DragModel::equation;
    const bool free = flies_motors(f_) && !f_.planar && has_air && row(f_.drag).is_force;
    const bool has_body = free && equation && has_inertia(p) && has_coefficients(p.aero);
    if (turns_bodies && has_body)
      return choose(RotationModel::rigid_body, "moments of inertia and coefficients are given");
    if (has_body && is_axisymmetric(p) && p.twist != 0 && !p.aero.pitching.empty())
      return choose(RotationModel::modified_point_mass, "coefficients of a shell with a twist are given");
    if (free && has_magnus(p)) return choose(RotationModel::magnus, "data of lift by spin are given");
    const bool drifts = has_air && equation && !f_.planar && p.twist != 0;
    if (drifts && p.length > 0) return choose(RotationModel::spin_drift, "a twist and a length are given");
    if (drifts) return choose(RotationModel::none, "the drift of a twist needs the projectile's length, too");
    f_.rotation = RotationModel::none;  // there is nothing to choose from: no note
  }
  void choose(RotationModel chosen, const char* reason) {
    note("rotation", name(f_.rotation), name(chosen), reason);
    f_.rotation = chosen;
  }
  static bool has_coefficients(const AeroDef& a) { return !a.lift.empty() || !a.pitching.empty(); }

  void by_projectile() {
    const ProjectileDef& p = projectile_;
    if (f_.rotation == RotationModel::spin_drift) {
      if (p.twist == 0)
        set("rotation", f_.rotation, RotationModel::none, "the projectile has no twist: it does not spin");
      else if (p.length <= 0)
        set("rotation", f_.rotation, RotationModel::none, "the stability factor needs the projectile's length");
      else if (f_.planar)
        set("rotation", f_.rotation, RotationModel::none, "a planar flight does not leave its plane");
    }
    if (f_.drag == DragModel::equation && f_.interpolation == Interpolation::cubic && spline_overshoots(p.drag))
      set("interpolation", f_.interpolation, Interpolation::pchip, "a spline through so few points would overshoot");
    if (f_.drag == DragModel::equation && is_sized_by_default(p))
      remark("drag", f_.drag,
             "mass and diameter are the defaults, 1 kg and 0.1 m: give them, or a ballistic coefficient");
    if (f_.drag == DragModel::linear_quadratic && p.drag.k1 == 0 && p.drag.k2 == 0)
      remark("drag", f_.drag, "k1 and k2 are zero: k2 is taken from the drag equation at launch");
  }

  /// A standard function says how drag changes with speed; its size is not given.
  static bool is_sized_by_default(const ProjectileDef& p) {
    const DragDef& d = p.drag;
    const bool standard = d.table != DragTable::constant && d.table != DragTable::custom;
    if (!standard || d.ballistic_coefficient != 0 || !d.bands.empty()) return false;
    const ProjectileDef plain;
    return p.mass == plain.mass && p.diameter == plain.diameter;
  }

  void without_rotation(const char* reason) { set("rotation", f_.rotation, RotationModel::none, reason); }

  /// After motion and integrator are settled.
  void by_rotation() {
    if (f_.rotation == RotationModel::magnus) by_spin();
    if (!turns(f_)) return by_point();
    if (f_.motion != Motion::force) return without_rotation("only motion 'force' knows moments");
    if (f_.integrator == Integrator::classic) return without_rotation("the original loop knows points only");
    if (f_.planar) return without_rotation("a planar flight does not leave its plane");
    if (!has_inertia(projectile_)) return without_rotation("the projectile's moments of inertia are not given");
    if (is_in_repose(f_)) return by_repose();
    const bool symmetric = is_axisymmetric(projectile_), damps_alike = projectile_.aero.yaw_damping.empty();
    if (f_.body_form == BodyForm::automatic)
      f_.body_form = symmetric && damps_alike && projectile_.twist != 0 ? BodyForm::axis : BodyForm::quaternion;
    if (f_.body_form == BodyForm::axis && !symmetric)
      set("body_form", f_.body_form, BodyForm::quaternion, "the body is not symmetric about its x axis");
    if (f_.body_form == BodyForm::axis && !damps_alike)
      set("body_form", f_.body_form, BodyForm::quaternion, "its yaw damping is not its pitch damping");
  }

  void by_point() {
    if (has_motor(projectile_) && flies_motors(f_) && f_.wind != WindModel::off)
      remark("rotation", f_.rotation,
             "a point's thrust follows the air at once: in wind it turns further than a rocket with a body does");
  }

  void by_repose() {
    if (!is_axisymmetric(projectile_))
      return without_rotation("a yaw of repose has only a body that is symmetric about its x axis");
    if (f_.drag != DragModel::equation) return without_rotation("the yaw of repose goes with the drag equation");
    if (projectile_.aero.pitching.empty())
      return without_rotation("the yaw of repose needs the coefficient of the overturning moment, aero.pitching");
  }

  void by_spin() {
    if (!has_magnus(projectile_)) return without_rotation("the projectile has no data of lift by spin");
    if (f_.motion != Motion::force) return without_rotation("only motion 'force' knows lift");
    if (f_.integrator == Integrator::classic) return without_rotation("the original loop knows no lift");
    if (!row(f_.drag).is_force) return without_rotation("lift by spin goes with a drag force");
  }

  /// A projectile without spin does not jump: nothing is lost.
  void by_jump() {
    if (!f_.aerodynamic_jump || f_.rotation == RotationModel::spin_drift) return;
    f_.aerodynamic_jump = false;
    if (projectile_.twist != 0)
      notes_.push_back({"aerodynamic_jump", "true", "false",
                        "Litz's aerodynamic jump goes with his spin drift; a rigid body jumps by itself"});
  }

  /// After motion and wind are settled.
  void by_functions() {
    const Wind& wind = environment_.wind;
    if (wind.field && f_.wind == WindModel::constant) {
      const char* reason = "a low rung knows no function: the environment's other wind blows";
      if (wind.profile.empty() && wind.velocity == Vec3d{})
        set("wind", f_.wind, WindModel::off, "a low rung knows no function, and the environment has no other wind");
      else
        remark("wind", f_.wind, reason);
    }
    if (environment_.force && f_.motion != Motion::force)
      remark("motion", f_.motion, "the environment's force is left out: only motion 'force' knows forces");
  }

  void limit_to_constants(const char* reason) {
    set("gravity", f_.gravity, lower_of(f_.gravity, GravityModel::constant), reason);
    set("earth", f_.earth, EarthModel::flat, reason);
  }

  Fidelity f_;
  const ProjectileDef& projectile_;
  const Environment& environment_;
  std::vector<FidelityNote> notes_;
};

}  // namespace

bool has_motor(const ProjectileDef& p) { return !p.motor.thrust.empty(); }

bool has_magnus(const ProjectileDef& p) { return p.magnus.lift != 0 || !p.magnus.table.empty(); }

bool flies_motors(const Fidelity& granted) {
  return granted.motion == Motion::force && granted.integrator != Integrator::classic;
}

FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile, const Environment& environment) {
  return Granting(asked, projectile, environment).run();
}

namespace {

constexpr double kMostSphereMach = 0.3;  // where compressibility begins to show

/// Why Litz's drift means little for a shot; empty where it is in its place.
std::string doubt_about_drift(const ProjectileDef& projectile, const Launch& launch, const Environment& environment) {
  const auto stability = stability_of_checked(projectile, launch_speed(launch), environment);
  if (!stability || !(launch_speed(launch) > 0) || (*stability >= 1 && *stability < kMostStable)) return {};
  const std::string is = "the stability factor Sg is " + short_text(*stability);
  if (*stability < 1) return is + ": below 1 the projectile tumbles, and its drift means nothing";
  return is + ": beyond " + short_text(kMostStable) + " there is no drift to be had; look at mass, diameter, length " +
         "and twist";
}

double launch_mach(const Launch& launch, const Environment& environment) {
  const auto air = air_at_origin(environment);
  return air && air->sound_speed > 0 ? launch_speed(launch) / air->sound_speed : 0;
}

}  // namespace

FidelityInUse grant_in_world(const Fidelity& asked, const ProjectileDef& projectile, const Environment& environment) {
  FidelityInUse in_use = grant(by_steps(asked, true), projectile, environment);
  if (in_use.fidelity.rotation == RotationModel::spin_drift) {
    in_use.fidelity.rotation = RotationModel::none;
    in_use.fidelity.aerodynamic_jump = false;
    in_use.notes.push_back({"rotation", "spin_drift", "none", "it is added to whole flights; worlds show what flew"});
  }
  return in_use;
}

FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile, const Environment& environment,
                    const Launch& launch) {
  FidelityInUse in_use = grant(asked, projectile, environment);
  const Fidelity& f = in_use.fidelity;
  const auto remark = [&in_use](const char* effect, std::string_view granted, std::string reason) {
    in_use.notes.push_back({effect, std::string(granted), std::string(granted), std::move(reason)});
  };
  if (launch.rail_length > 0 && !flies_motors(f))
    remark("motion", name(f.motion), "the launch rail is left out: only motion 'force' knows one");
  if (f.rotation == RotationModel::spin_drift)
    if (const auto doubt = doubt_about_drift(projectile, launch, environment); !doubt.empty())
      remark("rotation", name(f.rotation), doubt);
  if (f.drag == DragModel::equation && projectile.drag.table == DragTable::sphere)
    if (const double mach = launch_mach(launch, environment); mach > kMostSphereMach)
      remark("drag", name(f.drag),
             "a sphere's drag by Reynolds number holds below Mach 0.3; this shot starts at Mach " + short_text(mach));
  return in_use;
}

}  // namespace physim
