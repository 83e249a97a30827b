"""Pictures with Matplotlib, in the style of the command line's."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import Error
from ._table import optional

if TYPE_CHECKING:
    from ._flight import Flight
    from ._study import StudyResult
    from ._world import World

# The colours of Okabe and Ito, which people with colour blindness can tell apart.
BLUE, ORANGE, GREEN, PINK, YELLOW, SKY, BLACK = (
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#333333",
)  # fmt: skip
_SERIES = (BLUE, ORANGE, GREEN, PINK, YELLOW, SKY, BLACK)
_GREY = "#6e6e6e"
_SAMPLES = 400


def _new_figure(figure: Any, size: tuple[float, float]) -> Any:
    if figure is not None:
        return figure
    # Of pyplot, which shows it at the end of a notebook's cell.
    return optional("matplotlib.pyplot").figure(figsize=size, layout="constrained")


def _title(figure: Any, title: str, below: str = "") -> None:
    figure.suptitle(title + (f"\n{below}" if below else ""), x=0.01, ha="left", fontsize=13, color=BLACK)


def _axes(figure: Any, place: Any, title: str, xlabel: str = "", **options: Any) -> Any:
    axes = figure.add_subplot(place, **options)
    axes.set_title(title, loc="left", fontsize=10, color=BLACK)
    axes.set_xlabel(xlabel, fontsize=9)
    axes.grid(color="#e0e0e0", linewidth=0.6)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(_GREY)
    axes.tick_params(labelsize=8, color=_GREY)
    axes.ticklabel_format(useOffset=False)
    return axes


def _stretch(axes: Any, width: float, height: float) -> str:
    """The factor by which the picture stretches heights, in words; "" if they are to scale."""
    if width <= 0 or height <= 0:
        return ""
    box = axes.get_position()
    figure = axes.figure.get_size_inches()
    times = (box.height * figure[1] / height) / (box.width * figure[0] / width)
    return f", heights stretched {times:.2g} times" if times > 1.5 else ""


def plot_flights(flights: Sequence[Flight], names: Sequence[str], title: str, figure: Any = None) -> Any:
    """Height over distance, speed, and place, velocity and acceleration over time."""
    if not flights:
        raise Error("there is no flight to show", "plot")
    figure = _new_figure(figure, (11, 9))
    grid = figure.add_gridspec(4, 3, height_ratios=(1.6, 1, 1, 1))
    drawn = [flight._drawn(_SAMPLES) for flight in flights]
    several = len(flights) > 1
    path = _axes(figure, grid[0, :2], "height [m] over distance", "distance [m]")
    speed = _axes(figure, grid[0, 2], "speed [m/s]", "t [s]")
    for i, (samples, name) in enumerate(zip(drawn, names)):
        colour = _SERIES[i % len(_SERIES)]
        dashes = "-" if i < len(_SERIES) else "--"
        distance = np.hypot(samples.x - samples.x[0], samples.z - samples.z[0])
        path.plot(distance, samples.y, color=colour, linestyle=dashes, linewidth=1.6, label=name)
        speed.plot(samples.time, samples.speed, color=colour if several else PINK, linestyle=dashes, linewidth=1.4)
    low, high = path.get_ylim()
    left, right = path.get_xlim()
    path.set_title(f"height [m] over distance{_stretch(path, right - left, high - low)}", loc="left", fontsize=10)
    _event_marks(path, flights)
    if several:
        path.legend(fontsize=8, frameon=False)
    rows = (("x", "y", "z"), ("vx", "vy", "vz"), ("ax", "ay", "az"))
    units = ("m", "m/s", "m/s²")
    for row, (quantities, unit, single) in enumerate(zip(rows, units, (BLUE, ORANGE, GREEN)), start=1):
        for column, quantity in enumerate(quantities):
            axes = _axes(figure, grid[row, column], f"{quantity} [{unit}]", "t [s]" if row == 3 else "")
            for i, samples in enumerate(drawn):
                colour = _SERIES[i % len(_SERIES)] if several else single
                axes.plot(samples.time, samples[quantity], color=colour, linewidth=1.2)
            _not_flat(axes)
    shot = flights[0].shot
    fidelity = shot.get("fidelity_integrator") if not several else ""
    _title(figure, title or names[0], f"{names[0]}, {fidelity}" if title and not several else "")
    return figure


def _event_marks(axes: Any, flights: Sequence[Flight]) -> None:
    for i, flight in enumerate(flights):
        start = flight.start.position
        shown = [e for e in flight.events if e.kind in ("ignition", "burnout", "hit", "bounced", "ricocheted", "penetrated")]
        for event in shown:
            way = event.position - start
            axes.plot(np.hypot(way[0], way[2]), event.position[1], "o", color=_SERIES[i % len(_SERIES)], markersize=4)
            if len(shown) < 8:
                axes.annotate(event.kind, (np.hypot(way[0], way[2]), event.position[1]), fontsize=7,
                              xytext=(4, 4), textcoords="offset points", color=_GREY)  # fmt: skip


def _not_flat(axes: Any) -> None:
    """A number that does not change is a line, and not its rounding errors."""
    low, high = axes.dataLim.intervaly
    if high - low < 1e-9 * max(1.0, abs(low), abs(high)):
        axes.set_ylim(low - 1, high + 1)


def plot_world(world: World, figure: Any = None) -> Any:
    """The world from the side and from above: where all are, and the paths that were traced."""
    figure = _new_figure(figure, (11, 8))
    wall = np.concatenate(world._wall) if world._wall else np.empty((0, 3))
    grid = figure.add_gridspec(2, 3)
    side = _axes(figure, grid[0, :], "from the side", "downrange x [m]")
    above = _axes(figure, grid[1, :2] if len(wall) else grid[1, :], "from above (to the right is down)", "downrange x [m]")
    side.set_ylabel("height y [m]", fontsize=9)
    above.set_ylabel("right z [m]", fontsize=9)
    above.invert_yaxis()
    for path in _paths_of(world):
        side.plot(path[:, 0], path[:, 1], color=BLUE, linewidth=0.7, alpha=0.6)
        above.plot(path[:, 0], path[:, 2], color=BLUE, linewidth=0.7, alpha=0.6)
    for places, mark, colour in ((world.positions(), ".", BLUE), (world.hits.position, "x", ORANGE), (wall, ".", BLUE)):
        side.plot(places[:, 0], places[:, 1], mark, color=colour, markersize=4)
        above.plot(places[:, 0], places[:, 2], mark, color=colour, markersize=4)
    ground = world._core.ground
    if ground is not None:
        low, high = side.get_ylim()
        if low - (high - low) < ground < high:
            side.axhline(ground, color="#a0989a", linewidth=1.5)
    if len(wall):
        hits = _axes(figure, grid[1, 2], "hits on the wall, to scale", "right z [m]")
        hits.plot(wall[:, 2], wall[:, 1], ".", color=BLUE, markersize=4)
        hits.set_ylabel("height y [m]", fontsize=9)
        hits.set_aspect("equal", adjustable="datalim")
    title = world._setup.title or "World"
    _title(figure, title, f"{len(world)} projectiles at {world.time:.4g} s")
    return figure


def _paths_of(world: World) -> list[Any]:
    """Paths by projectile, in order of time, of what trace() kept."""
    trace = [part for part in world._trace or () if len(part[1])]
    if not trace:
        return []
    times, ids, places = (np.concatenate([part[i] for part in trace]) for i in range(3))
    order = np.lexsort((times, ids))
    ids, places = ids[order], places[order]
    return [path for path in np.split(places, np.flatnonzero(np.diff(ids)) + 1) if len(path) > 1]


# ------------------------------------------------------------------------------------------------------------- studies
def plot_study(result: StudyResult, figure: Any = None) -> Any:
    """Impacts with targets and ellipse, the effect of each input, and how a figure settled."""
    study = result.study
    figure = _new_figure(figure, (12, 8))
    grid = figure.add_gridspec(2, 2, width_ratios=(1.25, 1), height_ratios=(1.3, 1))
    quantities = study._core.quantities
    _impacts(figure, grid[:, 0], result, quantities)
    _effects(figure, grid[0, 1], result, quantities)
    _settling(figure, grid[1, 1], result)
    core = study._core
    below = [f"{result.shots} shots, {core.sampling}, seed {core.seed}"]
    if result.from_aim is not None:
        below.append(f"from the aim: CEP {result.from_aim.r50:.3g} m, R95 {result.from_aim.r95:.3g} m")
    below += [f"{name} {100 * hit.probability[0]:.1f} % ({100 * hit.low:.1f} to {100 * hit.high:.1f})"
              for name, hit in list(result.hits.items())[:3]]  # fmt: skip
    _title(figure, study.title, "  ·  ".join(below))
    return figure


def _impacts(figure: Any, place: Any, result: StudyResult, quantities: Sequence[str]) -> None:
    patches = optional("matplotlib.patches")

    study = result.study
    shots = study.samples(0)
    if len(quantities) < 2:
        axes = _axes(figure, place, f"{quantities[0]}", quantities[0])
        bars = result.quantities[quantities[0]].histogram
        axes.bar([bar[0] for bar in bars], [bar[2] for bar in bars], [bar[1] - bar[0] for bar in bars], align="edge", color=BLUE)
        return
    first, second = quantities[:2]
    units = study._core.units
    axes = _axes(figure, place, f"{second} [{units[1]}], the first {shots.size} shots", f"{first} [{units[0]}]")
    on_a_target = np.zeros(shots.size, dtype=bool)
    for name in shots:
        if name.startswith("hits "):
            on_a_target |= shots[name]
    for hit, colour, label in ((True, BLUE, "on a target"), (False, ORANGE, "beside")):
        chosen = on_a_target == hit
        if result.hits or not hit:
            axes.plot(shots[first][chosen], shots[second][chosen], ".", color=colour, markersize=2, alpha=0.6,
                      label=label if result.hits else "shots")  # fmt: skip
    for target in study._core.targets:
        patch = _patch_of(patches, target)
        if patch is not None:
            axes.add_patch(patch)
    if result.ellipse is not None:
        for times in (1, 2, 3):
            e = result.ellipse
            axes.add_patch(patches.Ellipse((e.right, e.up), 2 * times * e.long_axis, 2 * times * e.short_axis,
                                           angle=np.degrees(e.angle), fill=False, edgecolor=BLACK, linewidth=1))  # fmt: skip
    aim = study._core.aim
    axes.plot(*aim, "+", color=BLACK, markersize=10, label="aim")
    axes.legend(fontsize=8, frameon=False, loc="upper left", markerscale=2)
    if units[0] == units[1]:
        axes.set_aspect("equal", adjustable="datalim")


def _patch_of(patches: Any, target: dict[str, Any]) -> Any:
    style = {"facecolor": "#f0ece0", "edgecolor": "#8a8574", "linewidth": 1.2, "zorder": 0.5}
    if target["shape"] == "circle":
        return patches.Circle(target["centre"], target["radius"], **style)
    if target["shape"] == "rectangle":
        (right, up), width, height = target["centre"], target["width"], target["height"]
        return patches.Rectangle((right - width / 2, up - height / 2), width, height, **style)
    if target["shape"] == "polygon":
        return patches.Polygon(target["corners"], **style)
    return None


def _effects(figure: Any, place: Any, result: StudyResult, quantities: Sequence[str]) -> None:
    axes = _axes(figure, place, "a deviation of each input: effect and share of the variance")
    linear = result.study.linear()
    inputs = result.study.inputs
    if linear is None or not inputs:
        axes.text(0.5, 0.5, "no slopes", ha="center", transform=axes.transAxes, color=_GREY)
        return
    count = min(2, len(quantities))
    units = result.study._core.units
    rows = sorted(linear.rows, key=lambda row: float(np.nanmax(row["share"][:count])))[-8:]
    for i, row in enumerate(rows):
        for q in range(count):
            effect, share = abs(row["effect"][q]), row["share"][q]
            at = i + (0.18 if q == 0 else -0.18)
            axes.barh(at, 2 * effect, 0.32, left=-effect, color=(BLUE, YELLOW)[q], label=quantities[q] if i == 0 else None)
            if share >= 0.005:
                axes.annotate(f"± {effect:.3g} {units[q]}  {100 * share:.0f} %", (1.0, at), fontsize=7, va="center",
                              xycoords=("axes fraction", "data"), color=(BLUE, "#9a6d00")[q])  # fmt: skip
    names = [inputs[row["input"]].partition(" [")[0] for row in rows]
    axes.set_yticks(range(len(rows)), names, fontsize=8)
    axes.axvline(0, color=BLACK, linewidth=0.8)
    axes.legend(fontsize=8, frameon=False, loc="lower left")


def _settling(figure: Any, place: Any, result: StudyResult) -> None:
    stages = [stage for stage in result.__dict__["stages"]]
    hit = next(iter(result.hits), None)
    title = f"hits on {hit} [%], with the 95 % interval" if hit else "mean distance, with its standard error"
    axes = _axes(figure, place, title, "shots")
    if not stages:
        return
    shots = [stage.shots for stage in stages]
    if hit:
        rows = [stage.hits[0] for stage in stages]
        value = [100 * row["probability"][0] for row in rows]
        low, high = ([100 * row[end] for row in rows] for end in ("low", "high"))
    else:
        value = [stage.distance[0] for stage in stages]
        low = [stage.distance[0] - stage.distance[1] for stage in stages]
        high = [stage.distance[0] + stage.distance[1] for stage in stages]
    axes.fill_between(shots, low, high, color=BLUE, alpha=0.22, linewidth=0)
    axes.plot(shots, value, color=BLUE, linewidth=1.4)
    if len(shots) > 1:
        axes.set_xscale("log")
