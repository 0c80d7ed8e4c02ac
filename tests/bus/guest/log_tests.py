"""record and replay: what was on a bus comes back as it was."""
import json
import os
import signal
import subprocess
import unittest

from place import PLACE
from rigs import write_rig
from running import Daemon, wait_for
from modbus_tests import SERVER, mbpoll


def frames_of(log):
    """Time and frame of every line, without the interface."""
    with open(log) as lines:
        parts = [line.split() for line in lines]
    return [(float(p[0][1:-1]), p[2]) for p in parts]


class Recorder:
    def __init__(self, rig, out):
        self.process = subprocess.Popen([PLACE.rigsound, 'record', rig, '--out', out], stderr=subprocess.PIPE, text=True)
        self.said = self.process.stderr.readline()

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        self.said += self.process.communicate()[1]
        return self.process.returncode


def replay(*words):
    told = subprocess.run([PLACE.rigsound, 'replay', *words, '--json'], check=True, capture_output=True, text=True).stdout
    return json.loads(told)


class Can(unittest.TestCase):
    def test_a_log_replayed_and_recorded_is_the_log(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, can=['vcan0'])
        with open(PLACE.log) as log, open('/tmp/first.log', 'w') as part:
            part.writelines(line for _, line in zip(range(1000), log))
        recorder = Recorder(rig, '/tmp/again.log')
        self.assertIn('recording', recorder.said)
        figures = replay('/tmp/first.log', '--can', 'vcan0')
        self.assertEqual(recorder.stop(), 0)
        sent, got = frames_of('/tmp/first.log'), frames_of('/tmp/again.log')
        self.assertEqual([frame for _, frame in got], [frame for _, frame in sent])
        self.assertEqual(figures['sent'], len(sent))
        drift = [(got[i][0] - got[0][0]) - (sent[i][0] - sent[0][0]) for i in range(len(sent))]
        print(f'FIGURE replay: {figures["sent"]} frames, late by {figures["late_mean_ms"]:.3f} ms in the mean, '
              f'{figures["late_worst_ms"]:.3f} ms at worst; recorded times off by {1e3 * max(map(abs, drift)):.3f} ms '
              'at worst', flush=True)
        fast = replay('/tmp/first.log', '--can', 'vcan0', '--speed', '10')
        self.assertEqual(fast['sent'], len(sent))

    def test_an_interface_that_is_not_there(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, can=['vcan7'])
        for words in (['record', rig, '--out', '/tmp/none.log'], ['replay', PLACE.log, '--can', 'vcan7']):
            ended = subprocess.run([PLACE.rigsound, *words], capture_output=True, text=True)
            self.assertEqual((ended.returncode, ended.stderr.count('\n')), (3, 1))
            self.assertIn('vcan7 does not exist' if words[0] == 'record' else 'vcan7: does not exist', ended.stderr)
        self.assertFalse(os.path.exists('/tmp/none.log'))


class Modbus(unittest.TestCase):
    def test_what_a_simulator_wrote_is_written_again(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=[SERVER])
        recorder = Recorder(rig, '/tmp/written.pcap')
        self.assertIn('recording', recorder.said)
        for rods in (3, 5, 7):
            self.assertEqual(mbpoll('-m', 'tcp', '-p', 1502, '-0', '-t', '4', '-r', 8, '127.0.0.1', rods).returncode, 0)
        self.assertEqual(mbpoll('-m', 'tcp', '-p', 1502, '-0', '-t', '0', '-r', 0, '127.0.0.1', 1).returncode, 0)
        self.assertEqual(recorder.stop(), 0)
        decoded = subprocess.run([PLACE.rigsound, 'decode', rig, '--log', '/tmp/written.pcap'], check=True,
                                 capture_output=True, text=True).stdout.splitlines()
        rows = [line.split(',', 1)[1] for line in decoded[1:]]
        told = [row for row in rows if row.split(',')[0] not in ('situation', 'feed_deviation')]
        self.assertEqual(told,
                         ['rod_count,3', 'rod_count,5', 'rod_count,7', 'percussion,on'])
        with Daemon(PLACE.rigsoundd, rig) as daemon:
            wait_for('the server', lambda: daemon.bus('modbus 127.0.0.1:1502')['up'])
            figures = replay('/tmp/written.pcap', '--modbus', '127.0.0.1:1502')
            self.assertEqual((figures['sent'], figures['refused']), (4, 0))
            daemon.wait_signal('rod_count', 7)
            daemon.wait_signal('percussion', 1)
