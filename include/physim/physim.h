// The C interface of PhySim: C99, and C++. The guide is docs/c.md; settings are in docs/settings.md.
//
// Handles. Everything is made by a call that writes a handle, and given back by physim_free(). A handle is no address:
// one that is null, freed, or of another kind is refused by every call, and never followed.
//
// Errors. A call returns PHYSIM_OK or what went wrong. The texts of the last error of the calling thread stay until its
// next error. No exception leaves a call, and nothing ends the program. After an error outputs are as they were.
//
// Structs and columns. A struct that a call takes by itself begins with `size`, which the caller sets to the sizeof
// that the caller was compiled with; members behind it count as zero, and zero is always the default. Arrays of structs
// come with that size as `each`. Columns are the caller's memory, one number for each row; null: not wanted, or as
// defined.
//
// Threads. A handle that is only read may be used by any number of threads at once: flying and reading a physim_def,
// asking flights, scenes, figures, and a world between its steps. A call whose handle is not const changes what it
// names, and is the only one that uses it meanwhile. Callbacks of wind and force fields come from any thread; all
// others from the thread that steps. In a callback the world may be read and not changed.
//
// Units are SI; angles are in radians. The world frame has x downrange, y up, z to the right. Vectors are three
// doubles. The same calls give the same bits as in C++, on every machine.
#ifndef PHYSIM_H
#define PHYSIM_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(PHYSIM_C_BUILD)
#define PHYSIM_API __declspec(dllexport)
#elif defined(_WIN32)
#define PHYSIM_API __declspec(dllimport)
#elif defined(__GNUC__)
#define PHYSIM_API __attribute__((visibility("default")))
#else
#define PHYSIM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

// --------------------------------------------------------------------------------------------------- errors, handles

typedef enum physim_result {
  PHYSIM_OK = 0,
  PHYSIM_BAD_ARGUMENT = 1,   // a pointer that is null, a size that is 0, a number that is NaN
  PHYSIM_BAD_HANDLE = 2,     // null, freed, or of another kind
  PHYSIM_REFUSED = 3,        // what was asked makes no sense: the error says what, where, and what to do
  PHYSIM_NOT_FOUND = 4,      // nothing there: a range that a flight never reached, a thing of no such name
  PHYSIM_TOO_SMALL = 5,      // the text was cut; its length was written
  PHYSIM_OUT_OF_MEMORY = 6,  // nothing was made; a world that was being changed is lost
  PHYSIM_FAILED = 7,         // a mistake inside of the library
  PHYSIM_LOST = 8            // the world ran out of memory in the middle of a change; free it
} physim_result;

/// "0.2.0".
PHYSIM_API const char* physim_version(void);
/// The last error of this thread: "place: error: message; hint". Empty: there was none.
PHYSIM_API const char* physim_last_error(void);
/// Its place: a setting, a member, "file:line:column"; may be empty.
PHYSIM_API const char* physim_last_place(void);
/// Its correction; may be empty.
PHYSIM_API const char* physim_last_hint(void);

typedef struct physim_def physim_def;            // settings of shots, environment, world, scene, emitters, study
typedef struct physim_flight physim_flight;      // a computed trajectory
typedef struct physim_world physim_world;        // many projectiles in real time
typedef struct physim_snapshot physim_snapshot;  // a moment of a world
typedef struct physim_scene physim_scene;        // things to be hit
typedef struct physim_bytes physim_bytes;        // a save, a recording, a part of a study
typedef struct physim_pool physim_pool;          // threads
typedef struct physim_study physim_study;        // a study, checked and prepared
typedef struct physim_part physim_part;          // results of some of its shards
typedef struct physim_figures physim_figures;    // what came out of a study

/// Gives back anything that a call made. A null pointer is fine. What others still need stays as long as they need it.
PHYSIM_API physim_result physim_free(const void* handle);

/// The bytes of a handle, which stay until it is freed.
PHYSIM_API physim_result physim_bytes_data(const physim_bytes* bytes, const void** data, size_t* size);

/// A world (of a scenario: with what it has still to fire), a scene, or a part of a study as bytes.
PHYSIM_API physim_result physim_save(const void* handle, physim_bytes** bytes);

/// Threads for batches, casts and studies; `threads` counts the caller's own, 0: all that the machine has.
PHYSIM_API physim_result physim_pool_create(uint32_t threads, physim_pool** pool);

/// The name of a value of an enumeration of results: "outcome", "event", "crossing", "reason", "life", "joint_event",
/// "quantity" (of studies). Null: there is no such value, or no such enumeration.
PHYSIM_API const char* physim_name(const char* enumeration, int32_t value);

// ---------------------------------------------------------------------------------------------------------- settings

/// Settings, as a scenario file has them. `text`: of a file; null: one shot with nothing but defaults. `file` names it
/// in errors, and other files are looked for beside it; null: the current folder.
PHYSIM_API physim_result physim_def_create(const char* text, const char* file, physim_def** def);
PHYSIM_API physim_result physim_def_load(const char* file, physim_def** def);
PHYSIM_API physim_result physim_def_copy(const physim_def* def, physim_def** copy);

/// Sets a setting by its path, "environment.wind.velocity", to what stands right of "=" in a file or of `--set`: "170
/// gr", "g7", "[0, 0, 4]". One shot is "shot.NAME.mass" or, by its number, "shot.2.mass"; an element of a list is
/// "thing.2.position", and the number that follows the last one adds an element. "drag.table" is "shot.drag.table".
/// The value is checked by itself at once, and with all others where it is used.
PHYSIM_API physim_result physim_set(physim_def* def, const char* path, const char* value);
PHYSIM_API physim_result physim_set_number(physim_def* def, const char* path, double value);
/// Writes the value of a setting, default or not, in SI, up to `room` bytes with the 0 at its end; `length` (may be
/// null) is that of the whole value without it. PHYSIM_NOT_FOUND: the setting has no value here.
PHYSIM_API physim_result physim_get(const physim_def* def, const char* path, char* into, size_t room, size_t* length);
PHYSIM_API physim_result physim_get_number(const physim_def* def, const char* path, double* value);
/// The number of elements of a list of tables: "shot", "thing", "shot.1.drag.bands".
PHYSIM_API physim_result physim_count(const physim_def* def, const char* path, size_t* count);
/// Checks all settings together.
PHYSIM_API physim_result physim_check(const physim_def* def);
/// The settings that differ from their defaults, as the text of a file; as physim_get() writes.
PHYSIM_API physim_result physim_text(const physim_def* def, char* into, size_t room, size_t* length);

typedef struct physim_setting {
  uint32_t size;     ///< sizeof(physim_setting) [bytes]
  int32_t live;      ///< physim_world_set() changes it for one projectile in flight [-]
  const char* path;  ///< "shot.drag.ballistic_coefficient" [-]
  const char* type;  ///< "quantity", "integer", "boolean", "text", "choice", "vector", "points", "list", ... [-]
  const char* unit;  ///< SI unit, "" for none, "of the kind" where another setting decides [-]
  const char* default_value;  ///< "" if there is none [-]
  const char* range;          ///< "> 0", "0 .. 1", "off | constant | ..."; of lists: their length [-]
  const char* doc;            ///< one line [-]
} physim_setting;

/// The number of all settings, and one of them by its index from 0. Texts stay for ever.
PHYSIM_API size_t physim_setting_count(void);
PHYSIM_API physim_result physim_setting_at(size_t index, physim_setting* setting);

// ----------------------------------------------------------------------------------------- functions of one's own

typedef struct physim_wind_batch {
  size_t count;            ///< places [-]
  const double* time;      ///< since launch; in worlds, of the world [s]
  const double* position;  ///< three for each place [m]
  double* velocity;        ///< of the air, three for each, zero as it comes: to be filled [m/s]
} physim_wind_batch;
typedef void (*physim_wind_function)(void* user, const physim_wind_batch* batch);

typedef struct physim_field_batch {
  size_t count;            ///< projectiles [-]
  const double* time;      ///< since launch; in worlds, of the world [s]
  const double* position;  ///< three for each [m]
  const double* velocity;  ///< three for each [m/s]
  const double* mass;      ///< that is left [kg]
  double* force;           ///< three for each, zero as it comes: to be filled [N]
} physim_field_batch;
typedef void (*physim_field_function)(void* user, const physim_field_batch* batch);

/// Wind by place and time, for fidelity wind = "profile", and a force on all projectiles in motion "force". Each answer
/// depends on its own row alone; the function is called from any thread, any number of times, as long as something
/// that was made of the def is there. Null: none. physim_world_set_environment() brings it into a world.
PHYSIM_API physim_result physim_set_wind_function(physim_def* def, physim_wind_function function, void* user);
PHYSIM_API physim_result physim_set_field_function(physim_def* def, physim_field_function function, void* user);

// ----------------------------------------------------------------------------------------------------------- flights

enum {  // what of a physim_launch is given; all else is as the shot has it
  PHYSIM_POSITION = 1,
  PHYSIM_SPEED = 2,
  PHYSIM_ELEVATION = 4,
  PHYSIM_AZIMUTH = 8,
  PHYSIM_VELOCITY = 16  // instead of speed, elevation and azimuth
};

typedef struct physim_launch {
  uint32_t size;       ///< sizeof(physim_launch) [bytes]
  uint32_t given;      ///< PHYSIM_POSITION | ...: the members below that count [-]
  double position[3];  ///< of the muzzle [m]
  double velocity[3];  ///< [m/s]
  double speed;        ///< [m/s]
  double elevation;    ///< of the bore above the horizon [rad]
  double azimuth;      ///< of the plane of fire, to the right [rad]
} physim_launch;

typedef enum physim_outcome {
  PHYSIM_LANDED = 0,
  PHYSIM_REACHED_RANGE = 1,
  PHYSIM_EVENT = 2,
  PHYSIM_TIME_LIMIT = 3,
  PHYSIM_STEP_LIMIT = 4,
  PHYSIM_LEFT_DOMAIN = 5,
  PHYSIM_NON_FINITE = 6,
  PHYSIM_STALLED = 7,
  PHYSIM_WAS_REFUSED = 8,
  PHYSIM_HIT = 9
} physim_outcome;

typedef struct physim_flight_info {
  uint32_t size;        ///< sizeof(physim_flight_info) [bytes]
  int32_t outcome;      ///< physim_outcome [-]
  double duration;      ///< [s]
  double elevation;     ///< of the bore, as given or as found for the zero range [rad]
  double step;          ///< fixed step in use; 0: adaptive [s]
  int64_t steps;        ///< taken [-]
  int64_t evaluations;  ///< of the acceleration [-]
  size_t events;        ///< that happened [-]
} physim_flight_info;

typedef struct physim_sample {
  uint32_t size;               ///< sizeof(physim_sample) [bytes]
  uint32_t reserved;           ///< [-]
  double time;                 ///< since launch [s]
  double position[3];          ///< [m]
  double velocity[3];          ///< [m/s]
  double acceleration[3];      ///< [m/s^2]
  double speed;                ///< [m/s]
  double mach;                 ///< [-]
  double energy;               ///< kinetic [J]
  double mass;                 ///< [kg]
  double thrust;               ///< of the motor [N]
  double range;                ///< along the line of sight [m]
  double drop;                 ///< above the line of sight [m]
  double windage;              ///< right of the line of sight [m]
  double orientation[4];       ///< w, x, y, z: takes body axes into the world frame [-]
  double angular_velocity[3];  ///< along body axes [rad/s]
  double angle_of_attack;      ///< [rad]
} physim_sample;

typedef enum physim_moment {
  PHYSIM_AT_END = 0,
  PHYSIM_AT_TIME = 1,    // value: since launch [s]
  PHYSIM_AT_RANGE = 2,   // value: first crossing, along the line of sight [m]
  PHYSIM_AT_HEIGHT = 3,  // value: first crossing, above the origin [m]
  PHYSIM_AT_APEX = 4     // the first
} physim_moment;

/// Rows of samples, a column for each number; null: not wanted.
typedef struct physim_samples {
  uint32_t size;      ///< sizeof(physim_samples) [bytes]
  uint32_t reserved;  ///< [-]
  double* time;       ///< since launch [s]
  double* x;          ///< [m]
  double* y;          ///< [m]
  double* z;          ///< [m]
  double* vx;         ///< [m/s]
  double* vy;         ///< [m/s]
  double* vz;         ///< [m/s]
  double* speed;      ///< [m/s]
  double* mach;       ///< [-]
  double* range;      ///< along the line of sight [m]
  double* drop;       ///< above the line of sight [m]
  double* windage;    ///< right of the line of sight [m]
  double* energy;     ///< [J]
} physim_samples;

/// Names one of many in a world or a scene: projectiles, forces, joints, emitters, things. Index 0: none. As in C++,
/// ids are equal on every machine that makes the same calls, and do not say of which world they are.
typedef struct physim_id {
  uint32_t index;       ///< of its slot [-]
  uint32_t generation;  ///< of the slot's use [-]
} physim_id;

typedef struct physim_event {
  int32_t kind;        ///< physim_name("event", kind): "landed", "bounced", "hit", ... [-]
  int32_t direction;   ///< physim_name("crossing", direction) [-]
  int32_t reason;      ///< physim_name("reason", reason), of what left a world [-]
  uint32_t primitive;  ///< of what was hit: triangle or part [-]
  uint32_t material;   ///< of what was hit [-]
  physim_id id;        ///< projectile in a world [-]
  physim_id thing;     ///< that was hit; none: the ground [-]
  physim_id other;     ///< projectile that it met [-]
  uint32_t reserved;   ///< [-]
  double value;        ///< that was crossed, or a depth [unit of the kind]
  double time;         ///< since launch; in a world of the world [s]
  double position[3];  ///< [m]
  double velocity[3];  ///< [m/s]
  double normal[3];    ///< of what was hit, towards the projectile [-]
  double energy;       ///< lost to it [J]
} physim_event;

/// Flies a shot of a def, by its name or its number from 1 ("2"); null: the first. `launch` may be null.
PHYSIM_API physim_result physim_fly(const physim_def* def, const char* shot, const physim_launch* launch,
                                    physim_flight** flight);
PHYSIM_API physim_result physim_flight_read(const physim_flight* flight, physim_flight_info* info);
/// The state at a moment. PHYSIM_NOT_FOUND: the flight never came there.
PHYSIM_API physim_result physim_flight_at(const physim_flight* flight, physim_moment moment, double value,
                                          physim_sample* sample);
/// The jerk at a time since launch [s]: the change of acceleration along the path, in the world frame [m/s^3].
PHYSIM_API physim_result physim_flight_jerk(const physim_flight* flight, double time, double jerk[3]);
/// States at `count` times [s]; null: evenly from the start to the end, both included.
PHYSIM_API physim_result physim_flight_samples(const physim_flight* flight, const double* times, size_t count,
                                               const physim_samples* into);
/// Events from number `first` on, up to `room` of them; `count` is how many were written. `each`: sizeof(physim_event).
PHYSIM_API physim_result physim_flight_events(const physim_flight* flight, size_t first, physim_event* into,
                                              size_t each, size_t room, size_t* count);
/// The rungs of the fidelity that were not granted, a line each: "effect: asked, granted: reason"; as physim_get()
/// writes.
PHYSIM_API physim_result physim_flight_notes(const physim_flight* flight, char* into, size_t room, size_t* length);

// ----------------------------------------------------------------------------------------------------------- batches

/// Columns of launches, each of as many numbers as there are launches; null: all as the shot has it.
typedef struct physim_launches {
  uint32_t size;                        ///< sizeof(physim_launches) [bytes]
  uint32_t reserved;                    ///< [-]
  const double* x;                      ///< of the muzzle [m]
  const double* y;                      ///< [m]
  const double* z;                      ///< [m]
  const double* speed;                  ///< [m/s]
  const double* elevation;              ///< [rad]
  const double* azimuth;                ///< [rad]
  const double* ballistic_coefficient;  ///< batches only [kg/m^2]
  const double* form_factor;            ///< batches only [-]
  const double* delay;                  ///< worlds only: it is launched so much later [s]
} physim_launches;

typedef struct physim_weather {
  uint32_t size;              ///< sizeof(physim_weather) [bytes]
  int32_t moves_profile;      ///< the wind below moves the points of the profile [-]
  const double* wind_x;       ///< [m/s]
  const double* wind_y;       ///< [m/s]
  const double* wind_z;       ///< [m/s]
  const double* temperature;  ///< at the station [K]
  const double* pressure;     ///< at the station [Pa]
  const double* humidity;     ///< at the station [-]
  const double* density;      ///< at the origin [kg/m^3]
} physim_weather;

typedef struct physim_ends {
  uint32_t size;      ///< sizeof(physim_ends) [bytes]
  uint32_t reserved;  ///< [-]
  int32_t* outcome;   ///< physim_outcome [-]
  double* time;       ///< of flight; NaN of a shot that was refused, as all others [s]
  double* x;          ///< of the end [m]
  double* y;          ///< [m]
  double* z;          ///< [m]
  double* vx;         ///< at the end [m/s]
  double* vy;         ///< [m/s]
  double* vz;         ///< [m/s]
  double* speed;      ///< [m/s]
  double* drop;       ///< above the line of sight [m]
  double* windage;    ///< right of the line of sight [m]
} physim_ends;

typedef struct physim_batch_info {
  uint32_t size;          ///< sizeof(physim_batch_info) [bytes]
  uint32_t reserved;      ///< [-]
  uint64_t refused;       ///< shots [-]
  char kernel[16];        ///< instruction set that flew them [-]
  char first_error[256];  ///< of the first shot that was refused; empty: none was [-]
} physim_batch_info;

/// Flies `count` launches of a shot, with the numbers of physim_fly(). `weather`, `pool` and `info` may be null.
PHYSIM_API physim_result physim_batch(const physim_def* def, const char* shot, size_t count,
                                      const physim_launches* launches, const physim_weather* weather,
                                      const physim_ends* into, const physim_pool* pool, physim_batch_info* info);

// --------------------------------------------------------------------------------------------- aim, fit, fidelity

typedef struct physim_target {
  uint32_t size;           ///< sizeof(physim_target) [bytes]
  uint32_t reserved;       ///< [-]
  double position[3];      ///< at launch [m]
  double velocity[3];      ///< [m/s]
  double acceleration[3];  ///< constant [m/s^2]
  double tolerance;        ///< a path that passes so near hits it; 0: 0.01 [m]
} physim_target;
typedef struct physim_way {
  int32_t found;       ///< the members below count [-]
  uint32_t reserved;   ///< [-]
  double elevation;    ///< of the bore [rad]
  double azimuth;      ///< [rad]
  double time;         ///< of flight [s]
  double miss;         ///< [m]
  double speed;        ///< there [m/s]
  double descent;      ///< downwards positive [rad]
  double position[3];  ///< of the projectile there [m]
} physim_way;
typedef struct physim_aim_info {
  uint32_t size;          ///< sizeof(physim_aim_info) [bytes]
  int32_t in_reach;       ///< [-]
  int32_t behind_ground;  ///< paths hit only through the ground [-]
  uint32_t blocked;       ///< ways that something stands in [-]
  int64_t flights;        ///< flown [-]
  physim_way low;         ///< of the shortest time [-]
  physim_way high;        ///< of the longest [-]
  physim_way nearest;     ///< that any flight came [-]
  char explanation[256];  ///< in words [-]
} physim_aim_info;
/// Finds the directions that hit a target; null: that of the def ([target]). Out of reach is no error.
PHYSIM_API physim_result physim_aim(const physim_def* def, const char* shot, const physim_target* target,
                                    physim_aim_info* info);

typedef struct physim_farthest {
  uint32_t size;       ///< sizeof(physim_farthest) [bytes]
  uint32_t reserved;   ///< [-]
  double elevation;    ///< of the bore above the horizon [rad]
  double range;        ///< along the ground, from below the muzzle [m]
  double time;         ///< of flight [s]
  double position[3];  ///< of impact [m]
  double velocity[3];  ///< at impact [m/s]
  int64_t flights;     ///< flown [-]
} physim_farthest;
/// Finds the elevation that carries farthest over even ground, which lies at the height `ground` [m] and rises with
/// `slope` [rad] in the direction of fire. Refused if the shot does not come down within `time` [s]; 0: 3600.
PHYSIM_API physim_result physim_max_range(const physim_def* def, const char* shot, double ground, double slope,
                                          double time, physim_farthest* info);

/// A motion in a straight line under constant acceleration: v = u + a t, s = u t + a t^2 / 2.
typedef struct physim_straight {
  double s;  ///< displacement from the start [m]
  double u;  ///< velocity at the start [m/s]
  double v;  ///< velocity at time t [m/s]
  double a;  ///< acceleration [m/s^2]
  double t;  ///< time since the start [s]
} physim_straight;
/// Finds the motions that have three known quantities; the other two of `given` are NaN. `into` has room for two;
/// `count` is how many there are, by rising time. Refused if none has them, or any number of motions.
PHYSIM_API physim_result physim_suvat(const physim_straight* given, physim_straight* into, size_t* count);

/// A flight beside the reference. Distances and delay are NaN of one that never came to its end.
typedef struct physim_compared {
  double end_distance;      ///< between its end and that of the reference [m]
  double largest_distance;  ///< between the two at any equal time [m]
  double end_delay;         ///< of its end after that of the reference [s]
  int64_t steps;            ///< taken [-]
  int64_t evaluations;      ///< of the acceleration [-]
} physim_compared;
/// Flies a shot at `count` presets of fidelity ("game", "simulation", ...) and measures how far each comes from the
/// reference, which `reference` (may be null) becomes. `each`: sizeof(physim_compared).
PHYSIM_API physim_result physim_compare(const physim_def* def, const char* shot, const char* const* fidelities,
                                        size_t count, physim_compared* rows, size_t each, physim_flight** reference);

/// A figure that was not measured is NaN.
typedef struct physim_measurement {
  double range;  ///< along the line of sight [m]
  double speed;  ///< [m/s]
  double drop;   ///< above the line of sight [m]
  double time;   ///< of flight [s]
} physim_measurement;
typedef struct physim_fit_options {
  uint32_t size;         ///< sizeof(physim_fit_options) [bytes]
  int32_t muzzle_speed;  ///< fits it, too [-]
  double speed_error;    ///< 0: 1 [m/s]
  double drop_error;     ///< 0: 0.01 [m]
  double time_error;     ///< 0: 0.001 [s]
} physim_fit_options;
typedef struct physim_fit_info {
  uint32_t size;              ///< sizeof(physim_fit_info) [bytes]
  uint32_t reserved;          ///< [-]
  double scale;               ///< drag of what was fitted over that of the shot [-]
  double scale_error;         ///< standard error [-]
  double muzzle_speed;        ///< [m/s]
  double muzzle_speed_error;  ///< standard error [m/s]
  double rms;                 ///< of residuals over their errors [-]
  int64_t flights;            ///< flown [-]
} physim_fit_info;
/// Fits the drag of a shot to measurements. `fitted` (may be null) becomes a def whose shot is the fitted one.
PHYSIM_API physim_result physim_fit(const physim_def* def, const char* shot, const physim_measurement* measurements,
                                    size_t count, const physim_fit_options* options, physim_fit_info* info,
                                    physim_def** fitted);

typedef struct physim_purpose {
  uint32_t size;      ///< sizeof(physim_purpose) [bytes]
  int32_t free_step;  ///< steps are free; else a frame is `step` [-]
  double error;       ///< largest distance from the truth; 0: 0.01 [m]
  double time;        ///< over which it must hold; 0: 2 [s]
  double step;        ///< a frame; 0: 1/60 [s]
  double ground;      ///< height where flights end; NaN: no ground [m]
} physim_purpose;
typedef struct physim_fidelity_info {
  uint32_t size;          ///< sizeof(physim_fidelity_info) [bytes]
  int32_t ended_early;    ///< the search used up its steps [-]
  double step;            ///< fixed step; 0: none [s]
  double error;           ///< as measured [m]
  double cost;            ///< operations for a second of flight [1/s]
  double truth_cost;      ///< of the reference [1/s]
  char explanation[256];  ///< in words [-]
} physim_fidelity_info;
/// Finds the cheapest fidelity of a shot within an error of the reference. `chosen` (may be null) becomes a def whose
/// shot has it.
PHYSIM_API physim_result physim_choose_fidelity(const physim_def* def, const char* shot, const physim_purpose* purpose,
                                                physim_fidelity_info* info, physim_def** chosen);

// ----------------------------------------------------------------------------------------------------------- studies

typedef struct physim_study_info {
  uint32_t size;         ///< sizeof(physim_study_info) [bytes]
  uint32_t shard_shots;  ///< shots of a shard [-]
  uint64_t shards;       ///< of the whole study [-]
  size_t inputs;         ///< uncertain numbers [-]
  size_t targets;        ///< [-]
} physim_study_info;

/// Checks and prepares the study of a shot ([study], and distributions in the place of numbers).
PHYSIM_API physim_result physim_study_create(const physim_def* def, const char* shot, physim_study** study);
PHYSIM_API physim_result physim_study_read(const physim_study* study, physim_study_info* info);
/// Flies shards first, first + 1, ...: their bits depend on study and number alone, on any machine. `pool` may be null.
PHYSIM_API physim_result physim_study_fly(const physim_study* study, uint64_t first, uint64_t count,
                                          const physim_pool* pool, physim_part** part);
/// Ends a study earlier, where the 95 % interval of a figure is no wider than `width`: of the hit probability of a
/// target [-], by its name; null: of the mean of quantity `quantity` [unit of the quantity]. 0: it ends with its shots.
PHYSIM_API physim_result physim_study_set_width(physim_study* study, const char* target, size_t quantity, double width);
/// Flies what `so_far` (may be null) lacks, until the study ends, or for some time [s]; 0: as long as it takes. `part`
/// (may be null) becomes all that was flown, to go on with, and `figures` (may be null) what came out.
PHYSIM_API physim_result physim_study_run(const physim_study* study, const physim_part* so_far, double seconds,
                                          const physim_pool* pool, physim_part** part, physim_figures** figures);
/// Joins two parts of one study, in any order.
PHYSIM_API physim_result physim_part_join(const physim_part* a, const physim_part* b, physim_part** joined);
PHYSIM_API physim_result physim_part_load(const void* data, size_t size, physim_part** part);
/// The figures of the first `shards` of a part; 0: of all of the study.
PHYSIM_API physim_result physim_study_figures(const physim_study* study, const physim_part* part, uint64_t shards,
                                              physim_figures** figures);

typedef struct physim_figures_info {
  uint32_t size;          ///< sizeof(physim_figures_info) [bytes]
  int32_t has_plane;      ///< the radii below count [-]
  uint64_t shots;         ///< flown [-]
  uint64_t refused;       ///< of them [-]
  uint64_t not_arrived;   ///< of them [-]
  size_t quantities;      ///< [-]
  size_t targets;         ///< [-]
  double mean_radius;     ///< from the aim [m]
  double r50;             ///< half of the shots lie within, about the aim [m]
  double r90;             ///< [m]
  uint64_t shards;        ///< that they are of [-]
  int32_t width_reached;  ///< physim_study_set_width() ended it [-]
  int32_t time_was_up;    ///< the time of physim_study_run() ended it [-]
} physim_figures_info;
typedef struct physim_quantity {
  uint32_t size;     ///< sizeof(physim_quantity) [bytes]
  int32_t quantity;  ///< physim_name("quantity", quantity) [-]
  double mean;       ///< [unit of the quantity]
  double error;      ///< standard error of the mean [unit of the quantity]
  double deviation;  ///< [unit of the quantity]
  double least;      ///< [unit of the quantity]
  double most;       ///< [unit of the quantity]
} physim_quantity;
typedef struct physim_chance {
  uint32_t size;       ///< sizeof(physim_chance) [bytes]
  uint32_t reserved;   ///< [-]
  const char* target;  ///< its name, as long as the figures stay [-]
  uint64_t hits;       ///< [-]
  double probability;  ///< [-]
  double error;        ///< standard error [-]
  double low;          ///< of the 95 % interval [-]
  double high;         ///< [-]
} physim_chance;
PHYSIM_API physim_result physim_figures_read(const physim_figures* figures, physim_figures_info* info);
PHYSIM_API physim_result physim_figures_quantity(const physim_figures* figures, size_t index,
                                                 physim_quantity* quantity);
PHYSIM_API physim_result physim_figures_target(const physim_figures* figures, size_t index, physim_chance* chance);
/// The number that a part 0 to 1 of all shots lies below, of a quantity [unit of the quantity].
PHYSIM_API physim_result physim_figures_quantile(const physim_figures* figures, size_t index, double part,
                                                 double* value);

// ------------------------------------------------------------------------------------------------------------ worlds

typedef enum physim_firing {
  PHYSIM_FIRE_NOTHING = 0,  // the world and its scene; calls add all else
  PHYSIM_FIRE_ALL = 1       // shots, volleys, emitters, forces and joints of the scenario come by themselves
} physim_firing;

typedef struct physim_world_info {
  uint32_t size;              ///< sizeof(physim_world_info) [bytes]
  uint32_t joints;            ///< there are [-]
  double time;                ///< of the world [s]
  double fraction;            ///< of a step that physim_world_advance() left over [-]
  double step;                ///< of a frame [s]
  uint64_t planned_steps;     ///< within the scenario's duration; 0 if nothing fires by itself [-]
  size_t projectiles;         ///< alive [-]
  size_t events;              ///< of the last step, and of calls since [-]
  size_t forces;              ///< generators [-]
  size_t memory;              ///< [bytes]
  uint64_t steps;             ///< taken [-]
  uint64_t projectile_steps;  ///< [-]
  uint64_t refused;           ///< not spawned [-]
  uint64_t dropped_events;    ///< of calls between steps [-]
} physim_world_info;

typedef struct physim_projectile {
  uint32_t size;               ///< sizeof(physim_projectile) [bytes]
  int32_t life;                ///< physim_name("life", life): "in_flight", "landed", ... [-]
  uint32_t kind;               ///< [-]
  uint32_t layers;             ///< [-]
  uint32_t colour;             ///< RGBA [-]
  int32_t asleep;              ///< [-]
  uint64_t user_data;          ///< [-]
  double age;                  ///< since launch [s]
  double mass;                 ///< [kg]
  double mach;                 ///< [-]
  double position[3];          ///< [m]
  double velocity[3];          ///< [m/s]
  double acceleration[3];      ///< by all that acts on it [m/s^2]
  double orientation[4];       ///< w, x, y, z [-]
  double angular_velocity[3];  ///< [rad/s]
} physim_projectile;

/// Columns of projectiles; null: not wanted. Vectors are three numbers side by side, orientations four.
typedef struct physim_states {
  uint32_t size;      ///< sizeof(physim_states) [bytes]
  uint32_t reserved;  ///< [-]
  size_t stride;      ///< from one row to the next in each column, as of a struct of one's own; 0: no gaps [bytes]
  physim_id* id;      ///< [-]
  double* position;   ///< [m]
  double* velocity;   ///< [m/s]
  float* position_f;  ///< rounded to float [m]
  float* velocity_f;  ///< rounded to float [m/s]
  double* previous;   ///< position before the last step; only read [m]
  double* shown;      ///< position to draw, between steps; only read [m]
  float* shown_f;     ///< rounded to float; only read [m]
  double* angular_velocity;  ///< in the world frame, of what turns [rad/s]
  double* orientation;       ///< w, x, y, z; only read [-]
  uint64_t* user_data;       ///< [-]
} physim_states;

/// A world with the environment, [world] and things of a def.
PHYSIM_API physim_result physim_world_create(const physim_def* def, physim_firing firing, physim_world** world);
PHYSIM_API physim_result physim_world_read(const physim_world* world, physim_world_info* info);
/// A hash of all that decides what happens next.
PHYSIM_API physim_result physim_world_hash(const physim_world* world, uint64_t* hash);
/// The environment of a def from the next step on, in the place of environment `index`; 0 is that of all kinds that
/// were added without another.
PHYSIM_API physim_result physim_world_set_environment(physim_world* world, uint32_t index, const physim_def* def);
/// Another place to fly in, for physim_world_add_kind().
PHYSIM_API physim_result physim_world_add_environment(physim_world* world, const physim_def* def, uint32_t* index);
/// The levels of detail of a def (world.detail).
PHYSIM_API physim_result physim_world_set_detail(physim_world* world, const physim_def* def);
/// The place that levels of detail go by (world.detail) [m].
PHYSIM_API physim_result physim_world_set_observer(physim_world* world, const double position[3]);

enum { PHYSIM_ASK_HITS = 1 };  // its hits ask the function of physim_world_set_hit_function(), which is there

/// Prepares a shot of a def as a kind of projectile that flies in an environment of the world; `flags`: 0 or
/// PHYSIM_ASK_HITS.
PHYSIM_API physim_result physim_world_add_kind(physim_world* world, const physim_def* def, const char* shot,
                                               uint32_t environment, uint32_t flags, uint32_t* kind);
/// Projectiles of a kind, launched as its shot says but for `launches` (may be null). Ids (may be null) are null of
/// what was refused; `spawned` (may be null) counts the others.
PHYSIM_API physim_result physim_world_spawn(physim_world* world, uint32_t kind, size_t count,
                                            const physim_launches* launches, physim_id* ids, size_t* spawned);
/// Continues a flight from one of its times on [s].
PHYSIM_API physim_result physim_world_spawn_flight(physim_world* world, const physim_flight* flight, double time,
                                                   physim_id* id);
/// A projectile of a shot that is on its way already, `age` after its launch [s].
PHYSIM_API physim_result physim_world_spawn_moving(physim_world* world, const physim_def* def, const char* shot,
                                                   const double position[3], const double velocity[3], double age,
                                                   physim_id* id);
PHYSIM_API physim_result physim_world_despawn(physim_world* world, const physim_id* ids, size_t count, size_t* gone);

/// Takes `count` steps of dt [s]; 0: of the world's own step, as a world that fires by itself takes them.
PHYSIM_API physim_result physim_world_step(physim_world* world, uint64_t count, double dt);
/// Real time has passed [s]: as many steps as fit; `steps` may be null. Not for worlds that fire by themselves.
PHYSIM_API physim_result physim_world_advance(physim_world* world, double seconds, uint32_t* steps);
typedef enum physim_world_action {
  PHYSIM_CLEAR = 0,        // takes all projectiles out
  PHYSIM_PAUSE = 1,        // value: 1 or 0; physim_world_advance() takes no steps meanwhile
  PHYSIM_SINGLE_STEP = 2,  // one step of the world's own, paused or not
  PHYSIM_TIME_SCALE = 3    // value: factor on the time given to physim_world_advance()
} physim_world_action;
PHYSIM_API physim_result physim_world_do(physim_world* world, physim_world_action action, double value);
/// Events of the last step, and of calls since, as physim_flight_events() writes them.
PHYSIM_API physim_result physim_world_events(const physim_world* world, size_t first, physim_event* into, size_t each,
                                             size_t room, size_t* count);

/// Reads the projectiles `ids`; if `ids` is null, all that are alive, in the order of memory, which is faster: the
/// column `id` names them. Rows are filled up to `count`; `read` (may be null) is the number of projectiles. Rows of
/// projectiles that are gone are zero.
PHYSIM_API physim_result physim_world_states(const physim_world* world, const physim_id* ids, size_t count,
                                             const physim_states* into, size_t* read);
/// Writes positions, velocities, angular velocities and user data of projectiles; `written` (may be null) counts those
/// that took them.
PHYSIM_API physim_result physim_world_put(physim_world* world, const physim_id* ids, size_t count,
                                          const physim_states* from, size_t* written);
/// Adds an impulse to each, three numbers [N s].
PHYSIM_API physim_result physim_world_push(physim_world* world, const physim_id* ids, size_t count,
                                           const double* impulses, size_t* pushed);
/// Puts projectiles to sleep, or wakes them: `sleep` 1 or 0. `changed` (may be null) counts those that were not so
/// before.
PHYSIM_API physim_result physim_world_rest(physim_world* world, const physim_id* ids, size_t count, int32_t sleep,
                                           size_t* changed);
PHYSIM_API physim_result physim_world_projectile(const physim_world* world, physim_id id, physim_projectile* into);
/// The jerk of a projectile now: the change of its acceleration along its path, in the world frame [m/s^3].
PHYSIM_API physim_result physim_world_jerk(const physim_world* world, physim_id id, double jerk[3]);
/// A setting of one projectile in flight: those that are live ("mass", "drag.k1", "body.gravity_scale"), and all of
/// "fidelity". Reads any setting of its shot and body.
PHYSIM_API physim_result physim_world_set(physim_world* world, physim_id id, const char* path, const char* value);
PHYSIM_API physim_result physim_world_get(const physim_world* world, physim_id id, const char* path, char* into,
                                          size_t room, size_t* length);
/// The flight of a projectile from now on, until the ground or for a time [s].
PHYSIM_API physim_result physim_world_predict(const physim_world* world, physim_id id, double time,
                                              physim_flight** flight);

// ------------------------------------------------------------------------------------- snapshots, saves, recordings

PHYSIM_API physim_result physim_world_snapshot(const physim_world* world, physim_snapshot** snapshot);
/// Back to a moment of this world, bit for bit; refused for a snapshot of another one.
PHYSIM_API physim_result physim_world_restore(physim_world* world, const physim_snapshot* snapshot);

typedef struct physim_hit_question {
  physim_id projectile;        ///< that struck [-]
  physim_id thing;             ///< that was struck [-]
  uint32_t kind;               ///< of the projectile [-]
  uint32_t primitive;          ///< of the thing: triangle or part [-]
  uint32_t material;           ///< of it [-]
  int32_t inside;              ///< it was inside when the step began [-]
  double time;                 ///< of the world [s]
  double position[3];          ///< [m]
  double velocity[3];          ///< with which it came [m/s]
  double normal[3];            ///< of the surface, towards the projectile [-]
  double surface_velocity[3];  ///< [m/s]
  double energy;               ///< as seen from the surface [J]
  double obliquity;            ///< 0 straight on [rad]
  double thickness;            ///< of the thing along its way; 0: not known [m]
} physim_hit_question;

typedef enum physim_on_hit {
  PHYSIM_HIT_PASSES = 0,
  PHYSIM_HIT_STOPS = 1,
  PHYSIM_HIT_STICKS = 2,
  PHYSIM_HIT_BOUNCES = 3,
  PHYSIM_HIT_BY_MATERIAL = 4
} physim_on_hit;

typedef struct physim_hit_answer {
  int32_t then;          ///< physim_on_hit; PHYSIM_HIT_STOPS as it comes [-]
  int32_t has_velocity;  ///< the velocity below counts, of what passes or bounces [-]
  double velocity[3];    ///< after the hit [m/s]
} physim_hit_answer;

/// Decides what hits of kinds with PHYSIM_ASK_HITS do: a row for each hit.
typedef void (*physim_hit_function)(void* user, size_t count, const physim_hit_question* questions,
                                    physim_hit_answer* answers);

/// A question to an engine's own physics: the first hit of each segment.
typedef struct physim_engine_batch {
  size_t count;                           ///< segments [-]
  const struct physim_segment* segments;  ///< none is without length [-]
  struct physim_hit* hits;                ///< of each, empty as it comes: to be filled if it meets something [-]
  uint32_t layers;                        ///< bits: things of these [-]
  uint32_t reserved;                      ///< [-]
} physim_engine_batch;
/// Fills `part`, `normal` (outwards, of any length but 0) and `thing.index` (above 0, the engine's own) of a hit;
/// `velocity`, `primitive`, `material` (of the scene), `entering` and `starts_inside` count, too. The answer must
/// follow from the segment alone.
typedef void (*physim_engine_function)(void* user, const physim_engine_batch* batch);

typedef struct physim_force_batch {
  size_t count;            ///< projectiles that the force acts on [-]
  double time;             ///< of the world [s]
  const physim_id* id;     ///< [-]
  const double* position;  ///< three for each [m]
  const double* velocity;  ///< three for each [m/s]
  const double* mass;      ///< [kg]
  double* force;           ///< three for each: to be added to [N]
} physim_force_batch;
typedef void (*physim_force_function)(void* user, const physim_force_batch* batch);

/// Functions that a save or a recording lacks, in the order in which they were added.
typedef struct physim_functions {
  uint32_t size;                       ///< sizeof(physim_functions) [bytes]
  uint32_t forces;                     ///< number of force functions [-]
  const physim_force_function* force;  ///< [-]
  void* const* force_user;             ///< of each [-]
  physim_hit_function hit;             ///< [-]
  void* hit_user;                      ///< [-]
  physim_wind_function wind;           ///< of the environment [-]
  void* wind_user;                     ///< [-]
  physim_field_function field;         ///< of the environment [-]
  void* field_user;                    ///< [-]
  physim_engine_function engine;       ///< of the scene [-]
  void* engine_user;                   ///< [-]
} physim_functions;

/// The world of a save. `def`: of a world that fires by itself, the one that it was made of, with its functions; else
/// null. `functions` may be null. Kinds and names are given again: physim_world_add_kind() finds the kind that is
/// there.
PHYSIM_API physim_result physim_world_load(const void* data, size_t size, const physim_def* def,
                                           const physim_functions* functions, physim_world** world);
/// Records every call that changes the world, with a hash every `hash_every` steps (0: none). The recording of a world
/// to which something was done already, as of one with a scene, begins with a save.
PHYSIM_API physim_result physim_world_record(physim_world* world, uint32_t hash_every);
PHYSIM_API physim_result physim_world_stop_recording(physim_world* world, physim_bytes** recording);

typedef struct physim_replay_info {
  uint32_t size;         ///< sizeof(physim_replay_info) [bytes]
  int32_t agrees;        ///< no difference was found [-]
  int32_t complete;      ///< the recording has its end; else it was cut [-]
  uint32_t reserved;     ///< [-]
  uint64_t calls;        ///< made [-]
  uint64_t steps;        ///< taken [-]
  uint64_t hashes;       ///< compared, and equal [-]
  uint64_t hash;         ///< of the world at the end [-]
  char difference[256];  ///< the first; empty: none [-]
} physim_replay_info;

/// Makes all calls of a recording again, and compares. `functions` may be null.
PHYSIM_API physim_result physim_replay(const void* recording, size_t size, const physim_functions* functions,
                                       physim_replay_info* info);
/// A world that a recording moves on, as it was before the first call. It is only read; its snapshots go to no other.
PHYSIM_API physim_result physim_replay_open(const void* recording, size_t size, const physim_functions* functions,
                                            physim_world** world);
/// Makes the calls of the recording up to and with `frames` more that took steps; 0: the next call alone. `more` (may
/// be null) is 0 if the recording ended, or a difference was found. `info` (may be null): all that was done so far.
PHYSIM_API physim_result physim_replay_next(physim_world* world, uint64_t frames, int32_t* more,
                                            physim_replay_info* info);
/// Goes to where physim_replay_info.steps is `steps`, back or forwards: behind the call that took that step; 0: to the
/// beginning. `there` (may be null) is 0 if the recording ended, or a difference was found, before.
PHYSIM_API physim_result physim_replay_seek(physim_world* world, uint64_t steps, int32_t* there,
                                            physim_replay_info* info);

// ----------------------------------------------------------------------------------------------------------- drawing
// A world as lines, triangles, balls and texts, for an engine's debug drawing.

/// The meaning of a drawn element; colours are the caller's.
typedef enum physim_ink {
  PHYSIM_INK_SOLID,     ///< a thing that is hit
  PHYSIM_INK_SENSOR,    ///< a thing that only reports
  PHYSIM_INK_PATH,      ///< the path of a thing
  PHYSIM_INK_BOX,       ///< of the trees of things
  PHYSIM_INK_FLYING,    ///< a projectile that moves
  PHYSIM_INK_ASLEEP,    ///< a projectile that sleeps
  PHYSIM_INK_HELD,      ///< a projectile that calls move, or that nothing moves
  PHYSIM_INK_VELOCITY,  ///< how far a projectile moves in a time
  PHYSIM_INK_CONTACT,   ///< the normal of what was hit in the last step, there
  PHYSIM_INK_JOINT      ///< between its ends
} physim_ink;

/// A canvas: a table of functions, each of which may be null. Places have three numbers, x, y and z in W [m].
typedef struct physim_canvas {
  uint32_t size;      ///< sizeof(physim_canvas) [bytes]
  uint32_t reserved;  ///< [-]
  void* user;         ///< handed to each function [-]
  /// Before a projectile is drawn.
  void (*begin)(void* user, physim_id projectile);
  void (*line)(void* user, const double* a, const double* b, int32_t ink);
  /// Counterclockwise as seen from outside.
  void (*triangle)(void* user, const double* a, const double* b, const double* c, int32_t ink);
  /// Null: three circles of lines.
  void (*ball)(void* user, const double* middle, double radius, int32_t ink);
  void (*text)(void* user, const double* place, const char* text);
} physim_canvas;

typedef struct physim_drawing {
  uint32_t size;           ///< sizeof(physim_drawing) [bytes]
  uint32_t layers;         ///< bits: projectiles of these [-]
  int32_t without_things;  ///< the scene is not drawn [-]
  int32_t without_joints;  ///< [-]
  int32_t labels;          ///< are drawn at projectiles that have one, and names at things [-]
  int32_t boxes;           ///< of the trees of things [-]
  double point_size;       ///< half of the cross of a point; 0: none [m]
  double ahead;            ///< duration of the drawn lines of velocities; 0: none [s]
  double normals;          ///< length of the drawn normals of contacts; 0: none [m]
} physim_drawing;

/// Draws a world: its things, its projectiles as they are drawn between steps, joints, and what was hit in the last
/// step. Numbers from 0 to 1e9. The world must not be changed inside.
PHYSIM_API physim_result physim_world_draw(const physim_world* world, const physim_drawing* what,
                                           const physim_canvas* canvas);

// ------------------------------------------------------------------------------------------------------------ scenes
// A void pointer `scene` is a physim_scene, or a physim_world for the scene of that world.

typedef struct physim_transform {
  uint32_t size;       ///< sizeof(physim_transform) [bytes]
  uint32_t reserved;   ///< [-]
  double position[3];  ///< of the origin [m]
  double rotation[4];  ///< w, x, y, z, of any length; all 0: none [-]
  double scale;        ///< 0: 1 [-]
} physim_transform;

typedef struct physim_motion {
  uint32_t size;               ///< sizeof(physim_motion) [bytes]
  uint32_t reserved;           ///< [-]
  double start;                ///< time at which the thing is where its transform puts it [s]
  double velocity[3];          ///< [m/s]
  double angular_velocity[3];  ///< about its own origin [rad/s]
} physim_motion;

typedef struct physim_segment {
  double from[3];   ///< [m]
  double to[3];     ///< [m]
  double radius;    ///< of a ball about each point [m]
  double time;      ///< at which it begins [s]
  double duration;  ///< that its way takes; 0: things stand as at that time [s]
} physim_segment;

typedef struct physim_hit {
  physim_id thing;        ///< index 0: nothing was met [-]
  uint32_t primitive;     ///< triangle of a mesh or height field, part of a compound [-]
  uint32_t material;      ///< [-]
  int32_t entering;       ///< from outside to inside [-]
  int32_t starts_inside;  ///< [-]
  double part;            ///< of the segment, 0 to 1 [-]
  double time;            ///< [s]
  double position[3];     ///< [m]
  double normal[3];       ///< of the surface, outwards [-]
  double velocity[3];     ///< of the surface there [m/s]
} physim_hit;

typedef struct physim_nearest {
  uint32_t size;       ///< sizeof(physim_nearest) [bytes]
  uint32_t material;   ///< [-]
  physim_id thing;     ///< [-]
  double distance;     ///< 0 inside of a solid [m]
  double position[3];  ///< on the surface [m]
  double away[3];      ///< unit vector from the surface to the point [-]
} physim_nearest;

/// The things of a def.
PHYSIM_API physim_result physim_scene_create(const physim_def* def, physim_scene** scene);
/// The scene of a save, with the ids that its things had; physim_scene_find() knows none of them. `functions` (may be
/// null) has its engine, if it had one.
PHYSIM_API physim_result physim_scene_load(const void* data, size_t size, const physim_functions* functions,
                                           physim_scene** scene);

typedef struct physim_engine_info {
  uint32_t size;      ///< sizeof(physim_engine_info) [bytes]
  uint32_t reserved;  ///< [-]
  uint64_t calls;     ///< of its function [-]
  uint64_t segments;  ///< in these [-]
  uint64_t refused;   ///< answers that made no sense: nothing was met [-]
} physim_engine_info;
/// Lets an engine's own physics answer beside the things of a scene; null: it does not any more. A world has it with a
/// copy of the scene. `skin`: things are met this far outside of their surfaces, 1e-6 to 0.1; 0: 0.001 [m].
PHYSIM_API physim_result physim_scene_set_engine(physim_scene* scene, physim_engine_function function, void* user,
                                                 double skin);
PHYSIM_API physim_result physim_scene_read_engine(const void* scene, physim_engine_info* info);
/// Gives a world a copy of a scene; null: it has none any more.
PHYSIM_API physim_result physim_world_set_scene(physim_world* world, const physim_scene* scene);
/// Adds all things of a def, with their shapes and materials; ids of up to `room` of them. In a world this costs as
/// much as setting its scene.
PHYSIM_API physim_result physim_scene_add(void* scene, const physim_def* def, physim_id* ids, size_t room,
                                          size_t* count);
/// Adds another thing like one that is there, at another place.
PHYSIM_API physim_result physim_scene_copy(void* scene, physim_id like, const physim_transform* to, physim_id* id);
/// The first thing of a name among those that defs brought. PHYSIM_NOT_FOUND: none has it.
PHYSIM_API physim_result physim_scene_find(const void* scene, const char* name, physim_id* id);
PHYSIM_API physim_result physim_scene_move(void* scene, physim_id thing, const physim_transform* to);
/// Lets a thing move steadily; null: it rests where its transform puts it.
PHYSIM_API physim_result physim_scene_set_motion(void* scene, physim_id thing, const physim_motion* motion);
/// Bits that kinds and queries choose things by.
PHYSIM_API physim_result physim_scene_set_layers(void* scene, physim_id thing, uint32_t layers);
/// Lets the surface of a thing run as a conveyor's, in the thing's own frame [m/s]; null: it stands.
PHYSIM_API physim_result physim_scene_set_conveyor(void* scene, physim_id thing, const double velocity[3]);
PHYSIM_API physim_result physim_scene_remove(void* scene, physim_id thing);

/// The first hit of each segment on things of these layers. `each`: sizeof(physim_hit). `pool` may be null.
PHYSIM_API physim_result physim_scene_cast(const void* scene, const physim_segment* segments, size_t count,
                                           uint32_t layers, physim_hit* hits, size_t each, const physim_pool* pool);
/// All that the points of one segment meet, up to `room`; `count` is how many there are.
PHYSIM_API physim_result physim_scene_hits(const void* scene, const physim_segment* segment, uint32_t layers,
                                           physim_hit* hits, size_t each, size_t room, size_t* count);
/// The surface nearest to a point, within a distance [m], at a time [s]. PHYSIM_NOT_FOUND: none is that near.
PHYSIM_API physim_result physim_scene_nearest(const void* scene, const double point[3], double within, uint32_t layers,
                                              double time, physim_nearest* nearest);
/// The things that a ball touches at a time [s], up to `room`; `count` is how many there are.
PHYSIM_API physim_result physim_scene_overlaps(const void* scene, const double middle[3], double radius,
                                               uint32_t layers, double time, physim_id* ids, size_t room,
                                               size_t* count);

// Queries that see projectiles: all that were launched, of these layers (body.layers), as balls of their radius.
/// Those that a ball touches, by index, up to `room`; `count` is how many there are.
PHYSIM_API physim_result physim_world_in_ball(const physim_world* world, const double middle[3], double radius,
                                              uint32_t layers, physim_id* ids, size_t room, size_t* count);
/// Those that a box touches; `half`: half of its edges [m].
PHYSIM_API physim_result physim_world_in_box(const physim_world* world, const physim_transform* at,
                                             const double half[3], uint32_t layers, physim_id* ids, size_t room,
                                             size_t* count);
typedef struct physim_projectile_hit {
  physim_id id;        ///< of the projectile [-]
  double part;         ///< of the way, 0 to 1 [-]
  double position[3];  ///< of the point or ball that is cast, then [m]
  double normal[3];    ///< from the projectile's middle to that, of length 1 [-]
} physim_projectile_hit;
/// Those that a ray touches, or a ball of the segment's radius, in order; its times are not looked at. `each`:
/// sizeof(physim_projectile_hit).
PHYSIM_API physim_result physim_world_cast(const physim_world* world, const physim_segment* segment, uint32_t layers,
                                           physim_projectile_hit* hits, size_t each, size_t room, size_t* count);

// ------------------------------------------------------------------------------------------ emitters, forces, joints

/// Adds an [[emitter]] of a def, by its name or its number from 1. `follows` (may be null): a projectile that it sits
/// on. Emitters that its subs name are added to this world first, of whatever def.
PHYSIM_API physim_result physim_world_add_emitter(physim_world* world, const physim_def* def, const char* emitter,
                                                  const physim_id* follows, physim_id* id);

typedef enum physim_emitter_action {
  PHYSIM_PLAY = 0,
  PHYSIM_STOP = 1,
  PHYSIM_TRIGGER = 2,  // its subs that wait for it
  PHYSIM_EMIT = 3,     // value: this many particles at once
  PHYSIM_SEEK = 4      // value: as if it had played for this time [s]
} physim_emitter_action;
PHYSIM_API physim_result physim_emitter_do(physim_world* world, physim_id emitter, physim_emitter_action action,
                                           double value);
/// `time` above that of the world: it is there then [s]; below 0: it is there at once, without a way to it; else it
/// goes there in the course of the next step.
PHYSIM_API physim_result physim_emitter_move(physim_world* world, physim_id emitter, const physim_transform* to,
                                             double time);

typedef struct physim_emitter_info {
  uint32_t size;      ///< sizeof(physim_emitter_info) [bytes]
  uint32_t alive;     ///< particles now [-]
  int32_t playing;    ///< it may fire on its own [-]
  uint32_t reserved;  ///< [-]
  uint64_t born;      ///< since it was added [-]
  uint64_t refused;   ///< full, or the world did not take them [-]
  uint64_t landed;    ///< gone on the ground or on a thing [-]
  uint64_t gone;      ///< gone by age, rules, calls or newer ones [-]
} physim_emitter_info;
PHYSIM_API physim_result physim_emitter_read(const physim_world* world, physim_id emitter, physim_emitter_info* info);

/// Columns of particles for a renderer; null: not wanted.
typedef struct physim_particles {
  uint32_t size;      ///< sizeof(physim_particles) [bytes]
  uint32_t reserved;  ///< [-]
  size_t stride;      ///< from one row to the next in each column; 0: no gaps [bytes]
  physim_id* id;      ///< [-]
  double* position;   ///< three for each [m]
  double* previous;   ///< three for each [m]
  double* velocity;   ///< three for each [m/s]
  double* extent;     ///< three for each, by its own axes [m]
  double* rotation;   ///< three for each, about its axes [rad]
  double* age;        ///< [s]
  uint64_t* number;   ///< of the particle among those of its emitter [-]
  uint32_t* colour;   ///< RGBA [-]
  const double* eye;  ///< a place: rows come from the farthest of it to the nearest; null: by index [m]
} physim_particles;
/// Fills up to `room` rows; `count` is how many particles there are.
PHYSIM_API physim_result physim_emitter_particles(const physim_world* world, physim_id emitter, size_t room,
                                                  const physim_particles* into, size_t* count);

/// Past places of particles (emitter.trail); null: not wanted. Rows of a particle, then rows of places: of one particle
/// after the other, from the oldest to where it is now.
typedef struct physim_trails {
  uint32_t size;      ///< sizeof(physim_trails) [bytes]
  uint32_t reserved;  ///< [-]
  physim_id* id;      ///< of each particle [-]
  uint32_t* first;    ///< of each particle: which of all places is its first one [-]
  uint32_t* count;    ///< of each particle: how many places it has [-]
  double* position;   ///< three for each place [m]
  double* time;       ///< of each place: when the particle was there [s]
} physim_trails;
/// `particles` and `places` (not null) say for how many rows there is room, and become how many there are. `into` may
/// be null, if both are 0.
PHYSIM_API physim_result physim_emitter_trails(const physim_world* world, physim_id emitter, const physim_trails* into,
                                               size_t* particles, size_t* places);

/// Adds a [[force]] of a def, by its name or its number from 1: on these projectiles, or on those that it says itself
/// if `count` is 0. `other` (may be null): the projectile at the other end of a spring or bungee.
PHYSIM_API physim_result physim_world_add_force(physim_world* world, const physim_def* def, const char* force,
                                                const physim_id* ids, size_t count, const physim_id* other,
                                                physim_id* id);
/// A force of one's own on these projectiles, and on all of the layers.
PHYSIM_API physim_result physim_world_add_force_function(physim_world* world, physim_force_function function,
                                                         void* user, const physim_id* ids, size_t count,
                                                         uint32_t layers, physim_id* id);
/// Null: none; refused while there are kinds that ask.
PHYSIM_API physim_result physim_world_set_hit_function(physim_world* world, physim_hit_function function, void* user);

typedef enum physim_joint_kind {
  PHYSIM_ROD = 0,
  PHYSIM_CABLE = 1,
  PHYSIM_SPRING = 2,
  PHYSIM_HINGE = 3,
  PHYSIM_SLIDER = 4
} physim_joint_kind;
typedef struct physim_joint {
  uint32_t size;        ///< sizeof(physim_joint) [bytes]
  int32_t kind;         ///< physim_joint_kind [-]
  physim_id a;          ///< one end [-]
  physim_id b;          ///< the other end; none: the point [-]
  double point[3];      ///< [m]
  double length;        ///< 0: as far as its ends are apart; a spring's may be DBL_MIN, which is none [m]
  double restitution;   ///< of a cable, 0 to 1 [-]
  double stiffness;     ///< of a spring [N/m]
  double damping;       ///< of a spring [kg/s]
  double break_force;   ///< it ends if it pulls or pushes with more, on the mean of a step; 0: it never breaks [N]
  double velocity[3];   ///< of its point, if that is no thing's [m/s]
  physim_id thing;      ///< that takes the point along; index 0: none [-]
  double axis[3];       ///< of a hinge or slider, of any length but zero [-]
  double low;           ///< of a slider [m], of a hinge -pi to pi [rad]; -INFINITY: none
  double high;          ///< above low; INFINITY: none; both 0: no limits [m], [rad]
  double reference[3];  ///< of a hinge: direction of angle 0; zero: where a is now [-]
} physim_joint;
typedef struct physim_joint_info {
  uint32_t size;   ///< sizeof(physim_joint_info) [bytes]
  int32_t taut;    ///< [-]
  double length;   ///< distance of its ends [m]
  double tension;  ///< negative: it pushed [N]
  double force;    ///< with which it acted on its ends, on the mean of the last step [N]
  double angle;    ///< of a hinge [rad]
  double way;      ///< of a slider [m]
} physim_joint_info;
typedef struct physim_joint_event {
  int32_t kind;          ///< physim_name("joint_event", kind) [-]
  uint32_t reserved;     ///< [-]
  physim_id joint;       ///< [-]
  physim_id projectile;  ///< the one that left, else the first end [-]
  double time;           ///< [s]
  double speed;          ///< at which the ends parted [m/s]
} physim_joint_event;
PHYSIM_API physim_result physim_world_add_joint(physim_world* world, const physim_joint* joint, physim_id* id);
/// Puts the point of a joint at a place now; from there it goes on at a velocity.
PHYSIM_API physim_result physim_joint_move(physim_world* world, physim_id joint, const double position[3],
                                           const double velocity[3]);
PHYSIM_API physim_result physim_joint_read(const physim_world* world, physim_id joint, physim_joint_info* info);
PHYSIM_API physim_result physim_joint_events(const physim_world* world, physim_joint_event* into, size_t each,
                                             size_t room, size_t* count);

typedef enum physim_what { PHYSIM_A_FORCE = 0, PHYSIM_A_JOINT = 1, PHYSIM_AN_EMITTER = 2 } physim_what;
/// Takes projectiles out of the targets of a force; `released` (may be null) counts those that were among them.
PHYSIM_API physim_result physim_world_release(physim_world* world, physim_id force, const physim_id* ids, size_t count,
                                              size_t* released);
PHYSIM_API physim_result physim_world_remove(physim_world* world, physim_what what, physim_id id);

#ifdef __cplusplus
}
#endif

#endif
