"""engine.wasm in node: its share of a core while everything sounds."""
import json
import pathlib
import subprocess

from .table import Row

SCRIPT = pathlib.Path(__file__).parent / 'wasm_share.mjs'
SHARE = '<= 1 %'


def rows(programs, folder, rounds, shown):
    played, changes = folder / 'golden.rigset', folder / 'golden.csv'
    subprocess.run([programs.golden_set, played, changes], check=True)
    said = [json.loads(subprocess.run(['node', SCRIPT, programs.wasm, played, changes], capture_output=True, text=True, check=True).stdout)
            for _ in range(rounds)]
    best = min(said, key=lambda s: s['share'])
    yield Row('engine.wasm in node, two booms, a minute of everything', SHARE, 100 * best['share'], f'{best["us"]:.1f} us a block of 64')
