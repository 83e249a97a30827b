// Rules about settings of the environment, of shots and of tolerance.
#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "model/ladder.hpp"
#include "model/rotor.hpp"
#include "model/sight.hpp"
#include "model/spin_drift.hpp"
#include "physim/names.hpp"
#include "prepare/grant.hpp"
#include "scenario/expectation.hpp"
#include "scenario/suggest.hpp"
#include "scenario/unread.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim {
namespace rules_of_flights {
namespace {

using R = const Reading&;
using Rung = const FlownRung&;

// ------------------------------------------------------------------------------------------------- what a rung reads
bool is_in_air(Rung f) { return f.granted.air != AirModel::vacuum; }
bool computes_air(Rung f) { return f.granted.air == AirModel::isa; }
/// By the drag equation; linear and quadratic drag without numbers takes them from it.
bool flies_equation(Rung f) {
  const DragDef& drag = f.shot->projectile.drag;
  const bool by_launch = f.granted.drag == DragModel::linear_quadratic && drag.k1 == 0 && drag.k2 == 0;
  return f.granted.drag == DragModel::equation || by_launch;
}
bool flies_spin(Rung f) { return f.granted.rotation == RotationModel::magnus; }
bool flies_spin_by_table(Rung f) { return flies_spin(f) && !f.shot->projectile.magnus.table.empty(); }
bool flies_body(Rung f) { return turns(f.granted); }
bool flies_attitude(Rung f) { return turns(f.granted) && !is_in_repose(f.granted); }
bool adapts(Rung f) {
  PHYSIM_ASSERT(!is_chosen_by_rotation(f.granted.integrator));
  return f.granted.motion != Motion::closed_form && is_adaptive(f.granted.integrator);
}
bool takes_fixed_steps(Rung f) { return f.granted.motion != Motion::closed_form && !is_adaptive(f.granted.integrator); }
bool falls_with_height(Rung f) {
  const GravityField field = row(f.granted.gravity).field;
  return (feels_gravity(f) && (field == GravityField::central || field == GravityField::flattened)) ||
         row(f.granted.earth).shape == EarthShape::sphere;
}
bool flies_profile(Rung f) { return f.granted.wind == WindModel::profile; }
bool is_of_force(Rung f) { return row(f.granted.drag).is_force; }
bool is_linear(Rung f) { return f.granted.drag == DragModel::linear_quadratic; }
bool may_burn(Rung f) { return flies_motors(f.granted); }
bool drifts_by_rule(Rung f) { return f.granted.rotation == RotationModel::spin_drift; }
bool reads_coefficients(Rung f) { return flies_equation(f) && !flies_spin_by_table(f); }
const ProjectileDef& projectile(R r) { return r.shot().projectile; }
const Launch& launch(R r) { return r.shot().launch; }
const Atmosphere& air(R r) { return r.scenario.environment.atmosphere; }
const Wind& wind(R r) { return r.scenario.environment.wind; }
/// Whether Miller's rule says the stability of a shot, which `run` prints.
bool has_stability(R r, const ScenarioShot& shot) {
  return !r.scenario.world.given && stability_factor(shot.projectile, shot.launch, r.scenario.environment).has_value();
}
bool has_stability(R r) { return has_stability(r, r.shot()); }
bool has_some_stability(R r) {
  return std::ranges::any_of(r.scenario.shots, [&](const ScenarioShot& shot) { return has_stability(r, shot); });
}
bool blows(R r) { return !wind(r).profile.empty() || wind(r).velocity != Vec3d{} || r.is_drawn("environment.wind"); }
bool reads_density(Rung f) {
  return is_in_air(f) && !is_unmoved(f.shot->body) &&
         (flies_equation(f) || flies_spin(f) || flies_body(f) || drifts_by_rule(f));
}
bool feels_wind(Rung f, bool is_drawn) {
  const bool is_flown = f.granted.wind != WindModel::off || (is_drawn && f.asked.wind != WindModel::off);
  const DragDef& drag = f.shot->projectile.drag;
  const bool by_numbers = f.granted.drag == DragModel::linear_quadratic && (drag.k1 != 0 || drag.k2 != 0);
  return is_flown && (is_in_air(f) || by_numbers);
}
bool feels_direction(Rung f) { return row(f.granted.earth).turning && !is_unmoved(f.shot->body); }
/// Weight has a part of the turning, over a flat Earth, too; it points down whichever way x does.
bool feels_turning(Rung f) {
  const bool is_in_weight = row(f.granted.gravity).field == GravityField::flattened;
  return feels_direction(f) || (is_in_weight && !is_unmoved(f.shot->body));
}
/// Fired along a meridian, a shot is turned aside by the Earth, and by nothing else where the Earth's axis lies in the
/// plane of fire.
bool leaves_plane_alone(R r, Rung f) {
  const double azimuth = r.scenario.environment.earth.azimuth + f.shot->launch.azimuth;
  return f.granted.planar && !f.shot->launch.velocity && sincos(azimuth).sin == 0;
}
bool is_over_round_earth(Rung f) { return row(f.granted.earth).shape != EarthShape::flat; }
/// Whether something is laid out by latitude and longitude: terrain, and figures that are checked.
bool has_places(R r) {
  const auto is_terrain = [](const ScenarioShape& shape) { return !shape.terrain.empty(); };
  const auto is_place = [](const Expectation& expect) {
    const Figure* figure = find_figure(expect.quantity);
    return figure != nullptr && figure->place != nullptr;
  };
  return std::ranges::any_of(r.scenario.shapes, is_terrain) || std::ranges::any_of(r.scenario.expect, is_place);
}
/// True if things or a round Earth read latitude and direction.
bool is_laid_out(R r) { return has_places(r) || r.any(is_over_round_earth); }
/// ... or a direction of the compass that wind comes from.
bool reads_azimuth(R r) { return is_laid_out(r) || r.is_drawn("environment.wind.from"); }
/// Air that differs with the altitude of the origin, and the weight of what falls with height.
bool reads_altitude(R r) {
  const auto reads_air = [&](Rung f) {
    const bool is_overridden = !computes_air(f) && air(r).density && air(r).sound_speed;
    return is_in_air(f) && !is_overridden;
  };
  return is_laid_out(r) || has_some_stability(r) || r.any(reads_air) || r.any(falls_with_height);
}

/// A [[force]] that blows like wind reads drag and diameter of what it acts on.
bool is_blown(R r) {
  const auto blows = [](const ScenarioForce& force) { return std::holds_alternative<WindZone>(force.law); };
  return r.any(is_pushed) && std::ranges::any_of(r.scenario.forces, blows);
}

/// Something that may move a shot out of the plane of fire.
bool may_leave_plane(R r) {
  const bool is_world = r.scenario.world.given && (!r.scenario.forces.empty() || !r.scenario.joints.empty());
  const bool is_turned = r.any([](Rung f) {
    return f.asked.wind != WindModel::off || f.asked.rotation != RotationModel::none ||
           f.asked.earth != EarthModel::flat;
  });
  return is_world || is_turned || r.shot().projectile.force != Vec3d{} || !r.scenario.things.empty() ||
         !r.scenario.emitters.empty();
}

bool flies_constant_air(Rung f) { return is_in_air(f) && !computes_air(f); }
bool reads_constant_density(R r) {
  const bool is_of_stability = has_some_stability(r) && air(r).model != AirModel::isa;
  return is_of_stability || r.any([](Rung f) { return flies_constant_air(f) && reads_density(f); });
}
bool may_turn(R r) {
  const bool is_turned_in_world = may_be_turned(r) || r.shot().body.angular_velocity != Vec3d{};
  return launch(r).spin != LaunchSpin{} || r.is_drawn("spin.") || is_turned_in_world;
}
std::string name_of_table(R r) { return in_quotes(name(projectile(r).drag.table)); }
bool has_curve(R r) {
  const DragTable table = projectile(r).drag.table;
  return table != DragTable::constant && table != DragTable::sphere;
}
/// Adaptive steps end at the points of a linear curve, even of one that a table of spins stands before.
bool interpolates(R r) {
  return has_curve(r) && r.any([](Rung f) {
    return adapts(f) && is_in_air(f) && flies_equation(f) && f.granted.interpolation == Interpolation::linear;
  });
}
bool is_classic(Rung f) { return f.granted.integrator == Integrator::classic; }
bool may_find_step(Rung f) {
  return takes_fixed_steps(f) && (f.granted.integrator == Integrator::heun || f.granted.integrator == Integrator::rk4);
}

/// Whether an area or a size of a shot counts: in air, for a spin, in what it meets.
bool reads_diameter(R r) {
  const bool is_hit = !r.scenario.things.empty() && r.shot().body.collision.on_hit == OnHit::impact;
  const DragDef& drag = projectile(r).drag;
  const bool sizes_drag = (drag.ballistic_coefficient == 0 && drag.bands.empty()) || drag.table == DragTable::sphere;
  const auto is_in_drag = [&](Rung f) { return sizes_drag && is_in_air(f) && flies_equation(f); };
  const auto is_in_spin = [](Rung f) { return is_in_air(f) && (flies_spin(f) || flies_body(f) || drifts_by_rule(f)); };
  return (is_blown(r) && sizes_drag) || r.any(is_in_drag) || r.any(is_in_spin) || has_stability(r) || is_hit;
}

// --------------------------------------------------------------------------------------------------------------- rules
/// Predicate over a rung.
template <bool (*is_true)(Rung)>
bool some(R r) {
  return r.any(is_true);
}
/// ... or a [[force]] that blows reads coefficients anyway.
template <bool (*is_true)(Rung)>
bool some_or_blown(R r) {
  return is_blown(r) || r.any(is_true);
}
/// ... of one that is turned not only out of a plane that it may not leave.
template <bool (*feels)(Rung)>
bool some_in_sight(R r) {
  return r.any([&](Rung f) { return feels(f) && !leaves_plane_alone(r, f); });
}
/// True if a shot of a world is not fixed in a way.
template <bool (*is_fixed)(const BodyDef&)>
bool is_free(R r) {
  return !r.scenario.world.given || !is_fixed(r.shot().body);
}
bool has_own_steps(R r) { return !r.scenario.world.given; }

constexpr std::string_view kAirIsConstant = ": only air \"constant\" and \"exponential\" read it";
constexpr std::string_view kNoTurning = ": only shots over an Earth that turns read it";
constexpr std::string_view kOutOfPlane =
    " beside shot.fidelity.planar: fired along a meridian, a shot is turned out of its plane alone";
constexpr std::string_view kMoving =
    "shot.drag shot.gravity_scale shot.force shot.magnus shot.motor shot.aero "
    "shot.inertia shot.spin shot.fidelity";
constexpr std::string_view kCoefficients =
    "shot.drag.table shot.drag.coefficient shot.drag.curve "
    "shot.drag.ballistic_coefficient shot.drag.bands shot.drag.form_factor";

constexpr UnreadRule kFlightRules[] = {
    // ---------------------------------------------------------------------------------------------------- environment
    described({"environment.gravity.model",
               [](R r) { return r.scenario.environment.gravity.model == GravityModel::off || r.any(feels_gravity); },
               ": no shot feels gravity"}),
    described({"environment.gravity.model",
               [](R r) {
                 const int asked = level(r.scenario.environment.gravity.model);
                 return r.any([&](Rung f) { return level(f.asked.gravity) >= asked; });
               },
               ": the gravity of shot.fidelity is simpler"}),
    {"environment.gravity.acceleration", some<feels_gravity>, ": no shot feels gravity"},
    {"environment.gravity.radius", some<falls_with_height>,
     ": only gravity that falls with height and a sphere read it"},
    described({"environment.atmosphere.model",
               [](R r) {
                 const int asked = level(r.scenario.environment.atmosphere.model);
                 return r.any([&](Rung f) { return level(f.asked.air) >= asked; });
               },
               ": the air of shot.fidelity is simpler"}),
    {"environment.atmosphere.temperature environment.atmosphere.humidity environment.atmosphere.pressure "
     "environment.atmosphere.station_altitude environment.atmosphere.profile",
     [](R r) { return r.any(is_in_air) || has_some_stability(r); }, ": no shot flies in air"},
    {"environment.atmosphere.temperature environment.atmosphere.humidity environment.atmosphere.station_altitude "
     "environment.atmosphere.profile",
     [](R r) { return !air(r).density || !air(r).sound_speed || r.any(computes_air); },
     " beside environment.atmosphere.density and sound_speed"},
    {"environment.atmosphere.pressure", [](R r) { return r.any(reads_density) || has_some_stability(r); },
     ": no drag reads the density of air"},
    {"environment.atmosphere.pressure", [](R r) { return !air(r).density || r.any(computes_air); },
     " beside environment.atmosphere.density"},
    {"environment.atmosphere.station_altitude",
     [](R r) {
       const bool is_refused = !air(r).profile.empty();  // the check of the environment refuses both
       return is_refused || air(r).temperature || air(r).pressure || air(r).humidity;
     },
     " without environment.atmosphere.temperature, pressure or humidity"},
    {"environment.atmosphere.profile", [](R r) { return r.any(computes_air) || air(r).profile.size() == 1; },
     " but at the origin: no shot flies air \"isa\""},
    {"environment.atmosphere.density", [](R r) { return reads_constant_density(r) || !r.any(flies_constant_air); },
     ": no drag in such air reads its density"},
    {"environment.atmosphere.density", reads_constant_density, kAirIsConstant},
    {"environment.atmosphere.sound_speed", some<flies_constant_air>, kAirIsConstant},
    {"environment.atmosphere.scale_height",
     [](R r) { return r.any([](Rung f) { return f.granted.air == AirModel::exponential; }); },
     ": only air \"exponential\" reads it"},
    {"environment.wind",
     [](R r) {
       const bool is_drawn = r.is_drawn("environment.wind");
       return !blows(r) || r.any([&](Rung f) { return feels_wind(f, is_drawn); });
     },
     ": no shot feels wind"},
    {"environment.wind.velocity",
     [](R r) { return wind(r).profile.empty() || r.any([](Rung f) { return !flies_profile(f); }); },
     " beside environment.wind.profile"},
    {"environment.wind.profile", [](R r) { return r.any(flies_profile) || wind(r).velocity == Vec3d{}; },
     " beside environment.wind.velocity where wind is \"constant\""},
    {"environment.wind.profile", [](R r) { return r.any(flies_profile) || wind(r).profile.size() == 1; },
     " but at the origin: no shot flies wind \"profile\""},
    {"environment.wind.by environment.wind.interpolation", some<flies_profile>,
     " without environment.wind.profile and wind \"profile\""},
    {"environment.earth.rotation_rate", some<feels_turning>, kNoTurning},
    {"environment.earth.rotation_rate", some_in_sight<feels_turning>, kOutOfPlane},
    {"environment.earth.latitude", [](R r) { return is_laid_out(r) || r.any(feels_turning); }, kNoTurning},
    {"environment.earth.latitude", [](R r) { return is_laid_out(r) || some_in_sight<feels_turning>(r); }, kOutOfPlane},
    described({"environment.earth.longitude", is_laid_out, ": only shots over a round Earth read it"}),
    described(
        {"environment.earth.azimuth", [](R r) { return reads_azimuth(r) || r.any(feels_direction); }, kNoTurning}),
    described({"environment.earth.azimuth", [](R r) { return reads_azimuth(r) || some_in_sight<feels_direction>(r); },
               kOutOfPlane}),
    described({"environment.altitude", reads_altitude,
               ": no shot flies in air, falls by its height or flies over a round Earth"}),

    // ----------------------------------------------------------------------------------------------------- projectiles
    {kMoving, is_free<[](const BodyDef& body) { return body.kinematic; }>, " beside shot.body.kinematic"},
    {kMoving, is_free<[](const BodyDef& body) { return body.infinite_mass; }>, " beside shot.body.infinite_mass"},
    {kMoving, is_free<[](const BodyDef& body) { return body.frozen == Axes::all; }>, " beside shot.body.frozen"},
    {kCoefficients, some_or_blown<is_in_air>, ": there is no air"},
    {kCoefficients, some_or_blown<flies_equation>, ": only drag \"equation\" reads it"},
    {kCoefficients, some_or_blown<reads_coefficients>, " beside shot.magnus.table"},
    {"shot.drag.coefficient", [](R r) { return projectile(r).drag.table == DragTable::constant; },
     " beside shot.drag.table = ", name_of_table},
    {"shot.drag.curve", [](R r) { return projectile(r).drag.table == DragTable::custom; },
     " beside shot.drag.table = ", name_of_table},
    {"shot.drag.form_factor",
     [](R r) { return !projectile(r).drag.bands.empty() || !(projectile(r).drag.ballistic_coefficient > 0); },
     " beside shot.drag.ballistic_coefficient"},
    {"shot.drag.form_factor", [](R r) { return projectile(r).drag.bands.empty(); }, " beside shot.drag.bands"},
    {"shot.drag.damping", [](R r) { return r.any([](Rung f) { return f.granted.drag == DragModel::damping; }); },
     ": only drag \"damping\" reads it"},
    {"shot.drag.k1 shot.drag.k2", some<is_linear>, ": only drag \"linear_quadratic\" reads it"},
    {"shot.drag.k1 shot.drag.k2",
     [](R r) { return r.any([](Rung f) { return is_linear(f) && !flies_spin_by_table(f); }); },
     " beside shot.magnus.table"},
    described({"shot.diameter", reads_diameter, ": nothing that it flies through or meets reads it"}),
    {"shot.length", [](R r) { return projectile(r).twist != 0 || has_stability(r); }, " without shot.twist"},
    {"shot.length", [](R r) { return projectile(r).twist == 0 || has_stability(r) || r.any(drifts_by_rule); },
     ": no stability factor is computed from it"},
    {"shot.twist", [](R r) { return has_stability(r) || r.any(drifts_by_rule) || r.any(flies_body); },
     ": only rotations of spinning bodies read it"},
    {"shot.gravity_scale", [](R r) { return r.shot().body.use_gravity; }, " beside shot.body.use_gravity = false"},
    {"shot.gravity_scale", [](R r) { return r.shot().body.gravity_scale != 0; }, " beside shot.body.gravity_scale = 0"},
    {"shot.gravity_scale", [](R r) { return r.any([](Rung f) { return f.granted.gravity != GravityModel::off; }); },
     ": it feels no gravity"},
    {"shot.force shot.force_duration", some<is_pushed>, ": only motion \"force\" reads it"},
    {"shot.force_duration", [](R r) { return projectile(r).force != Vec3d{}; }, " without shot.force"},
    {"shot.sight.zero_in_calm_air shot.sight.dial", [](R r) { return launch(r).sight.zero_range > 0; },
     " without shot.sight.zero_range"},
    {"shot.sight.zero_in_calm_air", blows, " without environment.wind"},
    {"shot.spin shot.magnus", some<flies_spin>, ": only rotation \"magnus\" reads it"},
    {"shot.magnus.lift shot.magnus.lift_base shot.magnus.lift_saturation shot.magnus.drag_per_spin",
     [](R r) { return projectile(r).magnus.table.empty(); }, " beside shot.magnus.table"},
    {"shot.magnus.measure", [](R r) { return !projectile(r).magnus.table.empty(); }, " without shot.magnus.table"},
    {"shot.magnus.lift shot.magnus.lift_base shot.magnus.lift_saturation shot.magnus.drag_per_spin "
     "shot.magnus.decay_time shot.magnus.measure",
     may_turn, " without shot.spin"},
    {"shot.magnus.lift_base shot.magnus.lift_saturation", [](R r) { return projectile(r).magnus.lift != 0; },
     " without shot.magnus.lift"},
    {"shot.rail_length", some<may_burn>, ": only motion \"force\" flies a rail and reads it"},
    {"shot.motor", some<may_burn>, ": only motion \"force\" flies a motor and reads it"},
    {"shot.motor.drag_factor shot.motor.drag_curve", some<is_of_force>, ": no drag is a force"},
    {"shot.inertia shot.aero", some<flies_body>, ": only rotation \"rigid_body\" and \"modified_point_mass\" read it"},
    {"shot.motor.drag_factor shot.motor.drag_curve shot.aero", some<is_in_air>, ": there is no air"},
    {"shot.aero.magnus_moment shot.aero.damping_frame shot.aero.pitch_damping shot.aero.yaw_damping shot.attitude "
     "shot.fidelity.body_form",
     some<flies_attitude>, ": only rotation \"rigid_body\" reads it"},
    {"shot.aero.damping_frame shot.attitude.rate_frame", some<feels_direction>, kNoTurning},
    {"shot.aero.damping_frame shot.attitude.rate_frame", some_in_sight<feels_direction>, kOutOfPlane},

    // -------------------------------------------------------------------------------------------------------- fidelity
    {"shot.fidelity", [](R r) { return !is_ruled_by_detail(r.scenario, r.shot()); },
     ": in the world its rung is one of world.detail.rungs"},
    {"shot.fidelity.integrator shot.fidelity.precision",  // a shot is aimed at the fidelity itself
     [](R r) { return !r.shot().cheapest_within || r.scenario.target.position; },
     " beside shot.fidelity.cheapest_within"},
    {"shot.fidelity.integrator",
     [](R r) { return r.any([](Rung f) { return f.granted.motion != Motion::closed_form; }); },
     ": motion \"closed_form\" takes no steps"},
    {"shot.fidelity.original_one_shot_forces", some<is_classic>, ": only integrator \"classic\" reads it"},
    {"shot.fidelity.original_one_shot_forces",
     [](R r) {
       const bool is_braked = r.any([](Rung f) { return is_classic(f) && is_of_force(f); });
       return projectile(r).force != Vec3d{} || !r.scenario.forces.empty() || is_braked;
     },
     " without a force, of drag or another"},
    {"shot.fidelity.wind", blows, " without environment.wind"},
    {"shot.fidelity.interpolation", [](R r) { return interpolates(r) || some_or_blown<is_in_air>(r); },
     ": there is no air"},
    {"shot.fidelity.interpolation", [](R r) { return interpolates(r) || some_or_blown<flies_equation>(r); },
     ": only drag \"equation\" reads it"},
    {"shot.fidelity.interpolation", [](R r) { return interpolates(r) || some_or_blown<reads_coefficients>(r); },
     " beside shot.magnus.table"},
    {"shot.fidelity.interpolation", [](R r) { return has_curve(r) || !projectile(r).motor.drag_curve.empty(); },
     ": only a curve of drag reads it"},
    described({"shot.fidelity.body_form",
               [](R r) {
                 return r.any([&](Rung f) {
                   Fidelity open = f.asked;
                   open.body_form = BodyForm::automatic;
                   const Fidelity granted = grant(open, f.shot->projectile, r.scenario.environment).fidelity;
                   return granted.body_form != f.granted.body_form;
                 });
               },
               ": that form is flown anyway"}),
    {"shot.fidelity.planar", may_leave_plane, ": nothing moves it out of its plane"},
    {"shot.fidelity.aerodynamic_jump", [](R r) { return !wind(r).profile.empty() || wind(r).velocity != Vec3d{}; },
     " without environment.wind"},
    {"shot.fidelity.aerodynamic_jump",
     [](R r) {
       const auto stability = stability_factor(projectile(r), launch(r), r.scenario.environment);
       return stability && *stability < kMostStable;
     },
     ": no stability factor of the shot goes with spin drift"},
    {"shot.fidelity.aerodynamic_jump", some<drifts_by_rule>, ": only rotation \"spin_drift\" reads it"},

    // ------------------------------------------------------------------------------------------------------- tolerance
    {"tolerance.step tolerance.position_error tolerance.max_step tolerance.max_steps", has_own_steps,
     ": the steps of a [world] are world.step"},
    {"shot.fidelity.tolerance tolerance.relative tolerance.absolute", some<adapts>,
     ": only adaptive integrators read it"},
    {"shot.fidelity.tolerance", [](R r) { return !r.scenario.tolerance.relative; }, " beside tolerance.relative"},
    {"tolerance.step", some<takes_fixed_steps>, ": only integrators of a fixed step read it"},
    {"tolerance.position_error", some<may_find_step>, ": only integrators \"heun\" and \"rk4\" read it"},
    {"tolerance.position_error", [](R r) { return !(r.scenario.tolerance.step > 0); }, " beside tolerance.step"},
    {"tolerance.max_step",  // the flight by which a step is found is an adaptive one
     [](R r) { return r.any(adapts) || (r.scenario.tolerance.step == 0 && r.any(may_find_step)); },
     ": only adaptive integrators read it"},
};

}  // namespace
}  // namespace rules_of_flights

std::span<const UnreadRule> unread_in_flights() { return rules_of_flights::kFlightRules; }

}  // namespace physim
