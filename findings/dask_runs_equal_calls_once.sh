#!/usr/bin/env bash
# dask.distributed 2026.8.0 runs calls with equal arguments once, and gives the one result to all of them: a Monte Carlo
# study that maps a function over equal rows gets fewer draws than it asks for, with no warning. Client.map(), submit()
# and the executor of Client.get_executor() do it, the last although concurrent.futures promises one run for each call.
# `pure=False`, or the number of the shard among the arguments, gives each call a run of its own.
# Seen: 8 equal calls: 1 run by map(), 1 by submit(), 1 by the executor; 8 runs with pure=False.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q dask==2026.8.0 distributed==2026.8.0
cat >"$folder/seen.py" <<'PYTHON'
import os
import sys

import distributed


def draw(mean):
    return os.urandom(8).hex()


if __name__ == "__main__":
    cluster = distributed.LocalCluster(n_workers=1, threads_per_worker=1, host="127.0.0.1", dashboard_address=None)
    with cluster, distributed.Client(cluster) as client:
        runs = lambda futures: len({future.result() for future in futures})
        executor = client.get_executor()
        seen = {
            "map": runs(client.map(draw, [800.0] * 8)),
            "submit": runs([client.submit(draw, 801.0) for _ in range(8)]),
            "executor": runs([executor.submit(draw, 802.0) for _ in range(8)]),
            "map, pure=False": runs(client.map(draw, [803.0] * 8, pure=False)),
        }
    print("distributed", distributed.__version__, "distinct results of 8 equal calls:", seen)
    sys.exit(seen != {"map": 1, "submit": 1, "executor": 1, "map, pure=False": 8})
PYTHON
"$folder/env/bin/python" "$folder/seen.py"
