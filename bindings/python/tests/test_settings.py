"""The list of settings: each of it is a keyword, says what it is, and is refused with place and hint where it is bad."""

from __future__ import annotations

import inspect

import numpy as np
import pytest

import physim
from physim import _core
from physim._settings import path_of


def single_settings():
    return [row for row in physim.settings().values() if row.keyword and row.path != "shot"]


def test_every_row_of_the_list_is_here_with_text_and_range():
    rows = physim.settings()
    assert len(rows) == len(_core.settings()) > 450
    for row in rows.values():
        assert row.doc and row.type and row.describe()


def test_settings_without_a_keyword_are_those_of_lists():
    left_out = [row.path for row in physim.settings().values() if not row.keyword and not row.in_list]
    assert left_out == ["force"]  # shots have one of their own; scenarios take it as a table


def test_keywords_are_unique_and_lead_to_their_paths():
    keywords = [row.keyword for row in single_settings()]
    assert len(set(keywords)) == len(keywords)
    for row in single_settings():
        assert path_of(row.keyword) == row.path
        assert path_of(row.path) == row.path


def test_every_setting_is_taken_as_a_keyword():
    """A text stands at its place then, or is refused with its path."""
    for row in single_settings():
        try:
            given = physim.Shot(**{row.keyword: "x"})._given()
        except physim.Error as error:
            place = row.path.rpartition(".")[0] + "."
            assert any(path in (error.path, error.place) for path in (row.path, row.path.partition(".")[0])) or (
                row.path in str(error) or place in str(error)
            ), (row.path, str(error))
        else:
            assert (row.path, "x") in given, row.path


def test_keys_of_lists_are_taken_in_dicts():
    for row in physim.settings().values():
        if row.in_list and row.type in ("quantity", "integer") and not row.path.startswith("expect"):
            with pytest.raises(physim.Error) as raised:
                physim.Scenario(**{"world": {}, **nested(row.path, "no number")})
            assert row.path.rpartition(".")[2] in str(raised.value), row.path


def nested(path, value):
    """Beside it stand choices that its table cannot be without: they may say which unit it has."""
    table = path.rpartition(".")[0]
    beside = {
        row.path.removeprefix(table + "."): row.range.partition(" ")[0]
        for row in physim.settings().values()
        if row.required and row.type == "choice" and row.path.rpartition(".")[0] == table
    }
    lists = {row.path for row in physim.settings().values() if row.type == "list" or row.path == "shot"}
    parts = path.split(".")
    for i in range(len(parts), 0, -1):
        head = ".".join(parts[:i])
        value = [value] if head in lists and i < len(parts) else value
        value = {parts[i - 1]: value} | (beside if i == len(parts) else {})
    return value


def test_docstring_names_every_keyword_with_unit_and_default():
    for row in single_settings():
        assert f"    {row.keyword}: {row.doc}" in (physim.Shot.__doc__ or ""), row.keyword
    assert "speed" in (inspect.getdoc(physim.Shot) or "")


def test_defaults_are_told():
    assert physim.settings()["shot.mass"].default == "1 kg"
    assert physim.settings()["shot.mass"].unit == "kg"
    assert "gr" in physim.settings()["shot.mass"].units


def test_search_and_tables():
    found = physim.settings().search("wind", "profile")
    assert all("wind" in path for path in found) and len(found) > 1
    assert "<table>" in found._repr_html_() and "environment.wind" in repr(found)


@pytest.mark.parametrize(
    ("keywords", "path", "words"),
    [
        ({"mass": "168 furlong"}, "shot.mass", "known units: kg"),
        ({"mass": -1}, "shot.mass", "must be > 0"),
        ({"mass": float("nan")}, "shot.mass", "not a finite number"),
        ({"mass": None}, "shot.mass", "not a number"),
        ({"mass": [1, 2]}, "shot.mass", "expected a mass"),
        ({"mass": object()}, "shot.mass", "type object"),
        ({"mass": 10**30}, "shot.mass", "too large"),
        ({"mass": {"a": 1}}, "shot.mass", "a distribution"),
        ({"drag_table": "g9"}, "shot.drag.table", "known values: constant, g1"),
        ({"position": (1, 2)}, "shot.position", "three components"),
        ({"until_events": [{"kind": "mach", "value": 1, "kine": 2}]}, "until.events.kine", "kind"),
        ({"elevation": 0.1, "sight_zero_range": 100}, "shot.elevation", "given together with"),
        ({"maas": 1}, "maas", 'did you mean "mass"'),
        ({"environment_wind": {"velocities": 1}}, "environment.wind.velocities", 'did you mean "velocity"'),
        ({"drag": "g7"}, "shot.drag", "a table with keys"),
    ],
)
def test_bad_values_are_errors_with_path_and_hint(keywords, path, words):
    with pytest.raises(physim.Error) as raised:
        physim.Shot(**keywords)
    error = raised.value
    assert path in (error.path, error.place), (error.path, error.place)
    assert words in str(error)
    assert error.message and isinstance(error, ValueError)


def test_all_mistakes_are_told_at_once():
    with pytest.raises(physim.Error) as raised:
        physim.Shot(mass=-1, diameter="3 kg")
    assert "mass" in str(raised.value) and "diameter" in str(raised.value)


def test_what_can_be_given_as_a_value():
    shot = physim.Shot(
        mass=np.float32(0.5),
        speed=np.int64(100),
        position=np.array([0.0, 1.0, 2.0]),
        drag={"table": "custom", "curve": np.array([[0.0, 0.5], [2.0, 0.25]])},
        fidelity="small_arms",
        fidelity_rotation="none",
        sight_zero_in_calm_air=np.bool_(True),
    )
    assert shot.get("mass") == "0.5 kg"
    assert shot["shot.speed"] == "100 m/s"
    assert shot["position"] == "[0 m, 1 m, 2 m]" or "1" in shot["position"]
    assert shot["fidelity_rotation"] == "none"
    assert shot["sight_zero_in_calm_air"] == "true"


def test_shorthands_meet_the_keys_of_their_tables_in_any_order():
    one = physim.Shot(fidelity="artillery", fidelity_integrator="rk4")
    two = physim.Shot(fidelity_integrator="rk4", fidelity="artillery")
    three = physim.Shot(fidelity={"preset": "artillery", "integrator": "rk4"})
    four = physim.Shot(fidelity="artillery").replace(fidelity_integrator="rk4")
    assert one == two == three == four
    assert one["fidelity_integrator"] == "rk4" and one["fidelity_gravity"] == "inverse_square"


def test_tables_and_their_keys_meet_in_any_order():
    one = physim.Shot(drag={"table": "g7"}, drag_ballistic_coefficient=200)
    two = physim.Shot(drag_ballistic_coefficient=200, drag={"table": "g7"})
    assert one == two and one["drag_table"] == "g7"


def test_notes_tell_what_is_unusual_and_what_is_not_read():
    shot = physim.Shot(mass=0.01, diameter="7.8 mm", speed=3e5, drag_table="g7", drag_coefficient=0.3)
    assert len(shot.notes) == 2
    assert "shot.speed" in shot.notes[1] and "no effect beside" in shot.notes[0]
    assert physim.Shot().notes == []


def test_pint_quantities_are_taken_in_their_dimension():
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    given = physim.Shot(
        mass=168 * unit.grain,
        speed=2700 * unit.foot / unit.second,
        elevation=2 * unit.degree,
        drag_ballistic_coefficient=0.218 * unit.pound / unit.inch**2,
        environment_atmosphere_temperature=unit.Quantity(25, "degC"),
        position=[0, 1, 0] * unit.yard,
    )
    text = physim.Shot(
        mass="168 gr",
        speed="2700 ft/s",
        elevation="2 deg",
        drag_ballistic_coefficient="0.218 lb/in^2",
        environment_atmosphere_temperature="25 degC",
        position=["0 yd", "1 yd", "0 yd"],
    )
    for path in ("mass", "speed", "elevation", "drag_ballistic_coefficient", "environment_atmosphere_temperature"):
        a, b = (float(each[path].split()[0]) for each in (given, text))
        assert a == pytest.approx(b, rel=1e-12), path
    with pytest.raises(physim.Error) as raised:
        physim.Shot(mass=3 * unit.metre)
    assert raised.value.path == "shot.mass"
