"""Floods, losses and returns of a CAN interface."""
import subprocess
import unittest

from frames import CABIN1, DRILL1, EEC1, ERR, Bus, drill, engine_speed, master_gain
from place import PLACE
from rigs import write_rig
from running import Daemon, wait_for
from sound import PLAYBACK, PeriodClock


def ip(*words):
    subprocess.run(['ip', 'link', *words], check=True)


class Witness:
    """A candump of everything on vcan1, until the bus has been quiet for a second."""

    def __init__(self):
        with open('/tmp/flood.log', 'w') as log:
            self.process = subprocess.Popen(['candump', '-L', '-T', '1000', '-r', '67108864', 'vcan1,0:0,#FFFFFFFF'],
                                            stdout=log)
        wait_for('candump', lambda: ' raw' in open('/proc/net/can/rcvlist_all').read())

    def frames(self):
        """(data frames of the rig's three messages, whatever their source; error frames)"""
        self.process.wait()
        ours = errors = 0
        with open('/tmp/flood.log') as log:
            for line in log:
                identifier, data = line.split()[2].split('#', 1)
                number = int(identifier, 16)
                errors += len(identifier) == 8 and number & ERR != 0
                ours += (len(identifier) == 8 and number & ERR == 0 and not data.startswith('R')
                         and number >> 8 & 0x3FFFF in (0xF004, 0xFF10, 0xFF11))
        return ours, errors


class Flood(unittest.TestCase):
    def setUp(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, device=PLAYBACK, can=['vcan1'], fd=True,
                        form='float', safety='stale_after_ms = 0')
        self.clock = PeriodClock(PLACE.period_clock, 64)
        self.daemon = Daemon(PLACE.rigsoundd, rig)
        self.bus = Bus('vcan1')
        self.daemon.wait_playing()
        wait_for('vcan1', lambda: self.daemon.bus('can vcan1')['up'])

    def tearDown(self):
        self.daemon.__exit__()
        self.clock.__exit__()
        self.bus.close()

    def check_unharmed(self):
        """No deadline lost, and the next word counts."""
        self.bus.send(EEC1, engine_speed(1234))
        self.bus.send(DRILL1, drill(87.5, rattling=1))
        self.bus.send(CABIN1, master_gain(-12))
        self.daemon.wait_signal('engine_rpm', 1234)
        self.daemon.wait_signal('feed_pressure_bar', 87.5)
        self.daemon.wait_signal('rattling', 1)
        self.daemon.wait_signal('master_gain_db', -12)
        audio = self.daemon.status()['audio']
        self.assertEqual((audio['xruns'], audio['losses'], audio['deadline_misses']), (0, 0, 0))

    def test_counters_are_exact(self):
        frames, per_round = 2000, 5
        for i in range(frames):
            self.bus.send(EEC1, engine_speed(i % 3000))
            self.bus.send_fd(DRILL1, drill(i % 250) + bytes(24))   # FD and longer than its message
            self.bus.send(0x123, b'\1\2', flags=0)                 # not ours: the kernel keeps it away
            self.bus.send(EEC1, b'', flags=0x80000000)             # ours, and too short for its signal
            self.bus.send(0x40, bytes(8), flags=ERR)               # an error frame: bus-off
        def seen():
            b = self.daemon.bus('can vcan1')
            return b['frames_seen'] + b['frames_bad'] + b['frames_dropped'] == frames * (per_round - 1)
        wait_for('every frame to be counted', seen)
        bus = self.daemon.bus('can vcan1')
        self.assertEqual((bus['frames_seen'], bus['frames_bad'], bus['frames_dropped']), (3 * frames, frames, 0))
        self.assertIn('bus-off', bus['problem'])
        self.assertFalse(bus['up'])
        self.bus.send(0x100, bytes(8), flags=ERR)                  # the controller has restarted
        wait_for('the bus after its restart', lambda: self.daemon.bus('can vcan1')['up'])
        self.check_unharmed()

    def test_anything_at_full_rate(self):
        """Many senders at once; a candump beside the daemon says what there was to count."""
        witness = Witness()
        anything = [['-I', 'r', *kind] for kind in ([], ['-e'], ['-f'], ['-b'], ['-e', '-m'], ['-E'], ['-R'])]
        known = [['-e', *kind, '-I', identifier] for identifier in ('18FF10FE', '0CF004FE', '18FF11FE')
                 for kind in ([], ['-f'])]
        flood = [subprocess.Popen(['cangen', 'vcan1', '-g', '0', '-i', '-n', '2000', '-L', 'r', '-D', 'r', *kind])
                 for kind in anything + known]
        for _ in range(500):
            self.bus.send(0x4, bytes(8), flags=ERR)  # the controller's, no bus-off
        self.assertEqual([sender.wait() for sender in flood], [0] * len(flood))
        ours, errors = witness.frames()
        wait_for('every frame to be counted', lambda: sum(self.counted()) >= ours + errors)
        seen, bad, dropped = self.counted()
        print(f'FIGURE flood: of {2000 * len(flood)} frames {ours} were ours, {errors} error frames; {seen} seen, '
              f'{bad} error frames, {dropped} dropped by the kernel', flush=True)
        self.assertEqual((seen, bad, dropped), (ours, errors, 0))
        self.assertEqual(errors, 500)
        self.assertGreater(ours, 2000)
        self.check_unharmed()

    def counted(self):
        bus = self.daemon.bus('can vcan1')
        return bus['frames_seen'], bus['frames_bad'], bus['frames_dropped']


class Loss(unittest.TestCase):
    def setUp(self):
        ip('add', 'vcan2', 'type', 'vcan')
        ip('set', 'vcan2', 'up')

    def tearDown(self):
        subprocess.run(['ip', 'link', 'del', 'vcan2'], check=False, stderr=subprocess.DEVNULL)

    def check_loss_and_return(self, lose, regain):
        """The sound fades by the safety rule (mute) while the bus is away, and comes back by itself."""
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, can=['vcan2'],
                        safety='fade_ms = 100\nengine_rpm = { action = "mute", stale_after_ms = 0 }')
        with Daemon(PLACE.rigsoundd, rig) as daemon:
            wait_for('vcan2', lambda: daemon.bus('can vcan2')['up'])
            self.talk(daemon)
            lose()
            daemon.wait_signal('engine_rpm', validity='bus_down')
            wait_for('silence', lambda: daemon.status()['meters']['output_gain'] == 0)
            wait_for('silence', lambda: daemon.status()['meters']['peak_db'] <= -199)
            self.assertFalse(daemon.bus('can vcan2')['up'])
            regain()
            wait_for('vcan2 again', lambda: daemon.bus('can vcan2')['up'])
            self.talk(daemon)
            self.assertEqual(daemon.bus('can vcan2')['losses'], 1)

    def talk(self, daemon):
        bus = Bus('vcan2')
        bus.send(EEC1, engine_speed(1500))
        daemon.wait_signal('engine_rpm', 1500)
        wait_for('sound', lambda: daemon.status()['meters']['output_gain'] == 1)
        wait_for('sound', lambda: daemon.status()['meters']['peak_db'] > -80)
        bus.close()

    def test_down_and_up(self):
        self.check_loss_and_return(lambda: ip('set', 'vcan2', 'down'), lambda: ip('set', 'vcan2', 'up'))

    def test_deleted_and_made_again(self):
        def make():
            ip('add', 'vcan2', 'type', 'vcan')
            ip('set', 'vcan2', 'up')
        self.check_loss_and_return(lambda: ip('del', 'vcan2'), make)
