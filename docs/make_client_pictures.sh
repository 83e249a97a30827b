#!/usr/bin/env bash
# Takes the pictures of SimClient into docs/pictures: `./dev docs`, or SIMCLIENT=path/to/simclient with a display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
simclient=${SIMCLIENT:-build/release/bin/simclient}
pictures=docs/pictures

"$simclient" --hidden --size 1280x800 --screenshot "$pictures/client.png" \
  --script "trail-colour speed; fire; shot high; fire; seek 8.3; plots; wait 3" scenarios/mortar_over_hill.toml

"$simclient" --hidden --size 1280x800 --screenshot "$pictures/client_compare.png" \
  --script "compare; camera; camera; wait 1; fire-compared; wait 60; fit; wait 1" scenarios/308_168gr_g7.toml

"$simclient" --hidden --size 1280x800 --screenshot "$pictures/client_things.png" \
  --script "settings; fit; wait 70; hits; wait 1; fit; wait 1" scenarios/billiards.toml

"$simclient" --hidden --size 1280x800 --screenshot "$pictures/client_study.png" \
  --script "settings; statistics; study-at 400 m; study-at apex; study-run; wait 200" scenarios/study_308.toml

"$simclient" --hidden --size 640x400 scenarios/golf_drive.toml \
  --script "theme dusk; fire-whole; wait 480; picture-size 1; picture-of-scene $pictures/client_share.png; wait 1"

for test in 1 2 3 4 5 6; do
  "$simclient" --hidden --size 1120x720 \
    --script "test $test; wait 200; picture-of-plots $pictures/client_test_$test.png; wait 1"
done
python3 tools/shrink_png.py --shades 64 "$pictures"/client*.png
pngquant --strip --force --skip-if-larger --ext .png 128 "$pictures"/client_things.png || [[ $? == 98 ]]
for picture in client client_compare client_study; do  # whole windows
  pngquant --strip --force --skip-if-larger --ext .png 64 "$pictures/$picture.png" || [[ $? == 98 ]]
done
