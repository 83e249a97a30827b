// The C interface of PhySim for C#, made of its header by tools/c_interface.py: change those. docs/c.md is its guide.
// Pointers are pointers: structs of one's own are read and written in place. Delegates that a call keeps must stay.
using System;
using System.Runtime.InteropServices;

namespace PhySim {
public enum physim_result {
  PHYSIM_OK = 0,
  /// <summary>a pointer that is null, a size that is 0, a number that is NaN</summary>
  PHYSIM_BAD_ARGUMENT = 1,
  /// <summary>null, freed, or of another kind</summary>
  PHYSIM_BAD_HANDLE = 2,
  /// <summary>what was asked makes no sense: the error says what, where, and what to do</summary>
  PHYSIM_REFUSED = 3,
  /// <summary>nothing there: a range that a flight never reached, a thing of no such name</summary>
  PHYSIM_NOT_FOUND = 4,
  /// <summary>the text was cut; its length was written</summary>
  PHYSIM_TOO_SMALL = 5,
  /// <summary>nothing was made; a world that was being changed is lost</summary>
  PHYSIM_OUT_OF_MEMORY = 6,
  /// <summary>a mistake inside of the library</summary>
  PHYSIM_FAILED = 7,
  /// <summary>the world ran out of memory in the middle of a change; free it</summary>
  PHYSIM_LOST = 8,
}
public enum physim_position {
  PHYSIM_POSITION = 1,
  PHYSIM_SPEED = 2,
  PHYSIM_ELEVATION = 4,
  PHYSIM_AZIMUTH = 8,
  /// <summary>instead of speed, elevation and azimuth</summary>
  PHYSIM_VELOCITY = 16,
}
public enum physim_outcome {
  PHYSIM_LANDED = 0,
  PHYSIM_REACHED_RANGE = 1,
  PHYSIM_EVENT = 2,
  PHYSIM_TIME_LIMIT = 3,
  PHYSIM_STEP_LIMIT = 4,
  PHYSIM_LEFT_DOMAIN = 5,
  PHYSIM_NON_FINITE = 6,
  PHYSIM_STALLED = 7,
  PHYSIM_WAS_REFUSED = 8,
  PHYSIM_HIT = 9,
}
public enum physim_moment {
  PHYSIM_AT_END = 0,
  /// <summary>value: since launch [s]</summary>
  PHYSIM_AT_TIME = 1,
  /// <summary>value: first crossing, along the line of sight [m]</summary>
  PHYSIM_AT_RANGE = 2,
  /// <summary>value: first crossing, above the origin [m]</summary>
  PHYSIM_AT_HEIGHT = 3,
  /// <summary>the first</summary>
  PHYSIM_AT_APEX = 4,
}
public enum physim_firing {
  /// <summary>the world and its scene; calls add all else</summary>
  PHYSIM_FIRE_NOTHING = 0,
  /// <summary>shots, volleys, emitters, forces and joints of the scenario come by themselves</summary>
  PHYSIM_FIRE_ALL = 1,
}
public enum physim_ask_hits {
  PHYSIM_ASK_HITS = 1,
}
public enum physim_world_action {
  /// <summary>takes all projectiles out</summary>
  PHYSIM_CLEAR = 0,
  /// <summary>value: 1 or 0; physim_world_advance() takes no steps meanwhile</summary>
  PHYSIM_PAUSE = 1,
  /// <summary>one step of the world's own, paused or not</summary>
  PHYSIM_SINGLE_STEP = 2,
  /// <summary>value: factor on the time given to physim_world_advance()</summary>
  PHYSIM_TIME_SCALE = 3,
}
public enum physim_on_hit {
  PHYSIM_HIT_PASSES = 0,
  PHYSIM_HIT_STOPS = 1,
  PHYSIM_HIT_STICKS = 2,
  PHYSIM_HIT_BOUNCES = 3,
  PHYSIM_HIT_BY_MATERIAL = 4,
}
/// <summary>The meaning of a drawn element; colours are the caller's.</summary>
public enum physim_ink {
  /// <summary>a thing that is hit</summary>
  PHYSIM_INK_SOLID = 0,
  /// <summary>a thing that only reports</summary>
  PHYSIM_INK_SENSOR = 1,
  /// <summary>the path of a thing</summary>
  PHYSIM_INK_PATH = 2,
  /// <summary>of the trees of things</summary>
  PHYSIM_INK_BOX = 3,
  /// <summary>a projectile that moves</summary>
  PHYSIM_INK_FLYING = 4,
  /// <summary>a projectile that sleeps</summary>
  PHYSIM_INK_ASLEEP = 5,
  /// <summary>a projectile that calls move, or that nothing moves</summary>
  PHYSIM_INK_HELD = 6,
  /// <summary>how far a projectile moves in a time</summary>
  PHYSIM_INK_VELOCITY = 7,
  /// <summary>the normal of what was hit in the last step, there</summary>
  PHYSIM_INK_CONTACT = 8,
  /// <summary>between its ends</summary>
  PHYSIM_INK_JOINT = 9,
}
public enum physim_emitter_action {
  PHYSIM_PLAY = 0,
  PHYSIM_STOP = 1,
  /// <summary>its subs that wait for it</summary>
  PHYSIM_TRIGGER = 2,
  /// <summary>value: this many particles at once</summary>
  PHYSIM_EMIT = 3,
  /// <summary>value: as if it had played for this time [s]</summary>
  PHYSIM_SEEK = 4,
}
public enum physim_joint_kind {
  PHYSIM_ROD = 0,
  PHYSIM_CABLE = 1,
  PHYSIM_SPRING = 2,
  PHYSIM_HINGE = 3,
  PHYSIM_SLIDER = 4,
}
public enum physim_what {
  PHYSIM_A_FORCE = 0,
  PHYSIM_A_JOINT = 1,
  PHYSIM_AN_EMITTER = 2,
}
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_wind_function(IntPtr user, physim_wind_batch* batch);
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_field_function(IntPtr user, physim_field_batch* batch);
/// <summary>Decides what hits of kinds with PHYSIM_ASK_HITS do: a row for each hit.</summary>
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_hit_function(IntPtr user, UIntPtr count, physim_hit_question* questions, physim_hit_answer* answers);
/// <summary>Fills `part`, `normal` (outwards, of any length but 0) and `thing.index` (above 0, the engine's own) of a hit; `velocity`, `primitive`, `material` (of the scene), `entering` and `starts_inside` count, too. The answer must follow from the segment alone.</summary>
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_engine_function(IntPtr user, physim_engine_batch* batch);
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_force_function(IntPtr user, physim_force_batch* batch);
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_setting {
  /// <summary>sizeof(physim_setting) [bytes]</summary>
  public uint size;
  /// <summary>physim_world_set() changes it for one projectile in flight</summary>
  public int live;
  /// <summary>"shot.drag.ballistic_coefficient"</summary>
  public byte* path;
  /// <summary>"quantity", "integer", "boolean", "text", "choice", "vector", "points", "list", ...</summary>
  public byte* type;
  /// <summary>SI unit, "" for none, "of the kind" where another setting decides</summary>
  public byte* unit;
  /// <summary>"" if there is none</summary>
  public byte* default_value;
  /// <summary>"&gt; 0", "0 .. 1", "off | constant | ..."; of lists: their length</summary>
  public byte* range;
  /// <summary>one line</summary>
  public byte* doc;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_wind_batch {
  /// <summary>places</summary>
  public UIntPtr count;
  /// <summary>since launch; in worlds, of the world [s]</summary>
  public double* time;
  /// <summary>three for each place [m]</summary>
  public double* position;
  /// <summary>of the air, three for each, zero as it comes: to be filled [m/s]</summary>
  public double* velocity;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_field_batch {
  /// <summary>projectiles</summary>
  public UIntPtr count;
  /// <summary>since launch; in worlds, of the world [s]</summary>
  public double* time;
  /// <summary>three for each [m]</summary>
  public double* position;
  /// <summary>three for each [m/s]</summary>
  public double* velocity;
  /// <summary>that is left [kg]</summary>
  public double* mass;
  /// <summary>three for each, zero as it comes: to be filled [N]</summary>
  public double* force;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_launch {
  /// <summary>sizeof(physim_launch) [bytes]</summary>
  public uint size;
  /// <summary>PHYSIM_POSITION | ...: the members below that count</summary>
  public uint given;
  /// <summary>of the muzzle [m]</summary>
  public fixed double position[3];
  /// <summary>[m/s]</summary>
  public fixed double velocity[3];
  /// <summary>[m/s]</summary>
  public double speed;
  /// <summary>of the bore above the horizon [rad]</summary>
  public double elevation;
  /// <summary>of the plane of fire, to the right [rad]</summary>
  public double azimuth;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_flight_info {
  /// <summary>sizeof(physim_flight_info) [bytes]</summary>
  public uint size;
  /// <summary>physim_outcome</summary>
  public int outcome;
  /// <summary>[s]</summary>
  public double duration;
  /// <summary>of the bore, as given or as found for the zero range [rad]</summary>
  public double elevation;
  /// <summary>fixed step in use; 0: adaptive [s]</summary>
  public double step;
  /// <summary>taken</summary>
  public long steps;
  /// <summary>of the acceleration</summary>
  public long evaluations;
  /// <summary>that happened</summary>
  public UIntPtr events;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_sample {
  /// <summary>sizeof(physim_sample) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>since launch [s]</summary>
  public double time;
  /// <summary>[m]</summary>
  public fixed double position[3];
  /// <summary>[m/s]</summary>
  public fixed double velocity[3];
  /// <summary>[m/s^2]</summary>
  public fixed double acceleration[3];
  /// <summary>[m/s]</summary>
  public double speed;
  public double mach;
  /// <summary>kinetic [J]</summary>
  public double energy;
  /// <summary>[kg]</summary>
  public double mass;
  /// <summary>of the motor [N]</summary>
  public double thrust;
  /// <summary>along the line of sight [m]</summary>
  public double range;
  /// <summary>above the line of sight [m]</summary>
  public double drop;
  /// <summary>right of the line of sight [m]</summary>
  public double windage;
  /// <summary>w, x, y, z: takes body axes into the world frame</summary>
  public fixed double orientation[4];
  /// <summary>along body axes [rad/s]</summary>
  public fixed double angular_velocity[3];
  /// <summary>[rad]</summary>
  public double angle_of_attack;
}
/// <summary>Rows of samples, a column for each number; null: not wanted.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_samples {
  /// <summary>sizeof(physim_samples) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>since launch [s]</summary>
  public double* time;
  /// <summary>[m]</summary>
  public double* x;
  /// <summary>[m]</summary>
  public double* y;
  /// <summary>[m]</summary>
  public double* z;
  /// <summary>[m/s]</summary>
  public double* vx;
  /// <summary>[m/s]</summary>
  public double* vy;
  /// <summary>[m/s]</summary>
  public double* vz;
  /// <summary>[m/s]</summary>
  public double* speed;
  public double* mach;
  /// <summary>along the line of sight [m]</summary>
  public double* range;
  /// <summary>above the line of sight [m]</summary>
  public double* drop;
  /// <summary>right of the line of sight [m]</summary>
  public double* windage;
  /// <summary>[J]</summary>
  public double* energy;
}
/// <summary>Names one of many in a world or a scene: projectiles, forces, joints, emitters, things. Index 0: none. As in C++, ids are equal on every machine that makes the same calls, and do not say of which world they are.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_id {
  /// <summary>of its slot</summary>
  public uint index;
  /// <summary>of the slot's use</summary>
  public uint generation;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_event {
  /// <summary>physim_name("event", kind): "landed", "bounced", "hit", ...</summary>
  public int kind;
  /// <summary>physim_name("crossing", direction)</summary>
  public int direction;
  /// <summary>physim_name("reason", reason), of what left a world</summary>
  public int reason;
  /// <summary>of what was hit: triangle or part</summary>
  public uint primitive;
  /// <summary>of what was hit</summary>
  public uint material;
  /// <summary>projectile in a world</summary>
  public physim_id id;
  /// <summary>that was hit; none: the ground</summary>
  public physim_id thing;
  /// <summary>projectile that it met</summary>
  public physim_id other;
  public uint reserved;
  /// <summary>that was crossed, or a depth [unit of the kind]</summary>
  public double value;
  /// <summary>since launch; in a world of the world [s]</summary>
  public double time;
  /// <summary>[m]</summary>
  public fixed double position[3];
  /// <summary>[m/s]</summary>
  public fixed double velocity[3];
  /// <summary>of what was hit, towards the projectile</summary>
  public fixed double normal[3];
  /// <summary>lost to it [J]</summary>
  public double energy;
}
/// <summary>Columns of launches, each of as many numbers as there are launches; null: all as the shot has it.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_launches {
  /// <summary>sizeof(physim_launches) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>of the muzzle [m]</summary>
  public double* x;
  /// <summary>[m]</summary>
  public double* y;
  /// <summary>[m]</summary>
  public double* z;
  /// <summary>[m/s]</summary>
  public double* speed;
  /// <summary>[rad]</summary>
  public double* elevation;
  /// <summary>[rad]</summary>
  public double* azimuth;
  /// <summary>batches only [kg/m^2]</summary>
  public double* ballistic_coefficient;
  /// <summary>batches only</summary>
  public double* form_factor;
  /// <summary>worlds only: it is launched so much later [s]</summary>
  public double* delay;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_weather {
  /// <summary>sizeof(physim_weather) [bytes]</summary>
  public uint size;
  /// <summary>the wind below moves the points of the profile</summary>
  public int moves_profile;
  /// <summary>[m/s]</summary>
  public double* wind_x;
  /// <summary>[m/s]</summary>
  public double* wind_y;
  /// <summary>[m/s]</summary>
  public double* wind_z;
  /// <summary>at the station [K]</summary>
  public double* temperature;
  /// <summary>at the station [Pa]</summary>
  public double* pressure;
  /// <summary>at the station</summary>
  public double* humidity;
  /// <summary>at the origin [kg/m^3]</summary>
  public double* density;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_ends {
  /// <summary>sizeof(physim_ends) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>physim_outcome</summary>
  public int* outcome;
  /// <summary>of flight; NaN of a shot that was refused, as all others [s]</summary>
  public double* time;
  /// <summary>of the end [m]</summary>
  public double* x;
  /// <summary>[m]</summary>
  public double* y;
  /// <summary>[m]</summary>
  public double* z;
  /// <summary>at the end [m/s]</summary>
  public double* vx;
  /// <summary>[m/s]</summary>
  public double* vy;
  /// <summary>[m/s]</summary>
  public double* vz;
  /// <summary>[m/s]</summary>
  public double* speed;
  /// <summary>above the line of sight [m]</summary>
  public double* drop;
  /// <summary>right of the line of sight [m]</summary>
  public double* windage;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_batch_info {
  /// <summary>sizeof(physim_batch_info) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>shots</summary>
  public ulong refused;
  /// <summary>instruction set that flew them</summary>
  public fixed byte kernel[16];
  /// <summary>of the first shot that was refused; empty: none was</summary>
  public fixed byte first_error[256];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_target {
  /// <summary>sizeof(physim_target) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>at launch [m]</summary>
  public fixed double position[3];
  /// <summary>[m/s]</summary>
  public fixed double velocity[3];
  /// <summary>constant [m/s^2]</summary>
  public fixed double acceleration[3];
  /// <summary>a path that passes so near hits it; 0: 0.01 [m]</summary>
  public double tolerance;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_way {
  /// <summary>the members below count</summary>
  public int found;
  public uint reserved;
  /// <summary>of the bore [rad]</summary>
  public double elevation;
  /// <summary>[rad]</summary>
  public double azimuth;
  /// <summary>of flight [s]</summary>
  public double time;
  /// <summary>[m]</summary>
  public double miss;
  /// <summary>there [m/s]</summary>
  public double speed;
  /// <summary>downwards positive [rad]</summary>
  public double descent;
  /// <summary>of the projectile there [m]</summary>
  public fixed double position[3];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_aim_info {
  /// <summary>sizeof(physim_aim_info) [bytes]</summary>
  public uint size;
  public int in_reach;
  /// <summary>paths hit only through the ground</summary>
  public int behind_ground;
  /// <summary>ways that something stands in</summary>
  public uint blocked;
  /// <summary>flown</summary>
  public long flights;
  /// <summary>of the shortest time</summary>
  public physim_way low;
  /// <summary>of the longest</summary>
  public physim_way high;
  /// <summary>that any flight came</summary>
  public physim_way nearest;
  /// <summary>in words</summary>
  public fixed byte explanation[256];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_farthest {
  /// <summary>sizeof(physim_farthest) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>of the bore above the horizon [rad]</summary>
  public double elevation;
  /// <summary>along the ground, from below the muzzle [m]</summary>
  public double range;
  /// <summary>of flight [s]</summary>
  public double time;
  /// <summary>of impact [m]</summary>
  public fixed double position[3];
  /// <summary>at impact [m/s]</summary>
  public fixed double velocity[3];
  /// <summary>flown</summary>
  public long flights;
}
/// <summary>A motion in a straight line under constant acceleration: v = u + a t, s = u t + a t^2 / 2.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_straight {
  /// <summary>displacement from the start [m]</summary>
  public double s;
  /// <summary>velocity at the start [m/s]</summary>
  public double u;
  /// <summary>velocity at time t [m/s]</summary>
  public double v;
  /// <summary>acceleration [m/s^2]</summary>
  public double a;
  /// <summary>time since the start [s]</summary>
  public double t;
}
/// <summary>A flight beside the reference. Distances and delay are NaN of one that never came to its end.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_compared {
  /// <summary>between its end and that of the reference [m]</summary>
  public double end_distance;
  /// <summary>between the two at any equal time [m]</summary>
  public double largest_distance;
  /// <summary>of its end after that of the reference [s]</summary>
  public double end_delay;
  /// <summary>taken</summary>
  public long steps;
  /// <summary>of the acceleration</summary>
  public long evaluations;
}
/// <summary>A figure that was not measured is NaN.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_measurement {
  /// <summary>along the line of sight [m]</summary>
  public double range;
  /// <summary>[m/s]</summary>
  public double speed;
  /// <summary>above the line of sight [m]</summary>
  public double drop;
  /// <summary>of flight [s]</summary>
  public double time;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_fit_options {
  /// <summary>sizeof(physim_fit_options) [bytes]</summary>
  public uint size;
  /// <summary>fits it, too</summary>
  public int muzzle_speed;
  /// <summary>0: 1 [m/s]</summary>
  public double speed_error;
  /// <summary>0: 0.01 [m]</summary>
  public double drop_error;
  /// <summary>0: 0.001 [s]</summary>
  public double time_error;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_fit_info {
  /// <summary>sizeof(physim_fit_info) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>drag of what was fitted over that of the shot</summary>
  public double scale;
  /// <summary>standard error</summary>
  public double scale_error;
  /// <summary>[m/s]</summary>
  public double muzzle_speed;
  /// <summary>standard error [m/s]</summary>
  public double muzzle_speed_error;
  /// <summary>of residuals over their errors</summary>
  public double rms;
  /// <summary>flown</summary>
  public long flights;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_purpose {
  /// <summary>sizeof(physim_purpose) [bytes]</summary>
  public uint size;
  /// <summary>steps are free; else a frame is `step`</summary>
  public int free_step;
  /// <summary>largest distance from the truth; 0: 0.01 [m]</summary>
  public double error;
  /// <summary>over which it must hold; 0: 2 [s]</summary>
  public double time;
  /// <summary>a frame; 0: 1/60 [s]</summary>
  public double step;
  /// <summary>height where flights end; NaN: no ground [m]</summary>
  public double ground;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_fidelity_info {
  /// <summary>sizeof(physim_fidelity_info) [bytes]</summary>
  public uint size;
  /// <summary>the search used up its steps</summary>
  public int ended_early;
  /// <summary>fixed step; 0: none [s]</summary>
  public double step;
  /// <summary>as measured [m]</summary>
  public double error;
  /// <summary>operations for a second of flight [1/s]</summary>
  public double cost;
  /// <summary>of the reference [1/s]</summary>
  public double truth_cost;
  /// <summary>in words</summary>
  public fixed byte explanation[256];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_study_info {
  /// <summary>sizeof(physim_study_info) [bytes]</summary>
  public uint size;
  /// <summary>shots of a shard</summary>
  public uint shard_shots;
  /// <summary>of the whole study</summary>
  public ulong shards;
  /// <summary>uncertain numbers</summary>
  public UIntPtr inputs;
  public UIntPtr targets;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_figures_info {
  /// <summary>sizeof(physim_figures_info) [bytes]</summary>
  public uint size;
  /// <summary>the radii below count</summary>
  public int has_plane;
  /// <summary>flown</summary>
  public ulong shots;
  /// <summary>of them</summary>
  public ulong refused;
  /// <summary>of them</summary>
  public ulong not_arrived;
  public UIntPtr quantities;
  public UIntPtr targets;
  /// <summary>from the aim [m]</summary>
  public double mean_radius;
  /// <summary>half of the shots lie within, about the aim [m]</summary>
  public double r50;
  /// <summary>[m]</summary>
  public double r90;
  /// <summary>that they are of</summary>
  public ulong shards;
  /// <summary>physim_study_set_width() ended it</summary>
  public int width_reached;
  /// <summary>the time of physim_study_run() ended it</summary>
  public int time_was_up;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_quantity {
  /// <summary>sizeof(physim_quantity) [bytes]</summary>
  public uint size;
  /// <summary>physim_name("quantity", quantity)</summary>
  public int quantity;
  /// <summary>[unit of the quantity]</summary>
  public double mean;
  /// <summary>standard error of the mean [unit of the quantity]</summary>
  public double error;
  /// <summary>[unit of the quantity]</summary>
  public double deviation;
  /// <summary>[unit of the quantity]</summary>
  public double least;
  /// <summary>[unit of the quantity]</summary>
  public double most;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_chance {
  /// <summary>sizeof(physim_chance) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>its name, as long as the figures stay</summary>
  public byte* target;
  public ulong hits;
  public double probability;
  /// <summary>standard error</summary>
  public double error;
  /// <summary>of the 95 % interval</summary>
  public double low;
  public double high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_world_info {
  /// <summary>sizeof(physim_world_info) [bytes]</summary>
  public uint size;
  /// <summary>there are</summary>
  public uint joints;
  /// <summary>of the world [s]</summary>
  public double time;
  /// <summary>of a step that physim_world_advance() left over</summary>
  public double fraction;
  /// <summary>of a frame [s]</summary>
  public double step;
  /// <summary>within the scenario's duration; 0 if nothing fires by itself</summary>
  public ulong planned_steps;
  /// <summary>alive</summary>
  public UIntPtr projectiles;
  /// <summary>of the last step, and of calls since</summary>
  public UIntPtr events;
  /// <summary>generators</summary>
  public UIntPtr forces;
  /// <summary>[bytes]</summary>
  public UIntPtr memory;
  /// <summary>taken</summary>
  public ulong steps;
  public ulong projectile_steps;
  /// <summary>not spawned</summary>
  public ulong refused;
  /// <summary>of calls between steps</summary>
  public ulong dropped_events;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_projectile {
  /// <summary>sizeof(physim_projectile) [bytes]</summary>
  public uint size;
  /// <summary>physim_name("life", life): "in_flight", "landed", ...</summary>
  public int life;
  public uint kind;
  public uint layers;
  /// <summary>RGBA</summary>
  public uint colour;
  public int asleep;
  public ulong user_data;
  /// <summary>since launch [s]</summary>
  public double age;
  /// <summary>[kg]</summary>
  public double mass;
  public double mach;
  /// <summary>[m]</summary>
  public fixed double position[3];
  /// <summary>[m/s]</summary>
  public fixed double velocity[3];
  /// <summary>by all that acts on it [m/s^2]</summary>
  public fixed double acceleration[3];
  /// <summary>w, x, y, z</summary>
  public fixed double orientation[4];
  /// <summary>[rad/s]</summary>
  public fixed double angular_velocity[3];
}
/// <summary>Columns of projectiles; null: not wanted. Vectors are three numbers side by side, orientations four.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_states {
  /// <summary>sizeof(physim_states) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>from one row to the next in each column, as of a struct of one's own; 0: no gaps [bytes]</summary>
  public UIntPtr stride;
  public physim_id* id;
  /// <summary>[m]</summary>
  public double* position;
  /// <summary>[m/s]</summary>
  public double* velocity;
  /// <summary>rounded to float [m]</summary>
  public float* position_f;
  /// <summary>rounded to float [m/s]</summary>
  public float* velocity_f;
  /// <summary>position before the last step; only read [m]</summary>
  public double* previous;
  /// <summary>position to draw, between steps; only read [m]</summary>
  public double* shown;
  /// <summary>rounded to float; only read [m]</summary>
  public float* shown_f;
  /// <summary>in the world frame, of what turns [rad/s]</summary>
  public double* angular_velocity;
  /// <summary>w, x, y, z; only read</summary>
  public double* orientation;
  public ulong* user_data;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_hit_question {
  /// <summary>that struck</summary>
  public physim_id projectile;
  /// <summary>that was struck</summary>
  public physim_id thing;
  /// <summary>of the projectile</summary>
  public uint kind;
  /// <summary>of the thing: triangle or part</summary>
  public uint primitive;
  /// <summary>of it</summary>
  public uint material;
  /// <summary>it was inside when the step began</summary>
  public int inside;
  /// <summary>of the world [s]</summary>
  public double time;
  /// <summary>[m]</summary>
  public fixed double position[3];
  /// <summary>with which it came [m/s]</summary>
  public fixed double velocity[3];
  /// <summary>of the surface, towards the projectile</summary>
  public fixed double normal[3];
  /// <summary>[m/s]</summary>
  public fixed double surface_velocity[3];
  /// <summary>as seen from the surface [J]</summary>
  public double energy;
  /// <summary>0 straight on [rad]</summary>
  public double obliquity;
  /// <summary>of the thing along its way; 0: not known [m]</summary>
  public double thickness;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_hit_answer {
  /// <summary>physim_on_hit; PHYSIM_HIT_STOPS as it comes</summary>
  public int then;
  /// <summary>the velocity below counts, of what passes or bounces</summary>
  public int has_velocity;
  /// <summary>after the hit [m/s]</summary>
  public fixed double velocity[3];
}
/// <summary>A question to an engine's own physics: the first hit of each segment.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_engine_batch {
  /// <summary>segments</summary>
  public UIntPtr count;
  /// <summary>none is without length</summary>
  public physim_segment* segments;
  /// <summary>of each, empty as it comes: to be filled if it meets something</summary>
  public physim_hit* hits;
  /// <summary>bits: things of these</summary>
  public uint layers;
  public uint reserved;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_force_batch {
  /// <summary>projectiles that the force acts on</summary>
  public UIntPtr count;
  /// <summary>of the world [s]</summary>
  public double time;
  public physim_id* id;
  /// <summary>three for each [m]</summary>
  public double* position;
  /// <summary>three for each [m/s]</summary>
  public double* velocity;
  /// <summary>[kg]</summary>
  public double* mass;
  /// <summary>three for each: to be added to [N]</summary>
  public double* force;
}
/// <summary>Functions that a save or a recording lacks, in the order in which they were added.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_functions {
  /// <summary>sizeof(physim_functions) [bytes]</summary>
  public uint size;
  /// <summary>number of force functions</summary>
  public uint forces;
  public IntPtr* force;
  /// <summary>of each</summary>
  public IntPtr* force_user;
  public IntPtr hit;
  public IntPtr hit_user;
  /// <summary>of the environment</summary>
  public IntPtr wind;
  public IntPtr wind_user;
  /// <summary>of the environment</summary>
  public IntPtr field;
  public IntPtr field_user;
  /// <summary>of the scene</summary>
  public IntPtr engine;
  public IntPtr engine_user;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_replay_info {
  /// <summary>sizeof(physim_replay_info) [bytes]</summary>
  public uint size;
  /// <summary>no difference was found</summary>
  public int agrees;
  /// <summary>the recording has its end; else it was cut</summary>
  public int complete;
  public uint reserved;
  /// <summary>made</summary>
  public ulong calls;
  /// <summary>taken</summary>
  public ulong steps;
  /// <summary>compared, and equal</summary>
  public ulong hashes;
  /// <summary>of the world at the end</summary>
  public ulong hash;
  /// <summary>the first; empty: none</summary>
  public fixed byte difference[256];
}
/// <summary>Before a projectile is drawn.</summary>
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_canvas_begin(IntPtr user, physim_id projectile);
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_canvas_line(IntPtr user, double* a, double* b, int ink);
/// <summary>Counterclockwise as seen from outside.</summary>
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_canvas_triangle(IntPtr user, double* a, double* b, double* c, int ink);
/// <summary>Null: three circles of lines.</summary>
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_canvas_ball(IntPtr user, double* middle, double radius, int ink);
[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
public unsafe delegate void physim_canvas_text(IntPtr user, double* place, string text);
/// <summary>A canvas: a table of functions, each of which may be null. Places have three numbers, x, y and z in W [m].</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_canvas {
  /// <summary>sizeof(physim_canvas) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>handed to each function</summary>
  public IntPtr user;
  /// <summary>a physim_canvas_begin</summary>
  public IntPtr begin;
  /// <summary>a physim_canvas_line</summary>
  public IntPtr line;
  /// <summary>a physim_canvas_triangle</summary>
  public IntPtr triangle;
  /// <summary>a physim_canvas_ball</summary>
  public IntPtr ball;
  /// <summary>a physim_canvas_text</summary>
  public IntPtr text;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_drawing {
  /// <summary>sizeof(physim_drawing) [bytes]</summary>
  public uint size;
  /// <summary>bits: projectiles of these</summary>
  public uint layers;
  /// <summary>the scene is not drawn</summary>
  public int without_things;
  public int without_joints;
  /// <summary>are drawn at projectiles that have one, and names at things</summary>
  public int labels;
  /// <summary>of the trees of things</summary>
  public int boxes;
  /// <summary>half of the cross of a point; 0: none [m]</summary>
  public double point_size;
  /// <summary>duration of the drawn lines of velocities; 0: none [s]</summary>
  public double ahead;
  /// <summary>length of the drawn normals of contacts; 0: none [m]</summary>
  public double normals;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_transform {
  /// <summary>sizeof(physim_transform) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>of the origin [m]</summary>
  public fixed double position[3];
  /// <summary>w, x, y, z, of any length; all 0: none</summary>
  public fixed double rotation[4];
  /// <summary>0: 1</summary>
  public double scale;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_motion {
  /// <summary>sizeof(physim_motion) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>time at which the thing is where its transform puts it [s]</summary>
  public double start;
  /// <summary>[m/s]</summary>
  public fixed double velocity[3];
  /// <summary>about its own origin [rad/s]</summary>
  public fixed double angular_velocity[3];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_segment {
  /// <summary>[m]</summary>
  public fixed double from[3];
  /// <summary>[m]</summary>
  public fixed double to[3];
  /// <summary>of a ball about each point [m]</summary>
  public double radius;
  /// <summary>at which it begins [s]</summary>
  public double time;
  /// <summary>that its way takes; 0: things stand as at that time [s]</summary>
  public double duration;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_hit {
  /// <summary>index 0: nothing was met</summary>
  public physim_id thing;
  /// <summary>triangle of a mesh or height field, part of a compound</summary>
  public uint primitive;
  public uint material;
  /// <summary>from outside to inside</summary>
  public int entering;
  public int starts_inside;
  /// <summary>of the segment, 0 to 1</summary>
  public double part;
  /// <summary>[s]</summary>
  public double time;
  /// <summary>[m]</summary>
  public fixed double position[3];
  /// <summary>of the surface, outwards</summary>
  public fixed double normal[3];
  /// <summary>of the surface there [m/s]</summary>
  public fixed double velocity[3];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_nearest {
  /// <summary>sizeof(physim_nearest) [bytes]</summary>
  public uint size;
  public uint material;
  public physim_id thing;
  /// <summary>0 inside of a solid [m]</summary>
  public double distance;
  /// <summary>on the surface [m]</summary>
  public fixed double position[3];
  /// <summary>unit vector from the surface to the point</summary>
  public fixed double away[3];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_engine_info {
  /// <summary>sizeof(physim_engine_info) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>of its function</summary>
  public ulong calls;
  /// <summary>in these</summary>
  public ulong segments;
  /// <summary>answers that made no sense: nothing was met</summary>
  public ulong refused;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_projectile_hit {
  /// <summary>of the projectile</summary>
  public physim_id id;
  /// <summary>of the way, 0 to 1</summary>
  public double part;
  /// <summary>of the point or ball that is cast, then [m]</summary>
  public fixed double position[3];
  /// <summary>from the projectile's middle to that, of length 1</summary>
  public fixed double normal[3];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_emitter_info {
  /// <summary>sizeof(physim_emitter_info) [bytes]</summary>
  public uint size;
  /// <summary>particles now</summary>
  public uint alive;
  /// <summary>it may fire on its own</summary>
  public int playing;
  public uint reserved;
  /// <summary>since it was added</summary>
  public ulong born;
  /// <summary>full, or the world did not take them</summary>
  public ulong refused;
  /// <summary>gone on the ground or on a thing</summary>
  public ulong landed;
  /// <summary>gone by age, rules, calls or newer ones</summary>
  public ulong gone;
}
/// <summary>Columns of particles for a renderer; null: not wanted.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_particles {
  /// <summary>sizeof(physim_particles) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>from one row to the next in each column; 0: no gaps [bytes]</summary>
  public UIntPtr stride;
  public physim_id* id;
  /// <summary>three for each [m]</summary>
  public double* position;
  /// <summary>three for each [m]</summary>
  public double* previous;
  /// <summary>three for each [m/s]</summary>
  public double* velocity;
  /// <summary>three for each, by its own axes [m]</summary>
  public double* extent;
  /// <summary>three for each, about its axes [rad]</summary>
  public double* rotation;
  /// <summary>[s]</summary>
  public double* age;
  /// <summary>of the particle among those of its emitter</summary>
  public ulong* number;
  /// <summary>RGBA</summary>
  public uint* colour;
  /// <summary>a place: rows come from the farthest of it to the nearest; null: by index [m]</summary>
  public double* eye;
}
/// <summary>Past places of particles (emitter.trail); null: not wanted. Rows of a particle, then rows of places: of one particle after the other, from the oldest to where it is now.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_trails {
  /// <summary>sizeof(physim_trails) [bytes]</summary>
  public uint size;
  public uint reserved;
  /// <summary>of each particle</summary>
  public physim_id* id;
  /// <summary>of each particle: which of all places is its first one</summary>
  public uint* first;
  /// <summary>of each particle: how many places it has</summary>
  public uint* count;
  /// <summary>three for each place [m]</summary>
  public double* position;
  /// <summary>of each place: when the particle was there [s]</summary>
  public double* time;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_joint {
  /// <summary>sizeof(physim_joint) [bytes]</summary>
  public uint size;
  /// <summary>physim_joint_kind</summary>
  public int kind;
  /// <summary>one end</summary>
  public physim_id a;
  /// <summary>the other end; none: the point</summary>
  public physim_id b;
  /// <summary>[m]</summary>
  public fixed double point[3];
  /// <summary>0: as far as its ends are apart; a spring's may be DBL_MIN, which is none [m]</summary>
  public double length;
  /// <summary>of a cable, 0 to 1</summary>
  public double restitution;
  /// <summary>of a spring [N/m]</summary>
  public double stiffness;
  /// <summary>of a spring [kg/s]</summary>
  public double damping;
  /// <summary>it ends if it pulls or pushes with more, on the mean of a step; 0: it never breaks [N]</summary>
  public double break_force;
  /// <summary>of its point, if that is no thing's [m/s]</summary>
  public fixed double velocity[3];
  /// <summary>that takes the point along; index 0: none</summary>
  public physim_id thing;
  /// <summary>of a hinge or slider, of any length but zero</summary>
  public fixed double axis[3];
  /// <summary>of a slider [m], of a hinge -pi to pi [rad]; -INFINITY: none</summary>
  public double low;
  /// <summary>above low; INFINITY: none; both 0: no limits [m], [rad]</summary>
  public double high;
  /// <summary>of a hinge: direction of angle 0; zero: where a is now</summary>
  public fixed double reference[3];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_joint_info {
  /// <summary>sizeof(physim_joint_info) [bytes]</summary>
  public uint size;
  public int taut;
  /// <summary>distance of its ends [m]</summary>
  public double length;
  /// <summary>negative: it pushed [N]</summary>
  public double tension;
  /// <summary>with which it acted on its ends, on the mean of the last step [N]</summary>
  public double force;
  /// <summary>of a hinge [rad]</summary>
  public double angle;
  /// <summary>of a slider [m]</summary>
  public double way;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct physim_joint_event {
  /// <summary>physim_name("joint_event", kind)</summary>
  public int kind;
  public uint reserved;
  public physim_id joint;
  /// <summary>the one that left, else the first end</summary>
  public physim_id projectile;
  /// <summary>[s]</summary>
  public double time;
  /// <summary>at which the ends parted [m/s]</summary>
  public double speed;
}
public static unsafe class C {
  const string Library = "physim_c";
  /// <summary>"0.2.0".</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern IntPtr physim_version();
  /// <summary>The last error of this thread: "place: error: message; hint". Empty: there was none.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern IntPtr physim_last_error();
  /// <summary>Its place: a setting, a member, "file:line:column"; may be empty.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern IntPtr physim_last_place();
  /// <summary>Its correction; may be empty.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern IntPtr physim_last_hint();
  /// <summary>Gives back anything that a call made. A null pointer is fine. What others still need stays as long as they need it.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_free(IntPtr handle);
  /// <summary>The bytes of a handle, which stay until it is freed.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_bytes_data(IntPtr bytes, IntPtr* data, UIntPtr* size);
  /// <summary>A world (of a scenario: with what it has still to fire), a scene, or a part of a study as bytes.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_save(IntPtr handle, out IntPtr bytes);
  /// <summary>Threads for batches, casts and studies; `threads` counts the caller's own, 0: all that the machine has.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_pool_create(uint threads, out IntPtr pool);
  /// <summary>The name of a value of an enumeration of results: "outcome", "event", "crossing", "reason", "life", "joint_event", "quantity" (of studies). Null: there is no such value, or no such enumeration.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern IntPtr physim_name(string enumeration, int value);
  /// <summary>Settings, as a scenario file has them. `text`: of a file; null: one shot with nothing but defaults. `file` names it in errors, and other files are looked for beside it; null: the current folder.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_def_create(string text, string file, out IntPtr def);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_def_load(string file, out IntPtr def);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_def_copy(IntPtr def, out IntPtr copy);
  /// <summary>Sets a setting by its path, "environment.wind.velocity", to what stands right of "=" in a file or of `--set`: "170 gr", "g7", "[0, 0, 4]". One shot is "shot.NAME.mass" or, by its number, "shot.2.mass"; an element of a list is "thing.2.position", and the number that follows the last one adds an element. "drag.table" is "shot.drag.table". The value is checked by itself at once, and with all others where it is used.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_set(IntPtr def, string path, string value);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_set_number(IntPtr def, string path, double value);
  /// <summary>Writes the value of a setting, default or not, in SI, up to `room` bytes with the 0 at its end; `length` (may be null) is that of the whole value without it. PHYSIM_NOT_FOUND: the setting has no value here.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_get(IntPtr def, string path, byte* into, UIntPtr room, UIntPtr* length);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_get_number(IntPtr def, string path, double* value);
  /// <summary>The number of elements of a list of tables: "shot", "thing", "shot.1.drag.bands".</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_count(IntPtr def, string path, UIntPtr* count);
  /// <summary>Checks all settings together.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_check(IntPtr def);
  /// <summary>The settings that differ from their defaults, as the text of a file; as physim_get() writes.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_text(IntPtr def, byte* into, UIntPtr room, UIntPtr* length);
  /// <summary>The number of all settings, and one of them by its index from 0. Texts stay for ever.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern UIntPtr physim_setting_count();
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_setting_at(UIntPtr index, physim_setting* setting);
  /// <summary>Wind by place and time, for fidelity wind = "profile", and a force on all projectiles in motion "force". Each answer depends on its own row alone; the function is called from any thread, any number of times, as long as something that was made of the def is there. Null: none. physim_world_set_environment() brings it into a world.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_set_wind_function(IntPtr def, physim_wind_function function, IntPtr user);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_set_field_function(IntPtr def, physim_field_function function, IntPtr user);
  /// <summary>Flies a shot of a def, by its name or its number from 1 ("2"); null: the first. `launch` may be null.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_fly(IntPtr def, string shot, physim_launch* launch, out IntPtr flight);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_flight_read(IntPtr flight, physim_flight_info* info);
  /// <summary>The state at a moment. PHYSIM_NOT_FOUND: the flight never came there.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_flight_at(IntPtr flight, physim_moment moment, double value, physim_sample* sample);
  /// <summary>The jerk at a time since launch [s]: the change of acceleration along the path, in the world frame [m/s^3].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_flight_jerk(IntPtr flight, double time, double* jerk);
  /// <summary>States at `count` times [s]; null: evenly from the start to the end, both included.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_flight_samples(IntPtr flight, double* times, UIntPtr count, physim_samples* into);
  /// <summary>Events from number `first` on, up to `room` of them; `count` is how many were written. `each`: sizeof(physim_event).</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_flight_events(IntPtr flight, UIntPtr first, physim_event* into, UIntPtr each, UIntPtr room, UIntPtr* count);
  /// <summary>The rungs of the fidelity that were not granted, a line each: "effect: asked, granted: reason"; as physim_get() writes.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_flight_notes(IntPtr flight, byte* into, UIntPtr room, UIntPtr* length);
  /// <summary>Flies `count` launches of a shot, with the numbers of physim_fly(). `weather`, `pool` and `info` may be null.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_batch(IntPtr def, string shot, UIntPtr count, physim_launches* launches, physim_weather* weather, physim_ends* into, IntPtr pool, physim_batch_info* info);
  /// <summary>Finds the directions that hit a target; null: that of the def ([target]). Out of reach is no error.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_aim(IntPtr def, string shot, physim_target* target, physim_aim_info* info);
  /// <summary>Finds the elevation that carries farthest over even ground, which lies at the height `ground` [m] and rises with `slope` [rad] in the direction of fire. Refused if the shot does not come down within `time` [s]; 0: 3600.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_max_range(IntPtr def, string shot, double ground, double slope, double time, physim_farthest* info);
  /// <summary>Finds the motions that have three known quantities; the other two of `given` are NaN. `into` has room for two; `count` is how many there are, by rising time. Refused if none has them, or any number of motions.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_suvat(physim_straight* given, physim_straight* into, UIntPtr* count);
  /// <summary>Flies a shot at `count` presets of fidelity ("game", "simulation", ...) and measures how far each comes from the reference, which `reference` (may be null) becomes. `each`: sizeof(physim_compared).</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_compare(IntPtr def, string shot, IntPtr* fidelities, UIntPtr count, physim_compared* rows, UIntPtr each, out IntPtr reference);
  /// <summary>Fits the drag of a shot to measurements. `fitted` (may be null) becomes a def whose shot is the fitted one.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_fit(IntPtr def, string shot, physim_measurement* measurements, UIntPtr count, physim_fit_options* options, physim_fit_info* info, out IntPtr fitted);
  /// <summary>Finds the cheapest fidelity of a shot within an error of the reference. `chosen` (may be null) becomes a def whose shot has it.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_choose_fidelity(IntPtr def, string shot, physim_purpose* purpose, physim_fidelity_info* info, out IntPtr chosen);
  /// <summary>Checks and prepares the study of a shot ([study], and distributions in the place of numbers).</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_study_create(IntPtr def, string shot, out IntPtr study);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_study_read(IntPtr study, physim_study_info* info);
  /// <summary>Flies shards first, first + 1, ...: their bits depend on study and number alone, on any machine. `pool` may be null.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_study_fly(IntPtr study, ulong first, ulong count, IntPtr pool, out IntPtr part);
  /// <summary>Ends a study earlier, where the 95 % interval of a figure is no wider than `width`: of the hit probability of a target [-], by its name; null: of the mean of quantity `quantity` [unit of the quantity]. 0: it ends with its shots.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_study_set_width(IntPtr study, string target, UIntPtr quantity, double width);
  /// <summary>Flies what `so_far` (may be null) lacks, until the study ends, or for some time [s]; 0: as long as it takes. `part` (may be null) becomes all that was flown, to go on with, and `figures` (may be null) what came out.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_study_run(IntPtr study, IntPtr so_far, double seconds, IntPtr pool, out IntPtr part, out IntPtr figures);
  /// <summary>Joins two parts of one study, in any order.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_part_join(IntPtr a, IntPtr b, out IntPtr joined);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_part_load(IntPtr data, UIntPtr size, out IntPtr part);
  /// <summary>The figures of the first `shards` of a part; 0: of all of the study.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_study_figures(IntPtr study, IntPtr part, ulong shards, out IntPtr figures);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_figures_read(IntPtr figures, physim_figures_info* info);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_figures_quantity(IntPtr figures, UIntPtr index, physim_quantity* quantity);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_figures_target(IntPtr figures, UIntPtr index, physim_chance* chance);
  /// <summary>The number that a part 0 to 1 of all shots lies below, of a quantity [unit of the quantity].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_figures_quantile(IntPtr figures, UIntPtr index, double part, double* value);
  /// <summary>A world with the environment, [world] and things of a def.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_create(IntPtr def, physim_firing firing, out IntPtr world);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_read(IntPtr world, physim_world_info* info);
  /// <summary>A hash of all that decides what happens next.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_hash(IntPtr world, ulong* hash);
  /// <summary>The environment of a def from the next step on, in the place of environment `index`; 0 is that of all kinds that were added without another.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_set_environment(IntPtr world, uint index, IntPtr def);
  /// <summary>Another place to fly in, for physim_world_add_kind().</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_add_environment(IntPtr world, IntPtr def, uint* index);
  /// <summary>The levels of detail of a def (world.detail).</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_set_detail(IntPtr world, IntPtr def);
  /// <summary>The place that levels of detail go by (world.detail) [m].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_set_observer(IntPtr world, double* position);
  /// <summary>Prepares a shot of a def as a kind of projectile that flies in an environment of the world; `flags`: 0 or PHYSIM_ASK_HITS.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_add_kind(IntPtr world, IntPtr def, string shot, uint environment, uint flags, uint* kind);
  /// <summary>Projectiles of a kind, launched as its shot says but for `launches` (may be null). Ids (may be null) are null of what was refused; `spawned` (may be null) counts the others.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_spawn(IntPtr world, uint kind, UIntPtr count, physim_launches* launches, physim_id* ids, UIntPtr* spawned);
  /// <summary>Continues a flight from one of its times on [s].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_spawn_flight(IntPtr world, IntPtr flight, double time, physim_id* id);
  /// <summary>A projectile of a shot that is on its way already, `age` after its launch [s].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_spawn_moving(IntPtr world, IntPtr def, string shot, double* position, double* velocity, double age, physim_id* id);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_despawn(IntPtr world, physim_id* ids, UIntPtr count, UIntPtr* gone);
  /// <summary>Takes `count` steps of dt [s]; 0: of the world's own step, as a world that fires by itself takes them.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_step(IntPtr world, ulong count, double dt);
  /// <summary>Real time has passed [s]: as many steps as fit; `steps` may be null. Not for worlds that fire by themselves.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_advance(IntPtr world, double seconds, uint* steps);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_do(IntPtr world, physim_world_action action, double value);
  /// <summary>Events of the last step, and of calls since, as physim_flight_events() writes them.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_events(IntPtr world, UIntPtr first, physim_event* into, UIntPtr each, UIntPtr room, UIntPtr* count);
  /// <summary>Reads the projectiles `ids`; if `ids` is null, all that are alive, in the order of memory, which is faster: the column `id` names them. Rows are filled up to `count`; `read` (may be null) is the number of projectiles. Rows of projectiles that are gone are zero.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_states(IntPtr world, physim_id* ids, UIntPtr count, physim_states* into, UIntPtr* read);
  /// <summary>Writes positions, velocities, angular velocities and user data of projectiles; `written` (may be null) counts those that took them.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_put(IntPtr world, physim_id* ids, UIntPtr count, physim_states* from, UIntPtr* written);
  /// <summary>Adds an impulse to each, three numbers [N s].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_push(IntPtr world, physim_id* ids, UIntPtr count, double* impulses, UIntPtr* pushed);
  /// <summary>Puts projectiles to sleep, or wakes them: `sleep` 1 or 0. `changed` (may be null) counts those that were not so before.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_rest(IntPtr world, physim_id* ids, UIntPtr count, int sleep, UIntPtr* changed);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_projectile(IntPtr world, physim_id id, physim_projectile* into);
  /// <summary>The jerk of a projectile now: the change of its acceleration along its path, in the world frame [m/s^3].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_jerk(IntPtr world, physim_id id, double* jerk);
  /// <summary>A setting of one projectile in flight: those that are live ("mass", "drag.k1", "body.gravity_scale"), and all of "fidelity". Reads any setting of its shot and body.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_set(IntPtr world, physim_id id, string path, string value);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_get(IntPtr world, physim_id id, string path, byte* into, UIntPtr room, UIntPtr* length);
  /// <summary>The flight of a projectile from now on, until the ground or for a time [s].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_predict(IntPtr world, physim_id id, double time, out IntPtr flight);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_snapshot(IntPtr world, out IntPtr snapshot);
  /// <summary>Back to a moment of this world, bit for bit; refused for a snapshot of another one.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_restore(IntPtr world, IntPtr snapshot);
  /// <summary>The world of a save. `def`: of a world that fires by itself, the one that it was made of, with its functions; else null. `functions` may be null. Kinds and names are given again: physim_world_add_kind() finds the kind that is there.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_load(IntPtr data, UIntPtr size, IntPtr def, physim_functions* functions, out IntPtr world);
  /// <summary>Records every call that changes the world, with a hash every `hash_every` steps (0: none). The recording of a world to which something was done already, as of one with a scene, begins with a save.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_record(IntPtr world, uint hash_every);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_stop_recording(IntPtr world, out IntPtr recording);
  /// <summary>Makes all calls of a recording again, and compares. `functions` may be null.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_replay(IntPtr recording, UIntPtr size, physim_functions* functions, physim_replay_info* info);
  /// <summary>A world that a recording moves on, as it was before the first call. It is only read; its snapshots go to no other.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_replay_open(IntPtr recording, UIntPtr size, physim_functions* functions, out IntPtr world);
  /// <summary>Makes the calls of the recording up to and with `frames` more that took steps; 0: the next call alone. `more` (may be null) is 0 if the recording ended, or a difference was found. `info` (may be null): all that was done so far.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_replay_next(IntPtr world, ulong frames, int* more, physim_replay_info* info);
  /// <summary>Goes to where physim_replay_info.steps is `steps`, back or forwards: behind the call that took that step; 0: to the beginning. `there` (may be null) is 0 if the recording ended, or a difference was found, before.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_replay_seek(IntPtr world, ulong steps, int* there, physim_replay_info* info);
  /// <summary>Draws a world: its things, its projectiles as they are drawn between steps, joints, and what was hit in the last step. Numbers from 0 to 1e9. The world must not be changed inside.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_draw(IntPtr world, physim_drawing* what, physim_canvas* canvas);
  /// <summary>The things of a def.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_create(IntPtr def, out IntPtr scene);
  /// <summary>The scene of a save, with the ids that its things had; physim_scene_find() knows none of them. `functions` (may be null) has its engine, if it had one.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_load(IntPtr data, UIntPtr size, physim_functions* functions, out IntPtr scene);
  /// <summary>Lets an engine's own physics answer beside the things of a scene; null: it does not any more. A world has it with a copy of the scene. `skin`: things are met this far outside of their surfaces, 1e-6 to 0.1; 0: 0.001 [m].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_set_engine(IntPtr scene, physim_engine_function function, IntPtr user, double skin);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_read_engine(IntPtr scene, physim_engine_info* info);
  /// <summary>Gives a world a copy of a scene; null: it has none any more.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_set_scene(IntPtr world, IntPtr scene);
  /// <summary>Adds all things of a def, with their shapes and materials; ids of up to `room` of them. In a world this costs as much as setting its scene.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_add(IntPtr scene, IntPtr def, physim_id* ids, UIntPtr room, UIntPtr* count);
  /// <summary>Adds another thing like one that is there, at another place.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_copy(IntPtr scene, physim_id like, physim_transform* to, physim_id* id);
  /// <summary>The first thing of a name among those that defs brought. PHYSIM_NOT_FOUND: none has it.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_find(IntPtr scene, string name, physim_id* id);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_move(IntPtr scene, physim_id thing, physim_transform* to);
  /// <summary>Lets a thing move steadily; null: it rests where its transform puts it.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_set_motion(IntPtr scene, physim_id thing, physim_motion* motion);
  /// <summary>Bits that kinds and queries choose things by.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_set_layers(IntPtr scene, physim_id thing, uint layers);
  /// <summary>Lets the surface of a thing run as a conveyor's, in the thing's own frame [m/s]; null: it stands.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_set_conveyor(IntPtr scene, physim_id thing, double* velocity);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_remove(IntPtr scene, physim_id thing);
  /// <summary>The first hit of each segment on things of these layers. `each`: sizeof(physim_hit). `pool` may be null.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_cast(IntPtr scene, physim_segment* segments, UIntPtr count, uint layers, physim_hit* hits, UIntPtr each, IntPtr pool);
  /// <summary>All that the points of one segment meet, up to `room`; `count` is how many there are.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_hits(IntPtr scene, physim_segment* segment, uint layers, physim_hit* hits, UIntPtr each, UIntPtr room, UIntPtr* count);
  /// <summary>The surface nearest to a point, within a distance [m], at a time [s]. PHYSIM_NOT_FOUND: none is that near.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_nearest(IntPtr scene, double* point, double within, uint layers, double time, physim_nearest* nearest);
  /// <summary>The things that a ball touches at a time [s], up to `room`; `count` is how many there are.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_scene_overlaps(IntPtr scene, double* middle, double radius, uint layers, double time, physim_id* ids, UIntPtr room, UIntPtr* count);
  /// <summary>Those that a ball touches, by index, up to `room`; `count` is how many there are.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_in_ball(IntPtr world, double* middle, double radius, uint layers, physim_id* ids, UIntPtr room, UIntPtr* count);
  /// <summary>Those that a box touches; `half`: half of its edges [m].</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_in_box(IntPtr world, physim_transform* at, double* half, uint layers, physim_id* ids, UIntPtr room, UIntPtr* count);
  /// <summary>Those that a ray touches, or a ball of the segment's radius, in order; its times are not looked at. `each`: sizeof(physim_projectile_hit).</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_cast(IntPtr world, physim_segment* segment, uint layers, physim_projectile_hit* hits, UIntPtr each, UIntPtr room, UIntPtr* count);
  /// <summary>Adds an [[emitter]] of a def, by its name or its number from 1. `follows` (may be null): a projectile that it sits on. Emitters that its subs name are added to this world first, of whatever def.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_add_emitter(IntPtr world, IntPtr def, string emitter, physim_id* follows, physim_id* id);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_emitter_do(IntPtr world, physim_id emitter, physim_emitter_action action, double value);
  /// <summary>`time` above that of the world: it is there then [s]; below 0: it is there at once, without a way to it; else it goes there in the course of the next step.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_emitter_move(IntPtr world, physim_id emitter, physim_transform* to, double time);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_emitter_read(IntPtr world, physim_id emitter, physim_emitter_info* info);
  /// <summary>Fills up to `room` rows; `count` is how many particles there are.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_emitter_particles(IntPtr world, physim_id emitter, UIntPtr room, physim_particles* into, UIntPtr* count);
  /// <summary>`particles` and `places` (not null) say for how many rows there is room, and become how many there are. `into` may be null, if both are 0.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_emitter_trails(IntPtr world, physim_id emitter, physim_trails* into, UIntPtr* particles, UIntPtr* places);
  /// <summary>Adds a [[force]] of a def, by its name or its number from 1: on these projectiles, or on those that it says itself if `count` is 0. `other` (may be null): the projectile at the other end of a spring or bungee.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_add_force(IntPtr world, IntPtr def, string force, physim_id* ids, UIntPtr count, physim_id* other, physim_id* id);
  /// <summary>A force of one's own on these projectiles, and on all of the layers.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_add_force_function(IntPtr world, physim_force_function function, IntPtr user, physim_id* ids, UIntPtr count, uint layers, physim_id* id);
  /// <summary>Null: none; refused while there are kinds that ask.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_set_hit_function(IntPtr world, physim_hit_function function, IntPtr user);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_add_joint(IntPtr world, physim_joint* joint, physim_id* id);
  /// <summary>Puts the point of a joint at a place now; from there it goes on at a velocity.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_joint_move(IntPtr world, physim_id joint, double* position, double* velocity);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_joint_read(IntPtr world, physim_id joint, physim_joint_info* info);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_joint_events(IntPtr world, physim_joint_event* into, UIntPtr each, UIntPtr room, UIntPtr* count);
  /// <summary>Takes projectiles out of the targets of a force; `released` (may be null) counts those that were among them.</summary>
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_release(IntPtr world, physim_id force, physim_id* ids, UIntPtr count, UIntPtr* released);
  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
  public static extern physim_result physim_world_remove(IntPtr world, physim_what what, physim_id id);
}
}
