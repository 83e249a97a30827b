#!/usr/bin/env python3
"""Extreme values for every number among the settings of scenarios, through the command line.

    tools/fuzz_settings.py PROGRAM [COUNT [SEED]] [--patience SECONDS]

Each run of `PROGRAM run FILE --set PATH=VALUE` ends with exit code 0, 1 or 2, within its patience of processor time,
and says why if it is not 0. What ends otherwise is printed as a command.
"""
import argparse
import json
import pathlib
import random
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
NUMBER = re.compile(r'^(-?[0-9][0-9.e+-]*|inf)( .+)?$')
EXPONENTS = [-324, -300, -160, -40, -15, -9, -6, 0, 6, 9, 15, 40, 160, 300, 308]
WHOLE = [0, 1, 2, 255, 65536, 2**31 - 1, 2**31, 2**32 - 1, 2**53, 2**63 - 1]


def extreme(text, rng):
    """A value of the same unit far from the given one; None if the text holds no number."""
    match = NUMBER.match(text)
    if not match:
        return None
    number, unit = match[1], match[2] or ''
    if not unit and '.' not in number and 'e' not in number and rng.random() < 0.5:
        return str(rng.choice(WHOLE))
    if rng.random() < 0.1:
        return rng.choice(['0', '-0', '-1', 'inf', '1.7976931348623157e308']) + unit
    return f'{rng.choice(["", "", "", "-"])}{rng.uniform(1, 9.9):.3g}e{rng.choice(EXPONENTS)}{unit}'


def changed(value, rng):
    """A setting with one of its numbers replaced."""
    if not value.startswith('['):
        return extreme(value, rng)
    places = [match for match in re.finditer(r'"([^"]*)"', value) if NUMBER.match(match[1])]
    if not places:
        return None
    place = rng.choice(places)
    return value[:place.start(1)] + extreme(place[1], rng) + value[place.end(1):]


def run(command, patience):
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (patience, patience + 1))
    return subprocess.run(command, capture_output=True, text=True, errors='replace', preexec_fn=limit, cwd=ROOT)


def settings_of(program, scenario, patience):
    """Paths and values of all settings that hold a number."""
    done = run([program, 'run', scenario, '--json', '-'], patience)
    if not done.stdout:
        return []
    values = json.loads(done.stdout)['settings']
    return [(path, value) for path, value in values.items() if changed(value, random.Random(0)) is not None]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('program')
    parser.add_argument('count', nargs='?', type=int, default=10000)
    parser.add_argument('seed', nargs='?', type=int, default=1)
    parser.add_argument('--patience', type=int, default=20, help='processor time for a run [s]')
    asked = parser.parse_args()
    rng = random.Random(asked.seed)
    scenarios = sorted(str(path.relative_to(ROOT)) for path in (ROOT / 'scenarios').glob('*.toml'))
    known = {}
    wrong = 0
    for _ in range(asked.count):
        scenario = rng.choice(scenarios)
        if scenario not in known:
            known[scenario] = settings_of(asked.program, scenario, 120)
        if not known[scenario]:
            continue
        command = [asked.program, 'run', scenario, '--json', '/dev/null']
        for _ in range(rng.choice([1, 1, 1, 2])):
            path, value = rng.choice(known[scenario])
            command += ['--set', f'{path}={changed(value, rng)}']
        done = run(command, asked.patience)
        silent = done.returncode == 2 and not done.stderr.strip()
        if done.returncode in (0, 1, 2) and not silent:
            continue
        wrong += 1
        reason = done.stderr.strip().splitlines()[-1:] or ['says nothing']
        print(f'exit {done.returncode}: {reason[0][-200:]}\n    {subprocess.list2cmdline(command)}', flush=True)
    print(f'{asked.count} runs, {wrong} wrong')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
