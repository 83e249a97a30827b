"""The notebooks: every cell runs, in order, and each shows pictures."""

from __future__ import annotations

import json

import pytest
from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "bindings/python/notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_cells_run(file, monkeypatch, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt  # noqa: PLC0415

    plt.close("all")
    monkeypatch.chdir(ROOT)
    cells = json.loads(file.read_text(encoding="utf-8"))["cells"]
    names: dict[str, object] = {}
    for i, cell in enumerate(cells):
        assert not cell.get("outputs"), "notebooks are kept without outputs"
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"{file.name}, cell {i + 1}", "exec"), names)
    assert len(plt.get_fignums()) >= 1
    for number in plt.get_fignums():
        plt.figure(number).savefig(tmp_path / f"{number}.png")
    plt.close("all")


def test_there_are_three():
    assert len(NOTEBOOKS) == 3
