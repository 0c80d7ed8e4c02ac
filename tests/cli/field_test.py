#!/usr/bin/env python3
"""field_test.py RIGSOUND ROOT: logs and signal maps as they exist in the field, each with its right answer.

The files lie in `cases/`: what people reported of other tools, made small.
"""
import csv
import gzip
import io
import os
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import unittest

from folder_case import FolderCase
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
CASES = ROOT / 'tests/cli/cases'


def run(*words, **more):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300, **more)


def decode(rig, log, *words, **more):
    return run('decode', CASES / rig, '--log', log if log == '-' else CASES / log, *words, **more)


def told(result):
    """(time, signal, value) of every row."""
    rows = csv.DictReader(io.StringIO(result.stdout))
    return [(float(r['time_s']), r['signal'], r['value']) for r in rows]


class Case(FolderCase):
    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content) if isinstance(content, bytes) else path.write_text(content)
        return path

    def good(self, result, *parts):
        self.assertEqual(result.returncode, 0, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)
        return told(result)

    def refused(self, result, *parts):
        self.assertEqual((result.returncode, result.stdout), (1, ''), result.stderr)
        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)

    def speeds(self, result, *expected):
        """(time, r/min) of every row."""
        rows = self.good(result)
        self.assertEqual([(round(t, 6), float(v)) for t, s, v in rows if s == 'engine_rpm'], list(expected), result.stderr)


class Formats(Case):
    def test_what_candump_writes_and_shows(self):
        for log in ('candump-human-tz.log', 'candump-human-x.log', 'candump-L-tA.log', 'eight-decimals.log',
                    'three-decimals.log', 'vector.asc', 'peak21.trc', 'socketcan-227.pcap',
                    'socketcan-sll.pcap'):
            with self.subTest(log):
                self.speeds(decode('eec1.toml', log), (0, 1000), (0.02, 1008))

    def test_what_gzip_packed(self):
        self.speeds(decode('eec1.toml', 'candump.log.gz'), (0, 1000), (4000, 1008))

    def test_lines_without_stamps(self):
        result = decode('eec1.toml', 'candump-human-plain.log')
        self.speeds(result, (0, 1000), (0.001, 1008))
        self.assertIn('carries no time stamps', result.stderr)

    def test_decimals_that_change(self):
        self.speeds(decode('eec1.toml', 'mixed-decimals.log'), (0, 1000), (0.022631, 1008), (0.042631, 1016))

    def test_every_view_of_the_screen(self):
        """All options of candump at once: binary, swapped, text, colours, length codes, FD, remote and error frames."""
        lines = ('  vcan0  0CF00400   [8]  11110000 01111101 10000101 01000000 00011111 11111111 11111111 10000101',
                 "  vcan0  0CF00400   [8]  85`FF`FF`1F`40`85`7D`F0   `.....}.`",
                 "  vcan0  0CF00400   [8]  F0 7D 85 40 1F FF FF 85   '.}.@....'",
                 '  vcan0  RX - -  0CF00400   {8}  F0 7D 85 40 1F FF FF 85',
                 '\x1b[31m  vcan0  0CF00400   [8]  F0 7D 85 40 1F FF FF 85\x1b[0m')
        for line in lines:
            with self.subTest(line):
                log = self.write('a.log', ' (1700000000.000000)' + line + '\n (1700000000.500000)' +
                                 line.replace('40 1F', '80 1F').replace('1F`40', '1F`80').replace('01000000 0', '10000000 0') + '\n'
                                 ' (1700000000.600000)  vcan0  123   [3]  remote request\n'
                                 ' (1700000000.600000)  vcan0  20000088   [8]  00 00 0E 00 00 00 00 00   ERRORFRAME\n'
                                 ' (1700000000.600000)  vcan0  123  [12]  00 11 22 33 44 55 66 77 88 99 AA BB\n')
                result = run('decode', CASES / 'eec1.toml', '--log', log)
                self.speeds(result, (0, 1000), (0.5, 1008))
                self.assertIn('5 frames', result.stderr)
                self.assertIn('1 error frames', result.stderr)

    def test_stamps_from_frame_to_frame(self):
        frame = ' (000.{:06})  can0  0CF00400   [8]  F0 7D 85 {:02X} 1F FF FF 85\n'
        log = self.write('d.log', ''.join(frame.format(0 if i == 0 else 100000, i) for i in range(5)))
        self.speeds(run('decode', CASES / 'eec1.toml', '--log', log),
                    *[(round(0.1 * i, 1), (0x1F00 + i) * 0.125) for i in range(5)])
        log = self.write('z.log', ''.join(frame.format(100000 * i, i) for i in range(5)))
        self.speeds(run('decode', CASES / 'eec1.toml', '--log', log),
                    *[(round(0.1 * i, 1), (0x1F00 + i) * 0.125) for i in range(5)])

    def test_trc_of_every_version(self):
        bytes_ = 'F0 7D 85 40 1F FF FF 85'
        for version, first in (('1.0', '     1)         0  0CF00400  8  '), ('1.1', '     1)         0.0  Rx     0CF00400  8  '),
                               ('1.2', '     1)         0.0 1  Rx     0CF00400  8  '),
                               ('1.3', '     1)         0.0 1  Rx     0CF00400 -  8    '),
                               ('2.0', '      1         0.000 DT     0CF00400 Rx 8  '),
                               ('2.1', '      1         0.000 DT 1  0CF00400 Rx -  8    ')):
            with self.subTest(version):
                header = ';##########\n' if version == '1.0' else f';$FILEVERSION={version}\n;$STARTTIME=43008.92\n'
                second = first.replace('1)', '2)').replace(' 0.000', '20.000').replace(' 0.0 ', '20.0 ').replace('       0  0', '      20  0')
                log = self.write('a.trc', header + ';\n' + first + bytes_ + '\n' + second + bytes_.replace('40', '80') + '\n')
                self.speeds(run('decode', CASES / 'eec1.toml', '--log', log), (0, 1000), (0.02, 1008))

    def test_asc_decimal_relative_and_fd(self):
        log = self.write('a.asc', 'date Thu Apr 16 01:59:01.000 pm 2020\nbase dec  timestamps relative\n'
                                  '   0.5 1  217056256x  Rx   d 8 240 125 133 64 31 255 255 133\n'
                                  '   0.25 2  217056256x  TxRq   d 8 240 125 133 64 31 255 255 133\n'
                                  '   0.25 1  217056256x  Tx   d 8 240 125 133 128 31 255 255 133\n'
                                  '   0.25 CANFD   1 Rx  217056256x  EEC1  0 0 8  8 240 125 133 192 31 255 255 133  130000  130    0 0 0 0 0 0\n')
        self.speeds(run('decode', CASES / 'eec1.toml', '--log', log), (0, 1000), (0.5, 1008), (0.75, 1016))

    def test_other_formats_are_named_with_what_converts_them(self):
        self.refused(decode('eec1.toml', 'eec1.blf'), 'eec1.blf: is a Vector BLF', 'can_logconvert')
        for start, name in ((b'MDF     4.10', 'MDF'), (b'SQLite format 3\0', 'SQLite'), (b'\xfd7zXZ\0', 'xz'),
                            (b'\xff\xfe(\x001\0', 'UTF-16'), (b'timestamp,arbitration_id,extended\n', 'CSV of python-can'),
                            (b'Time Stamp,ID,Extended,Bus,LEN,D1\n', 'SavvyCAN')):
            with self.subTest(name):
                self.refused(run('decode', CASES / 'eec1.toml', '--log', self.write('a.log', start + b'x' * 50)), name)

    def test_interface_names_with_blanks_are_skipped(self):
        result = decode('eec1.toml', 'python-can-real.log', '--can', 'vcan0=can0')
        self.speeds(result, (0, 1000), (0.04, 1008))
        self.assertIn('skipped 1 lines', result.stderr)
        self.speeds(decode('eec1.toml', 'python-can.log'), (0, 1000), (0.500887, 1008))

    def test_cut_off_files(self):
        for name in ('candump-human-tz.log', 'vector.asc', 'peak21.trc'):
            whole = (CASES / name).read_bytes().split(b'End')[0].rstrip()
            with self.subTest(name):
                log = self.write(name, whole[:-4])
                self.refused(run('decode', CASES / 'eec1.toml', '--log', log), 'the log ends in the middle of a frame')
        packed = (CASES / 'candump.log.gz').read_bytes()
        self.refused(run('decode', CASES / 'eec1.toml', '--log', self.write('a.gz', packed[:-10])), 'cannot be unpacked to its end')
        capture = (CASES / 'socketcan-227.pcap').read_bytes()
        self.refused(run('decode', CASES / 'eec1.toml', '--log', self.write('a.pcap', capture[:-3])), 'was cut off')


class Pipes(Case):
    def test_nothing_is_lost(self):
        demo, log = ROOT / 'config/rigs/demo.toml', ROOT / 'config/logs/shift.log'
        whole = run('decode', demo, '--log', log)
        self.assertEqual(whole.returncode, 0)
        text = log.read_bytes()
        for sent in (text, gzip.compress(text)):
            result = subprocess.run([RIGSOUND, 'decode', demo, '--log', '-'], input=sent, capture_output=True, timeout=300)
            self.assertEqual(result.stdout.decode(), whole.stdout)
            self.assertEqual(result.stderr.decode().replace('-:', f'{log}:'), whole.stderr)
        fifo = self.folder / 'fifo'
        os.mkfifo(fifo)
        writer = subprocess.Popen(['cp', log, fifo])
        self.assertEqual(run('decode', demo, '--log', fifo).stdout, whole.stdout)
        writer.wait()
        self.assertEqual(list(pathlib.Path(tempfile.gettempdir()).glob('rigsound.log.*')), [])


class Clocks(Case):
    def test_a_clock_set_while_logging(self):
        result = decode('eec1.toml', 'clock-set-while-logging.log')
        self.speeds(result, (0, 1000), (0.001, 1008), (0.021, 1016))
        self.assertEqual(result.stderr.count('the clock was set forward'), 1)
        self.assertIn('clock-set-while-logging.log:2:', result.stderr)

    def test_a_lone_wrong_stamp_is_not_the_clock(self):
        rows = self.good(decode('eec1.toml', 'one-frame-ahead.log'), '1 stamps alone are wrong')
        self.assertEqual(len(rows), 100)
        self.assertEqual(len({t for t, _, _ in rows}), 100)
        self.assertAlmostEqual(rows[-1][0], 9.9, delta=0.051)

    def test_a_clock_set_back_and_logs_one_after_the_other(self):
        frame = '({:.6f}) can0 0CF00400#F07D85{:02X}1FFFFF85\n'
        for jump in (-3.7, -0.25, -86400 * 30):
            with self.subTest(jump):
                stamps = [1e9 + 0.1 * i + (jump if i >= 20 else 0) for i in range(40)]
                log = self.write('a.log', ''.join(frame.format(t, i) for i, t in enumerate(stamps)))
                rows = self.good(run('decode', CASES / 'eec1.toml', '--log', log), 'a.log:21: time runs backwards')
                self.assertEqual(len(rows), 40)
                self.assertAlmostEqual(rows[-1][0], 3.9, delta=0.001)

    def test_a_long_pause_can_be_left_out(self):
        result = decode('eec1.toml', 'gap-over-an-hour.log')
        self.speeds(result, (0, 1000), (4000, 1008))
        self.assertIn('--skip-gaps', result.stderr)
        result = decode('eec1.toml', 'gap-over-an-hour.log', '--skip-gaps', '10')
        self.speeds(result, (0, 1000), (0.001, 1008))
        self.assertIn('1 pauses were left out, the first of 4000.0 s', result.stderr)


class Nearest(Case):
    """A log of which nothing can be used is a failure that names the nearest thing."""

    def test_a_parameter_group_from_elsewhere(self):
        self.refused(decode('nov.toml', 'j1939-no-vframeformat.log'),
                     'none of its 2 frames is of use to the rig: PGN 61444 came from 00, the DBC says FE: j1939 = true?')

    def test_other_identifiers_and_interfaces(self):
        log = self.write('a.log', '(1.000000) can0 123#00\n(1.000000) can0 18FF1000#00\n')
        self.refused(run('decode', CASES / 'eec1.toml', '--log', log), 'it holds 123, 18FF1000, the rig wants EEC1 = 0CF004FE')
        log = self.write('a.log', '(1.000000) can0 123#00\n(1.000000) can1 0CF00400#F07D85401FFFFF85\n')
        self.refused(run('decode', CASES / 'eec1.toml', '--log', log), 'EEC1 came on can1', '--can can1=can0?')
        self.speeds(run('decode', CASES / 'eec1.toml', '--log', log, '--can', 'can1=can0'), (0, 1000))

    def test_fd_frames_on_a_classic_bus(self):
        self.refused(decode('eec1.toml', 'fd64.log'), 'CAN FD frames: fd = true?')
        rig = self.write('rig.toml', (CASES / 'eec1.toml').read_text().replace('dbc/', f'{CASES}/dbc/').replace('interface', 'fd = true\ninterface'))
        self.speeds(run('decode', rig, '--log', CASES / 'fd64.log'), (0, 1000))

    def test_values_that_are_none(self):
        log = self.write('a.log', '(1.000000) can0 0CF00400#FFFFFFFFFFFFFFFF\n')
        self.refused(run('decode', CASES / 'eec1.toml', '--log', log), 'EEC1.EngSpeed has no value: not_available')

    def test_units_addresses_and_servers_of_a_capture(self):
        self.refused(decode('mb_unit7.toml', 'modbus-eth.pcap'), '10.0.0.1:502 unit 1: holding 0 = 40001', 'unit 7')
        self.refused(decode('mb_40001.toml', 'modbus-eth.pcap'), '10.0.0.1:502 unit 1: holding 0 = 40001')


class Signals(Case):
    def test_an_error_indicator_does_not_hammer(self):
        rows = self.good(decode('perc.toml', 'percussion-error-10b.log'), 'percussion: 41 values refused, last error_value')
        self.assertEqual([(s, v) for _, s, v in rows if s == 'percussion'], [('percussion', 'off')])
        rows = self.good(decode('perc.toml', 'percussion-not-available-11b.log'), 'percussion: 41 values refused, last not_available')
        self.assertEqual([(s, v) for _, s, v in rows if s == 'percussion'], [('percussion', 'off')])
        rows = self.good(decode('perc.toml', 'percussion-on.log'))
        self.assertEqual([v for _, s, v in rows if s == 'percussion'], ['off', 'on', 'off'])

    def test_codes_of_short_and_odd_fields(self):
        rows = self.good(decode('short.toml', 'j1939-short-fields.log'))
        self.assertNotIn(('rod_count', '15'), [(s, v) for _, s, v in rows])
        self.assertEqual([v for _, s, v in rows if s == 'rod_count'], ['3'])
        self.assertEqual(max(float(v) for _, s, v in rows if s == 'feed_pressure_bar'), 100)

    def test_two_sources_of_one_message_are_told(self):
        log = self.write('a.log', ''.join(f'({t}.000000) can0 {id_}#F07D85401FFFFF85\n' for t, id_ in
                                          ((1, '0CF00400'), (2, '0CF00421'), (3, '0CF00400'))))
        result = run('decode', CASES / 'eec1.toml', '--log', log)
        self.good(result)
        self.assertEqual(result.stderr.count('EEC1 comes from 00, 21: all are taken in turn, source = 0x00 takes one'), 1)

    def test_what_comes_by_transport_protocol_is_said_to(self):
        self.refused(decode('j1939-tp.toml', 'j1939-tp-bam.log'), 'transport protocol (PGN 60416 and 60160)')

    def test_several_dbc_files_one_interface(self):
        self.good(decode('two-dbc-one-bus.toml', 'percussion-on.log'))
        self.refused(decode('one-interface-two-sections.toml', 'percussion-on.log'), 'dbc = ["a.dbc", "b.dbc"]')
        self.refused(decode('one-signal-twice.toml', 'percussion-on.log'), 'another bus does too')

    def test_maps_as_tools_write_them(self):
        def use(dbc, name='M.S'):
            rig = self.write('rig.toml', f'[safety]\nstale_after_ms = 0\n[[can]]\ninterface = "can0"\ndbc = "{CASES}/dbc/{dbc}"\n'
                                         f'[can.signals]\nengine_rpm = "{name}"\n')
            return run('decode', rig, '--log', CASES / 'dbc.log')
        for dbc in ('bs_nonempty', 'crlf', 'dotfive', 'ev', 'sci', 'spaces', 'dup_id', 'dup_message', 'dup_signal', 'umlaut',
                    'other_bad_mux', 'cm_nosemi', 'rep_candevstudio196', 'rep_cantools113', 'rep_cantools4',
                    'rep_cantools62', 'rep_cppcanparser9_11'):
            with self.subTest(dbc):
                self.good(use(dbc + '.dbc'))
        self.good(use('longname.dbc', 'M.EngineSpeedOfTheMainDieselEngineAfterFilter'))
        self.good(use('longname.dbc', 'M.EngineSpeedOfTheMainDieselEn0000'))
        self.refused(use('utf16.dbc'), 'utf16.dbc: is UTF-16')
        self.refused(use('cr.dbc'), 'cr.dbc: has line ends of CR alone')
        for dbc in ('comma', 'factor0', 'hexid', 'inf', 'nanrange', 'nounit', 'toolong', 'minuses', 'mux_neg'):
            with self.subTest(dbc):
                self.refused(use(dbc + '.dbc'), dbc + '.dbc:')


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


class Captures(Case):
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


class Plc(threading.Thread):
    """A sparse Modbus server: holding registers 100 and 106, exception 2 for everything else."""
    HELD = {100: 90, 106: 2}

    def __init__(self):
        super().__init__(daemon=True)
        self.listening = socket.create_server(('127.0.0.1', 0))
        self.port = self.listening.getsockname()[1]
        self.start()

    def run(self):
        while True:
            peer, _ = self.listening.accept()
            with peer, peer.makefile('rb') as stream:
                while head := stream.read(8):
                    tid, _, length, unit, function = struct.unpack('>HHHBB', head)
                    first, count = struct.unpack('>HH', stream.read(length - 2))
                    there = [self.HELD.get(first + i) for i in range(count)]
                    pdu = bytes((function | 0x80, 2)) if None in there else struct.pack(f'>BB{count}H', function, 2 * count, *there)
                    peer.sendall(struct.pack('>HHHB', tid, 0, len(pdu) + 1, unit) + pdu)


class Check(Case):
    def check(self, text, *words):
        if not (self.folder / 'set').exists():
            write_sound_set(self.folder / 'set')
        rig = self.write('rig.toml', f'[sound]\nset = "{self.folder}/set"\n' + text)
        return run('check', rig, *words)

    def case(self, name, *words):
        return self.check((CASES / name).read_text().replace('dbc/', f'{CASES}/dbc/'), *words)

    def test_lines_and_ports(self):
        self.refused(self.case('two-servers-one-port.toml'), 'is a port that two servers listen at')
        result = self.case('rtu-one-line-two-units.toml')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.case('modbus-two-units-one-host.toml').returncode, 0)
        self.assertEqual(self.case('modbus-status-word-bit.toml').returncode, 0)
        self.assertEqual(self.case('two-dbc-one-bus.toml').returncode, 0)

    def test_addresses_of_a_manual(self):
        result = self.case('mb_40001.toml')
        self.assertEqual(result.returncode, 0)
        self.assertIn('address 40001 counts from 0, so it is holding 40001 = 80002: address = 0?', result.stderr)

    def test_units_and_ranges(self):
        dbc = self.write('m.dbc', 'BO_ 256 DrillLeft: 8 A\n SG_ Feed : 0|16@1+ (1,0) [0|40000] "kPa" A\n'
                                  ' SG_ Load : 16|8@1+ (1,0) [0|100] "%" A\n')
        result = self.check(f'[[can]]\ninterface = "can0"\ndbc = "{dbc}"\n[can.signals]\nfeed_pressure_bar = "DrillLeft.Feed"\n'
                            'engine_load = "DrillLeft.Load"\n')
        self.assertEqual(result.returncode, 0)
        self.assertIn('rig.toml:7: can.signals.feed_pressure_bar: DrillLeft.Feed is in kPa, feed_pressure_bar in bar: scale = 0.01?',
                      result.stderr)
        self.assertNotIn('engine_load', result.stderr)

    def test_a_probe_of_a_device_with_holes(self):
        text = (CASES / 'modbus-sparse-plc.toml').read_text().replace('1702', str(Plc().port))
        result = self.check(text, '--probe')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('005A', result.stdout)
        result = self.check(text.replace('106', '103'), '--probe')
        self.assertEqual(result.returncode, 3)
        self.assertIn('005A', result.stdout)
        self.assertIn('cannot be read: Illegal data address', result.stdout)
        self.assertIn('1 signals cannot be read', result.stderr)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
