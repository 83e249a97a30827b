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
scene rifle "trail-colour speed; fire-whole; seek 1; vectors; wait 3" 308_168gr_g7
scene golf "fire-whole; seek 4.5; wait 3" golf_drive
scene shell "fire-whole; seek 54; wait 3" 105mm_m1_six_dof
scene rocket "fire; seek 1.6; wait 3" model_rocket
nearer=$(printf 'zoom-in; %.0s' {1..36})$(printf 'zoom-out; %.0s' {1..5})  # as near as it goes, and a little back
scene brick "fire; camera; seek 6.7; wait 3; $nearer wait 3" nesc_case03
scene orbit "fire-whole; seek 3840; wait 3" low_orbit
scene gun "seek 1.96; wait 3" emit_machine_gun
scene mortar "fire; shot high; fire; seek 8.3; wait 3" mortar_over_hill
scene billiards "seek 1.17; wait 3" billiards
scene fireworks "seek 6.2; wait 3" emit_fireworks
scene explosion "seek 1; wait 3" world_sparks
scene compare "compare; fire-compared; seek 1.67; wait 3" golf_drive
scene study "study-run; wait 120" study_308
scene target "target 20 1.5 0; set shot.fidelity.preset=small_arms; shot rifle_bullet; turn-right; fire; wait 8"
scene test_5 "test 5; wait 120"
