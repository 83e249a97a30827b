"""Flights: with the bits of the command line, asked at any place, and refused where they cannot be."""

from __future__ import annotations

import csv
import io
import json
import math
import pickle
import threading
import time

import numpy as np
import pytest
from conftest import BULLET, SCENARIOS, run_program, same_bits

import physim


def test_a_flight_has_the_bits_of_the_command_line():
    name = "308_168gr_g7.toml"
    out = run_program("run", f"scenarios/{name}", "--csv", "-", "--interval", "0.1 s")
    rows = list(csv.DictReader(io.StringIO(out[out.index("shot,") :])))
    flight = physim.Scenario.from_file(SCENARIOS / name).fly()
    times = [float(row["t [s]"]) for row in rows]
    samples = flight.at_times(times)
    for column, key in (("x", "x [m]"), ("y", "y [m]"), ("z", "z [m]"), ("vx", "vx [m/s]"), ("mach", "mach [-]")):
        assert same_bits(samples[column], np.array([float(row[key]) for row in rows])), column


def test_keywords_fly_as_the_file_does(bullet):
    of_file = physim.Scenario.from_file(SCENARIOS / "308_168gr_g7.toml").fly()
    of_words = physim.fly(**BULLET)
    assert of_words.duration == of_file.duration == bullet.fly().duration
    assert same_bits(of_words.end.position, of_file.end.position)
    assert of_words.elevation == of_file.elevation


def test_questions(bullet):
    flight = bullet.fly()
    assert flight.outcome == "reached_range"
    assert flight.at_range(600).range == pytest.approx(600)
    assert flight.at_range("600 m").drop == flight.at_range(600.0).drop
    assert flight.at_range("656.1679790026247 yd").time == pytest.approx(flight.at_range(600).time, rel=1e-12)
    assert flight.at_time(1).time == 1 and flight.at_time("1000 ms").time == 1
    assert flight.apogee.y >= max(flight.samples(500).y) - 1e-9
    assert flight.end.x == pytest.approx(1000) and flight.start.speed == pytest.approx(822.96)
    assert [event.kind for event in flight.events] == ["apex", "range"]
    assert flight.range == pytest.approx(1000, abs=0.1)
    samples = flight.samples(7)
    assert samples.size == 7 and samples["time"][-1] == flight.duration
    assert same_bits(samples.x[-1], flight.end.position[0])
    total = flight.accelerations(0.5)
    assert np.allclose(total["gravity"] + total["drag"], total["total"])
    before, behind = (flight.at_time(t).acceleration for t in (0.49, 0.51))
    assert np.allclose(flight.jerk("0.5 s"), (behind - before) / 0.02, rtol=0.01, atol=0.05)
    assert flight.cost["steps"] > 0 and len(flight.step_times) == flight.cost["steps"] + 1
    near, far = flight.danger_space(300, 0.5)
    assert near < 300 < far


def test_ranges_that_are_not_reached_are_nan_in_columns_and_an_error_alone(bullet):
    flight = bullet.fly()
    columns = flight.at_ranges([500, 2000])
    assert columns.drop[0] == flight.at_range(500).drop and math.isnan(columns.drop[1])
    with pytest.raises(physim.Error, match="2000"):
        flight.at_range(2000)


def test_a_refused_flight_is_an_error():
    with pytest.raises(physim.Error) as raised:
        physim.fly(**{**BULLET, "sight_zero_range": "90 km"})
    assert "zero" in str(raised.value)


def test_settings_are_read_and_changed_by_path():
    scenario = physim.Scenario.from_file(SCENARIOS / "308_168gr_g7.toml")
    assert scenario["shot.mass"] == scenario.get("shot.308-168gr.mass")
    before = scenario.fly().end
    scenario["shot.mass"] = "150 gr"
    scenario.set("shot.308-168gr.drag.ballistic_coefficient", "0.2 lb/in^2")
    assert scenario.fly().end.speed < before.speed
    text = scenario.text()
    with pytest.raises(physim.Error):
        scenario.set("shot.mass", "-1 kg")
    with pytest.raises(physim.Error, match="did you mean"):
        scenario.set("shot.masss", 1)
    assert scenario.text() == text
    changed = scenario.replace({"until.range": 500})
    assert changed.fly().end.x == pytest.approx(500) and scenario.text() == text


def test_overrides_are_those_of_the_command_line():
    scenario = physim.Scenario.from_file(SCENARIOS / "308_168gr_g7.toml", ["shot.mass=150 gr", "until.range=300 m"])
    assert scenario.fly().end.x == pytest.approx(300)
    with pytest.raises(physim.Error, match="without"):
        physim.Scenario.from_file(SCENARIOS / "308_168gr_g7.toml", ["shot.mass"])


def test_errors_of_files_have_line_and_column(tmp_path):
    file = tmp_path / "bad.toml"
    file.write_text('physim = 1\n[[shot]]\nmass = "heavy"\n')
    with pytest.raises(physim.Error) as raised:
        physim.Scenario.from_file(file)
    assert raised.value.place == f"{file}:3:8" and raised.value.path == "shot.mass"
    with pytest.raises(physim.Error):
        physim.Scenario.from_file(tmp_path / "none.toml")
    with pytest.raises(physim.Error, match="version"):
        physim.Scenario.from_text("[[shot]]\n")
    with pytest.raises(physim.Error):
        physim.Scenario.from_text("physim = 1\n[[shot]\n")


def test_text_and_file_round_trips(tmp_path, bullet):
    again = physim.Scenario.from_text(bullet.text())
    assert same_bits(again.fly().end.position, bullet.fly().end.position)
    bullet.save(tmp_path / "rifle.toml")
    assert physim.Shot(physim.Scenario.from_file(tmp_path / "rifle.toml")) == bullet


@pytest.mark.parametrize("file", sorted(SCENARIOS.glob("*.toml")), ids=lambda f: f.stem)
def test_every_scenario_flies_and_survives_pickling(file):
    scenario = physim.Scenario.from_file(file)
    again = pickle.loads(pickle.dumps(scenario))
    assert again.shots == scenario.shots
    if not scenario._setup.has_world:
        flight, copy = scenario.fly(), again.fly()
        assert same_bits(flight.end.position, copy.end.position) and flight.duration == copy.duration
        assert repr(flight) and "<table>" in flight._repr_html_()


def test_shots_and_flights_are_pickled_with_their_bits(bullet):
    assert pickle.loads(pickle.dumps(bullet)) == bullet
    flight = pickle.loads(pickle.dumps(bullet.fly()))
    assert same_bits(flight.end.position, bullet.fly().end.position)
    sample = pickle.loads(pickle.dumps(bullet.fly().end))
    assert sample == bullet.fly().end


def test_functions_of_place_and_time():
    calls = []

    def wind(time, position):
        calls.append(len(time))
        velocity = np.zeros_like(position)
        velocity[:, 2] = 5.0
        return velocity

    base = {**BULLET, "fidelity_rotation": "none"}
    with_function = physim.fly(**base, wind_field=wind)
    with_setting = physim.fly(**base, environment_wind_velocity=(0, 0, 5))
    assert calls and with_function.end.z == pytest.approx(with_setting.end.z, rel=1e-6)

    lift = physim.fly(speed=100, elevation=0.5, force_field=lambda t, x, v, m: np.outer(m, [0, 9.80665, 0]),
                      environment_gravity_model="constant", fidelity_drag="off", until_time=5)  # fmt: skip
    assert lift.end.y == pytest.approx(5 * 100 * math.sin(0.5), rel=1e-6)


def test_what_a_function_raises_comes_out():
    def broken(time, position):
        raise KeyError("no such cloud")

    with pytest.raises(KeyError, match="no such cloud"):
        physim.fly(**BULLET, wind_field=broken)
    with pytest.raises(ValueError, match="rows of three"):
        physim.fly(**BULLET, wind_field=lambda t, x: np.zeros(3))
    with pytest.raises(physim.Error, match="no function"):
        physim.fly(**BULLET, wind_field=3)


def test_other_threads_run_while_it_flies(bullet):
    """A flight of very many steps lets go of the interpreter."""
    long = bullet.replace(fidelity_integrator="rk4", tolerance_step=1e-5, until_time=10, until_range=None, speed=2000)
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted
    long.fly()
    after = counted
    done.set()
    thread.join()
    assert after - before > 10


def test_many_threads_fly_one_shot(bullet):
    expected = bullet.fly().end.position.tobytes()
    results = []

    def fly():
        results.extend(bullet.fly().end.position.tobytes() for _ in range(50))

    threads = [threading.Thread(target=fly) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(results) == {expected} and len(results) == 200


def test_notebook_tables_and_reprs(bullet):
    flight = bullet.fly()
    for each in (bullet, flight, flight.samples(5), flight.end, bullet.table([100, 200])):
        assert repr(each) and "<table>" in each._repr_html_()
    assert "..." in repr(flight.samples(50))


def test_columns(bullet):
    pandas = pytest.importorskip("pandas")
    samples = bullet.fly().samples(11)
    frame = samples.to_frame()
    assert isinstance(frame, pandas.DataFrame) and len(frame) == 11
    assert same_bits(frame["speed"].to_numpy(), samples.speed)
    assert samples[samples.speed > 500].size < 11 and samples[:3].size == 3 and samples[2]["time"] == samples.time[2]
    with pytest.raises(AttributeError, match="there are"):
        samples.velocity_of_light
    copy = pickle.loads(pickle.dumps(samples))
    assert same_bits(copy.x, samples.x)


def test_range_card_is_that_of_the_command_line(bullet):
    ranges = "100 m .. 1000 m step 100 m"
    out = run_program("table", "scenarios/308_168gr_g7.toml", "--ranges", ranges, "--format", "json", "--wind", "10 mph")
    card = json.loads(out)
    table = bullet.table(range(100, 1001, 100), winds=["10 mph"])
    text = json.dumps(card)
    assert list(table) == [key for key, _ in walk(card) if key in table] and any("10 mph" in name for name in table)
    for name in table:
        assert name in text
        expected = next(value for key, value in walk(card) if key == name)
        assert list(table[name]) == expected
    assert bullet.table(["100 yd"], units="customary").size == 1
    with pytest.raises(physim.Error, match="units"):
        bullet.table([100], units="imperial")


def test_angles_of_a_card_are_those_asked_for(bullet):
    """Yards with milliradians, as scopes have them: 1 MOA is a 10800th of pi."""
    own = bullet.table(["500 yd"], units="customary")
    mil = bullet.table(["500 yd"], units="customary", angle="mil")
    assert mil["drop [in]"] == own["drop [in]"]
    assert mil["drop [mil]"][0] == pytest.approx(own["drop [MOA]"][0] * np.pi / 10.8, rel=1e-12)
    assert bullet.table([500], angle="moa")["drop [MOA]"][0] == pytest.approx(
        bullet.table([500])["drop [mil]"][0] * 10.8 / np.pi, rel=1e-12)  # fmt: skip
    with pytest.raises(physim.Error, match='"mil", "moa"'):
        bullet.table([100], angle="degrees")


def walk(tree):
    if isinstance(tree, dict):
        for key, value in tree.items():
            yield key, value
            yield from walk(value)


def test_suvat_and_air(bullet):
    assert [round(each.t, 6) for each in physim.suvat(s=0, u=9.80665, a=-9.80665)] == [0, 2]
    assert bullet.air(0).density == pytest.approx(1.225, rel=1e-3)
    with pytest.raises(physim.Error):
        physim.suvat(s=1)
