"""The acceptance table: a row names a figure, how it is computed from the clips, and what it must reach."""
from dataclasses import dataclass
from typing import Callable, Sequence

import numpy as np


@dataclass
class Row:
    name: str
    prototype: str
    must: Sequence[float]
    goal: Sequence[float]
    reached: Callable
    better: str = 'lower'
    digits: int = 2


def mean(key):
    return lambda clips: float(np.nanmean([c.get(key, np.nan) for c in clips]))


def median(keys):
    return lambda clips: float(np.nanmedian([c.get(k, np.nan) for c in clips for k in keys]))


def each(function, keys):
    return lambda clips: [function(k)(clips) for k in keys]


def all_snrs(clips):
    return [float(np.mean([c['si_sdri@%d' % s] for c in clips for s in (-6, 0, 6, 12)]))]


def at_worst(key):
    return lambda clips: [min(c[key] for c in clips)]


def rule(clips):
    return [sum(c['false_alarm'] for c in clips), sum(c['found@0'] == 0 for c in clips), sum(c['found@-6'] == 0 for c in clips)]


NOISY = ('clean', '12', '6', '0')

DETECTION = [
    Row('SI-SDRi -6/0/+6/+12, dB', '7.39/5.99/4.30/2.78', (6.9, 5.7, 4.0, 2.5), (7.6, 6.1, 4.5, 3.0),
        each(mean, ['si_sdri@%d' % s for s in (-6, 0, 6, 12)]), 'higher'),
    Row('mean of the four', '5.11', (4.9,), (5.4,), all_snrs, 'higher'),
    Row('worst clip at 0 dB', '2.16', (1.5,), (2.5,), at_worst('si_sdri@0'), 'higher'),
    Row('F2c clean/+12/+6/0/-6', '.994/.996/.989/.988/.905', (.99, .99, .98, .98, .89), (.995, .995, .993, .99, .93),
        each(mean, ['F2c@%s' % s for s in ('clean', 12, 6, 0, -6)]), 'higher', 3),
    Row('raw F2 clean/0 dB', '.994/.987', (.98, .97), (.99, .985), each(mean, ('F2@clean', 'F2@0')), 'higher', 3),
    Row('timing clean/0 dB, us', '34/93', (45, 110), (35, 85), each(mean, ('timing_us@clean', 'timing_us@0')), digits=0),
    Row('amplitude clean/0/-6, dB', '.37/.60/.87', (.45, .70, 1.0), (.35, .55, .8),
        each(lambda k: median([k]), ['amplitude_db@%s' % s for s in ('clean', 0, -6)])),
    Row('alpha_d error >=0 dB/-6 *', '1.4-3.8 %/18 %', (.06, .22), (.03, .15),
        lambda clips: [median(['alpha_d@' + s for s in NOISY])(clips), median(['alpha_d@-6'])(clips)], digits=3),
    Row('N_a factor, >=0 dB *', '1.17-1.33', (1.45,), (1.2,), lambda clips: [median(['N_a@' + s for s in NOISY])(clips)]),
    Row('no click: false/missed 0/-6', '0/0/1', (0, 0, 2), (0, 0, 1), rule, digits=0),
    Row('CPU of a 2 s clip, s', '0.77-0.93', (.4,), (.15,), lambda clips: [mean('cpu_s@0')(clips)]),
]

KERNELS = [
    Row('CPU of the paper NMF, s', '2.56', (2.0,), (1.4,), lambda runs: [runs[0]['paper_nmf_s']]),
]

SYNTHESIS = [
    Row('LTAS/mod/level, clean, dB', '.35/1.99/.31', (.45, 2.2, .45), (.35, 1.95, .3), each(mean, ('ltas@1', 'mod@1', 'level@1'))),
    Row('crest dB, gap W1 %', '.80/1.14', (1.0, 1.4), (.7, 1.1), each(mean, ('crest@1', 'gap@1'))),
    Row('F0 x0.7: LTAS/level, dB', '.35/.28', (.55, .4), (.4, .3), each(mean, ('ltas@0.7', 'level@0.7'))),
    Row('F0 x1.4: LTAS/level, dB', '.43/.24', (.55, .4), (.4, .3), each(mean, ('ltas@1.4', 'level@1.4'))),
    Row('LTAS from 6/0 dB (audible), dB', '.81/.99', (.95, 1.15), (.75, .95), each(mean, ('ltas@6dB', 'ltas@0dB'))),
]


def verdict(row, values):
    """`goal`, `must` or `MISSED`, by the worst of the row's figures."""
    def reached(bounds):
        return all(v >= b - 1e-9 if row.better == 'higher' else v <= b + 1e-9 for v, b in zip(values, bounds))
    return 'goal' if reached(row.goal) else 'must' if reached(row.must) else 'MISSED'


def show(row, clips):
    """One line of the table; true when the must column is reached."""
    values = list(row.reached(clips))
    text = lambda numbers: '/'.join('%.*f' % (row.digits, v) for v in numbers)
    plain = lambda numbers: '/'.join('%g' % v for v in numbers)
    result = verdict(row, values)
    print('%-31s %-26s %-24s %-26s %-32s %s' % (row.name, row.prototype, plain(row.must), plain(row.goal), text(values), result),
          flush=True)
    return result != 'MISSED'


def footer(kernels):
    print('* of the regular noise-like clips, whose frequencies all decay alike')
    print('paper NMF at the rate of a 2048^3 matrix product in this run (%.1f GFLOP/s): %.2f s' % (kernels['sgemm_gflops'], kernels['at_peak_s']))


def header():
    print('%-31s %-26s %-24s %-26s %-32s' % ('', 'prototype', 'must', 'goal', 'reached'))
