/* The C interface from C99: worlds, scenes, emitters, forces, joints, callbacks. */
#include "check.h"

static const char kWorld[] =
    "physim = 1\n[[shot]]\nname = \"ball\"\nmass = \"1 kg\"\ndiameter = \"10 cm\"\nspeed = \"20 m/s\"\n"
    "elevation = \"45 deg\"\nfidelity = \"game\"\nbody.collision = { on_hit = \"bounce\", radius = \"5 cm\" }\n"
    "[world]\nstep = \"10 ms\"\nduration = \"3 s\"\nthreads = 1\n"
    "[[shape]]\nname = \"box\"\nbox = { half = [0.5, 5, 5] }\n"
    "[[thing]]\nname = \"wall\"\nshape = \"box\"\nposition = [30, 5, 0]\n";

static void test_world(void) {
  physim_def* def = made(kWorld);
  physim_world *world = NULL, *other = NULL, *loaded = NULL;
  physim_snapshot* snapshot = NULL;
  physim_bytes *save = NULL, *recording = NULL;
  physim_world_info info = {.size = sizeof info};
  physim_projectile one = {.size = sizeof one};
  physim_replay_info replay = {.size = sizeof replay};
  struct sprite {
    float place[3];
    physim_id id;
  } sprites[4];
  physim_states states = {.size = sizeof states};
  physim_event events[16];
  physim_id ids[4], all[8] = {{0, 0}};
  double z[3] = {-1, 0, 1}, position[24], velocity[12], impulse[3] = {0, 0, 5}, jerk[3];
  physim_launches launches = {.size = sizeof launches};
  physim_flight* ahead = NULL;
  physim_sample end = {.size = sizeof end};
  uint32_t kind = 0, steps = 0;
  uint64_t hash = 0, again = 0;
  size_t count = 0, size = 0, i;
  const void* data = NULL;
  char text[64];
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_record(world, 1));
  IS(PHYSIM_REFUSED, physim_world_record(world, 1));
  OK(physim_world_add_kind(world, def, "ball", 0, 0, &kind));
  launches.z = z;
  OK(physim_world_spawn(world, kind, 3, &launches, ids, &count));
  CHECK(count == 3);
  IS(PHYSIM_NOT_FOUND, physim_world_spawn(world, kind + 1, 1, NULL, ids, NULL));
  OK(physim_world_predict(world, ids[0], 0.5, &ahead));
  OK(physim_world_step(world, 50, 0));
  OK(physim_world_read(world, &info));
  CHECK(is_near(info.time, 0.5, 1e-12) && info.projectiles == 3 && info.steps == 50);

  states.stride = sizeof sprites[0];
  states.position_f = sprites[0].place;
  states.id = &sprites[0].id;
  OK(physim_world_states(world, NULL, 4, &states, &count));
  CHECK(count == 3 && sprites[2].id.index == ids[2].index && sprites[2].place[2] == 1.0f);
  memset(&states, 0, sizeof states);
  states.size = sizeof states;
  states.position = position;
  states.velocity = velocity;
  OK(physim_world_states(world, ids, 3, &states, NULL));
  OK(physim_flight_at(ahead, PHYSIM_AT_TIME, 0.5, &end));
  CHECK(is_near(end.position[0], position[0], 1e-4) && position[8] == 1);

  OK(physim_world_snapshot(world, &snapshot));
  OK(physim_world_hash(world, &hash));
  position[1] = 50;
  OK(physim_world_put(world, ids, 3, &states, &count));
  CHECK(count == 3);
  OK(physim_world_push(world, ids, 1, impulse, &count));
  CHECK(count == 1);
  OK(physim_world_projectile(world, ids[0], &one));
  CHECK(one.position[1] == 50 && is_near(one.velocity[2], velocity[2] + 5, 1e-5));
  CHECK(strcmp(physim_name("life", one.life), "in_flight") == 0);
  OK(physim_world_set(world, ids[0], "mass", "2 kg"));
  OK(physim_world_set(world, ids[0], "body.gravity_scale", "0.5"));
  OK(physim_world_set(world, ids[0], "fidelity.drag", "off"));
  OK(physim_world_get(world, ids[0], "shot.mass", text, sizeof text, NULL));
  CHECK(strcmp(text, "2 kg") == 0);
  OK(physim_world_get(world, ids[0], "fidelity.drag", text, sizeof text, NULL));
  CHECK(strcmp(text, "off") == 0);
  OK(physim_world_jerk(world, ids[0], jerk)); /* of constant gravity alone */
  CHECK(fabs(jerk[0]) + fabs(jerk[1]) + fabs(jerk[2]) < 1e-9);
  IS(PHYSIM_NOT_FOUND, physim_world_jerk(world, all[0], jerk));
  IS(PHYSIM_REFUSED, physim_world_set(world, ids[0], "length", "1 m"));
  IS(PHYSIM_REFUSED, physim_world_set(world, ids[0], "mass", "-2 kg"));
  OK(physim_world_hash(world, &again));
  CHECK(again != hash);
  OK(physim_world_restore(world, snapshot));
  OK(physim_world_hash(world, &again));
  CHECK(again == hash);

  OK(physim_world_step(world, 200, 0));
  OK(physim_world_read(world, &info));
  OK(physim_save(world, &save));
  OK(physim_bytes_data(save, &data, &size));
  OK(physim_world_load(data, size, NULL, NULL, &loaded));
  OK(physim_world_hash(world, &hash));
  OK(physim_world_hash(loaded, &again));
  CHECK(hash == again);
  IS(PHYSIM_REFUSED, physim_world_load(data, size - 1, NULL, NULL, &other));
  OK(physim_world_stop_recording(world, &recording));
  OK(physim_bytes_data(recording, &data, &size));
  OK(physim_replay(data, size, NULL, &replay));
  CHECK(replay.agrees && replay.complete && replay.hash == hash && replay.hashes > 200);

  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &other));
  IS(PHYSIM_REFUSED, physim_world_restore(other, snapshot));
  OK(physim_world_advance(other, 0.1, &steps));
  CHECK(steps == 8); /* world.max_steps */
  OK(physim_world_spawn_flight(other, ahead, 0.2, &all[0]));
  OK(physim_world_despawn(other, all, 1, &count));
  CHECK(count == 1);
  OK(physim_world_events(other, 0, events, sizeof events[0], 16, &count));
  CHECK(count == 2 && strcmp(physim_name("event", events[0].kind), "spawned") == 0);
  CHECK(strcmp(physim_name("reason", events[1].reason), "despawned") == 0);
  IS(PHYSIM_NOT_FOUND, physim_world_projectile(other, ids[2], &one));

  OK(physim_free(other));
  OK(physim_world_create(def, PHYSIM_FIRE_ALL, &other));
  OK(physim_world_read(other, &info));
  CHECK(info.planned_steps == 300 && info.projectiles == 1);
  for (i = 0; i < 300; ++i) OK(physim_world_step(other, 1, 0));
  IS(PHYSIM_REFUSED, physim_world_step(other, 1, 0.01));
  IS(PHYSIM_REFUSED, physim_world_restore(other, snapshot));
  OK(physim_free(save));
  OK(physim_save(other, &save));
  OK(physim_bytes_data(save, &data, &size));
  OK(physim_free(loaded));
  IS(PHYSIM_REFUSED, physim_world_load(data, size, NULL, NULL, &loaded));
  OK(physim_world_load(data, size, def, NULL, &loaded));
  OK(physim_world_hash(other, &hash));
  OK(physim_world_hash(loaded, &again));
  CHECK(hash == again);
  OK(physim_free(loaded));
  OK(physim_free(other));
  OK(physim_free(world));
  OK(physim_free(snapshot));
  OK(physim_free(save));
  OK(physim_free(recording));
  OK(physim_free(ahead));
  OK(physim_free(def));
}

static void test_scene(void) {
  physim_def *def = made(kWorld), *more = made(NULL);
  physim_scene* scene = NULL;
  physim_world* world = NULL;
  physim_segment segments[2] = {{{0, 5, 0}, {100, 5, 0}, 0, 0, 0}, {{0, 50, 0}, {100, 50, 0}, 0, 0, 0}};
  physim_hit hits[4];
  physim_id wall, copy, added[2], touched[4];
  physim_transform to = {.size = sizeof to};
  physim_motion motion = {.size = sizeof motion};
  physim_nearest nearest = {.size = sizeof nearest};
  const double point[3] = {25, 5, 0};
  size_t count = 0;
  OK(physim_scene_create(def, &scene));
  OK(physim_scene_find(scene, "wall", &wall));
  IS(PHYSIM_NOT_FOUND, physim_scene_find(scene, "door", &copy));
  OK(physim_scene_cast(scene, segments, 2, ~0u, hits, sizeof hits[0], NULL));
  CHECK(hits[0].thing.index == wall.index && hits[0].position[0] == 29.5 && hits[0].normal[0] == -1);
  CHECK(hits[1].thing.index == 0);
  OK(physim_scene_hits(scene, segments, ~0u, hits, sizeof hits[0], 4, &count));
  CHECK(count == 2 && hits[0].entering && !hits[1].entering && hits[1].position[0] == 30.5);
  to.position[0] = 60;
  to.position[1] = 5;
  OK(physim_scene_copy(scene, wall, &to, &copy));
  OK(physim_scene_hits(scene, segments, ~0u, hits, sizeof hits[0], 4, &count));
  CHECK(count == 4);
  OK(physim_scene_nearest(scene, point, 100, ~0u, 0, &nearest));
  CHECK(nearest.distance == 4.5 && nearest.away[0] == -1);
  IS(PHYSIM_NOT_FOUND, physim_scene_nearest(scene, point, 1, ~0u, 0, &nearest));
  OK(physim_scene_overlaps(scene, point, 5, ~0u, 0, touched, 4, &count));
  CHECK(count == 1 && touched[0].index == wall.index);
  OK(physim_scene_remove(scene, wall));
  IS(PHYSIM_REFUSED, physim_scene_remove(scene, wall));
  motion.velocity[0] = -10;
  OK(physim_scene_set_motion(scene, copy, &motion));
  segments[0].time = 1;
  OK(physim_scene_cast(scene, segments, 1, ~0u, hits, sizeof hits[0], NULL));
  CHECK(is_near(hits[0].position[0], 49.5, 1e-9) && hits[0].velocity[0] == -10);
  OK(physim_scene_set_motion(scene, copy, NULL));

  OK(physim_set(more, "shape.1.name", "ball"));
  OK(physim_set(more, "shape.1.sphere.radius", "2 m"));
  OK(physim_set(more, "thing.1.name", "dome"));
  OK(physim_set(more, "thing.1.shape", "ball"));
  OK(physim_set(more, "thing.1.position", "[10, 5, 0]"));
  OK(physim_scene_add(scene, more, added, 2, &count));
  CHECK(count == 1);
  OK(physim_scene_cast(scene, segments, 1, ~0u, hits, sizeof hits[0], NULL));
  CHECK(hits[0].thing.index == added[0].index && is_near(hits[0].position[0], 8, 1e-9));

  OK(physim_world_create(more, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_scene_find(world, "dome", &wall));
  OK(physim_scene_move(world, wall, &to));
  OK(physim_scene_cast(world, segments, 1, ~0u, hits, sizeof hits[0], NULL));
  CHECK(is_near(hits[0].position[0], 58, 1e-9));
  OK(physim_scene_add(world, def, added, 2, &count));
  OK(physim_scene_find(world, "wall", &wall));
  CHECK(wall.index == added[0].index);
  OK(physim_world_set_scene(world, NULL));
  IS(PHYSIM_NOT_FOUND, physim_scene_find(world, "wall", &wall));
  OK(physim_world_set_scene(world, scene));
  OK(physim_scene_find(world, "dome", &wall));
  IS(PHYSIM_BAD_HANDLE, physim_scene_find(def, "dome", &wall));
  OK(physim_free(world));
  OK(physim_free(scene));
  OK(physim_free(more));
  OK(physim_free(def));
}

/* ------------------------------------------------------------------------- emitters, forces, joints, callbacks */
static const char kParts[] =
    "physim = 1\n[environment]\nwind.profile = [{ at = 0, velocity = [0, 0, 0] }]\n"
    "[[shot]]\nname = \"spark\"\nmass = \"1 g\"\ndiameter = \"2 mm\"\nfidelity = \"game\"\nspeed = \"1 m/s\"\n"
    "[[shot]]\nname = \"ball\"\nmass = \"1 kg\"\ndiameter = \"10 cm\"\nspeed = \"10 m/s\"\nposition = [0, 100, 0]\n"
    "fidelity = \"small_arms\"\n"
    "[world]\nstep = \"10 ms\"\nthreads = 1\n"
    "[[emitter]]\nname = \"fountain\"\nshot = \"spark\"\nper_second = 100\nseed = 7\nposition = [0, 10, 0]\n"
    "[[emitter]]\nname = \"burst\"\nshot = \"spark\"\nper_second = 0\ncycle.plays = false\n"
    "sub = [{ on = \"trigger\", emitter = \"fountain\" }]\n"
    "[[force]]\nname = \"lift\"\nconstant_force.force = [0, 9.80665, 0]\nlayers = 2\n"
    "[[force]]\nname = \"band\"\nspring = { other = \"ball\", stiffness = 1 }\nshots = [\"spark\"]\n";

static void all_stop(void* user, size_t count, const physim_hit_question* questions, physim_hit_answer* answers) {
  size_t i;
  for (i = 0; i < count; ++i) {
    *(double*)user = questions[i].position[0];
    answers[i].then = PHYSIM_HIT_STICKS;
  }
}
static void pull(void* user, const physim_force_batch* batch) {
  size_t i;
  *(size_t*)user += batch->count;
  for (i = 0; i < batch->count; ++i) batch->force[3 * i + 2] += 10 * batch->mass[i];
}
static void gale(void* user, const physim_wind_batch* batch) {
  size_t i;
  for (i = 0; i < batch->count; ++i) batch->velocity[3 * i + 2] = *(const double*)user;
}
static void tow(void* user, const physim_field_batch* batch) {
  size_t i;
  for (i = 0; i < batch->count; ++i) batch->force[3 * i] = *(const double*)user * batch->mass[i];
}

/* Hinges, sliders, and points that move, of a world with two balls along z. */
static void test_axes(physim_world* world, const physim_id* ball) {
  const double place[3] = {0, 1, 0}, velocity[3] = {2, 0, 0};
  physim_joint axis = {.size = sizeof axis, .kind = PHYSIM_HINGE, .a = ball[0], .b = ball[1], .low = -1, .high = 2};
  physim_joint_info state = {.size = sizeof state};
  physim_id joint;
  IS(PHYSIM_REFUSED, physim_world_add_joint(world, &axis, &joint)); /* without an axis */
  axis.axis[1] = 1;
  OK(physim_world_add_joint(world, &axis, &joint));
  IS(PHYSIM_REFUSED, physim_joint_move(world, joint, place, velocity)); /* it has no point */
  OK(physim_world_remove(world, PHYSIM_A_JOINT, joint));
  IS(PHYSIM_NOT_FOUND, physim_joint_move(world, joint, place, velocity));
  axis.kind = PHYSIM_SLIDER, axis.b = axis.thing;
  axis.low = -INFINITY, axis.high = 100;
  OK(physim_world_add_joint(world, &axis, &joint));
  OK(physim_joint_move(world, joint, place, velocity));
  OK(physim_world_step(world, 1, 0));
  OK(physim_joint_read(world, joint, &state));
  CHECK(isfinite(state.way) && state.force > 0 && state.angle == 0);
  OK(physim_world_remove(world, PHYSIM_A_JOINT, joint));
  axis.thing.index = 77;
  IS(PHYSIM_REFUSED, physim_world_add_joint(world, &axis, &joint)); /* no such thing */
}

static void test_parts(void) {
  physim_def* def = made(kParts);
  physim_world* world = NULL;
  physim_id fountain, burst, ball[2], force, joint, nobody = {0, 0};
  physim_emitter_info info = {.size = sizeof info};
  physim_particles particles = {.size = sizeof particles};
  physim_transform to = {.size = sizeof to};
  physim_projectile one = {.size = sizeof one};
  physim_joint rod = {.size = sizeof rod};
  physim_joint_info state = {.size = sizeof state};
  physim_joint_event events[4];
  physim_world_info counts = {.size = sizeof counts};
  double place[300], zs[2] = {0, 2}, struck = 0;
  physim_launches launches = {.size = sizeof launches};
  uint32_t kind = 0;
  size_t count = 0, pulled = 0;
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  IS(PHYSIM_REFUSED, physim_world_add_emitter(world, def, "burst", NULL, &burst));
  OK(physim_world_add_emitter(world, def, "fountain", NULL, &fountain));
  OK(physim_world_add_emitter(world, def, "2", NULL, &burst));
  IS(PHYSIM_NOT_FOUND, physim_world_add_emitter(world, def, "none", NULL, &burst));
  OK(physim_world_step(world, 50, 0));
  OK(physim_emitter_read(world, fountain, &info));
  CHECK(info.born == 50 && info.playing);
  particles.position = place;
  OK(physim_emitter_particles(world, fountain, 100, &particles, &count));
  CHECK(count == info.alive && count > 0 && place[1] > 0 && place[1] <= 10);
  OK(physim_emitter_do(world, burst, PHYSIM_EMIT, 1));
  OK(physim_emitter_do(world, burst, PHYSIM_TRIGGER, 0));
  OK(physim_emitter_do(world, fountain, PHYSIM_STOP, 0));
  to.position[0] = 5;
  OK(physim_emitter_move(world, fountain, &to, 0));
  OK(physim_emitter_move(world, burst, &to, 100));
  OK(physim_emitter_read(world, fountain, &info));
  CHECK(!info.playing);
  IS(PHYSIM_BAD_ARGUMENT, physim_emitter_do(world, fountain, PHYSIM_EMIT, NAN));
  IS(PHYSIM_NOT_FOUND, physim_emitter_read(world, nobody, &info));

  IS(PHYSIM_REFUSED,
     physim_world_add_kind(world, def, "ball", 0, PHYSIM_ASK_HITS, &kind)); /* it asks, and there is no function */
  OK(physim_world_set_hit_function(world, all_stop, &struck));
  OK(physim_world_add_kind(world, def, "ball", 0, PHYSIM_ASK_HITS, &kind));
  launches.z = zs;
  OK(physim_world_spawn(world, kind, 2, &launches, ball, NULL));
  rod.a = ball[0];
  rod.b = ball[1];
  OK(physim_world_add_joint(world, &rod, &joint));
  rod.b = ball[0];
  IS(PHYSIM_REFUSED, physim_world_add_joint(world, &rod, &burst));
  rod.b = ball[1];
  OK(physim_world_add_force_function(world, pull, &pulled, ball, 1, 0, &force));
  OK(physim_world_step(world, 10, 0));
  CHECK(pulled > 0);
  OK(physim_joint_read(world, joint, &state));
  CHECK(is_near(state.length, 2, 1e-6) && state.taut);
  OK(physim_world_projectile(world, ball[1], &one));
  CHECK(one.position[2] > 2); /* it is pulled along by the rod */
  OK(physim_world_remove(world, PHYSIM_A_JOINT, joint));
  IS(PHYSIM_NOT_FOUND, physim_joint_read(world, joint, &state));
  rod.break_force = fabs(state.tension) / 2;
  OK(physim_world_add_joint(world, &rod, &joint));
  OK(physim_world_step(world, 1, 0));
  OK(physim_joint_events(world, events, sizeof events[0], 4, &count));
  CHECK(count == 1 && strcmp(physim_name("joint_event", events[0].kind), "broke") == 0);
  rod.break_force = 0;
  OK(physim_world_remove(world, PHYSIM_A_FORCE, force));
  test_axes(world, ball);
  OK(physim_world_add_joint(world, &rod, &joint));
  OK(physim_world_despawn(world, ball, 1, NULL));
  OK(physim_joint_events(world, events, sizeof events[0], 4, &count));
  CHECK(count >= 1 && strcmp(physim_name("joint_event", events[count - 1].kind), "ended") == 0);

  OK(physim_world_add_force(world, def, "lift", ball + 1, 1, NULL, &force));
  OK(physim_world_add_force(world, def, "1", NULL, 0, NULL, &force));
  OK(physim_world_add_force(world, def, "band", NULL, 0, ball + 1, &force));
  IS(PHYSIM_REFUSED, physim_world_add_force(world, def, "band", NULL, 0, NULL, &force));
  OK(physim_world_read(world, &counts));
  CHECK(counts.forces == 3);
  OK(physim_world_remove(world, PHYSIM_AN_EMITTER, fountain));
  IS(PHYSIM_REFUSED, physim_world_remove(world, PHYSIM_AN_EMITTER, fountain));
  OK(physim_free(world));
  OK(physim_free(def));
}

/* Balls of one metre at 0, 10 and 20 m: who is in a ball, in a box, and along a ray. */
static void test_queries(void) {
  static const char text[] =
      "physim = 1\n[[shot]]\nspeed = 0\nfidelity = \"game\"\nbody.collision.radius = \"1 m\"\n"
      "[world]\nduration = \"1 s\"\nground = \"none\"\n";
  physim_def* def = made(text);
  physim_world* world = NULL;
  uint32_t kind = 0;
  const double x[3] = {0, 10, 20};
  const double middle[3] = {5, 0, 0}, half[3] = {1, 1, 1};
  const physim_segment ray = {{-5, 0, 0}, {15, 0, 0}, 0, 0, 0};
  physim_transform at = {.size = sizeof at, .position = {20, 0, 1.5}};
  physim_launches launches = {.size = sizeof launches};
  physim_projectile_hit hits[2];
  physim_id ids[3], found[3];
  size_t count = 0;
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_add_kind(world, def, NULL, 0, 0, &kind));
  launches.x = x;
  OK(physim_world_spawn(world, kind, 3, &launches, ids, NULL));
  OK(physim_world_in_ball(world, middle, 4.5, 1, found, 3, &count));
  CHECK(count == 2 && found[0].index == ids[0].index && found[1].index == ids[1].index);
  OK(physim_world_in_ball(world, middle, 4.5, 2, found, 3, &count));
  CHECK(count == 0);
  OK(physim_world_in_box(world, &at, half, 1, found, 3, &count));
  CHECK(count == 1 && found[0].index == ids[2].index);
  OK(physim_world_cast(world, &ray, 1, hits, sizeof hits[0], 2, &count));
  CHECK(count == 2 && hits[0].id.index == ids[0].index && is_near(hits[0].part, 0.2, 1e-12));
  CHECK(is_near(hits[1].position[0], 9, 1e-12) && is_near(hits[1].normal[0], -1, 1e-12));
  IS(PHYSIM_BAD_ARGUMENT, physim_world_in_ball(world, middle, -1, 1, found, 3, &count));
  OK(physim_free(world));
  OK(physim_free(def));
}

static void test_functions(void) {
  physim_def* def = made(kParts);
  physim_world *world = NULL, *loaded = NULL;
  physim_flight *calm = NULL, *blown = NULL;
  physim_sample a = {.size = sizeof a}, b = {.size = sizeof b};
  physim_functions functions = {.size = sizeof functions};
  physim_bytes* save = NULL;
  double wind = 20, push = 3, struck = 0;
  const void* data = NULL;
  size_t size = 0;
  uint32_t kind = 0;
  uint64_t hash = 0, again = 0;
  OK(physim_fly(def, "ball", NULL, &calm));
  OK(physim_set_wind_function(def, gale, &wind));
  OK(physim_set_field_function(def, tow, &push));
  OK(physim_fly(def, "ball", NULL, &blown));
  OK(physim_flight_at(calm, PHYSIM_AT_TIME, 2, &a));
  OK(physim_flight_at(blown, PHYSIM_AT_TIME, 2, &b));
  CHECK(b.position[2] > a.position[2] && b.position[0] > a.position[0] + 5); /* 3 m/s^2 for 2 s: 6 m, less drag */
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_add_kind(world, def, "ball", 0, 0, &kind));
  OK(physim_world_spawn(world, kind, 1, NULL, NULL, NULL));
  OK(physim_world_step(world, 10, 0));
  OK(physim_save(world, &save));
  OK(physim_bytes_data(save, &data, &size));
  IS(PHYSIM_REFUSED, physim_world_load(data, size, NULL, NULL, &loaded)); /* it lacks its functions */
  functions.wind = gale;
  functions.wind_user = &wind;
  functions.field = tow;
  functions.field_user = &push;
  functions.hit = all_stop;
  functions.hit_user = &struck;
  OK(physim_world_load(data, size, NULL, &functions, &loaded));
  OK(physim_world_step(world, 10, 0));
  OK(physim_world_step(loaded, 10, 0.01));
  OK(physim_world_hash(world, &hash));
  OK(physim_world_hash(loaded, &again));
  CHECK(hash == again);
  OK(physim_set_wind_function(def, NULL, NULL));
  OK(physim_set(def, "environment.wind.velocity", "[1, 0, 0]"));
  OK(physim_world_set_environment(world, 0, def));
  OK(physim_free(loaded));
  OK(physim_free(world));
  OK(physim_free(save));
  OK(physim_free(blown));
  OK(physim_free(calm));
  OK(physim_free(def));
}

static void test_hits(void) {
  physim_def* def = made(kParts);
  physim_world* world = NULL;
  physim_id ball, wall;
  physim_projectile one = {.size = sizeof one};
  uint32_t kind = 0;
  double struck = 0;
  OK(physim_set(def, "shape.1.name", "box"));
  OK(physim_set(def, "shape.1.box.half", "[1, 100, 100]"));
  OK(physim_set(def, "thing.1.shape", "box"));
  OK(physim_set(def, "thing.1.name", "wall"));
  OK(physim_set(def, "thing.1.position", "[10, 100, 0]"));
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_scene_find(world, "wall", &wall));
  OK(physim_world_set_hit_function(world, all_stop, &struck));
  OK(physim_world_add_kind(world, def, "ball", 0, PHYSIM_ASK_HITS, &kind));
  OK(physim_world_spawn(world, kind, 1, NULL, &ball, NULL));
  OK(physim_world_step(world, 200, 0));
  OK(physim_world_projectile(world, ball, &one));
  CHECK(is_near(struck, 9, 1e-6) && is_near(one.position[0], 9, 1e-6));
  CHECK(strcmp(physim_name("life", one.life), "landed") == 0);
  OK(physim_free(world));
  OK(physim_free(def));
}

/* Calls that change a world otherwise. */
static void test_changes(void) {
  physim_def* def = made(kWorld);
  physim_world* world = NULL;
  physim_id ids[3], moving, force, wall;
  physim_projectile one = {.size = sizeof one};
  physim_world_info info = {.size = sizeof info};
  physim_launches launches = {.size = sizeof launches};
  physim_states states = {.size = sizeof states};
  physim_transform to = {.size = sizeof to};
  physim_hit hit;
  const physim_segment ray = {{0, 5, 0}, {100, 5, 0}, 0, 0, 0};
  double delay[3] = {0, 0.5, 1}, spin[9] = {0, 0, 10, 0, 0, 0, 0, 0, 0};
  const double place[3] = {0, 50, 0}, velocity[3] = {1, 2, 3}, belt[3] = {2, 0, 0}, too_fast[3] = {2e6, 0, 0};
  uint32_t moon = 0, kind = 0, light = 0, steps = 0;
  size_t count = 0, pulled = 0;
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_set(def, "environment.gravity.acceleration", "1.62"));
  OK(physim_set(def, "environment.gravity.model", "constant"));
  OK(physim_world_add_environment(world, def, &moon));
  OK(physim_world_add_kind(world, def, NULL, 0, 0, &kind));
  OK(physim_world_add_kind(world, def, NULL, moon, 0, &light));
  IS(PHYSIM_REFUSED, physim_world_add_kind(world, def, NULL, moon + 1, 0, &light));
  launches.delay = delay;
  OK(physim_world_spawn(world, kind, 3, &launches, ids, &count));
  CHECK(count == 3);
  OK(physim_world_spawn(world, light, 1, NULL, &moving, NULL));
  OK(physim_world_step(world, 20, 0));
  OK(physim_world_projectile(world, ids[2], &one));
  CHECK(strcmp(physim_name("life", one.life), "pending") == 0);
  OK(physim_world_projectile(world, moving, &one));
  CHECK(one.acceleration[1] < -1.62 && one.acceleration[1] > -4); /* with some drag */
  OK(physim_world_set_environment(world, moon, def));
  OK(physim_world_set_detail(world, def));
  OK(physim_world_spawn_moving(world, def, "ball", place, velocity, 2, &moving));
  OK(physim_world_projectile(world, moving, &one));
  CHECK(one.position[1] == 50 && one.velocity[2] == 3 && is_near(one.age, 2, 1e-6));

  states.angular_velocity = spin;
  OK(physim_world_put(world, ids, 1, &states, &count));
  CHECK(count == 1);
  OK(physim_world_rest(world, &moving, 1, 1, &count));
  CHECK(count == 1);
  OK(physim_world_projectile(world, moving, &one));
  CHECK(one.asleep);
  OK(physim_world_rest(world, &moving, 1, 0, &count));
  OK(physim_world_rest(world, &moving, 1, 0, &count));
  CHECK(count == 0); /* it is awake */
  OK(physim_world_add_force_function(world, pull, &pulled, &moving, 1, 0, &force));
  OK(physim_world_release(world, force, &moving, 1, &count));
  CHECK(count == 1);

  OK(physim_scene_find(world, "wall", &wall));
  OK(physim_scene_set_layers(world, wall, 2));
  OK(physim_scene_cast(world, &ray, 1, 1, &hit, sizeof hit, NULL));
  CHECK(hit.thing.index == 0);
  OK(physim_scene_cast(world, &ray, 1, 2, &hit, sizeof hit, NULL));
  CHECK(hit.thing.index == wall.index);
  OK(physim_scene_set_conveyor(world, wall, belt));
  IS(PHYSIM_REFUSED, physim_scene_set_conveyor(world, wall, too_fast));
  OK(physim_scene_set_conveyor(world, wall, NULL));

  OK(physim_world_do(world, PHYSIM_PAUSE, 1));
  OK(physim_world_advance(world, 0.05, &steps));
  CHECK(steps == 0);
  OK(physim_world_do(world, PHYSIM_SINGLE_STEP, 0));
  OK(physim_world_do(world, PHYSIM_PAUSE, 0));
  OK(physim_world_do(world, PHYSIM_TIME_SCALE, 0.5));
  OK(physim_world_advance(world, 0.11, &steps));
  CHECK(steps == 5);
  IS(PHYSIM_REFUSED, physim_world_do(world, PHYSIM_TIME_SCALE, -1));
  OK(physim_world_do(world, PHYSIM_CLEAR, 0));
  OK(physim_world_read(world, &info));
  CHECK(info.projectiles == 0);
  to.position[0] = 1;
  IS(PHYSIM_REFUSED, physim_emitter_move(world, wall, &to, -1));
  OK(physim_free(world));
  OK(physim_free(def));
}

/* A program that was compiled with a shorter struct gets what it knows, and nothing behind it. */
static void test_shorter_structs(void) {
  physim_def* def = made(kWorld);
  physim_world* world = NULL;
  physim_id id;
  uint32_t kind = 0;
  struct {
    physim_projectile known;
    double behind;
  } room = {.known = {.size = offsetof(physim_projectile, acceleration)}, .behind = 7};
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_add_kind(world, def, NULL, 0, 0, &kind));
  OK(physim_world_spawn(world, kind, 1, NULL, &id, NULL));
  room.known.acceleration[1] = room.known.angular_velocity[2] = 5;
  OK(physim_world_projectile(world, id, &room.known));
  CHECK(room.known.velocity[0] > 0 && room.known.acceleration[1] == 5 && room.known.angular_velocity[2] == 5);
  CHECK(room.behind == 7 && room.known.size == offsetof(physim_projectile, acceleration));
  OK(physim_free(world));
  OK(physim_free(def));
}

/* What a function does to the world that calls it: reading is fine, changes are refused, its end waits for the step. */
struct seen {
  physim_world* world;
  int calls;
  physim_result step, read, freed;
};
static void meddle(void* user, const physim_force_batch* batch) {
  struct seen* seen = user;
  physim_world_info info = {.size = sizeof info};
  (void)batch;
  if (seen->calls++ > 0) return;
  seen->step = physim_world_step(seen->world, 1, 0);
  seen->read = physim_world_read(seen->world, &info);
  seen->freed = physim_free(seen->world);
}
static void test_inside_of_a_step(void) {
  physim_def* def = made(kWorld);
  struct seen seen = {.calls = 0};
  physim_id id, force;
  uint32_t kind = 0;
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &seen.world));
  OK(physim_world_add_kind(seen.world, def, NULL, 0, 0, &kind));
  OK(physim_world_spawn(seen.world, kind, 1, NULL, &id, NULL));
  OK(physim_world_add_force_function(seen.world, meddle, &seen, &id, 1, 0, &force));
  OK(physim_world_step(seen.world, 3, 0));
  CHECK(seen.calls >= 3 && seen.step == PHYSIM_REFUSED && seen.read == PHYSIM_OK && seen.freed == PHYSIM_OK);
  IS(PHYSIM_BAD_HANDLE, physim_world_step(seen.world, 1, 0));
  OK(physim_free(def));
}

void test_worlds(void) {
  test_world();
  test_scene();
  test_parts();
  test_queries();
  test_functions();
  test_hits();
  test_changes();
  test_shorter_structs();
  test_inside_of_a_step();
}
