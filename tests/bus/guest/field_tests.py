"""Devices and tools as they are in the field: a sparse store, a PLC that closes, one line for two units, candump's screen."""
import pathlib
import select
import subprocess
import sys
import time
import unittest

from modbus_tests import SERVER, Line
from place import PLACE
from pymodbus.client import ModbusTcpClient
from rigs import write_rig
from running import Daemon, wait_for


class Plc:
    def __init__(self, kind, where):
        script = pathlib.Path(__file__).parent / 'field_plcs.py'
        self.process = subprocess.Popen([sys.executable, script, kind, where], stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline().strip() == 'listening'

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def said(self):
        ready, _, _ = select.select([self.process.stdout], [], [], 0)
        return self.process.stdout.readline() if ready else ''


def client(keys, **signals):
    lines = [f'{name} = {{ table = "holding", address = {address} }}' for name, address in signals.items()]
    return f'role = "client"\npoll_ms = 50\n{keys}\n[modbus.signals]\n' + '\n'.join(lines)


def changes(log):
    """Lines of the journal that tell of a bus going up or down."""
    return [line for line in log.splitlines() if line.endswith(': up') or ': down: ' in line or 'changes)' in line]


class Modbus(unittest.TestCase):
    def rig(self, *sections):
        return write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=sections)

    def test_a_sparse_store_is_asked_around_its_holes(self):
        rig = self.rig(client('address = "127.0.0.1:1610"\nunit = 1', feed_pressure_bar=100, rod_count=106))
        with Plc('sparse', '1610'), Daemon(PLACE.rigsoundd, rig) as daemon:
            daemon.wait_signal('feed_pressure_bar', 90)
            daemon.wait_signal('rod_count', 2)
            self.assertEqual(daemon.log().count('asked for in parts'), 1)
            probed = subprocess.run([PLACE.rigsound, 'check', rig, '--probe'], capture_output=True, text=True)
            self.assertEqual(probed.returncode, 0, probed.stderr)
            self.assertIn('005A', probed.stdout)

    def test_a_plc_that_closes_after_each_answer(self):
        rig = self.rig(client('address = "127.0.0.1:1611"\nunit = 1', feed_pressure_bar=100, rotation_pressure_bar=200))
        with Plc('closing', '1611'), Daemon(PLACE.rigsoundd, rig) as daemon:
            daemon.wait_signal('feed_pressure_bar', 90)
            daemon.wait_signal('rotation_pressure_bar', 55)
            seen = set()
            end = time.monotonic() + 10
            while time.monotonic() < end:
                s = daemon.signal('feed_pressure_bar')
                seen.add((s['value'], s['validity']))
                time.sleep(0.05)
            self.assertEqual(seen, {(90, 'valid')})
            self.assertLessEqual(len(changes(daemon.log())), 1)

    def test_two_units_on_one_line(self):
        sections = [client(f'transport = "rtu"\naddress = "/tmp/line_a"\nunit = {unit}', **{name: 0})
                    for unit, name in ((1, 'feed_pressure_bar'), (2, 'rotation_pressure_bar'))]
        with Line(), Plc('units', '/tmp/line_b') as plc, Daemon(PLACE.rigsoundd, self.rig(*sections)) as daemon:
            daemon.wait_signal('feed_pressure_bar', 81)
            daemon.wait_signal('rotation_pressure_bar', 82)
            wait_for('a hundred answers', lambda: daemon.bus('modbus /tmp/line_a')['frames_used'] >= 100)
            self.assertEqual(plc.said(), '')
            self.assertEqual(daemon.bus('modbus /tmp/line_a')['frames_bad'], 0)

    def test_a_master_that_is_gone_makes_its_signals_quiet(self):
        section = SERVER.replace('master_gone_after_ms = 0\n', '')
        with Daemon(PLACE.rigsoundd, self.rig(section)) as daemon:
            wait_for('the server', lambda: daemon.bus('modbus 127.0.0.1:1502')['up'])
            master = ModbusTcpClient('127.0.0.1', port=1502)
            self.assertTrue(master.connect())
            self.assertFalse(master.write_coil(0, True, slave=1).isError())
            daemon.wait_signal('percussion', 1)
            master.close()
            daemon.wait_signal('percussion', 0, validity='bus_down')


class Screen(unittest.TestCase):
    FORMS = (['-ta'], ['-tA'], ['-td'], ['-tz'], ['-ta', '-x'], ['-ta', '-i'], ['-ta', '-S'], ['-ta', '-a'],
             ['-tz', '-x', '-a', '-S'], ['-ta', '-i', '-S'], ['-ta', '-c'], [])

    def test_every_form_of_candump_is_read(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, can=['vcan0'], safety='stale_after_ms = 0')
        with open(PLACE.log) as log, open('/tmp/part.log', 'w') as part:
            part.writelines(line for _, line in zip(range(300), log))
        logs = [open(f'/tmp/screen{i}.log', 'w') for i in range(len(self.FORMS))]
        dumps = [subprocess.Popen(['candump', *form, '-T', '2000', 'vcan0'], stdout=log)
                 for form, log in zip(self.FORMS, logs)]
        wait_for('candump', lambda: open('/proc/net/can/rcvlist_all').read().count(' raw') >= len(dumps))
        subprocess.run([PLACE.rigsound, 'replay', '/tmp/part.log', '--can', 'vcan0'], check=True, capture_output=True)
        for dump in dumps:
            dump.wait()
        wanted = self.values('/tmp/part.log', rig)
        for i, form in enumerate(self.FORMS):
            logs[i].close()
            with self.subTest(form):
                self.assertEqual(self.values(f'/tmp/screen{i}.log', rig), wanted)

    def test_each_interface_of_a_log_goes_where_it_is_told(self):
        with open('/tmp/two.log', 'w') as log:
            for i in range(50):
                log.write(f'({i / 100:.6f}) can{i % 2} {0x100 + i % 2:03X}#{i:02X}\n')
        dump = subprocess.Popen(['candump', '-L', '-T', '2000', 'vcan0', 'vcan1'], stdout=open('/tmp/both.log', 'w'))
        wait_for('candump', lambda: open('/proc/net/can/rcvlist_all').read().count(' raw') >= 2)
        told = subprocess.run([PLACE.rigsound, 'replay', '/tmp/two.log', '--can', 'can0=vcan1', '--can', 'can1=vcan0'],
                              capture_output=True, text=True)
        self.assertEqual(told.returncode, 0, told.stderr)
        dump.wait()
        got = [line.split()[1:] for line in open('/tmp/both.log')]
        self.assertEqual(sorted(got), sorted([f'vcan{1 - i % 2}', f'{0x100 + i % 2:03X}#{i:02X}'] for i in range(50)))

    @staticmethod
    def values(log, rig):
        told = subprocess.run([PLACE.rigsound, 'decode', rig, '--log', log], check=True, capture_output=True, text=True)
        return [line.split(',', 1)[1] for line in told.stdout.splitlines()]
