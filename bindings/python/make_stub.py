"""Writes the stub of the extension module: that of nanobind, with types that `mypy --strict` takes.

python make_stub.py FOLDER_OF_THE_MODULE OUTPUT
"""

import importlib.util
import re
import sys
from pathlib import Path

from nanobind.stubgen import StubGen


def main() -> None:
    folder, output = Path(sys.argv[1]), Path(sys.argv[2])
    found = sorted(folder.glob("_core*.so")) + sorted(folder.glob("_core*.pyd"))
    tags = (f"cpython-{sys.version_info[0]}{sys.version_info[1]}", "abi3")
    file = next(path for path in found if any(tag in path.name for tag in tags) or len(found) == 1)
    spec = importlib.util.spec_from_file_location("_core", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    stub = StubGen(module)
    stub.put(module)
    text = stub.get()
    for bare, full in (("dict", "dict[str, Any]"), ("list", "list[Any]"), ("tuple", "tuple[Any, ...]")):
        text = re.sub(rf"\b{bare}\b(?=\s*(?:[:,)]|\||$))(?<!\.)", full, text, flags=re.M)
    text = text.replace("-> object:", "-> Any:")
    if "from typing import Any" not in text:
        text = "from typing import Any\n" + text
    text += "\n__version__: str\n"
    output.write_text(text, encoding="utf-8")


main()
