/* What is installed flies from C. */
#include <physim/physim.h>
#include <stdio.h>

int main(void) {
  physim_def* def = NULL;
  physim_flight* flight = NULL;
  physim_flight_info info = {.size = sizeof info};
  if (physim_def_create(NULL, NULL, &def) != PHYSIM_OK || physim_set(def, "speed", "10 m/s") != PHYSIM_OK ||
      physim_set(def, "elevation", "45 deg") != PHYSIM_OK || physim_fly(def, NULL, NULL, &flight) != PHYSIM_OK ||
      physim_flight_read(flight, &info) != PHYSIM_OK)
    return printf("%s\n", physim_last_error()), 1;
  printf("%s\n", physim_name("outcome", info.outcome));
  physim_free(flight);
  physim_free(def);
  return 0;
}
