#!/usr/bin/env python3
"""udp_test.py RIGSOUND RIGSOUNDD SENDER ROOT: a rig that is driven by datagrams, from the bundled examples to a log and back.

SENDER is examples/udp_sender.cpp, built.
"""
import csv
import io
import json
import socket
import subprocess
import sys
import time
import unittest

from daemon_case import PATIENCE_S, DaemonCase, free_port, wait_for

RIGSOUND = sys.argv[1]
SENDER, ROOT = sys.argv[3:5]


def run(*words):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=PATIENCE_S)


class Case(DaemonCase):
    def setUp(self):
        super().setUp()
        self.port = free_port(socket.SOCK_DGRAM)
        self.rig.write_text(f'[audio]\ndevice = "null"\n[sound]\nset = "set"\n[control]\nsocket = "{self.socket}"\n'
                            f'[[udp]]\naddress = "127.0.0.1:{self.port}"\n')

    def status(self):
        return json.loads(self.ctl('status', '--json').stdout)

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
        self.start_daemon()

        def signal(name):
            return next(s for s in self.status()['signals'] if s['name'] == name)

        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as mouth:
            def heard():
                mouth.sendto(b'{"feed_pressure_bar": 90, "rattling": "open"}', ('127.0.0.1', self.port))
                feed, rattling = signal('feed_pressure_bar'), signal('rattling')
                # The value is the one that the last block was told: it comes a block after the validity.
                return (feed['validity'], feed['value'], rattling['value']) == ('valid', 90, 2)
            wait_for('value', heard)
            wait_for('stale feed', lambda: signal('feed_pressure_bar')['validity'] == 'stale')
        bus = next(b for b in self.status()['buses'] if b['name'] == f'udp 127.0.0.1:{self.port}')
        self.assertTrue(bus['up'])


class Reload(Case):
    def test_a_bus_of_which_nothing_changed_goes_on(self):
        port = free_port()
        modbus = f'[[modbus]]\naddress = "127.0.0.1:{port}"\n[modbus.signals]\nrock = {{ address = 0 }}\n'
        self.rig.write_text(self.rig.read_text() + modbus)
        self.start_daemon()
        wait_for('bus', lambda: all(bus['up'] for bus in self.status()['buses']))
        with socket.create_connection(('127.0.0.1', port), timeout=PATIENCE_S) as master:
            def write(value):
                try:
                    master.sendall(bytes((0, 1, 0, 0, 0, 6, 1, 6, 0, 0, 0, value)))
                    return master.recv(12)[-1:]
                except ConnectionError:
                    return b''
            self.assertEqual(write(1), b'\1')
            self.rig.write_text(self.rig.read_text().replace(str(self.port), str(free_port(socket.SOCK_DGRAM))))
            self.assertEqual(self.ctl('reload').returncode, 0)
            self.assertEqual(write(2), b'\2')  # the same connection
            self.rig.write_text(self.rig.read_text().replace('address = 0', 'address = 1'))
            self.assertEqual(self.ctl('reload').returncode, 0)
            self.assertEqual(write(3), b'')  # now the bus is another


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
