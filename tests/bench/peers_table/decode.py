"""`rigsound decode` on long recorded buses, of which a tenth is the rig's: speed, and memory against length."""
import os
import pathlib
import random
import struct
import subprocess

from .table import Row

ROOT = pathlib.Path(__file__).resolve().parents[3]
SPEED, GROWTH = '>= 150 MB/s', '<= 1.05 times'
SHORT, LONG = 400_000, 2_000_000   # frames
USED_EVERY, A_SECOND = 10, 8000
PRESSURES = 64                     # that come round


def write_log(path, frames):
    """Feed pressures of the example's DBC between frames that nobody reads."""
    draw = random.Random(3)
    others = [f'{draw.randrange(0x100, 0x700):03X}#{draw.getrandbits(64):016X}' for _ in range(997)]
    ours = [f'18FF1017#{struct.pack("<H", draw.randrange(6000, 9000)).hex().upper()}FFFFC00101FF' for _ in range(PRESSURES)]
    with open(path, 'w') as file:
        for first in range(0, frames, 10_000):
            file.writelines(
                f'({1 + n / A_SECOND:.6f}) can0 {ours[n // USED_EVERY % PRESSURES] if n % USED_EVERY == 0 else others[n % len(others)]}\n'
                for n in range(first, first + 10_000))


def decoded(rigsound, log):
    """Processor seconds, and the most memory in MB."""
    child = subprocess.Popen([rigsound, 'decode', ROOT / 'config/rigs/demo.toml', '--log', log], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f'rigsound decode ended with {child.returncode}')
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def rows(programs, folder, rounds, shown):
    best = {}
    for frames in (SHORT, LONG):
        log = folder / f'{frames}.log'
        write_log(log, frames)
        runs = [decoded(programs.rigsound, log) for _ in range(rounds)]
        best[frames] = min(s for s, _ in runs), min(m for _, m in runs), log.stat().st_size / 1e6
        log.unlink()
    (short_s, short_mb, _), (long_s, long_mb, megabytes) = best[SHORT], best[LONG]
    yield Row('decode of a recorded bus, a tenth of its frames used', SPEED, megabytes / long_s, f'{megabytes:.0f} MB in {long_s:.2f} s')
    yield Row(f'memory of decode, {LONG // SHORT} times as long a recording', GROWTH, long_mb / short_mb, f'{short_mb:.1f} MB, {long_mb:.1f} MB')
