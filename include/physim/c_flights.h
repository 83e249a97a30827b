// The C interface, first part: errors, handles, settings, flights, batches, aim, fit, fidelity, studies. The rules are
// in physim/physim.h.
#ifndef PHYSIM_C_FLIGHTS_H
#define PHYSIM_C_FLIGHTS_H

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
/// What of the fidelity was not granted, a line each: "effect: asked, granted: reason"; as physim_get() writes.
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

#ifdef __cplusplus
}
#endif

#endif
