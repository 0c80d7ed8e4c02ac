#!/usr/bin/env python3
"""field_captures_test.py RIGSOUND ROOT: captures of Modbus as they exist in the field."""
import struct
import sys
import unittest

from field_case import CASES, FieldCase, decode, run


def pcapng(*packets):
    """A pcapng of packets (interface, microseconds, bytes) on two interfaces: can0 of SocketCAN, eth0 of Ethernet."""
    def block(kind, body):
        body += b'\0' * (-len(body) % 4)
        return struct.pack('<II', kind, len(body) + 12) + body + struct.pack('<I', len(body) + 12)
    text = block(0x0A0D0D0A, struct.pack('<IHHq', 0x1A2B3C4D, 1, 0, -1))
    for link, name in ((227, b'can0'), (1, b'eth0')):
        text += block(1, struct.pack('<HHI', link, 0, 65535) + struct.pack('<HH', 2, 4) + name + struct.pack('<HH', 0, 0))
    for interface, micros, data in packets:
        text += block(6, struct.pack('<IIIII', interface, 0, micros, len(data), len(data)) + data)
    return text


class Captures(FieldCase):
    def test_several_link_types_in_one(self):
        eec1 = bytes.fromhex('8cf0040008000000f07d85{}1fffff85'.format('40'))
        other = bytes(14) + b'nothing of ours'
        log = self.write('a.pcapng', pcapng((1, 0, other), (0, 100000, eec1), (1, 200000, other), (0, 600000, eec1.replace(b'\x40', b'\x80'))))
        self.speeds(run('decode', CASES / 'eec1.toml', '--log', log), (0, 1000), (0.5, 1008))

    def test_the_rig_chooses_the_server(self):
        rows = self.good(decode('mb2plc.toml', 'modbus-two-plcs-one-unit.pcap'))
        first = {v for _, s, v in rows if s == 'feed_pressure_bar'}
        second = {v for _, s, v in rows if s == 'b.feed_pressure_bar'}
        self.assertTrue(first and second and not first & second, rows)

    def test_servers_that_are_not_there_are_listed(self):
        rig = self.write('rig.toml', (CASES / 'mb1.toml').read_text().replace('10.0.0.1', '10.0.0.9'))
        self.refused(run('decode', rig, '--log', CASES / 'modbus-two-plcs-one-unit.pcap'),
                     'has the servers 10.0.0.1:502, 10.0.0.2:502', '10.0.0.9:502')

    def test_every_way_to_capture(self):
        for name in ('eth', 'vlan', 'qinq', 'sll', 'sll2', 'raw', 'null', 'ns', 'be', 'ns-be', 'ipv6', 'port1502',
                     'port1502-nosyn', 'snap68', 'segmented', 'retransmit', 'tid0', 'any-duplicated'):
            with self.subTest(name):
                self.good(decode('mb1.toml', f'modbus-{name}.pcap'))
        for name in ('ng', 'ng-2if'):
            self.good(decode('mb1.toml', f'modbus-{name}.pcapng'))

    def test_the_rigs_port_is_the_servers(self):
        rig = self.write('rig.toml', (CASES / 'mb1.toml').read_text().replace(':502', ':50502'))
        self.good(run('decode', rig, '--log', CASES / 'modbus-port50502-nosyn.pcap'))

    def test_rtu_over_tcp(self):
        self.refused(decode('mb1.toml', 'modbus-rtu-over-tcp.pcap'), 'it is RTU over TCP, transport = "rtu_tcp"?')
        text = (CASES / 'mb1.toml').read_text().replace('unit', 'transport = "rtu_tcp"\nunit')
        rows = self.good(run('decode', self.write('rig.toml', text), '--log', CASES / 'modbus-rtu-over-tcp.pcap'))
        self.assertEqual([float(v) for _, signal, v in rows if signal == 'feed_pressure_bar'], [100, 101, 102])
        self.good(run('decode', self.write('rig.toml', text.replace('502', '4001')), '--log', CASES / 'modbus-rtu-over-tcp.pcap'))

    def test_without_answers_there_is_no_exchange(self):
        for name in ('responses-only', 'writes-without-answers'):
            self.refused(decode('mb1.toml', f'modbus-{name}.pcap'), 'holds no Modbus/TCP exchange')


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
