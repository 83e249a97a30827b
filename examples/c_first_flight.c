/* One flight from C: settings by path, questions to the flight, errors, a batch in columns. */
#include <stdio.h>

#include "physim/physim.h"

static int failed(void) { return printf("%s\n", physim_last_error()), 1; }

int main(void) {
  physim_def* def = NULL;
  if (physim_def_create(NULL, NULL, &def) != PHYSIM_OK) return failed();
  physim_set(def, "mass", "175 gr");
  physim_set(def, "diameter", "7.82 mm");
  physim_set(def, "drag.table", "g7");
  physim_set(def, "drag.ballistic_coefficient", "0.243 lb/in^2");
  physim_set(def, "speed", "800 m/s");
  physim_set(def, "elevation", "2 deg");
  physim_set(def, "fidelity", "simulation");

  physim_flight* flight = NULL;
  if (physim_fly(def, NULL, NULL, &flight) != PHYSIM_OK) return failed();
  physim_sample at = {.size = sizeof at};
  if (physim_flight_at(flight, PHYSIM_AT_RANGE, 600, &at) == PHYSIM_OK) /* or PHYSIM_NOT_FOUND: it lands before */
    printf("at 600 m: %.2f m high, %.1f m/s, Mach %.2f\n", at.position[1], at.speed, at.mach);
  if (physim_flight_at(flight, PHYSIM_AT_END, 0, &at) == PHYSIM_OK)
    printf("it lands after %.2f s, %.1f m downrange\n", at.time, at.range);

  /* What is wrong, where, and what to do. */
  if (physim_set(def, "shot.mas", "175 gr") == PHYSIM_REFUSED) printf("%s\n", physim_last_error());

  /* Many launches of one shot: columns of the caller's own. */
  double speed[100], range[100];
  for (int i = 0; i < 100; ++i) speed[i] = 790 + 0.2 * i;
  physim_launches launches = {.size = sizeof launches, .speed = speed};
  physim_ends ends = {.size = sizeof ends, .x = range};
  if (physim_batch(def, NULL, 100, &launches, NULL, &ends, NULL, NULL) != PHYSIM_OK) return failed();
  printf("%.0f m/s carries to %.1f m, %.1f m/s to %.1f m\n", speed[0], range[0], speed[99], range[99]);

  physim_free(flight);
  physim_free(def);
  return 0;
}
