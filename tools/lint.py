#!/usr/bin/env python3
"""The house rules that a machine can check: `./dev lint`. With --format it applies clang-format instead.

Every finding prints `file:line: what is wrong; what to do`, and the exit status is 1.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import additions
import faults

ROOT = Path(__file__).resolve().parent.parent
LAYERS = ["base", "math", "model", "settings", "solve", "prepare", "collide", "flight", "study", "emit", "world", "scenario", "report",
          "validation", "capi"]  # ground first
KNOW_FILES = {"scenario", "report", "validation", "capi"}
MAX_LINES, MAX_TEST_LINES, MAX_COLUMNS, MAX_BYTES = 820, 600, 120, 1_000_000
MAX_C_LINES = 1200  # the C interface is one header, the file that other languages read
MAX_FUNCTION_LINES = 60
MAX_CASTS, MAX_CAST_FILES = 10, 3  # reinterpret_cast in include, src and apps
MIN_ASSERTS = 12  # PHYSIM_ASSERT per 1000 lines of include and src; this only rises
CPP = (".hpp", ".cpp", ".h", ".c")

findings = []


def find(path, line, message):
    findings.append(f"{path}:{line}: {message}")


def repository_files():
    """Paths relative to the root: tracked, and new but not ignored."""
    try:
        out = subprocess.run(
            ["git", "-c", f"safe.directory={ROOT}", "ls-files", "-co", "--exclude-standard", "-z"],
            cwd=ROOT, check=True, capture_output=True, text=True).stdout
        names = out.split("\0")
    except (OSError, subprocess.CalledProcessError):  # a source archive
        names = [str(p.relative_to(ROOT)) for p in ROOT.rglob("*")]
        names = [n for n in names if not n.startswith(("build/", "out/", ".git/"))]
    return sorted(n for n in set(names) if n and (ROOT / n).is_file())


def read(name):
    return (ROOT / name).read_text(encoding="utf-8", errors="replace")


# ----------------------------------------------------------------------------------------------------------- includes
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')
INTRINSICS = {"immintrin.h", "emmintrin.h", "cpuid.h", "arm_neon.h", "wasm_simd128.h"}
C_HEADERS = {"stdint.h", "stddef.h", "stdbool.h"}
FILE_HEADERS = {"fstream", "iostream", "filesystem"}



# Rooms of layers, lower ones first: a file sees its own room and those before it. A .cpp file of any room may include what
# the functions of World share: they stand with what they call.
ROOMS = {"world": ["core", "step", "couple", "journal", "door"]}
SHARED_BY_CALLS = {"world/couple/world_impl.hpp"}


def check_rooms(name, lines):
    parts = name.split("/")
    if parts[0] != "src" or parts[1] not in ROOMS:
        return
    rooms = ROOMS[parts[1]]
    if len(parts) != 4 or parts[2] not in rooms:
        find(name, 1, f"src/{parts[1]} has the rooms {', '.join(rooms)}; put the file into one of them")
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        target = match.group(2).split("/") if match else []
        if len(target) != 3 or target[0] != parts[1] or target[1] not in rooms:
            continue
        shared = name.endswith(".cpp") and "/".join(target) in SHARED_BY_CALLS
        if rooms.index(target[1]) > rooms.index(parts[2]) and not shared:
            find(name, number, f'{parts[1]}/{parts[2]} may not include "{"/".join(target)}"; its room comes later')


def check_includes(name, lines):
    """A layer sees the public headers, itself, and the layers above it; the core has no dependency."""
    parts = name.split("/")
    public = name.startswith("include/physim/")
    if not public and not (parts[0] == "src" and len(parts) > 2):
        return
    layer = None if public else parts[1]
    if layer is not None and layer not in LAYERS:
        find(name, 1, f"src/{layer} is no known layer; add it to LAYERS in tools/lint.py, in its place")
        return
    allowed = [] if public else LAYERS[: LAYERS.index(layer) + 1]
    knows_files = layer in KNOW_FILES
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quote, target = match.groups()
        top = target.split("/")[0] if "/" in target else ""
        if top == "physim":
            continue
        if quote == '"':
            if public:
                find(name, number, f'public header includes "{target}"; only physim/ and the C++ library may be here')
            elif top in LAYERS and top not in allowed:
                find(name, number, f'src/{layer} may not include "{target}"; move the code up to where both can see it')
            elif top not in LAYERS:
                find(name, number, f'"{target}" is in no layer; name it from src/, as "math/pack.hpp"')
        elif not knows_files:
            if ("/" in target or target.endswith((".h", ".hpp"))) and target not in INTRINSICS | C_HEADERS:
                find(name, number, f"<{target}> is not in the C++ standard library; the core has no dependency")
            elif target in FILE_HEADERS:
                find(name, number, f"<{target}>: only src/scenario and the apps know files; move it there")


# -------------------------------------------------------------------------------------------------------------- units
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z_])\'(?:\\.|[^\'\\\n])+\'', re.S)
UNIT = re.compile(r"\[[^\[\]\n]+\]")
NOT_A_FIELD = re.compile(
    r"^(using|typedef|static|friend|template|enum|struct|class|union|constexpr|inline|static_assert|extern|explicit|"
    r"virtual|operator)\b")


def blank(match):
    """Comments and strings become spaces, so that only code is parsed; line breaks stay."""
    return re.sub(r"[^\n]", " ", match.group())


def public_fields(code):
    """(first line, last line, name) of each data member that users of a struct or class see."""
    stack, start, access_of = [], 0, []  # stack: kind of each open brace; start: of the current statement
    depth = 0  # of ( and [
    line_of = lambda at: code.count("\n", 0, at) + 1
    at = 0
    while at < len(code):
        c = code[at]
        if c in "([":
            depth += 1
        elif c in ")]":
            depth -= 1
        elif c == "{" and depth == 0:
            head = code[start:at].strip()
            in_type = bool(stack) and stack[-1] in ("struct", "class")
            if re.search(r"\b(namespace|extern)\b[^;=()]*$", head):
                kind = "namespace"
            elif re.search(r"\benum\b", head):
                kind = "enum"
            elif re.search(r"\b(struct|union|class)\b[^;=()]*$", head):
                kind = "class" if re.search(r"\bclass\s+\w+[^<>]*$", head) and "struct" not in head else "struct"
            elif in_type and "(" not in re.sub(r"alignas\s*\([^)]*\)", "", head) or re.search(r"=\s*$", head):
                kind = "initializer"
            else:
                kind = "body"
            stack.append(kind)
            access_of.append("private" if kind == "class" else "public")
            if kind != "initializer":
                start = at + 1
        elif c == "}" and depth == 0 and stack:
            kind = stack.pop()
            access_of.pop()
            if kind in ("namespace", "body"):
                start = at + 1
            elif kind in ("struct", "class", "enum"):
                start = at + 1  # `} name;` leaves `name`, which is no field with a type
        elif c == ":" and depth == 0 and stack and stack[-1] in ("struct", "class"):
            word = code[start:at].strip()
            if word in ("public", "private", "protected"):
                access_of[-1] = word
                start = at + 1
        elif c == ";" and depth == 0:
            text = code[start:at]
            statement = re.sub(r"\[\[[^\]]*\]\]|alignas\s*\([^)]*\)", " ", text).strip()
            member = bool(stack) and stack[-1] in ("struct", "class") and "body" not in stack
            visible = all(a == "public" for a in access_of)
            if member and visible and statement and not NOT_A_FIELD.match(statement):
                declarator = re.split(r"[={]", statement)[0]
                words = re.sub(r"<[^;]*>", " ", declarator)
                if "(" not in words and "operator" not in words and len(re.findall(r"\w+", declarator)) > 1:
                    first = start + len(text) - len(text.lstrip())
                    yield line_of(first), line_of(at), re.findall(r"\w+", re.sub(r"\[.*", "", declarator))[-1]
            start = at + 1
        elif c == "#" and code[:at].rpartition("\n")[2].strip() == "":  # a preprocessor line, with its continuations
            end = at
            while (end := code.find("\n", end)) != -1 and code[end - 1] == "\\":
                end += 1
            at = len(code) if end == -1 else end
            if code[start:at].strip().startswith("#"):
                start = at
            continue
        at += 1


def check_units(name, text, lines):
    if not re.fullmatch(r"include/physim/[^/]*\.(hpp|h)", name):
        return
    code = COMMENT_OR_STRING.sub(blank, text)
    code_lines = code.split("\n")
    for first, last, field in public_fields(code):
        # The comment: behind the declaration, or in the lines of comment right above it.
        candidates = [lines[n][len(code_lines[n].rstrip()):] for n in range(first - 1, last)]
        above = first - 2
        while above >= 0 and lines[above].strip() and not code_lines[above].strip():
            candidates.append(lines[above])
            above -= 1
        below = last  # a trailing comment may go on, under itself
        while below < len(lines) and re.match(r"\s*///<", lines[below]):
            candidates.append(lines[below])
            below += 1
        if not any(UNIT.search(c) for c in candidates):
            find(name, first, f"public field `{field}` has no unit; end its comment with one, [m/s], or [-] for none")


NO_DEFAULT = {"Flight"}  # types of which there is none before it is made


def check_initialised(name, text):
    """A designated initialiser that leaves out a field without a value of its own is warned of: -Wextra at the user's."""
    if not re.fullmatch(r"include/physim/[^/]*\.hpp", name):  # structs of C have none
        return
    code = COMMENT_OR_STRING.sub(blank, text)
    for first, last, field in public_fields(code):
        declaration = " ".join(code.split("\n")[first - 1:last]).strip()
        if not re.search(r"[={]", declaration) and declaration.split()[0] not in NO_DEFAULT:
            find(name, first, f"public field `{field}` has no value of its own; give it one, or {{}}")


APART = re.compile(r"\b(isatty|ttyname|stdout|std::cout|std::cin|std::cerr|argc|argv|getopt|termios)\b"
                   r"|#\s*include\s*<(CLI/|GLFW/|imgui|epoxy/|termios)")


def check_apart(name, text):
    """Nothing below apps/ knows windows, terminals or command lines."""
    if not name.startswith(("src/", "include/")):
        return
    for number, line in enumerate(COMMENT_OR_STRING.sub(blank, text).split("\n"), 1):
        if match := APART.search(line):
            find(name, number, f"`{match.group().strip()}`: only the programs in apps/ know windows, terminals and "
                               "command lines; hand in what is needed")


def check_client_core(name, lines):
    """The client without a window knows neither OpenGL nor Dear ImGui: it is tested without them."""
    if not name.startswith("apps/simclient/core/"):
        return
    for number, line in enumerate(lines, 1):
        if re.search(r"#\s*include.*(imgui|GLFW|epoxy|simclient/(gl|ui)/)", line):
            find(name, number, "apps/simclient/core does without windows; move it to gl/ or ui/")


# ------------------------------------------------------------------------------------------------------ simpler rules
def check_source_named(name, lines):
    if re.match(r"src/model/.*\.(hpp|cpp)$", name):
        if not any(re.match(r"\s*(//|/?\*).*\bSources?:", line) for line in lines[:60]):
            find(name, 1, "a model names its source; add `// Source: author, title, equation` to the head comment")


OPENS = re.compile(r"\b(i|o)?fstream\b\s+\w|\b(i|o)fstream\b\s*[({]|\bfopen\s*\(|\bstbi_write_\w+\s*\((?!append)")
GUARDED = re.compile(r"\bbegin_(reading|writing)\s*\(")
NOT_GUARDED = {"apps/simclient/app.hpp",  # opened in app.cpp, announced in main.cpp
               "apps/simclient/core/recent_files.cpp"}  # a list of its own


def check_guarded(name, lines):
    """What opens a file asks whether it is an output of the work that reads it, or the other way round."""
    if not name.startswith(("include/", "src/", "apps/")) or name in NOT_GUARDED:
        return
    if any(GUARDED.search(line) for line in lines):
        return
    for number, line in enumerate(lines, 1):
        if OPENS.search(line.split("//")[0]):
            find(name, number, "opens a file; call begin_reading() or begin_writing() of scenario/files_in_use.hpp first")


def check_size(name, lines):
    if name.startswith(("src/", "include/", "apps/", "tests/")):
        most = MAX_TEST_LINES if name.startswith("tests/") else MAX_C_LINES if name.endswith(".h") else MAX_LINES
        if len(lines) > most:
            find(name, most + 1, f"{len(lines)} lines, the house has {most}; split the file by purpose")
        for number, line in enumerate(lines, 1):
            if len(line) > MAX_COLUMNS:
                find(name, number, f"{len(line)} columns, the house has {MAX_COLUMNS}; break the line")


def enumerations(files):
    """The names of all enum classes of the library."""
    names = set()
    for name in files:
        if name.startswith(("include/", "src/")):
            names.update(re.findall(r"\benum class (\w+)", read(name)))
    return names


def check_enumerators(name, text, enums):
    """Enumerators are names: their values mean nothing, and switches over them name each."""
    if not name.startswith(("src/", "include/", "apps/")):
        return
    code = COMMENT_OR_STRING.sub(blank, text)
    enum = r"(?:\w+::)*(?:%s)::\w+" % "|".join(sorted(enums))
    compared = rf"\s[<>]=?\s+{enum}\b|\b{enum}\s+[<>]=?\s|std::(?:min|max)\((?:[^;()]|\([^()]*\))*\b{enum}\b"
    for number, line in enumerate(code.split("\n"), 1):
        if re.search(compared, line) and not re.match(r"\s*(template|using)\b", line):
            find(name, number, "compares an enumerator by its value; ask for what it is, or for the level of a rung")
    for match in re.finditer(r"\bdefault:", code):
        opening = code.rfind("switch (", 0, match.start())
        if re.search(r"\bcase \w+(::\w+)+:", code[opening:match.start()]):
            find(name, code.count("\n", 0, match.start()) + 1,
                 "a default in a switch over an enumeration; name the rest, so that a new one does not compile")


def function_bodies(code):
    """(first line, lines, head) of each function's body in code without comments, strings and preprocessor lines."""
    stack, start, depth = [], 0, 0
    for at, c in enumerate(code):
        if c in "([":
            depth += 1
        elif c in ")]":
            depth -= 1
        elif depth == 0 and c == "{":
            head = code[start:at].strip()
            if re.search(r"\b(namespace|extern|class|struct|union|enum)\b[^;=()]*$", head):
                kind = "scope"
            else:
                kind = "function" if re.search(r"\)[^;=]*$", head) and "function" not in stack_kinds(stack) else "other"
            stack.append((kind, at, head))
            start = at + 1
        elif depth == 0 and c == "}" and stack:
            kind, begin, head = stack.pop()
            start = at + 1
            if kind == "function":
                yield code.count("\n", 0, begin) + 1, code.count("\n", begin, at) + 1, head.split("\n")[-1].strip()
        elif depth == 0 and c == ";":
            start = at + 1


def stack_kinds(stack):
    return [kind for kind, _, _ in stack]


def check_functions(name, text):
    if not name.startswith(("src/", "include/", "apps/")):
        return
    code = COMMENT_OR_STRING.sub(blank, text)
    code = re.sub(r"^[ \t]*#(?:.*\\\n)*.*", blank, code, flags=re.M)
    for line, length, head in function_bodies(code):
        if length > MAX_FUNCTION_LINES:
            find(name, line, f"`{head[:60]}` has {length} lines, the house has {MAX_FUNCTION_LINES}; split it by purpose")


# Their results are std::ranges::subrange, which clang 14 cannot instantiate with the library of g++ 12.
SUBRANGE = re.compile(r"\branges::(unique|remove|remove_if|partition|stable_partition|rotate|search|equal_range|find_end"
                      r"|subrange)\b|\bviews::")


def check_old_clang(name, lines):
    for number, line in enumerate(lines, 1):
        if match := SUBRANGE.search(line):
            find(name, number, f"`{match.group()}`: clang 14 cannot compile it; take the algorithm on iterators")


LEANING = re.compile(r"\s*//+\s+(The same|Both|Of)\b")


def check_comments(name, lines):
    """A comment must survive being moved: it says what it speaks of, and does not lean on the line before it."""
    if not name.startswith(("src/", "include/", "apps/")):
        return
    for number, line in enumerate(lines, 1):
        before = lines[number - 2] if number > 1 else ""
        if LEANING.match(line) and not before.lstrip().startswith("//"):
            find(name, number, "this comment leans on what stands before it; name what it speaks of")


APART = re.compile(r"tests/(?!additions|client|fast_math|fuzz|golden|hits|install|no_memory|soak|window)(\w+)/(\w+)\.cpp")


def check_test_namespace(name, lines):
    """Tests are compiled together: names of two files must not meet."""
    match = APART.fullmatch(name)
    for number, line in enumerate(lines, 1):
        if match and line == "namespace {":
            find(name, number, f"tests are compiled together; name it: namespace {match[1]}_{match[2]} {{")


UNNAMED = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.S | re.M)
OWN_NAME = re.compile(r"^(?:struct|class|enum class) (\w+)|^(?:constexpr|const) [\w:<>, ]+ (k\w+)\b", re.M)


def check_own_names(texts):
    """Files of a folder are compiled together, in groups that a new file shifts: their own names must not meet."""
    first = {}
    for name, text in texts.items():
        if not name.startswith(("src/", "apps/")) or name.endswith("_kernel.cpp"):
            continue
        for body in UNNAMED.finditer(text):
            for own in OWN_NAME.finditer(body[1]):
                word = own[1] or own[2]
                other = first.setdefault((os.path.dirname(name), word), name)
                if other != name:
                    find(name, text.count("\n", 0, body.start(1) + own.start()) + 1,
                         f"{other} has a `{word}` of its own, too, and both may be compiled as one; rename one of them")


def check_counts(texts):
    """Counts over the whole house; texts: name -> text of each C++ file."""
    casts = {n: t.count("reinterpret_cast<") for n, t in texts.items() if n.startswith(("include/", "src/", "apps/"))}
    casts = {n: count for n, count in casts.items() if count}
    if sum(casts.values()) > MAX_CASTS or len(casts) > MAX_CAST_FILES:
        find(max(casts, key=casts.get), 1, f"{sum(casts.values())} reinterpret_cast in {len(casts)} files, the house has "
             f"{MAX_CASTS} in {MAX_CAST_FILES}; structs list their members in src/base/members.hpp")
    core = {n: t for n, t in texts.items() if n.startswith(("include/", "src/"))}
    lines = sum(t.count("\n") for t in core.values())
    asserts = sum(len(re.findall(r"\bPHYSIM_ASSERT\(", COMMENT_OR_STRING.sub(blank, t))) for t in core.values())
    if asserts * 1000 < MIN_ASSERTS * lines:
        find("src", 1, f"{asserts} asserts in {lines} lines, the house has {MIN_ASSERTS} per 1000; state what could be false")
    return f"{lines} lines of core, {asserts} asserts, {sum(casts.values())} reinterpret_cast"


def check_kernel_symbols():
    """A weak symbol outside its own namespace may be shared by the linker with code for older processors."""
    nm = shutil.which("nm")
    pattern = "CMakeFiles/physim_kernels_*.dir/src/**/*_kernel.cpp.o"
    objects = [o for preset in ("release", "clang") for o in sorted((ROOT / "build" / preset).glob(pattern))]
    checked = 0
    for path in objects:
        isa = re.search(r"physim_kernels_(\w+)\.dir", str(path)).group(1)
        source = re.search(r"\.dir/(src/.*\.cpp)\.o$", str(path)).group(1)
        if isa == "base" or not nm or not (ROOT / source).exists():
            continue
        checked += 1
        out = subprocess.run([nm, "-C", "--defined-only", str(path)], capture_output=True, text=True, check=True).stdout
        for line in out.splitlines():
            match = re.match(r"[0-9a-fA-F]*\s+([WVu])\s+(.*)", line)
            if match and f"::{isa}::" not in match.group(2) and not match.group(2).startswith("DW.ref."):
                find(source, 1, f"the {isa} object defines `{match.group(2)}`, shared with other code; "
                                "force it inline (PHYSIM_INLINE) or put it between PHYSIM_ISA_BEGIN and PHYSIM_ISA_END")
    return f"{checked} kernel objects" if checked else "no kernel objects (build first to check them)"


def clang_format(sources, apply):
    program = shutil.which("clang-format-14") or shutil.which("clang-format")
    if not program:
        sys.exit("lint: clang-format is missing")
    if not sources:
        return
    if apply:
        subprocess.run([program, "-i", *sources], cwd=ROOT, check=True)
        return
    result = subprocess.run([program, "--dry-run", "-Werror", *sources], cwd=ROOT, capture_output=True, text=True)
    places = re.findall(r"^(\S+?):(\d+):\d+: (?:error|warning): code should be clang-formatted", result.stderr, re.M)
    for name in dict.fromkeys(name for name, _ in places):
        find(name, next(n for p, n in places if p == name), "not in the house format; run ./dev format")
    if result.returncode != 0 and not places:
        find("clang-format", 1, result.stderr.strip() or "failed")


def main():
    files = repository_files()
    cpp = [n for n in files if n.endswith(CPP)]
    if "--format" in sys.argv[1:]:
        clang_format(cpp, apply=True)
        print(f"format: {len(cpp)} files")
        return 0
    clang_format(cpp, apply=False)
    for name in files:
        size = os.path.getsize(ROOT / name)
        if size > MAX_BYTES:
            find(name, 1, f"{size / 1e6:.1f} MB; a file here has at most 1 MB: make it smaller or generate it")
    enums = enumerations(cpp)
    texts = {}
    for name in cpp:
        text = read(name)
        lines = text.splitlines()
        check_includes(name, lines)
        check_rooms(name, lines)
        check_units(name, text, lines)
        check_initialised(name, text)
        check_apart(name, text)
        check_client_core(name, lines)
        check_source_named(name, lines)
        check_guarded(name, lines)
        check_size(name, lines)
        check_test_namespace(name, lines)
        check_enumerators(name, text, enums)
        check_functions(name, text)
        check_comments(name, lines)
        check_old_clang(name, lines)
        texts[name] = text
    additions.check(find)
    faults.check(find)
    check_own_names(texts)
    counts = check_counts(texts)
    kernels = check_kernel_symbols()
    for finding in findings:
        print(finding)
    print(f"lint: {len(cpp)} source files, {kernels}, {counts}: {len(findings)} findings" if findings else
          f"lint: {len(cpp)} source files, {kernels}, {counts}: clean")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
