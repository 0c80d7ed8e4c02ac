"""Instructions of the dearest block of a shift with every transition, against the mean of the busiest state."""
import pathlib
import re
import subprocess

from .table import Row

CHECK = pathlib.Path(__file__).resolve().parents[2] / 'structure/check_block_cost'
WORST = '<= 1.3 times'


def rows(programs, folder, rounds, shown):
    said = subprocess.run([CHECK, programs.block_cost], capture_output=True, text=True)
    cost = {name: int(count) for name, count in re.findall(r'^(\w+): (\d+) instructions', said.stdout, re.M)}
    if 'worst' not in cost:
        raise SystemExit(f'{CHECK.name}: {said.stdout}{said.stderr}')
    yield Row('dearest block of every transition, over the mean of the busiest state', WORST, cost['worst'] / cost['busiest'],
              f'{cost["worst"]} / {cost["busiest"]} instructions')
