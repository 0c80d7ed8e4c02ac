#!/usr/bin/env python3
"""feed_test.py RIGSOUND ROOT: the feed axis as a user of `simulate`, `analyze` and `check` meets it."""
import pathlib
import struct
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
DEMO = ROOT / 'config/rigs/demo.toml'


def run(*words):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300)


class Case(FolderCase):
    def silence(self, seconds):
        data = bytes(2 * 48000 * seconds)
        form = struct.pack('<HHIIHH', 1, 1, 48000, 96000, 2, 16)
        body = b'WAVEfmt ' + struct.pack('<I', len(form)) + form + b'data' + struct.pack('<I', len(data)) + data
        path = self.folder / 'quiet.wav'
        path.write_bytes(b'RIFF' + struct.pack('<I', len(body)) + body)
        return path

    def refused(self, words, line, code):
        result = run(*words)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stderr.splitlines()[0], line)


class Usage(Case):
    def test_simulate_says_what_it_accepts(self):
        self.refused(['simulate', '--out', 'x', '--feed-ramp', '5'], '--feed-ramp: is 5, expected 10...3600 s', 2)
        self.refused(['simulate', '--out', 'x', '--rods', '1,21'], '--rods: is 21, expected 1...20', 2)
        self.refused(['simulate', '--out', 'x', '--rods', 'two'],
                     "--rods: 'two' is neither a number nor a range such as 3-7", 2)
        self.assertEqual(run('simulate', '--out', 'x', '--ids', '100', '--feed-ramp', '20').returncode, 2)

    def test_a_bus_log_needs_a_rig_that_describes_the_bus(self):
        self.refused(['analyze', 'a.wav', '--out', 'x', '--bus-log', 'b.log'], '--bus-log requires --rig', 2)


class BusLog(Case):
    def analyze(self, *words):
        return ['analyze', self.silence(3), '--out', self.folder / 'set', '--rig', DEMO, *words]

    def test_one_log_is_for_one_recording(self):
        words = self.analyze('--bus-log', 'b.log')
        words.insert(2, 'other.wav')
        self.refused(words, 'b.log: is given for 2 recordings, expected one (a bus log beside each recording, with its '
                     'name and .log, is found by itself)', 1)

    def test_a_log_of_other_minutes_gives_nothing(self):
        self.refused(self.analyze('--bus-log', ROOT / 'config/logs/shift.log'),
                     f"{ROOT / 'config/logs/shift.log'}: has no drilling within the recording, expected feed and hammer on "
                     f"while {self.folder / 'quiet.wav'} was recorded", 1)
        self.assertFalse((self.folder / 'set').exists())

    def test_the_offset_finds_them(self):
        result = run(*self.analyze('--bus-log', ROOT / 'config/logs/shift.log', '--bus-log-offset', '-28'))
        self.assertEqual(result.returncode, 1)
        self.assertIn('silent', result.stderr)  # a part was cut out and listened to


class Check(Case):
    def test_check_tells_where_each_series_flattens(self):
        folder = write_sound_set(self.folder / 'set')
        with open(folder / 'soundset.toml', 'a', encoding='utf-8') as index:
            index.write('[[laws]]\nln_gap = 0.001\nln_decay = 0.02\n')
        text = DEMO.read_text(encoding='utf-8').replace('../../out/soundset', str(folder))
        text = text.replace('../dbc/', f"{ROOT / 'config/dbc'}/").replace('tool = "rods"', '# no tool')
        rig = self.folder / 'rig.toml'
        rig.write_text(text, encoding='utf-8')
        result = run('check', rig)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('feed, 1 rod: 3 banks at 37.5 to 150 bar; flattens below them: nothing; '
                      'above: decay from 204 bar\n', result.stdout)


unittest.main(argv=sys.argv[:1])
