/* The C interface from C99: settings, flights, batches, aim, fit, fidelity, studies. Prints what fails. */
#include "check.h"

int failures = 0;

static const char kFirst[] =
    "physim = 1\n[[shot]]\nname = \"first\"\nmass = \"175 gr\"\ndiameter = \"7.82 mm\"\nspeed = \"800 m/s\"\n"
    "elevation = \"2 deg\"\ndrag = { table = \"g7\", ballistic_coefficient = \"0.243 lb/in^2\" }\n";

int is_near(double a, double b, double within) { return fabs(a - b) <= within; }

physim_def* made(const char* text) {
  physim_def* def = NULL;
  OK(physim_def_create(text, "test.toml", &def));
  return def;
}

static void test_settings(void) {
  physim_def *def = NULL, *copy = NULL;
  char text[64];
  size_t length = 0, count = 0;
  double number = 0;
  OK(physim_def_create(NULL, NULL, &def));
  OK(physim_set(def, "drag.table", "g7"));
  OK(physim_set(def, "shot.mass", "175 gr"));
  OK(physim_set_number(def, "speed", 800));
  OK(physim_get(def, "shot.drag.table", text, sizeof text, &length));
  CHECK(strcmp(text, "g7") == 0 && length == 2);
  OK(physim_get_number(def, "mass", &number));
  CHECK(is_near(number, 0.01133980925, 1e-15));
  OK(physim_def_copy(def, &copy));
  OK(physim_set(copy, "mass", "1 kg"));
  OK(physim_get(def, "mass", text, sizeof text, NULL));
  CHECK(strcmp(text, "0.01133980925 kg") == 0);
  IS(PHYSIM_TOO_SMALL, physim_get(def, "mass", text, 4, &length));
  CHECK(strcmp(text, "0.0") == 0 && length == 16);
  OK(physim_get(def, "mass", NULL, 0, &length));
  CHECK(length == 16);

  IS(PHYSIM_REFUSED, physim_set(def, "shot.mas", "1 kg"));
  CHECK(strcmp(physim_last_place(), "shot.mas") == 0 && strstr(physim_last_hint(), "shot.mass") != NULL);
  CHECK(strcmp(physim_last_error(), "shot.mas: error: unknown setting \"shot.mas\"; did you mean \"shot.mass\"?") == 0);
  IS(PHYSIM_REFUSED, physim_set(def, "shot.mass", "1 ft"));
  IS(PHYSIM_REFUSED, physim_set(def, "shot.mass", "-1 kg"));
  IS(PHYSIM_REFUSED, physim_set(def, "shot.mass", " "));
  IS(PHYSIM_BAD_ARGUMENT, physim_set_number(def, "shot.mass", NAN));
  IS(PHYSIM_NOT_FOUND, physim_get(def, "shot.preset", text, sizeof text, NULL));
  IS(PHYSIM_NOT_FOUND, physim_get_number(def, "drag.table", &number));
  OK(physim_get(def, "mass", text, sizeof text, NULL));
  CHECK(strcmp(text, "0.01133980925 kg") == 0);

  OK(physim_set(def, "thing.1.name", "wall"));
  OK(physim_set(def, "thing.1.shape", "box"));
  OK(physim_count(def, "thing", &count));
  CHECK(count == 1);
  IS(PHYSIM_REFUSED, physim_check(def)); /* there is no such shape yet */
  OK(physim_set(def, "shape.1.name", "box"));
  OK(physim_set(def, "shape.1.box.half", "[0.1, 5, 5]"));
  OK(physim_check(def));
  OK(physim_text(def, NULL, 0, &length));
  CHECK(length > 100);
  IS(PHYSIM_REFUSED, physim_def_create("physim = 1\n[[shot]]\nmass = -1\n", "bad.toml", &copy));
  CHECK(strcmp(physim_last_place(), "bad.toml:3:8") == 0);
  IS(PHYSIM_REFUSED, physim_def_load("no such file", &def));
  OK(physim_free(copy));
  OK(physim_free(def));
  IS(PHYSIM_BAD_HANDLE, physim_free(def));
  IS(PHYSIM_BAD_HANDLE, physim_set(def, "mass", "1 kg"));
  OK(physim_free(NULL));
}

static void test_list_of_settings(void) {
  physim_setting setting = {.size = sizeof setting};
  size_t i, lives = 0;
  CHECK(physim_setting_count() > 300);
  for (i = 0; i < physim_setting_count(); ++i) {
    OK(physim_setting_at(i, &setting));
    CHECK(setting.path[0] != '\0' && setting.type[0] != '\0' && setting.doc[0] != '\0');
    lives += setting.live != 0;
  }
  CHECK(lives > 10);
  IS(PHYSIM_NOT_FOUND, physim_setting_at(i, &setting));
}

static void test_flight(void) {
  physim_def* def = made(kFirst);
  physim_flight *flight = NULL, *other = NULL;
  physim_flight_info info = {.size = sizeof info};
  physim_sample at = {.size = sizeof at}, end = {.size = sizeof end}, later = {.size = sizeof later};
  physim_launch launch = {.size = sizeof launch};
  double time[5], x[5], y[5], jerk[3];
  physim_samples columns = {.size = sizeof columns};
  physim_event events[4];
  size_t count = 0;
  OK(physim_fly(def, NULL, NULL, &flight));
  OK(physim_flight_read(flight, &info));
  CHECK(info.outcome == PHYSIM_LANDED && strcmp(physim_name("outcome", info.outcome), "landed") == 0);
  OK(physim_flight_at(flight, PHYSIM_AT_RANGE, 600, &at));
  CHECK(is_near(at.range, 600, 1e-6) && at.speed > 400 && at.speed < 700);
  OK(physim_flight_at(flight, PHYSIM_AT_APEX, 0, &at));
  CHECK(is_near(at.velocity[1], 0, 1e-3));
  OK(physim_flight_at(flight, PHYSIM_AT_END, 0, &end));
  CHECK(end.time == info.duration && is_near(end.position[1], 0, 1e-6));
  IS(PHYSIM_NOT_FOUND, physim_flight_at(flight, PHYSIM_AT_RANGE, 1e6, &at));
  /* The jerk is the slope of the acceleration. */
  OK(physim_flight_jerk(flight, 0.5, jerk));
  OK(physim_flight_at(flight, PHYSIM_AT_TIME, 0.49, &at));
  OK(physim_flight_at(flight, PHYSIM_AT_TIME, 0.51, &later));
  CHECK(jerk[0] > 1 && is_near(jerk[0], (later.acceleration[0] - at.acceleration[0]) / 0.02, 0.01 * jerk[0]));
  IS(PHYSIM_BAD_ARGUMENT, physim_flight_jerk(flight, NAN, jerk));
  IS(PHYSIM_BAD_ARGUMENT, physim_flight_at(flight, PHYSIM_AT_TIME, NAN, &at));
  columns.time = time;
  columns.x = x;
  columns.y = y;
  OK(physim_flight_samples(flight, NULL, 5, &columns));
  CHECK(time[0] == 0 && time[4] == info.duration && x[4] == end.position[0] && y[4] == end.position[1]);
  OK(physim_flight_events(flight, 0, events, sizeof events[0], 4, &count));
  CHECK(count == info.events && count >= 2);
  CHECK(strcmp(physim_name("event", events[count - 1].kind), "ground") == 0);
  OK(physim_flight_events(flight, 100, events, sizeof events[0], 4, &count));
  CHECK(count == 0);

  launch.given = PHYSIM_SPEED;
  launch.speed = 400;
  OK(physim_fly(def, "first", &launch, &other));
  OK(physim_flight_at(other, PHYSIM_AT_END, 0, &at));
  CHECK(at.position[0] < end.position[0]);
  launch.speed = NAN;
  IS(PHYSIM_BAD_ARGUMENT, physim_fly(def, "1", &launch, &other));
  IS(PHYSIM_NOT_FOUND, physim_fly(def, "second", NULL, &other));
  IS(PHYSIM_BAD_HANDLE, physim_fly((const physim_def*)(const void*)flight, NULL, NULL, &other));
  CHECK(strstr(physim_last_error(), "another kind") != NULL);
  OK(physim_free(other));
  OK(physim_free(flight));
  OK(physim_free(def));
}

static void test_batch(void) {
  enum { kShots = 100 };
  physim_def* def = made(kFirst);
  physim_pool* pool = NULL;
  double speed[kShots], x[kShots];
  int32_t outcome[kShots];
  physim_launches launches = {.size = sizeof launches};
  physim_ends ends = {.size = sizeof ends};
  physim_batch_info info = {.size = sizeof info};
  physim_flight* flight = NULL;
  physim_launch launch = {.size = sizeof launch};
  physim_sample end = {.size = sizeof end};
  int i;
  for (i = 0; i < kShots; ++i) speed[i] = 700 + i;
  speed[7] = NAN;
  launches.speed = speed;
  ends.x = x;
  ends.outcome = outcome;
  OK(physim_pool_create(2, &pool));
  OK(physim_batch(def, NULL, kShots, &launches, NULL, &ends, pool, &info));
  CHECK(info.refused == 1 && outcome[7] == PHYSIM_WAS_REFUSED && isnan(x[7]) && info.first_error[0] != '\0');
  launch.given = PHYSIM_SPEED;
  launch.speed = speed[42];
  OK(physim_fly(def, NULL, &launch, &flight));
  OK(physim_flight_at(flight, PHYSIM_AT_END, 0, &end));
  CHECK(end.position[0] == x[42]);
  OK(physim_batch(def, NULL, 3, NULL, NULL, &ends, NULL, NULL));
  CHECK(x[0] == x[1] && x[1] == x[2] && x[0] == x[100 - 1 - 99]);
  IS(PHYSIM_BAD_ARGUMENT, physim_batch(def, NULL, 0, &launches, NULL, &ends, NULL, NULL));
  IS(PHYSIM_BAD_ARGUMENT, physim_batch(def, NULL, 1, &launches, NULL, NULL, NULL, NULL));
  OK(physim_free(flight));
  OK(physim_free(pool));
  OK(physim_free(def));
}

/* -------------------------------------------------------------------------------- aim, fit, fidelity, studies */
static void test_solving(void) {
  physim_def *def = made(kFirst), *fitted = NULL;
  physim_target target = {.size = sizeof target};
  physim_aim_info aim = {.size = sizeof aim};
  physim_flight* flight = NULL;
  physim_launch launch = {.size = sizeof launch};
  physim_sample at = {.size = sizeof at};
  physim_measurement measured[2];
  physim_fit_info fit = {.size = sizeof fit};
  physim_purpose purpose = {.size = sizeof purpose};
  physim_fidelity_info fidelity = {.size = sizeof fidelity};
  double before = 0, after = 0;
  int i;
  target.position[0] = 1000;
  target.position[1] = 20;
  target.position[2] = 5;
  OK(physim_aim(def, NULL, &target, &aim));
  CHECK(aim.in_reach && aim.low.found && aim.low.miss <= 0.01 && aim.explanation[0] != '\0');
  launch.given = PHYSIM_ELEVATION | PHYSIM_AZIMUTH;
  launch.elevation = aim.low.elevation;
  launch.azimuth = aim.low.azimuth;
  OK(physim_fly(def, NULL, &launch, &flight));
  OK(physim_flight_at(flight, PHYSIM_AT_TIME, aim.low.time, &at));
  CHECK(is_near(at.position[0], 1000, 0.02) && is_near(at.position[1], 20, 0.02) && is_near(at.position[2], 5, 0.02));
  target.position[0] = 1e6;
  OK(physim_aim(def, NULL, &target, &aim));
  CHECK(!aim.in_reach && !aim.low.found);
  IS(PHYSIM_REFUSED, physim_aim(def, NULL, NULL, &aim)); /* the def has no target */
  OK(physim_set(def, "target.position", "[500, 0, 0]"));
  OK(physim_aim(def, NULL, NULL, &aim));
  CHECK(aim.in_reach);
  OK(physim_free(flight));

  /* Speeds of a bullet with a tenth more drag are fitted by a scale of 1.1. */
  OK(physim_def_copy(def, &fitted));
  OK(physim_get_number(def, "drag.ballistic_coefficient", &before));
  OK(physim_set_number(fitted, "drag.ballistic_coefficient", before / 1.1));
  OK(physim_fly(fitted, NULL, NULL, &flight));
  for (i = 0; i < 2; ++i) {
    OK(physim_flight_at(flight, PHYSIM_AT_RANGE, 300 + 300 * i, &at));
    measured[i].range = 300 + 300 * i;
    measured[i].speed = at.speed;
    measured[i].drop = measured[i].time = NAN;
  }
  OK(physim_free(fitted));
  OK(physim_fit(def, NULL, measured, 2, NULL, &fit, &fitted));
  CHECK(is_near(fit.scale, 1.1, 1e-4));
  OK(physim_get_number(fitted, "drag.ballistic_coefficient", &after));
  CHECK(is_near(after, before / 1.1, 1e-2));
  IS(PHYSIM_BAD_ARGUMENT, physim_fit(def, NULL, measured, 0, NULL, &fit, NULL));
  OK(physim_free(fitted));

  purpose.error = 0.05;
  purpose.time = 1;
  purpose.ground = NAN;
  OK(physim_choose_fidelity(def, NULL, &purpose, &fidelity, &fitted));
  CHECK(fidelity.error <= 0.05 && fidelity.cost < fidelity.truth_cost && fidelity.explanation[0] != '\0');
  OK(physim_check(fitted));
  OK(physim_free(fitted));
  OK(physim_free(flight));
  OK(physim_free(def));
}

static void test_answers(void) {
  physim_def* def = made(kFirst);
  physim_farthest far = {.size = sizeof far};
  const char* const presets[2] = {"game", "reference"};
  const char* const unknown[1] = {"gane"};
  physim_compared rows[2];
  physim_flight* reference = NULL;
  physim_sample end = {.size = sizeof end};
  physim_straight thrown = {NAN, 20, NAN, -10, NAN}, found[2];
  size_t count = 0;

  /* Without air and over even ground the farthest elevation is 45 degrees, and the range v^2 / g. */
  OK(physim_set(def, "fidelity", "game"));
  OK(physim_set(def, "fidelity.drag", "off"));
  OK(physim_set(def, "environment.gravity.acceleration", "9.80665"));
  OK(physim_max_range(def, NULL, 0, 0, 0, &far));
  CHECK(is_near(far.elevation, atan(1.0), 1e-3) && is_near(far.range, 800 * 800 / 9.80665, 1));
  CHECK(is_near(far.position[0], far.range, 1) && far.velocity[1] < 0 && far.flights > 2);
  IS(PHYSIM_REFUSED, physim_max_range(def, NULL, 0, 0, 1, &far)); /* it flies for longer */

  OK(physim_free(def));
  def = made(kFirst);
  OK(physim_compare(def, NULL, presets, 2, rows, sizeof rows[0], &reference));
  CHECK(rows[0].largest_distance > rows[1].largest_distance && rows[1].largest_distance < 1e-3);
  CHECK(rows[0].steps > 0 && rows[1].evaluations > rows[1].steps);
  OK(physim_flight_at(reference, PHYSIM_AT_END, 0, &end));
  CHECK(end.range > 1000);
  IS(PHYSIM_REFUSED, physim_compare(def, NULL, unknown, 1, rows, sizeof rows[0], NULL));
  CHECK(strstr(physim_last_hint(), "game") != NULL);

  thrown.s = 15; /* up and down again */
  OK(physim_suvat(&thrown, found, &count));
  CHECK(count == 2 && is_near(found[0].t, 1, 1e-12) && is_near(found[1].t, 3, 1e-12) &&
        is_near(found[1].v, -10, 1e-12));
  thrown.s = 25;
  IS(PHYSIM_REFUSED, physim_suvat(&thrown, found, &count)); /* it never gets there */
  OK(physim_free(reference));
  OK(physim_free(def));
}

/* Studies that end by time and by the width of a figure. */
static void test_ends_of_studies(void) {
  physim_def* def = made(kFirst);
  physim_study* study = NULL;
  physim_part *some = NULL, *all = NULL, *whole = NULL;
  physim_figures *figures = NULL, *again = NULL;
  physim_figures_info sums = {.size = sizeof sums};
  physim_quantity q = {.size = sizeof q}, r = {.size = sizeof r};
  physim_study_info info = {.size = sizeof info};
  OK(physim_set(def, "speed", "800 m/s +- 3 m/s"));
  OK(physim_set(def, "until.range", "300 m"));
  OK(physim_set(def, "study.shots", "150000"));
  OK(physim_set(def, "study.targets", "[\"plate: rectangle 30 cm x 20 cm at 0 m, 9.9 m\"]"));
  OK(physim_study_create(def, NULL, &study));
  OK(physim_study_read(study, &info));
  OK(physim_study_run(study, NULL, 1e-9, NULL, &some, &figures));
  OK(physim_figures_read(figures, &sums));
  CHECK(sums.time_was_up && !sums.width_reached && sums.shards >= 1 && sums.shards < info.shards);
  OK(physim_free(figures));
  OK(physim_study_run(study, some, 0, NULL, &all, &figures));
  OK(physim_figures_read(figures, &sums));
  CHECK(!sums.time_was_up && sums.shards == info.shards);
  OK(physim_study_fly(study, 0, info.shards, NULL, &whole));
  OK(physim_study_figures(study, whole, 0, &again));
  OK(physim_figures_quantity(figures, 1, &q));
  OK(physim_figures_quantity(again, 1, &r));
  CHECK(q.mean == r.mean && q.deviation == r.deviation);
  OK(physim_free(again));
  OK(physim_free(figures));
  OK(physim_study_set_width(study, NULL, 1, 8 * q.error)); /* the whole has an interval of 3.92 errors */
  OK(physim_study_run(study, NULL, 0, NULL, NULL, &figures));
  OK(physim_figures_read(figures, &sums));
  CHECK(sums.width_reached && sums.shards < info.shards);
  OK(physim_free(figures));
  OK(physim_study_set_width(study, "plate", 0, 0.5));
  OK(physim_study_run(study, NULL, 0, NULL, NULL, &figures));
  OK(physim_figures_read(figures, &sums));
  CHECK(sums.width_reached && sums.shards < info.shards);
  IS(PHYSIM_NOT_FOUND, physim_study_set_width(study, "plat", 0, 0.5));
  IS(PHYSIM_NOT_FOUND, physim_study_set_width(study, NULL, 99, 0.5));
  IS(PHYSIM_BAD_ARGUMENT, physim_study_run(study, NULL, 0, NULL, NULL, NULL));
  OK(physim_free(figures));
  OK(physim_free(some));
  OK(physim_free(all));
  OK(physim_free(whole));
  OK(physim_free(study));
  OK(physim_free(def));
}

static void test_study(void) {
  physim_def* def = made(kFirst);
  physim_study *study = NULL, *other = NULL;
  physim_study_info info = {.size = sizeof info};
  physim_part *a = NULL, *b = NULL, *all = NULL, *whole = NULL, *loaded = NULL;
  physim_figures *figures = NULL, *again = NULL;
  physim_figures_info sums = {.size = sizeof sums};
  physim_quantity q = {.size = sizeof q}, r = {.size = sizeof r};
  physim_chance chance = {.size = sizeof chance};
  physim_bytes *bytes = NULL, *joined = NULL;
  const void *data = NULL, *data2 = NULL;
  size_t size = 0, size2 = 0;
  double median = 0;
  OK(physim_set(def, "speed", "800 m/s +- 3 m/s"));
  OK(physim_set(def, "until.range", "300 m"));
  OK(physim_set(def, "study.shots", "10000"));
  OK(physim_set(def, "study.targets", "[\"plate: rectangle 30 cm x 20 cm at 0 m, 9.9 m\"]"));
  OK(physim_study_create(def, NULL, &study));
  OK(physim_study_read(study, &info));
  CHECK(info.shards == 3 && info.inputs == 1 && info.targets == 1);
  OK(physim_study_fly(study, 2, 1, NULL, &b));
  OK(physim_study_fly(study, 0, 2, NULL, &a));
  IS(PHYSIM_REFUSED, physim_study_figures(study, a, 0, &figures)); /* a shard is missing */
  OK(physim_part_join(b, a, &all));
  IS(PHYSIM_REFUSED, physim_part_join(all, a, &whole)); /* shards of a are there */
  OK(physim_study_fly(study, 0, 3, NULL, &whole));
  OK(physim_save(all, &joined));
  OK(physim_save(whole, &bytes));
  OK(physim_bytes_data(bytes, &data, &size));
  OK(physim_bytes_data(joined, &data2, &size2));
  CHECK(size == size2 && memcmp(data, data2, size) == 0);
  OK(physim_part_load(data, size, &loaded));
  IS(PHYSIM_REFUSED, physim_part_load(data, size / 2, &loaded));
  OK(physim_study_figures(study, all, 0, &figures));
  OK(physim_study_figures(study, loaded, 0, &again));
  OK(physim_figures_read(figures, &sums));
  CHECK(sums.shots == 3 * info.shard_shots && sums.targets == 1 && sums.quantities >= 2);
  OK(physim_figures_quantity(figures, 1, &q));
  OK(physim_figures_quantity(again, 1, &r));
  CHECK(strcmp(physim_name("quantity", q.quantity), "up") == 0 && q.mean == r.mean && q.deviation > 0);
  OK(physim_figures_quantile(figures, 1, 0.5, &median));
  CHECK(is_near(median, q.mean, q.deviation));
  OK(physim_figures_target(figures, 0, &chance));
  CHECK(strcmp(chance.target, "plate") == 0 && chance.probability >= 0 && chance.low <= chance.high);
  IS(PHYSIM_NOT_FOUND, physim_figures_quantity(figures, 99, &q));
  OK(physim_set(def, "study.seed", "2"));
  OK(physim_study_create(def, NULL, &other));
  IS(PHYSIM_REFUSED, physim_study_figures(other, whole, 0, &again));
  OK(physim_free(study));
  OK(physim_free(other));
  OK(physim_free(a));
  OK(physim_free(b));
  OK(physim_free(all));
  OK(physim_free(whole));
  OK(physim_free(loaded));
  OK(physim_free(figures));
  OK(physim_free(again));
  OK(physim_free(bytes));
  OK(physim_free(joined));
  OK(physim_free(def));
}

int main(void) {
  test_settings();
  test_list_of_settings();
  test_flight();
  test_batch();
  test_worlds();
  test_more_worlds();
  test_solving();
  test_answers();
  test_study();
  test_ends_of_studies();
  if (failures == 0) printf("PhySim %s from C: all as it must be\n", physim_version());
  return failures != 0;
}
