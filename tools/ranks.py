#!/usr/bin/env python3
"""Measures what two ranks of `physim study` reach beside two processes that know nothing of each other.

    tools/ranks.py PHYSIM [FILE] [--shots N] [--rounds N] [--mpirun MPIRUN]

In turn, round by round: one process on one thread flies N shots; two processes fly N each, side by side; one process
on two threads, and two ranks, fly 2 N. Prints the time and the processor time of a shot, least and median, and how
they compare within each round (1.00x: as fast as two processes together; two ranks should reach 0.95). What a run
takes to begin and to end is taken off, by a run of one shard each. Where there is no mpirun, or PHYSIM was built without MPI,
it says so and leaves the ranks out.
"""
import argparse
import os
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

SHARD = 4096  # shots


def run_all(commands):
    """Time and processor time of programs that run side by side [s]."""
    before, begun = os.times(), time.monotonic()
    running = [subprocess.Popen(c, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) for c in commands]
    said = [each.communicate()[1] for each in running]
    taken, after = time.monotonic() - begun, os.times()
    for each, text in zip(running, said):
        if each.returncode != 0:
            sys.exit(f"{' '.join(each.args)} ended with {each.returncode}:\n{text}")
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return taken, used


def why_no_ranks(asked, mpirun):
    if not mpirun:
        return "there is no mpirun: ranks are left out (on Debian it comes with openmpi-bin)"
    lone = dict(os.environ, PMI_SIZE="2")  # as a launcher says it; a build without MPI refuses that
    ran = subprocess.run([asked.physim, "study", asked.file, "--shots", "1"], env=lone, capture_output=True, text=True)
    return "this physim was built without MPI: ranks are left out" if "without MPI" in ran.stderr else None


def main():
    root = Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("physim")
    parser.add_argument("file", nargs="?", default=str(root / "scenarios/study_308.toml"))
    parser.add_argument("--shots", type=int, default=2_000_000, help="of one process")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--mpirun", default=shutil.which("mpirun"))
    asked = parser.parse_args()

    def study(shots, threads=1):
        return [asked.physim, "study", asked.file, "--shots", str(shots), "--threads", str(threads)]

    def ranks(shots):
        return [asked.mpirun, "--oversubscribe", "--allow-run-as-root", "-n", "2", asked.physim, "study", asked.file,
                "--shots", str(shots)]

    n = -(-asked.shots // SHARD) * SHARD
    ways = {  # shots in all, and the programs of a number of shots in all
        "one process": (n, lambda shots: [study(shots)]),
        "two processes": (2 * n, lambda shots: [study(shots // 2)] * 2),
        "two threads": (2 * n, lambda shots: [study(shots, 2)]),
    }
    reason = why_no_ranks(asked, asked.mpirun)
    if reason:
        print(reason)
    else:
        ways["two ranks"] = (2 * n, lambda shots: [ranks(shots)])
    figures = {way: [] for way in ways}
    for _ in range(asked.rounds):
        for way, (shots, programs) in ways.items():
            idle, of_start = run_all(programs(2 * SHARD))
            taken, used = run_all(programs(shots))
            flown = shots - 2 * SHARD
            figures[way].append(((taken - idle) / flown * 1e9, (used - of_start) / flown * 1e9))
    print(f"{'':14}{'time [ns a shot]':>24}{'processor [ns a shot]':>26}{'beside two processes':>30}")
    print(f"{'':14}{'least':>14}{'median':>10}{'least':>16}{'median':>10}{'in time':>18}{'in processor':>14}")
    for way, rounds in figures.items():
        cells = f"{way:14}"
        for k, wide in ((0, 14), (1, 16)):
            of_rounds = [each[k] for each in rounds]
            cells += f"{min(of_rounds):>{wide}.0f}{statistics.median(of_rounds):>10.0f}"
        for k, wide in ((0, 17), (1, 13)):
            ratio = statistics.median(two[k] / own[k] for two, own in zip(figures["two processes"], rounds))
            cells += f"{ratio:>{wide}.2f}x"
        print(cells)


if __name__ == "__main__":
    main()
