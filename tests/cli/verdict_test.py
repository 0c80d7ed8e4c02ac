#!/usr/bin/env python3
"""verdict_test.py RIGSOUND: which stretches of a recording are drilling, and who decides that."""
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import unittest

from sound_files import strikes, write_wav

RIGSOUND = sys.argv[1]
RATE = 48000


def hiss(seconds, seed):
    dice = random.Random(seed)
    return [0.002 * dice.gauss(0, 1) for _ in range(int(seconds * RATE))]


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_verdict.'))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_verb(self, *words):
        return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=600)


class Stretches(Case):
    def setUp(self):
        super().setUp()
        drilling = [x + n for x, n in zip(strikes(3), hiss(3, 1))]
        self.recording = write_wav(self.folder / 'some.wav', [hiss(4, 2) + drilling + hiss(3, 3)])

    def test_windows_and_stretches_are_figures(self):
        figures = json.loads(self.run_verb('clicks', self.recording, '--json').stdout)
        self.assertEqual([(w['start_s'], w['end_s']) for w in figures['windows']], [(k, k + 2) for k in range(9)])
        for window in figures['windows']:
            self.assertTrue(0 <= window['probability'] <= 1)
            self.assertEqual(window['probability'] >= 0.5, 3 <= window['start_s'] <= 6, window)
        self.assertEqual(figures['drilling'], [{'start_s': 3, 'end_s': 8}])
        self.assertGreaterEqual(len(figures['clicks']), 73)
        for click in figures['clicks']:
            self.assertTrue(3.98 < click['time_s'] < 7.02, click)

    def test_they_are_told_unless_the_person_has_said_that_all_of_it_drills(self):
        told = f'{self.recording}: drilling in 3.0-8.0 of 10.0 s\n'
        self.assertEqual(self.run_verb('clicks', self.recording).stderr, told)
        unlabelled = self.run_verb('analyze', self.recording, '--out', self.folder / 'a')
        self.assertEqual((unlabelled.returncode, unlabelled.stderr.count(told)), (0, 1), unlabelled.stderr)
        said = self.run_verb('analyze', self.recording, '--out', self.folder / 'b', '--situation', 'normal')
        self.assertEqual((said.returncode, said.stderr.count(told)), (0, 0), said.stderr)

    def test_the_report_shows_the_probability(self):
        page = self.folder / 'report.html'
        self.run_verb('analyze', self.recording, '--out', self.folder / 'a', '--report', page)
        self.assertIn('Probability of drilling', page.read_text())


class Said(Case):
    def test_a_doubtful_recording_is_refused_unless_somebody_says_that_it_drills(self):
        noise = write_wav(self.folder / 'noise.wav', [hiss(2, 5)])
        words = ('analyze', noise, '--out', self.folder / 'set')
        refused = self.run_verb(*words)
        self.assertEqual(refused.returncode, 1)
        self.assertIn('no drilling found', refused.stderr)
        said = self.run_verb(*words, '--situation', 'overfeed')
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn('noise: warning: it may be no drilling: ', said.stderr)


unittest.main(argv=sys.argv[:1])
