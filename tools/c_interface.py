#!/usr/bin/env python3
"""The C interface out of its header: the bindings of C#, and the record of its ABI.

  c_interface.py csharp [--check]           writes bindings/csharp/PhySim.cs, or says whether it is up to date
  c_interface.py layouts                    writes a C program that prints where members of structs lie
  c_interface.py abi [--record] LIBRARY     compares the ABI with tests/capi/abi.xml, or records it

The ABI is that of a library of empty functions that a C compiler makes of the header: types and signatures are its own,
and LIBRARY must show the same functions. A difference is a warning until version 1.0; from then on it is an error, unless
docs/api_changes.md names what changed.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADER = ROOT / "include/physim/physim.h"
CSHARP = ROOT / "bindings/csharp/PhySim.cs"
RECORD = ROOT / "tests/capi/abi.xml"
CHANGES = ROOT / "docs/api_changes.md"

PLAIN = {"uint32_t": "uint", "int32_t": "int", "uint64_t": "ulong", "int64_t": "long", "double": "double", "float": "float",
         "size_t": "UIntPtr", "char": "byte", "void": "void"}  # fmt: skip
KEYWORDS = {"in", "out", "ref", "params", "object", "event", "fixed", "base", "checked", "lock", "string", "is", "as"}


class Interface:
    """Declarations in their order, each with the comment before it."""

    def __init__(self):
        self.enums, self.structs, self.opaque, self.callbacks, self.functions = [], [], [], [], []
        self.read(HEADER.read_text(encoding="utf-8"))

    def read(self, text):
        text = re.sub(r"^\s*#.*(?:\\\n.*)*$", "", text, flags=re.M)
        text = text.replace('extern "C" {', "")
        doc = r"(?P<doc>(?:[ \t]*///(?!<)[^\n]*\n)*)\s*"
        body = r"\{(?P<body>[^}]*)\}"
        patterns = {
            "enum": re.compile(doc + r"typedef enum (?P<name>\w+) " + body + r" \w+;"),
            "constants": re.compile(doc + r"enum " + body + ";"),
            "struct": re.compile(doc + r"typedef struct (?P<name>\w+) " + body + r" \w+;"),
            "opaque": re.compile(doc + r"typedef struct (?P<name>\w+) (?P=name);"),
            "callback": re.compile(doc + r"typedef (?P<type>\w+) \(\*(?P<name>\w+)\)\((?P<args>[^)]*)\);"),
            "function": re.compile(doc + r"PHYSIM_API (?P<type>[\w \*]+?)(?P<name>\w+)\((?P<args>[^)]*)\);"),
        }
        found = [(m.start(), kind, m) for kind, pattern in patterns.items() for m in pattern.finditer(text)]
        for _, kind, m in sorted(found, key=lambda each: each[0]):
            words = " ".join(line.strip().removeprefix("///").strip() for line in m["doc"].splitlines())
            if kind in ("enum", "constants"):
                self.enums.append((m.groupdict().get("name") or "", words, values_of(m["body"])))
            elif kind == "struct":
                self.structs.append((m["name"], words, members_of(m["body"])))
            elif kind == "opaque":
                self.opaque.append(m["name"])
            else:
                into = self.callbacks if kind == "callback" else self.functions
                into.append((m["name"], words, m["type"].strip(), args_of(m["args"])))


def values_of(body):
    """Names, numbers and comments of enumerators; one without a number has that of the one before it and 1."""
    rows = []
    for name, number, words in re.findall(r"(PHYSIM_\w+)(?: = (\d+))?,?[ \t]*(?://(?:/<)?[ \t]*([^\n]*))?", body):
        rows.append((name, int(number) if number else int(rows[-1][1]) + 1 if rows else 0, words))
    return rows


def members_of(body):
    """Type, name, length (0: no array) and comment of members. The type of a function is what it returns and takes."""
    rows = []
    plain = r"(?P<type>[\w \*]+?)(?P<name>\w+)(?:\[(?P<length>\d+)\])?"
    function = r"(?P<result>\w+) \(\*(?P<function>\w+)\)\((?P<args>[^)]*)\)"
    row = re.compile(rf"\s*(?P<doc>(?:///(?!<)[^\n]*\n\s*)*)(?:{function}|{plain});(?:[ \t]*///<[ \t]*(?P<words>[^\n]*))?")
    at = 0
    while body[at:].strip():
        m = row.match(body, at)
        if not m:
            raise SystemExit(f"a member that is not understood: {body[at:].strip().splitlines()[0]}")
        words = m["words"] or " ".join(line.strip().removeprefix("///").strip() for line in m["doc"].splitlines())
        type_ = (m["result"], args_of(m["args"])) if m["function"] else m["type"].strip()
        rows.append((type_, m["function"] or m["name"], int(m["length"] or 0), words))
        at = m.end()
    return rows


def args_of(text):
    args = []
    for arg in text.split(","):
        m = re.fullmatch(r"([\w \*]+?)(\w+)(\[\d+\])?", " ".join(arg.split()))
        if m and m[0] != "void":
            args.append((m[1].strip() + ("*" if m[3] else ""), m[2]))
    return args


# ------------------------------------------------------------------------------------------------------------------ C#
class CSharp:
    def __init__(self, interface):
        self.c = interface
        self.named = {name for name, *_ in interface.structs + interface.callbacks} | {name for name, *_ in interface.enums}

    def type_of(self, c_type):
        """Of members and parameters: pointers stay pointers, but for those to opaque structs and to nothing."""
        stars = c_type.count("*")
        core = c_type.replace("const", "").replace("struct", "").replace("*", "").strip()
        if core == "void" and stars or core in self.c.opaque:
            core, stars = "IntPtr", stars - 1
        if core == "char" and stars == 2:
            core, stars = "IntPtr", 1
        return PLAIN.get(core, core) + "*" * stars

    def parameter(self, c_type, name):
        name = "@" + name if name in KEYWORDS else name
        core = c_type.replace("const", "").replace("*", "").strip()
        if c_type.replace(" ", "") == "constchar*":
            return f"string {name}"
        if core in self.c.opaque and c_type.count("*") == 2:
            return f"out IntPtr {name}"
        return f"{self.type_of(c_type)} {name}"

    def summary(self, words, indent):
        words = words.strip().removesuffix("[-]").strip()
        words = words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        return [f"{indent}/// <summary>{words}</summary>"] if words else []

    def delegate(self, name, words, result, args):
        yield from self.summary(words, "")
        yield "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]"
        yield f"public unsafe delegate {result} {name}({', '.join(self.parameter(*arg) for arg in args)});"

    def struct(self, name, words, members):
        callbacks = {name for name, *_ in self.c.callbacks}
        yield from self.summary(words, "")
        yield "[StructLayout(LayoutKind.Sequential)]"
        yield f"public unsafe struct {name} {{"
        for c_type, member, length, about in members:
            is_function = isinstance(c_type, tuple)
            core = "" if is_function else c_type.replace("const", "").replace("*", "").strip()
            yield from self.summary(f"a {name}_{member}" if is_function else about, "  ")
            member = "@" + member if member in KEYWORDS else member
            if length:
                yield f"  public fixed {PLAIN[core]} {member}[{length}];"
            elif is_function or core in callbacks:
                yield f"  public IntPtr{'' if is_function else '*' * c_type.count('*')} {member};"
            else:
                yield f"  public {self.type_of(c_type)} {member};"
        yield "}"

    def lines(self):
        yield "// The C interface of PhySim for C#, made of its header by tools/c_interface.py: change those. docs/c.md is its guide."
        yield "// Pointers are pointers: structs of one's own are read and written in place. Delegates that a call keeps must stay."
        yield "using System;"
        yield "using System.Runtime.InteropServices;"
        yield ""
        yield "namespace PhySim {"
        for name, words, values in self.c.enums:
            yield from self.summary(words, "")
            yield f"public enum {name or 'physim_' + values[0][0].removeprefix('PHYSIM_').lower()} {{"
            for value, number, about in values:
                yield from self.summary(about, "  ")
                yield f"  {value} = {number},"
            yield "}"
        for name, words, result, args in self.c.callbacks:
            yield from self.delegate(name, words, result, args)
        for name, words, members in self.c.structs:
            for c_type, member, _, about in members:
                if isinstance(c_type, tuple):
                    yield from self.delegate(f"{name}_{member}", about, *c_type)
            yield from self.struct(name, words, members)
        yield "public static unsafe class C {"
        yield '  const string Library = "physim_c";'
        for name, words, result, args in self.c.functions:
            yield from self.summary(words, "  ")
            yield "  [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]"
            returned = "IntPtr" if result.replace(" ", "") == "constchar*" else self.type_of(result)
            yield f"  public static extern {returned} {name}({', '.join(self.parameter(*arg) for arg in args)});"
        yield "}"
        yield "}"


def csharp(check):
    text = "\n".join(CSharp(Interface()).lines()) + "\n"
    if not check:
        CSHARP.write_text(text, encoding="utf-8")
        return 0
    if CSHARP.read_text(encoding="utf-8") == text:
        return 0
    print("bindings/csharp/PhySim.cs is not that of the header; run python3 tools/c_interface.py csharp")
    return 1


def layouts():
    """bindings/csharp/Test.cs prints the same of its structs."""
    print('#include <stdio.h>\n#include "physim/physim.h"\nint main(void) {')
    for name, _, members in sorted(Interface().structs):
        print(f'  printf("{name} %d\\n", (int)sizeof({name}));')
        for _, member, *_ in members:
            print(f'  printf("{name}.{member} %d\\n", (int)offsetof({name}, {member}));')
    print("  return 0;\n}")
    return 0


# ----------------------------------------------------------------------------------------------------------------- ABI
def stub_of(interface):
    """A library of empty functions."""
    lines = ['#include "physim/physim.h"']
    for name, _, result, args in interface.functions:
        parameters = ", ".join(f"{c_type} {arg}" for c_type, arg in args) or "void"
        lines.append(f"{result} {name}({parameters}) {{ return ({result})0; }}")
    return "\n".join(lines) + "\n"


def shown_by(library):
    table = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1] for line in table.splitlines() if " T " in line}


def record_of(interface, folder):
    stub, library = folder / "stub.c", folder / "libphysim_c.so"
    stub.write_text(stub_of(interface), encoding="utf-8")
    compiler = ["cc", "-std=c99", "-g", "-O0", "-shared", "-fPIC", "-w", f"-I{ROOT}/include", str(stub), "-o", str(library)]
    subprocess.run(compiler, check=True)
    options = ["--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-elf-needed", "--no-architecture"]
    return subprocess.run(["abidw", *options, str(library)], check=True, capture_output=True, text=True).stdout


def abi(library, record):
    interface = Interface()
    declared, shown = {name for name, *_ in interface.functions}, shown_by(library)
    if declared != shown:
        print(f"{library} and its header do not have the same functions: {', '.join(sorted(declared ^ shown))}")
        return 1
    with tempfile.TemporaryDirectory() as name:
        now = record_of(interface, Path(name))
        if record:
            RECORD.write_text(now, encoding="utf-8")
            return 0
        fresh = Path(name) / "now.xml"
        fresh.write_text(now, encoding="utf-8")
        compared = subprocess.run(["abidiff", str(RECORD), str(fresh)], check=False, capture_output=True, text=True)
    if compared.returncode == 0:
        print(f"the ABI of {len(declared)} functions is that of the record")
        return 0
    print(compared.stdout)
    if compared.returncode & 3:  # abidiff could not compare
        print(compared.stderr)
        return 1
    return judged(compared.stdout)


def judged(difference):
    version = re.search(r'kVersion = "(\d+)', (ROOT / "include/physim/result.hpp").read_text(encoding="utf-8"))
    told = CHANGES.read_text(encoding="utf-8")
    untold = sorted({name for name in re.findall(r"\bphysim_\w+", difference) if name not in told})
    if version and int(version[1]) == 0:
        print("warning: the ABI of the C interface has changed; ./dev abi --record keeps it as it is now")
        return 0
    if untold:
        print(f"the ABI has changed, and docs/api_changes.md does not name: {', '.join(untold)}")
    return 1 if untold else 0


def main():
    args = sys.argv[1:]
    if args[:1] == ["csharp"] and args[1:] in ([], ["--check"]):
        return csharp(len(args) == 2)
    if args == ["layouts"]:
        return layouts()
    names = [arg for arg in args[1:] if arg != "--record"]
    if args[:1] == ["abi"] and len(names) == 1:
        return abi(names[0], "--record" in args)
    print(__doc__)
    return 2


if __name__ == "__main__":
    sys.exit(main())
