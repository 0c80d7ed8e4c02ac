#!/usr/bin/env python3
"""batch_test.py RIGSOUND: `analyze` of many recordings, in shards, as a cluster calls it."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

RIGSOUND = sys.argv[1]


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_batch.'))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_verb(self, *words, **environment):
        slurm_free = {key: value for key, value in os.environ.items() if not key.startswith('SLURM_')}
        return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300,
                              env={**slurm_free, **environment})


class SlurmArray(Case):
    def setUp(self):
        super().setUp()
        self.recordings = self.folder / 'in'
        self.recordings.mkdir()
        for i in range(7):  # refused at once, by name: which shard took which is told without any analysis
            (self.recordings / f'r{i}.wav').write_text('no sound')

    def task(self, number, first, last, count, **more):
        array = {'ID': number, 'MIN': first, 'MAX': last, 'COUNT': count, **more}
        return self.run_verb('analyze', self.recordings, '--out', self.folder / 'set', '--shard', 'auto',
                             **{f'SLURM_ARRAY_TASK_{key}': str(value) for key, value in array.items()})

    def taken(self, result):
        self.assertEqual(result.returncode, 1, result.stderr)
        return re.findall(r'(r\d)\.wav', result.stderr)

    def test_every_recording_is_done_once_whatever_the_array_begins_with(self):
        all_of_them = [f'r{i}' for i in range(7)]
        for numbers in (range(0, 4), range(1, 5), range(7, 9), range(0, 8, 2), range(5, 6)):
            ends = (numbers[0], numbers[-1], len(numbers))
            taken = [self.taken(self.task(n, *ends, STEP=numbers.step)) for n in numbers]
            self.assertEqual(sorted(sum(taken, [])), all_of_them, numbers)
            self.assertLessEqual(max(map(len, taken)) - min(map(len, taken)), 1, numbers)
        self.assertEqual(self.taken(self.task(0, 0, 3, 4)), ['r0', 'r4'])  # an older Slurm says no step

    def test_an_array_with_holes_is_refused_and_so_is_none(self):
        for task in ((3, 3, 7, 2), (1, 1, 5, 3), (2, 1, 5, 3)):
            result = self.task(*task)
            self.assertEqual((result.returncode, result.stdout), (2, ''))
            self.assertIn('leaves numbers out, expected an array such as 0-3', result.stderr)
        result = self.task('x', 0, 3, 4)
        self.assertEqual(result.returncode, 2)
        self.assertIn("SLURM_ARRAY_TASK_ID is 'x', expected a whole number", result.stderr)
        result = self.run_verb('analyze', self.recordings, '--out', self.folder / 'set', '--shard', 'auto')
        self.assertEqual(result.returncode, 2)
        self.assertIn('--shard: auto: SLURM_ARRAY_TASK_ID is not set, expected a task of a Slurm array', result.stderr)


unittest.main(argv=sys.argv[:1])
