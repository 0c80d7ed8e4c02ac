"""Ten minutes at every period instead of half a minute. Runs only when it is named: takes an hour of host time."""
import subprocess
import unittest

from place import PLACE
from rigs import write_rig
from running import Daemon
from sound import PLAYBACK, PeriodClock

SECONDS = 600


def endless_log():
    """The bundled log again and again, SECONDS long."""
    path = '/tmp/soak.log'
    with open(PLACE.log) as whole:
        entries = [line.split(' ', 1) for line in whole]
    times = [float(time[1:-1]) for time, _ in entries]
    turn = times[-1] - times[0] + 0.01
    with open(path, 'w') as out:
        for turns in range(int(SECONDS / turn) + 1):
            out.writelines(f'({t + turns * turn:.6f}) {frame}' for t, (_, frame) in zip(times, entries))
    return path


class Soak(unittest.TestCase):
    def check_no_xrun(self, block):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, device=PLAYBACK, block=block, form='float',
                        can=['vcan0'])
        log = endless_log()
        with PeriodClock(PLACE.period_clock, block), Daemon(PLACE.rigsoundd, rig) as daemon:
            daemon.wait_playing()
            subprocess.run(['canplayer', '-I', log, 'vcan0=can0'], check=True)
            audio = daemon.status()['audio']
        print(f'FIGURE soak at {block}: {audio["xruns"]} xruns and {audio["deadline_misses"]} deadline misses in '
              f'{audio["blocks"] * block / 48000:.0f} s', flush=True)
        self.assertEqual((audio['xruns'], audio['losses'], audio['deadline_misses']), (0, 0, 0))

    def test_64(self):
        self.check_no_xrun(64)

    def test_128(self):
        self.check_no_xrun(128)

    def test_256(self):
        self.check_no_xrun(256)
