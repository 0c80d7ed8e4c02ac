#!/usr/bin/env python3
"""figures_test.py RIGSOUND ROOT: what verbs measure, as text and with --json; what a recorded blow does not tell."""
import csv
import io
import json
import math
import pathlib
import random
import re
import struct
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
DEMO, SHIFT = ROOT / 'config/rigs/demo.toml', ROOT / 'config/logs/shift.log'
BAR = ('--length', 0.5, '--diameter', 0.025)
RATE = 48000


def run(*words):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=600)


class Case(FolderCase):
    def done(self, *words):
        result = run(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def document(self, *words):
        return json.loads(self.done(*words, '--json'))  # one document, or it is an error

    def rows(self, *words):
        return list(csv.DictReader(io.StringIO(self.done(*words))))

    def same(self, rows, objects):
        """Every field of the text is in JSON under its name, and as many digits as the text has agree."""
        self.assertEqual(len(rows), len(objects))
        for row, entry in zip(rows, objects):
            for name, text in row.items():
                value = entry[name]
                if isinstance(value, (int, float)) and not isinstance(value, bool):
                    digits = len(text.partition('.')[2]) if 'e' not in text else 3
                    self.assertAlmostEqual(float(text), value, delta=0.6 * 10 ** -digits, msg=name)
                elif value is None:
                    self.assertIn(text, ('', 'inf'))
                else:
                    self.assertEqual(text, {True: 'yes', False: 'no'}.get(value, value))

    def write_wav(self, name, samples):
        data = struct.pack(f'<{len(samples)}f', *samples)
        form = struct.pack('<HHIIHH', 3, 1, RATE, 4 * RATE, 4, 32)
        body = b'WAVEfmt ' + struct.pack('<I', len(form)) + form + b'data' + struct.pack('<I', len(data)) + data
        path = self.folder / name
        path.write_bytes(b'RIFF' + struct.pack('<I', len(body)) + body)
        return path

    def blow(self, name, t60_s, length_s, frequencies, noise=1e-4):
        """0.2 s of noise, then all frequencies dying away together in it."""
        dice = random.Random(7)
        sound = [0.0] * int(length_s * RATE)
        for hz in frequencies:
            step = 10 ** (-3 / (t60_s * RATE)) * complex(math.cos(2 * math.pi * hz / RATE),
                                                         math.sin(2 * math.pi * hz / RATE))
            z = complex(dice.gauss(0, 1), dice.gauss(0, 1))
            for n in range(len(sound)):
                sound[n] += z.real
                z *= step
        peak = max(map(abs, sound))
        return self.write_wav(name, [noise * dice.gauss(0, 1) for _ in range(RATE // 5)] +
                              [0.5 * x / peak + noise * dice.gauss(0, 1) for x in sound])


def words_of(line):
    """`NAME key=value key=value` as a row."""
    return dict(re.findall(r'(\w+)=(\S*)', line))


class Json(Case):
    def test_every_verb_with_json_shows_it_in_an_example(self):
        verbs = re.findall(r'^  (\w+) ', run('--help').stdout, re.M)
        having = [verb for verb in verbs if re.search(r'^ *--json', run(verb, '--help').stdout, re.M)]
        for verb in having:
            self.assertRegex(run(verb, '--help').stdout, rf'rigsound {verb} .*--json', verb)
        for verb in ('analyze', 'background', 'bench', 'check', 'clicks', 'contrast', 'decode', 'pack', 'render', 'replay',
                     'simulate', 'tool', 'unpack'):
            self.assertIn(verb, having)

    def test_clicks_and_analyze(self):
        clips = ('simulate', '--out', self.folder, '--ids', 100, '--snr', 12)
        truth = self.document(*clips)['recordings']
        self.same([words_of('recording=' + self.done(*clips))], truth)
        clip = self.folder / 'c100_12.wav'
        found = self.document('clicks', clip)
        self.assertTrue(found['drilling_found'])
        self.assertGreater(len(found['clicks']), 10)
        self.same(self.rows('clicks', clip), found['clicks'])
        set_ = self.folder / 'set'
        figures = self.document('analyze', clip, '--out', set_)
        self.assertEqual((figures['notes'], figures['failures']), ([], []))
        line = self.done('analyze', clip, '--out', set_)
        self.assertTrue(line.startswith(figures['banks'][0]['bank'] + ' situation='))
        self.same([words_of(line)], figures['banks'])

    def test_clicks_of_a_recording_without_any(self):
        quiet = self.document('clicks', self.write_wav('quiet.wav', [0.001 * math.sin(n / 9) for n in range(2 * RATE)]))
        self.assertEqual((quiet['drilling_found'], quiet['clicks']), (False, []))
        self.assertTrue(quiet['reason'])

    def test_tool_and_string(self):
        self.same(self.rows('tool', *BAR), self.document('tool', *BAR)['modes'])
        string = ('tool', '--string', '--rods', 2, '--length', 3.66, '--diameter', 0.038)
        rows, figures = self.rows(*string), self.document(*string)
        some = [{name: text for name, text in row.items() if text} for row in rows]
        for row in some:
            if row['family'] == 'reflection':
                del row['family'], row['mode']
        self.same(some, figures['modes'] + figures['reflection'])

    def test_background(self):
        figures = self.document('background', '--formula', '--out', self.folder / 'set')
        self.assertIn(f'points={len(figures["points"])}', self.done('background', '--formula', '--out', self.folder / 'set'))

    def test_bench(self):
        layers = self.document('bench', '--seconds', 0.1)
        for layer in layers.values():
            self.assertIn('ns_a_sample', layer)

    def rig(self):
        path = self.folder / 'rig.toml'
        path.write_text(f'[sound]\nset = "{write_sound_set(self.folder / "set")}"\n')
        return path

    def test_check(self):
        rig = self.rig()
        text, figures = run('check', rig), self.document('check', rig)
        self.assertIs(figures['ok'], True)
        sounds = figures['sound_set']
        self.assertIn('sound set {path}: {banks} banks, {clicks} clicks, {rocks} rocks, {tools} tools, background: '
                      '{background}'.format(**sounds), text.stdout)
        self.assertEqual((sounds['banks'], sounds['clicks']), (5, 30))
        self.assertEqual(figures['audio']['rate_hz'], 48000)
        self.assertEqual(figures['not_delivered'], text.stderr.splitlines())
        self.assertEqual(run('check', rig, '--json', '--probe').returncode, 2)
        rig.write_text('[sound]\nset = "absent"\n')
        broken = run('check', rig, '--json')
        self.assertEqual((broken.returncode, broken.stdout), (1, ''))

    def test_render_and_decode(self):
        rig, states, out = self.rig(), self.folder / 'states.csv', self.folder / 'out.wav'
        states.write_text('time_s,signal,value\n0,engine_rpm,1500\n0.1,rattling,closed\n0.3,rattling,none\n')
        words = ('render', rig, '--states', states, '--out', out)
        figures, text = self.document(*words), dict(line.split() for line in self.done(*words).splitlines())
        self.assertEqual(figures['sha256'], text['sha256'])
        self.assertGreater(figures['realtime_factor'], 0)
        self.assertEqual(list(self.document(*words, '--no-hash')), ['realtime_factor'])
        self.same(self.rows('decode', DEMO, '--log', SHIFT), self.document('decode', DEMO, '--log', SHIFT)['changes'])

    def test_pack_and_unpack(self):
        set_, packed = write_sound_set(self.folder / 'set'), self.folder / 'set.rigset'
        figures = self.document('pack', set_, packed)
        self.assertEqual((figures['banks'], figures['bytes']), (5, packed.stat().st_size))
        self.same([words_of(self.done('pack', set_, packed))], [figures])
        self.assertEqual(self.document('unpack', packed, self.folder / 'copy'),
                         {'out': str(self.folder / 'copy'), 'banks': 5})


class RecordedBlow(Case):
    def modes(self):
        return [float(row['target_hz']) for row in self.rows('tool', *BAR)]

    def test_bounds_hold_the_true_decay(self):
        blow = self.blow('blow.wav', 0.2, 0.3, self.modes())
        plot = self.folder / 'blow.svg'
        result = run('tool', '--from', blow, *BAR, '--plot', plot)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('recorded, 95 %', plot.read_text())
        rows = [row for row in csv.DictReader(io.StringIO(result.stdout)) if row['t60_low_s']]
        self.assertGreater(len(rows), 10)
        right = [row for row in rows if float(row['t60_low_s']) <= 0.2 <= float(row['t60_high_s'])]
        self.assertGreaterEqual(len(right), 0.95 * len(rows))
        for row in rows:
            self.assertLess(float(row['t60_s']), 1.1 * float(row['t60_high_s']))
        self.assertRegex(result.stderr, r'decays told in \d+ of \d+ third octaves')
        figures = self.document('tool', '--from', blow, *BAR)
        self.same(list(csv.DictReader(io.StringIO(result.stdout))), figures['modes'])
        for band in figures['fit']['bands']:
            self.assertLessEqual(band['recorded_low_db'], band['recorded_db'])
            self.assertLessEqual(band['recorded_db'], band['recorded_high_db'] + 1)

    def test_what_is_too_short_is_refused_with_what_it_tells(self):
        set_ = self.folder / 'set'
        result = run('tool', '--from', self.blow('short.wav', 7.5, 0.162, self.modes()), *BAR, '--out', set_)
        self.assertEqual((result.returncode, result.stdout), (1, ''))
        self.assertRegex(result.stderr, r'^\S*short.wav: tells the decay of 0 third octaves: .*\(T60 at least [\d.]+ s at \d+ Hz\), '
                                        r'expected .* longer sound of one impact')
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertFalse(set_.exists())

    def test_partials_of_no_bar_are_no_steel(self):
        dice = random.Random(3)
        anything = [60 * 2 ** dice.uniform(0, 8) for _ in range(14)]
        result = run('tool', '--from', self.blow('bell.wav', 0.3, 0.5, anything))
        self.assertEqual(result.returncode, 1)
        self.assertIn('expected --length and --diameter', result.stderr)
        found = run('tool', '--from', self.blow('bar.wav', 0.3, 0.5, self.modes()))
        self.assertRegex(found.stderr, r'steel estimated from \d+ modes: 0\.(49|50)\d m x 2[45]\.\d mm')


unittest.main(argv=sys.argv[:1])
