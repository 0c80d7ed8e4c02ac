#!/usr/bin/env python3
"""studio_test.py RIGSOUND SHIM: the server of `rigsound studio` lets in its own page alone and keeps people's files.

SHIM (`faults/failing_calls.cpp`) lets a call on a file fail, as on a full disk.
"""
import json
import os
import pathlib
import signal
import socket
import struct
import subprocess
import sys
import time
import unittest

from studio_case import PATIENCE_S, StudioCase, write_recording

RIGSOUND, SHIM = sys.argv[1:3]


class WhoMayAsk(StudioCase):
    def setUp(self):
        super().setUp()
        self.start()

    def test_the_page_needs_no_token_and_everything_else_does(self):
        here = {'Host': f'127.0.0.1:{self.port}'}
        page = self.raw('GET', '/', headers=here)
        self.assertEqual((page.status, b'<title>studio</title>' in page.body), (200, True))
        self.assertEqual(self.raw('GET', '/app.js', headers=here).headers['content-type'], 'text/javascript; charset=utf-8')
        for token in (None, '', 'x' * 32, self.token[:-1], self.token + '0'):
            self.assertEqual(self.ask('GET', '/state', X_Rigsound_Token=token).status, 401, token)
        self.assertEqual(self.ask('GET', '/state').status, 200)

    def test_a_host_that_is_another_is_refused(self):
        for host in (None, 'evil.example', f'evil.example:{self.port}', '127.0.0.1', f'127.0.0.1:{self.port + 1}',
                     f'127.0.0.1.evil.example:{self.port}'):
            for path in ('/', '/api/v1/state'):
                self.assertEqual(self.raw('GET', path, headers={
                    k: v for k, v in {'Host': host, 'X-Rigsound-Token': self.token}.items() if v is not None}).status, 403, host)
        self.assertEqual(self.ask('GET', '/state', Host=f'localhost:{self.port}').status, 200)

    def test_an_origin_that_is_another_page_is_refused(self):
        for origin in ('http://evil.example', 'null', f'https://127.0.0.1:{self.port}', f'http://127.0.0.1:{self.port + 1}'):
            for method in ('GET', 'POST'):
                self.assertEqual(self.ask(method, '/jobs', {} if method == 'POST' else None, Origin=origin).status, 403, origin)
        self.assertEqual(self.ask('GET', '/state', Origin=f'http://127.0.0.1:{self.port}').status, 200)
        self.assertEqual(self.ask('POST', '/jobs', {}, Sec_Fetch_Site='cross-site').status, 403)

    def test_headers_keep_the_page_to_itself(self):
        page = self.raw('GET', '/', headers={'Host': f'127.0.0.1:{self.port}'})
        policy = page.headers['content-security-policy']
        self.assertNotIn('unsafe-inline', policy)
        self.assertNotIn("'unsafe-eval'", policy)
        self.assertIn("default-src 'none'", policy)
        self.assertIn("frame-ancestors 'none'", policy)
        self.assertEqual(page.headers['x-content-type-options'], 'nosniff')

    def test_requests_are_bounded(self):
        self.assertEqual(self.ask('POST', '/jobs', {'kind': 'x' * (1 << 20)}).status, 413)
        self.assertEqual(self.ask('POST', '/listen/results', {'csv': 'x' * (1 << 20)}).status, 201)
        self.assertEqual(self.ask('POST', '/listen/results', {'csv': 'x' * (4 << 20)}).status, 413)
        headers = {'Host': f'127.0.0.1:{self.port}', 'X-Rigsound-Token': self.token, 'Content-Type': 'application/json'}
        deep = b'{"kind":' + b'[' * 100000
        self.assertEqual(self.raw('POST', '/api/v1/jobs', deep, headers).status, 400)
        self.assertEqual(self.raw('POST', '/api/v1/jobs', b'kind', headers).status, 400)
        self.assertEqual(self.raw('POST', '/api/v1/jobs', b'{}', {**headers, 'Content-Type': 'text/plain'}).status, 415)
        self.assertEqual(self.raw('POST', '/api/v1/jobs', b'{}', {**headers, 'Content-Encoding': 'gzip'}).status, 415)
        with socket.create_connection(('127.0.0.1', self.port), PATIENCE_S) as endless:
            endless.sendall((f'POST /api/v1/jobs HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nX-Rigsound-Token: {self.token}\r\n'
                             'Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n').encode())
            self.assertIn(b' 411 ', endless.recv(4096).split(b'\r\n')[0])
        self.assertEqual(self.raw('GET', '/' + 'a' * 20000, headers=headers).status, 414)
        self.assertEqual(self.ask('GET', '/state').status, 200)

    def test_only_this_machine_is_answered(self):
        listening = [line.split()[1] for line in pathlib.Path('/proc/net/tcp').read_text().splitlines()[1:]
                     if line.split()[3] == '0A']
        self.assertIn(f'0100007F:{self.port:04X}', listening)
        self.assertNotIn(f'00000000:{self.port:04X}', listening)


class WhatMayBeRead(StudioCase):
    def setUp(self):
        super().setUp()
        self.secret = self.folder / 'secret.wav'
        write_recording(self.secret, 1)
        write_recording(self.recordings / 'a.wav', 2)
        (self.recordings / 'link.wav').symlink_to(self.secret)
        (self.recordings / 'a.txt').symlink_to(self.folder / 'elsewhere.txt')
        (self.pages / 'out.js').symlink_to('/etc/hostname')
        (self.sound_set / 'banks/away').symlink_to(self.folder)
        (self.sound_set / 'tools').symlink_to(self.folder)
        self.start()

    def test_paths_and_links_that_leave_the_folders_lead_nowhere(self):
        here = {'Host': f'127.0.0.1:{self.port}', 'X-Rigsound-Token': self.token}
        for path in ('/../secret.wav', '/%2e%2e/secret.wav', '/..%2fsecret.wav', '/app.js/../../secret.wav', '/out.js',
                     '//etc/passwd', '/%00'):
            self.assertEqual(self.raw('GET', path, headers=here).status, 404, path)
        state = self.get('/state').json
        self.assertEqual([r['name'] for r in state['recordings']], ['a.wav'])
        for bank in ('..', '%2e%2e', '..%2f..%2fsecret.wav', 'away', '.', 'none'):
            self.assertIn(self.ask('GET', f'/banks/{bank}').status, (403, 404), bank)
        for result in ('..%2fsoundset.toml', '..'):
            self.assertEqual(self.ask('GET', f'/listen/results/{result}').status, 404)

    def test_a_label_track_that_is_a_link_is_not_written(self):
        recording = self.recording_id_of_first()
        reply = self.ask('PUT', f'/recordings/{recording}/labels', {
            'version': 'absent', 'parts': [{'from_s': 0, 'to_s': 1, 'situation': 'normal'}]})
        self.assertEqual(reply.status, 403, reply.body)
        self.assertFalse((self.folder / 'elsewhere.txt').exists())

    def recording_id_of_first(self):
        return self.get('/state').json['recordings'][0]['id']


class Recordings(StudioCase):
    def setUp(self):
        super().setUp()
        write_recording(self.recordings / 'a.wav', 20)
        self.start()
        self.id = self.recording_id('a.wav')

    def test_state(self):
        state = self.get('/state').json
        recording = state['recordings'][0]
        self.assertEqual((recording['frames'], recording['rate'], recording['channels'], recording['seconds']),
                         (960000, 48000, 1, 20))
        self.assertEqual((state['daemon'], state['writable'], state['rig'], state['problems']), (False, True, None, []))

    def samples(self, first, count):
        data = (self.recordings / 'a.wav').read_bytes()[44:]
        return struct.unpack_from(f'<{count}h', data, 2 * first)

    def test_audio_is_the_recording(self):
        body = self.get(f'/recordings/{self.id}/audio?from=1.5&to=1.6').body
        self.assertEqual(body[:4] + body[8:12], b'RIFFWAVE')
        got = struct.unpack('<4800f', body[-4800 * 4:])
        for x, y in zip(self.samples(72000, 4800), got):
            self.assertAlmostEqual(x / 32768, y, places=6)
        for stretch in ('from=30', 'from=-1', 'from=2&to=1', 'from=nan', 'from=x'):
            self.assertEqual(self.ask('GET', f'/recordings/{self.id}/audio?{stretch}').status, 400, stretch)

    def test_peaks_are_lowest_and_highest_of_every_column(self):
        for level in (0, 3, 9):
            wide = 64 << level
            for exact in (None, '1'):
                end = time.monotonic() + PATIENCE_S
                while True:
                    reply = self.get(f'/recordings/{self.id}/peaks/{level}/0')
                    if exact is None or reply.headers['x-rigsound-exact'] == exact or time.monotonic() > end:
                        break
                    time.sleep(0.05)
                if reply.headers['x-rigsound-exact'] == '0':
                    continue
                columns = struct.unpack('2048b', reply.body)
                for c in (0, 7, 29):
                    part = self.samples(c * wide, min(wide, 960000 - c * wide)) if c * wide < 960000 else (0,)
                    low, high = min(0, *part) * 127 / 32768, max(0, *part) * 127 / 32768
                    self.assertLessEqual(abs(columns[2 * c] - low), 1)
                    self.assertLessEqual(abs(columns[2 * c + 1] - high), 1)
                    self.assertTrue(columns[2 * c] <= low and columns[2 * c + 1] >= high)
        for place in ('0/99', '21/0', '-1/0', '0/-1', 'a/0', '0/99999999999999999999'):
            self.assertEqual(self.ask('GET', f'/recordings/{self.id}/peaks/{place}').status, 404, place)

    def test_spectrogram_is_a_picture_that_is_made_once(self):
        path = f'/recordings/{self.id}/spectrogram/4/0.png'
        first = self.get(path)
        self.assertEqual((first.body[:8], struct.unpack('>II', first.body[16:24])), (b'\x89PNG\r\n\x1a\n', (1024, 256)))
        kept = list((self.sound_set / '.cache').rglob('*.png'))
        self.assertEqual(len(kept), 1)
        kept[0].write_bytes(first.body[:8] + b'kept')
        self.assertEqual(self.get(path).body[8:], b'kept')
        write_recording(self.recordings / 'a.wav', 20, seed=2)  # another recording: made anew
        self.assertNotEqual(self.get(path).body[8:], b'kept')

    def test_a_tile_may_be_kept_by_the_browser_when_it_is_named_by_its_hash(self):
        path, seen = f'/recordings/{self.id}/spectrogram/4/0.png', self.get('/state').json['recordings'][0]['hash']
        self.assertIn('immutable', self.get(f'{path}?v={seen}').headers['cache-control'])
        for query in ('', '?v=other'):
            self.assertEqual(self.get(path + query).headers['cache-control'], 'no-store')


class Labels(StudioCase):
    PARTS = [{'from_s': 4, 'to_s': 8, 'situation': 'underfeed'},
             {'from_s': 0.5, 'to_s': 3.25, 'situation': 'normal', 'rods': 2, 'rock': 'hard', 'rpm': 1500, 'feed': 110.5, 'percussion': None}]

    def setUp(self):
        super().setUp()
        write_recording(self.recordings / 'a.wav', 10)
        self.start()
        self.path = f'/recordings/{self.recording_id("a.wav")}/labels'
        self.file = self.recordings / 'a.txt'

    def put(self, parts, version):
        return self.ask('PUT', self.path, {'version': version, 'parts': parts})

    def test_a_track_goes_there_and_back(self):
        self.assertEqual(self.get(self.path).json, {'version': 'absent', 'parts': [], 'problems': []})
        saved = self.put(self.PARTS, 'absent')
        self.assertEqual(saved.status, 200, saved.body)
        self.assertEqual(self.file.read_text(), '0.500000\t3.250000\tnormal rods=2 rock=hard rpm=1500 feed=110.5\n'
                                                '4.000000\t8.000000\tunderfeed\n')
        self.assertEqual(self.get(self.path).json, saved.json)
        first = saved.json['parts'][0]
        self.assertEqual((first['from_s'], first['to_s'], first['situation'], first['rods'], first['rock'], first['feed'], first['percussion']),
                         (0.5, 3.25, 'normal', 2, 'hard', 110.5, None))
        self.assertTrue(self.get('/state').json['recordings'][0]['labels'])
        emptied = self.put([], saved.json['version'])
        self.assertEqual((emptied.status, emptied.json['version'], self.file.exists()), (200, 'absent', False))

    def test_of_two_tabs_the_second_is_told(self):
        first = self.put(self.PARTS, 'absent')
        late = self.put(self.PARTS[:1], 'absent')
        self.assertEqual((late.status, late.json['version']), (409, first.json['version']))
        self.assertIn('has changed', late.json['error'])
        before = self.file.read_text()
        self.file.write_text('0\t1\toverfeed\n')  # an editor
        self.assertEqual(self.put(self.PARTS, first.json['version']).status, 409)
        self.assertEqual(self.file.read_text(), '0\t1\toverfeed\n')
        again = self.put(self.PARTS, self.get(self.path).json['version'])
        self.assertEqual((again.status, self.file.read_text()), (200, before))
        self.assertEqual((self.recordings / 'a.txt.bak').read_text(), '0\t1\toverfeed\n')

    def test_what_analyze_would_refuse_is_refused(self):
        for change in ({'rods': 21}, {'rods': 1.5}, {'rpm': 9000}, {'feed': 500}, {'rock': 'a b'}, {'rock': 'a\nb'}, {'to_s': 1}, {'to_s': 11},
                       {'situation': 'none'}, {'from_s': 'x'}, {'from_s': -1}):
            reply = self.put([{'from_s': 1, 'to_s': 2, 'situation': 'normal', **change}], 'absent')
            self.assertIn(reply.status, (400, 422), change)
            self.assertFalse(self.file.exists(), change)
        self.assertEqual(self.ask('PUT', self.path, {'parts': []}).status, 400)

    def test_a_track_that_cannot_be_read_is_told_and_kept(self):
        self.file.write_text('0\t1\tsomething else\n')
        got = self.get(self.path).json
        self.assertEqual((got['parts'], len(got['problems'])), ([], 1))
        self.assertIn('a.txt:1', got['problems'][0])
        self.assertEqual(self.put(self.PARTS, got['version']).status, 200)
        self.assertEqual((self.recordings / 'a.txt.bak').read_text(), '0\t1\tsomething else\n')


class FullDisk(StudioCase):
    def test_what_was_there_stays_whole_whichever_call_fails(self):
        write_recording(self.recordings / 'a.wav', 5)
        track, old, new = self.recordings / 'a.txt', '0\t1\toverfeed\n', '2.000000\t3.000000\tnormal\n'
        failed = 0
        for kind, n in ((kind, n) for kind in ('write', 'fsync', 'rename') for n in (1, 2, 3)):
            track.write_text(old)
            self.start(env=dict(os.environ, LD_PRELOAD=SHIM, RIGSOUND_FAULT=f'{self.recordings} {kind} {n}'))
            path = f'/recordings/{self.recording_id("a.wav")}/labels'
            reply = self.ask('PUT', path, {'version': self.get(path).json['version'],
                                           'parts': [{'from_s': 2, 'to_s': 3, 'situation': 'normal'}]})
            with self.subTest(kind=kind, n=n):
                self.assertEqual((reply.status, track.read_text()), (200, new) if reply.status == 200 else (503, old), reply.body)
                self.assertEqual([p.name for p in self.recordings.iterdir() if p.name.startswith('.')], [])
                self.assertEqual(self.ask('GET', '/state').status, 200)
            failed += reply.status == 503
            self.server.kill()
            self.server.wait()
        self.assertGreaterEqual(failed, 3)  # or the shim did nothing


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
        (self.pages / 'export.html').write_text('<a>RIGSOUND_RIG_JSON</a><b>RIGSOUND_RIGSET_BASE64</b><i>RIGSOUND_ENGINE_BASE64</i>')
        page = self.folder / 'page.html'
        result = subprocess.run([RIGSOUND, 'studio', self.sound_set, '--pages', self.pages, '--export', page], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        text = page.read_text()
        self.assertIn('<b>UklHU0VU', text)  # RIGSET
        self.assertIn('<i>AGFzbQ==</i>', text)
        self.assertNotIn('RIGSOUND_', text)


    def test_a_steel_is_tuned_and_saved(self):
        steel = {'length_m': 0.5, 'diameter_m': 0.025}
        modes = self.ask('POST', '/steel', steel).json['modes']
        self.assertTrue(modes and all(abs(m['error_cents']) < 1 for m in modes))
        self.assertEqual(self.ask('POST', '/steel', {'length_m': 50, 'diameter_m': 0.025}).status, 422)
        saved = self.ask('PUT', '/tools/bar', {**steel, 'version': 'absent'})
        self.assertEqual(saved.status, 200, saved.body)
        self.assertEqual(self.get('/tools/bar').json['version'], saved.json['version'])
        self.assertEqual([t['name'] for t in self.get('/sound_set').json['tools']], ['bar'])
        self.assertEqual(self.ask('PUT', '/tools/bar', {**steel, 'version': 'absent'}).status, 409)
        self.assertEqual(self.ask('GET', '/tools/..').status, 404)


class Logs(StudioCase):
    def test_a_table_of_states_becomes_a_timeline(self):
        text = 'time_s,signal,value\n0,engine_rpm,1500\n0.5,rattling,closed\n0.5,left.feed_pressure_bar,90\n2,engine_rpm,absent\n2,situation,normal\n'
        (self.recordings / 'a.csv').write_text(text)
        (self.recordings / 'shift.log').write_text('(0.0) can0 123#00\n')
        self.start()
        ids = {log['name']: log['id'] for log in self.get('/state').json['logs']}
        self.assertEqual(set(ids), {'a.csv', 'shift.log'})
        line = self.get(f'/logs/{ids["a.csv"]}/timeline').json
        signals = {(s['boom'], s['name']): s for s in line['signals']}
        self.assertEqual(signals['', 'engine_rpm']['changes'], [[0, 1500], [2, None]])
        self.assertEqual((signals['', 'rattling']['changes'], signals['', 'rattling']['words']), ([[0.5, 1]], ['none', 'closed', 'open']))
        self.assertEqual((signals['left', 'feed_pressure_bar']['changes'], signals['left', 'feed_pressure_bar']['unit']), ([[0.5, 90]], 'bar'))
        self.assertEqual((line['situations'], line['seconds']), ([{'boom': '', 'changes': [[2, 'normal']]}], 2))
        self.assertEqual(self.get(f'/logs/{ids["a.csv"]}/states.csv').body.decode(), text)
        self.assertEqual(self.ask('GET', f'/logs/{ids["shift.log"]}/timeline').status, 404)  # no rig

    def test_a_bus_log_is_decoded_by_the_rig(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        (self.recordings / 'shift.log').write_bytes((root / 'config/logs/shift.log').read_bytes())
        rig = root / 'config/rigs/demo.toml'
        self.start('--rig', rig)
        log, = self.get('/state').json['logs']
        csv = subprocess.run([RIGSOUND, 'decode', rig, '--log', self.recordings / 'shift.log'], capture_output=True, text=True).stdout
        self.assertEqual(self.get(f'/logs/{log["id"]}/states.csv').body.decode(), csv)
        line = self.get(f'/logs/{log["id"]}/timeline').json
        changes = sum(len(s['changes']) for s in line['signals'] + line['situations'])
        self.assertEqual(changes, len(csv.splitlines()) - 1)
        self.assertEqual(self.get('/rig').json['feed']['largest_bar'], 300)


class Suggestions(StudioCase):
    def test_a_recording_that_becomes_louder_and_faster_is_cut_there(self):
        slow, fast = (write_recording(self.folder / f'{hz}.wav', 6, rate_hz=hz, seed=hz).read_bytes()[44:] for hz in (20, 33))
        quiet = struct.pack(f'<{len(slow) // 2}h', *(x // 4 for x in struct.unpack(f'<{len(slow) // 2}h', slow)))
        head = (self.folder / '20.wav').read_bytes()[:40]
        (self.recordings / 'a.wav').write_bytes(head + struct.pack('<I', len(quiet + fast)) + quiet + fast)
        self.start()
        job = self.ask('POST', '/jobs', {'kind': 'suggest', 'recording': self.recording_id('a.wav')}).json['id']
        last = json.loads(self.get(f'/jobs/{job}/events').body.splitlines()[-1])
        self.assertEqual(last['state'], 'done', last)
        parts = last['result']['parts']
        self.assertEqual((parts[0]['from_s'], parts[-1]['to_s']), (0, 12))
        for one, next_one in zip(parts, parts[1:]):
            self.assertEqual(one['to_s'], next_one['from_s'])
        nearest = min(parts, key=lambda part: abs(part['from_s'] - 6))
        self.assertAlmostEqual(nearest['from_s'], 6, delta=0.25)
        self.assertIn('level', nearest['kinds'])


class WrongUsage(StudioCase):
    def run_studio(self, *words):
        result = subprocess.run([RIGSOUND, 'studio', *map(str, words)], capture_output=True, text=True, timeout=PATIENCE_S)
        return result.returncode, result.stderr

    def test_what_is_not_there_is_one_line(self):
        for code, text, words in (
                (1, 'expected one of a sound set', [self.folder / 'none/set', '--pages', self.pages]),
                (1, 'expected one of recordings', [self.sound_set, '--recordings', self.folder / 'none', '--pages', self.pages]),
                (1, 'holds no index.html', [self.sound_set, '--pages', self.folder])):
            self.assertEqual((self.run_studio(*words)[0], text in self.run_studio(*words)[1]), (code, True), words)

    def test_a_port_that_is_taken_is_told(self):
        self.start()
        code, text = self.run_studio(self.sound_set, '--pages', self.pages, '--port', self.port)
        self.assertEqual((code, 'cannot be listened at' in text), (3, True), text)


unittest.main(argv=sys.argv[:1])
