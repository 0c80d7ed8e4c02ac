"""The rows: what is compared, what it must reach, what it reached."""
import sys
from dataclasses import dataclass


@dataclass
class Row:
    what: str
    reach: str      # ">= 2", "<= 1 %"
    reached: float
    detail: str = ''

    def held(self):
        bound = float(self.reach.split()[1])
        return self.reached >= bound if self.reach.startswith('>=') else self.reached <= bound


def header(out=sys.stdout):
    print('| what | reach | reached | | |\n| --- | --- | --- | --- | --- |', file=out, flush=True)


def show(row, out=sys.stdout):
    """One line; true when it is held."""
    unit = ' '.join(row.reach.split()[2:])
    reached = f'{row.reached:.3g}' if row.reached < 1000 else f'{row.reached:.0f}'
    print(f'| {row.what} | {row.reach} | {reached}{" " if unit else ""}{unit} | {"held" if row.held() else "**MISSED**"} | {row.detail} |',
          file=out, flush=True)
    return row.held()
