#!/usr/bin/env python3
"""osc_test.py RIGSOUND RIGSOUNDD: a daemon that a tablet plays and watches, over datagrams written by hand from the OSC 1.0 text."""
import json
import socket
import struct
import subprocess
import sys
import unittest

from daemon_case import PATIENCE_S, DaemonCase, free_port

RIGSOUND = sys.argv[1]


def padded(text):
    return text.encode() + b'\0' * (4 - len(text.encode()) % 4)


def message(path, value):
    if isinstance(value, bool):
        kind, argument = 'T' if value else 'F', b''
    elif isinstance(value, str):
        kind, argument = 's', padded(value)
    else:
        kind, argument = 'f', struct.pack('>f', value)
    return padded(path) + padded(',' + kind) + argument


def values_of(packet):
    """{path: value} of a bundle of messages with one argument each."""
    assert packet[:16] == b'#bundle\0' + struct.pack('>Q', 1), packet[:16]
    packet, values = packet[16:], {}
    while packet:
        size, = struct.unpack('>I', packet[:4])
        element, packet = packet[4:4 + size], packet[4 + size:]
        path = element[:element.index(b'\0')].decode()
        rest = element[len(path) // 4 * 4 + 4:]
        kind, argument = rest[:4], rest[4:]
        values[path] = (argument[:argument.index(b'\0')].decode() if kind == b',s\0\0' else
                        struct.unpack('>f' if kind == b',f\0\0' else '>i', argument)[0])
    return values


class Case(DaemonCase):
    def write_rig(self, osc):
        self.rig.write_text('[audio]\ndevice = "null"\nblock = 256\n[sound]\nset = "set"\n[[boom]]\n[[boom]]\n'
                            f'[control]\nsocket = "{self.socket}"\n[osc]\n{osc}')


class Live(Case):
    def test_signals_controls_and_mute_come_in_and_what_is_heard_goes_out(self):
        port = free_port(socket.SOCK_DGRAM)
        tablet = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.addCleanup(tablet.close)
        tablet.bind(('127.0.0.1', 0))
        tablet.settimeout(PATIENCE_S)
        self.write_rig(f'address = "127.0.0.1:{port}"\ntargets = ["127.0.0.1:{tablet.getsockname()[1]}"]\n')
        self.start_daemon()
        heard = {}

        def hear_until(**wanted):
            while any(heard.get(path.replace('__', '/')) != value for path, value in wanted.items()):
                heard.update({path.removeprefix('/rigsound/'): value for path, value in values_of(tablet.recv(9000)).items()})

        def say(path, value):
            tablet.sendto(message(path, value), ('127.0.0.1', port))

        hear_until(muted=0, boom1__situation='underfeed', boom2__decay_factor=1.0)
        self.assertLessEqual({'meters/peak_db', 'meters/limiter_db', 'boom2/levels/drill/rms_db', 'boom1/impacts_made_hz', 'paused'}, set(heard))
        say('/rigsound/boom2/feed_pressure_bar', 160)
        say('/rigsound/boom?/decay_factor', 2)
        say('/rigsound/rattling', 'closed')
        say('/rigsound/mute', True)
        say('/rigsound/boom1/decay_factor', 99)
        say('/rigsound/volume', 1)
        hear_until(muted=1, boom1__situation='closed_rattling', boom2__situation='overfeed', boom1__decay_factor=2.0, boom2__decay_factor=2.0,
                   boom2__feed_pressure_bar=160.0, rattling=1.0)
        self.assertNotIn('rock', heard)  # never said
        say('/rigsound/feed_pressure_bar', 1000)
        say('/rigsound/mute', False)
        hear_until(muted=0)
        status = json.loads(self.ctl('status', '--json').stdout)
        signals = {signal['name']: signal for signal in status['signals']}
        self.assertEqual((signals['feed_pressure_bar']['refused'], signals['feed_pressure_bar']['last_refused']), (1, 1000))
        bus = status['buses'][0]
        self.assertEqual((bus['name'], bus['frames_seen'], bus['frames_bad']), (f'osc 127.0.0.1:{port}', 8, 1))
        self.assertEqual(self.ctl('set', 'boom2.feed_pressure_bar', '60').returncode, 0)
        hear_until(boom2__feed_pressure_bar=60.0)  # by hand, whatever OSC says
        say('/rigsound/boom2/feed_pressure_bar', 160)
        say('/rigsound/mute', True)
        hear_until(muted=1)
        self.assertEqual(heard['boom2/feed_pressure_bar'], 60.0)


class Rig(Case):
    def check(self, osc):
        self.write_rig(osc)
        return subprocess.run([RIGSOUND, 'check', self.rig], capture_output=True, text=True, timeout=PATIENCE_S)

    def test_check_says_what_it_takes_and_refuses_what_it_cannot(self):
        result = self.check('address = "127.0.0.1:9001"\ntargets = ["127.0.0.1:9000", "[::1]:9000"]\nevery_ms = 200\n')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('osc 127.0.0.1:9001: 28 signals, controls, mute\nosc to 127.0.0.1:9000 every 200 ms\nosc to [::1]:9000 every 200 ms\n',
                      result.stdout)
        for osc, error in (('address = "9001"', 'osc.address: "9001" is no address with a port, expected HOST:PORT or [V6]:PORT'),
                           ('targets = ["tablet:9000"]',
                            'osc.targets: "tablet:9000" is no address with a port, expected one like "192.168.1.5:9000"'),
                           ('every_ms = 10', 'osc.every_ms: is 10 ms, expected 100...60000 ms'),
                           ('adress = ""', "osc.adress: is not known here, did you mean 'address'?"),
                           ('address = "127.0.0.1:9001"\nsignals = ["engine_rmp"]',
                            'osc.signals: "engine_rmp" is no signal, or one that another bus delivers, did you mean \'engine_rpm\'?')):
            result = self.check(osc + '\n')
            self.assertEqual((result.returncode, result.stderr.count('\n')), (1, 1), result.stderr)
            self.assertIn(error, result.stderr)


unittest.main(argv=sys.argv[:1])
