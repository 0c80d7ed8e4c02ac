"""The paper's bar against the same model in Faust and on STK: what tool_bench prints of them."""
import subprocess

from .table import Row


def rows(programs, folder, rounds, shown):
    text = subprocess.run([programs.tool_bench, 'cost'], capture_output=True, text=True, check=True).stdout
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split('|')]
        if len(cells) == 5 and 'against' in cells[0]:
            yield Row(cells[0], ' '.join([*cells[1].split(), cells[3]]), float(cells[2]))
        elif line.startswith('SKIPPED'):
            print(line)
