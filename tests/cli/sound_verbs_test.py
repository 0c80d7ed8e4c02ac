#!/usr/bin/env python3
"""sound_verbs_test.py RIGSOUND: `contrast` and `tool --string` as a user calls them."""
import csv
import io
import json
import math
import shutil
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_set import SITUATIONS, write_bank, write_sound_set

RIGSOUND = sys.argv[1]
SPEED, DENSITY = 5200, 7850  # of sound in steel, m/s; kg/m^3
STRING = ('tool', '--string', '--rods', '6', '--length', '3.66', '--diameter', '0.038')


def run(*words):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=600)


class Case(FolderCase):
    def rows(self, *words):
        result = run(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return list(csv.DictReader(io.StringIO(result.stdout)))

    def refused(self, code, text, *words):
        result = run(*words)
        self.assertEqual((result.returncode, result.stdout), (code, ''), result.stderr)
        self.assertIn(text, result.stderr)


class DrillString(Case):
    def family(self, name, *words):
        return [row for row in self.rows(*STRING, *words) if row['family'] == name]

    def test_rods_without_joints_are_a_comb(self):
        comb = self.family('longitudinal')
        self.assertEqual(len(comb), int(6000 / (SPEED / (2 * 6 * 3.66))))
        for row in comb:
            self.assertAlmostEqual(float(row['target_hz']), int(row['mode']) * SPEED / (2 * 6 * 3.66), places=2)
            self.assertLess(abs(float(row['error_cents'])), 2)

    def test_exposed_rod(self):
        whole, half = self.family('bending'), self.family('bending', '--exposed', 1.83)
        self.assertAlmostEqual(float(whole[0]['target_hz']), 13, delta=0.5)
        self.assertAlmostEqual(float(half[0]['target_hz']) / float(whole[0]['target_hz']), 4, delta=0.02)
        for row in whole + half:
            self.assertLess(float(row['t60_pressed_s']), float(row['t60_s']))

    def test_bit_on_named_rock(self):
        impedance = math.pi / 4 * 0.038 ** 2 * DENSITY * SPEED
        for row in self.family('reflection', '--rock', 'hard'):
            x = float(row['pulse_s']) / (impedance / 5e8)
            self.assertAlmostEqual(float(row['x']), x, places=4)
            r = 1 - 4 * (1 - math.exp(-x)) / x + 2 * (1 - math.exp(-2 * x)) / x
            self.assertAlmostEqual(float(row['target_share']), r, places=4)
        self.refused(1, 'did you mean hard?', *STRING, '--rock', 'hadr')

    def test_sound_set_gets_the_string_and_gives_the_rock(self):
        folder = write_sound_set(self.folder / 'set')
        index = folder / 'soundset.toml'
        index.write_text(index.read_text() + '[[rock]]\nname = "gneiss"\nstiffness = 3e8\n')
        plot = self.folder / 'string.svg'
        self.rows(*STRING, '--rock', 'gneiss', '--out', folder, '--name', 'six', '--plot', plot)
        self.assertIn('kind = "string"', index.read_text())
        self.assertEqual(json.loads((folder / 'tools/six.json').read_text())['rods'], 6)
        self.assertIn('gneiss', plot.read_text())

    def test_json_holds_what_csv_does(self):
        figures = json.loads(run(*STRING, '--json').stdout)
        self.assertEqual(len(figures['modes']) + len(figures['reflection']), len(self.rows(*STRING)))
        self.assertEqual(figures['rock']['name'], 'medium')

    def test_options_of_a_string_need_one(self):
        self.refused(2, '--string', 'tool', '--rods', 6, '--length', 3.66, '--diameter', 0.038)
        self.refused(2, '--string', *STRING, '--from', 'impact.wav')
        self.refused(1, 'rod_length_m: is 25 m, expected 0.6...6.4 m',
                     'tool', '--string', '--length', 25, '--diameter', 0.038)


class Contrast(Case):
    def rig(self, folder):
        path = self.folder / 'rig.toml'
        path.write_text(f'[sound]\nset = "{folder}"\n')
        return path

    def contrast(self, folder, *words):
        result = run('contrast', self.rig(folder), '--seconds', 4, '--runs', 2, *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def test_banks_that_differ_are_told_apart(self):
        page = self.folder / 'page.html'
        result = self.contrast(write_sound_set(self.folder / 'set'), '--json', '--report', page)
        figures = json.loads(result.stdout)
        pairs = {frozenset((p['first'], p['second'])): p for p in figures['situations']['pairs']}
        self.assertEqual(len(pairs), 10)
        self.assertTrue(pairs[frozenset(('normal', 'overfeed'))]['told_apart'])
        rates = {s['name']: s['rate_hz'] for s in figures['situations']['sounds']}
        for i, situation in enumerate(SITUATIONS):
            self.assertAlmostEqual(rates[situation.replace('_', ' ')], 30 + 3 * i, delta=0.6)
        heard = figures['heard_from']
        self.assertLess(heard['underfeed']['feed_bar'], 90)
        self.assertGreater(heard['overfeed']['feed_bar'], 90)
        self.assertEqual(result.stderr, '')
        html = page.read_text()
        self.assertIn('Can it be heard?', html)
        self.assertIn('Dots: measured at one feed.', html)
        self.assertEqual(html.count('<svg'), html.count('role="img" aria-label="'))
        self.assertIn('% right; 50 is guessing over feed pressure, bar', html)

    def test_rods_and_rocks_are_compared_when_the_set_knows_several(self):
        folder = write_sound_set(self.folder / 'set')
        index = folder / 'soundset.toml'
        index.write_text(index.read_text() + '[[rock]]\nname = "marl"\n[[rock]]\nname = "gneiss"\n' + ''.join(
            f'[[bank]]\nname = "{name}"\nsituation = "normal"\nrods = {rods}\n' for name, rods in
            (('normal', 1), ('overfeed', 6))))
        result = self.contrast(folder, '--json')
        figures = json.loads(result.stdout)
        told = {(p['first'], p['second']): p['told_apart'] for p in figures['rods']['pairs']}
        self.assertEqual(told, {('1 rod', '6 rods'): True, ('1 rod', '20 rods'): True, ('6 rods', '20 rods'): False})
        self.assertEqual([p['told_apart'] for p in figures['rocks']['pairs']], [False])
        self.assertIn('warning: 20 rods cannot be told from 6 rods', result.stderr)
        self.assertIn('warning: gneiss cannot be told from marl', result.stderr)

    def test_a_copied_bank_is_named(self):
        folder = write_sound_set(self.folder / 'set')
        shutil.rmtree(folder / 'banks/overfeed')
        write_bank(folder / 'banks/overfeed', 48000, 30, 900)
        result = self.contrast(folder)
        self.assertRegex(result.stderr, r'(?m)^\S*set: warning: overfeed cannot be told from normal: .*played from banks normal and overfeed$')
        self.assertIn('Overfeed cannot be heard', result.stdout)

    def test_what_is_wrong_is_told_before_the_work(self):
        self.refused(1, 'there is no folder', 'contrast', self.rig('absent'))
        rig = self.rig(write_sound_set(self.folder / 'set'))
        self.refused(2, '--boom: is left, expected ', 'contrast', rig, '--boom', 'left')
        self.refused(1, 'expected another name for the output', 'contrast', rig, '--report', rig)
        self.refused(3, 'absent', 'contrast', rig, '--report', self.folder / 'absent/page.html')


unittest.main(argv=sys.argv[:1])
