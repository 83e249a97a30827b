"""Pictures: each is drawn, has axes with titles and units, and shows the numbers that it is of."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import SCENARIOS

import physim

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")


def lines(axes):
    return [line for line in axes.get_lines() if len(line.get_xdata()) > 10]


def test_a_flight(tmp_path, bullet):
    flight = bullet.fly()
    figure = flight.plot()
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles[0].startswith("height [m] over distance") and "speed [m/s]" in titles and "ax [m/s²]" in titles
    drawn = lines(figure.axes[0])[0]
    assert drawn.get_ydata().min() == flight.end.y and drawn.get_xdata().max() == pytest.approx(flight.range)
    figure.savefig(tmp_path / "flight.png")
    assert (tmp_path / "flight.png").stat().st_size > 10_000
    own = matplotlib.figure.Figure()
    assert flight.plot(own) is own and own.axes


def test_corners_stay_corners():
    flight = physim.Scenario.from_file(SCENARIOS / "model_rocket.toml").fly()
    figure = flight.plot()
    texts = [text.get_text() for text in figure.axes[0].texts]
    assert "burnout" in texts


def test_a_comparison(level):
    figure = level.compare(["arcade", "small_arms"]).plot()
    names = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert names == ["arcade", "small_arms", "reference"]


def test_a_world(tmp_path):
    world = physim.Scenario.from_file(SCENARIOS / "world_machine_gun.toml").world()
    world.trace()
    world.step(120)
    figure = world.plot()
    assert [axes.get_title(loc="left").partition(",")[0] for axes in figure.axes] == [
        "from the side", "from above (to the right is down)", "hits on the wall",
    ]  # fmt: skip
    paths = [line for line in figure.axes[0].get_lines() if len(line.get_xdata()) > 2]
    assert len(paths) > 5
    assert min(line.get_xdata().min() for line in paths) == 0 and max(line.get_xdata().max() for line in paths) == 100
    figure.savefig(tmp_path / "world.png")
    assert physim.World().plot().axes


def test_a_study(tmp_path, level):
    study = level.study(inputs={"speed": "+- 3 m/s", "azimuth": "+- 0.2 mrad"}, range=600, shots=10_000,
                        targets={"plate": "rectangle 45 cm x 75 cm at 0 m, -1 m", "disc": "circle 20 cm at 0 m, -1 m",
                                 "roof": "polygon -1 m, 0 m; 1 m, 0 m; 0 m, 1 m"})  # fmt: skip
    figure = study.run().plot()
    assert [axes.get_title(loc="left").split(",")[0] for axes in figure.axes][0] == "up [m]"
    assert len(figure.axes[0].patches) == 3 + 3
    shots = sum(len(line.get_xdata()) for line in figure.axes[0].get_lines())
    assert shots == 4096 + 1
    assert [label.get_text() for label in figure.axes[1].get_yticklabels()][-1].startswith("shot.")
    figure.savefig(tmp_path / "study.png")
    plain = level.study(inputs={"speed": "+- 3 m/s"}, shots=5000, quantities=["time"]).run()
    assert plain.plot().axes and np.isfinite(plain.quantities["time"].deviation)
