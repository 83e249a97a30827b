/* A study from C, by shards: two processes may fly them, and their parts are joined. */
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
  physim_set(def, "sight.zero_range", "300 m");
  physim_set(def, "speed", "800 m/s +- 3 m/s");
  physim_set(def, "environment.wind.velocity", "[0, 0, \"0 m/s +- 1.5 m/s\"]");
  physim_set(def, "until.range", "300 m");
  physim_set(def, "study.shots", "8000");
  physim_set(def, "study.targets", "[\"plate: circle 10 cm\"]");

  physim_study* study = NULL;
  physim_study_info info = {.size = sizeof info};
  if (physim_study_create(def, NULL, &study) != PHYSIM_OK) return failed();
  if (physim_study_read(study, &info) != PHYSIM_OK) return failed();

  physim_part *first = NULL, *rest = NULL, *all = NULL;
  if (physim_study_fly(study, 0, 1, NULL, &first) != PHYSIM_OK) return failed();
  if (physim_study_fly(study, 1, info.shards - 1, NULL, &rest) != PHYSIM_OK) return failed();
  if (physim_part_join(rest, first, &all) != PHYSIM_OK) return failed();

  physim_figures* figures = NULL;
  physim_chance plate = {.size = sizeof plate};
  if (physim_study_figures(study, all, 0, &figures) != PHYSIM_OK) return failed();
  if (physim_figures_target(figures, 0, &plate) != PHYSIM_OK) return failed();
  printf("%s: %.3f, with 95 %% between %.3f and %.3f\n", plate.target, plate.probability, plate.low, plate.high);

  physim_free(figures);
  physim_free(all);
  physim_free(rest);
  physim_free(first);
  physim_free(study);
  physim_free(def);
  return 0;
}
