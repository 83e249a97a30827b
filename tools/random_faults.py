"""Random faults: small mistakes drawn from the sources by a seed, put in one at a time; some test should notice each.

`./dev faults --random [COUNT [SEED [FIRST]]] [--minutes M]` draws fault FIRST and those after it: an operator turned, a
condition that never holds, a constant one larger, a statement left out ... in src/, outside of comments, texts, asserts
and directives. One that does not compile, or that leaves the programs as they are (code for other processors, a constant
whose value does not matter), is drawn again. The tests of the folder of its name run first, then all
others, those of the command line last, until one fails. Golden hash, documents, windows, the client, examples, jobs of
several ranks and random checks are left aside: the first would notice any other number, the others show what is told and
tested elsewhere.

What a kernel includes takes minutes to compile: such a place is drawn a tenth as often as another.
"""

import argparse
import hashlib
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

LAYERS = ("base", "math", "model", "solve", "prepare", "flight", "study", "collide", "emit", "world", "scenario", "report")
LEFT_ASIDE = {"docs", "client", "window", "additions"}  # folders of tests
LAST = {"cli"}  # programs that run take longer than calls
TOO_LONG = "StudyRanks.*"  # kill and go on with studies of many shots; others run the same code
KERNEL_WEIGHT = 0.1
PATIENCE = 1200  # for all tests [s]; longer is a hang, which is noticed, too

TURNED = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " + ": " - ",
          " - ": " + ", " * ": " / ", " / ": " * ", " += ": " -= ", " -= ": " += ", " && ": " || ", " || ": " && ",
          "std::min(": "std::max(", "std::max(": "std::min("}
OPERATOR = re.compile("|".join(re.escape(word) for word in sorted(TURNED, key=len, reverse=True)))
NUMBER = re.compile(r"(?<![\w.'])\d+(\.\d+)?(?![\w.'])")
NEGATION = re.compile(r"(?<=[ (])!(?=[\w(])")
ASSIGNMENT = re.compile(r"^ +[\w.>\-\[\]()*]+ [-+*|&]?= [^;{}]*;$", re.M)
CONDITION = re.compile(r"\bif \(")
# What is no code to put a fault into, or only names things.
MASKED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*|'
                    r"\b(?:PHYSIM_ASSERT|static_assert)\(.*?\);|\btemplate <[^{;]*?>(?=\n|\s*(?:class|struct|auto|void))|"
                    r"operator[^\s\w(]+", re.M | re.S)


def masked(text):
    return MASKED.sub(lambda found: re.sub(r"[^\n]", "\a", found.group()), text)


def closing(text, opening):
    """The place of the bracket that closes the one at `opening`."""
    depth = 0
    for i in range(opening, len(text)):
        depth += (text[i] in "(") - (text[i] in ")")
        if depth == 0:
            return i
    return len(text)


def places(text):
    """(from, to, what stands there instead, what it is) for each fault that a file may get."""
    shown = masked(text)
    for found in OPERATOR.finditer(shown):
        yield found.start(), found.end(), TURNED[found.group()], "an operator turned"
    for found in NUMBER.finditer(shown):
        more = str(float(found.group()) + 1) if found.group(1) else str(int(found.group()) + 1)
        yield found.start(), found.end(), more, "a constant larger by one"
    for found in NEGATION.finditer(shown):
        yield found.start(), found.end(), "", "a negation dropped"
    for found in ASSIGNMENT.finditer(shown):
        yield found.end() - len(found.group().lstrip()), found.end(), ";", "a statement dropped"
    for found in CONDITION.finditer(shown):
        opening = found.end() - 1
        inside = shown[opening + 1:closing(shown, opening)]
        if ";" not in inside and " = " not in inside:
            yield opening + 1, opening + 1 + len(inside), f"false && ({text[opening + 1:opening + 1 + len(inside)]})", \
                "a condition that never holds"


def read_by_kernels(src):
    """What kernels include, and what that includes."""
    waiting, seen = list(src.rglob("*_kernel.cpp")), set()
    while waiting:
        path = waiting.pop()
        if path in seen or not path.is_file():
            continue
        seen.add(path)
        waiting += [src / name for name in re.findall(r'#include "([^"]+)"', path.read_text(encoding="utf-8"))]
    return seen


class Faults:
    """Everywhere a fault may be put, and how to draw one: of all kinds of faults equally often."""

    def __init__(self, src):
        slow = read_by_kernels(src)
        self.by_kind = {}
        for layer in LAYERS:
            for path in sorted((src / layer).rglob("*.?pp")):
                for begin, end, instead, what in places(path.read_text(encoding="utf-8")):
                    found, weights = self.by_kind.setdefault(what, ([], []))
                    found.append((path, begin, end, instead, what))
                    weights.append(KERNEL_WEIGHT if path in slow else 1)

    def draw(self, chance):
        found, weights = self.by_kind[chance.choice(sorted(self.by_kind))]
        return chance.choices(found, weights)[0]


class Tests:
    """The test program of a build, by folders of the tests."""

    def __init__(self, tree, build):
        self.program, self.suites = build / "bin" / "physim_tests", {}
        self.programs = (self.program, build / "bin" / "physim")
        for path in (tree / "tests").rglob("*_test.cpp"):
            folder = path.relative_to(tree / "tests").parts[0]
            found = re.findall(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),", path.read_text(encoding="utf-8"), re.M)
            self.suites.setdefault(folder, set()).update(found)

    def digest(self):
        """Of the machine code that is tested."""
        return [hashlib.sha256(program.read_bytes()).hexdigest() for program in self.programs]

    def named(self, folders):
        return ":".join(f"{name}.*:*/{name}.*:{name}/*" for folder in folders for name in sorted(self.suites.get(folder, ())))

    def first_failure(self, wanted):
        """The test that fails first; nothing where all pass."""
        shards = os.cpu_count() or 1
        running = []
        for i in range(shards):
            out = tempfile.TemporaryFile("w+")
            environment = dict(os.environ, GTEST_TOTAL_SHARDS=str(shards), GTEST_SHARD_INDEX=str(i))
            command = [str(self.program), f"--gtest_filter={wanted}-{TOO_LONG}", "--gtest_fail_fast"]
            running.append((out, subprocess.Popen(command, env=environment, stdout=out, stderr=subprocess.STDOUT)))
        failure, end = "", time.monotonic() + PATIENCE
        while running and not failure:
            time.sleep(0.2)
            for out, program in list(running):
                if program.poll() is None and time.monotonic() < end:
                    continue
                running.remove((out, program))
                is_hang = program.poll() is None
                program.kill()
                out.seek(0)
                failure = failure or ("a hang in " + last_begun(out.read()) if is_hang else
                                      what_failed(out.read()) if program.returncode != 0 else "")
        for _, program in running:
            program.kill()
            program.wait()
        return failure

    def noticed_by(self, path):
        concerned = path.parts[path.parts.index("src") + 1]
        if failure := self.first_failure(self.named([concerned])) if self.suites.get(concerned) else "":
            return failure
        for folders in (set(self.suites) - LAST, LAST & set(self.suites)):
            if failure := self.first_failure(self.named(sorted(folders - {concerned} - LEFT_ASIDE))):
                return failure
        return ""


def what_failed(out):
    found = re.search(r"^\[  FAILED  \] ([\w./]+)", out, re.M)
    bug = re.search(r"a bug in PhySim: .*", out)
    return found.group(1) if found else f"{last_begun(out)}: {bug.group() if bug else 'a crash'}"


def last_begun(out):
    begun = re.findall(r"^\[ RUN      \] (\S+)", out, re.M)
    return begun[-1] if begun else "the beginning"


def build(folder):
    return subprocess.run(["cmake", "--build", str(folder), "--target", "physim_tests", "physim_cli"], check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def try_one(number, seed, everywhere, tests, sound, tree, folder):
    """Whether fault `number` of a seed was noticed."""
    chance = random.Random(f"{seed}:{number}")
    while True:
        path, begin, end, instead, what = everywhere.draw(chance)
        whole = path.read_text(encoding="utf-8")
        started = time.monotonic()
        path.write_text(whole[:begin] + instead + whole[end:], encoding="utf-8")
        try:
            if build(folder).returncode != 0 or tests.digest() == sound:
                continue
            by = tests.noticed_by(path)
        finally:
            path.write_text(whole, encoding="utf-8")
        line = whole.count("\n", 0, begin)
        first, last = whole.rfind("\n", 0, begin) + 1, whole.find("\n", end)
        print(f"{number}: {path.relative_to(tree)}:{line + 1}: {what}: {by and 'noticed by ' + by or 'SURVIVED'}, "
              f"{time.monotonic() - started:.0f} s\n    - {whole[first:last].strip()}\n    + "
              f"{(whole[first:begin] + instead + whole[end:last]).strip()}", flush=True)
        return bool(by)


def main(copy, words):
    parser = argparse.ArgumentParser(prog="./dev faults --random")
    for name, default in (("count", 100), ("seed", 1), ("first", 0)):
        parser.add_argument(name, nargs="?", type=int, default=default)
    parser.add_argument("--minutes", type=float, default=float("inf"), help="begins no fault after so long")
    asked = parser.parse_args(words)
    tree, folder = copy / "tree", copy / "random"
    # What a header's fault made to be compiled anew is there again when it is taken out.
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    linker = ["-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld"] if shutil.which("ld.lld") else []  # in a tenth of the time
    os.environ["CCACHE_SLOPPINESS"] = "pch_defines,time_macros,include_file_mtime,include_file_ctime"
    subprocess.run(["cmake", "-S", str(tree), "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                    "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -fpch-preprocess", "-DPHYSIM_ISAS=base", "-DPHYSIM_SMALL_KERNELS=ON",
                    "-DPHYSIM_CLIENT=OFF", *launcher, *linker], check=True, stdout=subprocess.DEVNULL)
    if build(folder).returncode != 0:
        sys.exit("faults: the sources do not build")
    tests = Tests(tree, folder)
    if failure := tests.first_failure(tests.named(sorted(set(tests.suites) - LEFT_ASIDE))):
        sys.exit(f"faults: without any fault, {failure} fails")
    sound = tests.digest()
    everywhere, done, noticed, started = Faults(tree / "src"), 0, 0, time.monotonic()
    print(f"{sum(len(found) for found, _ in everywhere.by_kind.values())} places", flush=True)
    for number in range(asked.first, asked.first + asked.count):
        if time.monotonic() - started > 60 * asked.minutes:
            break
        noticed += try_one(number, asked.seed, everywhere, tests, sound, tree, folder)
        done += 1
    print(f"{noticed} of {done} random faults were noticed; to go on: ./dev faults --random {asked.count} {asked.seed} "
          f"{asked.first + done}")
    return 0
