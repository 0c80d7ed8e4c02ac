#!/usr/bin/env python3
"""studio_recordings_test.py RIGSOUND SHIM: recordings, their labels and logs as the studio's page gets them, and people's files kept.

SHIM (`faults/failing_calls.cpp`) lets a call on a file fail, as on a full disk.
"""
import json
import os
import pathlib
import struct
import subprocess
import sys
import time
import unittest

from studio_case import PATIENCE_S, StudioCase, write_recording

RIGSOUND, SHIM = sys.argv[1:3]


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


unittest.main(argv=sys.argv[:1])
