/* A gun range, played: a wall, plates that move, sparks where rounds hit. Drawn by SDL2, flown by PhySim.
 *
 *   up, down      aim higher, lower          space     fire (held: full automatic)
 *   t             slow motion on, off        r         back by two seconds
 *   escape        end
 *
 * c_gun_range --demo FRAMES [PICTURE.bmp] plays by itself, and tells what was hit. */
#include <SDL.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "physim/physim.h"

enum { kWidth = 960, kHeight = 540, kMost = 2048, kPlates = 3, kMoments = 8 };
static const double kMetresAcross = 48, kMuzzle[3] = {1, 1.5, 0};

static const char kRange[] =
    "physim = 1\n"
    "[environment]\n"
    "gravity = \"constant\"\n"
    "[[shot]]\n" /* rounds: they stop in what they hit */
    "name = \"tracer\"\n"
    "mass = \"8 g\"\n"
    "diameter = \"9 mm\"\n"
    "fidelity = \"game\"\n"
    "body.collision.on_hit = \"stop\"\n"
    "[[shot]]\n" /* sparks: they bounce, and glow for a moment */
    "name = \"spark\"\n"
    "mass = \"10 mg\"\n"
    "diameter = \"1 mm\"\n"
    "fidelity = \"game\"\n"
    "body.restitution = 0.4\n"
    "body.collision = { on_hit = \"bounce\", radius = \"1 mm\" }\n"
    "[world]\n"
    "step = \"4 ms\"\n"
    "ground = { mode = \"bounce\", restitution = 0.5 }\n"
    "[[shape]]\n"
    "name = \"wall\"\n"
    "box = { half = [0.4, 4, 3] }\n"
    "[[shape]]\n"
    "name = \"plate\"\n"
    "box = { half = [0.1, 0.7, 0.7] }\n"
    "[[thing]]\n"
    "name = \"wall\"\n"
    "shape = \"wall\"\n"
    "position = [44, 4, 0]\n"
    "[[thing]]\n"
    "name = \"plate\"\n"
    "shape = \"plate\"\n"
    "position = [20, 2, 0]\n"
    "[[emitter]]\n"
    "name = \"sparks\"\n"
    "shot = \"spark\"\n"
    "per_second = 0\n"
    "maximum = 2000\n"
    "when_full = \"replace_oldest\"\n"
    "from = { shape = \"hemisphere\", radius = \"1 cm\" }\n"
    "start = { speed = [\"2 m/s\", \"9 m/s\"], lifetime = [\"0.3 s\", \"1.2 s\"], colour = \"#ffa040\" }\n"
    "life.colour = { colour = \"#ffffff\", gradient = [[0, \"#ffffff\"], [1, \"#ff400000\"]] }\n"
    "[[emitter]]\n"
    "name = \"gun\"\n"
    "shot = \"tracer\"\n"
    "per_second = 0\n"
    "seed = 1\n"
    "start.speed = [\"118 m/s\", \"122 m/s\"]\n"
    "from = { shape = \"cone\", angle = \"0.3 deg\", radius = \"1 mm\" }\n"
    "sub = [{ on = \"hit\", emitter = \"sparks\", count = 24, axis = \"normal\" }]\n";

struct range {
  physim_def* def;
  physim_world* world;
  physim_id gun, sparks, plates[kPlates];
  double elevation, plate_y[kPlates], flash[kPlates];
  int hits, slow;
  physim_snapshot* moments[kMoments]; /* a ring, one each quarter of a second */
  int moment;
  SDL_Renderer* draw;
};

static void check(physim_result result) {
  if (result == PHYSIM_OK) return;
  printf("%s\n", physim_last_error());
  exit(1);
}

static void make(struct range* g) {
  physim_transform to = {.size = sizeof to};
  check(physim_def_create(kRange, "range", &g->def));
  check(physim_world_create(g->def, PHYSIM_FIRE_NOTHING, &g->world));
  check(physim_world_add_emitter(g->world, g->def, "sparks", NULL, &g->sparks));
  check(physim_world_add_emitter(g->world, g->def, "gun", NULL, &g->gun));
  check(physim_scene_find(g->world, "plate", &g->plates[0]));
  for (int i = 0; i < kPlates; ++i) {
    to.position[0] = 16 + 8 * i;
    to.position[1] = 2 + i;
    if (i > 0) check(physim_scene_copy(g->world, g->plates[0], &to, &g->plates[i]));
  }
  g->elevation = 0.06;
}

/* Plates go up and down as the time of the world says, so that they go back with it. */
static void move_plates(struct range* g) {
  physim_world_info now = {.size = sizeof now};
  physim_transform to = {.size = sizeof to};
  check(physim_world_read(g->world, &now));
  for (int i = 0; i < kPlates; ++i) {
    to.position[0] = 16 + 8 * i;
    to.position[1] = g->plate_y[i] = 3.2 + 2.2 * sin(0.9 * now.time + 2 * i);
    check(physim_scene_move(g->world, g->plates[i], &to));
  }
}

static void aim(struct range* g) {
  physim_transform to = {.size = sizeof to};
  memcpy(to.position, kMuzzle, sizeof kMuzzle);
  to.rotation[0] = cos(g->elevation / 2);
  to.rotation[3] = sin(g->elevation / 2);
  check(physim_emitter_move(g->world, g->gun, &to, 0));
}

static void count_hits(struct range* g) {
  physim_event events[128];
  size_t count = 128;
  for (size_t first = 0; count == 128; first += count) {
    check(physim_world_events(g->world, first, events, sizeof events[0], 128, &count));
    for (size_t i = 0; i < count; ++i)
      for (int k = 0; k < kPlates; ++k)
        if (strcmp(physim_name("event", events[i].kind), "hit") == 0 && events[i].thing.index == g->plates[k].index &&
            events[i].energy > 1) { /* a round, and no spark */
          ++g->hits;
          g->flash[k] = 0.25;
        }
  }
}

/* ------------------------------------------------------------------------------------------------------------ drawing
 */
static double scale(void) { return kWidth / kMetresAcross; }
static int across(double x) { return (int)(x * scale()); }
static int down(double y) { return (int)(kHeight - 40 - y * scale()); }

static void rectangle(struct range* g, double x, double y, double half_x, double half_y) {
  SDL_Rect where = {across(x - half_x), down(y + half_y), across(2 * half_x) + 1, (int)(2 * half_y * scale())};
  SDL_RenderFillRect(g->draw, &where);
}

/* Rounds as streaks over the way of their last steps; red, green and blue are the upper bytes of a colour. */
static void draw_rounds(struct range* g) {
  static double position[3 * kMost], previous[3 * kMost];
  physim_particles rounds = {.size = sizeof rounds, .position = position, .previous = previous};
  size_t count = 0;
  check(physim_emitter_particles(g->world, g->gun, kMost, &rounds, &count));
  SDL_SetRenderDrawColor(g->draw, 255, 224, 130, 255);
  for (size_t i = 0; i < count && i < kMost; ++i) {
    const double *at = position + 3 * i, *was = previous + 3 * i;
    SDL_RenderDrawLine(g->draw, across(2 * was[0] - at[0]), down(2 * was[1] - at[1]), across(at[0]), down(at[1]));
  }
}

static void draw_sparks(struct range* g) {
  static double position[3 * kMost];
  static uint32_t colour[kMost];
  physim_particles sparks = {.size = sizeof sparks, .position = position, .colour = colour};
  size_t count = 0;
  check(physim_emitter_particles(g->world, g->sparks, kMost, &sparks, &count));
  for (size_t i = 0; i < count && i < kMost; ++i) {
    const uint32_t c = colour[i];
    const SDL_Rect dot = {across(position[3 * i]) - 1, down(position[3 * i + 1]) - 1, 3, 3};
    SDL_SetRenderDrawColor(g->draw, (Uint8)(c >> 24), (Uint8)(c >> 16), (Uint8)(c >> 8), (Uint8)c);
    SDL_RenderFillRect(g->draw, &dot);
  }
}

static void draw(struct range* g, double seconds) {
  SDL_SetRenderDrawColor(g->draw, 24, 28, 40, 255);
  SDL_RenderClear(g->draw);
  SDL_SetRenderDrawColor(g->draw, 52, 60, 54, 255);
  rectangle(g, kMetresAcross / 2, -2, kMetresAcross / 2, 2); /* the ground */
  SDL_SetRenderDrawColor(g->draw, 96, 84, 76, 255);
  rectangle(g, 44, 4, 0.4, 4); /* the wall */
  for (int i = 0; i < kPlates; ++i) {
    const int is_hit = g->flash[i] > 0;
    SDL_SetRenderDrawColor(g->draw, is_hit ? 250 : 150, is_hit ? 250 : 160, is_hit ? 250 : 175, 255);
    rectangle(g, 16 + 8 * i, g->plate_y[i], 0.1, 0.7);
    g->flash[i] -= seconds;
  }
  SDL_SetRenderDrawColor(g->draw, 200, 205, 215, 255);
  for (int k = -1; k <= 1; ++k) /* the barrel */
    SDL_RenderDrawLine(g->draw, across(kMuzzle[0]) - 24, down(kMuzzle[1]) + k + (int)(24 * tan(g->elevation)),
                       across(kMuzzle[0]), down(kMuzzle[1]) + k);
  draw_rounds(g);
  draw_sparks(g);
  SDL_RenderPresent(g->draw);
}

/* ------------------------------------------------------------------------------------------------------------- playing
 */
static void keep_moment(struct range* g) {
  physim_snapshot** place = &g->moments[g->moment++ % kMoments];
  check(physim_free(*place));
  *place = NULL;
  check(physim_world_snapshot(g->world, place));
}

/* To the oldest moment of the ring. */
static void go_back(struct range* g) {
  physim_snapshot* oldest = g->moments[g->moment % kMoments];
  if (oldest != NULL) check(physim_world_restore(g->world, oldest));
}

/* What a frame does; `fires` and `turn` are what the player wants. */
static void play(struct range* g, int frame, int fires, int turn) {
  const double seconds = 1.0 / 60;
  g->elevation = fmin(fmax(g->elevation + 0.004 * turn, -0.05), 0.5);
  aim(g);
  move_plates(g);
  if (fires && frame % 5 == 0) check(physim_emitter_do(g->world, g->gun, PHYSIM_EMIT, 1));
  check(physim_world_advance(g->world, g->slow ? seconds / 10 : seconds, NULL));
  count_hits(g);
  if (frame % 15 == 0) keep_moment(g);
  draw(g, seconds);
}

/* False when it is over. */
static int look_at_keys(struct range* g) {
  SDL_Event event;
  while (SDL_PollEvent(&event)) {
    if (event.type == SDL_QUIT) return 0;
    if (event.type != SDL_KEYDOWN || event.key.repeat) continue;
    if (event.key.keysym.sym == SDLK_ESCAPE) return 0;
    if (event.key.keysym.sym == SDLK_t) g->slow = !g->slow;
    if (event.key.keysym.sym == SDLK_r) go_back(g);
  }
  return 1;
}

static void save_picture(struct range* g, const char* file) {
  SDL_Surface* picture = SDL_CreateRGBSurfaceWithFormat(0, kWidth, kHeight, 32, SDL_PIXELFORMAT_ARGB8888);
  if (picture == NULL ||
      SDL_RenderReadPixels(g->draw, NULL, SDL_PIXELFORMAT_ARGB8888, picture->pixels, picture->pitch) ||
      SDL_SaveBMP(picture, file))
    printf("%s: %s\n", file, SDL_GetError());
  SDL_FreeSurface(picture);
}

static int demo(struct range* g, int frames, const char* picture) {
  for (int frame = 0; frame < frames; ++frame) {
    play(g, frame, 1, frame / 40 % 2 == 0 ? 1 : -1);
    if (frame == frames * 2 / 3 && g->moment > kMoments) go_back(g);
  }
  if (picture != NULL) save_picture(g, picture);
  physim_world_info info = {.size = sizeof info};
  physim_emitter_info gun = {.size = sizeof gun}, sparks = {.size = sizeof sparks};
  check(physim_world_read(g->world, &info));
  check(physim_emitter_read(g->world, g->gun, &gun));
  check(physim_emitter_read(g->world, g->sparks, &sparks));
  printf("%d rounds, %d hits on plates, %d sparks, %.2f s of the world\n", (int)gun.born, g->hits, (int)sparks.born,
         info.time);
  return frames < 100 || (g->hits > 0 && sparks.born > 0) ? 0 : 1;
}

int main(int count, char** words) {
  struct range g;
  memset(&g, 0, sizeof g);
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return printf("SDL: %s\n", SDL_GetError()), 1;
  SDL_Window* window =
      SDL_CreateWindow("PhySim: gun range", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, kWidth, kHeight, 0);
  g.draw = SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC);
  if (g.draw == NULL) g.draw = SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
  if (g.draw == NULL) return printf("SDL: %s\n", SDL_GetError()), 1;
  SDL_SetRenderDrawBlendMode(g.draw, SDL_BLENDMODE_BLEND);
  make(&g);

  int result = 0;
  if (count > 2 && strcmp(words[1], "--demo") == 0) {
    result = demo(&g, atoi(words[2]), count > 3 ? words[3] : NULL);
  } else {
    for (int frame = 0; look_at_keys(&g); ++frame) {
      const Uint8* keys = SDL_GetKeyboardState(NULL);
      play(&g, frame, keys[SDL_SCANCODE_SPACE], keys[SDL_SCANCODE_UP] - keys[SDL_SCANCODE_DOWN]);
      char title[80];
      snprintf(title, sizeof title, "PhySim: gun range - %d hits%s", g.hits, g.slow ? ", slow motion" : "");
      SDL_SetWindowTitle(window, title);
    }
  }
  for (int i = 0; i < kMoments; ++i) check(physim_free(g.moments[i]));
  check(physim_free(g.world));
  check(physim_free(g.def));
  SDL_DestroyRenderer(g.draw);
  SDL_DestroyWindow(window);
  SDL_Quit();
  return result;
}
