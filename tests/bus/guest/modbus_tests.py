"""Modbus as others speak it: mbpoll, pymodbus, libmodbus, over TCP and over a serial line."""
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
address = "127.0.0.1:1602"
unit = 1
poll_ms = 20
[modbus.signals]
feed_pressure_bar = { table = "holding", address = 0, type = "uint16", scale = 0.1 }
engine_rpm = { table = "holding", address = 2, type = "float32", word_order = "CDAB" }
percussion = { table = "coil", address = 1 }'''


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
        client.close()

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
        wait_for('the flood to be turned away', lambda: self.bus()['connections_refused'] >= 68)
        wait_for('the garbage to be counted', lambda: self.bus()['frames_bad'] == 50)
        self.assertEqual(self.daemon.signal('rod_count')['value'], 7)
        self.assertFalse(client.write_register(8, 9, slave=1).isError())
        self.daemon.wait_signal('rod_count', 9)
        complaints = [line for line in self.daemon.log().splitlines() if 'warn' in line]
        self.assertLess(len(complaints), 20)
        for connection in [half, *flood]:
            connection.close()
        client.close()


class Serial(unittest.TestCase):
    def test_a_line_between_two_pseudo_terminals(self):
        line = subprocess.Popen(['socat', 'pty,raw,echo=0,link=/tmp/line_a', 'pty,raw,echo=0,link=/tmp/line_b'])
        try:
            rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=[RTU])
            with Daemon(PLACE.rigsoundd, rig) as daemon:
                wait_for('the line', lambda: daemon.bus('modbus /tmp/line_a')['up'])
                serial = ('-m', 'rtu', '-a', 17, '-b', 19200, '-P', 'even', '-0', '-t', '4', '-r', 0, '/tmp/line_b')
                self.assertEqual(mbpoll(*serial, 855).returncode, 0)
                daemon.wait_signal('feed_pressure_bar', 85.5)
                self.assertNotEqual(mbpoll(*serial, 3001).returncode, 0)
                daemon.wait_signal('feed_pressure_bar', 85.5)
                line.terminate()
                line.wait()
                daemon.wait_signal('feed_pressure_bar', validity='bus_down')
        finally:
            line.terminate()
            line.wait()


class Client(unittest.TestCase):
    def start_plc(self):
        plc = subprocess.Popen([PLACE.plc, '1602'], stdout=subprocess.PIPE, text=True)
        self.assertEqual(plc.stdout.readline().strip(), 'listening')
        return plc

    def stop_plc(self, plc):
        plc.kill()
        plc.wait()
        plc.stdout.close()

    def test_the_device_dies_and_returns(self):
        plc = self.start_plc()
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, modbus=[CLIENT], safety='stale_after_ms = 0')
        with Daemon(PLACE.rigsoundd, rig) as daemon:
            daemon.wait_signal('feed_pressure_bar', 85.5)
            daemon.wait_signal('engine_rpm', 499.375)
            daemon.wait_signal('percussion', 1)
            self.stop_plc(plc)
            daemon.wait_signal('engine_rpm', validity='bus_down')
            plc = self.start_plc()
            daemon.wait_signal('engine_rpm', 499.375)
            self.assertEqual(daemon.bus('modbus 127.0.0.1:1602')['losses'], 1)
        self.stop_plc(plc)
