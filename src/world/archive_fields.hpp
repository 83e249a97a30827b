// How every struct of a recording is taken apart. A struct that gains a field no longer compiles here: name the field,
// and raise kRecordingFormat (include/physim/recording.hpp).
#pragma once

#include "base/archive.hpp"
#include "physim/world_def.hpp"

namespace physim {

// --------------------------------------------------------------------------------------------- small things
template <class A>
void fields(A& a, Vec3d& v) {
  auto& [x, y, z] = v;
  a(x, y, z);
}
template <class A>
void fields(A& a, ProjectileId& id) {
  auto& [index, generation] = id;
  a(index, generation);
}
template <class A>
void fields(A& a, KindId& id) {
  auto& [index] = id;
  a(index);
}
template <class A>
void fields(A& a, ForceId& id) {
  auto& [index, generation] = id;
  a(index, generation);
}

// --------------------------------------------------------------------------------------------- projectiles
template <class A>
void fields(A& a, Fidelity& f) {
  auto& [motion, integrator, gravity, drag, air, wind, earth, rotation, form, precision, interpolation, planar, jump,
         one_shot] = f;
  a(motion, integrator, gravity, drag, air, wind, earth, rotation, form, precision, interpolation, planar, jump,
    one_shot);
}
template <class A>
void fields(A& a, DragPoint& p) {
  auto& [mach, coefficient] = p;
  a(mach, coefficient);
}
template <class A>
void fields(A& a, BallisticBand& b) {
  auto& [above, ballistic_coefficient] = b;
  a(above, ballistic_coefficient);
}
template <class A>
void fields(A& a, DragDef& d) {
  auto& [table, coefficient, curve, ballistic_coefficient, bands, form_factor, damping, k1, k2] = d;
  a(table, coefficient, curve, ballistic_coefficient, bands, form_factor, damping, k1, k2);
}
template <class A>
void fields(A& a, ThrustPoint& p) {
  auto& [time, force] = p;
  a(time, force);
}
template <class A>
void fields(A& a, PropellantPoint& p) {
  auto& [time, mass] = p;
  a(time, mass);
}
template <class A>
void fields(A& a, MotorDef& m) {
  auto& [name, thrust, propellant_mass, propellant, ignition_delay, drag_factor, drag_curve] = m;
  a(name, thrust, propellant_mass, propellant, ignition_delay, drag_factor, drag_curve);
}
template <class A>
void fields(A& a, MagnusPoint& p) {
  auto& [speed, spin, drag, lift] = p;
  a(speed, spin, drag, lift);
}
template <class A>
void fields(A& a, MagnusDef& m) {
  auto& [lift, base, saturation, drag_per_spin, table, measure, decay_time] = m;
  a(lift, base, saturation, drag_per_spin, table, measure, decay_time);
}
template <class A>
void fields(A& a, LaunchSpin& s) {
  auto& [backspin, sidespin, gyrospin] = s;
  a(backspin, sidespin, gyrospin);
}
template <class A>
void fields(A& a, Inertia& i) {
  auto& [moments, products] = i;
  a(moments, products);
}
template <class A>
void fields(A& a, AeroPoint& p) {
  auto& [mach, angle_squared, value] = p;
  a(mach, angle_squared, value);
}
template <class A>
void fields(A& a, AeroDef& d) {
  auto& [area, length, span, norm, frame, drag_yaw, lift, lift_cubic, pitching, pitching_cubic, pitch_damping,
         yaw_damping, roll_damping, magnus_force, magnus_moment] = d;
  a(area, length, span, norm, frame, drag_yaw, lift, lift_cubic, pitching, pitching_cubic, pitch_damping);
  a(yaw_damping, roll_damping, magnus_force, magnus_moment);
}
template <class A>
void fields(A& a, ProjectileDef& p) {
  auto& [name, mass, diameter, length, twist, drag, magnus, inertia, aero, force, force_duration, motor, fidelity] = p;
  a(name, mass, diameter, length, twist, drag, magnus, inertia, aero, force, force_duration, motor, fidelity);
}
template <class A>
void fields(A& a, Sight& s) {
  auto& [height, look_angle, cant, zero_range, zero_in_calm_air] = s;
  a(height, look_angle, cant, zero_range, zero_in_calm_air);
}
template <class A>
void fields(A& a, LaunchAttitude& l) {
  auto& [frame, yaw, pitch, roll, rate_frame, rates] = l;
  a(frame, yaw, pitch, roll, rate_frame, rates);
}
template <class A>
void fields(A& a, Launch& l) {
  auto& [position, speed, elevation, azimuth, velocity, rail_length, sight, attitude, spin] = l;
  a(position, speed, elevation, azimuth, velocity, rail_length, sight, attitude, spin);
}
template <class A>
void fields(A& a, DespawnRules& d) {
  auto& [below, farther, older, slower, outside_box, box_low, box_high] = d;
  a(below, farther, older, slower, outside_box, box_low, box_high);
}
template <class A>
void fields(A& a, BodyDef& b) {
  auto& [gravity_scale, use_gravity, drag_scale, angular_drag, angular_velocity, kinematic, infinite_mass, frozen,
         frozen_rotation, can_sleep, sleep_speed, sleep_time, restitution, friction, rolling_resistance, despawn,
         smoothing, pool, environment, cheapest_within, within_time, layers, colour, label] = b;
  a(gravity_scale, use_gravity, drag_scale, angular_drag, angular_velocity, kinematic, infinite_mass, frozen);
  a(frozen_rotation, can_sleep, sleep_speed, sleep_time, restitution, friction, rolling_resistance, despawn);
  a(smoothing, pool, environment, cheapest_within, within_time, layers, colour, label);
}
template <class A>
void fields(A& a, BodyState& s) {
  auto& [position, velocity] = s;
  a(position, velocity);
}

// --------------------------------------------------------------------------------------------- environments
template <class A>
void fields(A& a, Gravity& g) {
  auto& [model, acceleration, radius] = g;
  a(model, acceleration, radius);
}
template <class A>
void fields(A& a, Atmosphere& s) {
  auto& [model, temperature, pressure, humidity, station_altitude, density, sound_speed, scale_height] = s;
  a(model, temperature, pressure, humidity, station_altitude, density, sound_speed, scale_height);
}
template <class A>
void fields(A& a, WindPoint& p) {
  auto& [at, velocity] = p;
  a(at, velocity);
}
template <class A>
void fields(A& a, Wind& w) {
  auto& [velocity, profile, by, interpolation] = w;
  a(velocity, profile, by, interpolation);
}
template <class A>
void fields(A& a, Earth& e) {
  auto& [latitude, longitude, azimuth, rotation_rate] = e;
  a(latitude, longitude, azimuth, rotation_rate);
}
template <class A>
void fields(A& a, Environment& e) {
  auto& [altitude, gravity, atmosphere, wind, earth] = e;
  a(altitude, gravity, atmosphere, wind, earth);
}

// --------------------------------------------------------------------------------------------- worlds
template <class A>
void fields(A& a, Ground& g) {
  auto& [mode, height, restitution, friction] = g;
  a(mode, height, restitution, friction);
}
template <class A>
void fields(A& a, Tolerance& t) {
  auto& [relative, absolute, step, position_error, max_step, max_steps] = t;
  a(relative, absolute, step, position_error, max_step, max_steps);
}
template <class A>
void fields(A& a, PoolDef& p) {
  auto& [name, maximum, when_full] = p;
  a(name, maximum, when_full);
}
template <class A>
void fields(A& a, DetailRung& r) {
  auto& [fidelity, within, younger] = r;
  a(fidelity, within, younger);
}
template <class A>
void fields(A& a, DetailRule& r) {
  auto& [rungs, hysteresis, layers] = r;
  a(rungs, hysteresis, layers);
}
/// Without threading, which changes no result: who replays has another machine.
template <class A>
void fields(A& a, WorldDef& d) {
  auto& [environment, ground, step, max_steps, time_scale, tolerance, apex_events, pools, detail, threading,
         max_projectiles] = d;
  static_cast<void>(threading);
  a(environment, ground, step, max_steps, time_scale, tolerance, apex_events, pools, detail, max_projectiles);
}

// --------------------------------------------------------------------------------------------- forces
template <class A>
void fields(A& a, ConstantForce& l) {
  auto& [force] = l;
  a(force);
}
template <class A>
void fields(A& a, ConstantAcceleration& l) {
  auto& [acceleration] = l;
  a(acceleration);
}
template <class A>
void fields(A& a, GravityForce& l) {
  auto& [gravity] = l;
  a(gravity);
}
template <class A>
void fields(A& a, LinearQuadraticDragForce& l) {
  auto& [k1, k2, wind] = l;
  a(k1, k2, wind);
}
template <class A>
void fields(A& a, AnchoredSpring& l) {
  auto& [anchor, stiffness, rest_length, damping] = l;
  a(anchor, stiffness, rest_length, damping);
}
template <class A>
void fields(A& a, Spring& l) {
  auto& [other, stiffness, rest_length, damping] = l;
  a(other, stiffness, rest_length, damping);
}
template <class A>
void fields(A& a, Bungee& l) {
  auto& [other, anchor, stiffness, rest_length, damping] = l;
  a(other, anchor, stiffness, rest_length, damping);
}
template <class A>
void fields(A& a, Buoyancy& l) {
  auto& [surface, volume, depth, density, damping, gravity] = l;
  a(surface, volume, depth, density, damping, gravity);
}
template <class A>
void fields(A& a, PointAttractor& l) {
  auto& [centre, strength, softening] = l;
  a(centre, strength, softening);
}
template <class A>
void fields(A& a, WindZone& l) {
  auto& [velocity, low, high, density] = l;
  a(velocity, low, high, density);
}
template <class A>
void fields(A& a, Explosion& l) {
  auto& [centre, force, radius] = l;
  a(centre, force, radius);
}
template <class A>
void fields(A& a, Thrust::Point& p) {
  auto& [time, force] = p;
  a(time, force);
}
template <class A>
void fields(A& a, Thrust& l) {
  auto& [curve, direction] = l;
  a(curve, direction);
}
template <class A>
void fields(A& a, ForceTarget& t) {
  auto& [ids, kind, layers] = t;
  a(ids, kind, layers);
}
template <class A>
void fields(A& a, ForceDef& f) {
  auto& [law, target, delay, duration] = f;
  a(law, target, delay, duration);
}

}  // namespace physim
