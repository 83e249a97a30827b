/* The C interface from C99: recordings played by frames, engines behind scenes, trails. */
#include "check.h"

static const char kWall[] =
    "physim = 1\n[[shot]]\nname = \"ball\"\nmass = \"1 kg\"\ndiameter = \"10 cm\"\nspeed = \"20 m/s\"\n"
    "elevation = \"45 deg\"\nfidelity = \"game\"\nbody.collision = { on_hit = \"bounce\", radius = \"5 cm\" }\n"
    "[world]\nstep = \"10 ms\"\nthreads = 1\n"
    "[[shape]]\nname = \"box\"\nbox = { half = [0.5, 5, 5] }\n"
    "[[thing]]\nname = \"wall\"\nshape = \"box\"\nposition = [30, 5, 0]\n";

static const char kFountain[] =
    "physim = 1\n[[shot]]\nname = \"spark\"\nmass = \"1 g\"\ndiameter = \"2 mm\"\nfidelity = \"game\"\nspeed = \"1 "
    "m/s\"\n"
    "[world]\nstep = \"10 ms\"\nthreads = 1\n"
    "[[emitter]]\nname = \"fountain\"\nshot = \"spark\"\nper_second = 100\nseed = 7\nposition = [0, 10, 0]\n";

/* A recording moves a world frame by frame; at its end it is the world that was recorded. */
static void test_replay_by_frames(void) {
  physim_def* def = made(kWall);
  physim_world *world = NULL, *played = NULL, *other = NULL;
  physim_bytes* recording = NULL;
  physim_snapshot* snapshot = NULL;
  physim_replay_info info = {.size = sizeof info};
  physim_states states = {.size = sizeof states};
  double place[3], places[20][3];
  uint32_t kind = 0;
  uint64_t hash = 0, again = 0;
  const void* data = NULL;
  size_t size = 0, count = 0, i;
  int32_t more = 0;
  states.position = place;
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_record(world, 1));
  OK(physim_world_add_kind(world, def, "ball", 0, 0, &kind));
  OK(physim_world_spawn(world, kind, 1, NULL, NULL, NULL));
  for (i = 0; i < 20; ++i) {
    OK(physim_world_step(world, 1, 0));
    OK(physim_world_states(world, NULL, 1, &states, &count));
    memcpy(places[i], place, sizeof place);
  }
  OK(physim_world_stop_recording(world, &recording));
  OK(physim_bytes_data(recording, &data, &size));
  OK(physim_replay_open(data, size, NULL, &played));
  for (i = 0; i < 20; ++i) {
    OK(physim_replay_next(played, 1, &more, &info));
    CHECK(more == 1 && info.steps == i + 1 && info.agrees);
    OK(physim_world_states(played, NULL, 1, &states, &count));
    CHECK(count == 1 && memcmp(places[i], place, sizeof place) == 0);
  }
  IS(PHYSIM_REFUSED, physim_world_step(played, 1, 0));
  IS(PHYSIM_REFUSED, physim_scene_add(played, def, NULL, 0, NULL));
  OK(physim_world_hash(world, &hash));
  OK(physim_world_hash(played, &again));
  CHECK(hash == again);
  OK(physim_replay_next(played, 1, &more, &info));
  CHECK(more == 0 && info.complete && info.agrees && info.hash == hash);
  for (i = 20; i-- > 0;) {
    OK(physim_replay_seek(played, (i * 7) % 20 + 1, &more, &info));
    CHECK(more == 1 && info.steps == (i * 7) % 20 + 1 && info.agrees);
    OK(physim_world_states(played, NULL, 1, &states, &count));
    CHECK(count == 1 && memcmp(places[(i * 7) % 20], place, sizeof place) == 0);
  }
  OK(physim_replay_seek(played, 21, &more, &info));
  CHECK(more == 0 && info.complete && info.agrees && info.hash == hash);
  OK(physim_world_snapshot(played, &snapshot));
  OK(physim_free(recording));
  OK(physim_save(played, &recording));
  OK(physim_bytes_data(recording, &data, &size));
  OK(physim_world_load(data, size, NULL, NULL, &other)); /* a world of its own, from here on */
  OK(physim_world_step(other, 1, 0));
  IS(PHYSIM_REFUSED, physim_replay_next(world, 1, &more, NULL));
  IS(PHYSIM_REFUSED, physim_replay_seek(world, 1, &more, NULL));
  OK(physim_free(snapshot));
  OK(physim_free(recording));
  OK(physim_free(other));
  OK(physim_free(played));
  OK(physim_free(world));
  OK(physim_free(def));
}

/* An engine that has a wall at x = 20 m, and counts segments. */
static void wall(void* user, const physim_engine_batch* batch) {
  size_t i;
  *(size_t*)user += batch->count;
  for (i = 0; i < batch->count; ++i) {
    const physim_segment* s = &batch->segments[i];
    if (!(s->from[0] < 20 && s->to[0] >= 20)) continue;
    batch->hits[i].thing.index = 7;
    batch->hits[i].part = (20 - s->from[0]) / (s->to[0] - s->from[0]);
    batch->hits[i].normal[0] = -1;
  }
}

static void test_engine(void) {
  physim_def* def = made(kWall);
  physim_scene *scene = NULL, *loaded = NULL;
  physim_world* world = NULL;
  physim_bytes* save = NULL;
  physim_engine_info info = {.size = sizeof info};
  physim_functions functions = {.size = sizeof functions};
  physim_projectile one = {.size = sizeof one};
  const physim_segment ray = {{0, 5, 0}, {100, 5, 0}, 0, 0, 0};
  physim_hit hit;
  physim_id ball;
  uint32_t kind = 0;
  size_t asked = 0, size = 0;
  const void* data = NULL;
  OK(physim_scene_create(def, &scene));
  OK(physim_scene_cast(scene, &ray, 1, ~0U, &hit, sizeof hit, NULL));
  CHECK(is_near(hit.position[0], 29.5, 1e-9));
  OK(physim_scene_set_engine(scene, wall, &asked, 0.01));
  OK(physim_scene_cast(scene, &ray, 1, ~0U, &hit, sizeof hit, NULL));
  CHECK(hit.thing.index == 7 && is_near(hit.position[0], 20, 0.011) && asked >= 1);
  OK(physim_scene_read_engine(scene, &info));
  CHECK(info.segments == asked && info.refused == 0);
  IS(PHYSIM_REFUSED, physim_scene_set_engine(scene, wall, &asked, 2));
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_set_scene(world, scene));
  OK(physim_world_add_kind(world, def, "ball", 0, 0, &kind));
  OK(physim_world_spawn(world, kind, 1, NULL, &ball, NULL));
  OK(physim_world_step(world, 200, 0));
  OK(physim_world_projectile(world, ball, &one));
  CHECK(one.velocity[0] < 0 && one.position[0] < 20); /* it bounced */
  OK(physim_save(scene, &save));
  OK(physim_bytes_data(save, &data, &size));
  IS(PHYSIM_REFUSED, physim_scene_load(data, size, NULL, &loaded)); /* it lacks its engine */
  functions.engine = wall;
  functions.engine_user = &asked;
  OK(physim_scene_load(data, size, &functions, &loaded));
  OK(physim_scene_cast(loaded, &ray, 1, ~0U, &hit, sizeof hit, NULL));
  CHECK(hit.thing.index == 7);
  OK(physim_scene_set_engine(loaded, NULL, NULL, 0));
  OK(physim_scene_cast(loaded, &ray, 1, ~0U, &hit, sizeof hit, NULL));
  CHECK(is_near(hit.position[0], 29.5, 1e-9));
  OK(physim_free(save));
  OK(physim_free(loaded));
  OK(physim_free(scene));
  OK(physim_free(world));
  OK(physim_free(def));
}

static void test_trails(void) {
  physim_def* def = made(kFountain);
  physim_world* world = NULL;
  physim_trails trails = {.size = sizeof trails};
  const physim_id stranger = {77, 3};
  physim_id emitter, ids[64];
  uint32_t first[64], count[64];
  double place[64 * 8][3], time[64 * 8];
  size_t particles = 0, places = 0, i;
  OK(physim_set(def, "emitter.1.trail.points", "8"));
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_add_emitter(world, def, NULL, NULL, &emitter));
  OK(physim_world_step(world, 30, 0));
  OK(physim_emitter_trails(world, emitter, NULL, &particles, &places));
  CHECK(particles > 0 && particles <= 64 && places >= particles && places <= 64 * 8);
  trails.id = ids;
  trails.first = first;
  trails.count = count;
  trails.position = place[0];
  trails.time = time;
  OK(physim_emitter_trails(world, emitter, &trails, &particles, &places));
  for (i = 0; i < particles; ++i) {
    physim_projectile one = {.size = sizeof one};
    const size_t last = first[i] + count[i] - 1;
    OK(physim_world_projectile(world, ids[i], &one));
    CHECK(count[i] >= 1 && last < places && memcmp(place[last], one.position, sizeof one.position) == 0);
    CHECK(count[i] == 1 || time[last] > time[first[i]]);
  }
  IS(PHYSIM_NOT_FOUND, physim_emitter_trails(world, stranger, NULL, &particles, &places));
  OK(physim_free(world));
  OK(physim_free(def));
}

/* What is drawn of a world, by ink. */
struct sheet {
  physim_world* world;
  size_t lines, triangles, balls, texts, bodies;
  double middle[3];
};
static void draw_begin(void* user, physim_id projectile) {
  (void)projectile;
  ++((struct sheet*)user)->bodies;
}
static void draw_line(void* user, const double* a, const double* b, int32_t ink) {
  ((struct sheet*)user)->lines += ink == PHYSIM_INK_VELOCITY && b[0] > a[0];
}
static void draw_triangle(void* user, const double* a, const double* b, const double* c, int32_t ink) {
  (void)a, (void)b, (void)c;
  ((struct sheet*)user)->triangles += ink == PHYSIM_INK_SOLID;
}
static void draw_ball(void* user, const double* middle, double radius, int32_t ink) {
  struct sheet* sheet = (struct sheet*)user;
  sheet->balls += ink == PHYSIM_INK_FLYING && is_near(radius, 0.05, 1e-12);
  memcpy(sheet->middle, middle, sizeof sheet->middle);
  CHECK(physim_world_step(sheet->world, 1, 0) != PHYSIM_OK); /* nothing is changed inside */
}
static void test_drawing(void) {
  physim_def* def = made(kWall);
  physim_world* world = NULL;
  physim_drawing what = {.size = sizeof what, .layers = ~0U, .ahead = 0.1};
  physim_canvas canvas = {.size = sizeof canvas, .line = draw_line, .triangle = draw_triangle};
  physim_projectile one = {.size = sizeof one};
  struct sheet sheet = {0};
  physim_id ball;
  uint32_t kind = 0;
  OK(physim_world_create(def, PHYSIM_FIRE_NOTHING, &world));
  OK(physim_world_add_kind(world, def, NULL, 0, 0, &kind));
  OK(physim_world_spawn(world, kind, 1, NULL, &ball, NULL));
  OK(physim_world_step(world, 3, 0));
  OK(physim_world_projectile(world, ball, &one));
  sheet.world = world;
  canvas.user = &sheet;
  canvas.begin = draw_begin;
  canvas.ball = draw_ball;
  OK(physim_world_draw(world, &what, &canvas));
  CHECK(sheet.bodies == 1 && sheet.balls == 1 && sheet.lines == 1 && sheet.triangles == 12);
  CHECK(is_near(sheet.middle[0], one.position[0], 1) && sheet.middle[0] > 0);
  OK(physim_world_step(world, 1, 0));
  what.without_things = 1;
  what.layers = 0;
  OK(physim_world_draw(world, &what, &canvas));
  CHECK(sheet.bodies == 1 && sheet.triangles == 12);
  what.ahead = -1;
  IS(PHYSIM_BAD_ARGUMENT, physim_world_draw(world, &what, &canvas));
  OK(physim_free(world));
  OK(physim_free(def));
}

void test_more_worlds(void) {
  test_drawing();
  test_replay_by_frames();
  test_engine();
  test_trails();
}
