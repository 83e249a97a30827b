"""Studies: uncertain numbers in, probabilities out; flown by threads, or by any executor, with equal bits."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Executor, Future, as_completed
from typing import Any

from . import _core
from ._errors import Error
from ._scenario import Scenario, Shot
from ._settings import _paths, path_of
from ._table import Columns, Record, html_table
from ._values import Quantity, bits, expect, quantity, whole

_BARS = 60  # of histograms


class StudyResult:
    """The result of a study. Estimates are pairs of value and standard error.

    Attributes:
        shots, refused, not_arrived: counts
        quantities: by name: mean, deviation, least, most, quantiles, histogram
        hits: by target: probability, low, high (of the 95 % interval), hits
        from_aim, from_centre, in_space: radii: mean, r50, r90, r95 [m]; or None
        ellipse, zone, spreads, worst, indices, over_inputs, stages, covariance
        at: the same at each place on the way
    """

    shots: int
    refused: int
    not_arrived: int
    from_aim: Record | None
    from_centre: Record | None
    in_space: Record | None
    ellipse: Record | None
    zone: Record | None

    def __init__(self, answer: Mapping[str, Any], study: Study, part: bytes = b"") -> None:
        self.__dict__.update({name: _recorded(value) for name, value in answer.items()})
        self.quantities: dict[str, Record] = {row["quantity"]: Record(row) for row in answer["quantities"]}
        self.hits: dict[str, Record] = {row["name"]: Record(row) for row in answer["hits"]}
        self.at: list[StudyResult] = [StudyResult(place, study) for place in answer["at"]]
        self.study = study
        self.part = part
        """The shards that were flown, as bytes: `Study.run(so_far=...)` goes on from there."""

    @property
    def figures(self) -> Columns:
        """Every figure under its own name: value and standard error."""
        if not self.part:
            raise Error("figures are those of the end of a study", "figures")
        return Columns(self.study._core.figures(self.part, self.__dict__["shards"]))

    def to_frame(self) -> Any:
        """The figures as a pandas DataFrame."""
        return self.figures.to_frame().set_index("figure")

    def plot(self, figure: Any = None) -> Any:
        """A Matplotlib figure: impacts with targets and ellipse, what each input costs, and how the figures settled."""
        from ._plot import plot_study  # noqa: PLC0415

        return plot_study(self, figure)

    def __repr__(self) -> str:
        hits = "; ".join(f"{name} {100 * h.probability[0]:.1f} %" for name, h in self.hits.items())
        radius = f"; R50 {self.from_aim.r50:.4g} m" if self.from_aim is not None else ""
        return f"<physim.StudyResult: {self.shots} shots{radius}{'; ' + hits if hits else ''}>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, Any]] = [("shots", self.shots), ("not arrived", self.not_arrived)]
        rows += [(f"hits {name} [%]", f"{100 * h.probability[0]:.2f} ({100 * h.low:.2f} to {100 * h.high:.2f})")
                 for name, h in self.hits.items()]  # fmt: skip
        if self.from_aim is not None:
            rows += [("CEP [m]", self.from_aim.r50), ("R95 [m]", self.from_aim.r95)]
        rows += [(f"{name}: mean, deviation", f"{q.mean[0]:.6g}, {q.deviation:.4g}") for name, q in self.quantities.items()]
        return html_table(["study", self.study.title], rows)


class Study:
    """Many flights of one shot with uncertain numbers.

        study = shot.study(inputs={"speed": "+- 3 m/s", "environment_wind_velocity.z": "0 m/s +- 1 m/s"},
                           targets={"plate": "rectangle 45 cm x 75 cm"}, range=600, shots=100_000)
        result = study.run()

    Options are the settings of [study]: inputs, correlated, targets, quantities, at, aim, sampling, shots, seed, rounds,
    indices, over_inputs. Inputs are a dict of distributions by keyword or path, or texts "shot.speed = +- 3 m/s";
    a distribution in the place of a shot's number counts, too. Targets are a dict of shapes by name, or texts.

        range: where the plane of impact stands [m]
        until_width: ends it when the first target's hit probability, or the first mean, is known to this width
    """

    __slots__ = ("__weakref__", "_core", "_setup", "_shot", "_until_width", "so_far")

    def __init__(
        self,
        of: Shot | Scenario,
        *,
        shot: str = "",
        range: Quantity | None = None,
        until_width: Quantity = 0.0,
        inputs: Mapping[str, str] | Sequence[str] | None = None,
        targets: Mapping[str, str] | Sequence[str] | None = None,
        **options: Any,
    ) -> None:
        changes: dict[str, Any] = {}
        for name, value in options.items():
            if f"study.{name}" not in _paths():
                known = sorted(path.removeprefix("study.") for path in _paths() if path.startswith("study."))
                raise Error(f'unknown option "{name}"', name, "known are " + ", ".join(known))
            changes[f"study.{name}"] = value
        if targets is not None:
            named = targets.items() if isinstance(targets, Mapping) else ()
            changes["study.targets"] = [f"{name}: {target}" for name, target in named] or list(targets)
        if range is not None:
            changes["until.range"] = range
        setup = expect(of, (Shot, Scenario), "of", "give a Shot or a Scenario")._setup
        if inputs is not None:
            changes["study.inputs"] = [*setup.inputs_given, *_inputs(inputs)]
        self._setup = setup.with_settings(changes) if changes else setup
        self._shot, self._until_width = shot, 0.0
        self._core = _core.Study.make(self._setup, shot, 0.0)
        if until_width:
            self._until_width = quantity(until_width, "until_width", "" if self._core.targets else self._core.units[0])
            self._core = _core.Study.make(self._setup, shot, self._until_width)
        self.so_far = b""
        """Shards that were flown, as bytes: `run()` goes on from there, also after an executor failed."""

    @property
    def title(self) -> str:
        return self._setup.title or self._shot or self._setup.shots[0]

    @property
    def shards(self) -> int:
        """Parts that it is flown in, each alone."""
        return self._core.shards

    @property
    def inputs(self) -> list[str]:
        """Uncertain numbers, with units."""
        return self._core.inputs

    @property
    def notes(self) -> list[str]:
        """To be known before it is flown: how often draws are impossible."""
        return self._core.notes

    def run(
        self,
        executor: Executor | None = None,
        *,
        threads: int = 0,
        so_far: bytes = b"",
        progress: Callable[[int, int], object] | None = None,
        shards_per_task: int | None = None,
        seconds: Quantity | None = None,
    ) -> StudyResult:
        """Flies what is missing and returns the result. Its bits depend neither on threads nor on the executor.

            executor: of concurrent.futures (processes, Dask, MPI, ...); each task flies some shards, named by their
                numbers, so that no two calls are equal. If one fails, what was flown is in `so_far`, and the next run()
                goes on from there.
            threads: 0: all of the machine; in a task of an executor there is one
            progress: called with shards done and all, in this thread's process; if it returns False, the study stops
            shards_per_task: by default so many that there are about a hundred tasks
            seconds: it ends then, with the shards that are under way; the result says `time_was_up`. On threads only
        """
        self.so_far = so_far or self.so_far
        seconds = None if seconds is None else quantity(seconds, "seconds", "s")
        if seconds is not None and not (seconds > 0 and executor is None):
            raise Error("is no time that a study on threads ends by", "seconds", "an executor flies all of it")
        if executor is not None:
            return self._run_on(executor, progress, shards_per_task)
        after = None if progress is None else (lambda done: progress(done, self.shards) is not False)
        answer, self.so_far = self._core.run_all(self.so_far, bits(threads, "threads"), after, _BARS, seconds)
        return StudyResult(answer, self, self.so_far)

    def _run_on(self, executor: Executor, progress: Callable[[int, int], object] | None, size: int | None) -> StudyResult:
        if self._until_width:
            raise Error("ends by the width of a figure", "until_width", "run it on threads, or give shots")
        size = whole(size, "shards_per_task") if size else max(1, self.shards // 100)
        missing = [i for i in range(self.shards) if not _core.has_shard(self.so_far, i)]
        tasks: list[Future[bytes]] = []
        key = (self._setup.text(), self._setup.file, self._setup.wind_field, self._setup.force_field, self._shot)
        for first in missing[::size]:
            count = sum(1 for i in missing if first <= i < first + size) if size > 1 else 1
            tasks.append(executor.submit(_fly_shards, key, first, count))
        try:
            for task in as_completed_of(tasks):
                part = task.result()
                self.so_far = _core.merge_parts(self.so_far, part) if self.so_far else part
                done = _core.shards_in(self.so_far)
                if progress is not None and progress(done, self.shards) is False:
                    break
        except BaseException:
            for task in tasks:
                task.cancel()
            raise
        for task in tasks:
            task.cancel()
        flown = next((i for i in range(self.shards) if not _core.has_shard(self.so_far, i)), self.shards)
        return StudyResult(self._core.result(self.so_far, flown, _BARS), self, self.so_far)

    def fly_shards(self, first: int, count: int = 1, *, threads: int = 1) -> bytes:
        """Flies some shards, as bytes: for schedulers that are no executors. `merge()` joins them."""
        return self._core.run_part(whole(first, "first"), whole(count, "count"), b"", bits(threads, "threads"), None)

    def merge(self, parts: Iterable[bytes]) -> StudyResult:
        """The result of parts that `fly_shards()` made, in any order; all shards from the first on must be there."""
        for part in parts:
            self.so_far = _core.merge_parts(self.so_far, part) if self.so_far else part
        return StudyResult(self._core.result(self.so_far, _core.shards_in(self.so_far), _BARS), self, self.so_far)

    def samples(self, shard: int = 0) -> Columns:
        """Shots of a shard one by one: what they drew, and where they ended."""
        return Columns(self._core.shots(whole(shard, "shard")))

    def linear(self) -> Record | None:
        """Covariances by slopes, without sampling: what a deviation of each input does."""
        answer = self._core.linear()
        return None if answer is None else Record(answer)

    def __reduce__(self) -> Any:
        return (_unpickled_study, (Scenario._of(self._setup), self._shot, self._until_width, self.so_far))

    def __repr__(self) -> str:
        return f"<physim.Study {self.title!r}: {self.shards} shards, {len(self.inputs)} inputs>"


def as_completed_of(tasks: Sequence[Future[bytes]]) -> Iterable[Future[bytes]]:
    """Tasks as they end; of executors whose futures are not those of the standard library, in their order."""
    return as_completed(tasks) if all(isinstance(task, Future) for task in tasks) else tasks


def _unpickled_study(scenario: Scenario, shot: str, until_width: float, so_far: bytes) -> Study:
    study = Study(scenario, shot=shot, until_width=until_width)
    study.so_far = so_far
    return study


@functools.lru_cache(maxsize=4)
def _study_of(text: str, file: str, wind_field: Any, force_field: Any, shot: str) -> _core.Study:
    return _core.Study.make(_core.Setup.from_text(text, file, [], wind_field, force_field), shot, 0.0)


def _fly_shards(key: tuple[str, str, Any, Any, str], first: int, count: int) -> bytes:
    """The task of an executor; each process prepares the study once."""
    return _study_of(*key).run_part(first, count, b"", 1, None)


def _inputs(inputs: Mapping[str, str] | Sequence[str]) -> list[str]:
    if not isinstance(inputs, Mapping):
        return [inputs] if isinstance(inputs, str) else list(inputs)
    texts = []
    for keyword, distribution in inputs.items():
        head, dot, component = keyword.partition(".")
        path = keyword
        if not keyword.startswith(("shot.", "environment.")):
            path = path_of(head) + dot + component
        texts.append(f"{path} = {distribution}")
    return texts


def _recorded(value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return [_recorded(each) for each in value]
    return value


def study_paths() -> Columns:
    """Numbers that may be uncertain: path, unit, text."""
    rows = _core.study_paths()
    return Columns({name: [row[i] for row in rows] for i, name in enumerate(("path", "unit", "about"))})


