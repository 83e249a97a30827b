"""The exception of the library: what is wrong, where, and what to do about it."""

from __future__ import annotations

import re


class Error(ValueError):
    """An error in some input.

    Attributes:
        message: the error, in one sentence.
        place: of the error: a path of a setting, or "file:line:column" of a scenario; may be empty.
        hint: the correction; may be empty.
        path: of the setting that is wrong ("shot.mass"), as far as the error is about one; else the place.
    """

    def __init__(self, message: str, place: str = "", hint: str = "") -> None:
        super().__init__(message, place, hint)
        self.message = message
        self.place = place
        self.hint = hint

    @property
    def path(self) -> str:
        named = re.match(r"([a-z_]+(?:\.[a-z_]+)+|physim|title|source): ", self.message)
        return named.group(1) if named else self.place

    def __str__(self) -> str:
        named = not self.place or self.message.startswith(self.place + ":")
        text = self.message if named else f"{self.place}: {self.message}"
        return f"{text}; {self.hint}" if self.hint else text
