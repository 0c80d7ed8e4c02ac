#!/usr/bin/env python3
"""endings_test.py RIGSOUND: the ending of an output's name is its format, or is refused with those that go."""
import hashlib
import struct
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_files import read_sound, strikes, write_wav
from sound_set import write_bank, write_sound_set

RIGSOUND = sys.argv[1]
FLAC24, OGG_VORBIS, WAV_FLOAT = 0x170003, 0x200060, 0x010006  # as libsndfile numbers them


class Endings(FolderCase):
    def setUp(self):
        super().setUp()
        at = self.folder
        write_sound_set(at / 'set')
        self.rig = at / 'rig.toml'
        self.rig.write_text('[sound]\nset = "set"\n[[udp]]\naddress = "127.0.0.1:45123"\n')
        self.states = at / 'states.csv'
        self.states.write_text('time_s,signal,value\n0,engine_rpm,1500\n0.1,feed_pressure_bar,90\n1,feed_pressure_bar,0\n')
        self.recording = write_wav(at / 'in.wav', [strikes(0.6)], 44100)
        self.bank = at / 'set/banks/normal'

    def run_verb(self, *words):
        return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=120)

    def sound(self, *words):
        result = self.run_verb(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def test_every_sound_goes_into_each_format(self):
        for name, words in (('render', ['render', self.rig, '--states', self.states, '--out']),
                            ('resynth', ['resynth', self.bank, '--seconds', 1]), ('denoise', ['denoise', self.recording])):
            _, rate, exact = read_sound(self.made(name, words, '.wav', WAV_FLOAT))
            kind, other_rate, same = read_sound(self.made(name, words, '.FLAC', FLAC24))
            self.assertEqual((rate, len(exact)), (other_rate, len(same)))
            self.assertGreater(max(map(abs, exact)), 0.01)
            self.assertLess(max(abs(a - b) for a, b in zip(exact, same)), 2 ** -23)
            _, other_rate, alike = read_sound(self.made(name, words, '.ogg', OGG_VORBIS))
            self.assertEqual((rate, len(exact)), (other_rate, len(alike)))
            error, power = sum((a - b) ** 2 for a, b in zip(exact, alike)), sum(a * a for a in exact)
            self.assertLess(error, 0.1 * power, name)

    def made(self, name, words, ending, kind):
        file = self.folder / (name + ending)
        self.sound(*words[:2], file, *words[2:]) if words[0] == 'resynth' else self.sound(*words, file)
        self.assertEqual(read_sound(file)[0], kind)
        return file

    def test_the_sha256_is_that_of_the_floats_whatever_the_file(self):
        said = [self.sound('render', self.rig, '--states', self.states, '--out', self.folder / f'a{ending}').stdout.split()[1]
                for ending in ('.wav', '.flac', '.ogg')]
        samples = read_sound(self.folder / 'a.wav')[2]
        self.assertEqual(said, [hashlib.sha256(struct.pack(f'<{len(samples)}f', *samples)).hexdigest()] * 3)

    def test_what_a_format_cannot_hold_is_clipped_and_said(self):
        loud = write_bank(self.folder / 'loud', 48000, 30, 900, gain_db=24.0) or self.folder / 'loud'
        wav, flac = self.folder / 'loud.wav', self.folder / 'loud.flac'
        self.assertEqual(self.sound('resynth', loud, wav, '--seconds', 1, '--gain-db', 24).stderr, '')
        exact = read_sound(wav)[2]
        over = sum(abs(x) > 1 for x in exact)
        self.assertGreater(over, 10)
        self.assertEqual(self.sound('resynth', loud, flac, '--seconds', 1, '--gain-db', 24).stderr,
                         f'{flac}: {over} samples over full scale are clipped; a file that ends in .wav keeps them\n')
        for x, held in zip(exact, read_sound(flac)[2]):
            self.assertAlmostEqual(max(-1, min(1, x)), held, delta=2 ** -22)

    def test_other_endings_are_refused_before_the_work_with_those_that_go(self):
        sound, picture, page = '.wav, .flac or .ogg', '.svg', '.html or .htm'
        new = lambda name: self.folder / name
        for words, endings in (
                (['render', self.rig, '--states', self.states, '--out', new('a.mp3')], sound),
                (['render', self.rig, '--states', self.states, '--out', new('wav')], sound),
                (['resynth', self.bank, new('a.aiff'), '--seconds', 1], sound),
                (['denoise', self.recording, new('a.opus')], sound),
                (['denoise', self.recording, new('a.wav'), '--noise', new('b')], sound),
                (['background', self.recording, '--rpm', 800, '--resynth', new('a.caf')], sound),
                (['background', self.recording, '--rpm', 800, '--resynth', new('a.wav'), '--plot', new('a.png')], picture),
                (['tool', '--length', 0.5, '--diameter', 0.025, '--plot', new('a.pdf')], picture),
                (['timeline', new('a.svg'), '--wav', self.recording, '--states', self.states], '.png'),
                (['contrast', self.rig, '--report', new('a.pdf')], page),
                (['analyze', self.recording, '--out', new('new'), '--report', new('a.txt')], page),
                (['record', self.rig, '--out', new('a.asc'), '--seconds', 1], '.pcap')):
            before = set(self.folder.rglob('*'))
            result = self.run_verb(*words)
            self.assertEqual((result.returncode, result.stdout), (2, ''), words)
            self.assertIn(f'expected a name that ends in {endings}\n', result.stderr)
            self.assertEqual(set(self.folder.rglob('*')), before, words)


unittest.main(argv=sys.argv[:1])
