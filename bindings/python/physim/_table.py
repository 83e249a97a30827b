"""Columns: what batches, samples, events and tables come in. NumPy arrays by name; a DataFrame where pandas is there."""

from __future__ import annotations

import html
import importlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import Error

_SHOWN = 12  # rows of a table in a notebook or a terminal


def optional(name: str) -> Any:
    """A package that may be missing."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise Error(f"{name} is not installed", name, f"pip install {name}") from error


def _text(value: Any) -> str:
    if isinstance(value, float):
        return "" if value != value else f"{value:.6g}"
    if isinstance(value, np.ndarray):
        return "(" + ", ".join(f"{each:.4g}" for each in value.ravel()) + ")"
    return str(value)


def html_table(names: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """A table for notebooks."""
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(_text(each))}</td>" for each in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


class Columns(Mapping[str, NDArray[Any]]):
    """Columns of one length, by name: `columns["x"]` or `columns.x`.

    NumPy arrays, or arrays of rows of three for vectors. Slices and masks take rows: `columns[:10]`,
    `columns[columns.speed > 300]`.
    """

    units: Mapping[str, str]
    """Of each column that has one."""

    def __init__(self, columns: Mapping[str, Any], units: Mapping[str, str] | None = None) -> None:
        self._columns: dict[str, NDArray[Any]] = {name: np.asarray(column) for name, column in columns.items()}
        self.units = dict(units or {})

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            return self._columns[key]
        if isinstance(key, (int, np.integer)):
            return {name: column[key] for name, column in self._columns.items()}
        return type(self)({name: column[key] for name, column in self._columns.items()}, self.units)

    def __getattr__(self, name: str) -> NDArray[Any]:
        if not name.startswith("_") and name in self._columns:
            return self._columns[name]
        raise AttributeError(f"there is no column {name!r}; there are {', '.join(self._columns)}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """The number of columns, as of any mapping; `size` is that of rows."""
        return len(self._columns)

    @property
    def size(self) -> int:
        """The number of rows."""
        return len(next(iter(self._columns.values()))) if self._columns else 0

    def rows(self) -> Iterator[dict[str, Any]]:
        """A dict for each row."""
        return (self[i] for i in range(self.size))

    def to_frame(self) -> Any:
        """A pandas DataFrame; vectors become three columns: position_x, position_y, position_z."""
        pandas = optional("pandas")
        flat: dict[str, Any] = {}
        for name, column in self._columns.items():
            if column.ndim == 1:
                flat[name] = column
            else:
                ends = "wxyz" if column.shape[1] == 4 else "xyz"
                flat.update({f"{name}_{end}": column[:, i] for i, end in enumerate(ends)})
        return pandas.DataFrame(flat)

    def _titles(self) -> list[str]:
        return [f"{name} [{self.units[name]}]" if self.units.get(name) else name for name in self._columns]

    def _shown(self) -> tuple[list[list[Any]], bool]:
        count = min(self.size, _SHOWN)
        return [[column[i] for column in self._columns.values()] for i in range(count)], count < self.size

    def __repr__(self) -> str:
        rows, more = self._shown()
        cells = [self._titles(), *[[_text(each) for each in row] for row in rows]]
        widths = [max(len(row[i]) for row in cells) for i in range(len(self._columns))]
        lines = ["  ".join(each.rjust(width) for each, width in zip(row, widths)) for row in cells]
        return "\n".join(lines + ([f"... {self.size} rows"] if more else []))

    def _repr_html_(self) -> str:
        rows, more = self._shown()
        return html_table(self._titles(), rows) + (f"<p>... {self.size} rows</p>" if more else "")

    def __getstate__(self) -> dict[str, Any]:
        return {"columns": self._columns, "units": self.units}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._columns, self.units = state["columns"], state["units"]


class Record:
    """A few named figures: attributes, `as_dict()`, and a table in notebooks."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.__dict__.update(values)

    def __getitem__(self, name: str) -> Any:
        return self.as_dict()[name]

    def as_dict(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if not name.startswith("_")}

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"there is no {name!r}; there are {', '.join(self.as_dict())}")

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={_text(value)}' for name, value in self.as_dict().items())})"

    def _repr_html_(self) -> str:
        return html_table(["", type(self).__name__], list(self.as_dict().items()))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Record):
            return NotImplemented
        mine, its = self.as_dict(), other.as_dict()
        return mine.keys() == its.keys() and all(np.array_equal(mine[name], its[name]) for name in mine)

    __hash__ = None  # type: ignore[assignment]  # it holds arrays
