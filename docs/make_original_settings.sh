#!/usr/bin/env bash
# Takes a picture of each of the original's 18 settings, its three shots side by side in it:
# docs/make_original_settings.sh FOLDER [WIDTHxHEIGHT], with SIMCLIENT=path/to/simclient and a display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
simclient=${SIMCLIENT:-build/release/bin/simclient}
folder=${1:?which folder?} size=${2:-1280x800}
mkdir -p "$folder"

for motion in velocity force; do
  for gravity in constant force off; do
    for drag in constant force off; do
      keys=  # from the first of each, as the client starts
      [[ $motion == velocity ]] || keys+="motion; "
      case $gravity in force) keys+="gravity; " ;; off) keys+="gravity; gravity; " ;; esac
      case $drag in force) keys+="drag; " ;; off) keys+="drag; drag; " ;; esac
      [[ $motion == velocity ]] && frames=36 || frames=62
      "$simclient" --range --hidden --size "$size" --screenshot "$folder/$motion-$gravity-$drag.png" --script "
        theme day; prediction; $keys
        artillery; set shot.azimuth=-10 deg; fire; bullet; set shot.azimuth=0 deg; fire
        laser; set shot.azimuth=10 deg; fire
        plots; plot x/time y/time speed/time; wait $frames; fit; wait 1"
    done
  done
done
