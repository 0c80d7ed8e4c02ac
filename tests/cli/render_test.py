#!/usr/bin/env python3
"""render_test.py RIGSOUND ROOT: `render` as a user calls it.

ROOT is the project.
"""
import hashlib
import struct
import sys
import unittest

from rig_case import RigCase, run
from sound_set import write_sound_set


def data_chunk(path):
    raw = path.read_bytes()
    at = 12
    while at + 8 <= len(raw):
        name, size = raw[at:at + 4], struct.unpack('<I', raw[at + 4:at + 8])[0]
        if name == b'fmt ':
            form = struct.unpack('<HHIIHH', raw[at + 8:at + 24])
        if name == b'data':
            return form, raw[at + 8:at + 8 + size]
        at += 8 + size + (size & 1)
    raise AssertionError('no data chunk')


class Render(RigCase):
    def render(self, rig, log, name, *more):
        result = run('render', rig, '--log', log, '--out', self.folder / name, *more)
        self.assertEqual(result.returncode, 0, result.stderr)
        digest, factor = result.stdout.splitlines()
        self.assertTrue(digest.startswith('sha256 ') and factor.startswith('realtime_factor '), result.stdout)
        self.assertGreater(float(factor.split()[1]), 0)
        return digest.split()[1]

    def test_states_by_hand_and_a_part_of_the_whole(self):
        write_sound_set(self.folder / 'set')
        rig = self.demo_rig()
        states = self.write('s.csv', 'time_s,signal,value\n0,engine_rpm,1500\n0.1,feed_pressure_bar,90\n'
                                     '1,rattling,closed\n2,rattling,none\n3,feed_pressure_bar,0\n')

        def render(name, *more):
            result = run('render', rig, '--states', states, '--out', self.folder / name, *more)
            self.assertEqual(result.returncode, 0, result.stderr)
            return data_chunk(self.folder / name)[1], result.stdout
        whole, said = render('whole.wav')
        self.assertEqual(said.split()[1], hashlib.sha256(whole).hexdigest())
        self.assertEqual(len(whole), 2251 * 64 * 2 * 4)  # the last row acts in block 2250, which begins at 3 s
        block = 64 * 2 * 4
        part, said = render('part.wav', '--from', 0.5, '--to', 1.5, '--no-hash')
        self.assertEqual(part, whole[375 * block:1125 * block])
        self.assertTrue(said.startswith('realtime_factor '))
        for words, code in ((['--from', 4], 2), (['--from', 2, '--to', 1], 2)):
            result = run('render', rig, '--states', states, '--out', self.folder / 'none.wav', *words)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertFalse((self.folder / 'none.wav').exists())

    def test_nothing_that_is_read_is_written_over(self):
        write_sound_set(self.folder / 'set')
        rig = self.demo_rig()
        log = self.short_log(1)
        clicks = self.folder / 'set/banks/normal/clicks.wav'
        (self.folder / 'link.wav').symlink_to(clicks)
        for words in (['render', rig, '--log', log, '--out', log], ['render', rig, '--log', log, '--out', rig],
                      ['render', rig, '--log', log, '--out', clicks],
                      ['render', rig, '--log', log, '--out', self.folder / 'link.wav'],
                      ['resynth', clicks.parent, clicks, '--seconds', 1],
                      ['resynth', clicks.parent, self.folder / 'new.wav', '--seconds', 1, '--impacts', clicks]):
            before = {path: path.read_bytes() for path in self.folder.rglob('*') if path.is_file()}
            self.refused(words, 'expected another name for the output')
            self.assertEqual({path: path.read_bytes() for path in self.folder.rglob('*') if path.is_file()}, before)

    def test_a_packed_set_sounds_the_same_and_unpacks(self):
        write_sound_set(self.folder / 'set')
        rig = self.demo_rig()
        log = self.short_log(3)
        first = self.render(rig, log, 'folder.wav')
        result = run('pack', self.folder / 'set', self.folder / 'one.rigset', '--rig', rig)
        self.assertEqual(result.returncode, 0, result.stderr)
        text = rig.read_text()
        def with_set(name, file):
            return self.write(file, text.replace(f"\"{self.folder / 'set'}\"", f'"{name}"'))
        packed_rig = with_set('one.rigset', 'packed.toml')
        self.assertIn('"one.rigset"', packed_rig.read_text())
        self.assertEqual(self.render(packed_rig, log, 'packed.wav'), first)
        result = run('unpack', self.folder / 'one.rigset', self.folder / 'again')
        self.assertEqual(result.returncode, 0, result.stderr)
        again = with_set('again', 'again.toml')
        self.assertEqual(self.render(again, log, 'again.wav'), first)
        self.refused(['unpack', self.folder / 'one.rigset', self.folder / 'again'], 'is there already')
        damaged = bytearray((self.folder / 'one.rigset').read_bytes())
        damaged[-1] ^= 1
        (self.folder / 'one.rigset').write_bytes(damaged)
        self.refused(['check', packed_rig], 'one.rigset', 'SHA-256')

    def test_states_that_are_none(self):
        write_sound_set(self.folder / 'set')
        rig = self.demo_rig()
        for text, parts in (('time_s,signal,value\n0,engine_rpn,1500\n', (':2', 'engine_rpn')),
                            ('time_s,signal,value\n0,left.rock,1\n', ("no boom 'left'", 'boom'))):
            states = self.write('s.csv', text)
            self.refused(['render', rig, '--states', states, '--out', self.folder / 'no.wav'], *parts)

    def test_same_input_same_bits(self):
        write_sound_set(self.folder / 'set')
        rig = self.demo_rig(**{'background_db = 0': 'background_db = -60'})  # the drill alone
        log = self.short_log()
        first = self.render(rig, log, 'a.wav')
        self.assertEqual(self.render(rig, log, 'b.wav'), first)
        self.assertEqual((self.folder / 'a.wav').read_bytes(), (self.folder / 'b.wav').read_bytes())
        self.assertNotEqual(self.render(rig, log, 'c.wav', '--seed', 2), first)
        self.assertEqual(self.render(rig, log, 'd.wav', '--seed', 1), first)

        form, pcm = data_chunk(self.folder / 'a.wav')
        self.assertEqual(hashlib.sha256(pcm).hexdigest(), first)
        self.assertEqual((form[0], form[1], form[2], form[5]), (3, 2, 48000, 32))
        seconds = len(pcm) / 8 / 48000
        self.assertAlmostEqual(seconds, 16, delta=0.1)
        samples = struct.unpack(f'<{len(pcm) // 4}f', pcm)
        self.assertLessEqual(max(map(abs, samples)), 10 ** (-1 / 20) + 1e-6)  # the ceiling of demo.toml
        power = [sum(x * x for x in samples[96000 * s:96000 * (s + 1)]) for s in range(16)]
        self.assertGreater(power[8], 4 * power[1])  # underfeed against idle


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
