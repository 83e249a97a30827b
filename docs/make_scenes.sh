#!/usr/bin/env bash
# Takes pictures of 16 scenes, to be looked at: docs/make_scenes.sh FOLDER [WIDTHxHEIGHT [THEME [SCENE ...]]], with
# SIMCLIENT=path/to/simclient and a display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
simclient=${SIMCLIENT:-build/release/bin/simclient}
folder=${1:?which folder?} size=${2:-1280x800} theme=${3:-day}
wanted=" ${*:4} "
mkdir -p "$folder"

scene() { # name, script, scenario
  [[ $wanted == "  " || $wanted == *" $1 "* ]] || return 0
  "$simclient" --hidden --size "$size" --screenshot "$folder/$1.png" --script "theme $theme; $2" ${3:+"scenarios/$3.toml"}
}

scene gallery "gallery; wait 3"
scene rifle "trail-colour speed; fire-whole; wait 60; vectors; wait 1" 308_168gr_g7
scene golf "fire-whole; wait 210" golf_drive
scene shell "fire-whole; faster; faster; faster; faster; faster; wait 100" 105mm_m1_six_dof
scene rocket "fire; wait 240" model_rocket
scene brick "fire; wait 400" nesc_case03
scene orbit "faster; faster; faster; faster; faster; faster; faster; faster; fire-whole; wait 900" low_orbit
scene gun "wait 130" emit_machine_gun
scene mortar "fire; shot high; fire; wait 500" mortar_over_hill
scene billiards "wait 70" billiards
scene fireworks "wait 330" emit_fireworks
scene explosion "wait 60" world_sparks
scene compare "compare; fire-compared; wait 100" golf_drive
scene study "study-run; wait 120" study_308
scene target "target 20 1.5 0; set shot.fidelity.preset=small_arms; shot rifle_bullet; turn-right; fire; wait 8"
scene test_5 "test 5; wait 120"
