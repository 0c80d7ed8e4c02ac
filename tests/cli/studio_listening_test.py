#!/usr/bin/env python3
"""studio_listening_test.py RIGSOUND: trials of a blind listening test, as the studio's server makes them."""
import cmath
import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

from studio_case import StudioCase, write_recording

ANALYSED = tempfile.TemporaryDirectory()
RATE = 48000
PAIR = ['denoised', 'synthesised']
KINDS = {'recorded', 'denoised', 'synthesised', 'anchor'}


def samples_of(wave):
    at = wave.index(b'data')
    return struct.unpack(f'<{struct.unpack_from("<I", wave, at + 4)[0] // 4}f', wave[at + 8:])


def level_db(samples, hz):
    """Of a bin as wide as a Hann window makes it."""
    turn, window = 2j * math.pi * hz / RATE, 2 * math.pi / len(samples)
    return 20 * math.log10(abs(sum(x * (1 - math.cos(window * n)) * cmath.exp(-turn * n) for n, x in enumerate(samples))) + 1e-30)


def setUpModule():
    """A bank and its recording: analysed once, copied for every test."""
    recordings = pathlib.Path(ANALYSED.name) / 'recordings'
    recordings.mkdir()
    write_recording(recordings / 'a.wav', 5)
    (recordings / 'a.txt').write_text('0.5\t4\tnormal\n')
    subprocess.run([sys.argv[1], 'analyze', recordings / 'a.wav', '--out', recordings.parent / 'new'], check=True, capture_output=True)


def tearDownModule():
    ANALYSED.cleanup()


class Trials(StudioCase):
    def setUp(self):
        super().setUp()
        for name in ('recordings', 'new'):
            shutil.copytree(pathlib.Path(ANALYSED.name) / name, self.folder / name, dirs_exist_ok=True)
        self.sound_set = self.folder / 'new'
        self.start()
        self.bank = self.get('/sound_set').json['banks'][0]['name']

    def post(self, **body):
        return self.ask('POST', '/listen/trials', {'test': 'abx', 'bank': self.bank, 'pair': PAIR, 'seconds': 1, **body})

    def open(self, **body):
        reply = self.post(**body)
        self.assertEqual(reply.status, 201, reply.body)
        return reply.json

    def sounds(self, trial):
        replies = {place: self.get(f'/listen/trials/{trial["id"]}/sounds/{place}') for place in trial['sounds']}
        self.assertEqual({r.headers['content-type'] for r in replies.values()}, {'audio/wav'})
        self.assertEqual({r.headers['cache-control'] for r in replies.values()}, {'no-store'})
        # Nothing but the samples differs.
        self.assertEqual(len({len(r.body) for r in replies.values()}), 1)
        self.assertEqual(len({tuple(sorted((k, v) for k, v in r.headers.items() if k != 'date')) for r in replies.values()}), 1)
        return {place: reply.body for place, reply in replies.items()}

    def end(self, trial):
        reply = self.ask('DELETE', f'/listen/trials/{trial["id"]}')
        self.assertEqual(reply.status, 200, reply.body)
        return reply.json

    def test_x_is_a_or_b_and_what_they_were_is_told_in_the_end(self):
        trial = self.open()
        self.assertEqual((set(trial), trial['sounds'], trial['seconds']), ({'id', 'seconds', 'sounds'}, ['a', 'b', 'x'], 1))
        heard = self.sounds(trial)
        self.assertEqual(len(samples_of(heard['a'])), RATE)
        self.assertNotEqual(heard['a'], heard['b'])
        told = self.end(trial)
        self.assertEqual(set(told['sounds'].values()), set(PAIR))
        for place in 'ab':
            self.assertEqual(heard['x'] == heard[place], told['sounds']['x'] == told['sounds'][place])
        self.assertEqual(self.ask('GET', f'/listen/trials/{trial["id"]}/sounds/a').status, 404)
        self.assertEqual(self.end(trial), told)

    def test_sounds_are_those_of_the_bank_at_the_gain_that_is_told(self):
        trial = self.open(from_s=1)
        heard, told = self.sounds(trial), self.end(trial)
        self.assertEqual(set(told['gain_db']), set(PAIR))
        for place in 'ab':
            kind = told['sounds'][place]
            whole, part = samples_of(self.get(f'/banks/{self.bank}/sound/{kind}').body), samples_of(heard[place])
            factor = 10 ** (told['gain_db'][kind] / 20)
            for n in range(RATE // 4, 3 * RATE // 4, 101):
                self.assertAlmostEqual(part[n], factor * whole[RATE + n], delta=1e-6)
            self.assertEqual((part[0], part[-1]), (0, 0))
            self.assertLess(max(map(abs, part)), 10 ** (-1 / 20) + 1e-4)

    def test_a_rating_has_a_hidden_reference_and_an_anchor(self):
        trial = self.open(test='rating')
        self.assertEqual(trial['sounds'], ['reference', '1', '2', '3', '4'])
        heard, told = self.sounds(trial), self.end(trial)['sounds']
        self.assertEqual({told[n] for n in '1234'}, KINDS)
        self.assertEqual(told['reference'], 'recorded')
        of = {told[n]: heard[n] for n in '1234'}
        self.assertEqual(of['recorded'], heard['reference'])
        recorded, anchor = samples_of(of['recorded']), samples_of(of['anchor'])
        for hz in (5000, 9000, 15000):
            self.assertLess(level_db(anchor, hz), level_db(recorded, hz) - 40)
        self.assertGreater(level_db(anchor, 2292), level_db(recorded, 2292) - 3)

    def test_orders_are_random(self):
        # Chance of an honest shuffle to fail: 4 of 2^40, and 4 (3/4)^80 < 1e-9.
        abx = [self.end(self.open())['sounds'] for _ in range(40)]
        self.assertEqual({told['a'] for told in abx}, set(PAIR))
        self.assertEqual({told['x'] == told['a'] for told in abx}, {True, False})
        rated = [self.end(self.open(test='rating'))['sounds'] for _ in range(80)]
        self.assertEqual({n for told in rated for n in '1234' if told[n] == 'recorded'}, set('1234'))

    def test_trials_are_forgotten_one_after_the_other(self):
        first = self.open()
        for _ in range(8):
            self.open()
        self.assertEqual(self.ask('GET', f'/listen/trials/{first["id"]}/sounds/a').status, 404)
        self.assertEqual(set(self.end(first)['sounds']), {'a', 'b', 'x'})
        for _ in range(56):
            self.open()
        self.assertEqual(self.ask('DELETE', f'/listen/trials/{first["id"]}').status, 404)

    def test_a_trial_that_cannot_be_made_is_refused(self):
        for status, change in ((400, {'test': 'dance'}), (400, {'test': 7}), (400, {'pair': ['recorded']}), (400, {'pair': ['recorded', 'recorded']}),
                               (400, {'pair': ['recorded', '../secret']}), (400, {'pair': 'recorded'}), (400, {'pair': None}),
                               (400, {'from_s': -1}), (400, {'from_s': 1e308}), (400, {'from_s': 'x'}), (400, {'from_s': 3.2}), (400, {'seconds': 0}),
                               (400, {'seconds': 1e9}), (404, {'bank': '..'}), (404, {'bank': '../new'}), (404, {'bank': 'none'}), (404, {'bank': ''}),
                               (400, {'bank': 3})):
            reply = self.post(**change)
            self.assertEqual((reply.status, len(reply.json['error'].splitlines())), (status, 1), (change, reply.body))
        # Shorter than asked for where the part ends.
        self.assertAlmostEqual(self.open(from_s=1, seconds=20)['seconds'], 2.5, delta=0.1)
        self.assertEqual(self.get('/state').status, 200)

    def test_what_is_no_trial_or_sound_is_told(self):
        trial = self.open()
        for method, path in (('GET', 'none/sounds/a'), ('GET', f'{trial["id"]}/sounds/c'), ('GET', f'{trial["id"]}/sounds/denoised'),
                             ('GET', f'{trial["id"]}/sounds/..'), ('DELETE', 'none'), ('DELETE', '..')):
            self.assertEqual(self.ask(method, f'/listen/trials/{path}').status, 404, path)
        self.assertEqual(self.ask('GET', f'/listen/trials/{trial["id"]}').status, 405)

    def test_only_the_page_may_ask(self):
        trial = self.open()
        self.assertEqual(self.ask('DELETE', f'/listen/trials/{trial["id"]}', Origin='http://evil.example').status, 403)
        self.assertEqual(self.ask('GET', f'/listen/trials/{trial["id"]}/sounds/a', X_Rigsound_Token=None).status, 401)
        self.assertEqual(set(self.end(trial)['sounds']), {'a', 'b', 'x'})

    def test_without_its_recording_a_bank_has_no_trials(self):
        write_recording(self.recordings / 'a.wav', 5, seed=2)
        reply = self.post()
        self.assertEqual((reply.status, 'recording has changed' in reply.json['error']), (404, True), reply.body)
        (self.recordings / 'a.wav').unlink()
        reply = self.post()
        self.assertEqual((reply.status, 'not in the folder' in reply.json['error']), (404, True), reply.body)


unittest.main(argv=sys.argv[:1])
