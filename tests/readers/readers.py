"""Reads a flight's CSV by pandas: readers.py FLIGHT CORNERS NAME; exit code 1 if a corner of the path is not in it."""
import sys

import pandas

flight, corners, name = sys.argv[1:4]
is_old = int(pandas.__version__.split(".")[0]) < 3  # later ones read each number as it was written
table = pandas.read_csv(flight + ".csv", **({"float_precision": "round_trip"} if is_old else {}))
assert set(table["shot"]) == {name}, set(table["shot"])
assert table["t [s]"].is_monotonic_increasing
for line in open(corners):
    time, _, _, _, x, y, z = (float(word) for word in line.split())
    rows = table[table["t [s]"] == time]
    assert ((rows["x [m]"] == x) & (rows["y [m]"] == y) & (rows["z [m]"] == z)).any(), line
