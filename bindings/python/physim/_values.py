"""Arguments of calls: numbers with units, whole numbers, points and objects; an Error for what is none."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from typing import Any, TypeVar

from . import _core
from ._errors import Error

_Kind = TypeVar("_Kind")
Quantity = float | str
Vector = Sequence[float | str] | str


def quantity(value: Any, name: str, unit: str) -> float:
    """A number in SI, a text with a unit, or a quantity of pint, as a number in SI. `unit`: of SI, "" of plain numbers."""
    if isinstance(value, str):
        return _core.parse_number(value, unit, name)
    if hasattr(value, "to") and hasattr(value, "magnitude"):
        value = in_si(value, name, unit)
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        hint = f'give a number in {unit}, or a text such as "1 {unit}"' if unit else "give a number"
        raise Error(f"found {shown(value)}", name, hint) from error
    if math.isnan(number):
        raise Error("is not a number", name)
    return number


def in_si(value: Any, name: str, unit: str) -> Any:
    """The magnitude of a quantity of pint in a unit of SI."""
    try:
        return value.to(unit or "dimensionless").magnitude
    except Exception as error:  # of pint, which need not be there
        raise Error(str(error), name) from error


def not_negative(value: Any, name: str, unit: str) -> float:
    """As quantity()."""
    number = quantity(value, name, unit)
    if number < 0:
        raise Error("must not be negative", name)
    return number


def whole(value: Any, name: str, most: int = 2**63 - 1) -> int:
    """A whole number from 0 on."""
    try:
        number = int(value) if isinstance(value, float) and value.is_integer() else operator.index(value)
    except TypeError as error:
        raise Error(f"found {shown(value)}", name, "give a whole number") from error
    if number < 0:
        raise Error("must not be negative", name)
    if number > most:
        raise Error("is too large", name, f"{most} at most")
    return number


def bits(value: Any, name: str) -> int:
    """A number of 32 bits: threads, layers."""
    return whole(value, name, 2**32 - 1)


def handle(value: Any, name: str) -> int:
    """An id, as the calls that make something return it."""
    return whole(value, name, 2**64 - 1)


def vector(value: Any, name: str, unit: str, size: int = 3) -> list[float]:
    """A point or a velocity: three numbers, or a text "500 m, 20 m, 0 m"."""
    try:
        parts = [each.strip() for each in value.split(",")] if isinstance(value, str) else list(value)
    except TypeError as error:
        raise Error(f"found {shown(value)}", name, "give x, y, z") from error
    if len(parts) != size:
        raise Error(f"found {len(parts)} components", name, "expected three: x, y, z" if size == 3 else f"expected {size}")
    return [quantity(each, name, unit) for each in parts]


def expect(value: Any, kind: type[_Kind] | tuple[type[_Kind], ...], name: str, hint: str) -> _Kind:
    """An object of a class."""
    if not isinstance(value, kind):
        raise Error(f"found {shown(value)}", name, hint)
    return value


def shown(value: Any) -> str:
    """What was found, for messages."""
    text = repr(value) if isinstance(value, (str, bytes, int, float, type(None))) else ""
    return text if text and len(text) < 40 else f"an object of type {type(value).__name__}"
