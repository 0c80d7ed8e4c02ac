#!/usr/bin/env python3
"""bench_test.py RIGSOUND ROOT: `bench` plays what it is told to; how long that takes is not asserted."""
import json
import sys
import unittest

from rig_case import RigCase, run
from sound_set import write_sound_set

LAYERS = ['drill', 'tool', 'background', 'scene+mix', 'engine']


class Bench(RigCase):
    def setUp(self):
        super().setUp()
        self.rig = self.demo_rig()
        write_sound_set(self.folder / 'set')

    def layers(self, *words):
        result = run('bench', '--json', *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        layers = json.loads(result.stdout)
        self.assertEqual(list(layers), LAYERS)
        for name, layer in layers.items():
            times = [layer[key] for key in ('p50_block_us', 'p99_block_us', 'p99_9_block_us', 'worst_block_us')]
            self.assertEqual(times, sorted(times), name)
        engine = layers['engine']
        self.assertGreater(engine['mean_block_us'], 0)
        self.assertAlmostEqual(engine['share_of_core'], engine['mean_block_us'] / engine['block_us'])
        self.assertAlmostEqual(engine['ns_a_sample'] * engine['block_us'] * 48e-3, engine['mean_block_us'] * 1e3, places=3)
        self.assertEqual(engine['quiet'], 'too busy to judge' not in result.stderr)
        return layers

    def blocks(self, *words):
        return {layer['blocks'] for layer in self.layers(*words).values()}

    def test_a_rig_by_itself_plays_as_long_as_it_is_told(self):
        self.assertEqual(self.blocks('--rig', self.rig, '--seconds', 0.4), {300})
        self.rig = self.demo_rig(**{'block = 64': 'block = 512'})
        self.assertEqual(self.blocks('--rig', self.rig, '--seconds', 0.512), {48})

    def test_a_log_is_played_from_its_start_to_its_end_or_to_a_part(self):
        log = self.short_log(2)
        stamps = [float(line[1:18]) for line in log.read_text().splitlines()]
        blocks = self.blocks('--rig', self.rig, '--log', log)
        self.assertLess(abs(blocks.pop() - (stamps[-1] - stamps[0]) * 750), 2)
        self.assertFalse(blocks)
        self.assertEqual(self.blocks('--rig', self.rig, '--log', log, '--seconds', 0.8), {600})

    def test_a_table_ends_with_whether_it_fits(self):
        result = run('bench', '--seconds', 0.1)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([line.split()[0] for line in result.stdout.splitlines()[1:6]], LAYERS)
        self.assertRegex(result.stdout.splitlines()[-1],
                         r'^(fits|does not fit).*: its worst block takes [\d.]+ % of the 1333 us that a block of 64 frames lasts$')

    def test_what_cannot_be_played_again_or_at_all_is_refused(self):
        for words, part in ((('--rig', self.rig, '--log', '-'), 'standard input can be read once'),
                            (('--log', 'a.log'), 'needs the --rig')):
            result = run('bench', *words)
            self.assertEqual((result.returncode, result.stdout), (2, ''))
            self.assertIn(part, result.stderr)
        self.refused(['bench', '--rig', self.rig, '--log', 'no.log'], 'no.log: cannot be opened')
        self.refused(['bench', '--rig', 'no.toml'], 'no.toml: cannot be opened')


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
