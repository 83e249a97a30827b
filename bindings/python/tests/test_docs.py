"""Every block of Python in the guide and in the README runs, one after the other."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT


@pytest.mark.parametrize("page", ["docs/python.md", "README.md"])
def test_blocks_run(page, monkeypatch, tmp_path):
    pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(ROOT)
    text = (ROOT / page).read_text(encoding="utf-8").replace("/tmp/", f"{tmp_path}/")
    text = text.replace('"shot.png"', f'"{tmp_path}/shot.png"')
    blocks = re.findall(r"```python\n(.*?)```", text, re.S)
    assert blocks
    names: dict[str, object] = {}
    for i, block in enumerate(blocks):
        exec(compile(block, f"{page}, block {i + 1}", "exec"), names)
    assert (tmp_path / "shot.png").stat().st_size > 20_000


def test_the_guide_is_short():
    assert len((ROOT / "docs/python.md").read_text(encoding="utf-8").split()) < 2500


def test_the_guide_names_only_what_there_is():
    import physim

    text = (ROOT / "docs/python.md").read_text(encoding="utf-8")
    for name in re.findall(r"physim\.([A-Za-z_]+)", text):
        assert hasattr(physim, name), name
