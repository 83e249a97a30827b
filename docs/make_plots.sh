#!/usr/bin/env bash
# Draws the pictures of the documentation into docs/pictures: `./dev docs`, or PHYSIM=path/to/physim docs/make_plots.sh.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
physim=${PHYSIM:-build/release/bin/physim}
pictures=docs/pictures
mkdir -p "$pictures"

# draw SCENARIO: all its shots in one picture. draw_shot SCENARIO SHOT: one of them.
draw() { "$physim" run "scenarios/$1.toml" --plot "$pictures/$1.png" >/dev/null; }
draw_shot() {
  local folder
  folder=$(mktemp -d)
  "$physim" run "scenarios/$1.toml" --out "$folder" >/dev/null
  mv "$folder/$1_$2.png" "$pictures/"
  rm -r "$folder"
}

"$physim" compare scenarios/308_168gr_g7.toml --plot "$pictures/ladder.png" >/dev/null
"$physim" compare scenarios/105mm_m1_six_dof.toml --plot "$pictures/105mm_m1_ladder.png" >/dev/null
draw 308_168gr_g7
draw cannonball_galileo
draw_shot lob_16km shell
draw_shot golf_drive drive
draw model_rocket
draw 105mm_m1_six_dof
draw original_artillery
draw original_test_3
draw original_test_6
draw original_test_3_drag
draw original_test_6_drag

# Of worlds: fewer projectiles, lighter pictures. Their checks count what is not there, so the exit code says nothing.
draw_world() {
  local name=$1
  shift
  "$physim" run "scenarios/world_$name.toml" "$@" --plot "$pictures/world_$name.png" >/dev/null || [[ $? == 1 ]]
}
draw_world force_field --set volley.count=12
draw_world machine_gun --set volley.count=30 --set title="Machine gun: 30 rounds on a wall at 100 m"

# Of emitters, at a moment when there is much to be seen.
draw_emitters() {
  local name=$1
  shift
  "$physim" run "scenarios/emit_$name.toml" "$@" --plot "$pictures/emit_$name.png" >/dev/null || [[ $? == 1 ]]
}
draw_emitters fountain --set world.duration="2.5 s" --set title="Fountain: a ring of jets"
draw_emitters machine_gun
draw_emitters fireworks --set world.duration="11 s"
draw_emitters shotgun
draw_emitters rain
draw_emitters volcano --set world.duration="16 s"
draw_emitters spiral

"$physim" study scenarios/study_308.toml --plot "$pictures/study_308.png" >/dev/null
"$physim" study scenarios/study_model_rocket.toml --plot "$pictures/study_model_rocket.png" >/dev/null
"$physim" study scenarios/study_308.toml --over-inputs 12 --target "head: circle 10 cm" \
  --plot "$pictures/study_308_inputs.png" >/dev/null
"$physim" study scenarios/study_308.toml --ranges "100 m .. 1000 m step 100 m" --shots 20000 --target "head: circle 10 cm" \
  --plot "$pictures/study_308_ranges.png" >/dev/null

# A picture of 128 colours looks the same and is a third as large; those of the original have few lines, and need fewer.
pngquant --strip --force --skip-if-larger --ext .png 40 "$pictures"/original_*.png || [[ $? == 98 ]]
pngquant --strip --force --skip-if-larger --ext .png 128 "$pictures"/{[!c],cannon}*.png || [[ $? == 98 ]]
