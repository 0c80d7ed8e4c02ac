#!/usr/bin/env python3
"""studio_banks_test.py RIGSOUND: analyses and the sound set that the studio's page makes and refines."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest
import zlib

from studio_case import PATIENCE_S, StudioCase, write_recording

RIGSOUND = sys.argv[1]


def bytes_of_text(text):
    """The inverse of page_text(): seven bits a letter."""
    bits = ''
    for letter in map(ord, text):
        which = (letter - 0x100) // 128
        bits += f'{letter:07b}' if letter < 0x80 else f'{(0, 13, 60)[which % 3]:07b}' + (f'{letter % 128:07b}' if which < 3 else '')
    return bytes(int(bits[n:n + 8], 2) for n in range(0, len(bits) // 8 * 8, 8))


class Analyses(StudioCase):
    def setUp(self):
        super().setUp()
        write_recording(self.recordings / 'a.wav', 9)
        (self.recordings / 'a.txt').write_text('0.5\t4\tnormal\n4.5\t8.5\toverfeed\n')
        self.sound_set = self.folder / 'new'
        self.start()
        self.id = self.recording_id('a.wav')

    def job(self, **body):
        reply = self.ask('POST', '/jobs', body)
        self.assertEqual(reply.status, 202, reply.body)
        return reply.json['id']

    def ended(self, job):
        end = time.monotonic() + 10 * PATIENCE_S
        while time.monotonic() < end:
            state = self.get(f'/jobs/{job}').json
            if state['state'] not in ('waiting', 'running'):
                return state
            time.sleep(0.1)
        self.fail('no end')

    def child(self):
        for _ in range(PATIENCE_S * 20):
            found = subprocess.run(['pgrep', '-P', str(self.server.pid)], capture_output=True, text=True).stdout.split()
            if found:
                return int(found[0])
            time.sleep(0.05)
        self.fail('no child')

    def test_chosen_parts_become_banks(self):
        job = self.job(kind='analyze', recording=self.id, parts=[{'from_s': 0.5, 'to_s': 4}])
        state = self.ended(job)
        self.assertEqual(state['state'], 'done', state)
        self.assertEqual([b['bank'] for b in state['result']['banks']], ['a_00500ms'])
        self.assertAlmostEqual(state['result']['banks'][0]['rate_hz'], 24, delta=0.5)
        self.assertEqual((state['progress'], state['done'], state['error']), (1, ['a_00500ms'], None))
        bank, = self.get('/sound_set').json['banks']
        self.assertEqual((bank['name'], bank['recording'], bank['from_s'], bank['to_s'], bank['refined']),
                         ('a_00500ms', self.id, 0.5, 4, False))
        figures = self.get('/banks/a_00500ms').json
        self.assertEqual(figures['warnings'], [])
        self.assertAlmostEqual(sum(figures['gaps']['share']), 1, places=6)
        lengths = {which: len(self.get(f'/banks/a_00500ms/sound/{which}').body) for which in ('recorded', 'denoised', 'synthesised')}
        self.assertEqual(len(set(lengths.values())), 1, lengths)
        events = [json.loads(line) for line in self.get(f'/jobs/{job}/events').body.splitlines()]
        self.assertEqual(events[-1]['state'], 'done')

    def test_an_analysis_that_is_killed_takes_nothing_with_it(self):
        job = self.job(kind='analyze', recording=self.id)
        os.kill(self.child(), signal.SIGKILL)
        state = self.ended(job)
        self.assertEqual((state['state'], 'killed' in state['error']), ('failed', True))
        self.assertEqual(self.ask('GET', '/state').status, 200)

    def test_an_analysis_that_is_stopped_leaves_nothing(self):
        job = self.job(kind='analyze', recording=self.id)
        child = self.child()
        self.assertEqual(self.ask('DELETE', f'/jobs/{job}').status, 200)
        self.assertEqual(self.ended(job)['state'], 'stopped')
        self.assertFalse(pathlib.Path(f'/proc/{child}').exists())
        self.assertEqual([p.name for p in self.folder.rglob('.*') if p.name != '.cache'], [])

    def test_an_analysis_ends_with_its_server(self):
        self.job(kind='analyze', recording=self.id)
        child = self.child()
        self.server.kill()
        self.server.wait()
        for _ in range(PATIENCE_S * 20):
            if not pathlib.Path(f'/proc/{child}/exe').exists():
                return
            time.sleep(0.05)
        self.fail('it goes on')

    def test_work_that_makes_no_sense_is_refused(self):
        for status, body in ((400, {'kind': 'dance'}), (400, {}), (404, {'kind': 'analyze', 'recording': 'none'}),
                             (409, {'kind': 'analyze', 'recording': self.id, 'parts': [{'from_s': 1, 'to_s': 2}]}),
                             (400, {'kind': 'analyze', 'recording': self.id, 'clicks': 1})):
            self.assertEqual(self.ask('POST', '/jobs', body).status, status, body)
        self.assertEqual(self.ask('GET', '/jobs/none').status, 404)


class SoundSet(StudioCase):
    def setUp(self):
        super().setUp()
        self.start()

    def resynth(self):
        out = self.folder / 'out.wav'
        result = subprocess.run([RIGSOUND, 'resynth', self.sound_set / 'banks/normal', out, '--seconds', '2'], capture_output=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return out.read_bytes()

    def test_a_refined_value_changes_what_resynth_plays_and_can_be_taken_back(self):
        as_analysed, stored = self.resynth(), (self.sound_set / 'banks/normal/bank.json').read_bytes()
        bank = self.get('/banks/normal').json
        self.assertEqual((bank['refinement']['version'], len(bank['clicks'])), ('absent', 6))
        reply = self.ask('PUT', '/banks/normal/refinement', {
            'version': 'absent', 'controls': {'mean_frequency_hz': 45, 'decay_factor': 2}, 'dropped': [1, 4], 'trim_db': -3})
        self.assertEqual(reply.status, 200, reply.body)
        self.assertNotEqual(self.resynth(), as_analysed)
        self.assertEqual((self.sound_set / 'banks/normal/bank.json').read_bytes(), stored)
        again = self.get('/banks/normal').json
        self.assertEqual((again['refinement']['dropped'], again['refinement']['controls']['mean_frequency_hz']), ([1, 4], 45))
        self.assertEqual(again['statistics'], bank['statistics'])
        self.assertEqual(self.ask('DELETE', '/banks/normal/refinement?version=absent').status, 409)
        self.assertEqual(self.ask('DELETE', f'/banks/normal/refinement?version={reply.json["version"]}').status, 200)
        self.assertEqual(self.resynth(), as_analysed)

    def test_rate_and_level_are_those_asked_for(self):
        out = {}
        for rate in (0, 45):
            self.ask('PUT', '/banks/normal/refinement', {
                'version': self.get('/banks/normal').json['refinement']['version'], 'controls': {'mean_frequency_hz': rate}})
            impacts = self.folder / 'impacts.csv'
            subprocess.run([RIGSOUND, 'resynth', self.sound_set / 'banks/normal', self.folder / 'out.wav', '--seconds', '20',
                            '--impacts', impacts], check=True)
            out[rate] = (len(impacts.read_text().splitlines()) - 1) / 20
        self.assertAlmostEqual(out[0], 30, delta=0.5)
        self.assertAlmostEqual(out[45], 45, delta=0.7)

    def test_a_refinement_that_cannot_be_played_is_refused(self):
        for change in ({'dropped': [0, 1, 2, 3, 4]}, {'dropped': [9]}, {'dropped': [-1]}, {'trim_db': 90}, {'controls': {'volume': 1}},
                       {'controls': {'decay_factor': 0}}, {'controls': {'decay_factor': 'x'}}):
            self.assertEqual(self.ask('PUT', '/banks/normal/refinement', {'version': 'absent', **change}).status, 400, change)
            self.assertFalse((self.sound_set / 'banks/normal/refined.json').exists())

    def test_packed_sets(self):
        self.assertEqual(self.get('/sound_set.rigset').body[:6], b'RIGSET')
        for query in ('?rig=1', '?bank=normal', '?bank=normal&clicks=0,2'):
            (self.folder / 'a.rigset').write_bytes(self.get('/sound_set.rigset' + query).body)
            result = subprocess.run([RIGSOUND, 'unpack', self.folder / 'a.rigset', self.folder / f'unpacked{len(query)}'], capture_output=True)
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.ask('GET', '/sound_set.rigset?bank=none').status, 404)
        self.assertEqual(self.ask('GET', '/sound_set.rigset?bank=normal&clicks=9').status, 400)

    def test_the_rig_knows_the_rocks_by_name(self):
        self.assertEqual(self.get('/rig').json['rocks'], [])
        with open(self.sound_set / 'soundset.toml', 'a') as index:
            index.write('[[rock]]\nname = "soft"\n[[rock]]\nname = "hard"\nstiffness = 5e8\n')
        self.assertEqual(self.get('/rig').json['rocks'], ['soft', 'hard'])

    def test_a_set_that_goes_while_it_is_shown_is_told(self):
        (self.sound_set / 'banks/normal/clicks.wav').unlink()
        found = self.get('/sound_set').json
        self.assertEqual((len(found['banks']), len(found['problems'])), (4, 1))
        self.assertEqual(self.ask('GET', '/banks/normal').status, 422)

    def test_results_of_listening_tests_are_never_overwritten(self):
        names = {self.ask('POST', '/listen/results', {'csv': f'trial,answer\n{i},a\n'}).json['name'] for i in range(3)}
        self.assertEqual(len(names), 3)
        self.assertEqual({r['name'] for r in self.get('/listen/results').json['results']}, names)
        self.assertIn(b'trial,answer', self.get(f'/listen/results/{names.pop()}').body)

    def test_export_is_one_file(self):
        (self.pages / 'engine.wasm').write_bytes(b'\0asm')
        (self.pages / 'export.html').write_text('<a>RIGSOUND_RIG_JSON</a><b>RIGSOUND_RIGSET</b><i>RIGSOUND_ENGINE</i>')
        page = self.folder / 'page.html'
        result = subprocess.run([RIGSOUND, 'studio', self.sound_set, '--pages', self.pages, '--export', page], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        text = page.read_bytes().decode()
        self.assertNotIn('RIGSOUND_', text)
        self.assertFalse(set('\0\r') & set(text))
        self.assertEqual(zlib.decompress(bytes_of_text(text[text.index('<i>') + 3:text.index('</i>')])), b'\0asm')
        planes = zlib.decompress(bytes_of_text(text[text.index('<b>') + 3:text.index('</b>')]))
        size = len(planes) // 4
        packed = bytearray(planes)
        for plane in range(4):
            packed[plane:4 * size:4] = planes[plane * size:(plane + 1) * size]
        (self.folder / 'out.rigset').write_bytes(packed)
        result = subprocess.run([RIGSOUND, 'unpack', self.folder / 'out.rigset', self.folder / 'unpacked'], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ''))


unittest.main(argv=sys.argv[:1])
