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
bool is_pushed(Rung f) { return f.granted.motion == Motion::force; }
bool adapts(Rung f) {
  PHYSIM_ASSERT(!is_chosen_by_rotation(f.granted.integrator));
  return f.granted.motion != Motion::closed_form && is_adaptive(f.granted.integrator);
}
bool takes_fixed_steps(Rung f) { return f.granted.motion != Motion::closed_form && !is_adaptive(f.granted.integrator); }
bool flies_profile(Rung f) { return f.granted.wind == WindModel::profile; }
bool falls_with_height(Rung f) {
  const GravityField field = row(f.granted.gravity).field;
  return (feels_gravity(f) && (field == GravityField::central || field == GravityField::flattened)) ||
         row(f.granted.earth).shape == EarthShape::sphere;
}
bool reads_coefficients(Rung f) { return flies_equation(f) && !flies_spin_by_table(f); }
const ProjectileDef& projectile(R r) { return r.shot().projectile; }
const Launch& launch(R r) { return r.shot().launch; }
/// Whether Miller's rule says the stability of a shot, which `run` prints.
bool has_stability(R r, const ScenarioShot& shot) {
  return !r.scenario.world.given && stability_factor(shot.projectile, shot.launch, r.scenario.environment).has_value();
}
bool has_stability(R r) { return has_stability(r, r.shot()); }
bool has_some_stability(R r) {
  return std::ranges::any_of(r.scenario.shots, [&](const ScenarioShot& shot) { return has_stability(r, shot); });
}
bool blows(R r) {
  const Wind& wind = r.scenario.environment.wind;
  return !wind.profile.empty() || wind.velocity != Vec3d{} || r.is_drawn("environment.wind");
}
bool reads_density(Rung f) {
  return is_in_air(f) && !is_unmoved(f.shot->body) &&
         (flies_equation(f) || flies_spin(f) || flies_body(f) || f.granted.rotation == RotationModel::spin_drift);
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
std::string why_no_turning(R r, bool (*feels)(Rung)) {
  const auto leaves_plane_alone = [&](Rung f) {
    const double azimuth = r.scenario.environment.earth.azimuth + f.shot->launch.azimuth;
    return f.granted.planar && !f.shot->launch.velocity && sincos(azimuth).sin == 0;
  };
  if (!r.any(feels)) return ": only shots over an Earth that turns read it";
  return read_unless(!r.any([&](Rung f) { return feels(f) && !leaves_plane_alone(f); }),
                     "shot.fidelity.planar: fired along a meridian, a shot is turned out of its plane alone");
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
std::string why_no_place(R r) {
  return read_by(has_places(r) || r.any(is_over_round_earth), "shots over a round Earth read");
}
std::string why_no_direction(R r, bool (*feels)(Rung)) {
  if (has_places(r) || r.any(is_over_round_earth)) return {};
  return why_no_turning(r, feels);
}
/// Air that differs with the altitude of the origin, and the weight of what falls with height.
std::string why_no_altitude(R r) {
  const Atmosphere& air = r.scenario.environment.atmosphere;
  const auto reads_air = [&](Rung f) {
    const bool is_overridden = !computes_air(f) && air.density && air.sound_speed;
    return is_in_air(f) && !is_overridden;
  };
  const bool is_read = has_places(r) || has_some_stability(r) || r.any(reads_air) || r.any(falls_with_height) ||
                       r.any(is_over_round_earth);
  return read_or(is_read, ": no shot flies in air, falls by its height or flies over a round Earth");
}

/// Whether what pushes a shot in a world moves it.
std::string why_unmoved(R r) {
  const BodyDef& body = r.shot().body;
  if (!r.scenario.world.given || !is_unmoved(body)) return {};
  if (body.kinematic) return " beside shot.body.kinematic";
  return body.infinite_mass ? " beside shot.body.infinite_mass" : " beside shot.body.frozen";
}

/// A [[force]] that blows like wind reads drag and diameter of what it acts on.
bool is_blown(R r) {
  const auto blows = [](const ScenarioForce& force) { return std::holds_alternative<WindZone>(force.law); };
  return r.any(is_pushed) && std::ranges::any_of(r.scenario.forces, blows);
}

/// Why no shot reads a coefficient of drag.
std::string why_no_coefficient(R r) {
  if (is_blown(r)) return {};
  if (!r.any(is_in_air)) return ": there is no air";
  if (!r.any(flies_equation)) return ": only drag \"equation\" reads it";
  return read_unless(!r.any(reads_coefficients), "shot.magnus.table");
}

// -------------------------------------------------------------------------------------------------------- environment
std::string why_no_air(R r) { return read_or(r.any(is_in_air) || has_some_stability(r), ": no shot flies in air"); }
std::string why_no_sound(R r) {
  const Atmosphere& air = r.scenario.environment.atmosphere;
  if (std::string why = why_no_air(r); !why.empty()) return why;
  const bool overridden = air.density && air.sound_speed;
  return read_unless(overridden && !r.any(computes_air), "environment.atmosphere.density and sound_speed");
}

constexpr UnreadRule kEnvironmentRules[] = {
    {"environment.gravity.model",
     [](R r) {
       const GravityModel model = r.scenario.environment.gravity.model;
       if (model != GravityModel::off && !r.any(feels_gravity)) return std::string(": no shot feels gravity");
       return read_or(r.any([&](Rung f) { return level(f.asked.gravity) >= level(model); }),
                      ": the gravity of shot.fidelity is simpler");
     },
     true},
    {"environment.gravity.acceleration", [](R r) { return read_or(r.any(feels_gravity), ": no shot feels gravity"); }},
    {"environment.gravity.radius",
     [](R r) { return read_by(r.any(falls_with_height), "gravity that falls with height and a sphere read"); }},
    {"environment.atmosphere.model",
     [](R r) {
       const AirModel model = r.scenario.environment.atmosphere.model;
       return read_or(r.any([&](Rung f) { return level(f.asked.air) >= level(model); }),
                      ": the air of shot.fidelity is simpler");
     },
     true},
    {"environment.atmosphere.temperature", why_no_sound},
    {"environment.atmosphere.humidity", why_no_sound},
    {"environment.atmosphere.pressure",
     [](R r) {
       if (std::string why = why_no_air(r); !why.empty()) return why;
       if (!r.any(reads_density) && !has_some_stability(r)) return std::string(": no drag reads the density of air");
       const bool overridden = r.scenario.environment.atmosphere.density.has_value();
       return read_unless(overridden && !r.any(computes_air), "environment.atmosphere.density");
     }},
    {"environment.atmosphere.station_altitude",
     [](R r) {
       if (std::string why = why_no_sound(r); !why.empty()) return why;
       const Atmosphere& air = r.scenario.environment.atmosphere;
       if (!air.profile.empty()) return std::string();  // the check of the environment refuses both
       return read_with(air.temperature || air.pressure || air.humidity,
                        "environment.atmosphere.temperature, pressure or humidity");
     }},
    {"environment.atmosphere.profile",
     [](R r) {
       if (std::string why = why_no_sound(r); !why.empty()) return why;
       const bool is_read = r.any(computes_air) || r.scenario.environment.atmosphere.profile.size() == 1;
       return read_or(is_read, " but at the origin: no shot flies air \"isa\"");
     }},
    {"environment.atmosphere.density",
     [](R r) {
       const auto is_constant = [](Rung f) { return is_in_air(f) && !computes_air(f); };
       const bool is_of_stability = has_some_stability(r) && r.scenario.environment.atmosphere.model != AirModel::isa;
       const bool is_read = is_of_stability || r.any([&](Rung f) { return is_constant(f) && reads_density(f); });
       if (!is_read && r.any(is_constant)) return std::string(": no drag in such air reads its density");
       return read_by(is_read, "air \"constant\" and \"exponential\" read");
     }},
    {"environment.atmosphere.sound_speed",
     [](R r) {
       const auto reads = [](Rung f) { return is_in_air(f) && !computes_air(f); };
       return read_by(r.any(reads), "air \"constant\" and \"exponential\" read");
     }},
    {"environment.atmosphere.scale_height",
     [](R r) {
       return read_by(r.any([](Rung f) { return f.granted.air == AirModel::exponential; }),
                      "air \"exponential\" reads");
     }},
    {"environment.wind",
     [](R r) {
       const bool is_drawn = r.is_drawn("environment.wind");
       return read_or(!blows(r) || r.any([&](Rung f) { return feels_wind(f, is_drawn); }), ": no shot feels wind");
     }},
    {"environment.wind.velocity",
     [](R r) {
       const bool is_read = r.any([](Rung f) { return !flies_profile(f); });
       return read_unless(!r.scenario.environment.wind.profile.empty() && !is_read, "environment.wind.profile");
     }},
    {"environment.wind.profile",
     [](R r) {
       const Wind& wind = r.scenario.environment.wind;
       if (r.any(flies_profile)) return std::string();
       if (wind.velocity != Vec3d{}) return read_unless(true, "environment.wind.velocity where wind is \"constant\"");
       return read_or(wind.profile.size() == 1, " but at the origin: no shot flies wind \"profile\"");
     }},
    {"environment.wind.by",
     [](R r) { return read_with(r.any(flies_profile), "environment.wind.profile and wind \"profile\""); }},
    {"environment.wind.interpolation",
     [](R r) { return read_with(r.any(flies_profile), "environment.wind.profile and wind \"profile\""); }},
    {"environment.earth.rotation_rate", [](R r) { return why_no_turning(r, feels_turning); }},
    {"environment.earth.latitude", [](R r) { return why_no_direction(r, feels_turning); }},
    {"environment.earth.longitude", why_no_place, true},
    {"environment.earth.azimuth",
     [](R r) {
       if (r.is_drawn("environment.wind.from")) return std::string();  // it is a direction of the compass
       return why_no_direction(r, feels_direction);
     },
     true},
    {"environment.altitude", why_no_altitude, true},
};

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

// --------------------------------------------------------------------------------------------------------------- shots
std::string why_no_linear_drag(R r) {
  const auto is_linear = [](Rung f) { return f.granted.drag == DragModel::linear_quadratic; };
  if (!r.any(is_linear)) return ": only drag \"linear_quadratic\" reads it";
  return read_unless(!r.any([&](Rung f) { return is_linear(f) && !flies_spin_by_table(f); }), "shot.magnus.table");
}

constexpr UnreadRule kDragRules[] = {
    {"shot.drag.table", why_no_coefficient},
    {"shot.drag.coefficient",
     [](R r) {
       if (std::string why = why_no_coefficient(r); !why.empty()) return why;
       const DragTable table = projectile(r).drag.table;
       return read_unless(table != DragTable::constant, "shot.drag.table = " + in_quotes(name(table)));
     }},
    {"shot.drag.curve",
     [](R r) {
       if (std::string why = why_no_coefficient(r); !why.empty()) return why;
       const DragTable table = projectile(r).drag.table;
       return read_unless(table != DragTable::custom, "shot.drag.table = " + in_quotes(name(table)));
     }},
    {"shot.drag.ballistic_coefficient", why_no_coefficient},
    {"shot.drag.bands", why_no_coefficient},
    {"shot.drag.form_factor",
     [](R r) {
       if (std::string why = why_no_coefficient(r); !why.empty()) return why;
       const DragDef& drag = projectile(r).drag;
       const std::string by = drag.bands.empty() ? "shot.drag.ballistic_coefficient" : "shot.drag.bands";
       return read_unless(drag.ballistic_coefficient > 0 || !drag.bands.empty(), by);
     }},
    {"shot.drag.damping",
     [](R r) {
       return read_by(r.any([](Rung f) { return f.granted.drag == DragModel::damping; }), "drag \"damping\" reads");
     }},
    {"shot.drag.k1", why_no_linear_drag},
    {"shot.drag.k2", why_no_linear_drag},
};

std::string why_no_spin(R r) { return read_by(r.any(flies_spin), "rotation \"magnus\" reads"); }
std::string why_no_turn(R r) {
  const bool is_turned_in_world = may_be_turned(r) || r.shot().body.angular_velocity != Vec3d{};
  return read_with(launch(r).spin != LaunchSpin{} || r.is_drawn("spin.") || is_turned_in_world, "shot.spin");
}
std::string why_no_formula(R r) {
  if (!projectile(r).magnus.table.empty()) return " beside shot.magnus.table";
  return why_no_turn(r);
}
std::string why_no_body(R r) {
  return read_by(r.any(flies_body), "rotation \"rigid_body\" and \"modified_point_mass\" read");
}
std::string why_no_attitude(R r) { return read_by(r.any(flies_attitude), "rotation \"rigid_body\" reads"); }
std::string why_no_forces(R r) { return read_by(r.any(is_pushed), "motion \"force\" reads"); }
std::string why_no_drag(R r) {
  if (!r.any([](Rung f) { return row(f.granted.drag).is_force; })) return ": no drag is a force";
  return read_or(r.any(is_in_air), ": there is no air");
}
std::string why_no_zero(R r) { return read_with(launch(r).sight.zero_range > 0, "shot.sight.zero_range"); }

/// Whether an area or a size of a shot counts: in air, for a spin, in what it meets.
bool reads_diameter(R r) {
  const bool is_hit = !r.scenario.things.empty() && r.shot().body.collision.on_hit == OnHit::impact;
  const DragDef& drag = projectile(r).drag;
  const bool sizes_drag = (drag.ballistic_coefficient == 0 && drag.bands.empty()) || drag.table == DragTable::sphere;
  const auto is_in_drag = [&](Rung f) { return sizes_drag && is_in_air(f) && flies_equation(f); };
  const auto is_in_spin = [](Rung f) {
    return is_in_air(f) && (flies_spin(f) || flies_body(f) || f.granted.rotation == RotationModel::spin_drift);
  };
  return (is_blown(r) && sizes_drag) || r.any(is_in_drag) || r.any(is_in_spin) || has_stability(r) || is_hit;
}

constexpr UnreadRule kProjectileRules[] = {
    {"shot.diameter",
     [](R r) { return read_or(reads_diameter(r), ": nothing that it flies through or meets reads it"); }, true},
    {"shot.length",
     [](R r) {
       const bool drifts = r.any([](Rung f) { return f.granted.rotation == RotationModel::spin_drift; });
       if (projectile(r).twist == 0) return read_with(has_stability(r), "shot.twist");
       return read_or(drifts || has_stability(r), ": no stability factor is computed from it");
     }},
    {"shot.twist",
     [](R r) {
       const bool spins =
           r.any([](Rung f) { return f.granted.rotation == RotationModel::spin_drift || flies_body(f); });
       return read_by(spins || has_stability(r), "rotations of spinning bodies read");
     }},
    {"shot.drag", why_unmoved},
    {"shot.gravity_scale", why_unmoved},
    {"shot.force", why_unmoved},
    {"shot.magnus", why_unmoved},
    {"shot.motor", why_unmoved},
    {"shot.aero", why_unmoved},
    {"shot.inertia", why_unmoved},
    {"shot.spin", why_unmoved},
    {"shot.gravity_scale",
     [](R r) {
       const BodyDef& body = r.shot().body;
       if (!body.use_gravity) return std::string(" beside shot.body.use_gravity = false");
       if (body.gravity_scale == 0) return std::string(" beside shot.body.gravity_scale = 0");
       return read_or(r.any([](Rung f) { return f.granted.gravity != GravityModel::off; }), ": it feels no gravity");
     }},
    {"shot.force", why_no_forces},
    {"shot.force_duration",
     [](R r) {
       if (std::string why = why_no_forces(r); !why.empty()) return why;
       return read_with(projectile(r).force != Vec3d{}, "shot.force");
     }},
    {"shot.sight.zero_in_calm_air",
     [](R r) {
       if (std::string why = why_no_zero(r); !why.empty()) return why;
       return read_with(blows(r), "environment.wind");
     }},
    {"shot.sight.dial", why_no_zero},
    {"shot.spin", why_no_spin},
    {"shot.magnus", why_no_spin},
    {"shot.magnus.lift", why_no_formula},
    {"shot.magnus.lift_base",
     [](R r) {
       if (std::string why = why_no_formula(r); !why.empty()) return why;
       return read_with(projectile(r).magnus.lift != 0, "shot.magnus.lift");
     }},
    {"shot.magnus.lift_saturation",
     [](R r) {
       if (std::string why = why_no_formula(r); !why.empty()) return why;
       return read_with(projectile(r).magnus.lift != 0, "shot.magnus.lift");
     }},
    {"shot.magnus.drag_per_spin", why_no_formula},
    {"shot.magnus.decay_time", why_no_turn},
    {"shot.magnus.measure",
     [](R r) {
       if (projectile(r).magnus.table.empty()) return std::string(" without shot.magnus.table");
       return why_no_turn(r);
     }},
    {"shot.rail_length",
     [](R r) {
       return read_by(r.any([](Rung f) { return flies_motors(f.granted); }), "motion \"force\" flies a rail and reads");
     }},
    {"shot.motor",
     [](R r) {
       return read_by(r.any([](Rung f) { return flies_motors(f.granted); }),
                      "motion \"force\" flies a motor and reads");
     }},
    {"shot.motor.drag_factor", why_no_drag},
    {"shot.motor.drag_curve", why_no_drag},
    {"shot.inertia", why_no_body},
    {"shot.aero", why_no_body},
    {"shot.aero", [](R r) { return read_or(r.any(is_in_air), ": there is no air"); }},
    {"shot.aero.magnus_moment", why_no_attitude},
    {"shot.aero.damping_frame",
     [](R r) {
       if (std::string why = why_no_attitude(r); !why.empty()) return why;
       return why_no_turning(r, feels_direction);
     }},
    {"shot.aero.pitch_damping", why_no_attitude},
    {"shot.aero.yaw_damping", why_no_attitude},
    {"shot.attitude", why_no_attitude},
    {"shot.attitude.rate_frame", [](R r) { return why_no_turning(r, feels_direction); }},
};

std::string why_chosen(R r) {
  const bool is_aimed = r.scenario.target.position.has_value();  // at the fidelity itself
  return read_unless(r.shot().cheapest_within && !is_aimed, "shot.fidelity.cheapest_within");
}

constexpr UnreadRule kFidelityRules[] = {
    {"shot.fidelity", why_unmoved},
    {"shot.fidelity",
     [](R r) {
       return read_or(!is_ruled_by_detail(r.scenario, r.shot()),
                      ": in the world its rung is one of world.detail.rungs");
     }},
    {"shot.fidelity.integrator", why_chosen},
    {"shot.fidelity.integrator",
     [](R r) {
       return read_or(r.any([](Rung f) { return f.granted.motion != Motion::closed_form; }),
                      ": motion \"closed_form\" takes no steps");
     }},
    {"shot.fidelity.precision", why_chosen},
    {"shot.fidelity.original_one_shot_forces",
     [](R r) {
       const auto is_classic = [](Rung f) { return f.granted.integrator == Integrator::classic; };
       if (!r.any(is_classic)) return std::string(": only integrator \"classic\" reads it");
       const auto is_braked = [&](Rung f) { return is_classic(f) && row(f.granted.drag).is_force; };
       const bool is_forced = projectile(r).force != Vec3d{} || !r.scenario.forces.empty() || r.any(is_braked);
       return read_with(is_forced, "a force, of drag or another");
     }},
    {"shot.fidelity.wind", [](R r) { return read_with(blows(r), "environment.wind"); }},
    {"shot.fidelity.interpolation",
     [](R r) {
       const ProjectileDef& p = projectile(r);
       const bool is_curve = p.drag.table != DragTable::constant && p.drag.table != DragTable::sphere;
       // Adaptive steps end at the points of a linear curve, even of one that a table of spins stands before.
       const auto ends_at_points = [](Rung f) {
         return adapts(f) && is_in_air(f) && flies_equation(f) && f.granted.interpolation == Interpolation::linear;
       };
       if (is_curve && r.any(ends_at_points)) return std::string();
       if (std::string why = why_no_coefficient(r); !why.empty()) return why;
       return read_by(is_curve || !p.motor.drag_curve.empty(), "a curve of drag reads");
     }},
    {"shot.fidelity.tolerance",
     [](R r) {
       if (!r.any(adapts)) return std::string(": only adaptive integrators read it");
       return read_unless(r.scenario.tolerance.relative.has_value(), "tolerance.relative");
     }},
    {"shot.fidelity.body_form", why_no_attitude},
    {"shot.fidelity.body_form",
     [](R r) {
       const auto is_chosen = [&](Rung f) {
         Fidelity open = f.asked;
         open.body_form = BodyForm::automatic;
         const Fidelity granted = grant(open, f.shot->projectile, r.scenario.environment).fidelity;
         return granted.body_form != f.granted.body_form;
       };
       return read_or(r.any(is_chosen), ": that form is flown anyway");
     },
     true},
    {"shot.fidelity.planar", [](R r) { return read_or(may_leave_plane(r), ": nothing moves it out of its plane"); }},
    {"shot.fidelity.aerodynamic_jump",
     [](R r) {
       const Wind& wind = r.scenario.environment.wind;
       return read_with(!wind.profile.empty() || wind.velocity != Vec3d{}, "environment.wind");
     }},
    {"shot.fidelity.aerodynamic_jump",
     [](R r) {
       const auto stability = stability_factor(projectile(r), launch(r), r.scenario.environment);
       return read_or(stability && *stability < kMostStable, ": no stability factor of the shot goes with spin drift");
     }},
    {"shot.fidelity.aerodynamic_jump",
     [](R r) {
       return read_by(r.any([](Rung f) { return f.granted.rotation == RotationModel::spin_drift; }),
                      "rotation \"spin_drift\" reads");
     }},
};

// ----------------------------------------------------------------------------------------------------------- tolerance
std::string why_no_adaptive_steps(R r) { return read_by(r.any(adapts), "adaptive integrators read"); }
std::string why_no_own_steps(R r) {
  return read_or(!r.scenario.world.given, ": the steps of a [world] are world.step");
}

bool may_find_step(Rung f) {
  return takes_fixed_steps(f) && (f.granted.integrator == Integrator::heun || f.granted.integrator == Integrator::rk4);
}

constexpr UnreadRule kToleranceRules[] = {
    {"tolerance.relative", why_no_adaptive_steps},
    {"tolerance.absolute", why_no_adaptive_steps},
    {"tolerance.step",
     [](R r) {
       if (std::string why = why_no_own_steps(r); !why.empty()) return why;
       return read_by(r.any(takes_fixed_steps), "integrators of a fixed step read");
     }},
    {"tolerance.position_error",
     [](R r) {
       if (std::string why = why_no_own_steps(r); !why.empty()) return why;
       if (!r.any(may_find_step)) return std::string(": only integrators \"heun\" and \"rk4\" read it");
       return read_unless(r.scenario.tolerance.step > 0, "tolerance.step");
     }},
    {"tolerance.max_step",
     [](R r) {
       if (std::string why = why_no_own_steps(r); !why.empty()) return why;
       // The flight by which a step is found is an adaptive one.
       if (r.scenario.tolerance.step == 0 && r.any(may_find_step)) return std::string();
       return why_no_adaptive_steps(r);
     }},
    {"tolerance.max_steps", why_no_own_steps},
};

}  // namespace
}  // namespace rules_of_flights

std::span<const UnreadRule> unread_in_flights() {
  using namespace rules_of_flights;
  static const std::vector<UnreadRule> all = [] {
    std::vector<UnreadRule> list;
    for (const std::span<const UnreadRule> part : std::initializer_list<std::span<const UnreadRule>>{
             kEnvironmentRules, kDragRules, kProjectileRules, kFidelityRules, kToleranceRules})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace physim
