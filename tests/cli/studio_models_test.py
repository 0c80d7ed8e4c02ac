#!/usr/bin/env python3
"""studio_models_test.py RIGSOUND: the steels and diesels of the studio's page: tuned, heard, saved, brought back."""
import json
import math
import subprocess
import sys
import unittest

from studio_case import StudioCase

RIGSOUND = sys.argv[1]
STEEL = {'length_m': 0.5, 'diameter_m': 0.025}
DECAY = {'low_hz': 500, 'low_s': 0.4, 'high_hz': 8000, 'high_s': 0.05}


def rigsound(*words):
    result = subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    return result.stdout


class ModelCase(StudioCase):
    def unpacked(self, octets):
        """The folder of a packed set."""
        (self.folder / 'a.rigset').write_bytes(octets)
        folder = self.folder / f'unpacked{len(list(self.folder.iterdir()))}'
        rigsound('unpack', self.folder / 'a.rigset', folder)
        return folder

    def status(self, method, path, body=None):
        return self.ask(method, path, body).status


class Steels(ModelCase):
    def setUp(self):
        super().setUp()
        self.start()

    def test_a_steel_is_tuned(self):
        ranges = self.get('/steel').json['bar']
        self.assertLess(ranges['length_m']['min'], ranges['length_m']['max'])
        modes = self.ask('POST', '/steel', STEEL).json['modes']
        self.assertTrue(modes and all(abs(mode['error_cents']) < 1 for mode in modes))
        # The lengthwise modes of a free bar are even: c / 2L and its multiples (jackhammer paper, section 2).
        lengthwise = [mode['target_hz'] for mode in modes if mode['family'] == 'longitudinal']
        for n, hz in enumerate(lengthwise, 1):
            self.assertAlmostEqual(hz, n * 5200 / (2 * STEEL['length_m']), delta=0.01 * hz)
        longer = self.ask('POST', '/steel', {**STEEL, 'transversal': {**DECAY, 'low_s': 0.8}}).json['modes']
        self.assertGreater(longer[0]['t60_s'], 1.5 * self.ask('POST', '/steel', {**STEEL, 'transversal': DECAY}).json['modes'][0]['t60_s'])

    def test_what_is_heard_is_what_is_saved(self):
        body = {**STEEL, 'transversal': DECAY}
        for more in ({}, {'bank': 'normal'}):
            reply = self.ask('POST', '/steel/rigset', {**body, **more})
            self.assertEqual(reply.status, 200, reply.body)
            heard = self.unpacked(reply.body)
            banks = [folder.name for folder in (heard / 'banks').iterdir()]
            self.assertEqual(banks, [more.get('bank', 'hammer')])
        saved = self.ask('PUT', '/tools/bar', {**body, 'version': 'absent'})
        self.assertEqual(saved.status, 200, saved.body)
        self.assertEqual((heard / 'tools/steel.json').read_bytes(), (self.sound_set / 'tools/bar.json').read_bytes())

    def test_a_steel_is_saved_and_brought_back(self):
        first = self.ask('PUT', '/tools/bar', {**STEEL, 'version': 'absent'})
        self.assertEqual(first.status, 200, first.body)
        self.assertEqual(self.get('/tools/bar').json['version'], first.json['version'])
        self.assertEqual([tool['name'] for tool in self.get('/sound_set').json['tools']], ['bar'])
        self.assertEqual(self.status('PUT', '/tools/bar', {**STEEL, 'version': 'absent'}), 409)
        self.assertEqual(self.status('POST', '/tools/bar/restore', {'version': first.json['version']}), 404)
        second = self.ask('PUT', '/tools/bar', {**STEEL, 'length_m': 0.8, 'version': first.json['version']}).json
        self.assertEqual(self.status('POST', '/tools/bar/restore', {'version': first.json['version']}), 409)
        back = self.ask('POST', '/tools/bar/restore', {'version': second['version']}).json
        self.assertEqual(back['version'], first.json['version'])
        self.assertEqual(self.get('/tools/bar').json['tool']['length_m'], 0.5)
        self.assertEqual(self.ask('POST', '/tools/bar/restore', {'version': back['version']}).json, second)
        self.assertEqual(sorted(file.name for file in (self.sound_set / 'tools').iterdir()), ['bar.json', 'bar.json.old'])

    def test_a_drill_string_keeps_its_name(self):
        rigsound('tool', '--string', '--length', 3.66, '--diameter', 0.038, '--name', 'rods', '--out', self.sound_set)
        version = self.get('/tools/rods').json['version']
        self.assertEqual(self.status('PUT', '/tools/rods', {**STEEL, 'version': version}), 422)
        self.assertEqual(self.get('/tools/rods').json['version'], version)

    def test_what_is_no_steel_is_refused(self):
        for status, body in ((422, {**STEEL, 'length_m': 50}), (422, {**STEEL, 'length_m': 1e308}), (422, {**STEEL, 'length_m': -1}),
                             (422, {**STEEL, 'length_m': 0.2, 'diameter_m': 0.08}), (400, {**STEEL, 'length_m': '0.5'}),
                             (400, {**STEEL, 'length_m': None}), (400, {'length_m': 0.5}), (400, {**STEEL, 'transversal': 7}),
                             (400, {**STEEL, 'transversal': {'low_hz': 500}}), (422, {**STEEL, 'transversal': {**DECAY, 'low_s': 1e9}}),
                             (422, {**STEEL, 'longitudinal': {**DECAY, 'high_s': -1}})):
            for method, path in (('POST', '/steel'), ('POST', '/steel/rigset'), ('PUT', '/tools/bar')):
                self.assertEqual(self.status(method, path, {**body, 'version': 'absent'}), status, (path, body))
        headers = {'Host': f'127.0.0.1:{self.port}', 'X-Rigsound-Token': self.token, 'Content-Type': 'application/json'}
        for number in (b'NaN', b'Infinity', b'1e999', b'-'):
            body = b'{"length_m": ' + number + b', "diameter_m": 0.025}'
            self.assertEqual(self.raw('POST', '/api/v1/steel/rigset', body, headers).status, 400, number)
        for bank, status in (('none', 404), ('../banks/normal', 404), ('', 200), (5, 400)):
            self.assertEqual(self.status('POST', '/steel/rigset', {**STEEL, 'bank': bank}), status, bank)
        for name in ('..', '.hidden', '%2e%2e%2fbar', 'a%20b', 'x' * 200):
            self.assertEqual(self.status('PUT', f'/tools/{name}', {**STEEL, 'version': 'absent'}), 404, name)
            self.assertEqual(self.status('POST', f'/tools/{name}/restore', {'version': 'absent'}), 404, name)
        self.assertFalse((self.sound_set / 'tools').exists())

    def test_what_is_kept_elsewhere_is_not_brought_in(self):
        version = self.ask('PUT', '/tools/bar', {**STEEL, 'version': 'absent'}).json['version']
        (self.folder / 'secret').write_text('{}')
        (self.sound_set / 'tools/bar.json.old').symlink_to(self.folder / 'secret')
        self.assertEqual(self.status('POST', '/tools/bar/restore', {'version': version}), 403)
        self.assertEqual(self.get('/tools/bar').json['version'], version)


class Diesels(ModelCase):
    def setUp(self):
        super().setUp()
        rigsound('background', '--formula', '--name', 'diesel', '--out', self.sound_set)
        self.start()

    def spectrum(self, rpm, load=0):
        return self.get(f'/diesel/diesel/spectrum?rpm={rpm}&load={load}').json

    def test_orders_go_with_the_speed(self):
        for rpm in (800, 1730):
            found = self.spectrum(rpm)
            for order in found['orders']:
                self.assertAlmostEqual(order['hz'], order['order'] * rpm / 60, delta=1e-3 * order['hz'])
            # Six cylinders of a four-stroke fire three times a turn.
            self.assertEqual(max(found['orders'], key=lambda order: order['db'])['order'] % 3, 0, rpm)
            hz, db = found['spectrum']['hz'], found['spectrum']['db']
            self.assertEqual(len(hz), len(db))
            self.assertTrue(20 <= hz[0] < hz[-1] <= 10000 and hz == sorted(hz))
            # The loudest band is that of the loudest order.
            loudest = max(found['orders'], key=lambda order: order['db'])
            self.assertAlmostEqual(hz[db.index(max(db))], loudest['hz'], delta=rpm / 120 / 8)

    def test_what_runs_has_the_orders_of_its_model(self):
        model = json.loads((self.sound_set / 'backgrounds/diesel/background.json').read_text())
        point = model['points'][len(model['points']) // 2]
        found = self.get(f"/diesel/diesel/spectrum?rpm={point['rpm']}&load={point['load']}").json['orders']
        # The level of a sine is 3.01 dB below that of its peak.
        wanted = [db - 3.01 for db in point['order_level_db'][:len(found)]]
        loud = [k for k, db in enumerate(wanted) if db > max(wanted) - 15]
        self.assertGreater(len(loud), 2)
        for k in loud:
            self.assertAlmostEqual(found[k]['db'], wanted[k], delta=1)

    def test_load_is_heard(self):
        level = {load: 10 * math.log10(sum(10 ** (db / 10) for db in self.spectrum(1500, load)['spectrum']['db'])) for load in (0, 1)}
        self.assertGreater(level[1], level[0] + 2)

    def test_a_diesel_says_where_it_was_learned(self):
        diesel = self.get('/diesel/diesel').json
        known = next(b['rpm'] for b in self.get('/sound_set').json['backgrounds'] if b['name'] == 'diesel')
        self.assertEqual([point['rpm'] for point in diesel['points']], known)
        self.assertEqual({point['recording'] for point in diesel['points']}, {None})
        self.assertEqual(self.status('GET', '/diesel/diesel/recorded/0'), 404)

    def test_a_recording_at_hand_stands_beside_its_model(self):
        rigsound('background', '--formula', '--resynth', self.recordings / 'mid.wav', '--resynth-rpm', 1500, '--seconds', 9)
        rigsound('background', self.recordings / 'mid.wav', '--rpm', 1500, '--name', 'learned', '--out', self.sound_set)
        point, = self.get('/diesel/learned').json['points']
        self.assertEqual(point['recording'], self.recording_id('mid.wav'))
        recorded = self.get('/diesel/learned/recorded/0').json
        self.assertEqual((recorded['recording'], recorded['from_s']), (point['recording'], 0))
        self.assertAlmostEqual(recorded['to_s'], 9, delta=0.01)
        self.assertAlmostEqual(recorded['rpm'], 1500, delta=1)
        model = self.get('/diesel/learned/spectrum?rpm=1500').json
        loud = [(a['db'], b['db']) for a, b in zip(recorded['orders'], model['orders']) if a['db'] > max(o['db'] for o in recorded['orders']) - 20]
        self.assertGreater(len(loud), 2)
        for there, here in loud:
            self.assertAlmostEqual(there, here, delta=1.5)
        (self.recordings / 'mid.wav').write_bytes(b'RIFF')
        self.assertEqual(self.status('GET', '/diesel/learned/recorded/0'), 422)

    def test_it_is_packed_alone(self):
        heard = self.unpacked(self.get('/sound_set.rigset?background=diesel').body)
        self.assertEqual([folder.name for folder in (heard / 'backgrounds').iterdir()], ['diesel'])
        packed, stored = (json.loads((folder / 'backgrounds/diesel/background.json').read_text()) for folder in (heard, self.sound_set))
        for key in ('rpm', 'load', 'order_level_db', 'v_hi_db'):
            self.assertEqual([point[key] for point in packed['points']], [point[key] for point in stored['points']])

    def test_what_is_no_speed_and_no_diesel_is_refused(self):
        for query in ('', '?rpm=', '?rpm=x', '?rpm=0', '?rpm=-800', '?rpm=nan', '?rpm=inf', '?rpm=1e9', '?rpm=1e999', '?rpm=99',
                      '?rpm=1500&load=2', '?rpm=1500&load=-0.1', '?rpm=1500&load=nan'):
            self.assertEqual(self.status('GET', '/diesel/diesel/spectrum' + query), 400, query)
        for name in ('none', '..', '.hidden', '%2e%2e', '..%2fbackgrounds%2fdiesel', 'x' * 200):
            for path in (f'/diesel/{name}', f'/diesel/{name}/spectrum?rpm=1500', f'/diesel/{name}/recorded/0', f'/sound_set.rigset?background={name}'):
                self.assertEqual(self.status('GET', path), 404, path)
        for point in ('-1', '99', '99999999999999999999', 'x', '0x0', '1.0'):
            self.assertEqual(self.status('GET', f'/diesel/diesel/recorded/{point}'), 404, point)

    def test_a_diesel_elsewhere_is_not_read(self):
        rigsound('background', '--formula', '--name', 'other', '--out', self.folder / 'elsewhere')
        (self.sound_set / 'backgrounds/link').symlink_to(self.folder / 'elsewhere/backgrounds/other')
        self.assertEqual(self.status('GET', '/diesel/link'), 403)
        (self.sound_set / 'backgrounds/half').mkdir()
        (self.sound_set / 'backgrounds/half/background.json').symlink_to(self.folder / 'elsewhere/backgrounds/other/background.json')
        self.assertEqual(self.status('GET', '/diesel/half/spectrum?rpm=1500'), 403)


unittest.main(argv=sys.argv[:1])
