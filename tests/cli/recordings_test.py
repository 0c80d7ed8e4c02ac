#!/usr/bin/env python3
"""recordings_test.py RIGSOUND: recordings that are silent or have many channels, in every verb that reads some."""
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_files import read_wav, strikes, write_wav

RIGSOUND = sys.argv[1]


class Case(FolderCase):
    def run_verb(self, *words):
        return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300)


class Silence(Case):
    def setUp(self):
        super().setUp()
        self.recording = write_wav(self.folder / 'silent.wav', [[0.0] * 22050], 44100)

    def test_clicks_finds_none_and_says_why(self):
        for more in ([], ['--no-denoise'], ['--method', 'paper']):
            result = self.run_verb('clicks', self.recording, *more)
            self.assertEqual((result.returncode, result.stdout), (0, 'time_s,amplitude\n'))
            self.assertEqual(result.stderr, f'{self.recording}: no drilling found: it is silent\n')

    def test_denoise_writes_silence_and_says_why(self):
        out, noise = self.folder / 'out.wav', self.folder / 'noise.wav'
        result = self.run_verb('denoise', self.recording, out, '--noise', noise)
        self.assertEqual((result.returncode, result.stdout), (0, ''))
        self.assertEqual(result.stderr, f'{self.recording}: no drilling found: it is silent\n')
        for file in (out, noise):
            self.assertEqual(read_wav(file.read_bytes()), (1, 44100, (0.0,) * 22050))

    def test_a_bank_or_a_steel_of_silence_is_an_error(self):
        for words in (['analyze', self.recording, '--out', self.folder / 'set'],
                      ['tool', '--from', self.recording],
                      ['background', self.recording, '--rpm', 800, '--out', self.folder / 'set']):
            result = self.run_verb(*words)
            self.assertEqual((result.returncode, result.stdout), (1, ''))
            self.assertRegex(result.stderr, r'silent\.wav: silent, no [a-z ]+ found in it; expected to hear some\n')


class ManyChannels(Case):
    def test_they_are_mixed_down_and_it_is_said_once_by_every_verb(self):
        sound = strikes(0.6)
        surround = write_wav(self.folder / 'six.wav', [[gain * x for x in sound] for gain in (1, 0.5, 0, 0.7, 0.3, 0.5)])
        mono = write_wav(self.folder / 'mono.wav', [[0.5 * x for x in sound]])
        said = f'{surround}: 6 channels mixed down to one\n'
        for words in (['clicks', surround], ['denoise', surround, self.folder / 'out.wav'],
                      ['analyze', surround, '--out', self.folder / 'set'], ['tool', '--from', surround],
                      ['background', surround, '--rpm', 1500, '--out', self.folder / 'set'],
                      ['background', surround, '--model', 'paper', '--resynth', self.folder / 'r.wav']):
            self.assertEqual(self.run_verb(*words).stderr.count(said), 1, words)
        channels, _, denoised = read_wav((self.folder / 'out.wav').read_bytes())
        self.assertEqual((channels, len(denoised)), (1, len(sound)))
        found = [self.run_verb('clicks', recording).stdout for recording in (surround, mono)]
        self.assertEqual(len(found[0].splitlines()), len(found[1].splitlines()))
        self.assertNotIn('mixed down', self.run_verb('clicks', mono).stderr)


unittest.main(argv=sys.argv[:1])
