/* A world from C: a gun that fires by itself, a wall, positions read in bulk into an engine's own structs, events,
 * and a moment to which the world goes back. */
#include <stdio.h>
#include <string.h>

#include "physim/physim.h"

static const char kRange[] =
    "physim = 1\n"
    "[[shot]]\n"
    "name = \"tracer\"\n"
    "preset = \"rifle_bullet\"\n"
    "fidelity = \"game\"\n"
    "body.collision.on_hit = \"stop\"\n"
    "[world]\n"
    "step = \"5 ms\"\n"
    "[[shape]]\n"
    "name = \"wall\"\n"
    "box = { half = [0.2, 2, 10] }\n"
    "[[thing]]\n"
    "name = \"wall\"\n"
    "shape = \"wall\"\n"
    "position = [200, 2, 0]\n"
    "[[emitter]]\n"
    "name = \"gun\"\n"
    "shot = \"tracer\"\n"
    "position = [0, 1.5, 0]\n"
    "gun = { rounds_per_minute = 600, dispersion = \"2 mrad\" }\n"
    "start.speed = \"800 m/s\"\n";

struct sprite { /* an engine's own */
  float place[3];
  physim_id id;
};

static int failed(void) { return printf("%s\n", physim_last_error()), 1; }

int main(void) {
  physim_def* def = NULL;
  physim_world* world = NULL;
  physim_id gun;
  if (physim_def_create(kRange, "range", &def) != PHYSIM_OK) return failed();
  if (physim_world_create(def, PHYSIM_FIRE_NOTHING, &world) != PHYSIM_OK) return failed();
  if (physim_world_add_emitter(world, def, "gun", NULL, &gun) != PHYSIM_OK) return failed();

  size_t hits = 0;
  for (int frame = 0; frame < 120; ++frame) {
    if (physim_world_advance(world, 1.0 / 60, NULL) != PHYSIM_OK) return failed();
    physim_event events[64];
    size_t count = 64;
    for (size_t first = 0; count == 64; first += count) {
      if (physim_world_events(world, first, events, sizeof events[0], 64, &count) != PHYSIM_OK) return failed();
      for (size_t i = 0; i < count; ++i) hits += strcmp(physim_name("event", events[i].kind), "hit") == 0;
    }
  }

  struct sprite sprites[64];
  physim_states into = {.size = sizeof into, .stride = sizeof sprites[0]};
  into.shown_f = sprites[0].place;
  into.id = &sprites[0].id;
  size_t alive = 0;
  if (physim_world_states(world, NULL, 64, &into, &alive) != PHYSIM_OK) return failed();
  printf("%u hits on the wall after two seconds, %u in flight\n", (unsigned)hits, (unsigned)alive);
  for (size_t i = 0; i < alive && i < 64; ++i)
    printf("  %u at %.1f m, %.2f m high\n", (unsigned)sprites[i].id.index, sprites[i].place[0], sprites[i].place[1]);

  physim_snapshot* moment = NULL;
  uint64_t before = 0, after = 0;
  if (physim_world_snapshot(world, &moment) != PHYSIM_OK) return failed();
  physim_world_hash(world, &before);
  physim_world_step(world, 100, 0);
  physim_world_restore(world, moment);
  physim_world_hash(world, &after);
  printf("back at the moment, %s\n", before == after ? "to the bit" : "but not to the bit");

  physim_free(moment);
  physim_free(world);
  physim_free(def);
  return before == after && hits > 10 ? 0 : 1;
}
