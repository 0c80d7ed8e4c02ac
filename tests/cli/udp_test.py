#!/usr/bin/env python3
"""udp_test.py RIGSOUND RIGSOUNDD SENDER ROOT: a rig that is driven by datagrams, from the bundled examples to a log and back.

SENDER is examples/udp_sender.cpp, built.
"""
import csv
import io
import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from sound_set import write_sound_set

RIGSOUND, RIGSOUNDD, SENDER, ROOT = sys.argv[1:5]
PATIENCE_S = 120


def run(*words):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=PATIENCE_S)


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


def wait_for(ready):
    end = time.monotonic() + PATIENCE_S
    while not (value := ready()):
        assert time.monotonic() < end, 'waited in vain'
        time.sleep(0.02)
    return value


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_udp.'))
        self.addCleanup(shutil.rmtree, self.folder)
        self.port = free_port()
        write_sound_set(self.folder / 'set')
        self.rig = self.folder / 'rig.toml'
        self.rig.write_text(f'[audio]\ndevice = "null"\n[sound]\nset = "{self.folder}/set"\n[control]\nsocket = "{self.folder}/s"\n'
                            f'[[udp]]\naddress = "127.0.0.1:{self.port}"\n')

    def values(self, log, *words):
        result = run('decode', self.rig, '--log', log, *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = csv.DictReader(io.StringIO(result.stdout))
        return {(r['signal'], r['value']) for r in rows}, result.stderr


class Examples(Case):
    def test_what_they_send_is_recorded_decoded_and_sent_again(self):
        for sender in ([SENDER], [sys.executable, f'{ROOT}/config/examples/udp_sender.py']):
            with self.subTest(sender):
                log = self.folder / 'u.pcap'
                recorder = subprocess.Popen([RIGSOUND, 'record', self.rig, '--out', log], stderr=subprocess.PIPE, text=True)
                self.assertIn('recording', recorder.stderr.readline())
                subprocess.run([*sender, '127.0.0.1', str(self.port), '0.5'], check=True, timeout=PATIENCE_S)
                recorder.terminate()
                recorder.communicate(timeout=PATIENCE_S)
                values, notes = self.values(log)
                self.assertLessEqual({('feed_pressure_bar', '90'), ('percussion', 'on'), ('rattling', 'none'), ('rod_count', '2')}, values)
                self.assertNotIn('refused', notes)
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ear:
                    ear.bind(('127.0.0.1', 0))
                    ear.settimeout(PATIENCE_S)
                    told = run('replay', log, '--udp', f'127.0.0.1:{ear.getsockname()[1]}', '--speed', 10, '--json')
                    self.assertEqual(told.returncode, 0, told.stderr)
                    self.assertGreater(json.loads(told.stdout)['sent'], 1)
                    self.assertEqual(json.loads(ear.recv(9000))['feed_pressure_bar'], 90)

    def test_a_log_of_another_port_is_of_use_and_one_of_nothing_is_not(self):
        log = self.folder / 'u.pcap'
        recorder = subprocess.Popen([RIGSOUND, 'record', self.rig, '--out', log], stderr=subprocess.PIPE, text=True)
        self.assertIn('recording', recorder.stderr.readline())
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as mouth:
            for text in ('{"engine_rpm": 900}', '{"engine_rmp": 1000}', 'x', '{"engine_rpm": 1000}'):
                mouth.sendto(text.encode(), ('127.0.0.1', self.port))
        time.sleep(0.5)
        recorder.terminate()
        recorder.communicate(timeout=PATIENCE_S)
        self.rig.write_text(self.rig.read_text().replace(str(self.port), '9'))
        values, notes = self.values(log)
        self.assertEqual(values, {('engine_rpm', '900'), ('engine_rpm', '1000')})
        self.assertIn("1 names are no signal of the rig, the first is 'engine_rmp'", notes)
        self.rig.write_text(self.rig.read_text() + 'signals = ["rock"]\n')
        result = run('decode', self.rig, '--log', log)
        self.assertEqual((result.returncode, result.stdout), (1, ''))
        self.assertIn("'engine_rpm' is no signal of the rig", result.stderr)


class Live(Case):
    def test_the_daemon_hears_it(self):
        daemon = subprocess.Popen([RIGSOUNDD, self.rig], stderr=subprocess.DEVNULL)
        self.addCleanup(daemon.wait)
        self.addCleanup(daemon.kill)
        wait_for((self.folder / 's').exists)

        def status():
            with socket.socket(socket.AF_UNIX) as client:
                client.connect(str(self.folder / 's'))
                client.sendall(b'{"command":"status"}\n')
                with client.makefile() as answer:
                    return json.loads(answer.readline())

        def signal(name):
            return next(s for s in status()['signals'] if s['name'] == name)

        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as mouth:
            def heard():
                mouth.sendto(b'{"feed_pressure_bar": 90, "rattling": "open"}', ('127.0.0.1', self.port))
                feed, rattling = signal('feed_pressure_bar'), signal('rattling')
                # The value is the one that the last block was told: it comes a block after the validity.
                return (feed['validity'], feed['value'], rattling['value']) == ('valid', 90, 2)
            wait_for(heard)
            wait_for(lambda: signal('feed_pressure_bar')['validity'] == 'stale')
        bus = next(b for b in status()['buses'] if b['name'] == f'udp 127.0.0.1:{self.port}')
        self.assertTrue(bus['up'])


class Reload(Case):
    def test_a_bus_of_which_nothing_changed_goes_on(self):
        with socket.create_server(('127.0.0.1', 0)) as probe:
            port = probe.getsockname()[1]
        modbus = f'[[modbus]]\naddress = "127.0.0.1:{port}"\n[modbus.signals]\nrock = {{ address = 0 }}\n'
        self.rig.write_text(self.rig.read_text() + modbus)
        daemon = subprocess.Popen([RIGSOUNDD, self.rig], stderr=subprocess.PIPE, text=True)
        self.addCleanup(daemon.stderr.close)
        self.addCleanup(daemon.wait)
        self.addCleanup(daemon.kill)
        wait_for((self.folder / 's').exists)

        def ask(command):
            with socket.socket(socket.AF_UNIX) as client:
                client.connect(str(self.folder / 's'))
                client.sendall(json.dumps({'command': command}).encode() + b'\n')
                with client.makefile() as answer:
                    return json.loads(answer.readline())

        wait_for(lambda: all(bus['up'] for bus in ask('status')['buses']))
        with socket.create_connection(('127.0.0.1', port), timeout=PATIENCE_S) as master:
            def write(value):
                try:
                    master.sendall(bytes((0, 1, 0, 0, 0, 6, 1, 6, 0, 0, 0, value)))
                    return master.recv(12)[-1:]
                except ConnectionError:
                    return b''
            self.assertEqual(write(1), b'\1')
            self.rig.write_text(self.rig.read_text().replace(str(self.port), str(free_port())))
            self.assertTrue(ask('reload')['ok'])
            self.assertEqual(write(2), b'\2')  # the same connection
            self.rig.write_text(self.rig.read_text().replace('address = 0', 'address = 1'))
            self.assertTrue(ask('reload')['ok'])
            self.assertEqual(write(3), b'')  # now the bus is another


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
