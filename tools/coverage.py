#!/usr/bin/env python3
"""Which functions no test runs: coverage.py BUILD_FOLDER, of a build with --coverage whose tests have run.

Prints the share of lines that ran by folder, and each function of which no instance ran.
"""
from __future__ import annotations

import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
OURS = ("src/", "include/", "apps/")


def reports(data: pathlib.Path) -> list[dict]:
    """What gcov says of one object file."""
    with tempfile.TemporaryDirectory() as folder:
        out = subprocess.run(["gcov", "--json-format", "--stdout", str(data)], cwd=folder, capture_output=True, check=True)
    return [json.loads(line) for line in out.stdout.splitlines() if line.startswith(b"{")]


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    build = pathlib.Path(sys.argv[1]).resolve()
    data = sorted(build.rglob("*.gcda"))
    if not data:
        print(f"coverage.py: no test of {build} has run", file=sys.stderr)
        return 1
    lines: dict[str, dict[int, int]] = collections.defaultdict(lambda: collections.defaultdict(int))
    functions: dict[tuple[str, int], tuple[str, int]] = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for report in (each for some in pool.map(reports, data) for each in some):
            for file in report["files"]:
                path = (build / report.get("current_working_directory", ".") / file["file"]).resolve()
                name = str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else ""
                if not name.startswith(OURS):
                    continue
                for line in file["lines"]:
                    lines[name][line["line_number"]] += line["count"]
                for function in file["functions"]:
                    at = (name, function["start_line"])
                    _, count = functions.get(at, ("", 0))
                    functions[at] = (function["demangled_name"], count + function["execution_count"])
    rooms: dict[str, list[int]] = collections.defaultdict(lambda: [0, 0])
    for name, counts in lines.items():
        room = str(pathlib.Path(name).parent)
        rooms[room][0] += sum(count > 0 for count in counts.values())
        rooms[room][1] += len(counts)
    total = [sum(ran for ran, _ in rooms.values()), sum(all_ for _, all_ in rooms.values())]
    for room, (ran, all_) in [*sorted(rooms.items()), ("all", total)]:
        print(f"{room:28} {ran:6} of {all_:6} lines ran  {100 * ran / all_:5.1f} %")
    never = sorted((at, name) for at, (name, count) in functions.items() if count == 0)
    print(f"\n{len(never)} of {len(functions)} functions never ran:")
    for (file, line), name in never:
        print(f"{file}:{line}: {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
