"""Modbus as others speak it: mbpoll, pymodbus, libmodbus, over TCP and over a serial line."""
import os
import random
import socket
import struct
import subprocess
import unittest

from pymodbus.client import ModbusTcpClient
from place import PLACE
from rigs import write_rig
from running import Daemon, wait_for

SERVER = '''role = "server"
address = "127.0.0.1:1502"
master_gone_after_ms = 0
[modbus.signals]
engine_rpm = { table = "holding", address = 0, type = "float32", word_order = "ABCD" }
engine_load = { table = "holding", address = 2, type = "float32", word_order = "CDAB" }
feed_pressure_bar = { table = "holding", address = 4, type = "float32", word_order = "BADC" }
percussion_rate_hz = { table = "holding", address = 6, type = "float32", word_order = "DCBA" }
rod_count = { table = "holding", address = 8, type = "uint16" }
percussion = { table = "coil", address = 0 }'''

RTU = '''role = "server"
transport = "rtu"
address = "/tmp/line_a"
unit = 17
[modbus.signals]
feed_pressure_bar = { table = "holding", address = 0, type = "uint16", scale = 0.1 }'''

CLIENT = '''role = "client"
{device}
unit = 1
poll_ms = 20
[modbus.signals]
rod_count = {{ table = "holding", address = 0, type = "uint16", scale = 0.01 }}
engine_rpm = {{ table = "holding", address = 2, type = "float32", word_order = "ABCD" }}
engine_load = {{ table = "holding", address = 4, type = "float32", word_order = "CDAB" }}
feed_pressure_bar = {{ table = "holding", address = 6, type = "float32", word_order = "BADC" }}
percussion_rate_hz = {{ table = "input", address = 8, type = "float32", word_order = "DCBA" }}
percussion = {{ table = "coil", address = 1 }}'''
ON_TCP, ON_LINE = 'address = "127.0.0.1:1602"', 'transport = "rtu"\naddress = "/tmp/line_a"'
IN_THE_PLC = {'rod_count': 5, 'engine_rpm': 1499.375, 'engine_load': 0.625, 'feed_pressure_bar': 87.25,
              'percussion_rate_hz': 42.5, 'percussion': 1}


def in_order(value, order):
    """The two registers of a float32 whose bytes A B C D travel in `order`."""
    big = struct.pack('>f', value)
    return list(struct.unpack('>HH', bytes(big['ABCD'.index(letter)] for letter in order)))


def mbpoll(*words):
    return subprocess.run(['mbpoll', *map(str, words)], capture_output=True, text=True)


class Server(unittest.TestCase):
    def setUp(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=[SERVER])
        self.daemon = Daemon(PLACE.rigsoundd, rig)
        wait_for('the server', lambda: self.bus()['up'])

    def tearDown(self):
        self.daemon.__exit__()

    def bus(self):
        return self.daemon.bus('modbus 127.0.0.1:1502')

    def test_mbpoll_writes_and_reads(self):
        self.assertEqual(mbpoll('-m', 'tcp', '-p', 1502, '-0', '-t', '4', '-r', 8, '127.0.0.1', 5).returncode, 0)
        self.assertEqual(mbpoll('-m', 'tcp', '-p', 1502, '-0', '-t', '0', '-r', 0, '127.0.0.1', 1).returncode, 0)
        self.daemon.wait_signal('rod_count', 5)
        self.daemon.wait_signal('percussion', 1)
        self.assertIn('[8]: \t5', mbpoll('-m', 'tcp', '-p', 1502, '-0', '-1', '-t', '4', '-r', 8, '127.0.0.1').stdout)
        refused = mbpoll('-m', 'tcp', '-p', 1502, '-0', '-t', '4', '-r', 8, '127.0.0.1', 21)
        self.assertIn('Illegal data value', refused.stderr + refused.stdout)
        self.daemon.wait_signal('rod_count', 5)

    def test_pymodbus_writes_in_all_four_word_orders(self):
        client = ModbusTcpClient('127.0.0.1', port=1502)
        self.assertTrue(client.connect())
        for address, value, order, signal in ((0, 1499.375, 'ABCD', 'engine_rpm'), (2, 0.625, 'CDAB', 'engine_load'),
                                              (4, 87.25, 'BADC', 'feed_pressure_bar'),
                                              (6, 42.5, 'DCBA', 'percussion_rate_hz')):
            self.assertFalse(client.write_registers(address, in_order(value, order), slave=1).isError())
            self.daemon.wait_signal(signal, value)
        for bad in (float('nan'), float('inf'), 4001.0, -1.0):
            answer = client.write_registers(0, in_order(bad, 'ABCD'), slave=1)
            self.assertEqual(answer.exception_code, 3)
        self.assertEqual(client.write_register(99, 1, slave=1).exception_code, 2)
        self.assertEqual(client.read_input_registers(0, 1, slave=1).exception_code, 2)
        self.daemon.wait_signal('engine_rpm', 1499.375)
        self.assertEqual(self.bus()['requests_refused'], 6)
        for _ in range(200):
            client.write_register(99, 1, slave=1)
        self.assertEqual(self.bus()['requests_refused'], 206)
        self.check_said_once('address not in the rig', 'value out of range')
        client.close()

    def check_said_once(self, *kinds):
        """One complaint a minute of each kind, however many there were."""
        lines = [line for line in self.daemon.log().splitlines() if ' warn' in line]
        self.assertEqual([sum(kind in line for line in lines) for kind in kinds], [1] * len(kinds))

    def test_garbage_half_frames_and_floods_change_nothing(self):
        client = ModbusTcpClient('127.0.0.1', port=1502)
        client.write_register(8, 7, slave=1)
        random.seed(1)
        half = socket.create_connection(('127.0.0.1', 1502))
        half.sendall(b'\0\1\0\0\0\6\1\6\0')
        for _ in range(50):
            with socket.create_connection(('127.0.0.1', 1502)) as bad:
                bad.sendall(b'\xff' + random.randbytes(300))
        flood = [socket.create_connection(('127.0.0.1', 1502)) for _ in range(100)]
        wait_for('the flood to be evicted', lambda: self.bus()['evicted_connections'] >= 90)
        wait_for('the garbage to be counted', lambda: self.bus()['frames_bad'] == 50)
        self.assertEqual(self.daemon.signal('rod_count')['value'], 7)
        self.assertFalse(client.write_register(8, 9, slave=1).isError())
        self.daemon.wait_signal('rod_count', 9)
        self.check_said_once('not Modbus, connection closed', 'too many connections')
        for connection in [half, *flood]:
            connection.close()
        client.close()


class Stranger(unittest.TestCase):
    def test_only_the_allowed_networks_come_in(self):
        section = SERVER.replace('[modbus.signals]', 'allow = ["127.0.0.2/32", "10.0.0.0/8"]\n[modbus.signals]')
        section = section.replace('127.0.0.1:1502', '0.0.0.0:1502')
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=[section])
        with Daemon(PLACE.rigsoundd, rig) as daemon:
            def bus():
                return daemon.bus('modbus 0.0.0.0:1502')
            wait_for('the server', lambda: bus()['up'])
            self.assertNotEqual(mbpoll('-m', 'tcp', '-p', 1502, '-0', '-t', '4', '-r', 8, '127.0.0.1', 5).returncode, 0)
            wait_for('the stranger', lambda: bus()['rejected_connections'] >= 1)
            self.assertEqual((bus()['frames_seen'], daemon.signal('rod_count')['validity']), (0, 'never_seen'))
            self.assertIn('not in an allowed network', daemon.log())
            friend = ModbusTcpClient('127.0.0.1', port=1502, source_address=('127.0.0.2', 0))
            self.assertTrue(friend.connect())
            self.assertFalse(friend.write_register(8, 5, slave=1).isError())
            daemon.wait_signal('rod_count', 5)
            friend.close()


class Line:
    """A serial line: two pseudo-terminals, /tmp/line_a and /tmp/line_b."""

    def __enter__(self):
        self.socat = subprocess.Popen(['socat', 'pty,raw,echo=0,link=/tmp/line_a', 'pty,raw,echo=0,link=/tmp/line_b'])
        wait_for('the line', lambda: os.path.exists('/tmp/line_b'))
        return self

    def cut(self):
        self.socat.terminate()
        self.socat.wait()

    def __exit__(self, *_):
        self.cut()


class Serial(unittest.TestCase):
    WORDS = ('-m', 'rtu', '-a', 17, '-b', 19200, '-P', 'even', '-0', '-t', '4', '-r', 0, '/tmp/line_b')

    def test_a_server_on_a_line_that_is_noisy_and_is_cut(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=[RTU])
        with Line() as line, Daemon(PLACE.rigsoundd, rig) as daemon:
            def bus():
                return daemon.bus('modbus /tmp/line_a')
            wait_for('the line', lambda: bus()['up'])
            self.assertEqual(mbpoll(*self.WORDS, 855).returncode, 0)
            daemon.wait_signal('feed_pressure_bar', 85.5)
            self.assertNotEqual(mbpoll(*self.WORDS, 3001).returncode, 0)
            self.assertEqual(bus()['requests_refused'], 1)
            with open('/tmp/line_b', 'wb') as noise:
                noise.write(b'\x11\x06\0\0\x03\x57\xff\xff')  # a write with a wrong checksum
            wait_for('the noise', lambda: bus()['frames_bad'] == 1)
            self.assertEqual(daemon.signal('feed_pressure_bar')['value'], 85.5)
            line.cut()
            daemon.wait_signal('feed_pressure_bar', validity='bus_down')
            with Line():
                wait_for('the line again', lambda: bus()['up'])
                self.assertEqual(mbpoll(*self.WORDS, 900).returncode, 0)
                daemon.wait_signal('feed_pressure_bar', 90)


class Client(unittest.TestCase):
    def start_plc(self, where):
        plc = subprocess.Popen([PLACE.plc, where], stdout=subprocess.PIPE, text=True)
        self.assertEqual(plc.stdout.readline().strip(), 'listening')
        return plc

    def stop_plc(self, plc):
        plc.kill()
        plc.wait()
        plc.stdout.close()

    def check_death_and_return(self, device, where, name):
        plc = self.start_plc(where)
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=[CLIENT.format(device=device)],
                        safety='stale_after_ms = 0')
        with Daemon(PLACE.rigsoundd, rig) as daemon:
            for signal, value in IN_THE_PLC.items():
                daemon.wait_signal(signal, value)
            self.stop_plc(plc)
            for signal in IN_THE_PLC:
                daemon.wait_signal(signal, validity='bus_down')
            plc = self.start_plc(where)
            for signal, value in IN_THE_PLC.items():
                daemon.wait_signal(signal, value)
            self.assertEqual(daemon.bus(name)['losses'], 1)
        self.stop_plc(plc)

    def test_a_device_on_the_network_dies_and_returns(self):
        self.check_death_and_return(ON_TCP, '1602', 'modbus 127.0.0.1:1602')

    def test_a_device_on_a_line_dies_and_returns(self):
        with Line():
            self.check_death_and_return(ON_LINE, '/tmp/line_b', 'modbus /tmp/line_a')
