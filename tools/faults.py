#!/usr/bin/env python3
"""Faults: deliberate mistakes inside the library, put in one at a time; each must be caught by a PHYSIM_ASSERT.

`./dev lint` checks that each has a place to be made at. `./dev faults [WORD ...]` copies the sources to build/faults,
builds the tests without optimisation, then makes each of the mistakes below (or those whose text has one of the words),
builds what it touches and runs a few tests: they must end with "a bug in PhySim", before a wrong number comes out. A
mistake that does not build or is not caught fails.

`./dev faults --random` draws small mistakes by a seed instead: tools/random_faults.py.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import random_faults

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "faults"

# What it is, the file, what stands there, what is put there instead, tests that pass by.
FAULTS = [
    ("a stale row: nobody tells the projectile whose row moved", "src/world/core/placement.cpp",
     "if (moved != 0) state_.slots[moved].row = slot.row;", "static_cast<void>(moved);", "Life.*:World.*"),
    ("a clock that runs back", "src/world/core/clock.hpp", "++run_steps;", "--run_steps;", "Life.*"),
    ("a step that is not counted", "src/world/core/clock.hpp", "++steps;", ";", "Life.*"),
    ("a column never set: velocity", "src/world/core/placement.cpp",
     "    Rows::put(c.velocity, row, at.velocity);\n    if (layout.carried)", "    if (layout.carried)", "Life.*"),
    ("a column never set: the rotor", "src/world/core/placement.cpp", "if (layout.turning) rows.put_rotor(row, *n.rotor);", ";",
     "Rigid*:*RigidWorld*"),
    ("a column never set: the place of launch", "src/world/core/placement.cpp",
     "if (layout.launched) Rows::put(c.launch, row, at.position);", ";", "Life.*:World.*"),
    ("a pool that nobody leaves", "src/world/core/pools.hpp", "--pool.count;", ";", "Life.*:Moments.*:Recording.*"),
    ("one who is gone is counted as alive", "src/world/core/slots.hpp", "--alive_;", ";", "Life.*"),
    ("a generator that is gone still acts", "src/world/core/generators.cpp", "std::erase(order_, index);", ";", "Forces.*:*Force*"),
    ("an event at another time", "src/world/step/settled_row.hpp", "event.time = context_.time + passed;", "event.time = passed - 1;",
     "Ground.*"),
    ("forced rows read one too far", "src/world/step/forced_step.cpp", "first += size;", "first += size + 1;", "*Force*"),
    ("a projectile left in the cohort it was in", "src/world/door/world_change.cpp",
     "  Status status = placement.relocate(id.index);\n  if (!status) slot->flags = before;",
     "  Status status;\n  if (!status) slot->flags = before;", "Life.*"),
    ("columns of floats read as doubles", "src/world/step/settle.cpp", "if (context.state->rows[chunk.cohort].layout().float32)",
     "if (!context.state->rows[chunk.cohort].layout().float32)", "Ground.*"),
    ("a recording's frame that starts behind its end", "src/world/core/recorder.cpp", "open_ = bytes_.size();",
     "open_ = bytes_.size() + 64;", "Recording.*"),
    ("calls that are left twice", "src/world/core/recorder.hpp", "recorder_->leave();",
     "recorder_->leave(), recorder_->leave();", "Recording.*"),
    ("a pool of tables that the conditions do not point to", "src/prepare/cohort.cpp", "pool.point(conditions);", ";",
     "Flight.*:Batch.*"),
    ("dense output without its coefficients", "src/flight/path_keeper.hpp",
     "path.coefficients.insert(path.coefficients.end(), dense.coefficient, dense.coefficient + count);", ";", "Flight.*"),
    ("a flight that ends before it began", "src/flight/lane_flight.hpp",
     "end(verdict.outcome, sound ? path_.since_start(j_->at.time(verdict.theta))",
     "end(verdict.outcome, sound ? -1 - path_.since_start(j_->at.time(verdict.theta))", "Flight.*"),
    ("a bore without unit length", "src/model/sight.cpp", "return sight.bore(sincos_of(",
     "return 2 * sight.bore(sincos_of(", "Flight.*:Zero.*"),
    ("a curve with a piece too few", "src/math/interpolation.cpp", "PiecewiseCubic::operator()(double x) const {",
     "PiecewiseCubic::operator()(double x) const {\n  const_cast<PiecewiseCubic*>(this)->pieces.pop_back();",
     "Interpolation.*:*Interpol*:Drag*"),
    ("a motor that burns twice", "src/model/motor.cpp", "delivered += lasts *", "delivered += 2 * lasts *", "*Motor*"),
    ("a grant of more than was asked", "src/prepare/grant.cpp", "    if (field == granted) return;\n",
     "    if (field == granted) std::swap(field, granted = Enum{});\n", "Grant*:*Fidelity*"),
]


def check(find):
    """For tools/lint.py, find(path, line, message): every mistake still has a place to be made at."""
    for what, file, there, _, _ in FAULTS:
        if (ROOT / file).read_text(encoding="utf-8").count(there) != 1:
            find("tools/faults.py", 1, f"{what}: {file} does not have it once any more")


def build():
    return subprocess.run(["cmake", "--build", str(COPY / "build"), "-j", str(os.cpu_count() or 2), "--target",
                           "physim_tests"], check=False, stdout=subprocess.PIPE, text=True)


def caught(tests):
    """The assert that ended the tests; nothing where none did."""
    done = subprocess.run([str(COPY / "build" / "bin" / "physim_tests"), f"--gtest_filter={tests}", "--gtest_brief=1"],
                          check=False, capture_output=True, text=True)
    said = re.search(r"(\S+: a bug in PhySim: .*)", done.stderr)
    return said.group(1).removeprefix("../../").removeprefix("tree/") if said else ""


def copy_sources():
    names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.split("\0")
    for name in names:
        source, target = ROOT / name, COPY / "tree" / name
        if name and source.is_file() and not (target.exists() and target.read_bytes() == source.read_bytes()):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)


def main(words):
    copy_sources()
    if words[:1] == ["--random"]:
        return random_faults.main(COPY, words[1:])
    subprocess.run(["cmake", "-S", str(COPY / "tree"), "-B", str(COPY / "build"), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                    "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DPHYSIM_ISAS=base", "-DPHYSIM_SMALL_KERNELS=ON",
                    "-DPHYSIM_CLIENT=OFF"],
                   check=True, stdout=subprocess.DEVNULL)
    if build().returncode != 0:
        sys.exit("faults: the sources do not build")
    missed = 0
    for what, file, there, instead, tests in FAULTS:
        if words and not any(word in what for word in words):
            continue
        source = COPY / "tree" / file
        whole = source.read_text(encoding="utf-8")
        if whole.count(there) != 1:
            sys.exit(f"faults: {file} has {whole.count(there)} times: {there}")
        source.write_text(whole.replace(there, instead), encoding="utf-8")
        made = build()
        by = caught(tests) if made.returncode == 0 else ""
        source.write_text(whole, encoding="utf-8")
        missed += not by
        print(f"{what}: {by or ('NOT CAUGHT' if made.returncode == 0 else 'DOES NOT BUILD: ' + made.stdout[-400:])}",
              flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
