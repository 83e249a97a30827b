#!/usr/bin/env python3
"""Additions: what a new rung, law ... costs, held by patches that add one for the tests alone.

tests/additions/NAME.patch adds one to the sources, with its test; its first lines say what it is and how many files it
may touch beside tests and docs (`Files: 4`). A patch is the honest measure: a rung that is compiled in for tests would
be a rung of the library, and one that is made of test hooks would not pass through the places that real ones touch.

`./dev lint` checks that every patch still applies and touches no more files than it may: cheap, at every change.
`./dev additions` applies all of them to a copy of the sources, builds the library, the command line and their tests,
without any optional library, and runs them.
`./dev additions --python` builds the Python package over that library, too, in the environment of `./dev python`: each
setting that a patch adds as a row must be a keyword with its text and in the list of settings, by that row alone. The list
of docs/settings.md and the C interface are looked at by every run.
`./dev additions --write NAME` writes a patch anew from the files changed in the working tree.
`./dev additions --taken-out [NAME ...]` takes out what the patches add to the sources, one run of lines at a time, and
says what notices it: a build that fails, or tests. Fails where nothing does.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PATCHES = ROOT / "tests" / "additions"
COPY = ROOT / "build" / "additions"
FREE = ("tests/", "docs/", "CHANGELOG.md", "scenarios/")  # not counted


def patches():
    return sorted(PATCHES.glob("*.patch"))


def touched(patch):
    """The files of the library and the apps that a patch changes or adds."""
    files = re.findall(r"^diff --git a/\S+ b/(\S+)$", patch.read_text(encoding="utf-8"), re.M)
    return [name for name in files if not name.startswith(FREE)]


def limit(patch):
    match = re.search(r"^Files: (\d+)$", patch.read_text(encoding="utf-8"), re.M)
    return int(match.group(1)) if match else 0


def apply(patch, folder, *options):
    # One line of context must agree: neighbours may change without a patch being written anew.
    return subprocess.run(["git", "apply", "-C1", "--recount", *options, str(patch)], cwd=folder, capture_output=True,
                          text=True)


def check(find):
    """For tools/lint.py: find(path, line, message)."""
    for patch in patches():
        name = str(patch.relative_to(ROOT))
        files = touched(patch)
        if len(files) > limit(patch):
            find(name, 1, f"the addition touches {len(files)} files, it may {limit(patch)}: {', '.join(files)}")
        result = apply(patch, ROOT, "--check")
        if result.returncode != 0:
            find(name, 1, "does not apply any more; make the addition again and ./dev additions --write "
                          f"{patch.stem}: {result.stderr.strip().splitlines()[0]}")


def write(name):
    """The working tree's changes, with the head of the old patch."""
    path = PATCHES / f"{name}.patch"
    head = path.read_text(encoding="utf-8").split("diff --git")[0] if path.exists() else f"{name}\n\nFiles: 4\n\n"
    subprocess.run(["git", "add", "--intent-to-add", "."], cwd=ROOT, check=True)
    diff = subprocess.run(["git", "diff", "--", ".", f":!tests/additions/{name}.patch"], cwd=ROOT, check=True,
                          capture_output=True, text=True).stdout
    path.write_text(head + diff, encoding="utf-8")
    print(f"{path.relative_to(ROOT)}: {', '.join(touched(path))}")


def copy_sources():
    tree = COPY / "tree"
    names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.split("\0")
    wanted = {n for n in names if n and (ROOT / n).is_file()}
    for old in [p for p in tree.rglob("*") if p.is_file() and str(p.relative_to(tree)) not in wanted]:
        old.unlink()
    return tree, wanted


def fill(tree, wanted):
    """Patched sources into the copy; files that are as they were keep their times, so that little is built again."""
    fresh = COPY / "fresh"
    shutil.rmtree(fresh, ignore_errors=True)
    for name in wanted:
        target = fresh / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, target)
    subprocess.run(["git", "init", "-q", "."], cwd=fresh, check=True)  # or git apply would look at the tree around it
    for patch in patches():
        result = apply(patch, fresh)
        if result.returncode != 0:
            sys.exit(f"additions: {patch.name} does not apply: {result.stderr}")
    for source in (p for p in fresh.rglob("*") if p.is_file() and ".git" not in p.relative_to(fresh).parts):
        target = tree / source.relative_to(fresh)
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_bytes() != source.read_bytes():
            shutil.copyfile(source, target)
    shutil.rmtree(fresh)


def build(*more):
    """What the compiler says where the patched copy does not build; nothing where it does."""
    done = subprocess.run(["cmake", "--build", str(COPY / "build"), "-j", str(os.cpu_count() or 2), "--target",
                           "physim_additions", "physim_cli", *more], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)
    return "" if done.returncode == 0 else done.stdout or "no output"


def failing_tests():
    done = subprocess.run([str(COPY / "build" / "bin" / "physim_additions"), "--gtest_brief=1"], check=False,
                          capture_output=True, text=True)
    return done.returncode, re.findall(r"^\[  FAILED  \] (\S+) \(", done.stdout, re.M)


def settings_added():
    """Names of settings that patches add as rows."""
    return [name for patch in patches() for name in
            re.findall(r"^\+\s*PHYSIM_SETTING\((\w+)", patch.read_text(encoding="utf-8"), re.M)]


def are_documented(names):
    """Whether the page of settings, as the patched program writes it, has them."""
    page = subprocess.run([str(COPY / "build" / "bin" / "physim"), "list", "settings", "--markdown"], check=True,
                          capture_output=True, text=True).stdout
    missing = [name for name in names if not re.search(rf"\b{name}\b", page)]
    for name in missing:
        print(f"additions: docs/settings.md would not have {name}", file=sys.stderr)
    return bool(names) and not missing


IN_PYTHON = """
import sys, physim
for name in sys.argv[1:]:
    (row,) = (row for row in physim.settings().values() if row.path.endswith("." + name))
    assert f"    {row.keyword}: {row.doc}" in physim.Shot.__doc__, f"{row.keyword} is not in the text of Shot"
    assert (row.path, row.default) in physim.Shot(**{row.keyword: row.default})._given(), row.keyword
    print("Python has", row.keyword)
"""


def test_python(names):
    """The package over the patched library: the keywords are there, and the tests of settings pass."""
    python, package, into = ROOT / "build" / "python" / "bin" / "python", COPY / "tree" / "bindings" / "python", COPY / "python"
    if not python.exists():
        sys.exit("additions: there is no environment for Python; ./dev python makes it")
    if failure := build("physim_report"):
        sys.exit(failure)
    shutil.copytree(package / "physim", into / "physim", dirs_exist_ok=True)
    subprocess.run(["cmake", "-G", "Ninja", "-S", str(package), "-B", str(into / "cmake"), f"-DPHYSIM_BUILT={COPY / 'build'}",
                    f"-DPHYSIM_INTO={into / 'physim'}", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O0",
                    f"-DPython_EXECUTABLE={python}"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(into / "cmake"), "-j", str(os.cpu_count() or 2)], check=True)
    environment = {**os.environ, "PYTHONPATH": str(into)}
    subprocess.run([str(python), "-c", IN_PYTHON, *names], check=True, env=environment)
    return subprocess.run([str(python), "-m", "pytest", "bindings/python/tests/test_settings.py"], check=False,
                          cwd=COPY / "tree", env=environment).returncode


def build_and_test(with_python=False):
    tree, wanted = copy_sources()
    fill(tree, wanted)
    subprocess.run(["cmake", "-S", str(tree), "-B", str(COPY / "build"), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                    "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DPHYSIM_ISAS=base", "-DPHYSIM_SMALL_KERNELS=ON", "-DPHYSIM_WERROR=ON",
                    "-DPHYSIM_OPTIONAL=OFF"],
                   check=True, stdout=subprocess.DEVNULL)
    if failure := build():
        print(failure, file=sys.stderr)
        sys.exit("additions: the patched sources do not build")
    for patch in patches():
        print(f"{patch.stem}: {len(touched(patch))} files of at most {limit(patch)}: {', '.join(touched(patch))}")
    code = subprocess.run([str(COPY / "build" / "bin" / "physim_additions")], check=False).returncode
    code = code or (0 if are_documented(settings_added()) else 1)
    return code or (test_python(settings_added()) if with_python else 0)


def blocks(patch):
    """Runs of lines that a patch adds to the sources: file, the line before, the run, the lines that it replaces."""
    file, before, added, removed = "", "", "", ""
    for line in [*patch.read_text(encoding="utf-8").splitlines(keepends=True), "@@"]:
        if line.startswith("+") and not line.startswith("+++"):
            added += line[1:]
        elif line.startswith("-") and not line.startswith("---"):
            removed += line[1:]
        else:
            if added and not file.startswith(FREE):
                yield file, before, added, removed
            added = removed = ""
            before = line[1:] if line.startswith(" ") else ""
            if line.startswith("+++ b/"):
                file = line[6:].strip()


def taken_out(names):
    if build_and_test() != 0:
        return 1
    silent = 0
    for patch in [p for p in patches() if not names or p.stem in names]:
        for file, before, added, removed in blocks(patch):
            source = COPY / "tree" / file
            whole = source.read_text(encoding="utf-8")
            assert whole.count(before + added) == 1, (file, added)
            source.write_text(whole.replace(before + added, before + removed), encoding="utf-8")
            noticed = ""
            if build():
                noticed = "does not build"
            else:
                code, failed = failing_tests()
                noticed = (", ".join(failed) or "the tests break off") if code != 0 else ""
            source.write_text(whole, encoding="utf-8")
            silent += not noticed
            print(f"{patch.stem}: {file}: {added.strip().splitlines()[0]}: {noticed or 'NOTHING NOTICES'}", flush=True)
    return 1 if silent else 0


if __name__ == "__main__":
    if sys.argv[1:2] == ["--write"]:
        write(sys.argv[2])
    elif sys.argv[1:2] == ["--taken-out"]:
        sys.exit(taken_out(sys.argv[2:]))
    else:
        sys.exit(build_and_test("--python" in sys.argv[1:]))
