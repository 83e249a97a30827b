"""The list of settings, and keyword arguments that are made of it."""

from __future__ import annotations

import difflib
import functools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from . import _core
from ._errors import Error

#: Names that a shot's settings may have without "shot." in front of them are those of its table.
_SHOT = "shot."


@dataclass(frozen=True)
class Setting:
    """One setting of the library: a number, a choice, a text, a list or a list of tables."""

    path: str
    """In scenario files and errors: "shot.drag.ballistic_coefficient"."""
    keyword: str
    """Of `Shot()` and `fly()`: "drag_ballistic_coefficient"; "" of keys of lists, and of a list of scenarios that has
    the name of a shot's setting ("force")."""
    type: str
    """quantity, integer, boolean, text, choice, vector, points, list, drawn, colour or gradient."""
    unit: str
    """In SI; "" of plain numbers."""
    default: str
    """As a file has it; "" where there is none."""
    range: str
    """"> 0", "0 .. 1", "off | constant | ..."; of lists their length."""
    doc: str
    """One line."""
    live: bool
    """A world can change it for one projectile in flight."""
    in_list: bool
    """It is a key of the tables of a list: "until.events.kind"."""
    required: bool
    """It has no default."""
    none: str
    """The word that None stands for, of settings that may be absent."""

    @property
    def units(self) -> list[str]:
        """Units that it takes, the one of SI first."""
        return _core.units_of(self.path)

    def describe(self) -> str:
        """Unit, range and default in brackets behind the text."""
        about = [f"in {self.unit}" if self.unit and not self.unit.startswith("of ") else self.unit, self.range]
        about.append(f"default {self.default}" if self.default else "")
        return f"{self.doc} [{'; '.join(each for each in about if each)}]"


def keyword_of(path: str) -> str:
    """The keyword of a path: dots become underscores, and "shot." goes without saying."""
    return path.removeprefix(_SHOT).replace(".", "_")


@functools.cache
def _rows() -> tuple[Setting, ...]:
    of_shots = {keyword_of(row["path"]) for row in _core.settings() if row["path"].startswith(_SHOT)}
    return tuple(
        Setting(
            path=row["path"],
            keyword="" if _is_in_list(row) or row["path"] in of_shots else keyword_of(row["path"]),
            type=row["type"],
            unit=row["unit"],
            default=row["default"],
            range=row["range"],
            doc=row["doc"],
            live=row["live"],
            in_list=_is_in_list(row),
            required=row["required"],
            none=row["none"],
        )
        for row in _core.settings()
    )


def _is_in_list(row: Mapping[str, Any]) -> bool:
    """Shots are a list, too, but keywords are those of one."""
    return bool(row["in_lists"] > (1 if row["path"].startswith(_SHOT) else 0))


class Settings(Mapping[str, Setting]):
    """All settings by path; a table in notebooks."""

    def __init__(self, rows: tuple[Setting, ...]) -> None:
        self._rows = {row.path: row for row in rows}

    def __getitem__(self, path: str) -> Setting:
        return self._rows[path]

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)

    def search(self, *words: str) -> Settings:
        """Those that have all of some words in path or text."""
        wanted = [word.lower() for word in words]
        return Settings(
            tuple(r for r in self._rows.values() if all(w in f"{r.path} {r.doc}".lower() for w in wanted))
        )

    def to_frame(self) -> Any:
        """A pandas DataFrame with a row for each."""
        from ._table import optional  # noqa: PLC0415

        return optional("pandas").DataFrame([vars(row) for row in self._rows.values()]).set_index("path")

    def __repr__(self) -> str:
        return "\n".join(f"{row.path}: {row.describe()}" for row in self._rows.values())

    def _repr_html_(self) -> str:
        from ._table import html_table  # noqa: PLC0415  # that module knows more than this one

        names = ["path", "keyword", "unit", "default", "range", "doc"]
        return html_table(names, [[getattr(row, name) for name in names] for row in self._rows.values()])


def settings() -> Settings:
    """All settings of the library with units, ranges, defaults and texts: what shots, worlds and scenarios take."""
    return Settings(_rows())


@functools.cache
def _by_keyword() -> dict[str, str]:
    """Paths by keyword: of single settings, and of tables, which may be given as dicts."""
    paths: dict[str, str] = {}
    for row in _rows():
        if not row.keyword or row.path == "shot":
            continue
        parts = row.path.split(".")
        first = 2 if parts[0] == "shot" else 1
        for end in range(first, len(parts) + 1):  # "environment", "environment.wind", ...
            path = ".".join(parts[:end])
            paths.setdefault(keyword_of(path), path)
    for row in _rows():  # a setting comes before a table of another's name
        if row.keyword and row.path != "shot":
            paths[row.keyword] = row.path
    return paths


def path_of(keyword: str) -> str:
    """The path of a keyword, or of a path itself; an Error with the nearest ones where there is none."""
    known = _by_keyword()
    found = known.get(keyword)
    if found is not None:
        return found
    if keyword in _paths():
        return keyword
    near = difflib.get_close_matches(keyword, known, n=3, cutoff=0.6)
    hint = " or ".join(f'"{each}"' for each in near)
    raise Error(
        f'unknown setting "{keyword}"', keyword, f"did you mean {hint}?" if hint else "physim.settings() lists all"
    )


@functools.cache
def _paths() -> frozenset[str]:
    return frozenset(_by_keyword().values())


class _Paths(dict[str, str]):
    """Paths by keyword, found when a keyword is used first."""

    def __missing__(self, keyword: str) -> str:
        return self.setdefault(keyword, path_of(keyword))


_PATHS = _Paths()


def by_path(keywords: Mapping[str, Any]) -> dict[str, Any]:
    """Settings by path, out of keyword arguments."""
    paths = _PATHS
    return {paths[keyword]: value for keyword, value in keywords.items()}


def keyword_docs(*, shots: bool = True) -> str:
    """The keywords with their texts, a line each, for docstrings."""
    wanted = (row for row in _rows() if row.keyword and row.path.startswith(_SHOT) == shots)
    return "\n".join(f"    {row.keyword}: {row.describe()}" for row in wanted)
