#!/usr/bin/env python3
"""Flies the studies of docs/rockets_uncertainty.md and prints the page's tables of results.

    tools/rockets_uncertainty.py PHYSIM FOLDER [SHOTS]

FOLDER has NAME_rigid.toml for each of the rockets, with the measured apogee among their expectations. The spreads are
those of the page's first table.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

WIND = 1.6  # m/s, of each component
# thrust and drag as parts of one, mass in g, elevation and azimuth in degrees
ROCKETS = {
    "valetudo": ("Valetudo", 0.0249, 0.0382, 1, 1, 2),
    "ndrt2020": ("NDRT 2020", 0.033, 0.227, 10, 1, 3),
    "bella_lui": ("Bella Lui", 0.03, 0.05, 10, 1, 5),
    "genesis": ("Genesis", 0.033, 0.05, 10, 1, 5),
    "cavour": ("Cavour", 0.033, 0.05, 10, 1, 5),
    "andromeda": ("Andromeda", 0.033, 0.05, 10, 1, 5),
}
SHOWN = ["shot.motor.thrust", "shot.drag.form_factor", "shot.mass", "shot.elevation", "shot.azimuth",
         "environment.wind.velocity.x", "environment.wind.velocity.z"]


def inputs_of(thrust, drag, mass, elevation, azimuth):
    return [f"shot.motor.thrust = 1 +- {thrust}", f"shot.drag.form_factor = 1 +- {drag}", f"shot.mass = +- {mass} g",
            f"shot.elevation = +- {elevation} deg", f"shot.azimuth = +- {azimuth} deg",
            f"environment.wind.velocity.x = +- {WIND} m/s", f"environment.wind.velocity.z = +- {WIND} m/s"]


def measured_in(text):
    """The apogee [m] of the expectation whose source is the flight."""
    for block in text.split("[[expect]]")[1:]:
        if "measured in flight" in block:
            return float(re.search(r'equals = "([0-9.]+) m"', block).group(1))
    raise SystemExit("no measured apogee among the expectations")


def study(physim, file, inputs, shots):
    command = [physim, "study", str(file), "--set", 'study.quantities=["y"]', "--shots", str(shots), "--json", "-"]
    for text in inputs:
        command += ["--vary", text]
    ran = subprocess.run(command, capture_output=True, text=True)
    if ran.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{ran.stderr}")
    if ran.stderr:
        print(ran.stderr, file=sys.stderr)
    return json.loads(ran.stdout)


def main():
    if len(sys.argv) not in (3, 4):
        raise SystemExit(__doc__)
    physim, folder, shots = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) == 4 else 4096
    rows, shares, half, most = [], [], 0, 0
    for name, (title, *spreads) in ROCKETS.items():
        file = folder / f"{name}_rigid.toml"
        found = study(physim, file, inputs_of(*spreads), shots)
        figure = {f["name"]: f["value"] for f in found["figures"]}
        measured = measured_in(file.read_text())
        q = {p: figure[f"y.quantile_{p} [m]"] for p in ("0.05", "0.25", "0.5", "0.75", "0.95")}
        in_half, in_most = q["0.25"] <= measured <= q["0.75"], q["0.05"] <= measured <= q["0.95"]
        half, most = half + in_half, most + in_most
        rows.append(f"| {title} | {measured:.0f} | {q['0.5']:.0f} | {q['0.05']:.0f} .. {q['0.95']:.0f} | "
                    f"{'yes' if in_most else 'no'} | {q['0.25']:.0f} .. {q['0.75']:.0f} | "
                    f"{'yes' if in_half else 'no'} |")
        part = {row["path"]: row["share"][0] for row in found["inputs"]}
        shares.append(f"| {title} | {figure['y.deviation [m]']:.0f} | " +
                      " | ".join(f"{100 * part[path]:.1f}" for path in SHOWN) + " |")
        print(name, "done", figure["refused"], "refused", figure["not_arrived"], "did not arrive", file=sys.stderr)
    print("| rocket | measured [m] | median [m] | 90 % interval [m] | holds it | 50 % interval [m] | holds it |")
    print("|---|---|---|---|---|---|---|\n" + "\n".join(rows))
    print(f"\nCoverage: {most} of {len(rows)} at 90 %, {half} of {len(rows)} at 50 %.\n")
    print("| share of the variance [%] | deviation [m] | thrust | drag | mass | elevation | azimuth | wind downrange | "
          "wind aside |")
    print("|---|---|---|---|---|---|---|---|---|\n" + "\n".join(shares))


if __name__ == "__main__":
    main()
