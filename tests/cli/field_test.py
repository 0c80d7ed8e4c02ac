#!/usr/bin/env python3
"""field_test.py RIGSOUND ROOT: logs as they exist in the field, each with its right answer."""
import gzip
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from field_case import CASES, RIGSOUND, ROOT, FieldCase, decode, run


class Formats(FieldCase):
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


class Pipes(FieldCase):
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


class Clocks(FieldCase):
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


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
