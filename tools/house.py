#!/usr/bin/env python3
"""The house in figures: `./dev house`.

Ways and gates are lists that a reader can check: each entry names its file and a text that stands there, and an entry
whose text is gone is an error (exit status 1), so that the lists follow the code.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Ways through a step: name, file, a text of it.
WAYS = [
    ("march of any rung, one lane or packs", "src/solve/march.hpp", "class March"),
    ("loop over known steps of one flight", "src/flight/known_loop.cpp", "KnownLoop"),
    ("known steps of packs", "src/flight/known_pack_steps.hpp", "PHYSIM_ISA_BEGIN"),
    ("frames of the march", "src/solve/march.hpp", "take_frame"),
    ("stages of forced steps", "src/solve/stages.hpp", "PHYSIM_ISA_BEGIN"),
    ("rows, pushed or not, of any rung", "src/world/step/step_rows.hpp", "bool step_packs("),
    ("forced rows, stage by stage", "src/world/step/forced_rows.hpp", "advance_packs"),
    ("settling", "src/world/step/settle.cpp", "class Settling"),
    ("settling of a step that was taken elsewhere", "src/world/step/settled_row.hpp", "taken_"),
    ("settling of a driven step", "src/world/step/settled_row.hpp", "find_drive"),
    ("strikes in packs", "src/world/step/strike_packs.hpp", "struct Strike"),
    ("parts of steps in packs", "src/world/step/part_flights.cpp", "PartFlights::fly_lanes"),
]

# Gates, which say who may take a way: file and a text of it.
GATES = [
    ("src/world/core/static_rungs.hpp", "static_rung_of"),
    ("src/world/core/registry.hpp", "bool steps_plainly("),
    ("src/world/step/forced_step.cpp", "bool steps_with_free("),
    ("src/world/step/part_flights.cpp", "void PartFlights::find("),
    ("src/world/step/struck_rows.cpp", "may_strike"),
    ("src/world/couple/birth_batch.cpp", "bool are_alike("),
    ("src/world/door/world_step.cpp", "bool only_falls("),
    ("src/world/couple/emitter_step.cpp", "bool EmitterBirths::sees_ahead("),
    ("src/flight/known_pack_steps.hpp", "matches"),
    ("src/flight/known_step.hpp", "bool may_go_on("),
]

# Types on one emitter birth: name and file.
BIRTH = [
    ("Emission", "src/emit/emission.hpp"), ("Timeline", "src/emit/timeline.hpp"), ("EmitMoment", "src/emit/timeline.hpp"),
    ("Emitter", "src/world/core/emitters.hpp"), ("EmitterBirths", "src/world/couple/emitter_step.cpp"),
    ("EmitterScratch", "src/world/couple/emitter_step.hpp"), ("Firing", "src/world/couple/emitter_firing.hpp"),
    ("FiringQueue", "src/world/couple/emitter_firing.hpp"), ("BirthPlan", "src/world/couple/birth_columns.hpp"),
    ("BirthColumns", "src/world/couple/birth_columns.hpp"), ("FlownParts", "src/world/step/part_flights.hpp"),
    ("BirthBatches", "src/world/couple/birth_batch.hpp"), ("PartFlights", "src/world/step/part_flights.hpp"),
    ("Particle", "src/world/core/emitters.hpp"),
    ("Joining", "src/world/core/emitters.hpp"), ("EmitterWatch", "src/world/couple/emitter_watch.hpp"),
    ("Pose", "src/world/couple/emitter_pose.hpp"),
]

# A step of first order, v + a h, written out.
EULER = re.compile(r"\bv \+ (?:acceleration\(.*\)|a) \* \w+")
TYPE = re.compile(r"^\s*(?:template <[^>]*>\s*)?(?:struct|class|enum class|enum)\s+(?:\[\[\w+\]\]\s*)?(\w+)[^;()]*\{", re.M)
ALIAS = re.compile(r"^\s*using\s+(\w+)\s*=", re.M)

# The private dialect of comments: what plain English says otherwise.
DIALECT = re.compile(
    r"\b(?:who(?:ever|se)?|nobody|somebody|anybody|everybody|tells?|told|born|so many|so much|so far|so long|"
    r"is none|no number|knows nothing|knows? of|asks? for|let out|lets out|goes? on|as it is|likewise|anew|"
    r"of its own|by itself|in turn|come by|has come)\b", re.I)


def files(*patterns):
    out = subprocess.run(["git", "ls-files", *patterns], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return [ROOT / name for name in out.split()]


def text(path):
    return Path(path).read_text(encoding="utf-8", errors="replace")


def lines(paths):
    return sum(text(p).count("\n") for p in paths)


def drawn_by(name):
    """Files of ours that a file includes, itself among them."""
    seen, left = set(), [ROOT / name]
    while left:
        path = left.pop()
        if path in seen:
            continue
        seen.add(path)
        for found in re.findall(r'^\s*#\s*include\s*"([^"]+)"', text(path), re.M):
            for folder in ("src", "include"):
                if (ROOT / folder / found).is_file():
                    left.append(ROOT / folder / found)
    return seen


def comments(paths):
    for path in paths:
        for line in text(path).split("\n"):
            at = line.find("//")
            if at >= 0 and not line[at:].startswith("// -----"):
                yield line[at:]


def share_of_dialect(paths):
    all_of_them = list(comments(paths))
    return sum(1 for c in all_of_them if DIALECT.search(c)) / max(1, len(all_of_them)), len(all_of_them)


def check(entries, what):
    gone = [(path, part) for path, part in entries if not (ROOT / path).is_file() or part not in text(ROOT / path)]
    for path, part in gone:
        print(f"{path}: no \"{part}\"; mend the list of {what} in tools/house.py", file=sys.stderr)
    return not gone


def main():
    sources = files("src/*.cpp", "src/*.hpp")
    public = files("include/*.hpp", "include/*.h")
    tests = files("tests/*.cpp", "tests/*.hpp")
    guides = [p for p in files("docs/*.md", "README.md") if "notes" not in p.parts]
    good = check([(path, part) for _, path, part in WAYS], "ways")
    good &= check(GATES, "gates")
    good &= check([(path, name) for name, path in BIRTH], "types on a birth")
    verbose = "--list" in sys.argv
    print(f"ways through a step                         {len(WAYS):8}")
    if verbose:
        for name, path, _ in WAYS:
            print(f"    {name}: {path}")
    print(f"gates that choose one                       {len(GATES):8}")
    if verbose:
        for path, part in GATES:
            print(f"    {path}: {part}")
    print(f"types on one emitter birth                  {len(BIRTH):8}")
    drawn = drawn_by("src/flight/fly.cpp")
    print(f"files that src/flight/fly.cpp includes      {len(drawn):8}")
    print(f"    folders of src among them               {len({p.parent for p in drawn if 'src' in p.parts}):8}")
    euler = [(p.relative_to(ROOT), n + 1) for p in sources if "solve" not in p.parts
             for n, line in enumerate(text(p).split("\n")) if EULER.search(line)]
    print(f"spellings of v + a h outside src/solve      {len(euler):8}")
    if verbose:
        for path, line in euler:
            print(f"    {path}:{line}")
    kinds = {name for p in public for name in TYPE.findall(text(p))}
    aliases = {name for p in public for name in ALIAS.findall(text(p))}
    print(f"public headers                              {len(public):8}")
    print(f"public types (and aliases)                  {len(kinds):8} ({len(aliases)})")
    print(f"files of src; in the largest folder         {len(sources):8} "
          f"({max(sum(1 for p in sources if p.parent == f) for f in {p.parent for p in sources})})")
    print(f"lines of src                                {lines(sources):8}")
    print(f"lines of include                            {lines(public):8}")
    print(f"lines of tests                              {lines(tests):8}")
    print(f"words of guides (notes aside)               {sum(len(text(p).split()) for p in guides):8}")
    for name, paths in (("src and include", sources + public), ("include", public)):
        share, count = share_of_dialect(paths)
        print(f"dialect in comments of {name:20} {100 * share:8.1f} % of {count}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
